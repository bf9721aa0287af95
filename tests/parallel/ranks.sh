#!/usr/bin/env bash
# The same history, byte for byte, state hashes and all, and the same frames, bit for bit, on any
# number of ranks and threads: every shipped deck, shortened; with another skin; repartitioned
# every few steps; and split in two by a restart on other ranks. Decks of contact alone besides, which
# stand beside this file: all that a contact remembers moves with its points. Warnings are the same
# too, with the place and time of the first contact that did not hold and how many followed it; and so
# are measures, and when they were taken.
#   ranks.sh RUN_LIST SOURCE COMPARE STATE_DIFFERENCE RANDOM_PARTITION RANKS...
# RUN_LIST: brunt that runs many decks by one start (run_list.cpp), for starts took three quarters of the time.
# COMPARE: the program of tests/support/compare_frames.cpp, or true where there are no frames.
# RANDOM_PARTITION: RUN_LIST with points spread by a hash, so that nearly every contact is shared by
# ranks: for decks of contact, and for all on four ranks and more.
set -euo pipefail
ordinary=$1
decks=$2/decks own=$2/tests/parallel
compare=$3
state_difference=$4
random_partition=$5
shift 5
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# deck, or folder/deck where they differ (decks/deck: beside this file), when it is split by a
# restart, then what makes it a matter of seconds; a blank is written _, and _ itself __
cases=(
  "bars 8_us time.end=20_us"
  "hot-rod 0.4_s time.end=0.8_s"
  "taylor-bar 2_us heat=conduct materials.copper.thermal={cp:_383,_k:_386} parameters.size=0.9_mm time.end=4_us probes={edge:_{body:_bar,_at:_[1.1_mm,_0.4_mm,_2.3_mm],_fields:_[velocity.z,_stress.zz]}}"
  "taylor-bar-sph 2_us heat=conduct materials.copper.thermal={cp:_383,_k:_386} parameters.spacing=0.8_mm time.end=4_us"
  "taylor-bar 2_us heat=conduct materials.copper.thermal={cp:_383,_k:_386} parameters.size=0.9_mm time.end=4_us bodies.bar.element={type:_tet4} probes={edge:_{body:_bar,_at:_[1.1_mm,_0.4_mm,_2.3_mm],_fields:_[velocity.z,_stress.zz]}}"
  "taylor-bar-axisymmetric 2_us time.end=5_us bodies.bar.cells=[4,_40]"
  "taylor-bar-sph 2_us parameters.spacing=0.8_mm time.end=5_us"
  "drop-on-plate 20_us parameters.size=4_mm time.end=45_us"
  "block-on-incline 15_ms parameters.end=30_ms parameters.mu=0.6"
  "freezing-slab 10_ms time.end=20_ms materials.steel.thermal.cp={table:_[[300_K,_475],_[800_K,_640]],_over:_temperature}"
  "half-spaces 0.4_ms time.end=0.8_ms parameters.width=0.4_mm"
  "hot-block 5_us time.end=10_us"
  "rubbing-blocks 5_us time.end=9_us"
  "sliding-blocks 1_ms parameters.end=2_ms"
  "cutting-2d 0.5_us heat=conduct parameters.spacing=0.05_mm parameters.travel=0.06_mm probes={edge:_{body:_work,_at:_[3.4_mm,_0.6_mm],_fields:_[temperature,_stress.xx]}} sections={foot:_{body:_work,_plane:_{axis:_y,_at:_0.45_mm}}} time.heat__every=8"
  "cutting-2d/conducting 0.5_us parameters.spacing=0.05_mm parameters.travel=0.06_mm"
  "composite-rod 0.4_s time.end=0.8_s output.history=0.05_s"
  "hertz 4_us time.end=8_us parameters.cells=8 measures.pressure.at=5_us"
  "hertz/3d 4_us time.end=8_us parameters.cells=4 measures.pressure.at=5_us"
  "brick-stack 8_ms time.end=15_ms"
  "tumbling-blocks 0.55_ms parameters.speed=30_m/s parameters.end=0.6_ms bodies.plate.cells=[10,_10,_2]"
  "tumbling-blocks 0.55_ms parameters.speed=30_m/s parameters.end=0.6_ms bodies.plate.cells=[10,_10,_2] materials.nylon.thermal={cp:_1700,_k:_10} materials.hot={density:_700,_elastic:_{E:_1.5_GPa,_nu:_0.3},_thermal:_{cp:_1200,_k:_20}} bodies.die.material=hot bodies.die.cells=[3,_3,_3] bodies.die.temperature=900_K bodies.brick.material=hot bodies.brick.cells=[4,_2,_1] contact.default.heat=perfect time.heat__every=3"
  "projectile-2d 20_us parameters.spacing=2_mm parameters.size=4_mm time.end=40_us"
  "taylor-bar 2_us parameters.size=0.9_mm time.end=4_us bodies.bar.temperature==_300+2e4*z bodies.bar.element={integration:_one-point} boundaries={squeeze:_{body:_bar,_where:_surface,_pressure:_1_GPa},_beyond:_{body:_bar,_where:_{side:_max-z},_nonreflecting:_true}}"
  "decks/fold 0.8_ms"
  "decks/overlaps 0.18_ms"
  "decks/joints 0.2_ms"
  "decks/held 0.35_ms"
  "wave-through-joints 4_ms parameters.end=8_ms"
  "masonry-arch/hexes 0.5_ms parameters.end=1_ms"
  "decks/bonded 6.3_us"
  "decks/shaft 10_us"
  "decks/bricks 1.2_ms"
  "decks/sheet 15_us"
  "decks/solids 0.5_ms"
  "decks/fast 30_us"
  "decks/fast 20_us contact.default.stiffness=30 contact.default.step__by__area=true time.end=40_us"
  "tumbling-blocks 0.55_ms parameters.speed=30_m/s parameters.end=0.6_ms bodies.plate.cells=[10,_10,_2] contact.default.stiffness=20 contact.default.step__by__area=true"
  "strip-rolling 0.8_ms parameters.end=1.5_ms measures=null"
  "decks/driven 30_us"
  "decks/total 0.15_ms"
  "decks/mirrored 3_us"
  "decks/tets 2_us"
  "decks/stressed 3_us"
  "decks/still 2_us"
  "decks/flight 0.2_ms"
  "decks/thin 4_us"
  "decks/matters 15_us"
  "decks/cubes 15_us"
  "decks/erosion 8_us"
  "decks/conversion 7_us"
  "decks/failing 17_us"
  "decks/debris 3_us time.end=6_us"
  "decks/eroded-joint 12.6_us"
  "decks/lost 0.14_ms"
  "decks/fails 5_us"
  "decks/concrete 12_us"
  "concrete-cylinder 20_us time.end=40_us parameters.size=1_mm"
  "ring-compression 40_ms time.end=60_ms parameters.size=0.75_mm parameters.m=1 time.process__speed=400"
)
# On four ranks and more besides: what the cases above have in other decks.
more=(
  "hot-block 5_us time.end=10_us time.heat__every=16"
  "taylor-bar 2_us heat=conduct materials.copper.thermal={cp:_383,_k:_386} parameters.size=0.9_mm time.end=4_us time.heat__every=7"
  "hertz/pressed 4_us time.end=8_us parameters.cells=8"
  "hertz/cylinders 4_us time.end=8_us parameters.cells=8"
)
[ "$1" -lt 4 ] || cases+=("${more[@]}")
path_of() { case $1 in */*) echo "$1.yaml" ;; *) echo "$1/$1.yaml" ;; esac; }
plan() {  # plan LIST OUT DECK OPTIONS... -- OVERRIDES...: one more run of a list (PROGRAM.RANKS[.PART])
  local list=$1 out=$2 deck=$3 options=() overrides=() each ranks
  shift 3
  while [ "$1" != -- ]; do options+=("$1"); shift; done
  shift
  for each in "$@"; do
    each=${each//__/$'\1'} each=${each//_/ }
    overrides+=(--set "${each//$'\1'/_}")
  done
  case $deck in decks/*) deck=$own/$(path_of "$deck") ;; *) deck=$decks/$(path_of "$deck") ;; esac
  overrides+=(--set output.state_hash=true)
  ranks=${list#*.}
  printf '%q ' "$deck" --ranks "${ranks%.*}" --oversubscribe "${options[@]}" "${overrides[@]}" >"$out.args"
  printf '%s\n' "$out" run "$deck" --quiet --out "$out" "${options[@]}" "${overrides[@]}" '' >>"$list"
}
launch() {  # launch LIST: its runs one after another
  local list=$1 program ranks=${1#*.} start=()
  [ -e "$list" ] || return 0
  ranks=${ranks%.*}
  case $list in random.*) program=$random_partition ;; *) program=$ordinary ;; esac
  # As brunt starts ranks itself (app/cli/launch_ranks.cpp).
  [ "$ranks" = 1 ] || start=(mpirun -n "$ranks" --quiet --bind-to none --oversubscribe
    --mca pml ob1 --mca btl "self,vader" --mca mpi_yield_when_idle 1)
  "${start[@]}" "$program" "$list" >"$list.said" 2>"$list.err" </dev/null && return
  local out
  out=$(tail -n 1 "$list.said")
  echo "FAILED: run $out:" && cat "$list.err" "$out.err"
  return 1
}
same() {  # same DECK A B
  cmp -s <(grep '"text"' "$2/summary.json") <(grep '"text"' "$3/summary.json") ||
    { echo "FAILED: $1: $3 warns of something else than $2"; touch ../failed; }
  cmp -s <(grep -E '"(value|time)"' "$2/summary.json") <(grep -E '"(value|time)"' "$3/summary.json") ||
    { echo "FAILED: $1: $3 measures something else than $2"; touch ../failed; }
  cmp -s "$2/history.csv" "$3/history.csv" && return
  echo "FAILED: $1: $3 differs from $2 at the rows (step, hash):"
  diff <(awk -F, '{print $2, $NF}' "$2/history.csv") <(awk -F, '{print $2, $NF}' "$3/history.csv") | head -4 || true
  local program=$ordinary
  case $3 in *-random*) program=$random_partition ;; esac
  "$own/first_difference.sh" "$program" "$state_difference" "$2.args" "$3.args" || true
  touch ../failed
}
touches() {  # touches WHAT HISTORY: pairs that touch in the last row
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /^contact\..*\.planes$/) column[i] = 1 }
    NR > 1 { n = 0; for (i in column) if ($i > 0) n += $i } END { exit !(n >= 5) }' "$2" ||
    { echo "FAILED: $1: fewer than five contacts at the restart"; touch ../failed; }
}
contact_alone() { case $1 in decks/*) true ;; *) false ;; esac; }
plan_case() {  # plan_case NAME CASE RANKS...
  local name=$1 deck until shorten n threads
  local moved=(--set ranks.balance=1 --set ranks.balance_steps=7)
  read -r deck until shorten <<<"$2"
  shift 2
  plan ordinary.1 "$name-1" "$deck" --threads 1 -- $shorten
  # Two threads on two ranks; runs of one thread on two and three ranks, with another skin and repartitioned, follow.
  for n in "$@"; do
    threads=1
    [ "$n" != 2 ] || threads=2
    plan "ordinary.$n" "$name-$n-$threads" "$deck" --threads $threads -- $shorten
  done
  plan ordinary.2 "$name-half" "$deck" --threads 1 --until "${until//_/ }" -- $shorten
  plan ordinary.3 "$name-repartitioned" "$deck" --threads 1 "${moved[@]}" -- $shorten "contact.skin=1_mm"
  plan ordinary.3 "$name-rest" "$deck" --threads 1 --restart "$name-half" -- $shorten
  plan ordinary.1.rest "$name-alone" "$deck" --threads 1 --restart "$name-half" -- $shorten
  contact_alone "$deck" || [ "$1" -ge 4 ] || return 0
  plan random.3 "$name-random" "$deck" --threads 1 "${moved[@]}" -- $shorten
  plan random.2 "$name-random-rest" "$deck" --threads 1 --restart "$name-half" -- $shorten
}
check_case() {  # check_case NAME CASE
  local name=$1 deck=${2%% *} others=() args
  for args in "$name"-*.args; do
    case $args in "$name-1.args" | "$name-half.args") ;; *) others+=("${args%.args}") ;; esac
  done
  "$compare" "$name-1" "${others[@]}" >frames.txt || { echo "FAILED: $deck: frames differ"; cat frames.txt; touch ../failed; }
  for args in "${others[@]}"; do same "$deck" "$name-1" "$args"; done
  grep -q '"repartitions": [1-9]' "$name-repartitioned/summary.json" ||
    { echo "FAILED: $deck was not repartitioned"; touch ../failed; }
  ! contact_alone "$deck" || touches "$deck" "$name-half/history.csv"
}
check() {  # check FIRST RANKS...: the cases of one start
  local first=$1 last=$(($1 + at_once - 1)) i list
  shift
  [ "$last" -lt ${#cases[@]} ] || last=$((${#cases[@]} - 1))
  for i in $(seq "$first" "$last"); do plan_case "case$i" "${cases[$i]}" "$@"; done
  for list in ordinary.1 $(printf 'ordinary.%s\n' "$@" 2 3 | sort -u) ordinary.1.rest random.3 random.2; do
    launch "$list" || { touch ../failed; return; }
  done
  for i in $(seq "$first" "$last"); do check_case "case$i" "${cases[$i]}"; done
}
export OMP_WAIT_POLICY=passive OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
at_once=4
# As many starts at once as there are cores.
for ((first = 0; first < ${#cases[@]}; first += at_once)); do
  while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
  mkdir "$first"
  { (cd "$first" && check "$first" "$@") || touch failed; } >"$first.said" 2>&1 &
done
wait
cat ./*.said
[ ! -e failed ]
