#!/usr/bin/env bash
# `brunt trade`: errors are the same bits in two calls and over an interruption; what is done is not run again; fronts,
# orders, files.
#   trade.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# A bar that is stretched by its own weight: u = rho g L^2 / (2 E) below, which elements of constant strain meet at every
# size, and a density on which it depends. Settled by damping.
cat >bar.yaml <<'DECK'
parameters: {cells: 4, density: 1000 kg/m^3, g: 10 m/s^2, length: 0.1 m, E: 10 GPa}
time: {end: 0.7 ms}
materials: {soft: {density: $density, elastic: {E: $E, nu: 0}}}
bodies:
  bar: {material: soft, shape: {box: {min: [0, 0, 0], max: [$length, 0.01 m, 0.01 m]}}, cells: [$cells, 1, 1]}
boundaries:
  top: {body: bar, where: {side: max-x}, fix: [x, y, z]}
gravity: [= -$g, 0, 0]
damping: {rate: 1e5 1/s}
measures:
  sag: {min: {body: bar, field: displacement.x}, exact: = -$density * $g * $length^2 / (2 * $E), reference: -4 nm}
  stress: {max: {body: bar, field: stress.xx}, exact: = $density * $g * $length}
output: {every: 0.2 ms, history: 10 us}
DECK
vary=(--vary "parameters.cells=4,8,16")
expect 0 "$brunt" trade bar.yaml "${vary[@]}" --repeat 2 --quiet --out one
for file in trade.csv trade.json trade.svg; do [ -s one/$file ] || fail "one/$file is missing"; done
[ -s one/cells-16.repeat-2/summary.json ] || fail "no repeat"
cp out.txt one.txt
# The largest stress is that of the middle of the last element: (1 - 1/(2n)) of the exact value, error of order one.
grep -q "^  over cells, of 3 runs down to cells 16: order 1" one.txt || { cat one.txt; fail "no order of convergence"; }
grep -q "cells 16.*front" one.txt || fail "no front"
grep -q "finest: cells 16" one.txt || fail "no finest"

errors() { cut -d, -f1-8 "$1/trade.csv"; }

# Again: the same errors, and the runs of before.
before=$(stat -c %Y.%Z one/cells-4/history.csv)
expect 0 "$brunt" trade bar.yaml "${vary[@]}" --repeat 2 --quiet --out one
[ "$before" = "$(stat -c %Y.%Z one/cells-4/history.csv)" ] || fail "what was done ran again"
expect 0 "$brunt" trade bar.yaml "${vary[@]}" --repeat 1 --jobs 2 --quiet --out two
[ "$(errors one)" = "$(errors two)" ] || fail "errors of two trades differ"

# Folders of repeats are no variant's: the second run of 1 was in that of 1.2.
expect 0 "$brunt" trade bar.yaml --vary time.max_drift=1,1.2 --repeat 2 --quiet --out alike
for run in 1 1.2 1.repeat-2 1.2.repeat-2; do
  [ -s "alike/max_drift-$run/summary.json" ] || { ls alike; fail "no folder of run $run"; }
done
grep -q '1.2' alike/max_drift-1.2/deck.resolved.yaml || fail "the run of 1.2 is that of 1"

# Killed half way: the next call goes on from the last checkpoint, to the same bits.
slow=(--set "time.end=0.05 s" --set "output.history=0.1 ms" --set "output.every=0.02 s" --set "output.checkpoint_steps=500")
"$brunt" trade bar.yaml "${vary[@]}" "${slow[@]}" --repeat 1 --quiet --out cut >/dev/null 2>&1 &
trade=$!
for _ in $(seq 6000); do
  compgen -G "cut/cells-16/checkpoint-*.manifest" >/dev/null && break
  sleep 0.02
done
kill -KILL "$(pgrep -P "$trade")" || true      # the run itself; the trade says so and ends
wait "$trade" && fail "a trade of which a run was killed is done"
expect 0 "$brunt" trade bar.yaml "${vary[@]}" "${slow[@]}" --repeat 1 --quiet --out cut
! grep -q '"first_step": 0,' cut/cells-16/summary.json || fail "it began anew"
grep -q "went on after an interruption" out.txt || fail "the time of a part passes for that of the whole"
expect 0 "$brunt" trade bar.yaml "${vary[@]}" "${slow[@]}" --repeat 1 --quiet --out whole
[ "$(errors cut)" = "$(errors whole)" ] || fail "errors over an interruption differ"

# Asked to stop: status 5, and the next call ends it.
"$brunt" trade bar.yaml "${vary[@]}" "${slow[@]}" --repeat 1 --quiet --out asked >/dev/null 2>&1 &
trade=$!
for _ in $(seq 3000); do  # until its first run is under way
  [ -e asked/cells-4/history.csv ] && break
  sleep 0.02
done
kill -TERM "$trade"
status=0
wait "$trade" || status=$?
[ $status = 5 ] || [ $status = 0 ] || fail "status $status after a signal"
expect 0 "$brunt" trade bar.yaml "${vary[@]}" "${slow[@]}" --repeat 1 --quiet --out asked
[ "$(errors asked)" = "$(errors whole)" ] || fail "errors after a stop differ"

# One at a time; the deck as it stands is not run twice; a changed deck is not taken for the old one.
expect 0 "$brunt" trade bar.yaml "${vary[@]}" --vary "time.safety=0.5" --one-at-a-time --repeat 1 --quiet --out single
[ "$(grep -c ',sag,' single/trade.csv)" = 4 ] || { cat single/trade.csv; fail "not four variants"; }
expect 3 "$brunt" trade bar.yaml "${vary[@]}" --set "parameters.density=900 kg/m^3" --repeat 1 --quiet --out two
grep -q "force" err.txt || { cat err.txt; fail "no way out of a changed deck"; }
expect 0 "$brunt" trade bar.yaml "${vary[@]}" --set "parameters.density=900 kg/m^3" --repeat 1 --quiet --force --out two

# Wrong calls: all that is wrong, nothing runs.
expect 2 "$brunt" trade bar.yaml --vary "parameters.cels=4,8" --vary "time.safety=2" --out wrong
grep -q "cels" err.txt && grep -q "safety" err.txt || { cat err.txt; fail "not all that is wrong is said"; }
[ ! -e wrong ] || fail "a wrong call made a folder"
expect 2 "$brunt" trade bar.yaml
expect 2 "$brunt" trade bar.yaml --set time.safety=0.5 "${vary[@]}" --vary "times.end=1" --out wrong
grep -q "^--vary #2: unknown key 'times'" err.txt || { cat err.txt; fail "the option that is wrong is not named"; }
expect 2 "$brunt" trade bar.yaml "${vary[@]}" --out ''
expect 2 "$brunt" trade bar.yaml "${vary[@]}" --grid --one-at-a-time

# `table` shows columns of history.csv and what runs cost.
expect 0 "$brunt" table one/cells-4 one/cells-16 --show cells,cpu_seconds,body.bar.position.x,sag.exact
grep -q "cpu_seconds \[s\]" out.txt || fail "no processor time"
grep -q "one/cells-16 .*0\.0" out.txt || { cat out.txt; fail "no column of the history"; }
echo "all good"
