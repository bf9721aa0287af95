#!/usr/bin/env bash
# Wrong decks by hand, tests/wrong/*.yaml, as users write them. Below each deck stands what must be
# reported, all of it and nothing else:
#   #! LINE:COLUMN: key: what is wrong and what would be right     status 2, and no folder is made
#   #~ LINE:COLUMN: key: a warning                                 alone: the deck is right, status 0
# A text may end early; FILE stands for the deck's own name.
#   wrong_decks.sh PROGRAM SOURCE
set -euo pipefail
brunt=$1
decks=$2/tests/wrong
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$decks"/*.yaml "$decks"/*.stl "$decks"/*.msh "$work"
cd "$work"
export OMP_NUM_THREADS=1
failures=0
count=0

fail() {
  echo "FAILED: $1: $2" >&2
  failures=$((failures + 1))
}

# reported NAME MARK HEAD: each expected line begins a line of what was reported, and there are no others.
reported() {
  local wanted line found expected=0 lines=()
  mapfile -t lines < <(grep "^$3$1.yaml" err.txt || true)
  while IFS= read -r wanted; do
    wanted="$3$1.yaml:${wanted#"$2 "}"
    wanted=${wanted//FILE/$1.yaml}
    expected=$((expected + 1))
    found=0
    for line in "${lines[@]}"; do
      if [ "${line:0:${#wanted}}" = "$wanted" ]; then found=1; fi
    done
    [ $found = 1 ] || fail "$1" "not reported: $wanted"
  done < <(grep "^$2 " "$1.yaml" || true)
  [ ${#lines[@]} = "$expected" ] || fail "$1" "reported ${#lines[@]}, expected $expected: ${lines[*]}"
}

for deck in *.yaml; do
  name=${deck%.yaml}
  count=$((count + 1))
  wanted=0
  if grep -q '^#! ' "$deck"; then wanted=2; fi
  # A run would make its folder; a deck that is only warned of need not be run to its end.
  if [ $wanted = 2 ]; then command=(run --quiet --out "$name.out"); else command=(check); fi
  status=0
  "$brunt" "${command[0]}" "$deck" "${command[@]:1}" >out.txt 2>err.txt || status=$?
  [ $status = $wanted ] || fail "$name" "status $status instead of $wanted: $(cat err.txt)"
  [ ! -e "$name.out" ] || fail "$name" "a folder was made"
  reported "$name" '#!' ''
  reported "$name" '#~' 'warning: '
done
[ $count -ge 40 ] || fail "$decks" "only $count decks"

# Calls that are wrong: CALL is what stands behind `brunt run`, TEXT what must be reported.
call() {
  local text=$1 status=0
  shift
  "$brunt" run "$@" >out.txt 2>err.txt || status=$?
  [ $status = 2 ] || fail "run $*" "status $status instead of 2"
  grep -qF -- "$text" err.txt || fail "run $*" "not reported: $text; but $(cat err.txt)"
  [ ! -e made.out ] || fail "run $*" "a folder was made"
}
sound=$2/decks/bars/bars.yaml
mkdir folder
: >empty.yaml
printf '# nothing yet\n' >comment.yaml
call "folder: is a folder, not a deck" folder --out made.out
call "nowhere.yaml: there is no such file" nowhere.yaml --out made.out
call "empty.yaml:1:1: time: is missing" empty.yaml --out made.out
call "comment.yaml:1:1: bodies: is missing" comment.yaml --out made.out
if [ "$(id -u)" != 0 ]; then
  cp "$sound" locked.yaml
  chmod a-r locked.yaml
  call "cannot read the file 'locked.yaml'" locked.yaml --out made.out
fi
call "--set #1: unknown key 'boundries'; did you mean 'boundaries'?" \
  "$sound" --set boundries.left.fix=[x] --out made.out
call "--set #1: bodies.strker.material: is missing" "$sound" --set bodies.strker.size=1 --out made.out
call "--set #1: time.end: expects a time (s), got '3 mm'" \
  "$sound" --set "time.end=3 mm" --out made.out
call "--set #2: bodies.striker.velocity: expects a list of 3 components" \
  "$sound" --set "time.end=1 us" --set "bodies.striker.velocity=[1 m/s, 0]" --out made.out
call "--set #1: expects KEY=VALUE, got 'time.end'" "$sound" --set time.end --out made.out
call "--set #1: time.end: has no value" "$sound" --set time.end= --out made.out
call "--set #1: bodies.striker.cells.7: is not an entry" \
  "$sound" --set bodies.striker.cells.7=3 --out made.out
call "--until" "$sound" --until "3 mm" --out made.out
call "the output folder exists; --force replaces it" "$sound" --out folder
[ -z "$(ls folder)" ] || fail "--out" "something was written into a folder that exists"
: >file
call "is a file, not an output folder" "$sound" --out file --force

echo "$count wrong decks, $failures failures"
[ $failures = 0 ]
