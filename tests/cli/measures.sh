#!/usr/bin/env bash
# Measures as a user reads them: what has no value is told.
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
