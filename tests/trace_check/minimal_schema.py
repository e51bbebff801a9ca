"""The schema of minimal traces and the check agree: minimal_schema.py TPS SOURCES

A minimal trace of every kind of event, which the check accepts, is valid; and of each line, without one of its
keys or with one too many, both say the same."""
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

TPS, SOURCES = sys.argv[1], pathlib.Path(sys.argv[2])
with open(SOURCES / "data/schemas/minimal_trace.schema.json") as text:
    VALIDATOR = jsonschema.Draft202012Validator(json.load(text))
# An impulse, a phase, and a tether that forms and breaks.
SMALL = {
    "tps": 1, "dimension": 2, "duration": 9, "species": {"a": {"mass": 1, "radius": .5}},
    "pairs": [{"between": ["a", "a"], "blocking": {"c_rebound": 1},
               "tethering": {"distance": 2, "c_retract": 1, "c_revolve": 1, "theta_revolve_deg": 30, "form": "always"}}],
    "phases": [{"from": 0.5, "until": 8, "between": ["a", "a"], "break": "always"}],
    "impulses": [{"at": 1, "particle": 0, "impulse": [.5, .25]}],
    "particles": [{"species": "a", "position": [0, 0]}, {"species": "a", "position": [3, 0], "velocity": [-1, 0]}]}
SCENES = ["brownian", "sediment", "gas-drag", "gas-walls", "gas-periodic", "granular", "terminal",
          "terminal-action-potential", "three-body-grouped", "pair"]
# What a line needs by the scene, which its schema does not see.
BY_THE_SCENE = {"s", "spin", "tether"}
KINDS = ["rebound", "retract", "revolve", "break", "restitute", "wall", "gravity", "random_impulse", "thermostat",
         "scheduled_impulse", "phase_begin", "phase_end", "end"]
TOO_MANY = {"i": 0, "j": 1, "wall": 0, "face": 0, "phase": 0, "dv": [0, 0]}


def run(*arguments):
    return subprocess.run([TPS, *arguments], capture_output=True, text=True, timeout=120)


def minimal(line):
    if "trace" in line:
        return {"trace": 1, "form": "minimal", "scalar": line["scalar"], "semantics": 2, "positions": "lazy",
                "scene": line["scene"]}
    if "kind" not in line:
        return line
    small = {key: line[key] for key in ("t", "s", "kind", "i", "j", "tether", "phase", "wall", "face") if key in line}
    if "post" in line:
        small["post"] = {who: {key: state[key] for key in ("velocity", "spin") if key in state}
                         for who, state in line["post"].items()}
    return small


def changed(line):
    for key in line:
        if key not in BY_THE_SCENE:
            yield f"without {key}", {k: v for k, v in line.items() if k != key}
    for key, value in TOO_MANY.items():
        if "kind" in line and key not in line and (key, line["kind"]) != ("dv", "gravity"):
            yield f"with {key}", {**line, key: value}


def refuses(lines, file):
    file.write_text("".join(json.dumps(line) + "\n" for line in lines))
    done = run("check", "-q", "--format", "json", str(file))
    if not done.stdout:
        sys.exit(f"{lines[-2:]}: {done.stderr}")
    report = json.loads(done.stdout)
    return any(f["rule"] == "schema" for f in report["findings"])


def main():
    faults, kinds, compared = [], set(), 0
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "trace"
        scenes = [SOURCES / f"data/scenes/{name}.json" for name in SCENES]
        scenes.append(pathlib.Path(folder) / "small.json")
        scenes[-1].write_text(json.dumps(SMALL))
        for scene in scenes:
            run("run", "-q", "--max-events", "120", "-o", str(file), str(scene))
            lines = [json.loads(text) for text in file.read_text().splitlines()]
            lines = [minimal(line) for line in lines if "state" not in line]
            end = lines[-1]
            file.write_text("".join(json.dumps(line) + "\n" for line in lines))
            verdict = run("check", "-q", str(file))
            if verdict.returncode != 0:
                faults.append(f"{scene.name}: its minimal trace is refused\n{verdict.stdout[-600:]}")
            for number, line in enumerate(lines, 1):
                if not VALIDATOR.is_valid(line):
                    faults.append(f"{scene.name}:{number}: not valid: {json.dumps(line)[:300]}")
            for number, line in enumerate(lines):
                kind = line.get("kind", "end" if "end" in line else None)
                if kind is None or (kind in kinds and kind != "end"):
                    continue
                kinds.add(kind)
                for what, other in changed(line):
                    compared += 1
                    told = lines[:number] + [other] + ([end] if "kind" in line else [])
                    if refuses(told, file) == VALIDATOR.is_valid(other):
                        faults.append(f"{scene.name}: a {kind} {what}: the check "
                                      f"{'refuses' if VALIDATOR.is_valid(other) else 'takes'} it, the schema does not")
    missing = set(KINDS) - kinds
    if missing:
        faults.append(f"no scene has a {', a '.join(sorted(missing))}")
    print("\n".join(faults) or f"{compared} changed lines of {len(kinds)} kinds: schema and check agree")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
