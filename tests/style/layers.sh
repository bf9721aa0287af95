#!/usr/bin/env bash
# Fails on an #include that goes upward or sideways (README.md, How it is built): core < fe, sph, contact, io < app,
# and on a library outside the one folder that may use it.
set -euo pipefail
cd "$(dirname "$0")/../.."
status=0
forbid() {  # forbid FOLDER PATTERN REASON
  local hits
  hits=$(grep -rnE "^#include [<\"]($2)" --include=*.hpp --include=*.cpp "$1" || true)
  if [ -n "$hits" ]; then
    printf '%s: %s\n%s\n' "$1" "$3" "$hits"
    status=1
  fi
}
forbid core 'app/|fe/|sph/|contact/|io/' 'core includes nothing above it'
forbid fe 'app/|sph/|contact/|io/' 'fe includes core only'
forbid sph 'app/|fe/|contact/|io/' 'sph includes core only'
forbid contact 'app/|fe/|sph/|io/' 'contact includes core only'
forbid io 'app/|fe/|sph/|contact/' 'io includes core only'
# The rooms of a layer, each on those before it, and no source beside them.
rooms() {  # rooms LAYER ROOM...
  local layer=$1 above= i loose
  shift
  local all=("$@")
  for ((i = $# - 1; i >= 0; i--)); do
    [ -d "$layer/${all[i]}" ] || { echo "$layer/${all[i]}: there is no such room"; status=1; continue; }
    [ -z "$above" ] || forbid "$layer/${all[i]}" "$layer/($above)/" "${all[i]} includes no room above it"
    above=${all[i]}${above:+|$above}
  done
  loose=$(find "$layer" -type f | cut -d/ -f2 | sort -u | grep -vxE "$above|CMakeLists.txt" || true)
  [ -z "$loose" ] || { printf '%s, in no room: %s\n' "$layer" "$loose"; status=1; }
}
rooms contact geometry law surfaces contacts exchange search evaluate manager
rooms app deck scene ranks loop watch setup restart trade report cli
for folder in core fe sph contact app; do
  forbid $folder 'yaml-cpp|vtk|hdf5|H5' 'yaml-cpp, HDF5 and VTK stay in io'
done
exit $status
