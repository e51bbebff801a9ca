"""Responses, eqs. (3) to (7), friction and groups: exact rationals, no code of the project. Used by verify_vectors.py.

The roots, powers and angles of eq. (5) are taken to 300 bits, and an enclosure must then hold with 2^-250 of the largest
number around to spare.
"""
import math
from decimal import Context, Decimal
from fractions import Fraction as F

DIGITS, BITS, SPARE = Context(prec=130), 420, F(1, 2**250)


def claim(holds, what):
    if not holds:
        raise ValueError(what)


def double(text):
    claim(text == "inf" or text.lstrip("-").startswith("0x"), f"{text} is not a hexadecimal float")
    return float.fromhex(text)


def dot(x, y):
    return sum(a * b for a, b in zip(x, y))


def plus(x, y, factor=1):
    return [a + factor * b for a, b in zip(x, y)]


def check_nearest(name, lo, hi, middle_minus_truth):
    even = int(lo / math.ulp(lo)) % 2 == 0
    lower = middle_minus_truth > 0 or (middle_minus_truth == 0 and even)
    claim(name == ("lo" if lo == hi or lower else "hi"), f"nearest is not {name}")


def root(x):
    shift = BITS + abs(x.numerator.bit_length() - x.denominator.bit_length())
    return F(math.isqrt((x.numerator << 2 * shift) // x.denominator), 1 << shift)


def arctangent_of_inverse(n):
    return sum((-1) ** k * (1 << BITS) // ((2 * k + 1) * n ** (2 * k + 1)) for k in range(BITS // 4))


PI = 16 * arctangent_of_inverse(5) - 4 * arctangent_of_inverse(239)


def cosine_and_sine(degrees):
    one = 1 << BITS
    x, terms = PI * degrees.numerator // (180 * degrees.denominator), [one]
    for k in range(1, 120):
        terms.append((terms[-1] * x >> BITS) // k)
    return [F(sum((-1) ** (k // 2) * terms[k] for k in range(first, 120, 2)), one) for first in (0, 1)]


def power(c, x):
    c, x = (DIGITS.divide(Decimal(y.numerator), Decimal(y.denominator)) for y in (c, x))
    return F(DIGITS.exp(DIGITS.multiply(x, DIGITS.ln(c)))) if c else F(0)


class Pair:
    """Two bodies at a limit: r, v and inverse masses; the impulses of eqs. (4) and (5)."""

    def __init__(self, r, v, inverse_A, inverse_B):
        self.r, self.v, self.mu = r, v, 1 / (inverse_A + inverse_B)
        self.along = [dot(v, r) / dot(r, r) * x for x in r] if any(r) else v
        self.across = plus(v, self.along, -1)

    def impulse(self, kind, q):
        if kind != "revolve":
            return [(1 + number(q, "c" if "c" in q else "c_retract")) * self.mu * x for x in self.along]
        theta, (cosine, sine) = number(q, "theta_revolve_deg"), cosine_and_sine(number(q, "theta_revolve_deg"))
        speed = power(number(q, "c_revolve"), theta / 180) * root(dot(self.v, self.v))
        turned = [cosine * x / root(dot(self.across, self.across)) for x in self.across]
        turned = plus(turned, self.r, -sine / root(dot(self.r, self.r)))
        return [self.mu * (x - speed * y) for x, y in zip(self.v, turned)]

    def kinds(self, q):  # both where rounding decides
        cosine, sine = cosine_and_sine(number(q, "theta_revolve_deg"))
        closing = (number(q, "c_retract") * cosine) ** 2 * dot(self.along, self.along)
        needed = sine**2 * dot(self.across, self.across)
        if not any(self.across) or closing - needed > SPARE * closing:
            return ["retract"]
        return ["revolve"] if needed - closing > SPARE * needed else ["retract", "revolve"]


def cross(x, y):
    """Of two vectors of the plane one number; a spin of the plane, one component, turns a vector of it."""
    if len(x) == len(y) == 2:
        return [x[0] * y[1] - x[1] * y[0]]
    if len(x) == 1:
        return [-x[0] * y[1], x[0] * y[0]]
    return [x[k - 2] * y[k - 1] - x[k - 1] * y[k - 2] for k in range(3)]


def rough(q, kind):
    """Walton's rebound of discs and spheres that turn."""
    sides, K = "AB", F(1, 2) if len(q["u_A"]) == 2 else F(2, 5)
    w, v = [inverse_mass(q, "m_" + s) for s in sides], [vector(q, "v_" + s) for s in sides]
    spin, R = [vector(q, "spin_" + s) for s in sides], [number(q, "R_" + s) for s in sides]
    r = plus(vector(q, "u_B"), vector(q, "u_A"), -1)
    pair, axis = Pair(r, plus(v[1], v[0], -1), *w), [x / root(dot(r, r)) for x in r]
    normal = pair.impulse("rebound", q)
    surface = plus([R[0] * x for x in spin[0]], spin[1], R[1])
    g = plus(pair.across, cross(surface, axis), -1)
    factor, most = K / (1 + K) * (1 + number(q, "beta0")) * pair.mu, number(q, "mu") ** 2 * dot(normal, normal)
    excess = factor**2 * dot(g, g) - most
    decided = abs(excess) > SPARE * (most + factor**2 * (dot(pair.v, pair.v) + dot(surface, surface)))
    claim(not decided or kind == ("slides" if excess > 0 else "sticks"), f"the surfaces are not those of {kind}")
    size = factor if kind == "sticks" or not decided else root(most) / root(dot(g, g))
    across = [size * x for x in g]
    dp, turn = plus(normal, across), [x / K for x in cross(axis, across)]
    out = {"dp": dp, "v_A": plus(v[0], dp, w[0]), "v_B": plus(v[1], dp, -w[1])}
    return {**out, **{"spin_" + s: plus(spin[k], turn, w[k] / R[k]) for k, s in enumerate(sides)}}


def number(q, key):
    return F(double(q[key]))


def vector(q, key):
    return [F(double(t)) for t in (q[key] if isinstance(q[key], list) else [q[key]])]


def inverse_mass(q, key):
    return F(0) if q[key] == "inf" else 1 / number(q, key)


def response(op, q, kind):
    w_A, w_B, v_A, v_B = inverse_mass(q, "m_A"), inverse_mass(q, "m_B"), vector(q, "v_A"), vector(q, "v_B")
    r = plus(vector(q, "u_B"), vector(q, "u_A"), -1) if "u_A" in q else []
    pair = Pair(r, plus(v_B, v_A, -1), w_A, w_B)
    if op == "load":
        return {"v_load": plus(v_A, pair.v, pair.mu * w_A)}
    dp = vector(q, "dp") if "dp" in q else pair.impulse("revolve" if op == "revolution_impulse" else kind, q)
    if op == "restitution_impulse":
        return {"dp_AB": plus(dp, pair.v, -pair.mu)}
    out = {} if op == "apply_impulse" else {"dp": dp}
    after = {"v_A": plus(v_A, dp, w_A), "v_B": plus(v_B, dp, -w_B)}
    if op == "tether_response":
        claim(kind in pair.kinds(q), f"the response is not {kind}")
    return {**out, **after} if op in ("apply_impulse", "tether_response") else out


def group(q):
    """Velocities while loaded and after restitution. A body is its members; a wall keeps to itself."""
    w, v = [inverse_mass(b, "m") for b in q["bodies"]], [vector(b, "v") for b in q["bodies"]]
    body, inverse, undo = [{k} for k in range(len(w))], dict(enumerate(w)), []
    for c in q["collisions"]:
        i, j = c["i"], c["j"]
        r = plus(vector(q["bodies"][j], "u"), vector(q["bodies"][i], "u"), -1)
        claim(body[i].isdisjoint(body[j]) and (inverse[i] or inverse[j]) and any(r), "the collision is between two bodies")
        pair = Pair(r, plus(v[j], v[i], -1), inverse[i], inverse[j])
        claim(dot(pair.v, r) * (1 if c["limit"] == "inner" else -1) <= 0, "the bodies move towards the limit")
        kind = pair.kinds(c)[0] if c["limit"] == "outer" else None
        stored = plus(pair.impulse(kind, c), pair.v, -pair.mu)
        undo.append((set(body[i]), set(body[j]), stored, inverse[i], inverse[j]))
        joint = plus(v[i], pair.v, pair.mu * inverse[i])
        total = 0 if 0 in (inverse[i], inverse[j]) else 1 / (1 / inverse[i] + 1 / inverse[j])
        together = (body[i] | body[j]) - {k for k in (i, j) if w[k] == 0}
        for k in together:
            v[k], inverse[k], body[k] = joint, total, together
    loaded = list(v)
    for left, right, dp, w_i, w_j in reversed(undo):
        for side, factor in ((left, w_i), (right, -w_j)):
            for k in side:
                v[k] = plus(v[k], dp, factor)
    return loaded, v


def check_enclosure(names, enclosures, values, error):
    for name, (lo, hi), x in zip(names, (map(double, e) for e in enclosures), values, strict=True):
        F_lo, F_hi = [F(e) if math.isfinite(e) else (1 if e > 0 else -1) * F(2) ** 1024 for e in (lo, hi)]
        if lo == hi:
            claim(abs(x - F_lo) <= error, f"{float(x)} is not {lo}")
        claim(lo == -math.inf or lo == hi or F_lo <= x - error, f"{float(x)} is below its enclosure")
        claim(hi == math.inf or lo == hi or x + error <= F_hi, f"{float(x)} is above its enclosure")
        if name == "mid":  # not told from a double
            claim(lo < float(x) < hi and abs(x - F(float(x))) <= error, "the number is no double")
        else:
            claim(hi in (lo, math.nextafter(lo, math.inf)), "lo and hi are not adjacent")
            check_nearest(name, lo, hi, (F_lo + F_hi) / 2 - x)


def check_results(answer, values, rational):
    scale = sum(abs(x) for v in values.values() for x in v)
    claim(set(values) == set(answer["out"]), "keys of out")
    for key, components in values.items():
        exact = rational or key == "loaded"  # no impulse has been given yet
        check_enclosure(answer["nearest"][key], answer["out"][key], components, 0 if exact else SPARE * scale)


def check_response(case, op):
    q = case["in"]
    answers = [case] + case.get("also", [])
    claim(len({answer.get("kind") for answer in answers}) == len(answers), "two answers of one kind")
    for answer in answers:
        kind = answer.get("kind")
        if op == "group":
            values = {key: [x for v in found for x in v] for key, found in zip(("loaded", "restituted"), group(q))}
        else:
            values = rough(q, kind) if op == "rough_impulse" else response(op, q, kind)
        rational = op not in ("revolution_impulse", "rough_impulse") and kind != "revolve" and "outer" not in str(q)
        check_results(answer, values, rational)
