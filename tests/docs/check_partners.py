"""Fails when an equation header lacks its test or page, or a test or page its header (same stem everywhere)."""

import pathlib
import re
import sys


def missing_partners(root):
    headers = {path.stem for path in (root / "reference" / "equations").glob("*.hpp")}
    tests = {path.stem.removesuffix("_test") for path in (root / "tests" / "equations").glob("*_test.cpp")}
    pages = {path.stem: path.read_text(encoding="utf-8") for path in (root / "docs").glob("*.md")}
    for stem in sorted(headers - tests):
        yield f"reference/equations/{stem}.hpp has no tests/equations/{stem}_test.cpp"
    for stem in sorted(tests - headers - {"accuracy"}):
        yield f"tests/equations/{stem}_test.cpp has no reference/equations/{stem}.hpp"
    for stem in sorted(headers):
        number = re.match(r"eq\d+", stem)
        page = number[0] if number else None
        if page and page not in pages:
            yield f"reference/equations/{stem}.hpp has no docs/{page}.md"
        elif not any(f"{stem}.hpp" in text for name, text in pages.items() if page in (None, name)):
            yield f"reference/equations/{stem}.hpp is named by no page" + (f" docs/{page}.md" if page else "")
    for page in sorted(name for name in pages if re.fullmatch(r"eq\d+", name)):
        if not any(stem.startswith(page + "_") for stem in headers):
            yield f"docs/{page}.md has no reference/equations/{page}_*.hpp"


def main():
    missing = list(missing_partners(pathlib.Path(sys.argv[1])))
    print("\n".join(missing) or "every equation has its header, test and page")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
