#!/usr/bin/env bash
# `run --refine`: of ten decks with closed forms the exact values lie within the bounds in nine.
#   refine_bounds.sh PROGRAM SOURCE
exec python3 "$2/tests/support/refine_bounds.py" "$1" "$2"
