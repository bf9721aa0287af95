#!/usr/bin/env bash
# `brunt plan` says beforehand what a run will need: its memory is that of the run's peak within a
# factor of 1.5, for elements and for particles, where the scene outweighs the program.
#   plan.sh PROGRAM SOURCE
set -euo pipefail
brunt=$1
decks=$2/decks
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1

# compare DECK SET: the plan's MB against the peak of a run of a few steps.
compare() {
  local planned peak name
  name=$(basename "$1" .yaml)
  planned=$("$brunt" plan "$1" --set "$2" | sed -n 's/^memory *about \([0-9]*\) MB.*/\1/p')
  "$brunt" run "$1" --set "$2" --until "0.05 us" --quiet --out "$name" 2>/dev/null
  peak=$(sed -n 's/.*"peak_memory": *\([0-9]*\).*/\1/p' "$name/summary.json")
  echo "$name: planned $planned MB, peak $((peak / 1000000)) MB"
  [ $((planned * 3)) -ge $((peak * 2 / 1000000)) ] && [ $((planned * 2)) -le $((peak * 3 / 1000000)) ]
}

compare "$decks/taylor-bar/taylor-bar.yaml" "parameters.size=0.2 mm"
compare "$decks/taylor-bar-sph/taylor-bar-sph.yaml" "parameters.spacing=0.25 mm"
compare "$decks/projectile-2d/projectile-2d.yaml" "parameters.size=0.5 mm"

# What else a plan tells: the columns that measures may name, and whose step it is.
"$brunt" plan "$decks/bars/bars.yaml" >plan.txt
for text in "bound by" "body.striker.velocity.x" "contact.striker-target.force.x"; do
  grep -qF "$text" plan.txt || { cat plan.txt; echo "FAILED: the plan lacks: $text"; exit 1; }
done
# How far elements flatten is not known: a range, which holds what the run takes.
range=$("$brunt" plan "$decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml" |
  sed -n 's/^steps *\([0-9]*\) to \([0-9]*\) up to .*/\1 \2/p')
read -r least most <<<"$range"
"$brunt" run "$decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml" --quiet --out steps
steps=$(sed -n 's/^  "steps": *\([0-9]*\).*/\1/p' steps/summary.json)
echo "taylor-bar-axisymmetric: planned $least to $most steps, taken $steps"
[ "$least" -le "$steps" ] && [ "$steps" -le "$most" ]

# A key is found by its last part, wherever it stands.
"$brunt" explain friction | grep -q '^contact.pairs.NAME.friction'
echo "all good"
