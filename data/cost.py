#!/usr/bin/env python3
"""Time and memory of every verb on input of growing size: data/cost.py [TPS] prints the table of docs/cost.md.

Each row is a verb on input of size 1, 10 and 100 (the unit is in the row); a run that takes longer than LIMIT seconds
is stopped and shown as such. Memory is the peak of the process."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
TPS = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else str(ROOT / "build/release/tps")
LIMIT = 20
SCALES = (1, 10, 100)


def gas(n, permanent=False):
    side = max(2, round(n ** (1 / 3) + 0.499))
    at = lambda k: [1.5 * (k % side), 1.5 * (k // side % side), 1.5 * (k // side ** 2)]
    speed = lambda k: [((k * 7919) % 101 - 50) / 100, ((k * 104729) % 89 - 44) / 100, ((k * 1299709) % 97 - 48) / 100]
    pair = {"between": ["A", "A"], "blocking": {"c_rebound": 1}}
    if permanent:
        pair["tethering"] = {"distance": 10.0 * side, "c_retract": 1, "c_revolve": 1, "theta_revolve_deg": 45, "form": "permanent"}
    return {"tps": 1, "dimension": 3, "duration": 1e9, "species": {"A": {"mass": 1, "radius": 0.5}}, "pairs": [pair],
            "particles": [{"species": "A", "position": at(k), "velocity": speed(k)} for k in range(n)]}


def phased(n):
    species = {f"S{k}": {"mass": 1, "radius": 0.5} for k in range(n)}
    tethering = {"distance": 2, "c_retract": 1, "c_revolve": 1, "theta_revolve_deg": 45}
    pairs = [{"between": [f"S{k}", f"S{k}"], "blocking": {"c_rebound": 1}, "tethering": tethering} for k in range(n)]
    phases = [{"between": [f"S{k}", f"S{k}"], "from": 1, "until": 2, "form": "never"} for k in range(n)]
    particles = [{"species": f"S{k}", "position": [3 * k, 0, 0], "velocity": [0, 0, 0]} for k in range(n)]
    return {"tps": 1, "dimension": 3, "duration": 10, "species": species, "pairs": pairs, "phases": phases, "particles": particles}


def memory_of(process):
    """Peak so far in megabytes. What wait4 reports includes this program, which the child was a copy of."""
    try:
        status = pathlib.Path(f"/proc/{process}/status").read_text()
    except OSError:
        return 0
    peak = [line.split()[1] for line in status.splitlines() if line.startswith("VmHWM")]
    return int(peak[0]) / 1024 if peak else 0


def measured(words, stdin=None):
    """Seconds and megabytes of a command, as text."""
    start = time.monotonic()
    child = subprocess.Popen([TPS, *map(str, words)], stdin=open(stdin, "rb") if stdin else subprocess.DEVNULL,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    peak = 0
    while True:
        peak = max(peak, memory_of(child.pid))
        pid, status, _ = os.wait4(child.pid, os.WNOHANG)
        seconds = time.monotonic() - start
        if pid:
            break
        if seconds > LIMIT:
            child.kill()
            os.wait4(child.pid, 0)
            return f"> {LIMIT} s"
        time.sleep(0.002)
    code = os.waitstatus_to_exitcode(status)
    note = "" if code == 0 else f" (exit {code})"
    return f"{seconds:.2f} s, {peak:.0f} MB{note}"


def repeated(path, lines_of, n):
    header, cases = lines_of
    with open(path, "w") as out:
        header = dict(header, count=n)
        out.write(json.dumps(header) + "\n")
        for k in range(n):
            out.write(cases[k % len(cases)])
    return path


def rows(folder):
    def scene(name, content):
        path = folder / name
        path.write_text(json.dumps(content))
        return path

    vectors = (ROOT / "data/vectors/block_time.plain.jsonl").read_text().splitlines(keepends=True)
    lines = json.loads(vectors[0]), vectors[1:]
    trace = folder / "gas.ndjson"
    small = folder / "small.json"
    subprocess.run([TPS, "scene", "gas", "--particles", "64", "--duration", "1e9", "-o", small], check=True)

    def run_of(events):
        subprocess.run([TPS, "run", "-q", small, "-o", trace, "--max-events", str(events)], check=True, stdout=subprocess.DEVNULL)
        return trace

    def requests(n):
        path = folder / "requests"
        path.write_text("".join(json.dumps({"seq": k, "op": "block_time", "in": json.loads(lines[1][k % len(lines[1])])["in"]}) + "\n"
                                for k in range(n)))
        return path

    def page(events):
        return measured(["view", "-q", run_of(events), "-o", folder / "page.html"])

    def boxed(edges):
        # Two particles that pass so many edges of a periodic box and never meet.
        along = {"species": "A", "position": [0, 0, 0], "velocity": [8 * edges / 3, 5.6 * edges / 3, 3.2 * edges / 3]}
        box = dict(gas(1), duration=1, box={"periodic": [8, 8, 8]}, particles=[along, {"species": "A", "position": [2, 3, 1], "velocity": [0, 0, 0]}])
        subprocess.run([TPS, "run", "-q", scene("s", box), "-o", trace], check=True, stdout=subprocess.DEVNULL)
        return trace

    def without_kicks(kicks):
        # A minimal trace in which gravity never acts.
        falling = dict(gas(1), duration=1, gravity={"acceleration": [0, 0, -1], "every": 1 / kicks})
        trace.write_text(json.dumps({"trace": 1, "form": "minimal", "scalar": "double", "scene": falling}) + "\n" + json.dumps({"end": "duration", "t": 1, "events": 0}) + "\n")
        return trace

    def one_body(balls):
        # A row of balls that becomes one body, pair by pair: its trace grows with the square of their number.
        subprocess.run([TPS, "scene", "cradle", "--particles", str(balls), "-o", folder / "row.json"], check=True)
        row = dict(json.loads((folder / "row.json").read_text()), grouping={"dt_restitute": 1}, duration=0.5)
        subprocess.run([TPS, "run", "-q", scene("s", row), "-o", trace], check=True, stdout=subprocess.DEVNULL)
        return trace

    def foreign(bodies):
        path = folder / "foreign.json"
        path.write_text(json.dumps({"species": {"a": {"mass": 1, "radius": 0.25}},
                                    "particles": {str(k): {"position": [k, 0, 0], "velocity": [1, 0, 0], "species": "a"} for k in range(bodies)}}))
        return path

    def one_request(particles):
        path = folder / "request"
        path.write_text(json.dumps({"seq": 1, "op": "next_event", "in": {"scene": gas(particles)}}) + "\n")
        return path

    yield "explain, 200 particles", lambda s: measured(["explain", scene("s", gas(200 * s))])
    yield "explain, 200 particles tethered for ever to each other", lambda s: measured(["explain", scene("s", gas(200 * s, True))])
    yield "explain, 100 species, pairs and phases", lambda s: measured(["explain", scene("s", phased(100 * s))])
    yield "run to the first event, 200 particles", lambda s: measured(["run", "-q", scene("s", gas(200 * s)), "--max-events", 1])
    yield "run, 64 particles, 1000 events", lambda s: measured(["run", "-q", small, "-o", trace, "--max-events", 1000 * s])
    yield "check, 1000 events", lambda s: measured(["check", "-q", run_of(1000 * s)])
    yield "check, a flight across 100 edges of a periodic box", lambda s: measured(["check", "-q", boxed(100 * s)])
    yield "check, 100 kicks of gravity missing", lambda s: measured(["check", "-q", without_kicks(100 * s)])
    yield "check, one body of 100, 316, 1000 made pair by pair", lambda s: measured(["check", "-q", one_body(round(100 * s ** 0.5))])
    yield "view, 1000 events", lambda s: page(1000 * s)
    yield "import, 100 bodies", lambda s: measured(["import", foreign(100 * s), "-o", folder / "imported.json"])
    yield "run --resume, behind 1000 events", lambda s: measured(["run", "-q", "--resume", run_of(1000 * s), "--max-events", 1000 * s])
    yield "draw, 200 particles", lambda s: measured(["draw", scene("s", gas(200 * s)), "-o", folder / "svg"])
    yield "scene gas, 200 particles", lambda s: measured(["scene", "gas", "--particles", 200 * s])
    yield "vectors verify, 100 cases", lambda s: measured(["vectors", "verify", repeated(folder / "v", lines, 100 * s)])
    yield "vectors requests, 100 cases", lambda s: measured(["vectors", "requests", repeated(folder / "v", lines, 100 * s)])
    yield "serve, 100 requests", lambda s: measured(["serve"], stdin=requests(100 * s))
    yield "serve, next_event of 10 particles", lambda s: measured(["serve"], stdin=one_request(10 * s))
    yield "properties, 10 cases of each law", lambda s: measured(["properties", "--quiet", "--cases", 10 * s])


def main():
    print("| verb and size 1 | size 1 | size 10 | size 100 |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, cost in rows(pathlib.Path(folder)):
            print(f"| {name} | " + " | ".join(cost(scale) for scale in SCALES) + " |", flush=True)


if __name__ == "__main__":
    main()
