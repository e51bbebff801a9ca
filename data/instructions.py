"""Instructions a question of each variant of `tps cost`, counted by callgrind: the same in every run on one machine.

instructions.py PROGRAM [--stratum NAME] [--variant NAME,…]     (needs valgrind; some seconds a variant)

What is counted is the loop that latency is timed in, which asks all questions in every call, and all that it calls. Valgrind computes long double in 64 bits,
so its count there is that of another arithmetic.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

LOOP = re.compile(r"tps::cost::latency<(.*)>\(std::span")


def loops_of(profile):
    """Name of each timed loop: (calls, instructions with all callees), from callgrind's file."""
    names, loops, callee, calls = {}, {}, None, 0
    for line in profile.splitlines():
        if line.startswith(("fn=", "cfn=")):
            number, _, name = line[line.index("=") + 1:].partition(" ")  # a name stands at its first mention only
            known = names.setdefault(number, name)
            callee = known if line[0] == "c" else callee
        elif line.startswith("calls="):
            calls = int(line[6:].split()[0])
        elif calls:
            found = LOOP.search(callee)
            if found:
                before = loops.get(found[1], (0, 0))
                loops[found[1]] = (before[0] + calls, before[1] + int(line.split()[1]))
            calls = 0
    return loops


def study_of(program, stratum, variant):
    with tempfile.TemporaryDirectory() as folder:
        profile = pathlib.Path(folder) / "profile"
        done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", program, "cost", "--quick", "--quiet", "--stratum", stratum,
                               "--variant", variant, "--questions", "1", "--repetitions", "1", "--json", "-"], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{program} cost --variant {variant} ended with {done.returncode}: {done.stderr[-500:]}")
        return json.loads(done.stdout), loops_of(profile.read_text())


def instructions(program, stratum, variant, baseline):
    study, loops = study_of(program, stratum, variant)
    own = {name: loop for name, loop in loops.items() if name != baseline} or loops
    [(name, (calls, counted))] = own.items()
    return name, counted / (calls * study["settings"]["timed"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--stratum", default="plain")
    parser.add_argument("--variant", default="")
    arguments = parser.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("valgrind is not installed; this command counts with it")
    study = json.loads(subprocess.run([arguments.program, "cost", "--quick", "--quiet", "--without-times", "--stratum", arguments.stratum, "--questions", "1",
                                       "--json", "-"], capture_output=True, text=True, check=True).stdout)
    names = arguments.variant.split(",") if arguments.variant else [v["name"] for v in study["variants"]]
    baseline, first = instructions(arguments.program, arguments.stratum, study["settings"]["baseline"], None)
    print(f"{'variant':24}{'instructions':>14}{'of printed':>12}", flush=True)
    for name in names:
        count = first if name == study["settings"]["baseline"] else instructions(arguments.program, arguments.stratum, name, baseline)[1]
        print(f"{name:24}{count:14.1f}{count / first:12.2f}", flush=True)


if __name__ == "__main__":
    main()
