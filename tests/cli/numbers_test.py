"""Every option of every verb, as --help has them, with what is no value of it: a message and exit code 2; never another
code, a crash or a wait. Arguments: the program, [--all]: every value for every option, which takes three times as long;
without it each option meets a third of them, and the next option another third."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import processes

BAD_NUMBERS = ["nan", "NAN", "-nan", "nan(1)", "-inf", "-2", "1e400", "-1e400", "", " ", "x", "1x", "0x", "1,5", "1e", "--", "٣", "99999999999999999999999"]
MAYBE = {"inf", "0", "1e308", "1e-320", "18446744073709551615", "0x1p3"}  # taken by some, refused by others
# Options whose values are words or names, of files and the like; all others are numbers.
WORDS = {"-h", "--help", "--version", "-o", "--output", "--format", "--checkpoint", "--resume", "--scene", "--witness", "--law", "--library", "--regressions",
         "--replay", "--in", "--op", "--stratum", "--answers", "--list", "--quiet", "-q", "--why", "--without-random-impulses", "--bitwise", "--trust-draws", "--scalar", "--timing", "--detector",
         "--profile", "--expect-fail", "--hypotheses", "--runs", "--hazards", "--simulator", "--quick", "--variant", "--without-times", "--from", "--json", "--csv",
         "--page", "--view", "--responses", "--model", "--hard-cases", "--queries", "--case"}
# Of a verb what it needs besides.
NEEDED = {"run": ["scene"], "check": ["trace"], "explain": ["scene"], "draw": ["trace"], "import": ["scenario"], "eval": ["load", "--in", "input"],
          "vectors verify": ["vectors"], "vectors requests": ["vectors"], "properties": ["--law", "Eq6Laws.Law1*", "--cases", "1"],
          "cost": ["--queries", "--quick", "--variant", "printed-double", "--stratum", "plain"],
          "vectors generate": ["--op", "load", "--level", "1"]}
# Numbers that are words, too, and options that take numbers as words of their own (a count of zero particles is none).
TAKES = {("run", "--until", "99999999999999999999999"), ("draw", "--at", "99999999999999999999999"), ("import", "--duration", "99999999999999999999999")}


def help_of(tps, words):
    return subprocess.run([tps, *words, "--help"], capture_output=True, text=True, check=True).stdout


def verbs_of(tps):
    for verb in re.findall(r"^  (\w+) ", help_of(tps, []).split("Subcommands:")[1], re.M):
        subs = help_of(tps, [verb])
        if "Subcommands:" in subs:
            for sub in re.findall(r"^  ([\w-]+) ", subs.split("Subcommands:")[1], re.M):
                yield [verb, sub]
        else:
            yield [verb]


def options_of(text):
    for line in text.splitlines():
        match = re.match(r"^  (-\w(?:,--[\w-]+)?|--[\w-]+)(.*)", line)
        if match:
            yield match.group(1).split(",")[-1], match.group(2)


def main():
    tps = os.path.abspath(sys.argv[1])
    every = "--all" in sys.argv
    failures = processes.Failures()
    processes.adopt_orphans()
    seen = set()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        subprocess.run([tps, "scene", "pair", "-o", "scene"], cwd=folder, check=True)
        subprocess.run([tps, "run", "scene", "-q", "-o", "trace"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        subprocess.run([tps, "vectors", "generate", "--op", "load", "--level", "1", "-o", "folder"], cwd=folder, check=True)
        (folder / "vectors").write_bytes(next((folder / "folder").iterdir()).read_bytes())
        (folder / "input").write_text('{"m_A":1,"m_B":2,"v_A":[1,0],"v_B":[0,0]}')
        (folder / "scenario").write_text("{}")

        def tried(verb, option, value):
            words = [tps, *verb, *NEEDED.get(" ".join(verb), []), f"{option}={value}"]
            return processes.run(words, cwd=folder)

        for verb in verbs_of(tps):
            for option, rest in options_of(help_of(tps, verb)):
                numeric = option not in WORDS
                if not numeric and option not in ("--format", "--scalar", "--timing", "--detector", "--op", "--stratum"):
                    continue
                if not numeric and verb == ["eval"] and option == "--op":
                    continue
                seen.add((" ".join(verb), option))
                share = slice(None) if every else slice(len(seen) % 3, None, 3)
                for value in BAD_NUMBERS[share]:
                    if (" ".join(verb), option, value) in TAKES:
                        continue
                    code, out, err = tried(verb, option, value)
                    large = value == "99999999999999999999999" and code in (0, 3)  # a real number like others
                    failures.expect(code == 2 and err.strip() or large, f"{' '.join(verb)} {option}={value!r}: {code}, {err[:200]}")
                for value in MAYBE if numeric else ():
                    if value in ("0x1p3", "18446744073709551615", "1e308") and verb[0] == "scene":
                        continue  # as many particles as are asked for
                    if option in ("--cases", "--minutes") and value not in ("0", "inf", "1e308"):
                        continue  # as many as are asked for
                    code, out, err = tried(verb, option, value)
                    failures.expect(code in (0, 1, 2, 3, 5, 8) and (code in (0, 1, 5) or err.strip()), f"{' '.join(verb)} {option}={value}: {code}, {err[:200]}")
        failures.expect(len(seen) > 60, f"the options are found in --help: {len(seen)}")

        cases = {
            "properties --": 2, "properties --cases 1 --": 2, "properties -- ''": 2, "properties --list --": 2,
            "vectors verify vectors --answers ''": 2, "properties --library ''": 2, "check trace --scene ''": 2, "run scene -o ''": 2,
            "properties --replay .": 3, "properties --replay /nowhere": 3, "scene terminal --duration inf": 2,
            "properties --runs --law Nix": 2, "properties --runs --bits 24": 2, "properties --timing paper": 2, "properties --runs --scalar certified": 2,
            "properties --runs --scalar mp50 --law Momentum": 5, "properties --runs --cases 1 --law Names -- false": 4,
        }
        for text, expected in cases.items():
            words = [word if word != "''" else "" for word in text.split()]
            code, out, err = processes.run([tps, *words], cwd=folder)
            failures.expect(code == expected and err, f"{text}: {code}, {err[:200]}")
        name_paths(tps, folder, failures)
    return failures.conclude("values of options")


def name_paths(tps, folder, failures):
    """Paths that lead nowhere, as each input (3) and each output (7)."""
    (folder / "loop").symlink_to("pool")
    (folder / "pool").symlink_to("loop")
    (folder / "dangling").symlink_to("/nowhere/at/all")
    paths = ["loop", "dangling", "a" * 300, "/".join(["b" * 200] * 30), "scene/inside", "loop/inside", "/nowhere/at/all", "nul", "."]
    if os.getuid() != 0:  # nothing is forbidden to root
        (folder / "secret").write_text("")
        (folder / "secret").chmod(0)
        paths.append("secret")
    reads = ["run {}", "run --resume {} -o made", "explain {}", "check {}", "check trace --scene {}", "draw {}", "import {}", "eval load --in {}", "vectors verify {}",
             "vectors requests {}", "vectors verify vectors --answers {}", "properties --replay {}"]
    writes = ["run scene -q -o {}", "run scene -q --checkpoint {}", "draw trace -o {}", "check trace -o {}", "scene pair -o {}",
              "run --resume trace -q -o {}"]
    for path in paths:
        for text in reads:
            code, out, err = processes.run([tps, *(word.format(path) for word in text.split())], cwd=folder)
            failures.expect(code == 3 and err, f"{text.format(path[:50])}: {code}, {err[:200]}")
        for text in writes:
            if path == "nul":
                continue
            code, out, err = processes.run([tps, *(word.format(path) for word in text.split())], cwd=folder)
            failures.expect(code == 7 and err, f"{text.format(path[:50])}: {code}, {err[:200]}")
    code, out, err = processes.run([tps, "vectors", "generate", "--op", "load", "--level", "1", "-o", "scene"], cwd=folder)
    failures.expect(code == 7 and err, f"vectors generate -o FILE: {code}, {err[:200]}")


if __name__ == "__main__":
    sys.exit(main())
