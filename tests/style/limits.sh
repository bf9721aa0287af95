#!/usr/bin/env bash
# Fails on files over 400 lines and on lines over 100 characters (the style of this project).
set -euo pipefail
cd "$(dirname "$0")/../.."
find app core fe sph contact io tests \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 awk '
  FNR == 1 { if (NR > 1 && lines > 400) { print file ": " lines " lines"; bad = 1 } file = FILENAME }
  { lines = FNR; if (length($0) > 100) { print FILENAME ":" FNR ": " length($0) " characters"; bad = 1 } }
  END { if (lines > 400) { print file ": " lines " lines"; bad = 1 } exit bad }'
