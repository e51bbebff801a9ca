"""Numbers of a trace: exact hexadecimal text, times that are the sum of two doubles, ulps."""
import math
from fractions import Fraction


def hexadecimal(x):
    """A double or a dyadic fraction, exactly, as docs/trace.md writes it."""
    if isinstance(x, float):
        if math.isinf(x):
            return "inf"
        if x == 0:
            return "-0x0p+0" if math.copysign(1, x) < 0 else "0x0p+0"
        if abs(x) >= 2.0**-1022:
            digits, exponent = x.hex().split("p")
            return f"{digits.rstrip('0').rstrip('.') if '.' in digits else digits}p{exponent}"
        x = Fraction(x)
    if x == 0:
        return "0x0p+0"
    sign, numerator, denominator = "-" if x < 0 else "", abs(x.numerator), x.denominator
    exponent = numerator.bit_length() - denominator.bit_length()  # the denominator is a power of two
    places = -(-(numerator.bit_length() - 1) // 4) * 4
    tail = (numerator << places >> (numerator.bit_length() - 1)) - (1 << places)
    digits = f"{tail:0{places // 4}x}".rstrip("0") if places else ""
    return f"{sign}0x1{'.' + digits if digits else ''}p{exponent:+d}"


def vector_text(v):
    return [hexadecimal(x) for x in v]


def two_sum(a, b):
    s = a + b
    part = s - a
    return s, (a - (s - part)) + (b - part)


def after(t, dt):
    """The clock (hi, lo) moved on by dt."""
    s, rest = two_sum(t[0], dt)
    if math.isinf(s):
        return (s, 0.0)
    rest += t[1]
    hi = s + rest
    return (hi, rest - (hi - s))


def elapsed(earlier, later):
    """later − earlier, rounded once to a double."""
    return math.fsum((later[0], later[1], -earlier[0], -earlier[1]))


def exact(t):
    return Fraction(t[0]) + Fraction(t[1]) if t[1] else Fraction(t[0])


def next_after(x, steps=1):
    """The double `steps` ulps away from zero."""
    for _ in range(steps):
        x = math.nextafter(x, math.copysign(math.inf, x))
    return x


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(a):
    """|a|, scaled so that no square leaves the range."""
    largest = max(abs(x) for x in a)
    if largest == 0:
        return 0.0
    _, e = math.frexp(largest)
    return math.ldexp(math.sqrt(sum(math.ldexp(x, -e) ** 2 for x in a)), e)


def plus(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(factor, a):
    return tuple(factor * x for x in a)


def off_by(v, steps):
    """Its largest component so many ulps outwards."""
    k = max(range(len(v)), key=lambda n: abs(v[n]))
    return tuple(next_after(x, steps) if n == k else x for n, x in enumerate(v))
