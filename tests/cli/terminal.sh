#!/usr/bin/env bash
# What a user sees on a terminal: the bar, with time, step, dt and whose it is, drift, time left;
# and Ctrl-C: status 5, a message, files that are whole.
#   terminal.sh PROGRAM SOURCE
set -euo pipefail
brunt=$1
deck=$2/decks/bars/bars.yaml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
fail() { tr '\r' '\n' <screen.txt | tail -n 5 >&2; echo "FAILED: $*" >&2; exit 1; }
command -v script >/dev/null || { echo "no script(1): not tested"; exit 0; }

# The shell on the terminal sends the signal that Ctrl-C sends, to brunt alone.
cat >session.sh <<END
stty cols 160 2>/dev/null
"$brunt" run "$deck" --set "time.end=1 s" --out stopped &
pid=\$!
for i in \$(seq 300); do
  [ "\$(wc -l <stopped/history.csv 2>/dev/null || echo 0)" -ge 1 ] && break
  sleep 0.1
done
sleep 2
kill -INT \$pid
wait \$pid
echo "status \$?"
END
script -qec "bash -m session.sh" screen.txt >/dev/null </dev/null || true
tr '\r' '\n' <screen.txt >lines.txt
grep -Eq '^\[[#.]{20}\] +[0-9.]+ %  [0-9.]+ [mun]?s of 1 s  step [0-9]+  dt [0-9.]+ ns \((striker|target): [a-z _]+\)  drift [0-9e.+-]+' \
  lines.txt || fail "no bar"
grep -q 'brunt: stopped by a signal at t = ' lines.txt || fail "no message"
grep -q '^status 5' lines.txt || fail "status"
[ -s stopped/summary.json ] || fail "no summary"
grep -q '"status": *5' stopped/summary.json || fail "status in the summary"
tail -n 1 stopped/frames.pvd | grep -q '</VTKFile>' || [ ! -e stopped/frames.pvd ] || fail "frames.pvd is cut"
columns=$(head -n 1 stopped/history.csv | tr -cd , | wc -c)
[ "$(tail -n 1 stopped/history.csv | tr -cd , | wc -c)" = "$columns" ] || fail "the last row is cut"

# A narrow terminal: no line is longer than it, or its rest would stay on the screen.
cat >narrow.sh <<END
stty cols 60 2>/dev/null
"$brunt" run "$deck" --set "time.end=200 us" --out narrow
END
script -qec "bash narrow.sh" screen.txt >/dev/null </dev/null || true
tr '\r' '\n' <screen.txt | sed 's/\x1b\[K//g' | grep ' %  .* of 200 us' >bars.txt || true
[ "$(awk '{ if (length($0) > 59) n++ } END { print n + 0 }' bars.txt)" = 0 ] || fail "too wide"
echo "all good"
