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
for folder in core fe sph contact app; do
  forbid $folder 'yaml-cpp|vtk|hdf5|H5' 'yaml-cpp, HDF5 and VTK stay in io'
done
exit $status
