#!/usr/bin/env bash
# Says in which step two runs differ first, and in which body and entity: runs both again with a row a
# step, then up to that step, and compares their checkpoints.
#   first_difference.sh PROGRAM STATE_DIFFERENCE A B   A, B: files with the arguments of `run` but for
#   --out, quoted for the shell. Status 1 where a difference was found, 0 where there is none.
set -euo pipefail
brunt=$1 state_difference=$2
declare -a a b
eval "a=($(cat "$3"))"
eval "b=($(cat "$4"))"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for each in a b; do
  declare -n arguments=$each
  "$brunt" run "${arguments[@]}" --quiet --out "$work/$each" --set output.history='1e-15 s' \
    --set output.every='1 s' --set output.state_hash=true >/dev/null 2>&1 || { echo "run $each fails: ${arguments[*]}"; exit 2; }
done
# Step and time of the first row in which anything differs.
found=$(paste -d'\n' "$work/a/history.csv" "$work/b/history.csv" | awk -F, '
  NR % 2 { row = $0; next } row != $0 { split(row, one, ","); print one[2], one[1]; exit }' || true)  # awk ends before paste has written all
[ -n "$found" ] || { echo "histories of every step are the same"; exit 0; }
read -r step time <<<"$found"
for each in a b; do
  declare -n arguments=$each
  "$brunt" run "${arguments[@]}" --quiet --out "$work/$each-$step" --until "$time s" >/dev/null 2>&1 ||
    { echo "run $each fails up to $time s"; exit 2; }
done
echo "the first row that differs is of step $step, $time s:"
"$state_difference" "$work/a-$step" "$work/b-$step" && echo "no state differs after step $step"
exit 1
