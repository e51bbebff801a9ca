"""Wrong simulators, one mistake each: a text of data/adapters/python that is replaced, and the row in which `tps conform` has to find it.

SimulatorMutant(name, file, old, new, row, says): `row` must have an answer of class `kind`, and `says` be in what is said of it.
"""
from dataclasses import dataclass


@dataclass(frozen=True)
class SimulatorMutant:
    name: str
    file: str
    old: str
    new: str
    row: str = "run.whole"
    says: str = ""
    kind: str = "WRONG"
    first: int = 0  # the scene that shows it
    scenes: int = 1
    features: str = "no-groups,no-draws,no-phases,no-impulses"
    ops: str = "simulate"
    also: tuple = ()  # further texts that belong to the mistake, with what replaces them


S, L, R, T, P = "pairs.py", "paper_loop.py", "responses.py", "timing.py", "protocol.py"
NEXT = 't, _, _, limit, i, j = min(times, default=(math.inf, 0, 0, "", 0, 0))'
FREE = "u = [[x + w * t for x, w in zip(place, speed)] for place, speed in zip(pairs.u, pairs.v)]"
BREAKS = 'breaks = rule == "always" or isinstance(rule, dict) and math.sqrt(dot(out["dp"], out["dp"])) > rule["impulse_above"]'
PREDICTED = """def predicted(pairs, i, j):
    if (i, j) not in pairs.ahead:
        pairs.ahead[i, j] = [(t, limit) for t, limit in pairs.due(i, j) if t is not None]
    return pairs.ahead[i, j]


"""
PASSED = "pairs.ahead = {pair: [(when - t, which) for when, which in ahead] for pair, ahead in pairs.ahead.items() if pair != (i, j)}"
RESPONDS = "    kind, dp, tether = pairs.respond(i, j, limit)\n"
RECORDED = '**({"tether": tether} if tether else {})}'

WRONG = [
    SimulatorMutant("a_pair_forgotten", L, "for i, j in pairs.laws for", "for i, j in list(pairs.laws)[1:] for", says="was due"),
    SimulatorMutant("late_by_1e-13", L, "clock + t, events + 1", "clock + t * (1 + 1e-13), events + 1", says="contact", first=7),
    SimulatorMutant("missed_where_two_are_near", L, NEXT, "times.sort(); near = len(times) > 1 and 0 < times[1][0] - times[0][0] < 1e-9\n    "
                    't, _, _, limit, i, j = times[int(near)] if times else (math.inf, 0, 0, "", 0, 0)', first=102),
    SimulatorMutant("formed_not_recorded", L, RECORDED, '**({"tether": tether} if tether == "broken" else {})}', "run.rebound", "tethers"),
    SimulatorMutant("recorded_not_formed", L, "if tether:", 'if tether == "broken":', "run.whole"),
    SimulatorMutant("formed_when_full", S, 'self.species[k].get("max_tethers", math.inf)', "math.inf", "run.formed", "tethers", first=2),
    SimulatorMutant("never_breaks", S, BREAKS, "breaks = False", "run.whole", "tethers"),
    SimulatorMutant("break_with_impulse", S, 'return ("break", none, "broken")', 'return ("break", out["dp"], "broken")', "run.break", "impulse"),
    SimulatorMutant("threshold_on_velocity", S, 'math.sqrt(dot(out["dp"], out["dp"])) > rule', "abs(v_n) > rule", "run.whole", "tethers", first=4),
    SimulatorMutant("threshold_5_percent_high", S, '> rule["impulse_above"]', '> 1.05 * rule["impulse_above"]', "run.whole", "tethers", first=4),
    SimulatorMutant("threshold_5_percent_low", S, '> rule["impulse_above"]', '> 0.95 * rule["impulse_above"]', "run.break", "tethers", first=20),
    SimulatorMutant("start_time_ignored", L, 'read(scene.get("start_time", 0))', "0.0"),
    SimulatorMutant("no_duration_ends_at_once", L, 'read(scene["duration"])', '(read(scene["duration"]) if read(scene["duration"]) < math.inf else 0)', "run.end",
                    "it begins at", first=14),
    SimulatorMutant("infinite_mass_moves", R, "def apply_impulse(m_A, m_B, v_A, v_B, dp):\n",
                    "def apply_impulse(m_A, m_B, v_A, v_B, dp):\n    m_A, m_B = min(m_A, 1e6), min(m_B, 1e6)\n", "run.infinite mass", first=4),
    SimulatorMutant("walls_stand_still", L, FREE, "u = [[x + w * t * (m < math.inf) for x, w in zip(place, speed)] for place, speed, m in "
                    "zip(pairs.u, pairs.v, pairs.m)]", first=9),
    SimulatorMutant("retracts_with_c_revolve", S, 'tether_response(c_retract=law["c_retract"]', 'tether_response(c_retract=law["c_revolve"]', "run.retract",
                    "impulse"),
    SimulatorMutant("impulse_off_by_1e-12", R, "(1 + c) * reduced", "(1 + 1e-12) * (1 + c) * reduced", "run.rebound", "impulse"),
    SimulatorMutant("taut_pairs_lost", T, 'return {"verdict": "overstretched" if c > 0 else "taut", "t": 0}', 'return {"verdict": "taut", "t": None}', first=2),
    SimulatorMutant("turning_pairs_lost", T, '"turning", "t": -h / a', '"static", "t": None', first=23),
    SimulatorMutant("product_as_printed", R, "speed = c_revolve ** (theta_revolve_deg / 180)", "speed = c_revolve * theta_revolve_deg / 180", "run.revolve", "D4"),
    SimulatorMutant("always_retracts", R, "if across == 0 or abs(c_retract * v_n) > slope(theta_revolve_deg) * across:", "if True:", "run.retract"),
    SimulatorMutant("no_restitution", R, "(1 + c) * reduced", "reduced", "run.rebound", "impulse"),
    SimulatorMutant("enclosure_ignored", S, "in self.tethers | self.permanent:", "in self.tethers:", first=4),
    SimulatorMutant("ends_too_early", L, "if clock + t > duration:", "if clock + t > duration / 2:", "run.end", "was due"),
    SimulatorMutant("end_missing", L, 'return (yield {"end": "duration", "events": events, "t": start + duration})', "return", says="no end"),
    SimulatorMutant("counts_wrongly", L, '{"end": "duration", "events": events,', '{"end": "duration", "events": events + 1,', "run.end", "end"),
    SimulatorMutant("ten_digits", L, 'yield {"t": start + clock, **event', 'yield {"t": float(f"{start + clock:.9e}"), **event'),
    SimulatorMutant("velocities_swapped", L, 'pairs.v[i], pairs.v[j] = after', 'pairs.v[j], pairs.v[i] = after'),
    SimulatorMutant("distance_from_radii", S, 'return self.laws[i, j][limit].get("distance", default)',
                    'return default if limit == "blocking" else self.laws[i, j][limit].get("distance", default)', first=11),
    SimulatorMutant("places_for_ids", S, 'self.ids = [p["id"] for p in particles]', "self.ids = list(range(len(particles)))", first=11),
    SimulatorMutant("permanent_does_not_block", S, 'if "blocking" in self.laws[i, j] and', 'if "blocking" in self.laws[i, j] and (i, j) not in self.permanent and', first=96),
    SimulatorMutant("forms_never_unless_told", S, '.get("form", "always") == "always"', '.get("form", "never") == "always"', "run.rebound", "tether", first=71),
    SimulatorMutant("answers_again", L, "pairs.answered.add((i, j, limit))", "pass", says="D11", kind="OTHER READING"),
    SimulatorMutant("refuses_scenes", L, "{\"trace\": list(run(scene, max_events))}", "{\"trace\": list(run(scene, max_events))} if len(scene[\"particles\"]) < 4 else 1 / 0",
                    kind="REFUSED"),
    SimulatorMutant("third_particle_not_predicted_again", L, "for t, limit in pairs.due(i, j) if t is not None", "for t, limit in predicted(pairs, i, j)",
                    says="contact", also=((S, "        self.answered = set()", "        self.ahead, self.answered = {}, set()"),
                                   (L, "def first_due(pairs):\n", PREDICTED + "def first_due(pairs):\n"),
                                   (L, RESPONDS, "    " + PASSED + "\n" + RESPONDS))),
    SimulatorMutant("steps_without_the_others", L, FREE, FREE.replace("zip(pairs.u, pairs.v)]", "zip(pairs.u[:2], pairs.v)] + pairs.u[2:]"),
                    "next_event.step_rebound", "straight line", ops="next_event"),
    SimulatorMutant("steps_to_the_last", L, "min(times, default", "max(times, default", "next_event.step_rebound", "was due", ops="next_event"),
    SimulatorMutant("steps_late_by_1e-12", L, '"dt": t,', '"dt": t * (1 + 1e-12),', "next_event.step_rebound", ops="next_event"),
    SimulatorMutant("steps_only_soon", L, 'if t == math.inf else {"dt"', 'if t > 0.5 else {"dt"', "next_event.step_rebound", "is due", ops="next_event"),
    SimulatorMutant("steps_without_tethers", L, RECORDED, "**{}}", "next_event.step_rebound", "tethers", ops="next_event"),
    SimulatorMutant("knows_no_groups", L, '"no-groups", ', "", "run.rebound", "load", features="groups,no-draws,no-phases,no-impulses"),
    SimulatorMutant("knows_no_phases", L, '"no-phases", ', "", says="phase", features="no-groups,no-draws,no-impulses", first=2),
    SimulatorMutant("knows_no_impulses", L, ', "no-impulses"', "", says="impulse", features="no-groups,no-draws,no-phases"),
]

RIGHT = [
    SimulatorMutant("as_it_is", L, "import json\n", "import json\n", scenes=20),
    SimulatorMutant("other_order_of_ties", L, NEXT, NEXT.replace("min(times", "min(times, key=lambda e: (e[0], -e[1], -e[2])")),
    SimulatorMutant("does_not_say_eager", L, '"positions": "eager", ', ""),
    SimulatorMutant("inverse_masses", R, "p / m_A for v, p in zip(v_A, dp)], \"v_B\": [v - p / m_B",
                    "p * (1 / m_A) for v, p in zip(v_A, dp)], \"v_B\": [v - p * (1 / m_B)"),
]
