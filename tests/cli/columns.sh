#!/usr/bin/env bash
# docs/columns.md against what runs write: see tests/support/check_columns.py.
#   columns.sh PROGRAM SOURCE
set -euo pipefail
exec /usr/bin/python3 "$2/tests/support/check_columns.py" "$1" "$2"
