#!/usr/bin/env python3
"""Runs tps_bench_engine and plots the cost of an event against the number of particles.

scaling.py PROGRAM FOLDER [--filter REGEX]

Writes FOLDER/scaling.json (Google Benchmark's own) and FOLDER/scaling.svg, and prints a table.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 760, 440, 70, 20, 200, 50
COLOURS = ("#1b6ca8", "#c0392b", "#2d8a4e", "#8e44ad", "#d68910", "#117a8b", "#7f8c8d", "#34495e", "#a04000", "#6c3483")


def measured(program, out, pattern):
    command = [program, "--benchmark_out=" + str(out), "--benchmark_out_format=json"]
    if pattern:
        command.append("--benchmark_filter=" + pattern)
    subprocess.run(command, check=True, stdout=sys.stderr)
    return json.loads(out.read_text())["benchmarks"]


def series_of(benchmarks):
    """name without the size -> [(particles, microseconds an event, benchmark)]"""
    series = {}
    for b in benchmarks:
        parts = b["name"].split("/")
        kind = [p for p in parts[1:] if not p.isdigit() and not p.startswith("iterations")]
        name = " ".join([parts[0]] + kind)
        series.setdefault(name, []).append((b["particles"], 1e6 / b["items_per_second"], b))
    return {name: sorted(points, key=lambda p: p[0]) for name, points in series.items()}


def svg(series):
    xs = [p[0] for points in series.values() for p in points]
    ys = [p[1] for points in series.values() for p in points]
    x_low, x_high = math.floor(math.log10(min(xs))), math.ceil(math.log10(max(xs)))
    y_low, y_high = math.floor(math.log10(min(ys))), math.ceil(math.log10(max(ys)))

    def x(n):
        return LEFT + (math.log10(n) - x_low) / max(1, x_high - x_low) * (WIDTH - LEFT - RIGHT)

    def y(cost):
        return HEIGHT - BOTTOM - (math.log10(cost) - y_low) / max(1, y_high - y_low) * (HEIGHT - TOP - BOTTOM)

    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for e in range(x_low, x_high + 1):
        lines.append(f'<line x1="{x(10**e):.1f}" y1="{TOP}" x2="{x(10**e):.1f}" y2="{HEIGHT - BOTTOM}" stroke="#ddd"/>'
                     f'<text x="{x(10**e):.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">10^{e}</text>')
    for e in range(y_low, y_high + 1):
        lines.append(f'<line x1="{LEFT}" y1="{y(10**e):.1f}" x2="{WIDTH - RIGHT}" y2="{y(10**e):.1f}" stroke="#ddd"/>'
                     f'<text x="{LEFT - 8}" y="{y(10**e) + 4:.1f}" text-anchor="end">10^{e}</text>')
    lines.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle">particles</text>')
    lines.append(f'<text x="16" y="{HEIGHT / 2}" transform="rotate(-90 16 {HEIGHT / 2})" text-anchor="middle">µs an event</text>')
    for n, (name, points) in enumerate(series.items()):
        colour = COLOURS[n % len(COLOURS)]
        path = " ".join(f"{x(p[0]):.1f},{y(p[1]):.1f}" for p in points)
        lines.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        lines += [f'<circle cx="{x(p[0]):.1f}" cy="{y(p[1]):.1f}" r="3" fill="{colour}"/>' for p in points]
        lines.append(f'<text x="{WIDTH - RIGHT + 12}" y="{TOP + 14 + 18 * n}" fill="{colour}">{name}</text>')
    return "\n".join(lines + ["</svg>"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--filter", default="", help="a regular expression: these benchmarks only")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    series = series_of(measured(arguments.program, arguments.folder / "scaling.json", arguments.filter))
    (arguments.folder / "scaling.svg").write_text(svg(series))
    print(f"{'system':28} {'particles':>9} {'events/s':>10} {'µs/event':>9} {'queries/event':>13} {'bytes/particle':>14}")
    for name, points in series.items():
        for particles, cost, b in points:
            print(f"{name:28} {particles:9.0f} {1e6 / cost:10.0f} {cost:9.2f} {b['queries_per_event']:13.1f} "
                  f"{b.get('bytes_per_particle', 0):14.0f}")


if __name__ == "__main__":
    main()
