#!/usr/bin/env python3
"""Includes run one way: properties -> verify -> reference, and never in a circle between folders.

tower.py ROOT     counts the includes between folders and fails on one that runs up or round
"""
import collections
import pathlib
import re
import sys

STOREYS = ["reference", "verify", "properties"]  # each may include those before it
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]((?:reference|verify|properties|\.)/[^">]+|\.\./[^">]+)[">]', re.MULTILINE)


def folder(path):
    """"verify/exact" of "verify/exact/verdict.hpp". A file that lies in a storey directly (scalars.hpp, law.hpp) is,
    with those of its stem, a folder of its own.

    A folder's verb stands above the folder: it may use all others, and nobody uses it.
    """
    if is_verb(path):
        return path.split("/")[0] + "/verbs"
    parts = pathlib.PurePosixPath(path).parts
    if len(parts) == 2:
        return path.split(".")[0]
    return "/".join(parts[:-1][:3 if "benchmark" in parts else 2])


def is_verb(path):
    return path.endswith("_verb.cpp")


def circles(arrows):
    """Folders that include each other, directly or by way of others."""
    def reach(start):
        seen, open_ = set(), [start]
        while open_:
            for target in arrows.get(open_.pop(), ()):
                if target not in seen:
                    seen.add(target)
                    open_.append(target)
        return seen
    return sorted(f for f in arrows if f in reach(f))


def main():
    root = pathlib.Path(sys.argv[1])
    counts = collections.Counter()
    wrong = []
    sources = [p for storey in STOREYS for p in sorted((root / storey).rglob("*")) if p.suffix in (".hpp", ".cpp", ".h", ".c")]
    if not sources:
        sys.exit(f"{root} has none of the folders {', '.join(STOREYS)}")
    for source in sources:
        name = source.relative_to(root).as_posix()
        for target in INCLUDE.findall(source.read_text()):
            if target.startswith("."):
                wrong.append(f"{name} includes {target}: paths begin at the root of the tree")
                continue
            if is_verb(target):
                wrong.append(f"{name} includes {target}: nobody uses a verb")
            if STOREYS.index(target.split("/")[0]) > STOREYS.index(name.split("/")[0]):
                wrong.append(f"{name} includes {target}: an arrow that runs up")
            if not (root / target).exists() and "catalogue" not in target:
                wrong.append(f"{name} includes {target}, which is not there")
            if folder(name) != folder(target):
                counts[folder(name), folder(target)] += 1
    arrows = collections.defaultdict(set)
    for source, target in counts:
        arrows[source].add(target)
    wrong += [f"{f} is in a circle of includes" for f in circles(arrows)]
    for (source, target), count in sorted(counts.items()):
        print(f"{count:5} {source} -> {target}")
    print(f"{sum(counts.values())} includes between folders, {len(wrong)} of them wrong")
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
