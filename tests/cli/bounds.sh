#!/usr/bin/env bash
# `brunt check` ends with 0 or 2 within 5 s and 1 GB, whatever it reads.
#   bounds.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
says() { grep -q -- "$1" err.txt || { head -c 2000 err.txt; fail "does not say '$1'"; }; }
# CPU time, since a machine may be busy. A sanitizer's shadow takes any space: then none is asked for.
space=1048576
if nm "$brunt" 2>/dev/null | grep -q __asan_init; then space=unlimited; fi
# bounded STATUS FILE [SAYS]
bounded() {
  limit=60 expect "$1" bash -c 'ulimit -t 5; ulimit -v "$1"; exec "$2" check "$3"' _ $space "$brunt" "$2"
  [ $# -lt 3 ] || says "$3"
}
# deck BODY: a deck of one body of steel.
deck() {
  printf 'time: {end: 1 us}\nmaterials: {m: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}}}\nbodies:\n  a: {material: m, velocity: [1 m/s, 0, 0], %s}\n' "$1"
}
box='shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 10 mm]}}'
deck "method: fe, size: 5 mm, $box" >sound.yaml
bounded 0 sound.yaml

# Files that include each other: 20,000 in a row; each the next twice.
mkdir row twice
for i in $(seq 20000); do echo "include: [$((i + 1)).yaml]" >"row/$i.yaml"; done
cp sound.yaml row/20001.yaml
bounded 2 row/1.yaml 'levels'
for i in $(seq 16); do echo "include: [$((i + 1)).yaml, $((i + 1)).yaml]" >"twice/$i.yaml"; done
cp sound.yaml twice/17.yaml
bounded 2 twice/1.yaml 'includes at most'

# Parameters made of each other, 20,000 in a row, the last first; and texts that double.
{ echo 'parameters:'
  seq 20000 | awk '{ print "  p" $1 ": $p" $1 + 1 }'
  printf '  p20001: 5 mm\n'
  deck "method: fe, size: \$p1, $box"; } >chain.yaml
bounded 0 chain.yaml
{ echo 'parameters:'
  seq 40 | awk '{ print "  p" $1 ": x$p" $1 + 1 "$p" $1 + 1 }'
  printf '  p41: x\ntitle: $p1\n'
  deck "method: fe, size: 5 mm, $box"; } >doubling.yaml
bounded 2 doubling.yaml 'too long'
{ echo 'parameters:'
  seq 40 | awk '{ print "  p" $1 ": [$p" $1 + 1 ", $p" $1 + 1 "]" }'
  printf '  p41: [1]\ngravity: $p1\n'
  deck "method: fe, size: 5 mm, $box"; } >lists.yaml
bounded 2 lists.yaml

# Nested without end: lists, maps, brackets of an expression.
awk 'BEGIN { printf "title: "; for (i = 0; i < 100000; ++i) printf "["; print "" }' >deep.yaml
bounded 2 deep.yaml
awk 'BEGIN { for (i = 0; i < 2000; ++i) { for (k = 0; k < i; ++k) printf " "; print "a:" } }' >maps.yaml
bounded 2 maps.yaml
awk 'BEGIN { for (i = 0; i < 5000; ++i) printf "("; printf 1; for (i = 0; i < 5000; ++i) printf ")" }' >brackets.txt
deck "method: fe, size: 5 mm, $box" | sed "s/end: 1 us/end: \"= $(cat brackets.txt) us\"/" >expression.yaml
bounded 2 expression.yaml

# No files: folders, pipes, devices; and surfaces that are.
mkfifo pipe
for path in . pipe /dev/zero /dev/full; do
  bounded 2 "$path"
  deck "method: sph, size: 1 mm, file: $path" >stl.yaml
  bounded 2 stl.yaml
  echo "include: [$path]" >including.yaml
  bounded 2 including.yaml
done
table="method: fe, size: 5 mm, $box}\nboundaries:\n  b: {body: a, where: surface, force: [0, 0, {file: rows.csv, over: time}]"
deck "$(printf "$table")" >table.yaml
printf '0,1\n1,2\n' >rows.csv
bounded 0 table.yaml
awk 'BEGIN { for (i = 0; i < 1048576; ++i) print "1,2" }' >rows.csv
bounded 2 table.yaml 'rises from row to row'
echo 3,4 >>rows.csv
bounded 2 table.yaml 'larger than 4 MiB together'
rm rows.csv && mkfifo rows.csv
bounded 2 table.yaml 'cannot read'
printf 'solid' >huge.stl
truncate -s 20G huge.stl
deck "method: sph, size: 1 mm, file: huge.stl" >stl.yaml
bounded 2 stl.yaml 'larger than 128 MiB'
cp huge.stl huge.yaml
bounded 2 huge.yaml 'larger than 16 MiB'

# Metres where millimetres were meant: counted, not meshed, unless the deck says so.
deck "method: fe, size: 4 mm, shape: {cylinder: {radius: 4, length: 20 mm, base: [0, 0, 0], axis: z}}" >metres.yaml
bounded 2 metres.yaml 'max_cells'
deck "method: sph, size: 4 mm, shape: {sphere: {radius: 4, center: [0, 0, 0]}}" >sphere.yaml
bounded 2 sphere.yaml 'max_cells'
# Nor is a second body meshed where the first has gone beyond the limit and is reported.
{ cat metres.yaml; echo '  b: {material: m, method: fe, size: 4 mm, shape: {box: {min: [5 m, 0, 0], max: [9 m, 4 m, 4 m]}}}'; } >two.yaml
bounded 2 two.yaml 'bodies.a.size: makes about'
deck "method: fe, cells: [10, 10, 10], $box" >thousand.yaml
{ cat thousand.yaml; echo 'max_cells: 999'; } >one-less.yaml
bounded 2 one-less.yaml 'max_cells, 999'
{ cat thousand.yaml; echo 'max_cells: 1000'; } >just.yaml
bounded 0 just.yaml

# Many bodies: what 1,000 need grows with their number, not with that of their pairs.
{ printf 'geometry: plane-strain\ndepth: 1 m\ntime: {end: 0.1 us}\nheat: off\n'
  printf 'materials: {m: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}}}\nbodies:\n'
  seq 0 999 | awk '{ x = 2 * ($1 % 40); y = 2 * int($1 / 40)
    printf "  b%d: {method: fe, material: m, size: 1 mm, velocity: [%d m/s, 0], ", $1, $1 % 2
    printf "shape: {box: {min: [%d mm, %d mm], max: [%d mm, %d mm]}}}\n", x, y, x + 1, y + 1 }'
  printf 'contact: {pairs: {first: {between: [b0, b1], friction: 0.1}}}\n'; } >many.yaml
bounded 0 many.yaml
limit=60 expect 0 bash -c 'ulimit -v "$1"; exec "$2" run many.yaml --quiet' _ $space "$brunt"
# Half a million pairs of bodies: history.csv tells of the one that the deck names.
columns=$(head -n 1 many.out/history.csv | tr , '\n' | grep '^contact\.' | cut -d. -f2 | sort -u)
[ "$columns" = first ] || fail "columns of contact: $columns"
grep -q '499500 pairs of bodies may touch' many.out/log.txt || fail "the log does not say of whom"
echo 'measures: {push: {history: {column: contact.b2-b3.force.x, reduce: max}}}' >>many.yaml
bounded 2 many.yaml 'over 1000 pairs'
echo "all good"
