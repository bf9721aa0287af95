#!/usr/bin/env bash
# `output.pictures: true` draws every frame at the end of a run, and says where; so does `render`.
# Without VTK the key is refused.
#   pictures.sh PROGRAM SOURCE
set -euo pipefail
brunt=$1
deck=$2/decks/bars/bars.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
fail() { cat err.txt >&2; echo "FAILED: $*" >&2; exit 1; }

status=0
"$brunt" run "$deck" --until "4 us" --set "output.every=2 us" --set output.pictures=true \
  2>err.txt || status=$?
if grep -q "built without VTK" err.txt; then
  [ $status = 2 ] && [ ! -e bars.out ] || fail "status $status without VTK"
  echo "no VTK: refused"
  exit 0
fi
[ $status = 0 ] || fail "status $status"
grep -q "3 pictures: von_mises.00000.png to von_mises.00002.png" err.txt || fail "not reported where"
for i in 0 1 2; do
  picture=bars.out/von_mises.0000$i.png
  [ "$(head -c 4 "$picture" | tail -c 3)" = PNG ] || fail "$picture is no PNG"
  # A blank picture of 1280 x 800 packs into less than 5 kB.
  [ "$(stat -c %s "$picture")" -gt 5000 ] || fail "$picture is blank"
done
cmp -s bars.out/von_mises.00000.png bars.out/von_mises.00002.png && fail "nothing moved"

"$brunt" run "$deck" --until "4 us" --set "output.every=2 us" --quiet --force 2>err.txt
if compgen -G "bars.out/*.png" >/dev/null; then fail "drawn without being asked"; fi
status=0
"$brunt" render . 2>err.txt || status=$?
[ $status = 2 ] && grep -q "has no frames.pvd" err.txt || fail "render of no folder: $status"
echo "all good"
