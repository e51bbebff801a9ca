"""What each effect costs where it is called for: a gas with it beside the same gas without, in events a second and bytes a particle.
Used by called_for.py."""
import json
import pathlib
import re
import subprocess

PARTICLES, EVENTS, ROUNDS = 1000, 20000, 5
MEMBRANE, WALLS, PERIODIC = [], ["--walls", "1"], ["--periodic", "1"]  # what holds the gas
TETHERING = {"distance": 3, "c_retract": 1, "c_revolve": 1, "theta_revolve_deg": 45, "form": "never"}


def keys(**more):
    return lambda scene: scene.update(more)


def of_species(**more):
    return lambda scene: scene["species"]["sphere"].update(more)


def of_pair(**more):
    def change(scene):
        next(pair for pair in scene["pairs"] if pair["between"] == ["sphere", "sphere"]).update(more)
    return change


def nothing(_):
    pass


def phases(scene):
    of_pair(tethering=TETHERING)(scene)
    scene["phases"] = [{"between": ["sphere", "sphere"], "from": n / 100, "until": n / 100 + 0.005, "break": "never"} for n in range(100)]


def impulses(scene):
    who = scene["particles"][-1]["id"]
    scene["impulses"] = [{"at": n / 1000, "particle": who, "impulse": [0.1, 0, 0]} for n in range(1000)]


# effect: (container, change) without it, (container, change) with it, and what that is. None: there is nothing without it.
PRICES = {
    "drag": ((MEMBRANE, nothing), (MEMBRANE, keys(drag={"gamma": 0.01})), "γ = 0.01"),
    "friction": ((MEMBRANE, nothing), (MEMBRANE, of_pair(friction={"mu": 0.5, "beta0": 0})), "every rebound of two spheres"),
    "gravity": ((MEMBRANE, nothing), (MEMBRANE, keys(gravity={"acceleration": [0, 0, -1], "every": 0.05})), "a kick every 0.05, some 500 collisions"),
    "grouping": ((MEMBRANE, nothing), (MEMBRANE, keys(grouping={"dt_restitute": 1e-4})), "loads and restitutions for collisions"),
    "periodic_box": ((MEMBRANE, nothing), (PERIODIC, nothing), "instead of the membrane"),
    "phases": ((MEMBRANE, of_pair(tethering=TETHERING)), (MEMBRANE, phases), "200 changes of rules that bind nobody"),
    "random_impulses": ((MEMBRANE, nothing), (MEMBRANE, of_species(random_impulses={"tau": 0.1, "shape": 2, "mean": 0.1})), "as many as collisions"),
    "rebound": None,
    "scheduled_impulses": ((MEMBRANE, nothing), (MEMBRANE, impulses), "1000 on one sphere"),
    "tethering": ((WALLS, nothing), (MEMBRANE, nothing), "a membrane instead of walls"),
    "thermostat": ((MEMBRANE, nothing), (MEMBRANE, of_species(thermostat={"tau": 0.1, "kT": 1})), "as many as collisions"),
    "walls": ((MEMBRANE, nothing), (WALLS, nothing), "six faces instead of the membrane"),
}


def scene_of(tps, folder, name, container, change):
    done = subprocess.run([tps, "scene", "gas", "--particles", str(PARTICLES), *container], capture_output=True, check=True)
    scene = json.loads(done.stdout)
    change(scene)
    path = folder / f"{name}.json"
    path.write_text(json.dumps(scene))
    return path


def measured(program, scene):
    """(bytes held, events a second)"""
    told = subprocess.run([program, scene, str(EVENTS)], capture_output=True, text=True, check=False)
    found = re.match(r"\d+ events, (\d+) bytes, (\d+) events/s", told.stdout)
    if not found:
        raise SystemExit(f"prices.py: {scene}: {told.stderr or told.stdout}")
    return int(found[1]), int(found[2])


def row(program, tps, folder, effect, price):
    if price is None:
        return f"| {effect} | – | – | – | – | – | without it a gas has no events |"
    without, called, what = price
    scenes = [scene_of(tps, folder, f"{effect}-{name}", *made) for name, made in (("without", without), ("with", called))]
    rounds = [[measured(program, scene) for scene in scenes] for _ in range(ROUNDS)]  # side by side
    (b0, _), (b1, _) = rounds[0]
    r0, r1 = (max(pair[k][1] for pair in rounds) for k in (0, 1))
    return f"| {effect} | {r0:,} | {r1:,} | {r1 / r0 - 1:+.0%} | {b0 / PARTICLES:.0f} | {b1 / PARTICLES:.0f} | {what} |"


def print_table(program, build, page):
    folder = (build / "called_for").resolve()
    lines = ["| effect | events/s without | with | | bytes a particle without | with | what is called for |", "|---|---|---|---|---|---|---|"]
    lines += [row(program, build / "tps", folder, effect, price) for effect, price in PRICES.items()]
    print("\n".join(lines))
    if page:
        text = page.read_text(encoding="utf-8")
        text, count = re.subn(r"(?ms)^\| effect \| events/s without .*?(?=^$|\Z)", lambda _: "\n".join(lines) + "\n", text, count=1)
        if not count:
            raise SystemExit(f"prices.py: {page} has no table that begins with | effect | events/s without |")
        page.write_text(text, encoding="utf-8")
    return 0
