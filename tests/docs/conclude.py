"""How a check of pages ends."""


def conclude(faults, otherwise):
    """Prints the faults, or what holds where there are none; the exit code."""
    found = list(faults)
    print("\n".join(found) or otherwise)
    return 1 if found else 0
