#!/usr/bin/env bash
# A process that is stepped faster: what a user reads is in real time, in every file and line.
#   process_speed.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
limit=60
cat >press.yaml <<'YAML'
title: a block is pressed
geometry: plane-strain
time: {end: 0.8 ms, process_speed: 10}
materials:
  steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, strength: {j2: {yield: 300 MPa, hardening: 1 GPa}}}
bodies: {block: {material: steel, shape: {box: {min: [0, 0], max: [4 mm, 4 mm]}}, cells: [4, 4]}}
boundaries:
  below: {body: block, where: {side: min-y}, fix: [y]}
  above: {body: block, where: {side: max-y}, velocity: [free, "= -0.375*(1 - cos(2*pi*t/0.8e-3))"]}
output: {history: 4 us, state_hash: true}
YAML

expect 0 "$brunt" plan press.yaml
grep -q "process    stepped 10 times faster" out.txt || fail "plan does not say that times are real"
grep -qE "^steps .*800 us" out.txt || { cat out.txt; fail "plan does not say the real end"; }
expect 0 "$brunt" run press.yaml --out whole
grep -q "stepped 10 times faster: forces of inertia and kinetic energies are 100 times" err.txt || fail "no distortion"
grep -q "process_speed: 10" whole/deck.resolved.yaml || fail "the resolved deck is not the user's"
grep -qE "end: (8e-04|0.0008)" whole/deck.resolved.yaml || fail "the resolved deck is not in real time"
python3 - <<'PYTHON'
import csv, json
rows = list(csv.DictReader(open("whole/history.csv")))
assert abs(float(rows[-1]["time"]) - 0.8e-3) < 1e-15, rows[-1]["time"]
assert abs(float(rows[100]["time"]) - float(rows[99]["time"]) - 4e-6) < 3e-6
fastest = min(float(row["body.block.velocity.y"]) for row in rows)
assert -0.40 < fastest < -0.36, fastest            # half of 0.75 m/s
process = json.load(open("whole/summary.json"))["process"]
assert process["speed"] == 10 and "100 times" in process["distorts"]
assert 0 < process["kinetic_over_work"]["block"]["mean"] < 0.05, process
PYTHON
if [ -e whole/frames.pvd ]; then
  last=$(grep -oE 'timestep="[^"]*"' whole/frames.pvd | tail -1)
  case $last in *8e-04* | *0.0008* | *0.00079999*) ;; *) fail "frames end at $last" ;; esac
fi
says=$("$brunt" status whole)
case $says in *"of 800 us"*) ;; *) fail "status says $says" ;; esac

# What was stopped goes on bit for bit, from a checkpoint that says the real time.
expect 0 "$brunt" run press.yaml --quiet --out parts --until "0.3 ms"
"$brunt" verify parts | grep -q "t = 0.000300" || { "$brunt" verify parts; fail "not the real time of a checkpoint"; }
expect 0 "$brunt" run press.yaml --quiet --out parts --resume
cmp whole/history.csv parts/history.csv || fail "another history after a restart"
expect 2 "$brunt" run press.yaml --quiet --out parts --resume --set time.process_speed=5
grep -q "time.process_speed: 10 in the" err.txt || fail "it went on at another speed"

# Far too fast: it says so.
expect 0 "$brunt" run press.yaml --out fast --set time.process_speed=200
grep -q "warning: time.process_speed: block: kinetic energy is" err.txt || fail "no warning"
grep -q "time.process_speed" fast/summary.json || fail "no warning in the summary"
grep -q "time.process_speed: block" fast/log.txt || fail "no warning in the log"

# One is none.
expect 0 "$brunt" run press.yaml --quiet --out one --set time.process_speed=1
expect 0 "$brunt" run press.yaml --quiet --out none --set time.process_speed=null
cmp one/history.csv none/history.csv || fail "a speed of 1 changes something"
