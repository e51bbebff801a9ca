"""Each law of wall_time, drag_time and rough_impulse holds of the adapter in Python, and is broken by a wrong one made for it.

  effect_laws_test.py TPS SOURCE

LAWS has for each law a text of data/adapters/python/effects.py and what stands there instead; `tps properties` has to find a case that breaks
the law. A law of these operations without a row is a fault.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TIME = '"t": gap / towards}'
CLOCK = "-math.log1p(-gamma * s) / gamma}"
ACROSS = "across = [factor * x if sticks else most * (x / slip) for x in g]"
BOTH = """import effects, timing  # one law asks block_time, too
from protocol import serve
serve("Python, effects and times", {**timing.OPERATIONS, **effects.OPERATIONS})
"""
LAWS = {  # law: (text, replacement, what is wrong)
    "WallLaws.Law1TheWayFlownIsTheGap": (TIME, '"t": gap}', "the distance from the plane instead of the time to it"),
    "WallLaws.Law2AwayFromBoundariesTheVerdictIsRight": ('"overlap" if gap < 0 else "contact"', '"hit"', "every event is a hit"),
    "WallLaws.Law3PowersOfTwo": ("if gap <= 0:", "if gap <= 1e-3:", "a tolerance that is a length"),
    "WallLaws.Law4Reflections": ("towards = -dot(normal, v)", "towards = -dot([abs(x) for x in normal], v)", "the sense of the normal lost"),
    "WallLaws.Law5LinearInTheDistance": (" - L\n", "\n", "the centre instead of the surface of the particle"),
    "WallLaws.Law6HeadOnItIsTheBlockTime": (TIME, '"t": 2 * gap / towards}', "twice the time"),
    "DragLaws.Law1AtTheStartBothAreZero": (CLOCK, CLOCK.replace("}", " + 1e-12}"), "a small number added, against a division by zero"),
    "DragLaws.Law2IsTheInverse": (CLOCK, "s * (1 + gamma * s / 2)}", "the first two terms of the series"),
    "DragLaws.Law3ReachedBeforeTheEndAlone": ("if gamma * s >= 1:", "if gamma * s >= 0.75:", "the end too early"),
    "DragLaws.Law4RisesWithS": (CLOCK, "s * (1 - gamma * s)}", "a parabola"),
    "DragLaws.Law5BetweenItsLimits": (CLOCK, "-math.expm1(-gamma * s) / gamma}", "s of t instead of t of s"),
    "DragLaws.Law6PowersOfTwo": (CLOCK, CLOCK.replace(" / gamma", ""), "the logarithm not divided by γ"),
    "RoughLaws.Law1TheImpulseIsOfBothEquations": ("(1 + beta0) * K", "beta0 * K", "β₀ instead of 1 + β₀"),
    "RoughLaws.Law2TheSmallerLimitDecides": ("sticks = factor * slip <= most", "sticks = True", "surfaces always hold"),
    "RoughLaws.Law3MomentumIsConserved": ('pair["v_B"], dp)', 'pair["v_B"], normal)', "friction turns and does not push"),
    "RoughLaws.Law4AngularMomentumAboutTheContactIsConserved": ("cross(n, across)", "cross(across, n)", "spins turn the other way"),
    "RoughLaws.Law5EnergyNeverGrows": (ACROSS, ACROSS.replace("factor * x if sticks else most", "-factor * x if sticks else -most"), "friction the other way"),
    "RoughLaws.Law6TheNamesMayBeExchanged": ("R_A * x + R_B * y for", "R_A * x for", "B's spin left out"),
    "RoughLaws.Law7TheFirstAxisMayBeMirrored": ("[-spin[0] * x[1], spin[0] * x[0]]", "[-abs(spin[0]) * x[1], abs(spin[0]) * x[0]]", "the sense of a disc's spin lost"),
}


def asked(tps, law, folder):
    """(what `tps properties` says, its exit code)"""
    done = subprocess.run([tps, "properties", "--law", law, "--cases", "100", "-o", folder / "broken.jsonl", "--", sys.executable, folder / "both.py"],
                          capture_output=True, text=True, check=False)
    return done.stdout + done.stderr, done.returncode


def main(tps, source):
    adapters = pathlib.Path(source) / "data/adapters/python"
    text, faults = (adapters / "effects.py").read_text(), []
    listed = subprocess.run([tps, "properties", "--list"], capture_output=True, text=True, check=True).stdout
    for law in re.findall(r"\b(?:Wall|Drag|Rough)Laws\.\w+", listed):
        if law not in LAWS:
            faults.append(f"{law} has no row in LAWS; give it a wrong adapter that breaks it")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for path in adapters.glob("*.py"):
            shutil.copy(path, folder)
        (folder / "both.py").write_text(BOTH)
        for law, (old, new, what) in LAWS.items():
            if text.count(old) != 1:
                faults.append(f"{law}: {json.dumps(old)} stands {text.count(old)} times in effects.py; allowed: once")
                continue
            (folder / "effects.py").write_text(text.replace(old, new))
            said, code = asked(tps, law, folder)
            if code != 1 or "BROKEN" not in said:
                faults.append(f"{law} is not broken by {what} (exit code {code}): {said[-600:]}")
        (folder / "effects.py").write_text(text)
        for laws in ("WallLaws.*", "DragLaws.*", "RoughLaws.*"):
            said, code = asked(tps, laws, folder)
            if code != 0:
                faults.append(f"{laws} of the right adapter, exit code {code}: {said[-1500:]}")
    print("\n".join(faults) or f"{len(LAWS)} laws hold, and each is broken by a wrong adapter")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
