#!/usr/bin/env bash
# Where one bit of one value is another, the difference is named: step, table, body, entity, column.
#   difference.sh PROGRAM SOURCE STATE_DIFFERENCE
set -euo pipefail
brunt=$1 source=$2 state_difference=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
fail() { echo "FAILED: $*"; exit 1; }
deck=$source/decks/bars/bars.yaml
"$brunt" run "$deck" --quiet --out half --set time.end='4 us' --until '2 us' --ranks 2 --oversubscribe 2>/dev/null
"$state_difference" half half || fail "a checkpoint differs from itself"

# The velocity along x of node 204, which is of the target: column 4 after mass and position.
"$state_difference" --change half changed points 204 4
said=$("$state_difference" half changed) && fail "nothing was found"
case $said in
  "step "*", table points, id 204, body target, column 4: "*"; 1 of "*) ;;
  *) fail "said '$said'" ;;
esac
# Of an element: its id, its body.
"$state_difference" --change half changed "$("$state_difference" --tables half | grep -m1 '^elements')" 7 0
said=$("$state_difference" half changed) && fail "nothing was found"
case $said in
  *", table elements."*", id 7, body striker, column 0: "*"; 1 of "*) ;;
  *) fail "said '$said'" ;;
esac

# Two runs that go on from there: one step later neighbours of the node differ too, no others.
"$state_difference" --change half changed points 204 4
step=$(basename half/checkpoint-*.manifest .manifest | sed 's/checkpoint-0*//')
for from in half changed; do
  printf '%q ' "$deck" --set 'time.end=4 us' --restart "$PWD/$from" >$from.args
done
status=0
said=$("$source/tests/parallel/first_difference.sh" "$brunt" "$state_difference" half.args changed.args) || status=$?
[ "$status" = 1 ] || fail "status $status: $said"
grep -q "^the first row that differs is of step $((step + 1)), " <<<"$said" || fail "said '$said'"
# The striker stands at the target, and feels it in the same step.
grep -qE "^step $((step + 1)), table points, id [0-9]*, body (striker|target), column" <<<"$said" ||
  fail "said '$said'"
# The same arguments twice: no difference.
"$source/tests/parallel/first_difference.sh" "$brunt" "$state_difference" half.args half.args >same.txt ||
  fail "$(cat same.txt)"
