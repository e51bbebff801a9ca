"""A long run in legs: ended at random events, gone on with from its checkpoint, now by cells, now by all pairs.

long_run.py TPS [--events N] [--legs N] [--particles N] [--seed S] [--fast]

What has to hold of each system: the last checkpoint is that of a run that was let alone, byte for byte; momentum and energy are
within the bounds that the summary derives (docs/ledger.md); the clock has not stalled. --fast leaves out the second run and the
detector that does not scale, so that 10^8 events take what they take once. Prints a line a system; exit code 1 where
something does not hold.
"""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

SYSTEMS = {
    "spheres in a membrane": ["scene", "gas", "--density", "0.5"],
    "spheres in a periodic box": ["scene", "gas", "--density", "0.5", "--periodic", "1"],
    "spheres of restitution 0.99": ["scene", "gas", "--density", "0.3", "--restitution", "0.99"],
}


def summary_of(words):
    ended = subprocess.run(words, capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise SystemExit(f"{' '.join(words)} returned {ended.returncode}: {ended.stderr[-500:]}")
    return json.loads(ended.stdout)


def run_in_legs(tps, scene, folder, ends, detectors):
    """The summary of the last leg, and the checkpoint that it leaves."""
    kept = folder / "legs"
    words = [tps, "run", scene, "--timing", "certified", "--checkpoint", kept]
    for n, end in enumerate(ends):
        if n > 0:
            words = [tps, "run", "--resume", kept, "--checkpoint", kept]
        summary = summary_of([str(w) for w in [*words, "-q", "--format", "json", "--max-events", end, "--detector", detectors[n % len(detectors)]]])
    return summary, kept.read_bytes()


def broken_bounds(summary):
    """What the summary says that cannot be."""
    if abs(summary["energy"]["remainder"]) > summary["energy"]["bound"]:
        yield f"energy is off by {summary['energy']['remainder']:.3g}, allowed {summary['energy']['bound']:.3g}"
    if summary["momentum"]["drift"] > summary["momentum"]["bound"]:
        yield f"momentum is off by {summary['momentum']['drift']:.3g}, allowed {summary['momentum']['bound']:.3g}"
    if summary["end"] != "max_events":
        yield f"the run ended with {summary['end']} after {summary['events']} events"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tps")
    parser.add_argument("--events", type=float, default=1e8)
    parser.add_argument("--legs", type=int, default=50)
    parser.add_argument("--particles", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=20261126)
    parser.add_argument("--fast", action="store_true")
    arguments = parser.parse_args()
    events = int(arguments.events)
    failures = 0
    for name, words in SYSTEMS.items():
        choices = random.Random(f"{arguments.seed} {name}")
        ends = sorted(choices.sample(range(1, events), arguments.legs - 1)) + [events]
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            scene = folder / "scene"
            subprocess.run([arguments.tps, *words, "--particles", str(arguments.particles), "--duration", "1e9", "-o", scene], check=True)
            start = time.monotonic()
            summary, kept = run_in_legs(arguments.tps, scene, folder, ends, ["cells"] if arguments.fast else ["cells", "all-pairs"])
            seconds = time.monotonic() - start
            problems = list(broken_bounds(summary))
            if not arguments.fast and run_in_legs(arguments.tps, scene, folder, [events], ["cells"])[1] != kept:
                problems.append("the checkpoint is not that of the run let alone")
        energy, momentum = summary["energy"], summary["momentum"]
        print(f"| {name} | {events:.0e} | {len(ends)} | {energy['remainder']:.2g} of {energy['bound']:.2g} | "
              f"{momentum['drift']:.2g} of {momentum['bound']:.2g} | {seconds:.0f} s |", flush=True)
        for problem in problems:
            print(f"  {problem}; seed {arguments.seed}, legs end at {ends}")
        failures += len(problems)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
