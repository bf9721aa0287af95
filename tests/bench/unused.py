#!/usr/bin/env python3
"""What a scene does not use costs nothing: instructions of a step with and without it, by valgrind.

  unused.py [PROGRAM]      default: build/app/brunt

A steel block of 8^3 elements and one of 8^3 particles fly apart, so that nothing but elements, particles and the loop
works. Each line adds what has no effect there. Steps are counted from the difference of two runs, so that reading and
building, which differ, stay out.
"""
import pathlib, re, subprocess, sys, tempfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
brunt = sys.argv[1] if len(sys.argv) > 1 else str(root / "build/app/brunt")

MATERIAL = "density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}, strength: {j2: {yield: 400 MPa, hardening: 1 GPa}}"
DECK = """title: two blocks that fly apart
geometry: 3d
time: {{end: 1 ms, max_step: 50 ns}}
{top}
materials:
  steel: {{{material}{thermal}}}
bodies:
  hexes: {{material: steel, shape: {{box: {{min: [0, 0, 0], max: [8 mm, 8 mm, 8 mm]}}}}, size: 1 mm, velocity: [-10 m/s, 0, 0], spin: {{axis: z, rate: 1e4 rad/s, about: [4 mm, 4 mm, 4 mm]}}}}
  grains: {{method: sph, material: steel, shape: {{box: {{min: [9 mm, 0, 0], max: [17 mm, 8 mm, 8 mm]}}}}, size: 1 mm, velocity: [10 m/s, 0, 0]}}
{bodies}
contact: {{{contact}}}
output: {{every: 1 ms, history: 1 ms}}
"""
BALL = "  ball: {material: steel, rigid: true, shape: {sphere: {center: [0.5 m, 0, 0], radius: 5 mm}}, size: 2 mm}"
BLOCK = "  rests: {material: steel, shape: {box: {min: [0.4 m, 0, 0], max: [0.404 m, 4 mm, 4 mm]}}, size: 2 mm}"
GRAINS = BLOCK.replace("{material", "{method: sph, material")
FEATURES = {
    "gravity 0": {"top": "gravity: [0, 0, 0]"},
    "thermal data that nothing heats": {"thermal": ", thermal: {cp: 475 J/kg/K, k: 45 W/m/K}", "top": "heat: off"},
    "an ignored pair": {"contact": "default: {friction: 0}, pairs: {none: {between: [hexes, grains], ignore: true}}"},
    "friction 0": {"contact": "default: {friction: 0}"},
    "a far free ball": {"bodies": BALL},
    "a far block at rest, 8 elements": {"bodies": BLOCK},
    "a far block at rest, 512 elements": {"bodies": BLOCK.replace("size: 2 mm", "size: 0.5 mm")},
    "a far block at rest, 64 particles": {"bodies": GRAINS.replace("size: 2 mm", "size: 1 mm")},
    "a far block at rest, 512 particles": {"bodies": GRAINS.replace("size: 2 mm", "size: 0.5 mm")},
}


def instructions(deck, microseconds):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "deck.yaml"
        path.write_text(deck)
        result = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", brunt,
             "run", str(path), "--until", f"{microseconds} us", "--threads", "1", "--quiet", "--out", f"{folder}/run"],
            capture_output=True, text=True)
        if result.returncode != 0:
            sys.exit(result.stderr)
        return int(re.search(r"Collected : (\d+)", result.stderr).group(1))


def of_steps(**parts):
    given = {"top": "", "thermal": "", "bodies": "", "contact": "", "material": MATERIAL} | parts
    deck = DECK.format(**given)
    return instructions(deck, 3) - instructions(deck, 1)


base = of_steps()
print(f"{base / 40:.0f} instructions a step")
for name, parts in FEATURES.items():
    print(f"{name:40s} {100 * (of_steps(**parts) / base - 1):+.3f} %", flush=True)
