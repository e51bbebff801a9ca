"""A small event-driven simulator of its own, honest unless a lie is put into it (lies.py).

All pairs are asked at every step; nothing is fast, nothing is shared with reference/. A lie overrides one of the
hooks of Honesty (honesty.py), once; the simulation goes on from whatever it did.
"""
import math

from groups import Forest, Node, leaves, preorder
from happenings import IMPULSE, PHASE, RESTITUTION, Hit
from honesty import Honesty
from laws import Laws
from numbers_of_traces import after, elapsed, norm, plus
from philox import TETHER_BREAK, TETHER_FORM, uniform
from responses import (apply_impulse, collision_impulse, load_velocity, restitution_impulse, retraction_suffices, revolution_impulse)
from schedule import Schedule
from timing import INNER, OUTER
from trace_text import Writer


class Simulator(Schedule):
    def __init__(self, scene, timing="certified", state_every=7, lie=None):
        self.laws, self.timing, self.lie = Laws(scene), timing, lie or Honesty()
        self.scene, self.n = scene, len(scene["particles"])
        self.mass = [self.laws.mass(i) for i in range(self.n)]
        self.fixed = [math.isinf(m) for m in self.mass]
        self.x = [tuple(map(float, p["position"])) for p in self.laws.particles]
        self.v = [tuple(map(float, p.get("velocity", [0.0] * scene["dimension"]))) for p in self.laws.particles]
        self.clock = [(0.0, 0.0)] * self.n
        self.ids = [p["id"] for p in self.laws.particles]
        self.tethers = {tuple(sorted(self.laws.index[i] for i in pair)) for pair in scene.get("tethers", [])}
        self.responded = [set() for _ in range(self.n)]
        self.forest = Forest() if "grouping" in scene else None
        self.now = self.last = (0.0, 0.0)
        self.k = self.progress = self.phases_done = self.impulses_done = 0
        self.draws, self.kinds, self.asked = {}, {}, {}
        self.out = Writer(scene, timing, state_every)
        self.state_every = state_every
        self.lie.begin(self)

    # Particles

    def place_at(self, i, t):
        return self.x[i] if self.clock[i] == t else plus(self.x[i], self.v[i], elapsed(self.clock[i], t))

    def place(self, i):
        return self.place_at(i, self.now)

    def bring(self, i):
        if not self.fixed[i]:
            self.x[i], self.clock[i] = self.lie.brought(self, i, self.place(i)), self.now

    def set_velocity(self, i, v):
        if not self.fixed[i]:
            if v != self.v[i]:
                self.responded[i].clear()
            self.v[i] = v

    def respond_noted(self, i, j, limit):
        for a, b in ((i, j), (j, i)):
            if not self.fixed[a]:
                self.responded[a].add((b, limit))

    def has_responded(self, i, j, limit):
        return (self.fixed[i] or (j, limit) in self.responded[i]) and (self.fixed[j] or (i, limit) in self.responded[j])

    def body_mass(self, i):
        body = self.forest.body(i) if self.forest else None
        return body.mass if body else self.mass[i]

    def members(self, i):
        if self.fixed[i]:
            return []
        return self.forest.members(i) if self.forest else [i]

    def tethered(self, i, j):
        return self.laws.tethering(i, j) is not None and (self.laws.permanent(i, j) or (i, j) in self.tethers)

    # What happens

    def step(self, event):
        self.now = max(event.time, self.now)
        before = self.k
        if event.rank == RESTITUTION:
            self.restitute(self.forest.body(event.i))
        elif event.rank == PHASE:
            self.change_phase()
        elif event.rank == IMPULSE:
            self.push()
        else:
            self.collide(event)
        if before // self.state_every != self.k // self.state_every:
            self.write_state()

    def open_record(self, kind, involved):
        for i in involved:
            self.bring(i)
        record = {"kind": kind, "involved": list(involved)}
        if involved:
            record["i"] = involved[0]
            record["pre"] = {i: (self.place(i), self.v[i]) for i in involved}
        return record

    def close_record(self, record):
        record["post"] = {i: (record["pre"][i][0], self.v[i]) for i in record["involved"]}
        self.k += 1
        record.update(k=self.k, t=self.now, dt=elapsed(self.last, self.now))
        if self.now[0] != self.last[0]:
            self.progress = self.k - 1  # events before the clock moved
        record = self.lie.recorded(self, record)
        self.last = self.now
        for one in record if isinstance(record, list) else [record]:
            self.kinds[one["kind"]] = self.kinds.get(one["kind"], 0) + 1
            self.out.event(self, one)

    def collide(self, event):
        record = self.open_record("rebound", [event.i, event.j])
        hit = Hit(self, event)
        hit.record = {**record, "j": event.j}
        self.answer_inner(hit) if event.limit == INNER else self.answer_outer(hit)
        self.lie.impulse(self, hit)
        self.change_tether(hit)
        self.lie.tether(self, hit)
        hit.record["kind"] = hit.kind
        if hit.kind != "break":
            hit.record["dp"] = hit.dp
            if hit.answered:
                self.load(hit) if self.forest else self.part(hit)
            if not (self.forest and self.forest.together(hit.i, hit.j)):
                self.respond_noted(hit.i, hit.j, hit.limit)
        self.close_record(hit.record)

    def answer_inner(self, hit):
        if hit.frame.normal < 0:
            c = float(self.laws.blocking(hit.i, hit.j)["c_rebound"])
            hit.dp, hit.answered = collision_impulse(hit.frame, hit.m_i, hit.m_j, c), True

    def answer_outer(self, hit):
        law = self.laws.tethering(hit.i, hit.j)
        retract, revolve, theta = (float(law[k]) for k in ("c_retract", "c_revolve", "theta_revolve_deg"))
        hit.kind = "retract"
        if hit.frame.normal < 0 and norm(hit.frame.across) == 0:
            return
        hit.answered = True
        if hit.frame.normal >= 0 and retraction_suffices(hit.frame, retract, theta):
            hit.dp = collision_impulse(hit.frame, hit.m_i, hit.m_j, retract)
        else:
            hit.kind = "revolve"
            hit.dp = revolution_impulse(hit.frame, hit.m_i, hit.m_j, revolve, theta)

    def draw(self, purpose, i, j):
        used = self.draws.get((purpose, self.ids[i], self.ids[j]), 0)
        self.draws[purpose, self.ids[i], self.ids[j]] = used + 1
        return uniform(int(self.scene.get("seed", 0)), purpose, self.ids[i], self.ids[j], used)

    def is_full(self, i):
        return sum(i in pair for pair in self.tethers) >= self.laws.capacity(i)

    def decides(self, rule, purpose, hit):
        if rule in ("never", "always"):
            return rule == "always"
        if "impulse_above" in rule:
            return math.sqrt(sum(p * p for p in hit.dp)) > rule["impulse_above"]
        hit.record["draw"] = self.draw(purpose, hit.i, hit.j)
        return hit.record["draw"] < rule["probability"]

    def change_tether(self, hit):
        law, pair = self.laws.tethering(hit.i, hit.j), (hit.i, hit.j)
        if not law:
            return
        if hit.limit == OUTER:
            if not self.laws.permanent(*pair) and self.decides(self.laws.rule(*pair, "break"), TETHER_BREAK, hit):
                self.tethers.discard(pair)
                hit.kind, hit.record["tether"] = "break", "broken"
        elif not self.laws.permanent(*pair) and pair not in self.tethers and not any(map(self.is_full, pair)):
            if self.decides(self.laws.rule(*pair, "form"), TETHER_FORM, hit):
                self.tethers.add(pair)
                hit.record["tether"] = "formed"

    def part(self, hit):
        new = apply_impulse(hit.m_i, hit.m_j, self.v[hit.i], self.v[hit.j], hit.dp)
        for i, v in zip((hit.i, hit.j), self.lie.applied(self, hit, new)):
            self.set_velocity(i, v)

    def load(self, hit):
        v_load = load_velocity(hit.m_i, hit.m_j, self.v[hit.i], self.v[hit.j])
        stored = restitution_impulse(hit.m_i, hit.m_j, self.v[hit.i], self.v[hit.j], hit.dp)
        v_load, stored = self.lie.loaded(self, hit, v_load, stored)
        fixed = self.fixed[hit.i], self.fixed[hit.j]
        sides = [self.forest.side(i, f) for i, f in zip((hit.i, hit.j), fixed)]
        node = Node(hit.i, hit.j, hit.limit, sides, (hit.m_i, hit.m_j), stored)
        expiry = self.lie.expiry(self, hit, after(self.now, float(self.scene["grouping"]["dt_restitute"])))
        body = self.forest.join(node, fixed, expiry, self.now)
        self.move_as_one(hit.record, body.members, v_load)
        hit.record["dp_stored"], hit.record["members"] = stored, list(body.members)

    def move_as_one(self, record, members, v):
        for m in members:
            if m not in record["involved"]:
                self.bring(m)
                record["pre"][m] = (self.place(m), self.v[m])
                record["involved"].append(m)
        for m in self.lie.members(self, record, members):
            self.set_velocity(m, v)

    def restitute(self, body):
        self.forest.dissolve(body)
        for m in body.members:
            self.bring(m)
        for node in self.lie.unwinding(self, body, list(preorder(body.root))):
            record = {**self.open_record("restitute", [node.i, node.j]), "j": node.j, "dp": node.dp}
            v_i, v_j = apply_impulse(*node.masses, self.v[node.i], self.v[node.j], node.dp)
            for side, v in zip(node.sides, (v_i, v_j)):
                for m in leaves(side):
                    self.set_velocity(m, v)
            self.respond_noted(node.i, node.j, node.limit)
            self.close_record(record)

    def change_phase(self):
        _, opens, phase = self.laws.changes[self.phases_done]
        self.laws.open[phase] = self.lie.phase(self, opens, phase)
        self.phases_done += 1
        self.close_record({"kind": "phase_begin" if opens else "phase_end", "phase": phase, "involved": [], "pre": {}})

    def push(self):
        i, impulse = self.lie.pushed(self, *self.laws.impulses[self.impulses_done][1:])
        self.impulses_done += 1
        record = {**self.open_record("scheduled_impulse", [i]), "dp": impulse}
        mass = self.body_mass(i)
        self.move_as_one(record, self.members(i), tuple(v + p / mass for v, p in zip(self.v[i], impulse)))
        self.close_record(record)

    # The whole run

    def write_state(self, final=False):
        self.out.state(self, final)

    def run(self, max_events):
        self.write_state()
        end = (float(self.scene["duration"]), 0.0)
        while True:
            if self.k >= max_events or self.lie.stops(self):
                return self.end("max_events", self.now)
            event = self.next_event()
            if event is None or event.time > end:
                endless = math.isinf(end[0])
                return self.end("no_more_events" if endless else "duration", self.now if endless else end)
            self.step(event)

    def end(self, reason, t):
        self.write_state(final=True)
        self.out.end(self.lie.ending(self, {"end": reason, "events": self.k, "t": t}))
        return self.out
