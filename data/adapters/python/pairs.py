"""Particles of a scene, and what a pair of them does at its limits: when it gets there, and how it responds (docs/scene.md)."""
import math

from protocol import read
from responses import collision_impulse, frame, revolution_impulse, tether_response
from timing import block_time, dot, tether_time


class Pairs:
    def __init__(self, scene):
        species = read(scene["species"])
        particles = [{"id": n, "velocity": [0.0 for _ in p["position"]], **p} for n, p in enumerate(read(scene["particles"]))]
        particles.sort(key=lambda p: p["id"])  # a pair is written, and ties are ordered, by ids
        self.ids = [p["id"] for p in particles]
        self.species = [species[p["species"]] for p in particles]
        self.u, self.v = [p["position"] for p in particles], [p["velocity"] for p in particles]
        self.m = [s["mass"] for s in self.species]
        laws = {frozenset(law["between"]): law for law in read(scene.get("pairs", []))}
        names = [p["species"] for p in particles]
        self.laws = {(i, j): laws[frozenset((names[i], names[j]))] for j in range(len(names)) for i in range(j)
                     if frozenset((names[i], names[j])) in laws and min(self.m[i], self.m[j]) < math.inf}
        self.tethers = {tuple(sorted(map(self.ids.index, pair))) for pair in scene.get("tethers", [])}
        self.permanent = {pair for pair, law in self.laws.items() if law.get("tethering", {}).get("form") == "permanent"}
        self.answered = set()  # (i, j, limit): has responded there, and neither velocity has changed since

    def states(self, i, j):
        return {"u_A": self.u[i], "u_B": self.u[j], "v_A": self.v[i], "v_B": self.v[j]}

    def distance(self, i, j, limit):
        radii = [self.species[k].get("radius", 0) for k in (i, j)]
        default = sum(radii) if limit == "blocking" else abs(radii[0] - radii[1])
        return self.laws[i, j][limit].get("distance", default)

    def due(self, i, j):
        """When the pair is at its inner and at its outer limit."""
        if "blocking" in self.laws[i, j] and (i, j, "inner") not in self.answered:
            yield block_time(L=self.distance(i, j, "blocking"), **self.states(i, j))["t"], "inner"
        if (i, j) in self.tethers | self.permanent:
            found, again = tether_time(L=self.distance(i, j, "tethering"), **self.states(i, j)), (i, j, "outer") in self.answered
            if again and found["verdict"] == "turning":  # rounding left it outside: there and back again (D17)
                yield 2 * found["t"], "outer"
            elif not again or found["verdict"] == "hit":
                yield found["t"], "outer"

    def has_room(self, k):
        return sum(k in pair for pair in self.tethers) < self.species[k].get("max_tethers", math.inf)

    def respond(self, i, j, limit):
        """The kind of the event, its impulse, and what becomes of the tether."""
        law, masses, none = self.laws[i, j], {"m_A": self.m[i], "m_B": self.m[j], **self.states(i, j)}, [0.0 for _ in self.u[i]]
        _, _, v_n, across = frame(**self.states(i, j))
        if limit == "inner":
            forms = "tethering" in law and law["tethering"].get("form", "always") == "always" and (i, j) not in self.tethers
            dp = collision_impulse(c=law["blocking"]["c_rebound"], **masses)["dp"] if v_n < 0 else none
            return "rebound", dp, "formed" if forms and self.has_room(i) and self.has_room(j) else None
        law = law["tethering"]
        revolving = {"c_revolve": law["c_revolve"], "theta_revolve_deg": law["theta_revolve_deg"], **masses}
        if v_n > 0:
            out = tether_response(c_retract=law["c_retract"], **revolving)
        else:  # rounding of a perpendicular pair (D16)
            out = {"kind": "revolve", **revolution_impulse(**revolving)} if any(across) else {"kind": "retract", "dp": none}
        rule = law.get("break", "never") if (i, j) in self.tethers else "never"
        breaks = rule == "always" or isinstance(rule, dict) and math.sqrt(dot(out["dp"], out["dp"])) > rule["impulse_above"]
        return ("break", none, "broken") if breaks else (out["kind"], out["dp"], None)
