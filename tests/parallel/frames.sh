#!/usr/bin/env bash
# Frames that several ranks write in pieces, as a user meets them: one of the ranks on a full disk, a
# run that goes on on other ranks, a folder that is used again, pictures.
#   frames.sh PROGRAM SOURCE COMPARE SHIM
# COMPARE: the program of tests/support/compare_frames.cpp. SHIM: the library of disk_full.c.
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
deck=$2/decks/drop-on-plate/drop-on-plate.yaml
compare=$3
shim=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export OMP_NUM_THREADS=1
short=(--quiet --oversubscribe --set "parameters.size=4 mm" --set "time.end=20 us"
  --set "output.every=4 us")

limit=120
run() { local out=$1 ranks=$2; shift 2; expect 0 "$brunt" run "$deck" "${short[@]}" --out "$out" --ranks "$ranks" "$@"; }
same() { "$compare" "$1" "$2" || fail "frames of $2"; }
# Every file in frames/ belongs to a frame of the index.
no_strays() {
  comm -13 <({ grep -o 'frames/[^"]*' "$1/frames.pvd" | sed 's,frames/,,'
    cat "$1"/frames/*.pvt? 2>/dev/null | sed -n 's/.*Piece Source="\([^"]*\)".*/\1/p'; } | sort) \
    <(find "$1/frames" -type f -printf '%f\n' | sort) >strays.txt
  [ ! -s strays.txt ] || fail "strays in $1: $(head -3 strays.txt)"
}

run one 1
run three 3
same one three
no_strays three

# Particles that were elements are a part of their own, empty at first.
converts=$2/tests/parallel/decks/conversion.yaml
for ranks in 1 3; do
  expect 0 "$brunt" run "$converts" --quiet --oversubscribe --set "output.every=4 us" --ranks $ranks --out "of-$ranks"
done
same of-1 of-3
no_strays of-3
[ "$(grep -c 'lower.particles.*vtu' of-1/frames.pvd)" = 5 ] || fail "no part of particles"

# Two parts on other ranks, in one folder and in another; then the folder again on fewer ranks.
run split 3 --until "9 us"
run split 2 --resume
same one split
no_strays split
run half 2 --until "9 us"
run rest 1 --restart half
same one rest
no_strays rest
run three 2 --force
same one three
no_strays three
if compgen -G "three/frames/*.2.vt?" >/dev/null; then fail "pieces of the third rank are left"; fi

# With fields left out, those named are as a lone rank has them; ids stay, pieces are merged by them.
run fields 2 --set "output.fields=[stress, velocity]"
grep -q 'Name="id"' fields/frames/plate.00000.pvtu || fail "no ids"
if grep -q 'Name="displacement"' fields/frames/plate.00000.pvtu; then fail "a field too many"; fi

# Frames know their ranks where they are asked for them; nothing else does.
run owners 3 --set "output.fields=[velocity, rank]"
run owner 1 --set "output.fields=[velocity, rank]"
/usr/bin/python3 - owners owner <<'END' || fail "ranks in frames"
import sys, pathlib
sys.path.insert(0, "/usr/lib/python3/dist-packages")
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
for out, n in zip(sys.argv[1:], (3, 1)):
    seen = set()
    for rank in range(n):
        file = pathlib.Path(out, "frames", f"plate.00001.{rank}.vtu" if n > 1 else "plate.00001.vtu")
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(file))
        reader.Update()
        grid = reader.GetOutput()
        cells, points = (data.GetArray("rank") for data in (grid.GetCellData(), grid.GetPointData()))
        copies = grid.GetPointData().GetArray("vtkGhostType")
        for i in range(grid.GetNumberOfCells()):
            assert cells.GetTuple1(i) == rank, (file, i)
        for i in range(grid.GetNumberOfPoints()):
            copy = copies is not None and copies.GetTuple1(i) == 1
            assert (points.GetTuple1(i) != rank) == copy, (file, i)
        seen.add(rank) if grid.GetNumberOfCells() else None
    assert len(seen) == n, (out, seen)
END
# A body that is on one rank alone has a piece without points on the other.
expect 0 "$brunt" run "$2/decks/cutting-2d/conducting.yaml" --quiet --oversubscribe --ranks 2 --out alone \
  --set "parameters.spacing=0.05 mm" --set "parameters.travel=0.01 mm" --set "output.fields=[pressure, rank]"
"$brunt" render alone --frames last --field rank >out.txt || fail "a picture of ranks"
cmp owners/history.csv three/history.csv || fail "a history that knows ranks"

# The disk of one rank is full at one file, or the root's at what joins the pieces: all ranks end with
# one message and status 4, the frames before are whole, and the run goes on from there.
for file in plate.00002.1.vtu plate.00002.0.vtu plate.00002.pvtu frames.pvd.tmp; do
  rm -rf full
  at=1
  [ $file != frames.pvd.tmp ] || at=5
  expect 4 env LD_PRELOAD="$shim" BRUNT_FULL_NAME="$file" BRUNT_FULL_AT=$at \
    "$brunt" run "$deck" "${short[@]}" --out full --ranks 3 --set output.checkpoint_steps=1
  [ "$(grep -c '^brunt: ' err.txt)" = 1 ] || { cat err.txt; fail "not one message for $file"; }
  grep -q "full/.*${file%.tmp}': No space left" err.txt || { cat err.txt; fail "$file is not named"; }
  "$brunt" render full --frames last >out.txt || fail "frames before a full disk at $file"
  run full 2 --resume
  same one full
  no_strays full
done

# The picture of several ranks is that of one.
for out in one split; do "$brunt" render $out --frames last --out "picture-$out" >out.txt; done
diff -r picture-one picture-split || fail "pictures differ"
echo "all good"
