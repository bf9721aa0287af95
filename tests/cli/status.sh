#!/usr/bin/env bash
# How far runs are, or how they ended, by their folders alone.
#   status.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'kill %1 2>/dev/null || true; rm -rf "$work"' EXIT
cd "$work"
limit=60
deck=$2/decks/bars/bars.yaml
says() { "$brunt" status "$1" >said.txt || true; grep -qE -- "^$1 +$2" said.txt || { cat said.txt; fail "does not say '$2'"; }; }

expect 0 "$brunt" run "$deck" --quiet --set "time.end=20 us" --out done
says done "done +100.0 %  20 us of 20 us  step [0-9]+  drift [-0-9.e]+  last row [0-9]+ s ago"
expect 0 "$brunt" run "$deck" --quiet --set "time.end=20 us" --until "10 us" --out until
says until "(done|stopped) .* of 20 us .*time.until"
expect 0 "$brunt" run "$deck" --quiet --set "stop.when== time > 5e-6" --out when
says when "done .*stop.when holds"

# One that is under way, and is killed then.
"$brunt" run "$deck" --quiet --set "time.end=10 s" --set output.checkpoint_steps=1000 --out long &
for _ in $(seq 100); do
  [ -e long/checkpoint-000000001000.manifest ] && break
  sleep 0.1
done
says long "running +0.0 %  [0-9.]+ .s of 10 s"
kill -KILL %1
wait %1 2>/dev/null || true
says long "cut off .*latest checkpoint-0000000.*: brunt run DECK --resume goes on"
cp -r long torn && printf 'time,st' >torn/history.csv
says torn "cut off +no row in history.csv yet"
echo '{' >done/summary.json
says done "broken"
mkdir empty
says empty "holds no run"
expect 2 "$brunt" status empty missing when
[ "$("$brunt" status empty missing when | wc -l)" = 3 ] || fail "not a line each"

# Asking keeps no run out.
(while :; do "$brunt" status busy >/dev/null 2>&1 || true; done) &
for _ in 1 2 3 4 5; do
  expect 0 "$brunt" run "$deck" --quiet --force --set "time.end=1 us" --out busy
done
kill %2 2>/dev/null || true
