#!/usr/bin/env bash
# What accuracy costs on decks that ship: makes the tables and plots of docs/trade.md anew, with nothing but `brunt trade`.
#   decks/trade.sh [FOLDER]      REPEAT=3 JOBS=1 DECKS="half-spaces bars" decks/trade.sh; pages are written to docs/
# Run again after an interruption, it goes on where it stopped.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
brunt=${BRUNT:-$here/../brunt}
folder=${1:-trade.out}
docs=${DOCS:-$here/../docs}
mkdir -p "$folder" "$docs/trade"
page=$folder/page.md
# study NAME DECK --vary ...: one section of the page, from its head (the lines on stdin).
study() {
  local name=$1 deck=$2
  shift 2
  if [ -n "${DECKS:-}" ] && [[ " $DECKS " != *" $name "* ]]; then cat >/dev/null; return; fi
  {
    echo "## $name"
    echo
    cat
    echo
    echo '```sh'
    printf 'brunt trade decks/%s' "$deck"
    printf ' %q' "$@" | sed 's/\\ / /g'
    echo
    echo '```'
    echo
    echo '```text'
    "$brunt" trade "$here/$deck" "$@" --repeat "${REPEAT:-3}" --jobs "${JOBS:-1}" --out "$folder/$name" | sed 's/ *$//'
    echo '```'
    echo
    echo "![Error over processor time]($(basename "$docs/trade")/$name.svg)"
    echo
  } >>"$page"
  cp "$folder/$name/trade.svg" "$docs/trade/$name.svg"
}
cat >"$page" <<'HEAD'
# What accuracy costs, on decks that ship

Tables and plots of [decks/trade.sh](../decks/trade.sh), which makes them anew; how to read them is in
[the guide](guide/trade.md). Times are of one thread, of a machine that does other things too: the spread says how much.

HEAD
study half-spaces half-spaces/half-spaces.yaml --vary "parameters.size=0.4 mm,0.2 mm,0.1 mm" --vary time.heat_every=1,4 <<'TEXT'
Heat conduction alone, two half-spaces in contact; exact by their closed form. Size, and conduction at every fourth step.
TEXT
study bars bars/bars.yaml --vary parameters.cells=12,25,50,100 --vary time.safety=0.4,0.8 <<'TEXT'
Two elastic bars meet; exact by de Saint-Venant. Size and step.
TEXT
study hertz hertz/hertz.yaml --vary parameters.cells=12,24,34 --vary contact.default.stiffness=0.5,2,8 --against reference <<'TEXT'
Two balls meet; the reference is Hertz. Size, and stiffness of the contact over that of the elements.
TEXT
study taylor-bar-axisymmetric taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml \
  --vary "bodies.bar.cells=[4, 40],[6, 60],[8, 80]" --vary bodies.bar.element.integration=one-point,q1p0,full <<'TEXT'
A bar of copper on a rigid wall: the finest run is what errors are to, for the reference is another program's.
TEXT
mv "$page" "$docs/trade.md"
