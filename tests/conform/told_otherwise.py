#!/usr/bin/env python3
"""A simulator of effects that knows its scene a little otherwise than it is told, and is wrong in nothing else: the run of another scene as a
minimal trace.

  told_otherwise.py TPS LIE SCENE > TRACE, LIE one of LIES
"""
import json
import math
import pathlib
import subprocess
import sys


def number(x):
    return float.fromhex(x) if isinstance(x, str) and x.lstrip("-").startswith("0x") else float(x)


def changed(kind, key, change):
    """The lie that each `kind` of the scene has another number at `key`."""
    def lie(scene):
        for each in kind(scene):
            each[key] = change(number(each[key]))
    return lie


def times(factor):
    return lambda x: factor * x


def of_species(name):
    return lambda scene: [species[name] for species in scene["species"].values() if name in species]


def of_pairs(name):
    return lambda scene: [pair[name] for pair in scene["pairs"] if name in pair]


def shapes(name):
    return lambda scene: [wall[name] for wall in scene["walls"] if name in wall]


def corner(which, side):
    """A box whose corner is moved by a ten-thousandth of its size along the last axis."""
    def lie(scene):
        for box in (scene["walls"][which]["box"],):
            low, high = number(box["low"][-1]), number(box["high"][-1])
            box[side][-1] = number(box[side][-1]) + (high - low) * 1e-4
    return lie


def no_spins(scene):
    for particle in scene["particles"]:
        particle.pop("spin", None)


def longer(scene):
    scene["box"]["periodic"] = [edge if edge == "inf" else 1.0001 * number(edge) for edge in scene["box"]["periodic"]]


def turned(scene):
    scene["gravity"]["acceleration"] = [-number(g) for g in scene["gravity"]["acceleration"]]


#: LIE → the word of --features whose scenes show it, and what it does to a scene.
LIES = {
    "gravity_stronger": ("gravity", lambda scene: scene["gravity"].update(acceleration=[1.001 * number(g) for g in scene["gravity"]["acceleration"]])),
    "gravity_upwards": ("gravity", turned),
    "gravity_seldom": ("gravity", changed(lambda scene: [scene["gravity"]], "every", times(1.001))),
    "kicks_stronger": ("random-impulses", changed(of_species("random_impulses"), "mean", times(1.001))),
    "kicks_seldom": ("random-impulses", changed(of_species("random_impulses"), "tau", times(1.001))),
    "kicks_wider": ("random-impulses", changed(of_species("random_impulses"), "shape", times(1.01))),
    "hotter": ("thermostat", changed(of_species("thermostat"), "kT", times(1.001))),
    "thermostat_seldom": ("thermostat", changed(of_species("thermostat"), "tau", times(1.001))),
    "drag_stronger": ("drag", changed(lambda scene: [scene["drag"]], "gamma", times(1.001))),
    "friction_larger": ("friction", changed(of_pairs("friction"), "mu", times(1.001))),
    "friction_never_sticks": ("friction", changed(of_pairs("friction"), "mu", times(1e-3))),
    "friction_elastic": ("friction", changed(of_pairs("friction"), "beta0", lambda x: min(1.0, x + 1e-3))),
    "spins_forgotten": ("friction", no_spins),
    "walls_softer": ("walls", changed(lambda scene: scene["walls"], "c_rebound", lambda c: max(0.0, c - 1e-3))),
    "post_thicker": ("walls", changed(shapes("sphere"), "radius", times(1.001))),
    "wall_moved": ("walls", corner(0, "high")),
    "block_taller": ("block", corner(1, "low")),
    "box_longer": ("periodic", longer),
}


def plain(line):
    """An event or the end of a full trace as a minimal one has it."""
    kept = {key: line[key] for key in ("kind", "i", "j", "tether", "wall", "face", "phase", "end", "events") if key in line}
    for key in ("t", "s"):
        if key in line:
            kept[key] = math.fsum(map(number, line[key])) if isinstance(line[key], list) else number(line[key])
    if "post" in line:
        kept["post"] = {who: {key: state[key] for key in ("velocity", "spin") if key in state} for who, state in line["post"].items()}
    return kept


def main():
    tps, lie, path = sys.argv[1:]
    scene = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    if lie != "none":
        LIES[lie][1](scene)
    done = subprocess.run([tps, "run", "-q", "-", "-o", "-", "--max-events", "1000"], input=json.dumps(scene), capture_output=True, text=True)
    if done.returncode == 3:
        sys.exit(done.stderr or 3)
    print('{"trace":1,"form":"minimal","semantics":2,"positions":"lazy"}')
    for text in done.stdout.splitlines()[1:]:
        line = json.loads(text)
        if "state" not in line:
            print(json.dumps(plain(line)))


if __name__ == "__main__":
    main()
