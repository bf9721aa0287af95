#!/usr/bin/env bash
# Measures as a user reads them: when they are taken, and that what has no value is told.
#   measures.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
limit=60

# A window between two rows: no row answers, and what is computed from it has no value either. Said once,
# on the screen, in the log and in the summary, and both measures are there as null, on any ranks.
cat >window.yaml <<'YAML'
geometry: 3d
time: {end: 6 us}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  bar: {material: steel, shape: {box: {min: [0, 0, 0], max: [8 mm, 2 mm, 2 mm]}}, size: 1 mm, velocity: [10 m/s, 0, 0]}
measures:
  none: {history: {column: body.bar.velocity.x, reduce: max, from: 2.9 us, to: 3 us}}
  twice: {expression: "= 2 * $none"}
  speed: {speed: {body: bar}}
output: {history: 3.5 us}
YAML
for ranks in 1 2; do
  expect 0 "$brunt" run window.yaml --out "window-$ranks" --ranks $ranks --oversubscribe
  [ "$(grep -c "^warning: measure: 'none' has no value: no history row lies between" err.txt)" = 1 ] ||
    { cat err.txt; fail "$ranks ranks: what has no value is not told once"; }
  grep -qE "^ +none +nan" err.txt || { cat err.txt; fail "$ranks ranks: not in the closing words"; }
  [ "$(grep -c "measure: 'none' has no value" "window-$ranks/log.txt")" = 1 ] || fail "not in the log once"
done
python3 - <<'PYTHON'
import json
for ranks in (1, 2):
    summary = json.load(open(f"window-{ranks}/summary.json"))
    values = {name: measure["value"] for name, measure in summary["measures"].items()}
    assert values["none"] is None and values["twice"] is None, values
    assert abs(values["speed"] - 10) < 1e-9, values
    assert [warning["id"] for warning in summary["warnings"]] == ["measure"], summary["warnings"]
PYTHON
for command in table report; do expect 0 "$brunt" $command window-1; done

# When: at 0 before the first step, else at the first step at or after it, which `time` tells. A rod that
# conducts alone takes steps of 0.6 s: its end has 300 K + 100 K cos 0 at time 0 and less after any step.
# Of the same bits on two ranks, and where the run goes on before, between and after the times.
cat >rod.yaml <<'YAML'
geometry: 3d
time: {end: 6 s}
materials: {steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, thermal: {cp: 450 J/kg/K, k: 50 W/m/K}}}
bodies:
  rod:
    material: steel
    shape: {box: {min: [0, 0, 0], max: [0.1 m, 10 mm, 10 mm]}}
    cells: [10, 2, 2]
    temperature: "= 300 + 100*cos(pi*x/0.1)"
boundaries: {held: {body: rod, where: all, fix: [x, y, z]}}
measures:
  first: {max: {body: rod, field: temperature}, at: 0}
  soon: {max: {body: rod, field: temperature}, at: 1 s}
  later: {max: {body: rod, field: temperature}, at: 4 s}
  last: {max: {body: rod, field: temperature}}
  fell: {expression: "= $first - $soon", at: 1 s}
YAML
expect 0 "$brunt" run rod.yaml --out rod --quiet
expect 0 "$brunt" run rod.yaml --out rod-2 --quiet --ranks 2 --oversubscribe
others=(rod-2)
for until in 0.1 2 5; do
  expect 0 "$brunt" run rod.yaml --out "until-$until" --quiet --until "$until s"
  expect 0 "$brunt" run rod.yaml --out "rest-$until" --quiet --restart "until-$until" --ranks 2 --oversubscribe
  others+=("rest-$until")
done
python3 - "${others[@]}" <<'PYTHON'
import csv, json, sys
def measures(run):
    return json.load(open(run + "/summary.json"))["measures"]
rod = measures("rod")
value = {name: measure["value"] for name, measure in rod.items()}
time = {name: measure["time"] for name, measure in rod.items()}
steps = [float(row["dt"]) for row in csv.DictReader(open("rod/history.csv"))]
assert time["first"] == 0 and abs(value["first"] - 400) < 1e-12, (time, value)
for name, at in (("soon", 1), ("later", 4)):
    assert at <= time[name] < at + max(steps), (name, time, max(steps))
assert time["last"] == 6, time
assert value["first"] > value["soon"] > value["later"] > value["last"], value
assert value["fell"] == value["first"] - value["soon"] and time["fell"] == time["soon"], (value, time)
for other in sys.argv[1:]:
    assert measures(other) == rod, (other, measures(other), rod)
PYTHON
expect 0 "$brunt" table rod --show first,soon.time
grep -q "soon.time" out.txt || { cat out.txt; fail "table --show soon.time"; }

# Times are real where the process is stepped faster: the bar moves at 10 m/s of real time.
cat >fast.yaml <<'YAML'
geometry: 3d
time: {end: 0.2 ms, process_speed: 10}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  bar: {material: steel, shape: {box: {min: [0, 0, 0], max: [8 mm, 2 mm, 2 mm]}}, size: 1 mm, velocity: [10 m/s, 0, 0]}
measures:
  start: {mean: {body: bar, field: displacement.x}, at: 0}
  way: {mean: {body: bar, field: displacement.x}, at: 0.1 ms}
  all: {mean: {body: bar, field: displacement.x}}
YAML
expect 0 "$brunt" run fast.yaml --out fast --quiet
python3 - <<'PYTHON'
import json
measures = json.load(open("fast/summary.json"))["measures"]
assert measures["start"]["value"] == 0 and measures["start"]["time"] == 0, measures
assert 1e-4 <= measures["way"]["time"] < 1.1e-4, measures
assert abs(measures["all"]["time"] - 2e-4) < 1e-18, measures
for name in ("way", "all"):
    assert abs(measures[name]["value"] - 10 * measures[name]["time"]) < 1e-12, measures
PYTHON
