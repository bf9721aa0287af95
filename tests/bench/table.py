#!/usr/bin/env python3
"""What a step, a start, a frame and memory cost, and what a floor program takes for the same work beside it, as a table.

  table.py PROGRAM [--floor-hex COMMAND] [--floor-sph COMMAND] [--rounds N] [--large] [--threads N]

COMMAND prints lines with "median NUMBER" [ns an element-step] behind a heading with PLASTIC or ELASTIC; of particles
"real nbrs NUMBER" and "sum NUMBER" [ns a particle-step]. Runs of all rows alternate, and the table has medians and the
ratio of medians; load on the machine then falls on all of them. --large adds half a million of each kind.
"""
import argparse, json, pathlib, re, statistics, subprocess, sys, tempfile, threading, time

HERE = pathlib.Path(__file__).resolve().parent
DECKS = HERE.parent.parent / "decks"
ELASTIC = ["--set", "materials.copper={density: 8960, elastic: {E: 124 GPa, nu: 0.34}, thermal: {cp: 383}}",
           "--set", "measures={length: {extent: {body: bar, axis: z}}}"]
# name, deck, options, until ("": whole runs, for bodies that are crushed cost more than those that are about to be), floor ("plastic", "elastic", "pair"), long
ROWS = [
    ("hex, taylor-bar, one point", DECKS / "taylor-bar/taylor-bar.yaml",
     ["--set", "parameters.size=0.4 mm", "--set", "bodies.bar.element={integration: one-point}"], "", "plastic", False),
    ("hex, Johnson-Cook, 19,652", HERE / "hexes.yaml", ["--set", "parameters.n=17"], "", "plastic", False),
    ("hex, elastic, 19,652", HERE / "hexes.yaml", ["--set", "parameters.n=17"] + ELASTIC, "", "elastic", False),
    ("particle, 50,976", HERE / "particles.yaml", [], "4 us", "pair", False),
    ("hex, Johnson-Cook, 500,000", HERE / "hexes.yaml", ["--set", "parameters.n=50"], "0.4 us", "plastic", True),
    ("particle, 500,000", HERE / "particles.yaml", ["--set", "parameters.spacing=0.13 mm"], "0.2 us", "pair", True),
]
NEIGHBOURS = 51  # within the support, of particles.yaml


def resident(pid):
    """Resident memory of a process [byte]; 0 where it is gone."""
    try:
        found = re.search(r"VmRSS:\s+(\d+)", pathlib.Path(f"/proc/{pid}/status").read_text())
    except OSError:
        return 0
    return 1024 * int(found.group(1)) if found else 0


def run(program, deck, options, until, threads):
    """Costs of one run, by name; memory is looked at while it steps."""
    with tempfile.TemporaryDirectory() as work:
        out = pathlib.Path(work, "out")
        call = [program, "run", deck, "--quiet", "--threads", str(threads), "--out", out] + options
        call += ["--set", f"time.end={until}"] if until else []  # --until would write a checkpoint
        process = subprocess.Popen(call + ["--set", "output.checkpoint=off"], stderr=subprocess.PIPE, text=True)
        samples = []

        def watch():
            while process.poll() is None:
                samples.append(resident(process.pid))
                time.sleep(0.05)
        watcher = threading.Thread(target=watch)
        watcher.start()
        errors = process.communicate()[1]
        watcher.join()
        if process.returncode != 0:
            sys.exit(f"{deck}: status {process.returncode}\n{errors}")
        summary = json.loads((out / "summary.json").read_text())
        frames = max(1, (out / "frames.pvd").read_text().count("timestep")) if (out / "frames.pvd").exists() else 1
    n, steps, phases = summary["elements"] + summary["particles"], summary["steps"], summary["phases"]
    loop = summary.get("loop_seconds") or sum(phases.values())
    return {"n": n, "ns": 1e9 * loop / n / steps, "output": (phases["output"] + phases["ledger"]) / loop,
            "peak": summary["peak_memory"] / n, "steady": statistics.median([s for s in samples if s] or [0]) / n,
            "start": summary["start_seconds"], "frame": phases["output"] / frames}


def floor_of(command, kind):
    """The smallest time that a floor program reports of this kind of work; None without it."""
    if not command:
        return None
    text = subprocess.run(command, shell=True, capture_output=True, text=True, check=True).stdout
    if kind == "pair":
        return float(re.search(r"\bsum (\d+)", text).group(1)) / float(re.search(r"real nbrs ([\d.]+)", text).group(1))
    best, here = None, None
    for line in text.splitlines():
        upper = line.upper()
        here = "elastic" if "ELASTIC" in upper else "plastic" if "PLASTIC" in upper else here
        found = re.search(r"median\s+([\d.]+)", line)
        if found and here == kind:
            best = min(best or float(found.group(1)), float(found.group(1)))
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--floor-hex")
    parser.add_argument("--floor-sph")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--large", action="store_true")
    given = parser.parse_args()
    rows = [row for row in ROWS if given.large or not row[5]]
    runs, floors = [[] for _ in rows], [[] for _ in rows]
    for _ in range(given.rounds):
        for k, (name, deck, options, until, kind, _) in enumerate(rows):
            runs[k].append(run(given.program, deck, options, until, given.threads))
            floors[k].append(floor_of(given.floor_sph if kind == "pair" else given.floor_hex, kind))
    print("| work | entities | ns a step, everything | floor | ratio | output and ledger | steady, peak [kB] | start [s] | a frame [s] |")
    print("|---|---|---|---|---|---|---|---|---|")
    for (name, _, _, _, kind, _), mine, floor in zip(rows, runs, floors):
        of = {key: statistics.median(one[key] for one in mine) for key in mine[0]}
        ns = of["ns"] / NEIGHBOURS if kind == "pair" else of["ns"]
        known = [one for one in floor if one]
        least = statistics.median(known) if known else None
        print(f"| {name}{', a pair' if kind == 'pair' else ''} | {of['n']:,.0f} | {ns:.1f} | "
              f"{f'{least:.1f}' if least else '-'} | {f'{ns / least:.2f}' if least else '-'} | {100 * of['output']:.1f} % | "
              f"{of['steady'] / 1e3:.2f}, {of['peak'] / 1e3:.2f} | {of['start']:.2f} | {of['frame']:.3f} |")


if __name__ == "__main__":
    main()
