#!/usr/bin/env bash
# Decks of docs/guide: see tests/support/check_guide.py.
#   guide.sh PROGRAM SOURCE
set -euo pipefail
exec /usr/bin/python3 "$2/tests/support/check_guide.py" "$1" "$2"
