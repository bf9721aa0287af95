#!/usr/bin/env bash
# The output folder: what is not of a run stays, another deck is refused, two runs do not meet.
#   folder.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
limit=60
deck=$2/decks/bars/bars.yaml
short=(--quiet --set "time.end=5 us" --set "output.every=2 us" --set "output.history=0.5 us" --set output.state_hash=true)
says() { grep -q -- "$1" err.txt || { cat err.txt; fail "does not say '$1'"; }; }

# Names like those of a run, links and folders are not a run's unless its list has them.
foreign=(holiday.png von_mises.00077.png mine.vtu frames/mine.vtu frames/striker.00099.vtu
  frames/striker.old.vtp frames/x.tmp-abcdef checkpoint-mine.manifest
  checkpoint-000000000001.0.h5.bak notes.txt .tmp-note data.csv)
put_foreign() {
  for file in "${foreign[@]}"; do echo mine >"out/$file"; done
  mkdir -p out/album.png out/frames/album.vtu out/frames/deep.00000.vtu
  echo mine >out/album.png/inside && echo mine >target.txt
  ln -sf "$work/target.txt" out/link.png
  ln -sf "$work/target.txt" out/frames/link.00000.vtu
}
foreign_is_there() {
  for file in "${foreign[@]}" album.png/inside; do
    [ "$(cat "out/$file" 2>/dev/null)" = mine ] || fail "$1: $file is gone"
  done
  [ -d out/frames/album.vtu ] && [ -d out/frames/deep.00000.vtu ] || fail "$1: a folder is gone"
  [ -L out/link.png ] && [ -L out/frames/link.00000.vtu ] && [ "$(cat target.txt)" = mine ] ||
    fail "$1: a link is gone"
}
files_of() { (cd "$1" && find . -type f | sort); }
expect 0 "$brunt" run "$deck" "${short[@]}" --out out
for file in $(cd out && find . -type f ! -name '*.h5' ! -name '*.manifest' ! -name brunt-files.txt); do
  grep -qx "${file#./}" out/brunt-files.txt || fail "$file is not listed"
done
cp -r out pure
put_foreign
expect 0 "$brunt" run "$deck" "${short[@]}" --force --out out
foreign_is_there "--force"
# A longer run leaves more; a shorter one after it leaves none of that.
expect 0 "$brunt" run "$deck" "${short[@]}" --set "time.end=9 us" --force --out out
[ -e out/frames/striker.00005.vtu ] || fail "no sixth frame"
expect 0 "$brunt" run "$deck" "${short[@]}" --force --out out
[ ! -e out/frames/striker.00005.vtu ] || fail "--force left a frame of the run before"
foreign_is_there "--force after a longer run"
expect 0 "$brunt" run "$deck" "${short[@]}" --until "3 us" --force --out out
expect 0 "$brunt" run "$deck" "${short[@]}" --resume --out out
foreign_is_there "--resume"
cmp out/history.csv pure/history.csv || fail "history beside other files"

# The folder of a brunt that kept no list: its own names, and no others.
rm out/brunt-files.txt out/frames/striker.00099.vtu
foreign=("${foreign[@]/frames\/striker.00099.vtu/notes.txt}")
expect 0 "$brunt" run "$deck" "${short[@]}" --until "3 us" --force --out out
foreign_is_there "--force without a list"
rm out/brunt-files.txt
expect 0 "$brunt" run "$deck" "${short[@]}" --resume --out out
foreign_is_there "--resume without a list"
grep -qx 'frames/striker.00000.vtu' out/brunt-files.txt || fail "frames of before are not listed"

# What would have to make room is refused, and stays.
for name in log.txt history.csv summary.json frames.pvd deck.resolved.yaml brunt-files.txt frames; do
  mkdir -p "folder/$name" "linked" "plain"
  if [ "$name" != frames ]; then
    expect 2 "$brunt" run "$deck" "${short[@]}" --force --out folder
    says "folder/$name: is in the way"
  fi
  ln -s "$work/target.txt" "linked/$name"
  expect 2 "$brunt" run "$deck" "${short[@]}" --resume --out linked
  says "linked/$name: is in the way"
  echo mine >"plain/$name"
  [ "$name" = deck.resolved.yaml ] || [ "$name" = frames.pvd ] ||
    expect 2 "$brunt" run "$deck" "${short[@]}" --force --out plain
  [ "$(cat target.txt "plain/$name")" = "mine
mine" ] || fail "$name was written to"
  rm -r folder linked plain
done

# --resume with another deck: refused, with what differs; --force begins anew.
expect 0 "$brunt" run "$deck" "${short[@]}" --until "3 us" --out part
files_of part >before.txt && cp part/history.csv before.csv
changed=("${short[@]}" --set time.safety=0.5)
expect 2 "$brunt" run "$deck" "${changed[@]}" --resume --out part
says 'time.safety: .* in the checkpoint, 0.5 in the deck'
says 'force'
files_of part | cmp - before.txt || fail "a refused --resume changed the folder"
cmp part/history.csv before.csv || fail "a refused --resume wrote to the history"
rm part/checkpoint-*
expect 2 "$brunt" run "$deck" "${changed[@]}" --resume --out part
says 'time.safety: .* in the folder, 0.5 in the deck'
expect 0 "$brunt" run "$deck" "${changed[@]}" --resume --force --out part
expect 0 "$brunt" run "$deck" "${changed[@]}" --out whole
cmp part/history.csv whole/history.csv || fail "--resume --force did not begin anew"

# A second run is refused while the first is there, however it is called; render reads on.
"$brunt" run "$deck" --quiet --set "time.end=1 s" --set "time.max_step=1 ns" --out busy &
pid=$!
for _ in $(seq 300); do [ -e busy/frames/target.00000.vtu ] && break; sleep 0.05; done
for how in --force --resume; do
  expect 2 "$brunt" run "$deck" "${short[@]}" $how --out busy
  says 'another run is writing to this folder'
done
if "$brunt" render busy --frames 0 >out.txt 2>err.txt; then
  [ -s busy/von_mises.00000.png ] || fail "no picture of a run that goes on"
else
  grep -q 'without VTK' err.txt || { cat err.txt; fail "render beside a run"; }
fi
kill -0 $pid || fail "the first run ended"
kill -9 $pid
wait $pid 2>/dev/null || true
# A run that was killed holds nothing.
expect 0 "$brunt" run "$deck" "${short[@]}" --force --out busy
cmp busy/history.csv pure/history.csv || fail "history after a run that was killed"

# Of two at once one runs, with each row once.
expect 0 "$brunt" run "$deck" "${short[@]}" --until "3 us" --out twice
"$brunt" run "$deck" "${short[@]}" --resume --out twice 2>/dev/null & first=$!
"$brunt" run "$deck" "${short[@]}" --resume --out twice 2>/dev/null & second=$!
a=0 b=0
wait $first || a=$?
wait $second || b=$?
case "$a $b" in '0 0' | '0 2' | '2 0') ;; *) fail "two at once: $a and $b" ;; esac
cmp twice/history.csv pure/history.csv || fail "two at once spoil the history"
echo "all good"
