#!/usr/bin/env bash
# decks/schema.json against a validator: see tests/support/validate_decks.py.
#   schema.sh PROGRAM SOURCE
set -euo pipefail
# The validator of the distribution, whatever other Python is there.
exec /usr/bin/python3 "$2/tests/support/validate_decks.py" "$2"
