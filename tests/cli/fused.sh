#!/usr/bin/env bash
# Products and sums are fused where the source says so (vfma, core/simd.hpp) and nowhere else: bits would depend on what
# the compiler inlines where, and on the instruction set (docs/decisions/122-fused-turns.md, 225-fused-by-name.md).
# What the source asks for has the form 231, in kernels of eight lanes any; what a compiler fuses by itself adds and
# subtracts in turn, or has another form. Libraries that are linked in by the system are not looked at.
#   fused.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
command -v objdump >/dev/null || { echo "no objdump: not looked at"; exit 0; }
[ "$(uname -m)" = x86_64 ] || { echo "not x86-64: not looked at"; exit 0; }
code=$(mktemp)
trap 'rm -f "$code"' EXIT
objdump -d --no-show-raw-insn "$1" >"$code"
# What is looked for would be found: the program multiplies and adds numbers, many at a time.
[ "$(grep -cE '\bv?mulpd\b' "$code")" -gt 1000 ] || fail "no products are seen: the search is broken"
grep -qE 'vfn?madd231pd.*ymm' "$code" || fail "nothing is fused by name: the search is broken"
fused=$(awk '/^[0-9a-f]+ <.*>:$/ { name = $2; wide = name ~ /Dv8_d/ }
  /\tv?fm(addsub|subadd)/ { count[name]++ }
  /\tv?fn?m(add|sub)(132|213)/ && !wide { count[name]++ }
  END { for (name in count) print name, count[name] }' "$code")
[ -z "$fused" ] || fail "fused instructions in: $fused"
