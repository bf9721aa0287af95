#!/usr/bin/env bash
# No status but 0, 2, 3, 4 and 5, whatever a call meets: names, links, folders, disks, signals.
#   statuses.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
limit=60
deck=$2/decks/bars/bars.yaml
short=(--quiet --set "time.end=5 us" --set "output.every=2 us" --set "output.history=0.5 us" --set output.state_hash=true)
says() { grep -q -- "$1" err.txt || { cat err.txt; fail "does not say '$1'"; }; }

# A run whose first row is none: so fast that its energy is no number.
expect 3 "$brunt" run "$deck" "${short[@]}" --out fast --set 'bodies.striker.velocity=[1e160 m/s, 0, 0]'
says 'is no finite number'

# ... and one whose first frame is none, in single precision: no folder of no frames.
expect 3 "$brunt" run "$deck" "${short[@]}" --out far --set 'bodies.striker.velocity=["= 1e42 * x", 0, 0]'
says 'a frame: velocity'
[ -e far/frames.pvd ] && [ ! -e far/frames ] || fail "frames/ of no frames"

# A limit on the size of files is like a full disk: what cannot be written is named, nothing is left of it.
for kilobytes in 1 3 6 12; do
  status=0
  (ulimit -f "$kilobytes" && exec "$brunt" run "$deck" "${short[@]}" --force --out small) >out.txt 2>err.txt || status=$?
  [ $status = 4 ] || { cat err.txt; fail "status $status with files of $kilobytes kB"; }
  says 'File too large'
  [ -z "$(find small -name '*.tmp-*')" ] || fail "a temporary is left of files of $kilobytes kB"
done

# Hardly any memory. Where libraries do not fit the loader ends the program, or they do themselves;
# once it is there, it says what is wrong.
there=false
for kilobytes in $(seq 40000 4000 180000); do
  status=0
  (ulimit -v "$kilobytes" && exec "$brunt" --version) >out.txt 2>err.txt || status=$?
  case $status in
    0 | 4) there=true ;;
    *) [ $there = false ] || fail "--version in $kilobytes kB: status $status" ;;
  esac
done
[ $there = true ] || fail "--version needs more than 180 MB"

# Paths that cannot be: too long, in a circle, of another kind, where nobody may look.
long=$(printf 'n%.0s' $(seq 300))
ln -s loop loop
mkfifo pipe
for path in "$long" "$long.yaml" "$long/x.yaml" loop loop/x.yaml pipe /dev/zero . /dev/full; do
  expect 2 "$brunt" check "$path"
  expect 2 "$brunt" run "$path" --quiet
  expect 2 "$brunt" render "$path"
  expect 2 "$brunt" verify "$path"
  "$brunt" table "$path" >out.txt 2>err.txt || [ $? -le 4 ] || fail "table $path"
done
expect 2 "$brunt" check pipe
says 'pipe'
expect 2 "$brunt" check <(cat "$deck")
for out in "$long" loop loop/x; do
  expect 4 "$brunt" run "$deck" "${short[@]}" --out "$out"
  says "${out:0:20}"
  expect 4 "$brunt" run "$deck" "${short[@]}" --resume --out "$out"
done
expect 2 "$brunt" run "$deck" "${short[@]}" --force --out pipe
for include in "$long" loop pipe /dev/zero .; do
  printf 'include: [%s]\n' "$include" >with.yaml
  expect 2 "$brunt" check with.yaml
  says "with.yaml:1:"
done
mkdir closed && cp "$deck" closed/deck.yaml && chmod 0 closed
if [ "$(id -u)" = 0 ] && command -v setpriv >/dev/null && chmod 755 . &&
  setpriv --reuid=65534 --clear-groups test -x "$brunt" 2>/dev/null; then
  nobody=(setpriv --reuid=65534 --clear-groups)
elif [ "$(id -u)" != 0 ]; then
  nobody=()
else
  nobody=(false)
fi
if [ "${nobody[*]}" != false ]; then
  expect 2 "${nobody[@]}" "$brunt" check closed/deck.yaml
  expect 4 "${nobody[@]}" "$brunt" run "$deck" "${short[@]}" --out closed/out
  expect 4 "${nobody[@]}" "$brunt" run "$deck" "${short[@]}" --force --out closed/out
  expect 2 "${nobody[@]}" "$brunt" render closed/out
  expect 2 "${nobody[@]}" "$brunt" verify closed/out
fi
chmod 755 closed
mkdir gone
(cd gone && rmdir "$work/gone" && status=0 && "$brunt" run "$deck" "${short[@]}" 2>"$work/err.txt" ||
  status=$? && [ $status = 4 ]) || fail "a working directory that is gone"
says 'bars.out'

# A full standard output, and one that nobody reads to its end.
status=0
"$brunt" run "$deck" "${short[@]}" --json --out json >/dev/full 2>err.txt || status=$?
[ $status = 4 ] || fail "status $status where --json meets a full disk"
says 'standard output'
[ -s json/summary.json ] || fail "no summary beside a full standard output"
status=0
"$brunt" schema >/dev/full 2>err.txt || status=$?
[ $status = 4 ] || fail "status $status of schema to a full disk"
{ status=0; "$brunt" schema 2>/dev/null || status=$?; echo $status >status.txt; } | true
case $(cat status.txt) in 0 | 4) ;; *) fail "schema into a pipe that is closed: $(cat status.txt)" ;; esac

# Signals: 5 and a checkpoint, on one rank and two. A script's background jobs ignore SIGINT.
endless=(--quiet --set "time.end=1 s" --set "time.max_step=1 ns")
start() { perl -e '$SIG{$_} = "DEFAULT" for qw(INT HUP); setpgrp; exec @ARGV' "$brunt" run "$deck" "${endless[@]}" "$@" 2>log.txt & pid=$!; }
runs() { for _ in $(seq 400); do [ "$(wc -l 2>/dev/null <"$1/history.csv" || echo 0)" -gt 1 ] && return; sleep 0.05; done; cat log.txt; fail "$1 does not run"; }
ends() {  # ends NAME SIGNAL
  status=0
  wait $pid || status=$?
  [ $status = 5 ] || { cat log.txt; fail "status $status after SIG$2 of $1"; }
  expect 0 "$brunt" verify "$1"
  grep -q '"status": *5' "$1/summary.json" || fail "no summary of $1"
}
start --out one_HUP && runs one_HUP && kill -HUP $pid && ends one_HUP HUP
if command -v mpirun >/dev/null; then
  for signal in TERM INT HUP USR2; do
    start --ranks 2 --oversubscribe --out "two_$signal"
    runs "two_$signal"
    # As a terminal does, to the whole group.
    if [ $signal = INT ]; then kill -INT -- -$pid; else kill -$signal $pid; fi
    ends "two_$signal" $signal
  done
  expect 0 "$brunt" run "$deck" "${short[@]}" --ranks 2 --oversubscribe --out two
  expect 2 "$brunt" run "$deck" "${short[@]}" --ranks 2 --oversubscribe --out two
  expect 3 "$brunt" run "$deck" "${short[@]}" --ranks 2 --oversubscribe --out broken \
    --set "time.min_step=1 s"
fi
echo "all good"
