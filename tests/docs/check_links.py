"""Whatever the pages and the comments of the sources point to is there.

In the Markdown files: relative links with their anchors, and paths in backquotes such as `tests/engine/escape_test.cpp`. In
sources, schemas and scripts: pages named as docs/NAME.md, their sections cited as docs/NAME.md, "Title", and those of
docs/semantics.md cited as "semantics §N".
docs/map.md has a row for each folder of code.
"""

import pathlib
import re
import sys

from conclude import conclude

FOLDERS = ("reference", "verify", "properties", "tests", "docs", "data", "site")
PAGES = ("*.md", "docs/*.md", "data/*.md")
SOURCES = (".hpp", ".cpp", ".h", ".c", ".in", ".py", ".txt", ".json", ".md")
LINK = re.compile(r"(?<!`)\[[^\]]*\]\(([^)\s]+)\)")
BLOCK = re.compile(r"^```.*?^```$", re.M | re.S)
QUOTED_PATH = re.compile(rf"`((?:{'|'.join(FOLDERS)})/[\w./-]*\w(?:\.\w+|/))`")
CITED_SECTION = re.compile(r'\b(docs/[\w-]+\.md), "([^"]+)"')
CONTINUED = re.compile(r"\n\s*(?://+|#) ?")  # a comment that goes on in the next line
WRITTEN_LATER = {"data/regressions/found.jsonl"}
PLACEHOLDER = re.compile(r"eqN|/name[._]")


def text_of(path):
    return path.read_text(encoding="utf-8", errors="replace")


def anchors(text):
    """The names that a reader's browser knows the headings by, as GitHub makes them."""
    seen = {}
    for heading in re.findall(r"^#+ +(.*?) *$", BLOCK.sub("", text), re.M):
        name = re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()).replace(" ", "-")
        count = seen[name] = seen.get(name, -1) + 1
        yield f"{name}-{count}" if count else name


def titles(text):
    """Headings, and what paragraphs begin with in bold."""
    text = BLOCK.sub("", text)
    return {title.strip(" .`") for title in re.findall(r"^#+ +(.*?) *$", text, re.M) + re.findall(r"\*\*(.+?)\*\*", text)}


def broken_links(root, page):
    name, text = page.relative_to(root).as_posix(), BLOCK.sub("", text_of(page))
    for link in LINK.findall(text):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = page.parent / path if path else page
        if not target.exists():
            yield f"{name}: the link {link} leads to no file"
        elif anchor and anchor not in anchors(text_of(target)):
            yield f"{name}: the link {link} leads to no heading; there are {', '.join(anchors(text_of(target)))}"
    for path in QUOTED_PATH.findall(text):
        if path not in WRITTEN_LATER and not PLACEHOLDER.search(path) and not (root / path).exists():
            yield f"{name}: `{path}` does not exist"


def broken_citations(root, source, sections):
    name, text = source.relative_to(root).as_posix(), text_of(source)
    for path in sorted(set(re.findall(r"\bdocs/[\w-]+\.md\b", text))):
        if not PLACEHOLDER.search(path) and not (root / path).is_file():
            yield f"{name} names {path}, which does not exist"
    for path, title in sorted(set(CITED_SECTION.findall(CONTINUED.sub(" ", text)))):
        if (root / path).is_file() and not any(it == title or it.startswith(f"{title}:") for it in titles(text_of(root / path))):
            yield f'{name} cites {path}, "{title}": the page has no such heading, nor a paragraph that begins with it in bold'
    for number in sorted(set(re.findall(r"semantics §(\d+)", text)) - sections):
        yield f"{name} cites semantics §{number}; docs/semantics.md has the sections {', '.join(sorted(sections))}"


def folders_without_a_row(root):
    page = text_of(root / "docs" / "map.md")
    for floor in ("reference", "verify", "properties"):
        for folder in sorted(path.name for path in (root / floor).iterdir() if path.is_dir()):
            if f"| `{floor}/{folder}/` |" not in page:
                yield f"docs/map.md has no row for {floor}/{folder}/"


def broken(root):
    yield from folders_without_a_row(root)
    pages = [page for pattern in PAGES for page in sorted(root.glob(pattern))]
    sections = set(re.findall(r"^## §(\d+)", text_of(root / "docs" / "semantics.md"), re.M))
    for page in pages:
        yield from broken_links(root, page)
    here = root / "tests" / "docs"
    for folder in FOLDERS:
        for source in sorted((root / folder).rglob("*")):
            if source.suffix in SOURCES and source.is_file() and here not in source.parents:
                yield from broken_citations(root, source, sections)


if __name__ == "__main__":
    sys.exit(conclude(broken(pathlib.Path(sys.argv[1])), "links, paths and citations lead to what they name"))
