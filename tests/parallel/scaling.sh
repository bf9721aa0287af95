#!/usr/bin/env bash
# What tests/bench/scaling predicts of ranks: every point is owned once, one rank copies nothing, and
# two and three ranks send what runs of two and three ranks do send.
#   scaling.sh SCALING BRUNT SOURCE
set -euo pipefail
scaling=$1 brunt=$2 decks=$3/decks
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
status=0
fail() { echo "FAILED: $*"; status=1; }

# A step sends what two runs of different length differ by; start and frames are in both.
sent() {  # sent DECK RANKS UNTIL LONGER OVERRIDES... : messages and bytes a step
  local deck=$1 n=$2 until=$3 longer=$4 out k=0
  shift 4
  for out in short long; do
    "$brunt" run "$decks/$deck/$deck.yaml" --quiet --force --out "$out" --ranks "$n" --threads 1 \
      --oversubscribe --until "$([ $out = short ] && echo "$until" || echo "$longer")" \
      --set output.every='1 s' "$@" 2>"$out.err" || { cat "$out.err" >&2; return 1; }
  done
  paste <(numbers short) <(numbers long) | awk '
    { short[NR] = $1; long[NR] = $2 }
    END { d = long[1] - short[1]
          for (i = 2; i <= 3; ++i) print (long[i] * long[1] - short[i] * short[1]) / d }'
}
numbers() {  # steps, messages and bytes a step of a summary
  for key in steps messages_step bytes_step; do
    grep -o "\"$key\": *[0-9.e+]*" "$1/summary.json" | head -1 | sed 's/.*: *//'
  done
}
near() {  # near A B SHARE
  awk -v a="$1" -v b="$2" -v s="$3" 'BEGIN { d = a - b; exit !(d * d <= s * s * b * b) }'
}
# check DECK STEPS UNTIL LONGER OVERRIDES... ; lists are rarer later on: LONGER lasts about STEPS
check() {
  local deck=$1 steps=$2 until=$3 longer=$4 sets=() each
  shift 4
  for each in "$@"; do sets+=(--set "${each//_/ }"); done
  "$scaling" "$decks/$deck/$deck.yaml" --steps "$steps" --ranks 1,2,3,8,64 --csv "${sets[@]}" >predicted
  awk -F, -v deck="$deck" '
    NR == 2 { points = $2; elements = $3; particles = $4
              if ($5 != 0 || $6 != $3 || $8 != 0 || $9 != 0) wrong("one rank copies or sends") }
    NR > 2 { if ($2 != points || $3 != elements || $4 != particles) wrong("owned once is not so")
             if ($5 <= 0 || $6 < $3 || $8 < $1 - 1) wrong("too little is copied or sent")
             if ($1 <= 8 && $7 > 1.03) wrong("out of balance: " $7) }
    function wrong(what) { print "FAILED: " deck ": " $1 " ranks: " what; bad = 1 }
    END { if (NR != 6) wrong("rows are missing"); exit bad }' predicted || status=1
  for n in 2 3; do
    sent "$deck" "$n" "$until" "$longer" "${sets[@]}" >run || { fail "$deck: $n ranks"; continue; }
    local messages bytes predicted_messages predicted_bytes
    { read -r messages; read -r bytes; } <run
    IFS=, read -r predicted_messages predicted_bytes < <(awk -F, -v n="$n" '$1 == n { print $8 "," $9 }' predicted)
    # Several ranks make their lists a little more often than the one that was asked.
    near "$predicted_messages" "$messages" 0.15 ||
      fail "$deck: $n ranks: $predicted_messages messages a step, a run sends $messages"
    near "$predicted_bytes" "$bytes" 0.1 ||
      fail "$deck: $n ranks: $predicted_bytes bytes a step, a run sends $bytes"
  done
}
check taylor-bar 60 '1 us' '3 us' parameters.size=0.9_mm 'bodies.bar.element={integration:_one-point}'
check taylor-bar-sph 40 '0.5 us' '5.5 us' parameters.spacing=0.8_mm
check drop-on-plate 60 '4 us' '30 us' parameters.size=4_mm
exit $status
