#!/usr/bin/env python3
"""Proves known-answer files again, with exact arithmetic and no code of the project.

python3 data/verify_vectors.py [FILE|- ...]     (default: every data/vectors/*.jsonl)

Timing and order are decided by integers alone: signs of the polynomial at both ends of an enclosure, of its slope (which
says the branch) and of its discriminant. Responses are in verify_responses.py, what the operations admit in verify_domain.py.
Exit code 1 if a case is wrong.
"""
import glob, json, math, os, sys
from decimal import Context, Decimal

from verify_domain import check_question
from verify_responses import F, Pair, check_nearest, check_response, check_results, claim, dot, double, inverse_mass, plus, root, vector

BROKEN = ValueError, KeyError, TypeError, AttributeError, ArithmeticError, IndexError
NOW, NEVER = {"overlap", "contact", "taut", "overstretched"}, {"static", "receding", "miss", "tangent"}


def sign(x):
    return (x > 0) - (x < 0)


def over_power_of_two(texts):
    ratios = [double(t).as_integer_ratio() for t in texts]
    unit = max(d for _, d in ratios)
    return [n * (unit // d) for n, d in ratios], unit


class Query:
    """a t^2 + 2 h t + c in integers, and which zero of it is the event."""

    def __init__(self, q, kind):
        n = len(q["u_A"])
        u, length = over_power_of_two(q["u_A"] + q["u_B"] + [q["L"]])
        w, speed = over_power_of_two(q["v_A"] + q["v_B"])
        r, v = [u[n + k] - u[k] for k in range(n)], [w[n + k] - w[k] for k in range(n)]
        a, h, c = dot(v, v), dot(r, v), dot(r, r) - u[-1] ** 2
        self.A, self.B, self.C = (a, speed**2), (2 * h, length * speed), (c, length**2)
        self.a, self.h, self.c, self.larger = a * length**2, h * length * speed, c * speed**2, kind == "tether"
        self.D = self.sign_D = self.h**2 - self.a * self.c
        if a == 0:
            self.verdict = "static"
        elif self.larger:
            outside = ("taut" if c == 0 else "overstretched") if h >= 0 else "hit" if c == 0 or self.D > 0 else "turning"
            self.verdict = "hit" if c < 0 else outside
        else:
            outside = ("tangent", "hit", "miss")[sign(self.D)]
            self.verdict = "receding" if h >= 0 else "overlap" if c < 0 else "contact" if c == 0 else outside
        if self.verdict in NOW:
            self.a, self.h, self.c, self.D = 1, 0, 0, 0
        elif self.verdict == "turning":  # closest approach, as the double zero of (a t + h)^2
            self.a, self.h, self.c, self.D = self.a**2, self.a * self.h, self.h**2, 0

    def slope(self, n, d):
        return sign(self.a * n + self.h * d)

    def polynomial(self, n, d):  # its sign at n/d; for a turning that of a t + h
        return self.slope(n, d) if self.D == 0 else sign((self.a * n + 2 * self.h * d) * n + self.c * d * d)

    def side(self, n, d):  # -1, 0, 1: n/d lies before, at, after the event
        slope, branch = self.slope(n, d), 1 if self.larger else -1
        return slope if self.D == 0 or slope * branch < 0 else branch * self.polynomial(n, d)

    def scaled(self, k):  # t 2^k, to two units
        root = math.isqrt(self.D << 2 * k)
        return ((root if self.larger else -root) - (self.h << k)) // self.a


def order(p, q):
    if p.verdict in NEVER or q.verdict in NEVER:
        return ("none" if q.verdict in NEVER else "after") if p.verdict in NEVER else "before"
    ah, ac, hc = p.a * q.h - q.a * p.h, p.a * q.c - q.a * p.c, p.h * q.c - q.h * p.c
    if ac * ac == 4 * ah * hc:  # the resultant vanishes: a zero in common
        n, d = (-ac, 2 * ah) if ah > 0 else (ac, -2 * ah)
        if (p.D == 0 or p.larger == q.larger) if ah == 0 else p.side(n, d) == q.side(n, d) == 0:
            return "equal"
    k = 64
    while abs(p.scaled(k) - q.scaled(k)) < 8:
        k *= 2
    return "after" if p.scaled(k) > q.scaled(k) else "before"


def check_timing(case, q):
    proof, t = case["proof"], case["t"]
    claim(case["verdict"] == q.verdict, f"the verdict is {q.verdict}")
    claim(proof["D"] == sign(q.sign_D), "sign of D")
    for name in "ABC":
        mantissa, exponent = proof[name].split("p")
        (n, d), m, e = getattr(q, name), int(mantissa, 16), int(exponent)
        claim((m << max(e, 0)) * d == n << max(-e, 0), name)
    if q.verdict in NEVER | NOW:
        return claim(t is None if q.verdict in NEVER else t == ["0x0p+0"] * 2, "t")
    lo, hi = map(double, t)
    (n, d), (m, e) = lo.as_integer_ratio(), (2**1024, 1) if hi == math.inf else hi.as_integer_ratio()
    mid = n * e + m * d, 2 * d * e
    claim([proof[k] for k in ("lo", "hi", "mid")] == [q.polynomial(*x) for x in ((n, d), (m, e), mid)], "signs")
    claim(q.side(n, d) == 0 if lo == hi else q.side(n, d) < 0 and (hi == math.inf or q.side(m, e) > 0), "t")
    claim(lo == hi or hi == math.nextafter(lo, math.inf), "lo and hi are not adjacent")
    check_nearest(case["nearest"], lo, hi, q.side(*mid))


class Plane(Query):
    """How far B is beyond the limit of a plane through A, b t + c = L - n.r - n.v t: linear, and rising where it is reached."""

    def __init__(self, q):
        n = len(q["u_A"])
        u, length = over_power_of_two(q["u_A"] + q["u_B"] + [q["L"]])
        w, speed = over_power_of_two(q["v_A"] + q["v_B"])
        normal, unit = over_power_of_two(q["normal"])
        b = -dot(normal, [w[n + k] - w[k] for k in range(n)])
        c = u[-1] * unit - dot(normal, [u[n + k] - u[k] for k in range(n)])
        self.A, self.B, self.C = (0, 1), (b, speed * unit), (c, length * unit)
        self.a, self.h, self.c, self.D, self.sign_D, self.larger = b * length, c * speed, 0, 0, b != 0, True
        approaches = "hit" if c < 0 else "contact" if c == 0 else "overlap"
        self.verdict = "static" if w[:n] == w[n:] else approaches if b > 0 else "receding"


def logarithm(x, bits):
    """Integers around -ln(x) 2^bits, 0 < x <= 1."""
    digits = Context(prec=bits // 3 + 40 + max(0, len(str(x.denominator)) - len(str(x.numerator))))
    ln = digits.divide(Decimal(x.numerator), Decimal(x.denominator))
    ln = F(digits.minus(digits.ln(ln)))
    middle = (ln.numerator << bits) // ln.denominator
    return middle - 2, middle + 2


def check_drag(case):
    """t = -ln(1 - gamma s)/gamma: on which side of it lie lo, hi and their middle?"""
    gamma, s = (F(double(case["in"][key])) for key in ("gamma", "s"))
    z, proof, t = gamma * s, case["proof"], case["t"]
    mantissa, exponent = proof["z"].split("p")
    claim(z == F(int(mantissa, 16)) * F(2) ** int(exponent), "z")
    claim(case["verdict"] == ("reached" if z < 1 else "never"), "verdict")
    if z >= 1:
        return claim(t is None and set(proof) == {"z"}, "t")
    lo, hi = map(double, t)
    claim((lo == hi == 0) if s == 0 else hi == math.nextafter(lo, math.inf), "lo and hi are not adjacent")
    ends = [F(x) if x < math.inf else F(2) ** 1024 for x in (lo, hi)]
    signs = []
    for x in (*ends, sum(ends) / 2):
        bits = 128 + max(0, z.denominator.bit_length() - z.numerator.bit_length())
        while s and not (gamma * x * 2**bits < (around := logarithm(1 - z, bits))[0] or gamma * x * 2**bits > around[1]):
            bits *= 2
        signs.append(0 if s == 0 else -1 if gamma * x * 2**bits < around[0] else 1)
    claim([proof[k] for k in ("lo", "hi", "mid")] == signs, "signs")
    claim(signs == [0, 0, 0] or (signs[0] < 0 < signs[1]), "t is not between lo and hi")
    check_nearest(case["nearest"], lo, hi, signs[2])


def limits(scene):
    """Every (pair law, i, j, kind, query) that can be the next event."""
    particles, tethers = scene["particles"], [set(t) for t in scene.get("tethers", [])]
    mass = [scene["species"][p["species"]]["mass"] for p in particles]
    for j, B in enumerate(particles):
        for i, A in enumerate(particles[:j]):
            laws = [p for p in scene["pairs"] if sorted(p["between"]) == sorted((A["species"], B["species"]))]
            for kind in ("blocking", "tethering") if {i, j} in tethers else ("blocking",):
                if laws and not mass[i] == mass[j] == "inf":
                    state = {"u_A": A["position"], "u_B": B["position"], "v_A": A["velocity"], "v_B": B["velocity"]}
                    query = Query({**state, "L": laws[0][kind]["distance"]}, "tether" if kind == "tethering" else "block")
                    yield laws[0][kind], i, j, kind, query


def check_next_event(case):
    scene = case["in"]["scene"]
    possible = [e for e in limits(scene) if e[4].verdict not in NEVER]
    law, i, j, kind, first = possible[0]
    for event in possible[1:]:
        if order(event[4], first) == "before":
            law, i, j, kind, first = event
    claim(sum(order(e[4], first) == "equal" for e in possible) == 1, "two events at one instant")
    claim((case["i"], case["j"]) == (i, j), f"the next event is of {i} and {j}")
    dt = (F(-first.h) + (1 if first.larger else -1) * root(F(first.D))) / first.a
    u = [plus(vector(p, "position"), vector(p, "velocity"), dt) for p in scene["particles"]]
    v = [vector(p, "velocity") for p in scene["particles"]]
    w = [inverse_mass(scene["species"][p["species"]], "mass") for p in scene["particles"]]
    pair = Pair(plus(u[j], u[i], -1), plus(v[j], v[i], -1), w[i], w[j])
    kinds = pair.kinds(law) if kind == "tethering" else ["rebound"]
    claim([case["kind"]] == kinds, f"the event is a {kinds}")
    dp = pair.impulse(kinds[0], {"c": law["c_rebound"]} if kind == "blocking" else law)
    v[i], v[j] = plus(v[i], dp, w[i]), plus(v[j], dp, -w[j])
    check_results(case, {"dt": [dt], "positions": sum(u, []), "velocities": sum(v, [])}, rational=False)


HEADER = {"schema", "version", "semantics", "op", "stratum", "why", "generator", "seed", "first", "count"}
# What a case may have beside its question and its answer; and the keys of answers. What is stored and not proven is believed by nobody.
FORM = {"id", "rev", "in", "tags", "twin", "level", "accept", "why"}
PROVEN = {"time": {"verdict", "t", "nearest", "proof", "cond"}, "order": {"order", "proof"},
          "next_event": {"kind", "i", "j", "out", "nearest", "cond"}, "response": {"kind", "also", "out", "nearest", "cond"}}


def check(case, op):
    kind = "time" if op.endswith("_time") else op if op in PROVEN else "response"
    unknown = set(case) - FORM - PROVEN[kind]
    claim(not unknown, f"no keys of this case: {', '.join(sorted(unknown))}")
    claim("rev" not in case or type(case["rev"]) is int and case["rev"] >= 1, "rev")
    claim("level" not in case or case["level"] in (1, 2, 3), "level")
    check_question(op, case["in"])
    if op == "drag_time":
        return check_drag(case)
    if op.endswith("_time"):
        return check_timing(case, Plane(case["in"]) if op == "wall_time" else Query(case["in"], op[:-5]))
    if op == "next_event":
        return check_next_event(case)
    if op != "order":
        return check_response(case, op)
    found = order(*(Query(case["in"][k], case["in"][k]["kind"]) for k in ("first", "second")))
    claim(case["order"] == found, f"the order is {found}")


def check_file(name, lines):
    """The number of cases, and of wrong ones."""
    header, count, cases, wrong = None, 0, 0, 0
    for number, line in enumerate(lines, 1):
        case = {}
        try:
            case = json.loads(line)
            if "schema" in case:  # files may follow one another
                claim(set(case) <= HEADER, f"no keys of a header: {', '.join(sorted(set(case) - HEADER))}")
                claim(header is None or count == header["count"], f"{count} cases where the header says {header and header['count']}")
                header, count = case, 0
                continue
            count, cases = count + 1, cases + 1
            check(case, header["op"])
        except BROKEN as error:
            wrong += 1
            print(f"{name}:{number}: {case.get('id', 'no case') if isinstance(case, dict) else case}: "
                  f"{type(error).__name__}: {error}")
    if header is None or count != header.get("count"):
        wrong += 1
        print(f"{name}: truncated: {count} cases, the header says {header and header.get('count')}")
    return cases, wrong


def main(names):
    here = os.path.dirname(os.path.abspath(__file__))
    names = names or sorted(glob.glob(os.path.join(here, "vectors", "*.jsonl")))
    cases = wrong = 0
    for name in names:
        try:
            with (sys.stdin if name == "-" else open(name, encoding="utf-8", errors="replace")) as lines:
                found = check_file(name, lines)
        except OSError as error:
            print(f"{name}: {error.strerror}")
            found = 0, 1
        cases, wrong = cases + found[0], wrong + found[1]
    print(f"{cases} cases in {len(names)} files, {wrong} wrong")
    return 1 if wrong or not cases else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
