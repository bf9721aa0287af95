#!/usr/bin/env bash
# `brunt plan` says beforehand what a run will need: its memory is that of the run's peak within
# 15 %, for elements and for particles, where the scene outweighs the program.
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
  planned=$("$brunt" plan "$1" --set "$2" --no-rehearsal | sed -n 's/^memory *about \([0-9]*\) MB.*/\1/p')
  "$brunt" run "$1" --set "$2" --until "0.05 us" --quiet --out "$name" 2>/dev/null
  peak=$(sed -n 's/.*"peak_memory": *\([0-9]*\).*/\1/p' "$name/summary.json")
  echo "$name: planned $planned MB, peak $((peak / 1000000)) MB"
  [ $((planned * 115)) -ge $((peak / 10000)) ] && [ $((planned * 100)) -le $((peak / 10000 * 115 / 100)) ]
}

compare "$decks/taylor-bar/taylor-bar.yaml" "parameters.size=0.2 mm"
compare "$decks/taylor-bar-sph/taylor-bar-sph.yaml" "parameters.spacing=0.25 mm"
# Particles of a narrow kernel beside a rigid body, which has the default's and no use for it.
compare "$2/tests/bench/particles.yaml" "parameters.spacing=0.2 mm"
compare "$decks/projectile-2d/projectile-2d.yaml" "parameters.size=0.5 mm"

# What else a plan tells: the columns that measures may name, and whose step it is.
"$brunt" plan "$decks/bars/bars.yaml" >plan.txt
for text in "bound by" "body.striker.velocity.x" "contact.striker-target.force.x"; do
  grep -qF "$text" plan.txt || { cat plan.txt; echo "FAILED: the plan lacks: $text"; exit 1; }
done
# How far elements flatten is known of a run that takes seconds, as it is tried: to a hundredth, as the first step is not
# that of the deck alone. Of longer ones it is rehearsed with larger elements (Rehearsals of unit_app).
planned=$("$brunt" plan "$decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml" |
  sed -n 's/^steps *\([0-9]*\) to 80 us, by a run of the deck itself/\1/p')
"$brunt" run "$decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml" --quiet --out steps
steps=$(sed -n 's/^  "steps": *\([0-9]*\).*/\1/p' steps/summary.json)
echo "taylor-bar-axisymmetric: planned $planned steps, taken $steps"
{ [ -n "$planned" ] && [ $((100 * planned)) -ge $((99 * steps)) ] && [ $((100 * planned)) -le $((101 * steps)) ]; } ||
  { echo "FAILED: steps"; exit 1; }
"$brunt" plan "$decks/taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml" --no-rehearsal >plan.txt
grep -q '^steps *[0-9]* to [0-9]* up to 80 us' plan.txt ||
  { cat plan.txt; echo "FAILED: no range without a rehearsal"; exit 1; }
# All of them had one reason, which the summary names.
grep -qF '"element of bar": 1.0' steps/summary.json
# Sizes of a mesh file cannot be made larger, and this run does not get far: a range, which the energy bounds.
printf '%s\n' '$MeshFormat' '2.2 0 8' '$EndMeshFormat' '$Nodes' 4 '1 0 0 0' '2 1 0 0' '3 1 1 0' '4 0 1 0' \
  '$EndNodes' '$Elements' 1 '1 3 2 1 1 1 2 3 4' '$EndElements' >bar.msh
printf '%s\n' 'title: a bar from a file' 'geometry: plane-strain' 'time: {end: 80 us}' \
  'materials: {copper: {library: copper-ofhc}}' 'bodies:' \
  '  bar: {material: copper, file: bar.msh, scale: 1 mm, velocity: [200 m/s, 0]}' \
  '  wall: {rigid: true, shape: {box: {min: [1 mm, -5 mm], max: [2 mm, 5 mm]}}}' >mesh.yaml
"$brunt" plan mesh.yaml >plan.txt
grep -q '^steps *[0-9]* to [0-9]* up to 80 us' plan.txt ||
  { cat plan.txt; echo "FAILED: no range where nothing can be rehearsed"; exit 1; }

# A key is found by its last part, wherever it stands.
"$brunt" explain friction | grep -q '^contact.pairs.NAME.friction'
echo "all good"
