"""Eq. (2) by the decision tables of docs/eq2.md: in doubles ("stable"), and exactly ("certified")."""
import math
from fractions import Fraction

from numbers_of_traces import dot, minus, norm

INNER, OUTER = "inner", "outer"


class Root:
    """The time (p + s √d)/a × 2^k with integers p, d ≥ 0, a > 0 and s = −1, 0 or 1."""

    def __init__(self, p, s, d, a, k):
        self.p, self.s, self.d, self.a, self.k = p, s, d, a, k

    def fraction(self, numerator):
        """numerator/a × 2^k"""
        return Fraction(numerator << max(self.k, 0), self.a << max(-self.k, 0))

    def quotient(self, numerator, bits=0):
        """The double nearest to numerator/a × 2^(k − bits): what Python divides integers to."""
        k = self.k - bits
        return (numerator << max(k, 0)) / (self.a << max(-k, 0))

    def rounded(self):
        """The nearest double."""
        root = math.isqrt(self.d)
        if self.s == 0 or root * root == self.d:
            return self.quotient(self.p + self.s * root)
        bits = 64
        while True:
            root = math.isqrt(self.d << 2 * bits)
            low, high = (self.quotient((self.p << bits) + self.s * r, bits) for r in (root, root + 1))
            if low == high:
                return low
            bits *= 2


def sign(x):
    return (x > 0) - (x < 0)


def sign_of_sum(x, y, d):
    """The sign of x + y √d."""
    if y == 0 or d == 0:
        return sign(x)
    if x == 0 or sign(x) == sign(y):
        return sign(y)
    return sign(x) * sign(x * x - y * y * d)


def compare(start_1, root_1, start_2, root_2):
    """The sign of (start_1 + root_1) − (start_2 + root_2), exactly; a root may be None."""
    x = start_1 - start_2
    y = z = Fraction(0)
    d1 = d2 = 0
    if root_1:
        x, y, d1 = x + root_1.fraction(root_1.p), root_1.fraction(root_1.s), root_1.d
    if root_2:
        x, z, d2 = x - root_2.fraction(root_2.p), -root_2.fraction(root_2.s), root_2.d
    if z == 0 or d2 == 0:
        return sign_of_sum(x, y, d1)
    if y == 0 or d1 == 0:
        return sign_of_sum(x, z, d2)
    both = sign(y) if sign(y) == sign(z) else sign(y) * sign(y * y * d1 - z * z * d2)
    if x == 0 or both == 0 or sign(x) == both:
        return both or sign(x)
    return sign(x) * sign_of_sum(x * x - y * y * d1 - z * z * d2, -2 * y * z, d1 * d2)


def integers(vectors):
    """Vectors of doubles as integers, and k: each is the integer times 2^k."""
    ratios = [[x.as_integer_ratio() for x in v] for v in vectors]
    bits = max(d.bit_length() - 1 for v in ratios for _, d in v)
    return [[n << (bits - d.bit_length() + 1) for n, d in v] for v in ratios], -bits


def exact_root(u_i, u_j, v_i, v_j, limit, kind, only_hit=False):
    """The exact Root of a pair's next event at a limit, or None. `only_hit`: it has just responded there."""
    (x_i, x_j, length), k_u = integers([u_i, u_j, (limit,)])
    (w_i, w_j), k_v = integers([v_i, v_j])
    r, v, L = [b - a for a, b in zip(x_i, x_j)], [b - a for a, b in zip(w_i, w_j)], length[0]
    a, h = sum(x * x for x in v), sum(x * y for x, y in zip(r, v))
    c = sum(x * x for x in r) - L * L
    d, k = h * h - a * c, k_u - k_v
    if a == 0:
        return None
    if kind == INNER:
        if h >= 0:
            return None
        if c <= 0:
            return Root(0, 0, 0, 1, 0)
        return Root(-h, -1, d, a, k) if d > 0 else None
    if c < 0:
        return Root(-h, 1, d, a, k)
    if c == 0 and h < 0:
        return Root(-2 * h, 0, 0, a, k)
    if h >= 0:
        return None if only_hit else Root(0, 0, 0, 1, 0)
    if d > 0:
        return Root(-h, 1, d, a, k)
    # It never comes back inside: it is pulled where it turns, or where real arithmetic has it after a pull (D17).
    return Root(-2 * h if only_hit else -h, 0, 0, a, k)


def stable_time(u_i, u_j, v_i, v_j, limit, kind, only_hit=False):
    """The same in doubles, without cancellation: the time or None."""
    r, v = minus(u_j, u_i), minus(v_j, v_i)
    scale_u, scale_v = math.frexp(max(map(abs, r + (limit,))))[1], math.frexp(max(map(abs, v)))[1]
    r = tuple(math.ldexp(x, -scale_u) for x in r)
    v = tuple(math.ldexp(x, -scale_v) for x in v)
    L = math.ldexp(limit, -scale_u)
    a, h, distance = dot(v, v), dot(r, v), norm(r)
    if a == 0:
        return None
    c = (distance - L) * (distance + L) if distance < 2 * L else dot(r, r) - L * L
    cross = cross_square(r, v)
    d = h * h - a * c if h * h < a * L * L else a * L * L - cross
    t = root_by_table(a, h, c, d, kind, only_hit)
    return None if t is None else math.ldexp(t, scale_u - scale_v)


def cross_square(r, v):
    if len(r) == 2:
        return (r[0] * v[1] - r[1] * v[0]) ** 2
    return sum((r[i] * v[j] - r[j] * v[i]) ** 2 for i, j in ((0, 1), (1, 2), (2, 0)))


def root_by_table(a, h, c, d, kind, only_hit):
    if kind == INNER:
        if h >= 0:
            return None
        if c <= 0:
            return 0.0
        return c / (-h + math.sqrt(d)) if d > 0 else None
    if c < 0:
        return (-h + math.sqrt(max(d, 0.0))) / a if h <= 0 else -c / (h + math.sqrt(max(d, 0.0)))
    if c == 0 and h < 0:
        return -2 * h / a
    if h >= 0:
        return None if only_hit else 0.0
    if d > 0:
        return (-h + math.sqrt(d)) / a
    return -2 * h / a if only_hit else -h / a
