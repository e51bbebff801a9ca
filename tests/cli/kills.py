"""SIGKILL at random moments of verbs that write or have children. What a run has written goes on, or says that it holds no
state yet, and ends as the run that was let alone; a check says that the trace is cut off; nothing of the others is left.
Arguments: the program, [--kills N] (a kind, default 3). The long form: python3 tests/cli/kills.py build/release/tps --kills 100"""
import collections
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import hostile_program
import processes

RUNS = {"plain": [], "states": ["--state-every", "20"], "checkpoint": ["--state-every", "20", "--checkpoint", "kept"],
        "float": ["--scalar", "float"], "mp50": ["--scalar", "mp50", "--state-every", "30"], "certified": ["--timing", "certified"]}
EVENTS = collections.defaultdict(lambda: 3000, mp50=600)  # a run takes a fraction of a second


def whole(tps, folder, options, events):
    words = [tps, "run", "scene", "-q", "-o", "whole", "--max-events", str(events), *[o.replace("kept", "kept_whole") for o in options]]
    start = time.monotonic()
    subprocess.run(words, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return (folder / "whole").read_bytes(), time.monotonic() - start


def events_of(trace):
    """Event lines and the end; states are where the run was looked at."""
    return [line for line in trace.splitlines() if not line.startswith(b'{"state"')]


def killed_run(tps, folder, options, events, expected, after, failures, seen):
    for name in ("cut", "kept", "kept.unfinished"):
        (folder / name).unlink(missing_ok=True)
    marked = processes.Marked([tps, "run", "scene", "-q", "-o", "cut", "--max-events", str(events), *options], cwd=folder)
    time.sleep(after)
    marked.process.send_signal(signal.SIGKILL)
    marked.end()
    if not (folder / "cut").exists():
        seen["nothing written yet"] += 1
        return
    cut = (folder / "cut").read_bytes()
    # A check in 833 bits takes a minute: the other scalars stand for it.
    check = processes.run([tps, "check", "cut", "-q"], cwd=folder) if "mp50" not in options and cut != expected and cut else None
    if check:
        failures.expect(check[0] in (1, 3) and ("end" in check[1] + check[2]), f"check of a trace of {len(cut)} bytes: {check}")
    code, _, err = processes.run([tps, "run", "--resume", "cut", "-q", "--max-events", str(events)], cwd=folder)
    if code == 3 and ("no full state" in err or "no complete line" in err):
        seen["said to hold no state"] += 1
        failures.expect(b'\n{"state"' not in cut.rpartition(b"\n")[0], f"a state is there: {err}")
        return
    seen["gone on"] += 1
    failures.expect(code == 0, f"resumed: {code}, {err}")
    failures.expect(events_of((folder / "cut").read_bytes()) == events_of(expected), "the trace gone on with is that of the run let alone")
    if "--checkpoint" in options and (folder / "kept").exists():
        code, _, err = processes.run([tps, "run", "--resume", "kept", "-q", "--max-events", "1"], cwd=folder)
        failures.expect(code == 0, f"the checkpoint: {code}, {err}")


def main():
    tps = os.path.abspath(sys.argv[1])
    kills = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    moments = random.Random(20261125)
    failures = processes.Failures()
    seen = collections.Counter()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        subprocess.run([tps, "scene", "gas", "--particles", "60", "--duration", "1e6", "-o", "scene"], cwd=folder, check=True)
        for name, options in RUNS.items():
            expected, seconds = whole(tps, folder, options, EVENTS[name])
            for _ in range(kills):
                killed_run(tps, folder, options, EVENTS[name], expected, moments.uniform(0, 1.2) * seconds, failures, seen)
        for mode in ("right", "hang", "fork_hang", "session_hang", "daemon_hang", "grandchildren", "deaf", "noisy", "flood_lines"):
            for _ in range(kills):
                marked = processes.Marked([tps, "properties", "--quiet", "--cases", "100000", "--timeout", "3000", "-o", "broken", "--", sys.executable,
                                           hostile_program.__file__, mode], cwd=folder)
                processes.wait_until(lambda: marked.left() or marked.process.poll() is not None, "it has a child")
                time.sleep(moments.uniform(0, 0.4))
                marked.process.send_signal(signal.SIGKILL)
                marked.end()  # fails where something is left
                failures.expect(True, "")
                seen["programs killed with their children"] += 1
        before = (folder / "whole").read_bytes()
        for _ in range(kills):
            marked = processes.Marked([tps, "check", "whole", "-q", "-o", "report"], cwd=folder)
            time.sleep(moments.uniform(0, 0.1))
            marked.process.send_signal(signal.SIGKILL)
            marked.end()
            failures.expect((folder / "whole").read_bytes() == before, "a check touches nothing")
            seen["checks killed"] += 1
    print(", ".join(f"{what}: {count}" for what, count in seen.items()))
    return failures.conclude(f"kills, {kills} of each kind")


if __name__ == "__main__":
    sys.exit(main())
