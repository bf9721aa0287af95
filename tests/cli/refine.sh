#!/usr/bin/env bash
# `brunt run --refine`: an error bar for every measure, which holds the exact value; what may not go with it.
#   refine.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# The bar of trade.sh: the stress of its last element is short of the exact one by 1/(2 n), n its number of elements.
cat >bar.yaml <<'DECK'
parameters: {cells: 16, width: 0.01 m}
time: {end: 0.7 ms}
materials: {soft: {density: 1000 kg/m^3, elastic: {E: 10 GPa, nu: 0}}}
bodies:
  bar: {material: soft, shape: {box: {min: [0, 0, 0], max: [0.1 m, $width, $width]}}, cells: [$cells, 1, 1]}
boundaries:
  top: {body: bar, where: {side: max-x}, fix: [x, y, z]}
gravity: [-10 m/s^2, 0, 0]
damping: {rate: 1e5 1/s}
measures:
  sag: {min: {body: bar, field: displacement.x}, exact: -5 nm}
  stress: {max: {body: bar, field: stress.xx}, exact: 1 kPa}
output: {every: 0.2 ms, history: 10 us}
DECK
# The values and bounds of a summary: each exact value lies within its bound.
check() {
  python3 - "$1" <<'PYTHON'
import json, sys
measures = json.load(open(sys.argv[1] + "/summary.json"))["measures"]
for name, m in measures.items():
    # The closed form of the sag holds at nodes to what is left of the swinging, 1e-6 of it.
    room = m["bound"] + 1e-6 * abs(m["exact"])
    print(name, m["value"], "+-", m["bound"], m["convergence"], "exact", m["exact"])
    if abs(m["value"] - m["exact"]) > room:
        sys.exit(name + ": the exact value lies beyond the bound")
if not 0.9 < measures["stress"]["order"] < 1.1:
    sys.exit("the stress of one end converges with order one")
if measures["stress"]["bound"] > 3 * abs(measures["stress"]["value"] - measures["stress"]["exact"]):
    sys.exit("the bound is three times the error and more")
PYTHON
}
expect 0 "$brunt" run bar.yaml --refine
grep -q "stress .* +- .*order 1" err.txt || { cat err.txt; fail "no error bar is printed"; }
check bar.out
[ "$(ls -d bar.out.refine/size-*/ | wc -l)" = 2 ] || fail "not three sizes"
for run in bar.out.refine/size-*/; do
  grep -q '"parameters.cells=\(11\|8\)"' "$run/summary.json" || fail "the size is not that of cells: $run"
done

# Without a parameter it is the cells of bodies; four cells are made finer.
sed -e 's/\$cells/4/' -e 's/{cells: 16, /{/' bar.yaml >four.yaml
expect 0 "$brunt" run four.yaml --refine --quiet --out few
check few
# By a key, two sizes, more sizes.
expect 0 "$brunt" run bar.yaml --refine=2 --refine-key bodies.bar.cells --quiet --out two
grep -q '"convergence": "two sizes give no order"' two/summary.json || fail "two sizes gave an order"
expect 0 "$brunt" run bar.yaml --refine=4 --quiet --json --out many
grep -q '"bound"' out.txt || fail "no bound in the summary that is printed"
check many

# Again: refused, resumed, replaced, as `run` alone.
expect 2 "$brunt" run bar.yaml --refine --quiet
before=$(stat -c %Y.%Z bar.out/history.csv)
expect 0 "$brunt" run bar.yaml --refine --resume --quiet
[ "$before" = "$(stat -c %Y.%Z bar.out/history.csv)" ] || fail "--resume ran again"
check bar.out

# What cannot be.
expect 2 "$brunt" run bar.yaml --refine --refine-key parameters.width --quiet --out wrong
expect 2 "$brunt" run bar.yaml --refine --until "1 ms" --quiet --out wrong
[ ! -e wrong ] || fail "a wrong call made a folder"
echo "all good"
