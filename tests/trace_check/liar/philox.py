"""Philox4x32-10 of Random123, and the uniform numbers that a scene's seed gives."""
TETHER_FORM, TETHER_BREAK = 3, 4
_MASK = 0xFFFFFFFF


def philox(key, counter):
    k0, k1 = key
    c = list(counter)
    for _ in range(10):
        a, b = 0xD2511F53 * c[0], 0xCD9E8D57 * c[2]
        c = [(b >> 32) ^ c[1] ^ k0, b & _MASK, (a >> 32) ^ c[3] ^ k1, a & _MASK]
        k0, k1 = (k0 + 0x9E3779B9) & _MASK, (k1 + 0xBB67AE85) & _MASK
    return c


def uniform(seed, purpose, first, second, n):
    """Draw number n of the stream (seed, purpose, two ids), in [0, 1)."""
    words = philox((seed & _MASK, seed >> 32), (purpose, first, second, n))
    return ((words[1] << 32 | words[0]) >> 11) * 2.0**-53
