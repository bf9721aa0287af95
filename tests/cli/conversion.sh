#!/usr/bin/env bash
# Elements that become particles, over a restart: frames, history and the last checkpoint of a run in parts are those of a
# run in one, to the byte, whether it goes on in its folder or in another, before, while and after elements go.
#   conversion.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
limit=120

# deck GEOMETRY STRIKER PLATE VELOCITY: boxes as their corners.
deck() {
  cat <<DECK
title: A striker and a plate become particles
geometry: $1
time: {end: 24 us}
heat: conduct
materials:
  lead:
    density: 11340 kg/m^3
    elastic: {E: 16 GPa, nu: 0.3}
    strength: {j2: {yield: 20 MPa, hardening: 20 MPa}}
    thermal: {cp: 129 J/kg/K, k: 35 W/m/K}
bodies:
  striker: {material: lead, shape: {box: $2}, size: 1 mm, velocity: $4, erode: {when: {strain: 0.3}, to: sph}}
  plate: {material: lead, shape: {box: $3}, size: 1 mm, erode: {when: {strain: 0.3}, to: sph}}
contact: {default: {friction: 0.1}}
output: {every: 2 us, history: 0.5 us, state_hash: true}
DECK
}
deck 3d '{min: [-2 mm, -2 mm, 0.1 mm], max: [2 mm, 2 mm, 5.1 mm]}' '{min: [-4 mm, -4 mm, -2 mm], max: [4 mm, 4 mm, 0]}' \
  '[20 m/s, 0, -200 m/s]' >solid.yaml
deck plane-strain '{min: [-2 mm, 0.1 mm], max: [2 mm, 6.1 mm]}' '{min: [-5 mm, -2 mm], max: [5 mm, 0]}' \
  '[20 m/s, -200 m/s]' >flat.yaml

# eroded FOLDER: elements that have gone by each row.
eroded() {
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^body\..*\.eroded$/) at[i] = 1; next }
    { n = 0; for (i in at) n += $i; print n }' "$1/history.csv"
}
same_bytes() {  # same_bytes A B: all but what holds wall times
  diff -rq --exclude=log.txt --exclude=summary.json --exclude=deck.resolved.yaml --exclude=brunt-files.txt \
    --exclude='checkpoint-*' "$1" "$2" || fail "$2 differs from $1"
  local last
  last=$(cd "$1" && find . -name '*.h5' | sort | tail -n 1)
  cmp "$1/$last" "$2/$last" || fail "the last checkpoint of $2"
}

for name in solid flat; do
  expect 0 "$brunt" run $name.yaml --quiet --out whole_$name
  [ -s whole_$name/frames/striker.particles.00012.vtu ] || fail "no particles in the frames of whole_$name"
  for until in 2 7 15; do
    expect 0 "$brunt" run $name.yaml --quiet --until "$until us" --out part
    gone=$(eroded part | tail -n 1) end=$(eroded whole_$name | tail -n 1)
    echo "$name: $gone of $end elements have gone at $until us"
    case $until in
      2) [ "$gone" = 0 ] || fail "$gone elements have gone at $until us" ;;
      *) [ "$gone" -gt 0 ] && [ "$gone" -lt "$end" ] || fail "$gone of $end elements at $until us" ;;
    esac
    expect 0 "$brunt" run $name.yaml --quiet --restart part --out other
    same_bytes whole_$name other
    expect 0 "$brunt" run $name.yaml --quiet --resume --out part
    same_bytes whole_$name part
    rm -r part other
  done
done
echo "all good"
