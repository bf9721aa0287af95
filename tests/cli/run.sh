#!/usr/bin/env bash
# The program as a user calls it: exit statuses, folders, what is written, the same bytes twice.
#   run.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
decks=$2/decks
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
deck=$decks/bars/bars.yaml
short=(--set "time.end=5 us" --set "output.every=2 us" --set "output.history=0.5 us" --set output.state_hash=true --quiet)

expect 0 "$brunt" run "$deck" "${short[@]}"
for file in deck.resolved.yaml log.txt history.csv summary.json; do
  [ -s "bars.out/$file" ] || fail "bars.out/$file is missing"
done
head -n 1 bars.out/history.csv | grep -q '^time,step,dt,dt_body,energy.kinetic,' || fail "columns"

# An existing folder is not touched; --force replaces, --resume skips what is done.
cp bars.out/summary.json before.json
expect 2 "$brunt" run "$deck" "${short[@]}"
cmp -s before.json bars.out/summary.json || fail "a refused run touched its folder"
expect 0 "$brunt" run "$deck" "${short[@]}" --resume
cmp -s before.json bars.out/summary.json || fail "--resume ran again"
touch bars.out/mine.txt
expect 0 "$brunt" run "$deck" "${short[@]}" --force
[ -e bars.out/mine.txt ] || fail "--force took a file that is not brunt's"

# The same bytes on one and two threads, and from the resolved deck.
expect 0 "$brunt" run "$deck" "${short[@]}" --threads 1 --out one
expect 0 "$brunt" run "$deck" "${short[@]}" --threads 2 --out two
cmp one/history.csv two/history.csv || fail "history depends on threads"
expect 0 "$brunt" run one/deck.resolved.yaml --quiet --out again
cmp one/history.csv again/history.csv || fail "the resolved deck is not the deck"

# Wrong decks and calls: status 2, a place, no folder.
expect 2 "$brunt" run "$deck" --set "bodies.striker.velocty=[1 m/s, 0, 0]" --out wrong
grep -q "did you mean 'velocity'" err.txt || { cat err.txt; fail "no suggestion"; }
[ ! -e wrong ] || fail "a wrong deck made a folder"
expect 2 "$brunt" run nowhere.yaml
expect 2 "$brunt" walk
expect 2 "$brunt" run

# Physics that breaks: status 3, a summary, a last frame.
expect 3 "$brunt" run "$deck" "${short[@]}" --set "time.min_step=1 s" --out broken
grep -q '"status": *3' broken/summary.json || fail "no status in the summary"
grep -q 'min_step' err.txt || fail "no cause"

# Contacts that do not hold: said once for each pair, on the screen and in the log; counted at the end.
expect 0 "$brunt" run "$2/tests/parallel/decks/lost.yaml" --quiet --out lost
for pair in weak flying-standing; do
  # That faces are deep, and hold yet, may be said before.
  [ "$(grep "^warning: contact: $pair: .* at t = \|^warning: contact: $pair: .*since t = " err.txt | grep -vc "hold yet")" = 1 ] ||
    { cat err.txt; fail "$pair is not reported once"; }
  grep -q "warning.* contact: $pair: .*; in all [0-9]* contacts let go, [0-9]* came back" lost/log.txt ||
    fail "no count of $pair in the log"
  grep -q "\"text\": \"$pair: .*; in all [0-9]* contacts let go, [0-9]* came back" lost/summary.json ||
    fail "no count of $pair in the summary"
done
grep -q '"text": "weak: .*; in all 8 contacts let go, 0 came back' lost/summary.json ||
  { grep text lost/summary.json; fail "eight shots are not eight contacts"; }

# --json prints the summary; check, plan, table, explain, schema answer.
expect 0 "$brunt" run "$deck" "${short[@]}" --json --out json
grep -q '"measures"' out.txt || fail "--json"
expect 0 "$brunt" check "$deck"
expect 0 "$brunt" plan "$deck"
grep -q 'elements' out.txt || fail "plan"
expect 0 "$brunt" table one two broken nowhere
[ "$(wc -l <out.txt)" -ge 5 ] || { cat out.txt; fail "table"; }
expect 0 "$brunt" explain materials.strength.johnson-cook.C
expect 0 "$brunt" schema
grep -q '"taylor_quinney"' out.txt || fail "schema"

# What a script leaves where a variable has no value, and options that do nothing, are not passed over in silence.
said() { grep -q -- "$1" err.txt out.txt || { cat err.txt out.txt; fail "does not say '$1'"; }; }
for option in --out --restart; do
  expect 2 "$brunt" run "$deck" "${short[@]}" $option ''
  said "$option: is empty"
  expect 2 "$brunt" run "$deck" $option= "${short[@]}"
  said "$option: has no value but the option '--"
done
[ ! -e ./--set ] || fail "a run into an option"
expect 2 "$brunt" run "$deck" "${short[@]}" --refine-key parameters.cells --out wrong
said '--refine'
expect 0 "$brunt" run "$deck" "${short[@]}" --until 5 --out late
said '^warning: --until: time.until: 5 s is after the end of the run, .* (time.end): it stops nothing'
grep -q 'it stops nothing' late/summary.json || fail "no warning in the summary"
expect 0 "$brunt" run "$deck" "${short[@]}" --set time.until=5 --out late --force
said '^warning: --set #[0-9]*: time.until: 5 s is after the end of the run, .* (time.end): it stops nothing'
expect 2 "$brunt" run "$deck" "${short[@]}" --out wrong --set 'bodies.strikr.velocity=[0, 0, 0]'
said '^--set #[0-9]*: bodies.strikr.shape: is missing: .*; this is bodies.strikr as --set alone gives it: is its name right'
echo 1 >file
for how in --quiet --force --resume; do
  expect 2 "$brunt" run "$deck" "${short[@]}" $how --out file
  said '^file: is a file, not an output folder'
done

# Points that erosion has left on the axis of an axisymmetric scene, where they stand for no area,
# touch: frames are written.
cat >axis.yaml <<'END'
title: Elements at the axis erode to points that touch what comes
geometry: axisymmetric
time: {end: 4 us}
materials:
  glass:
    density: 2500 kg/m^3
    elastic: {E: 70 GPa, nu: 0.22}
    damage: {principal_stress: 20 MPa, energy: 20 J/m^2}
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  plate:
    material: glass
    shape: {box: {min: [0, 0], max: [20 mm, 10 mm]}}
    size: 1 mm
    element: {integration: full}
    erode: {when: [damage, inverted], to: points}
  bullet: {material: steel, shape: {box: {min: [0, 10 mm], max: [4 mm, 13 mm]}}, size: 1 mm, velocity: [0, -40 m/s]}
output: {every: 0.1 us}
END
expect 0 "$brunt" run axis.yaml --out axis

# A signal stops at the end of a step: status 5 and a summary.
"$brunt" run "$deck" --quiet --set "time.end=1 s" --out stopped &
pid=$!
for _ in $(seq 100); do [ -s stopped/history.csv ] && break; sleep 0.1; done
sleep 0.3
kill -TERM $pid
status=0
wait $pid || status=$?
[ $status = 5 ] || fail "status $status after SIGTERM"
[ -s stopped/summary.json ] || fail "no summary after SIGTERM"
echo "all good"
