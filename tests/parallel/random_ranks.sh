#!/usr/bin/env bash
# Random decks on one rank, and on two ranks that are repartitioned every 7 steps, with another skin: the
# same history, byte for byte, state hashes and all, the same warnings and the same end, for whatever a
# deck draws (tests/support/random_deck.hpp). Decks that break must break in the same step, of the same
# element. Each deck that differs is printed by `random_scenes KIND SEED --print`.
#   random_ranks.sh PROGRAM RANDOM_SCENES STATE_DIFFERENCE [KIND FIRST LAST]...   KIND: deck or newer
set -euo pipefail
brunt=$1 random_scenes=$2 state_difference=$3
own=$(cd "$(dirname "$0")" && pwd)
shift 3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
limit=600  # [s] after which a run hangs

run() {  # run OUT DECK OPTIONS...: its status
  local out=$1 deck=$2 status=0
  shift 2
  printf '%q ' "$work/$deck" --threads 1 "$@" >"$out.args"
  timeout "$limit" "$brunt" run "$deck" --quiet --out "$out" --threads 1 --set output.state_hash=true "$@" \
    >"$out.said" 2>&1 || status=$?
  echo "$status"
}
said() { grep '^brunt: ' "$1.said" || true; }
texts() { grep '"text"' "$1/summary.json" || true; }
check() {  # check KIND SEED
  local name=$1-$2 alone ranks wrong=()
  "$random_scenes" "$1" "$2" --print >"$name.yaml"
  alone=$(run "$name.1" "$name.yaml")
  ranks=$(run "$name.2" "$name.yaml" --ranks 2 --oversubscribe --set ranks.balance=1 \
    --set ranks.balance_steps=7 --set contact.skin=1mm)
  case $alone in 0 | 2 | 3) ;; *) wrong+=("one rank ends with $alone") ;; esac
  [ "$alone" = "$ranks" ] || wrong+=("two ranks end with $ranks, one with $alone")
  cmp -s <(said "$name.1") <(said "$name.2") || wrong+=("the end is said in other words")
  if [ "$alone" != 2 ]; then
    cmp -s "$name.1/history.csv" "$name.2/history.csv" || wrong+=("histories differ")
    cmp -s <(texts "$name.1") <(texts "$name.2") || wrong+=("warnings differ")
    touch "$name.ran"
  fi
  if [ ${#wrong[@]} -gt 0 ]; then
    printf "FAILED: random deck $name: %s\n" "${wrong[@]}"
    grep -h '^brunt: ' "$name.1.said" "$name.2.said" || true
    [ "$alone$ranks" != 00 ] ||
      "$own/first_difference.sh" "$brunt" "$state_difference" "$name.1.args" "$name.2.args" || true
    touch failed
  fi
  rm -rf "$name.1" "$name.2"
}

# As many decks at once as there are cores: half of the time of a short run goes into starting it.
asked=0
while [ $# -ge 3 ]; do
  for seed in $(seq "$2" "$3"); do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
    { check "$1" "$seed" >"$1-$seed.checked" 2>&1 || touch failed; } &
    asked=$((asked + 1))
  done
  shift 3
done
wait
cat ./*.checked
ran=$(find . -name '*.ran' | wc -l)
echo "$ran of $asked random decks ran"
# Some are refused, by the same words; where most are, decks are drawn wrongly.
[ ! -e failed ] && [ "$ran" -gt $((asked / 2)) ]
