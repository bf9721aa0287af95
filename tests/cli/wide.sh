#!/usr/bin/env bash
# Registers of 512 bits are used by kernels of eight lanes alone, whose names have a vector of eight: what else a source
# that is built for AVX-512 made out of line the linker could take for the whole program, which other processors run too.
#   wide.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
command -v objdump >/dev/null || { echo "no objdump: not looked at"; exit 0; }
[ "$(uname -m)" = x86_64 ] || { echo "not x86-64: not looked at"; exit 0; }
code=$(mktemp)
trap 'rm -f "$code"' EXIT
# Registers 16 to 31 and those of masks came with AVX-512 as well.
objdump -d --no-show-raw-insn "$1" | awk '/^[0-9a-f]+ <.*>:$/ { name = $2 }
  /%zmm|%[xy]mm(1[6-9]|2[0-9]|3[01])|%k[0-7]\>/ { count[name]++ }
  END { for (name in count) print name, count[name] }' >"$code"
if ! grep -q Dv8_d "$code"; then
  [ ! -s "$code" ] || fail "AVX-512 without kernels of eight lanes: $(cat "$code")"
  echo "not built for AVX-512"
  exit 0
fi
others=$(grep -vE "Dv8_d|make_wide_strength" "$code" || true)
[ -z "$others" ] || fail "AVX-512 outside of kernels of eight lanes: $others"
