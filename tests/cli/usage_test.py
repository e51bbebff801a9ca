"""What a command line says that cannot be meant: exit code 2, and a message that names the words. Argument: the program."""
import os
import sys

import processes

REFUSED = [
    (["--versoin"], ["tps: there is no option --versoin; tps --help lists what there is"]),
    (["runn"], ["tps: there is no runn; did you mean run? There are ", "explain", "scene"]),
    (["nosuch"], ["tps: there is no nosuch; there are ", "run", "explain", "scene"]),
    (["scene", "nosuch", "--particles", "3"], ["tps scene: there is no nosuch; there are ", "terminal", "random"]),
    (["vectors", "nosuch"], ["tps vectors: there is no nosuch; there are ", "generate", "verify"]),
    (["scene"], ["A subcommand is required"]),
    (["scene", "terminal", "--impact-at", "90"], ["--impact-at is 90", "before --duration, 80"]),
    (["scene", "terminal", "--impact-at", "80"], ["--impact-at is 80", "--impacts 0"]),
    (["scene", "gas", "--particles", "2", "--periodic", "1"], ["--periodic 1", "--particles 2", "--density"]),
    (["scene", "random", "--features", "2d,3d"], ["--features", "2d and 3d exclude each other"]),
    (["conform", "--features", "groups,no-groups", "--", "true"], ["--features", "groups and no-groups exclude each other"]),
]
TAKEN = [
    ["scene", "terminal", "--impact-at", "90", "--impacts", "0"],
    ["scene", "terminal", "--impact-at", "79"],
    ["scene", "random", "--features", "2d,no-groups", "--seed", "1", "--number", "0"],
]


def main():
    tps = os.path.abspath(sys.argv[1])
    failures = processes.Failures()
    for words, named in REFUSED:
        code, out, err = processes.run([tps, *words])
        failures.expect(code == 2 and not out, f"{words}: exit code {code}, {out[:200]}")
        for word in named:
            failures.expect(word in err, f"{words}: no {word!r} in {err!r}")
    for words in TAKEN:
        code, out, err = processes.run([tps, *words])
        failures.expect(code == 0 and out.startswith("{"), f"{words}: exit code {code}, {err}")
    return failures.conclude("what cannot be meant")


if __name__ == "__main__":
    sys.exit(main())
