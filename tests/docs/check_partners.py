"""Each equation has its header, laws, oracle, tests and page, and one finds the other.

The stem of a header is that of its test. A page docs/eqN.md ends with a table of four rows, header, laws, oracle,
tests, whose links lead to files of the right folder. Headers and laws name their page in their first comment; laws of one
equation have the stem of its page: eqN_name_laws.cpp. README.md
has a row for each equation, whose links are among those of its page.
"""

import pathlib
import re
import sys

from conclude import conclude

FOLDERS = {"header": ("reference/equations/",), "laws": ("properties/laws/",), "oracle": ("verify/", "tests/equations/"),
           "tests": ("tests/",)}
LINK = re.compile(r"\]\(([^)#]+)[^)]*\)")


def text_of(path):
    return path.read_text(encoding="utf-8")


def first_comment(path):
    return re.match(r"(?://.*\n)*", text_of(path))[0]


def missing_headers_and_tests(root):
    headers = {path.stem for path in (root / "reference" / "equations").glob("*.hpp")}
    tests = {path.stem.removesuffix("_test") for path in (root / "tests" / "equations").glob("*_test.cpp")}
    for stem in sorted(headers - tests):
        yield f"reference/equations/{stem}.hpp has no tests/equations/{stem}_test.cpp"
    for stem in sorted(tests - headers - {"accuracy"}):
        yield f"tests/equations/{stem}_test.cpp has no reference/equations/{stem}.hpp"


def partners(page):
    """{row: [path from the root, …]} of the table under "The same in code"."""
    section = text_of(page).partition("\n## The same in code\n")[2]
    rows = re.findall(r"^\| (\w+) \| (.*) \|$", section, re.M)
    return {row: [link.removeprefix("../") for link in LINK.findall(cell) if link.startswith("../")] for row, cell in rows}


def missing_of_page(root, page, table):
    name = f"docs/{page.name}"
    for row, folders in FOLDERS.items():
        paths = table.get(row, [])
        if not paths:
            yield f"{name}: no links in the row {row} of the table under 'The same in code'"
        for path in paths:
            if not (root / path).is_file():
                yield f"{name}: {row} {path} does not exist"
            elif not path.startswith(folders):
                yield f"{name}: {row} {path} is not in {' or '.join(folders)}"
            elif row in ("header", "laws") and name not in first_comment(root / path):
                yield f"{path} does not name {name} in its first comment, but the page names it as {row}"
    if not any(re.match(rf"reference/equations/{page.stem}_", path) for path in table.get("header", [])):
        yield f"{name} names no header reference/equations/{page.stem}_*.hpp"


def missing_pages(root, tables):
    """Headers and laws that name no page, or one that does not name them."""
    sources = [(path, "header") for path in (root / "reference" / "equations").glob("*.hpp")]
    sources += [(path, "laws") for path in (root / "properties" / "laws").glob("*_laws.cpp")]
    for path, row in sorted(sources):
        name = path.relative_to(root).as_posix()
        pages = [page for page in re.findall(r"docs/(\w+)\.md", first_comment(path)) if page != "semantics"]
        stem = re.match(r"eq\d+(?=_)", path.stem)
        if not pages or (stem and stem[0] not in pages):
            yield f"{name} does not name its page docs/{stem[0] if stem else 'NAME'}.md in its first comment"
        equations = [page for page in pages if page in tables]
        if row == "laws" and len(equations) == 1 and not path.name.startswith(equations[0] + "_"):
            yield f"{name} has laws of docs/{equations[0]}.md alone, but not its stem: call it {equations[0]}_{path.name}"
        for page in pages:
            if page in tables and name not in tables[page].get(row, []):
                yield f"docs/{page}.md does not name {name} as {row}"
        if pages and not any(path.name in text_of(root / "docs" / f"{page}.md") for page in pages):
            yield f"none of the pages that {name} names names it: {', '.join(pages)}"


def missing_in_readme(root, tables):
    readme = text_of(root / "README.md")
    if "| equation | header | laws | oracle | page |" not in readme:
        yield "README.md has no table with the columns equation, header, laws, oracle, page"
    for page, table in sorted(tables.items()):
        row = re.search(rf"^\| \({page[2:]}\) .*$", readme, re.M)
        cells = row[0].strip("|").split("|") if row else []
        if len(cells) != 5 or f"docs/{page}.md" not in cells[4]:
            yield f"README.md has no row ({page[2:]}) of five columns with docs/{page}.md"
            continue
        for column, cell in zip(("header", "laws", "oracle"), cells[1:4]):
            paths = LINK.findall(cell)
            for path in paths or ["nothing"]:
                if path not in table.get(column, []):
                    yield f"README.md, row ({page[2:]}), {column}: {path} is not what docs/{page}.md names"


def missing_partners(root):
    pages = sorted(path for path in (root / "docs").glob("eq*.md") if re.fullmatch(r"eq\d+", path.stem))
    tables = {page.stem: partners(page) for page in pages}
    yield from missing_headers_and_tests(root)
    for page in pages:
        yield from missing_of_page(root, page, tables[page.stem])
    yield from missing_pages(root, tables)
    yield from missing_in_readme(root, tables)
    if not pages:
        yield f"{root}/docs has no page eqN.md"


if __name__ == "__main__":
    sys.exit(conclude(missing_partners(pathlib.Path(sys.argv[1])), "every equation has its header, laws, oracle, tests and page, and one finds the other"))
