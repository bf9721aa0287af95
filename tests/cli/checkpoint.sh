#!/usr/bin/env bash
# Checkpoints as a user meets them: signals, kill -9, a full disk, damaged files, restarts.
#   checkpoint.sh PROGRAM SOURCE SHIM [KILLS] [STRIDE]
# SHIM: the library of disk_full.c. KILLS: runs that are killed. STRIDE: the disk is full from every
# so-many-th write on; 1: from each in turn.
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
decks=$2/decks
shim=$3
kills=${4:-6}
stride=${5:-9}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
deck=$decks/bars/bars.yaml
short=(--quiet --set "time.end=12 us" --set "output.every=3 us" --set "output.history=0.5 us" --set output.state_hash=true)

says() { grep -q "$1" err.txt || { cat err.txt; fail "does not say '$1'"; }; }
# All that a run says about the physics: wall times and memory aside.
result() { sed '/"step_bounds"/,/}/d' "$1/summary.json" | grep -vE '(wall|start|loop|cpu)_seconds|peak_memory|"memory"|first_step|contact_lists|ns_|"compared"|"hit_rate"|^    "(step_bound|search|points|elements|particles|contact|ledger|output|balance)"'; }
same_run() {  # same_run A B
  cmp "$1/history.csv" "$2/history.csv" || fail "history of $2"
  cmp "$1/frames.pvd" "$2/frames.pvd" || fail "frames.pvd of $2"
  diff -r "$1/frames" "$2/frames" || fail "frames of $2"
  diff <(result "$1") <(result "$2") || fail "summary of $2"
}
steps_of() { basename "$1" .manifest | sed 's/checkpoint-0*//'; }
latest() { find "$1" -name 'checkpoint-*.manifest' | sort | tail -n 1; }

# Cadence changes no bit; two are kept; in two parts it is the same run, to the byte.
expect 0 "$brunt" run "$deck" "${short[@]}" --out whole
expect 0 "$brunt" run "$deck" "${short[@]}" --set output.checkpoint_steps=3 --out often
cmp whole/history.csv often/history.csv || fail "checkpoints change bits"
[ "$(find often -name '*.manifest' | wc -l)" = 2 ] || fail "not two checkpoints: $(ls often)"
[ "$(find often -name '*.h5' | wc -l)" = 2 ] || fail "not two parts: $(ls often)"
expect 0 "$brunt" verify often
expect 0 "$brunt" run "$deck" "${short[@]}" --until "5 us" --out split
expect 0 "$brunt" run "$deck" "${short[@]}" --resume --out split
same_run whole split
expect 0 "$brunt" run "$deck" "${short[@]}" --resume --out split
same_run whole split

# A longer end in another folder, from a folder or a file: as if it had always been that long.
expect 0 "$brunt" run "$deck" "${short[@]}" --set "time.end=7 us" --out shorter
expect 0 "$brunt" run "$deck" "${short[@]}" --restart shorter --out longer
same_run whole longer
expect 0 "$brunt" run "$deck" "${short[@]}" --restart "$(latest shorter)" --out from_file
same_run whole from_file
expect 2 "$brunt" run "$deck" "${short[@]}" --restart shorter --out longer
expect 2 "$brunt" run "$deck" "${short[@]}" --restart nowhere --out wrong
expect 2 "$brunt" run "$deck" "${short[@]}" --restart shorter --set "time.end=1 us" --out wrong
says 'time after that of the checkpoint'
expect 2 "$brunt" run "$deck" "${short[@]}" --restart shorter --set time.safety=0.5 --out wrong
says 'time.safety: .* in the checkpoint, 0.5 in the deck'
expect 2 "$brunt" run "$deck" "${short[@]}" --restart shorter --until "1 us" --out wrong
says '^--until: time.until: expects a time after'
[ ! -e wrong ] || fail "a refused restart made a folder"

# Without --out, into the deck's own folder: refused where it exists, with a word on what would be lost.
cp -r shorter bars.out && files_of() { (cd "$1" && find . -type f -exec sha256sum {} + | sort); }
files_of bars.out >before.txt
expect 2 "$brunt" run "$deck" "${short[@]}" --restart bars.out
says '^bars.out: the output folder holds the run that --restart goes on from'
expect 2 "$brunt" run "$deck" "${short[@]}" --restart "$(latest bars.out)"
says 'replaces what was written after the checkpoint'
expect 2 "$brunt" run "$deck" "${short[@]}" --restart shorter
says '^bars.out: the output folder exists, and --restart writes the whole run there'
files_of bars.out | cmp - before.txt || fail "a refused --restart changed the folder"
expect 0 "$brunt" run "$deck" "${short[@]:1}" --restart bars.out --force
says '^goes on from bars.out/checkpoint-[0-9]*.manifest, t = .*s; writes to bars.out$'
same_run whole bars.out
rm -r bars.out
# From an earlier one of the same folder, cut off before it wrote any: --resume goes on from there, not from later ones.
expect 0 "$brunt" run "$deck" "${short[@]}" --set output.checkpoint_steps=10 --out again
earlier=$(ls again/checkpoint-*.manifest | head -n 1)
[ "$(ls again/checkpoint-*.manifest | wc -l)" -ge 2 ] || fail "no two checkpoints to choose from"
expect 0 "$brunt" run "$deck" "${short[@]}" --set output.checkpoint=off --restart "$earlier" --force --out again
[ "$(ls again/checkpoint-*.manifest)" = "$earlier" ] || { ls again; fail "checkpoints of a run that was replaced are left"; }
expect 0 "$brunt" run "$deck" "${short[@]:1}" --restart shorter
says '^goes on from shorter/checkpoint-[0-9]*.manifest, t = .*s; writes to bars.out$'
same_run whole bars.out

# Signals: one goes on, the others stop; what is left goes on to the same end.
long=(--quiet --set "time.end=60 us" --set "output.every=20 us" --set "output.history=1 us" --set output.state_hash=true
  --set "time.max_step=2 ns")
wait_for() { for _ in $(seq 300); do [ -n "$(find "$1" -name "$2" 2>/dev/null)" ] && return; sleep 0.02; done; fail "no $2 in $1"; }
"$brunt" run "$deck" "${long[@]}" --out whole_long
for signal in USR1 USR2 TERM INT; do
  # In its own session: a script's background jobs ignore SIGINT.
  perl -e '$SIG{INT} = "DEFAULT"; exec @ARGV' "$brunt" run "$deck" "${long[@]}" --out "on_$signal" &
  pid=$!
  wait_for "on_$signal" 'history.csv'
  kill -$signal $pid
  status=0
  if [ $signal = USR1 ]; then
    wait $pid || status=$?
    [ $status = 0 ] || fail "status $status after SIGUSR1"
    same_run whole_long on_USR1
    [ "$(find on_USR1 -name '*.manifest' | wc -l)" = 2 ] || fail "no checkpoint on SIGUSR1"
    continue
  fi
  wait $pid || status=$?
  [ $status = 5 ] || fail "status $status after SIG$signal"
  grep -q '"status": *5' "on_$signal/summary.json" || fail "no summary after SIG$signal"
  expect 0 "$brunt" verify "on_$signal"
  expect 0 "$brunt" run "$deck" "${long[@]}" --resume --out "on_$signal"
  same_run whole_long "on_$signal"
done

# Damage: refused with file and reason, and the one before is taken; with none, it starts again.
damage() { printf 'XX' | dd of="$1" bs=1 seek=3000 conv=notrunc status=none; }
cp -r often hurt
rm hurt/summary.json
newest=$(latest hurt)
damage "${newest%.manifest}.0.h5"
expect 4 "$brunt" verify hurt
says "$(basename "${newest%.manifest}").0.h5': its bytes have changed"
expect 0 "$brunt" run "$deck" "${short[@]}" --resume --out hurt
says 'bytes have changed'
cmp whole/history.csv hurt/history.csv || fail "history after damage"
rm -rf hurt && cp -r often hurt && rm hurt/summary.json
for file in hurt/*.h5; do truncate -s 500 "$file"; done
expect 4 "$brunt" run "$deck" "${short[@]}" --restart hurt --out wrong
says 'holds no checkpoint that is good'
expect 0 "$brunt" run "$deck" "${short[@]}" --resume --out hurt
cmp whole/history.csv hurt/history.csv || fail "history after starting again"

# kill -9 at random moments: the latest good checkpoint can be read, at most one interval is lost.
every=40
endless=(--quiet --set "time.end=1 s" --set "time.max_step=1 ns" --set "output.every=0.2 us"
  --set "output.history=10 ns" --set "output.checkpoint_steps=$every")
lost=0 unread=0 without=0
for n in $(seq "$kills"); do
  rm -rf killed
  "$brunt" run "$deck" "${endless[@]}" --out killed &
  pid=$!
  [ "$n" = 1 ] || sleep "$(awk -v s="$RANDOM" 'BEGIN { print 0.05 + 0.5 * s / 32768 }')"
  [ "$n" != 1 ] || { wait_for killed 'checkpoint-*.manifest'; sleep 0.1; }
  kill -9 $pid
  wait $pid 2>/dev/null || true
  step=$(tail -n 2 killed/history.csv 2>/dev/null | head -n 1 | cut -d, -f2 || true)
  case "$step" in '' | *[!0-9]*) step=0 ;; esac
  file=$(latest killed 2>/dev/null || true)
  if [ -z "$file" ]; then
    without=$((without + 1))
    [ "$step" -le "$every" ] || lost=$((lost + 1))
    continue
  fi
  "$brunt" verify killed >/dev/null || unread=$((unread + 1))
  [ $((step - $(steps_of "$file"))) -le "$every" ] || lost=$((lost + 1))
  if [ "$n" -le 3 ]; then
    expect 0 "$brunt" run "$deck" "${endless[@]}" --resume --until "$(awk -v s="$step" \
      'BEGIN { print (s + 100) * 1e-9 " s" }')" --out killed
  fi
done
echo "$kills kills: $unread unread, $lost lost more than an interval, $without before the first"
[ "$unread" = 0 ] && [ "$lost" = 0 ] || fail "kill -9"
[ "$without" -lt "$kills" ] || fail "no checkpoint before any kill"

# A disk that is full from the N-th write on: status 4, the file named, the checkpoint as it was.
full=("${short[@]}" --set output.checkpoint_steps=10)
expect 0 "$brunt" run "$deck" "${full[@]}" --until "5 us" --out before
cp -r before counted
expect 0 env LD_PRELOAD="$shim" BRUNT_COUNT="$work/count" \
  "$brunt" run "$deck" "${full[@]}" --resume --out counted
count=$(cat count)
[ "$count" -gt 50 ] || fail "only $count writes were seen"
tried=0
for at in $(seq 1 "$stride" "$count"); do
  rm -rf disk && cp -r before disk
  expect 4 timeout 60 env LD_PRELOAD="$shim" BRUNT_FULL_AT="$at" \
    "$brunt" run "$deck" "${full[@]}" --resume --out disk
  says "'disk/.*No space left"
  expect 0 "$brunt" verify disk
  tried=$((tried + 1))
done
expect 0 "$brunt" run "$deck" "${full[@]}" --resume --out disk
cmp whole/history.csv disk/history.csv || fail "history after a full disk"
echo "$tried of $count writes to a full disk: status 4, file named, checkpoint good"

# Writes that are interrupted (EINTR) or take a part only change no byte of history, frames and checkpoints.
plain=("${short[@]}" --set output.checkpoint_steps=20)
for how in plain short; do
  unset BRUNT_SHORT
  [ $how = plain ] || export BRUNT_SHORT=1
  expect 0 env LD_PRELOAD="$shim" BRUNT_COUNT="$work/count_$how" "$brunt" run "$deck" "${plain[@]}" --out "$how"
done
unset BRUNT_SHORT
[ "$(cat count_short)" -gt $(($(cat count_plain) * 3 / 2)) ] || fail "only $(cat count_short) writes were seen"
[ -n "$(find plain -name '*.h5')" ] || fail "no checkpoint of plain writes"
diff -rq --exclude=log.txt --exclude=summary.json plain short || fail "short writes change bytes"
diff <(result plain) <(result short) || fail "summary of short writes"
expect 0 "$brunt" verify short
echo "$(cat count_short) short writes for $(cat count_plain)"
echo "all good"
