#!/usr/bin/env bash
# Fails on an #include that goes upward or sideways (docs/architecture.md): core < fe, sph, contact, io < app,
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
# The rooms of contact, each on those before it; what other layers use is the manager's.
rooms=(geometry law surfaces contacts exchange search evaluate manager)
above='-'
for ((i = ${#rooms[@]} - 1; i >= 0; i--)); do
  room=${rooms[i]}
  [ -d "contact/$room" ] || { echo "contact/$room: no such room"; status=1; continue; }
  [ "$above" = - ] || forbid "contact/$room" "contact/($above)/" "$room includes no room above it"
  above="$room|${above#-}"
  above=${above%|}
done
loose=$(ls contact | grep -vxE "$(IFS='|'; echo "${rooms[*]}")|CMakeLists.txt" || true)
[ -z "$loose" ] || { printf 'contact: in no room: %s\n' "$loose"; status=1; }
for folder in core fe sph contact app; do
  forbid $folder 'yaml-cpp|vtk|hdf5|H5' 'yaml-cpp, HDF5 and VTK stay in io'
done
exit $status
