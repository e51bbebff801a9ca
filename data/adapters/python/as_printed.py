"""Eq. (2) as the paper prints it: the smaller real, non-negative root of a t^2 + b t + c, whatever the pair does."""
import math

from protocol import serve
from timing import dot, minus


def collision_time(u_A, u_B, v_A, v_B, L):
    r, v = minus(u_B, u_A), minus(v_B, v_A)
    a, b, c = dot(v, v), 2 * dot(r, v), dot(r, r) - L * L
    discriminant = b * b - 4 * a * c
    if a == 0 or discriminant < 0:
        return {"t": None}
    root = math.sqrt(discriminant)
    ahead = [t for t in ((-b - root) / (2 * a), (-b + root) / (2 * a)) if t >= 0]
    return {"t": min(ahead, default=None)}


if __name__ == "__main__":
    serve("as printed", {"block_time": collision_time, "tether_time": collision_time})
