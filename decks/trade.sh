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
    for word in "$@"; do
      case $word in *[\ \{\[]*) printf " '%s'" "$word" ;; *) printf ' %s' "$word" ;; esac
    done
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

## What they say

Found on 2026-11-28, with the tables below:

- `q1p0` is on the front of both copper bars, `one-point` at half its size is not: at 1.27 mm the foot in 3D is 0.8 % off
  the finest run for 0.9 s, with `one-point` at 0.635 mm 2.6 % for 5.2 s. `full` locks: 20 to 29 %.
- A contact twice as stiff as the elements of both sides in series (`stiffness: 2`; the default is 0.5) halves the error of Hertz' pressure
  (5.4 % against 12.5 % at 24 cells) for 0.4 to 13 % more steps. 8 gains another third for 70 % more.
- `quality: careful` (stiffness 2, q1p0 in metals) halves the error of the wall at 8.3 mm for 9 % more steps; of the
  projectile it finds the same speed, and makes 2.9 % of the energy at 2 mm where `default` makes 1.6 %. `quick` is `default`
  but for particles: a tenth of the time.
- Steps of 0.8 of the limit are as right as those of 0.4 and cost less.
- `heat_every` saves nothing where conduction alone bounds the step.
- Particles: of the bar, less smoothing is nearer to the finest run at less cost in length and strain. A chip converges to
  nothing yet at these spacings.
- Particles, one lever at a time: a hexagonal lattice brings 76 % more points at the same spacing and half the error in
  strain, where a finer spacing would cost eight times as much. `correction: false` is a third cheaper and twice as
  wrong. The three kernels differ by less than the spacing does; `pair_precision: single` changes no digit that is shown
  and takes as long, where eight pairs in double are formed at a time.
- Hourglass control: half of the default viscosity is nearer to `q1p0` in every measure (foot -0.4 instead of -0.6 %) for
  no more time; twice as much is worse (-1.0 %).
- Contact of equal bars: the default damping of 0.1 costs 0.2 % of the speed that is handed on, 1 costs 1.2 %, none
  nothing. A stiffness of 0.1 loses 1.7 % of the force. The skin changes no bit; without one lists are made every step.
- The pressure at the middle of an overlap instead of its integral (`plane: point`) saves nothing that can be told from the
  spread, and the area of contact of the cylinders is 13 to 26 % off instead of 2: leave it `integrated`.
- Heat that does not flow costs a fifth less than heat that does, and the cutting force is 10 % off; none at all makes it 50 %
  too large, for what is cut does not soften, and saves nothing more.
- `process_speed` is inertia: a chip at 20 m/s instead of 10 (2) costs half and is 7 % off in force, 5 a quarter and 27 %.
- Mass that is added to all elements: 7 and 66 % of it change the damage of crushed concrete by 0.5 % and save 11 and 22 % of the
  steps; 326 % change it by 11 %, and save 26 %: the elements that flatten shorten the step again.

HEAD
study half-spaces half-spaces/half-spaces.yaml --vary "parameters.size=0.4 mm,0.2 mm,0.1 mm" --vary time.heat_every=1,4 <<'TEXT'
Heat conduction alone, two half-spaces in contact; exact by their closed form. Size, and conduction at every fourth step.
TEXT
study bars bars/bars.yaml --vary parameters.cells=12,25,50,100 --vary time.safety=0.4,0.8 <<'TEXT'
Two elastic bars meet; exact by de Saint-Venant. Size and step.
TEXT
study hertz hertz/hertz.yaml --vary parameters.cells=12,24,34 --vary contact.default.stiffness=0.5,1,2,8 --against reference <<'TEXT'
Two balls meet; the reference is Hertz. Size, and stiffness of the contact over that of the elements.
TEXT
study hertz-plane hertz/hertz.yaml --vary parameters.cells=12,24 --vary contact.default.plane=integrated,point --against reference <<'TEXT'
The pressure over the overlap of two faces: integrated, or that at its middle times its area.
TEXT
study taylor-bar-axisymmetric taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml \
  --vary "bodies.bar.cells=[4, 40],[6, 60],[8, 80]" --vary bodies.bar.element.integration=one-point,q1p0,full <<'TEXT'
A bar of copper on a rigid wall: the finest run is what errors are to, for the reference is another program's.
TEXT
study taylor-bar taylor-bar/taylor-bar.yaml --vary "parameters.size=1.27 mm,0.9 mm,0.635 mm" \
  --vary "bodies.bar.element={integration: one-point},{integration: q1p0},{integration: full}" <<'TEXT'
The same in 3D. The reference is a program that holds the foot: against the finest run of all.
TEXT
study taylor-bar-sph taylor-bar-sph/taylor-bar-sph.yaml --vary "parameters.spacing=1.28 mm,1.07 mm,0.8 mm" \
  --vary bodies.bar.smoothing=1.3,1.5,1.7 <<'TEXT'
A bar of particles: spacing, and the smoothing length over it.
TEXT
study taylor-bar-hourglass taylor-bar-axisymmetric/taylor-bar-axisymmetric.yaml --one-at-a-time \
  --vary "bodies.bar.element={integration: one-point, hourglass: {viscous: 0.05}},{integration: one-point},{integration: one-point, hourglass: {viscous: 0.2}}" <<'TEXT'
Hourglass control of one-point elements in the same bar: viscous, half and twice the default of 0.1. The deck as it
stands has q1p0, which needs none.
TEXT
study taylor-bar-sph-levers taylor-bar-sph/taylor-bar-sph.yaml --set "parameters.spacing=1.28 mm" --one-at-a-time --vary "parameters.spacing=0.8 mm" \
  --vary bodies.bar.kernel=cubic,hyperbolic --vary bodies.bar.lattice=cubic --vary bodies.bar.correction=false \
  --vary bodies.bar.pair_precision=single --vary bodies.bar.smoothing=1.5 <<'TEXT'
The levers of particles, each alone, at 1.28 mm and beside a finer spacing: what is not varied is as in the deck (kernel
`wendland-c2`, hexagonal lattice, smoothing 1.7, corrected, double precision).
TEXT
study bars-contact bars/bars.yaml --one-at-a-time --vary contact.default.damping=0,0.3,1 \
  --vary contact.default.stiffness=0.1,2 --vary "contact.skin=0 m,4 mm" <<'TEXT'
The levers of contact, each alone: damping (0.1 in the deck), stiffness (0.5), and the skin of the search, which changes no bit.
TEXT
study cutting-2d cutting-2d/cutting-2d.yaml --vary "parameters.spacing=0.1 mm,0.075 mm,0.05 mm" \
  --vary contact.default.stiffness=0.5,2 <<'TEXT'
Orthogonal cutting with particles: spacing, and stiffness of the contact. A chip is no smooth flow: its forces approach no
value soon.
TEXT
study brick-wall-2d brick-wall-2d/brick-wall-2d.yaml --vary "parameters.size=12.5 mm,8.333333 mm,6.25 mm" \
  --vary quality=quick,default,careful <<'TEXT'
A projectile through a wall of bricks with joints: size of the elements, and `quality`.
TEXT
study projectile-2d projectile-2d/projectile-2d.yaml --vary "parameters.size=4 mm,2 mm" --vary quality=quick,default,careful <<'TEXT'
A projectile of particles through a plate: size of the elements of the plate, and `quality`.
TEXT
study heat cutting-2d/cutting-2d.yaml --set "parameters.spacing=0.1 mm" --set parameters.scale=1 --set heat=conduct \
  --one-at-a-time --vary heat=adiabatic,off <<'TEXT'
Cutting at its real speed: heat that flows, heat that stays where it arises, and none.
TEXT
study process-speed cutting-2d/cutting-2d.yaml --set "parameters.spacing=0.1 mm" --set parameters.scale=1 \
  --one-at-a-time --vary time.process_speed=2,5,10,20 <<'TEXT'
Cutting at its real speed, and stepped so many times faster: what inertia adds.
TEXT
study mass-scaling concrete-cylinder/concrete-cylinder.yaml --set "parameters.size=0.25 mm" --one-at-a-time \
  --vary "time.mass_scaling={step: 40 ns, max_added_mass: 10 %},{step: 50 ns, max_added_mass: 100 %},{step: 80 ns, max_added_mass: 400 %}" <<'TEXT'
A cylinder of concrete is crushed; its elements allow 34 ns. Mass is added to all that would not allow the step: 7, 66
and 326 % of the cylinder.
TEXT
mv "$page" "$docs/trade.md"
