#!/usr/bin/env python3
"""Pressure and collision rate of hard spheres in a periodic box, against Carnahan and Starling, and Enskog.

hard_spheres.py TPS [--particles N] [--duration T] [--seed S]

Prints a table in Markdown: each density's values with the standard error of twenty blocks, and how many of them it is off.
The first tenth of a run is left out: the lattice of the start melts.
"""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

BLOCKS = 20


def number(text):
    return float.fromhex(text)


def blocks_of(trace, duration, kinetic):
    """Virial and rate of a particle, a value a block."""
    with open(trace, encoding="utf-8") as lines:
        scene = json.loads(next(lines))["scene"]
        edge, count = scene["box"]["periodic"][0], len(scene["particles"])
        kT = 2 * kinetic / (3 * (count - 1))
        start = duration / 10
        length = (duration - start) / BLOCKS
        virial, rate = [1.0] * BLOCKS, [0.0] * BLOCKS
        for line in lines:
            event = json.loads(line)
            if event.get("kind") != "rebound" or number(event["t"]) < start:
                continue
            block = min(int((number(event["t"]) - start) / length), BLOCKS - 1)
            u_i, u_j = ([number(x) for x in event["pre"][str(event[key])]["position"]] for key in ("i", "j"))
            r_dp = sum(-math.remainder(b - a, edge) * number(dp) for a, b, dp in zip(u_i, u_j, event["dp"]))
            virial[block] += r_dp / (3 * count * kT * length)
            rate[block] += 2 / (count * length)
    return virial, rate, kT, count / edge**3


def estimate(blocks):
    mean = sum(blocks) / len(blocks)
    return mean, math.sqrt(sum((x - mean) ** 2 for x in blocks) / (len(blocks) * (len(blocks) - 1)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tps")
    parser.add_argument("--particles", type=int, default=500)
    parser.add_argument("--duration", type=float, default=20)
    parser.add_argument("--seed", type=int, default=1)
    a = parser.parse_args()
    print("| ρ | Z | Carnahan–Starling | off by | rate | Enskog | off by | collisions |\n|---|---|---|---|---|---|---|---|")
    for density in (.5, .7):
        with tempfile.TemporaryDirectory() as folder:
            scene, trace = pathlib.Path(folder, "gas.json"), pathlib.Path(folder, "gas.ndjson")
            subprocess.run([a.tps, "scene", "gas", "--periodic", "1", "--particles", str(a.particles), "--density", str(density),
                            "--duration", str(a.duration), "--seed", str(a.seed), "-o", scene], check=True)
            done = subprocess.run([a.tps, "run", scene, "--format", "json", "-o", trace], check=True, capture_output=True, text=True)
            summary = json.loads(done.stdout)
            virial, rate, kT, rho = blocks_of(trace, a.duration, summary["energy"]["kinetic_at_start"])
        eta = math.pi / 6 * rho
        carnahan_starling = (1 + eta + eta**2 - eta**3) / (1 - eta) ** 3
        enskog = 4 * math.sqrt(math.pi * kT) * rho * (1 - eta / 2) / (1 - eta) ** 3
        z, z_error = estimate(virial)
        g, g_error = estimate(rate)
        print(f"| {density} | {z:.4f} ± {z_error:.4f} | {carnahan_starling:.4f} | {(z - carnahan_starling) / z_error:+.1f} SE | "
              f"{g:.3f} ± {g_error:.3f} | {enskog:.3f} | {(g - enskog) / g_error:+.1f} SE | {summary['events']} |")


if __name__ == "__main__":
    main()
