"""The lines of a trace, full or minimal (docs/trace.md, docs/check.md)."""
import json

from fractions import Fraction

from groups import group_data
from numbers_of_traces import exact, hexadecimal, vector_text

SEMANTICS = 1


class Writer:
    def __init__(self, scene, timing, state_every):
        self.start = Fraction(float(scene.get("start_time", 0)))
        options = {"timing": timing, "state_every": state_every}
        self.lines = [{"trace": 1, "semantics": SEMANTICS, "version": "liar", "scalar": "double", "options": options, "scene": scene}]
        self.minimal_lines = [{"trace": 1, "form": "minimal", "scalar": "double", "options": {"timing": timing}, "scene": scene}]

    def time(self, t):
        return hexadecimal(self.start + exact(t))

    def event(self, sim, record):
        line = {"k": record["k"], "t": self.time(record["t"]), "dt": hexadecimal(record["dt"]), "kind": record["kind"]}
        name = sim.ids
        for key in ("i", "j"):
            if key in record:
                line[key] = name[record[key]]
        for key in ("phase", "tether"):
            if key in record:
                line[key] = record[key]
        for key in ("pre", "post"):
            if record["involved"]:
                line[key] = {str(name[i]): {"position": vector_text(x), "velocity": vector_text(v)} for i, (x, v) in record[key].items()}
        for key in ("dp", "dp_stored"):
            if key in record:
                line[key] = vector_text(record[key])
        if "draw" in record:
            line["draw"] = hexadecimal(record["draw"])
        if "members" in record:
            line["members"] = [name[m] for m in record["members"]]
        self.lines.append(line)
        self.minimal_lines.append(self.minimal(line))

    @staticmethod
    def minimal(line):
        kept = {key: line[key] for key in ("t", "kind", "i", "j", "phase", "tether", "draw") if key in line}
        if "post" in line:
            kept["post"] = {i: {"velocity": s["velocity"]} for i, s in line["post"].items()}
        return kept

    def state(self, sim, final):
        if final and sim.k and "state" in self.lines[-1]:
            return  # it was due here anyway
        name, hex_time = sim.ids, lambda t: [hexadecimal(t[0]), hexadecimal(t[1])]
        pairs = [(i, j) for i in range(sim.n) for j in range(i + 1, sim.n)]
        state = {
            "state": sim.k, "t": self.time(sim.now), "now": hex_time(sim.now), "last_event": hex_time(sim.last),
            "progress_event": sim.progress,
            "particles": [{"id": name[i], "position": vector_text(sim.x[i]), "velocity": vector_text(sim.v[i]),
                           "clock": hex_time(sim.clock[i])} for i in range(sim.n)],
            "tethers": [[name[i], name[j]] for i, j in sorted(sim.tethers)],
            "responded": [[name[i], name[j], limit] for i, j in pairs for limit in ("inner", "outer")
                          if not (sim.fixed[i] and sim.fixed[j]) and sim.has_responded(i, j, limit)],
            "groups": [group_data(b, name, hexadecimal, vector_text) for b in (sim.forest.bodies() if sim.forest else [])],
            "draws": [[*key, used] for key, used in sorted(sim.draws.items())],
            "progress": {k: n for k, n in (("phases", sim.phases_done), ("scheduled_impulses", sim.impulses_done)) if n},
            "counts": dict(sim.kinds), "quantities": {}, "observations": []}
        if final:
            state["final"] = True
        self.lines.append(sim.lie.state(sim, state))

    def end(self, end):
        line = {**end, "t": self.time(end["t"])}
        self.lines.append(line)
        self.minimal_lines.append(line)

    def text(self, minimal=False):
        return "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in (self.minimal_lines if minimal else self.lines))
