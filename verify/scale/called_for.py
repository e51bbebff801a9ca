#!/usr/bin/env python3
"""What a scene does not call for costs nothing: for every effect of the catalogue the engine is built without its file, and runs
scenes that do not call for it under callgrind. Instructions of the loop may differ from those of the whole engine by 0.1 %.

  called_for.py BUILD [--only EFFECT ...] [--events N]     exit code 1 if an effect costs a scene that does not call for it
  called_for.py BUILD --prices [--write PAGE]              what it costs where it is called for, as a table

BUILD is the folder of a build (build/release) with the program and the library; compiled is what it has been compiled with. The catalogue is
the list of the files in reference/engine/effects/: a new one is covered, and needs a row in prices.py.
"""
import argparse
import concurrent.futures
import copy
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

from prices import PRICES, print_table

ROOT = pathlib.Path(__file__).resolve().parents[2]
EFFECTS = sorted(path.stem for path in (ROOT / "reference/engine/effects").glob("*.hpp"))
CATALOGUE = "reference/engine/effect_catalogue.hpp"
ALLOWED = 1e-3
# With its limit on the growth of a whole source g++ inlines in one function by the size of all others, so that any class less moves code
# that has nothing to do with it.
UNLIMITED = ["--param", "inline-unit-growth=100000", "--param", "ipa-cp-unit-growth=100000"]
SCENES = 3  # that do not call for an effect


def capture(command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **more)
    if done.returncode:
        sys.exit(f"called_for.py: {shlex.join(map(str, command))} ended with exit code {done.returncode}:\n{done.stderr[-3000:]}")
    return done.stdout


class Engines:
    """The loop alone, whole and without one effect each."""

    def __init__(self, build):
        self.build, self.work = build.resolve(), (build / "called_for").resolve()
        commands = json.loads((build / "compile_commands.json").read_text())
        engine = next(c for c in commands if "run_double" in c["file"] and "/reference/" in c["file"])
        words = shlex.split(engine["command"])
        start = next(n for n, word in enumerate(words) if word.endswith("++") or word.endswith("++-12"))
        end = words.index("-o")
        self.compiler = [word for word in words[start:end] if word != "-Werror"]
        if "clang" not in self.compiler[0]:
            self.compiler += UNLIMITED
        self.whole = self.compile("whole", None)

    def compile(self, name, without):
        folder = self.work / name
        folder.mkdir(parents=True, exist_ok=True)
        words, include = list(self.compiler), []
        if without:
            text = (self.build / "generated" / CATALOGUE).read_text()
            kept = [line for line in text.splitlines() if f"effects/{without}.hpp" not in line and f"effects::{without}{{}}" not in line]
            catalogue = "\n".join(kept).replace(f"effects::{without}::call(scene), ", "")
            for path, content in ((CATALOGUE, catalogue), (f"reference/engine/effects/{without}.hpp", "#error This build has no such file.")):
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                (folder / path).write_text(content + "\n")
            include = ["-I" + str(folder)]
        program = folder / "engine_loop"
        capture([words[0], *include, *words[1:], "-g0", ROOT / "verify/scale/engine_loop.cpp", "-o", program,
                 "-Wl,--start-group", self.build / "reference/libtps_reference.a", self.build / "reference/libtps_reference_scalars.a",
                 "-Wl,--end-group", "-lfmt"], cwd=self.build)
        return program


def instructions(program, scene, events, work):
    out = work / f"callgrind.{os.getpid()}.{program.parent.name}.{scene.stem}"
    told = capture(["valgrind", "--tool=callgrind", "--toggle-collect=*engine_loop*", f"--callgrind-out-file={out}", program, scene, events])
    total = int(re.search(r"^(?:totals|summary): (\d+)", out.read_text(), re.M)[1])
    out.unlink()
    return total, int(told.split()[0])


def called_by(tps, scene):
    return {effect["name"] for effect in json.loads(capture([tps, "explain", scene, "--format", "json"]))["effects"] if effect["simulated"]}


def without_blocking(scene):
    """Tethers alone."""
    scene = copy.deepcopy(scene)
    scene["pairs"] = [{k: v for k, v in pair.items() if k != "blocking"} for pair in scene["pairs"] if "tethering" in pair]
    return scene


def falling(scene):
    return {**copy.deepcopy(scene), "gravity": {"acceleration": [0, 0, -1], "every": 0.05}}


def candidates(tps, work):
    """Scenes in many ways: those of data/scenes, tethers without blocking, and a gas between walls that falls."""
    paths = sorted((ROOT / "data/scenes").glob("*.json"), key=lambda path: -path.stat().st_size)
    paths = [path for path in paths if json.loads(path.read_text()).get("dimension", 3) == 3]  # compiled for space alone
    changed = [(name, "tethers-alone", without_blocking) for name in ("chain", "sheet", "sheet-touching")] + [("gas-walls", "falling", falling)]
    for name, suffix, change in changed:
        path = work / f"{name}-{suffix}.json"
        path.write_text(json.dumps(change(json.loads((ROOT / f"data/scenes/{name}.json").read_text()))))
        paths.append(path)
    return [(path, called_by(tps, path)) for path in paths]


def check(build, only, events):
    engines, tps = Engines(build), build / "tps"
    scenes = candidates(tps, engines.work)
    whole, faults = {}, []
    print(f"| effect | {' | '.join(f'scene {n + 1}' for n in range(SCENES))} |\n|---|{'---|' * SCENES}")
    for effect in only or EFFECTS:
        apart = [path for path, called in scenes if effect not in called][:SCENES]
        if len(apart) < SCENES:
            sys.exit(f"called_for.py: fewer than {SCENES} scenes of data/scenes do not call for {effect}; add one")
        program, cells = engines.compile(f"without_{effect}", effect), []
        asked = [(program, scene) for scene in apart] + [(engines.whole, scene) for scene in apart if scene not in whole]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            counts = list(pool.map(lambda pair: instructions(*pair, events, engines.work), asked))
        whole.update({scene: count for (program_of, scene), count in zip(asked, counts) if program_of == engines.whole})
        for scene, (count, done) in zip(apart, counts):
            all_of_it, whole_done = whole[scene]
            more = all_of_it / count - 1
            cells.append(f"{scene.stem}: {more:+.4%} of {count / 1e6:.1f} M in {done} events")
            if abs(more) > ALLOWED or done != whole_done:
                faults.append(f"{effect} costs {scene.name}, which does not call for it: {all_of_it} instructions in {whole_done} events, "
                              f"without its file {count} in {done}; allowed: {ALLOWED:.1%}")
        print(f"| {effect} | {' | '.join(cells)} |", flush=True)
    for fault in faults:
        print(f"called_for.py: {fault}", file=sys.stderr)
    return 1 if faults else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", nargs="*", choices=EFFECTS)
    parser.add_argument("--events", type=int, default=1500)
    parser.add_argument("--prices", action="store_true")
    parser.add_argument("--write", type=pathlib.Path)
    options = parser.parse_args()
    missing = set(EFFECTS) ^ set(PRICES)
    if missing:
        sys.exit(f"called_for.py: PRICES and the catalogue differ in {', '.join(sorted(missing))}; every effect needs a row")
    if options.prices:
        return print_table(Engines(options.build).whole, options.build, options.write)
    return check(options.build, options.only, options.events)


if __name__ == "__main__":
    sys.exit(main())
