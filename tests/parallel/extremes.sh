#!/usr/bin/env bash
# Ranks at the extremes: more of them than elements, a particle 1e9 m away, started by mpirun itself,
# and errors that only one rank meets: all end, in time, with one message and the right status.
#   extremes.sh PROGRAM SOURCE SHIM   SHIM: the library of tests/cli/disk_full.c
set -euo pipefail
brunt=$1 decks=$2/decks shim=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
failed=0
fail() { echo "FAILED: $*"; failed=1; }
limit=60  # [s] after which a run hangs

run() {  # run OUT DECK RANKS OPTIONS...
  local out=$1 deck=$2 n=$3
  shift 3
  timeout $limit "$brunt" run "$deck" --quiet --out "$out" --ranks "$n" --oversubscribe "$@" 2>"$out.err" ||
    { cat "$out.err"; fail "$out: status $?"; }
}
same() { cmp -s "$1/history.csv" "$2/history.csv" || fail "$2 is not $1"; }
# One status on all ways out, and one message: a line that begins with brunt:, or a deck's place.
ends() {  # ends STATUS MESSAGE COMMAND...
  local status=0 wanted=$1 message=$2
  shift 2
  timeout $limit "$@" >out.txt 2>err.txt || status=$?
  local said
  said=$(grep -cE "$message" err.txt || true)
  [ "$status" = "$wanted" ] || { cat err.txt; fail "status $status instead of $wanted: $*"; }
  [ "$1" != "$brunt" ] || ! grep -q MPI_ABORT err.txt || fail "Open MPI talks too: $*"
  [ "$said" = 1 ] || { cat err.txt; fail "said $said times instead of once: $message"; }
}

ends 2 "^--set" "$brunt" run "$decks/bars/bars.yaml" --out wrong --ranks 2 --oversubscribe --set time.ende=3
ends 2 "^brunt: --ranks 999" "$brunt" run "$decks/bars/bars.yaml" --out many --ranks 999

# Two elements on three ranks, which meet: one rank is empty, or nearly.
cat >two.yaml <<'Y'
title: Two elements
geometry: 3d
time: {end: 20 us}
materials:
  steel: {density: 7800 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  a: {method: fe, material: steel, shape: {box: {min: [0, 0, 0], max: [1 mm, 1 mm, 1 mm]}}, size: 1 mm, velocity: [10 m/s, 0, 0]}
  b: {method: fe, material: steel, shape: {box: {min: [1.05 mm, 0, 0], max: [2.05 mm, 1 mm, 1 mm]}}, size: 1 mm}
output: {every: 5 us, history: 0.1 us, state_hash: true}
Y
for n in 1 2 3 20; do run two-$n two.yaml $n; done
same two-1 two-2
same two-1 two-3
same two-1 two-20  # 16 points: ranks without any
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "contact.a-b.planes") c = i }
  $c > 0 { met = 1 } END { exit !met }' two-1/history.csv || fail "the two elements do not meet"

# A particle that is 1e9 m away from the others at the end, in memory that grows with nothing.
cat >stray.yaml <<'Y'
title: A block of particles on a plate, and a particle that flies away
geometry: 3d
time: {end: 4 us, max_step: 0.1 us}
materials:
  copper: {density: 8960 kg/m^3, elastic: {E: 124 GPa, nu: 0.34}}
bodies:
  block: {method: sph, material: copper, shape: {box: {min: [0, 0, 0], max: [6 mm, 6 mm, 6 mm]}}, size: 1 mm, velocity: [0, 0, -20 m/s]}
  stray: {method: sph, material: copper, shape: {box: {min: [0, 0, 50 mm], max: [1 mm, 1 mm, 51 mm]}}, size: 1 mm, velocity: [2.5e14 m/s, 0, 0]}
  plate: {method: fe, material: copper, shape: {box: {min: [-2 mm, -2 mm, -2 mm], max: [8 mm, 8 mm, 0]}}, size: 2 mm}
contact: {pairs: {apart: {between: [stray, any], ignore: true}}}
output: {every: 2 us, history: 0.1 us, state_hash: true}
Y
for n in 1 2 3; do (ulimit -v 4000000; run stray-$n stray.yaml $n); done
same stray-1 stray-2
same stray-1 stray-3
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "body.stray.position.x") c = i }
  END { exit !($c > 0.9e9) }' stray-1/history.csv || fail "the stray particle is not far away"

# mpirun by hand is what --ranks does.
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
mpi=(mpirun --oversubscribe --mca mpi_yield_when_idle 1)
timeout $limit "${mpi[@]}" -n 2 "$brunt" run two.yaml --quiet --out by-hand 2>err.txt || { cat err.txt; fail "mpirun by hand"; }
same two-2 by-hand
grep -q '"ranks": 2' by-hand/summary.json || fail "mpirun by hand was not two ranks"

# An element inside out, on the rank that owns that end of the bar.
cat >crush.yaml <<'Y'
title: A bar whose last element is turned inside out within a step
geometry: 3d
time: {end: 100 us, safety: 0.5}
materials:
  steel: {density: 7800 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  bar: {method: fe, material: steel, shape: {box: {min: [0, 0, 0], max: [20 mm, 1 mm, 1 mm]}}, size: 1 mm}
boundaries:
  foot: {body: bar, where: {side: min-x}, fix: [x]}
  end: {body: bar, where: {side: max-x}, velocity: [-20000 m/s, 0, 0]}
output: {every: 5 us, history: 0.1 us, state_hash: true}
Y
ends 3 '^brunt: ' "$brunt" run crush.yaml --quiet --out crush-1
cp err.txt alone.txt
for n in 2 3; do
  ends 3 '^brunt: ' "$brunt" run crush.yaml --quiet --out crush-$n --ranks $n --oversubscribe
  diff <(grep '^brunt' alone.txt) <(grep '^brunt' err.txt) || fail "$n ranks say something else"
done

# A corner goes through the Gauss point next to it and comes back, between two steps at which the run
# looks at its values (every 100th). It goes along the diagonal of a cube of size 1:
# x = X + d (1, 1, 1) (1 - X)(1 - Y)(1 - Z), det F = 1 - d ((1 - Y)(1 - Z) + ..). The mean of det F over
# the eighth at that corner is 1 - 3 d (3/4)^2, below 0 beyond d = 16/27; that of the whole is 1 - 3 d/4.
# At 1600 m/s from 1 us (step 100) on, d = 0.592 at step 137 and 0.608 at step 138, at most 0.8, and the
# run ends well; at 1800 m/s what it leaves behind is inside out at step 200, and the run breaks there.
# Repartitions and checkpoints look in between: they wait, and say nothing.
cat >corner.yaml <<'Y'
title: A corner goes through its element and comes back
geometry: 3d
time: {end: 2 us, max_step: 10 ns, max_created: 1}
parameters: {speed: 1600 m/s}
materials:
  steel: {density: 7800 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  bar:
    material: steel
    shape: {box: {min: [0, 0, 0], max: [4 mm, 1 mm, 1 mm]}}
    size: 1 mm
    element: {integration: q1p0}
boundaries:
  far: {body: bar, where: {side: max-x}, fix: [x, y, z]}
  corner:
    body: bar
    where: {box: {min: [-0.1 mm, -0.1 mm, -0.1 mm], max: [0.1 mm, 0.1 mm, 0.1 mm]}}
    velocity: [WAY, WAY, WAY]
output: {every: 1 s, history: 10 ns, state_hash: true}
Y
sed -i 's|WAY|"= $speed*tanh((1.5e-6 - t)/1e-8)*(t > 1e-6)"|g' corner.yaml
often=(--ranks 2 --oversubscribe --set ranks.balance=1 --set ranks.balance_steps=7)
run corner-1 corner.yaml 1
run corner-2 corner.yaml 2 "${often[@]:2}"
run corner-saved corner.yaml 1 --set output.checkpoint_steps=1
same corner-1 corner-2
same corner-1 corner-saved
faster=(run corner.yaml --quiet --set 'parameters.speed=1800 m/s')
ends 3 '^brunt: at t = 2e-06 s, body bar, element 0,' "$brunt" "${faster[@]}" --out faster-1
ends 3 '^brunt: at t = 2e-06 s, body bar, element 0,' "$brunt" "${faster[@]}" --out faster-2 "${often[@]}"
ends 3 '^brunt: at t = 2e-06 s, body bar, element 0,' "$brunt" "${faster[@]}" --out faster-saved \
  --set output.checkpoint_steps=1
same faster-1 faster-2
same faster-1 faster-saved
# None is written of what is inside out: the last is of step 137.
ends 3 '^brunt: at t = 1.45e-06 s, body bar, element 0,' "$brunt" run corner.yaml --quiet --out inside \
  --set output.checkpoint_steps=1 --until '1.446 us'
last=$(find inside -name 'checkpoint-*.manifest' | sort | tail -n 1)
[[ $last =~ checkpoint-0*137.manifest ]] || fail "the last checkpoint is '$last'"

# Elements of two bodies are inside out at step 40, d = 0.64, the one with the larger id on rank 0 of two:
# the first of all that broke is said, not that of the first rank.
cat >four.yaml <<'Y'
title: Corners of two of four bars go through their elements in the same steps
geometry: 3d
time: {end: 2 us, max_step: 10 ns, max_created: 1}
materials:
  steel: {density: 7800 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  a: {material: steel, shape: {box: {min: [0, 0, 0], max: [4 mm, 1 mm, 1 mm]}}, size: 1 mm, element: {integration: q1p0}}
  b: {material: steel, shape: {box: {min: [30 mm, 0, 0], max: [34 mm, 1 mm, 1 mm]}}, size: 1 mm, element: {integration: q1p0}}
  c: {material: steel, shape: {box: {min: [0, 20 mm, 0], max: [4 mm, 21 mm, 1 mm]}}, size: 1 mm, element: {integration: q1p0}}
boundaries:
  b-far: {body: b, where: {side: max-x}, fix: [x, y, z]}
  c-far: {body: c, where: {side: max-x}, fix: [x, y, z]}
  b: {body: b, where: {box: {min: [29.9 mm, -0.1 mm, -0.1 mm], max: [30.1 mm, 0.1 mm, 0.1 mm]}}, velocity: [1600 m/s, 1600 m/s, 1600 m/s]}
  c: {body: c, where: {box: {min: [-0.1 mm, 19.9 mm, -0.1 mm], max: [0.1 mm, 20.1 mm, 0.1 mm]}}, velocity: [1600 m/s, 1600 m/s, 1600 m/s]}
output: {every: 1 s, history: 10 ns, state_hash: true}
Y
for n in 1 2 3; do
  ends 3 '^brunt: at t = 4e-07 s, body b, element 4,' "$brunt" run four.yaml --quiet --out four-$n --ranks $n --oversubscribe
done

# The same of contacts whose friction is no coefficient: 0.2 - 30/100 is below 0 under all of two blocks
# in the step in which they touch, and the pairs of faces are evaluated by several ranks.
cat >rub.yaml <<'Y'
title: Two blocks slide on two bars, and friction falls below 0 in the same step
geometry: 3d
time: {end: 10 us}
materials:
  steel: {density: 7800 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  a: {material: steel, shape: {box: {min: [0, 0, 0], max: [4 mm, 1 mm, 1 mm]}}, size: 1 mm}
  b: {material: steel, shape: {box: {min: [12 mm, 0, 0], max: [16 mm, 1 mm, 1 mm]}}, size: 1 mm}
  c: {material: steel, shape: {box: {min: [0, 20 mm, 0], max: [4 mm, 21 mm, 1 mm]}}, size: 1 mm}
  b-top: {material: steel, shape: {box: {min: [13 mm, 0, 1.001 mm], max: [14 mm, 1 mm, 2.001 mm]}}, size: 1 mm, velocity: [30 m/s, 0, -10 m/s]}
  c-top: {material: steel, shape: {box: {min: [1 mm, 20 mm, 1.001 mm], max: [2 mm, 21 mm, 2.001 mm]}}, size: 1 mm, velocity: [30 m/s, 0, -10 m/s]}
contact: {default: {friction: "= 0.2 - v/100"}}
output: {every: 1 s, history: 10 ns, state_hash: true}
Y
for n in 1 2 4; do
  ends 3 '^brunt: .* contact b-b-top at [(]0.0135016,' "$brunt" run rub.yaml --quiet --out rub-$n --ranks $n --oversubscribe
done

# An output folder that cannot be: only the root tries.
touch taken
ends 4 '^brunt: ' "$brunt" run two.yaml --quiet --out taken/out --ranks 2 --oversubscribe

# Rank 1 alone finds no checkpoint, or its disk full.
run first two.yaml 2 --until '5 us'
cat >one-is-odd.sh <<S
#!/usr/bin/env bash
if [ "\$OMPI_COMM_WORLD_RANK" = 1 ]; then
  case \$1 in
    restart) exec "$brunt" run two.yaml --quiet --out odd --restart nowhere ;;
    disk) export LD_PRELOAD="$shim" BRUNT_FULL_NAME=checkpoint BRUNT_FULL_AT=1 ;;
  esac
fi
case \$1 in
  restart) exec "$brunt" run two.yaml --quiet --out odd --restart first ;;
  disk) exec "$brunt" run two.yaml --quiet --out full --set output.checkpoint_steps=5 ;;
esac
S
chmod +x one-is-odd.sh
ends 2 'nowhere' "${mpi[@]}" -n 2 ./one-is-odd.sh restart
ends 4 '^brunt: .*checkpoint' "${mpi[@]}" -n 2 ./one-is-odd.sh disk
exit $failed
