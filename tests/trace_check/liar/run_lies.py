#!/usr/bin/env python3
"""Tells every lie to `tps check`, which has to catch each by its rule and to accept the honest run of the same scene.

  run_lies.py TPS [--only NAME] [--seeds N] [--share K/N] [--half honest | lies] [--known NAME,…] [--keep DIR]
  run_lies.py TPS --list | --page docs/lies.md
"""
import argparse
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
# Each registers its lies.
import lies_of_misses, lies_of_time, lies_of_order, lies_of_impulse, lies_of_groups, lies_of_tethers, lies_of_state, lies_of_ends  # noqa: E401,F401
from lie import LIES
from liars_scenes import SCENES
from simulator import Simulator


def judged(tps, text):
    """Exit code and the rules that are violated."""
    done = subprocess.run([tps, "check", "-q", "--format", "json", "-"], input=text.encode(), capture_output=True, timeout=60)
    try:
        report = json.loads(done.stdout)
    except ValueError:
        return done.returncode, set(), done.stderr.decode()[:200]
    first = next((f"line {f['line']}, {f['rule']}: {f['message']}" for f in report["findings"] if f["outcome"] == "violated"), "")
    return done.returncode, {r["rule"] for r in report["rules"] if r["violated"]}, first


class Trial:
    def __init__(self, options):
        self.options, self.wrong, self.caught, self.honest, self.rules = options, [], {}, {}, {}

    def complain(self, name, form, seed, what, text):
        place = ""
        if self.options.keep:
            place = pathlib.Path(self.options.keep) / f"{name.replace('/', '-')}-{form}-{seed}.ndjson"
            place.write_text(text)
        self.wrong.append(f"{name} ({form}, seed {seed}): {what} {place}")

    def honest_run(self, scene, timing, seed, events):
        key = (scene, timing, seed, events)
        if key in self.honest:
            return
        self.honest[key] = True
        out = Simulator(SCENES[scene](seed), timing).run(events)
        for form in ("full", "minimal"):
            text = out.text(form == "minimal")
            code, _, first = judged(self.options.tps, text)
            if code:
                self.complain(f"honest {scene}/{timing}", form, seed, f"check exits {code}, 0 is right; {first}", text)

    def tell(self, lie, scene, timing, seed):
        """Whether the lie could be told."""
        if self.options.half != "lies":
            self.honest_run(scene, timing, seed, lie.until)
        if self.options.half == "honest":
            return True
        liar = lie(2 + seed % 5)
        out = Simulator(SCENES[scene](seed), timing, lie=liar).run(lie.until)
        if not liar.told:
            return False
        for form in ("full", "minimal") if lie.minimal else ("full",):
            text = out.text(form == "minimal")
            code, rules, first = judged(self.options.tps, text)
            self.rules.setdefault(lie.name, set()).update(rules & lie.rules)
            if code != 1:
                self.complain(f"{lie.name}/{scene}/{timing}", form, seed, f"check exits {code}, 1 is right; {first}", text)
            elif form == "full" and not rules & lie.rules:
                self.complain(f"{lie.name}/{scene}/{timing}", form, seed, f"caught by {sorted(rules)}, not by {sorted(lie.rules)}; {first}", text)
            self.caught[lie.name] = self.caught.get(lie.name, 0) + 1
        return True

    def tell_all(self, lie):
        told = 0
        for timing in lie.timings:
            for scene in lie.scenes:
                told += sum(self.tell(lie, scene, timing, seed) for seed in range(self.options.seeds))
        if told < self.options.seeds:
            self.wrong.append(f"{lie.name}: told only {told} times; its scenes do not fit it")


def table():
    """The lies and their rules, as docs/lies.md has them."""
    rows = ["| lie | what | one of these rules |", "|---|---|---|"]
    for name, lie in LIES.items():
        what = " ".join((lie.__dict__.get("__doc__") or "").split()).replace("|", "\\|")
        rows.append(f"| {name.replace('_', ' ')} | {what} | {', '.join(sorted(lie.rules))} |")
    return "\n".join(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tps")
    parser.add_argument("--only", help="one lie, by its name")
    parser.add_argument("--seeds", type=int, default=2, help="scenes of each kind")
    parser.add_argument("--share", default="0/1", help="K/N: every Nth lie from the Kth, for tests in parallel")
    parser.add_argument("--half", choices=("honest", "lies"), help="only the honest runs of the lies' scenes, or only the lies")
    parser.add_argument("--known", default="", help="lies that are not caught yet; one that is fails, so that the list shrinks")
    parser.add_argument("--keep", help="a folder for the traces of what went wrong")
    parser.add_argument("--list", action="store_true", help="the lies and their rules, as a table")
    parser.add_argument("--page", help="fails unless this page has that table")
    options = parser.parse_args()
    if options.list:
        print(table())
        return 0
    if options.page:
        same = table() in pathlib.Path(options.page).read_text()
        print("" if same else f"the table of {options.page} is not what run_lies.py --list prints")
        return not same
    share, of = map(int, options.share.split("/"))
    names = [options.only] if options.only else sorted(LIES)[share::of]
    trial, known = Trial(options), set(filter(None, options.known.split(",")))
    for name in names:
        before = len(trial.wrong)
        trial.tell_all(LIES[name])
        if name in known:
            trial.wrong[before:] = [] if len(trial.wrong) > before else [f"{name}: is caught now, and no longer a known gap"]
    print(*trial.wrong, sep="\n")
    print(f"{len(names)} lies, {sum(trial.caught.values())} told, {len(trial.honest)} honest scenes, {len(trial.wrong)} wrong")
    return bool(trial.wrong)


if __name__ == "__main__":
    sys.exit(main())
