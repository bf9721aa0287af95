#!/usr/bin/env bash
# Sweeps speeds and element sizes of the Taylor bar and ends with one table: nothing but `brunt run` and `brunt table`.
# Run again, it goes on where it stopped.
#   decks/sweep.sh [FOLDER]      speeds and sizes: SPEEDS="130 190" SIZES="0.8 0.6" decks/sweep.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=${1:-sweep.out}
speeds=${SPEEDS:-130 146 190}
sizes=${SIZES:-0.8 0.6}
mkdir -p "$folder"
runs=()
for speed in $speeds; do
  for size in $sizes; do
    out=$folder/$speed-$size
    "$here/../brunt" run "$here/taylor-bar/taylor-bar.yaml" --quiet --resume --json \
      --set "parameters.speed=$speed m/s" --set "parameters.size=$size mm" --out "$out" >"$out.json"
    runs+=("$out")
  done
done
"$here/../brunt" table "${runs[@]}" --show speed,size,length,length.error,steps,cpu_seconds,created,energy.kinetic,status
