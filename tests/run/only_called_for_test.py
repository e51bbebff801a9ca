"""A trace has the words of the effects that its scene calls for, and of no other; the catalogue is that of `tps explain`.

  only_called_for_test.py TPS SOURCE

Words are the keys of events and of full states, with those inside them, and the kinds of events. WORDS has a row for every effect of the catalogue: a
new one needs its row, and a scene that calls for it, in data/scenes or in CALLED.
"""
import json
import pathlib
import re
import subprocess
import sys

QUANTITIES = ("energy_bound", "from_outside", "from_walls", "kinetic_at_start", "lost", "momentum_at_start", "momentum_bound", "oldest_group", "stored",
              "work", "worst_inner_excess", "worst_outer_excess")
BASE = {"event.k", "event.t", "event.dt", "event.kind", "event.i", "event.j", "event.pre.position", "event.pre.velocity", "event.post.position",
        "event.post.velocity", "event.dp", "state.state", "state.t", "state.now", "state.last_event", "state.progress_event", "state.final",
        "state.checksum", "state.observations", "state.responded", "state.particles.id", "state.particles.position", "state.particles.velocity", "state.particles.clock", "state.responded.i",
        "state.responded.j", "state.responded.limit", *(f"state.counts.#{n}" for n in ("first_noise", "largest_group", "noise", "zero_impulse")),
        *(f"state.quantities.{n}" for n in QUANTITIES)}
# What each adds: words that every run with it has, and words that it may have.
WORDS = {
    "drag": ({"event.s", "event.ds"}, {"state.s", "state.quantities.drag_lost", "state.quantities.drag_taken", "state.quantities.drag_since"}),
    "friction": ({"event.contact", "event.pre.spin", "event.post.spin", "state.particles.spin", "state.quantities.friction_lost"}, set()),
    "gravity": ({"kind gravity", "event.dv", "state.quantities.gravity_work"}, set()),
    "grouping": ({"kind restitute", "event.members", "event.dp_stored"}, {"state.groups"}),
    "periodic_box": (set(), set()),
    "phases": ({"kind phase_begin", "event.phase"}, {"kind phase_end"}),
    "random_impulses": ({"kind random_impulse", "state.quantities.random_impulses_heat"}, set()),
    "rebound": ({"kind rebound"}, {"event.tether", "event.draw", "state.draws"}),
    "scheduled_impulses": ({"kind scheduled_impulse"}, set()),
    "tethering": ({"kind retract"}, {"kind revolve", "kind break", "event.tether", "event.draw", "state.draws", "state.tethers"}),
    "thermostat": ({"kind thermostat", "state.quantities.thermostat_heat"}, set()),
    "walls": ({"kind wall", "event.wall", "state.quantities.walls_lost", "state.quantities.walls_work"}, {"event.face"}),
}


def with_species(scene, **more):
    next(s for s in scene["species"].values() if s["mass"] != "inf").update(more)


def with_phase(scene):
    pair = next(p for p in scene["pairs"] if "tethering" in p)
    scene["phases"] = [{"between": pair["between"], "from": 0.01, "until": 0.02, "break": "never"}]


CALLED = {  # what no file of data/scenes calls for: a file, and what is added to it
    "phases": ("pair", with_phase),
    "thermostat": ("gas-walls", lambda scene: with_species(scene, thermostat={"tau": 0.1, "kT": 1})),
}


def words_in(value, path):
    """Keys with what they hold; a list that is empty says nothing."""
    if isinstance(value, dict):
        for key, inside in value.items():
            key = re.sub(r"_[012]$", "", key)
            yield from words_in(inside, path if key.isdigit() else f"{path}.{key}")
    elif isinstance(value, list) and (not value or isinstance(value[0], dict)):
        for inside in value:
            yield from words_in(inside, path)
    else:
        yield path.replace("state.counts.", "kind ") if path.startswith("state.counts.") and "#" not in path else path


def run(tps, text):
    done = subprocess.run([tps, "run", "-", "-o", "-", "--max-events", "150", "--quiet"], input=text, capture_output=True, text=True, check=False)
    words = set()
    for line in done.stdout.splitlines()[1:]:
        found = json.loads(line)
        if "kind" in found:
            words.add("kind " + found["kind"])
            words.update(words_in(found, "event"))
        elif "state" in found:
            words.update(words_in(found, "state"))
    return words


def belongs(word, known):
    return word == known or word.startswith(known + ".")


def called_by(tps, text):
    done = subprocess.run([tps, "explain", "-", "--format", "json"], input=text, capture_output=True, text=True, check=True)
    effects = json.loads(done.stdout)["effects"]
    return [e["name"] for e in effects], {e["name"] for e in effects if e["simulated"]}


def main(tps, source):
    scenes = {path.stem: path.read_text() for path in sorted((pathlib.Path(source) / "data/scenes").glob("*.json"))}
    for effect, (file, change) in CALLED.items():
        scene = json.loads(scenes[file])
        change(scene)
        scenes[f"{file} with {effect}"] = json.dumps(scene)
    faults, shown, catalogue = [], {}, []
    for name, text in scenes.items():
        catalogue, called = called_by(tps, text)
        words = run(tps, text)
        for effect in called:
            shown.setdefault(effect, set()).update(words)
        allowed = BASE.union(*(always | maybe for effect, (always, maybe) in WORDS.items() if effect in called))
        for word in sorted(words):
            if any(belongs(word, known) for known in allowed) or word in {f"state.progress.{effect}" for effect in called}:
                continue
            owners = [effect for effect, (always, maybe) in WORDS.items() if any(belongs(word, known) for known in always | maybe)]
            faults.append(f"{name}: has {word}, which " + (f"is of {', '.join(owners)}, and the scene does not call for it" if owners else "no effect owns"))
    if set(catalogue) != set(WORDS):
        faults.append(f"WORDS and the catalogue differ in {', '.join(sorted(set(catalogue) ^ set(WORDS)))}; every effect needs a row")
    for effect, (always, _) in WORDS.items():
        if effect not in shown:
            faults.append(f"no scene calls for {effect}; add one to data/scenes, or to CALLED")
        elif always - shown[effect]:
            faults.append(f"{effect}: no scene that calls for it has {', '.join(sorted(always - shown[effect]))}")
    print("\n".join(faults) or f"{len(scenes)} scenes have the words of what they call for, of {len(WORDS)} effects")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
