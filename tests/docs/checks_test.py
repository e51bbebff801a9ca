"""The checks of partners and of links see each of these faults, put into a copy of the pages and sources one at a time."""

import pathlib
import shutil
import sys
import tempfile

import check_links
import check_partners

# check, file, text in it, what it is replaced by, a part of what the check must say
FAULTS = [
    (check_partners.missing_partners, "docs/eq5.md", "properties/laws/eq5_revolution_laws.cpp", "properties/laws/eq6_load_laws.cpp",
     "docs/eq5.md does not name properties/laws/eq5_revolution_laws.cpp as laws"),
    (check_partners.missing_partners, "docs/eq4.md", "| oracle |", "| others |", "docs/eq4.md: no links in the row oracle"),
    (check_partners.missing_partners, "docs/eq3.md", "tests/certified/response_test.cpp", "tests/certified/no_test.cpp",
     "docs/eq3.md: tests tests/certified/no_test.cpp does not exist"),
    (check_partners.missing_partners, "docs/eq1.md", "| laws | [`eq1_distance_laws.cpp`](../properties/laws/",
     "| laws | [`wide.hpp`](../properties/wide.hpp), [`eq1_distance_laws.cpp`](../properties/laws/",
     "docs/eq1.md: laws properties/wide.hpp is not in properties/laws/"),
    (check_partners.missing_partners, "reference/equations/eq6_load_velocity.hpp", "docs/eq6.md", "docs/eq7.md",
     "reference/equations/eq6_load_velocity.hpp does not name its page docs/eq6.md"),
    (check_partners.missing_partners, "properties/laws/eq6_load_laws.cpp", "docs/eq6.md", "the page",
     "properties/laws/eq6_load_laws.cpp does not name its page"),
    (check_partners.missing_partners, "properties/laws/eq2_order_laws.cpp", "docs/exact.md, docs/eq2.md", "docs/trace.md",
     "none of the pages that properties/laws/eq2_order_laws.cpp names names it: trace"),
    (check_partners.missing_partners, "properties/laws/group_laws.cpp", ", docs/eq7.md", "",
     "properties/laws/group_laws.cpp has laws of docs/eq6.md alone, but not its stem: call it eq6_group_laws.cpp"),
    (check_partners.missing_partners, "README.md", "](properties/laws/eq3_impulse_laws.cpp)", "](properties/laws/eq6_load_laws.cpp)",
     "README.md, row (3), laws: properties/laws/eq6_load_laws.cpp is not what docs/eq3.md names"),
    (check_partners.missing_partners, "README.md", "| (7) ", "| 7 ", "README.md has no row (7)"),
    (check_links.broken, "docs/map.md", "](glossary.md)", "](glosary.md)", "docs/map.md: the link glosary.md leads to no file"),
    (check_links.broken, "docs/map.md", "](check.md#bounds)", "](check.md#bound)",
     "docs/map.md: the link check.md#bound leads to no heading"),
    (check_links.broken, "docs/semantics.md", "`tests/engine/escape_test.cpp`", "`tests/engine/escapes_test.cpp`",
     "docs/semantics.md: `tests/engine/escapes_test.cpp` does not exist"),
    (check_links.broken, "docs/semantics.md", "## §6 ", "## §7 ", "reference/engine/queue.hpp cites semantics §6"),
    (check_links.broken, "docs/map.md", "| `reference/engine/` |", "| `reference/engines/` |",
     "docs/map.md has no row for reference/engine/"),
    (check_links.broken, "reference/equations/vector.hpp", "docs/eq1.md", "docs/vector.md",
     "reference/equations/vector.hpp names docs/vector.md, which does not exist"),
    (check_links.broken, "reference/engine/energy_share.hpp", '"Effect by effect"', '"Effect for effect"',
     'reference/engine/energy_share.hpp cites docs/ledger.md, "Effect for effect"'),
]


def copy_of(root, target):
    """Pages and sources; what is large and is only pointed to, as links."""
    for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE"):
        shutil.copy(root / name, target)
    for name in ("docs", "reference", "properties"):
        shutil.copytree(root / name, target / name)
    for name in ("verify", "tests", "data", "site"):
        (target / name).symlink_to(root / name)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder)
        copy_of(root, target)
        for check, name, text, other, said in FAULTS:
            file = target / name
            good = file.read_text(encoding="utf-8")
            if text not in good:
                wrong.append(f"{name} has no {text!r} to put a fault into")
                continue
            file.write_text(good.replace(text, other, 1), encoding="utf-8")
            found = list(check(target))
            file.write_text(good, encoding="utf-8")
            if not any(said in line for line in found):
                wrong.append(f"{name} with {other!r} for {text!r}: {check.__module__} says {found}, not {said!r}")
        for check in (check_partners.missing_partners, check_links.broken):
            wrong += [f"without a fault {check.__module__} says: {line}" for line in check(target)]
    print("\n".join(wrong) or f"{len(FAULTS)} faults, each seen")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
