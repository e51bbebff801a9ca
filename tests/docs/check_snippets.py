"""Compares what pages show with what is there: code with the compiled snippet, output with what is printed.

In a page, `<!-- snippet: STEM -->` stands before a ```cpp block, the text of docs/snippets/STEM.cpp between its
markers, and a ```text block with what `docs_snippets eqN` prints. In a ```console block each line that starts with
`$ tps` is run in the repository's root; the lines under it are what it prints (standard output, then errors). A line
`…` stands for any lines. `--write` puts the present code and output into the pages instead of comparing.

A page that says `<!-- file: PATH as NAME -->` before a block is a tutorial: it starts in an empty folder. The block is the
text of PATH, which from there on is NAME in that folder; with `part:` for `file:` the block is a part of that text. From the
first of these on every `$` line is run, in that folder.

`--but COMMAND` leaves out what another test compares; `--write` does not.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
SNIPPET = re.compile(r"<!-- snippet: (\w+) -->\n\Z")
FILE = re.compile(r"<!-- (file|part): (\S+) as (\S+) -->\n\Z")


def matches(shown, printed):
    """Whether printed lines are those shown, `…` standing for any number of them."""
    pattern = "".join(r"(?:.*\n)*?" if line.strip() == "…" else re.escape(line) + r"\n" for line in shown.splitlines())
    text = "\n".join(line.rstrip() for line in printed.splitlines()) + ("\n" if printed else "")
    return re.fullmatch(pattern, text) is not None


class Page:
    def __init__(self, path, arguments):
        self.path, self.arguments = path, arguments
        self.text = path.read_text(encoding="utf-8")
        self.failures, self.compared, self.pieces, self.done = [], 0, [], 0
        self.folder = None  # of a tutorial

    def expect(self, block, what, shown, present):
        self.compared += 1
        if not matches(shown, present):
            line = self.text.count("\n", 0, block.start()) + 1
            self.failures.append(f"{self.path}:{line}: {what} differs; shown:\n{shown}present:\n{present}")
        return shown if matches(shown, present) else present

    def run(self, command):
        environment = dict(os.environ, PATH=f"{self.arguments.tps.parent}:{os.environ['PATH']}", TPS_PROGRESS="never")
        result = subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=120,
                                cwd=self.folder.name if self.folder else self.arguments.root, env=environment)
        return result.stdout + result.stderr

    def put_file(self, block, marker):
        """The block as a file of the tutorial's folder, or as a part of one."""
        whole, path, name = marker[1] == "file", self.arguments.root / marker[2], marker[3]
        self.folder = self.folder or tempfile.TemporaryDirectory()
        shutil.copyfile(path, pathlib.Path(self.folder.name) / name)
        text = path.read_text(encoding="utf-8")
        return self.expect(block, f"{marker[2]}", block[2], text if whole or block[2] not in text else block[2])

    def console(self, block):
        """Commands with their output, in turn; outside of a tutorial anything but `$ tps …` is left as it is."""
        parts = re.split(r"^(\$ .*\n(?:> .*\n)*)", block[2], flags=re.M)
        body = parts[0]
        for command, output in zip(parts[1::2], parts[2::2]):
            body += command
            left_out = command[2:].strip() in self.arguments.but and not self.arguments.write
            if (command.startswith("$ tps") or self.folder) and not left_out:
                output = self.expect(block, command.strip(), output, self.run(command[2:].replace("\n> ", "\n")))
            body += output
        return body

    def check(self):
        stem = None
        for block in BLOCK.finditer(self.text):
            body = block[2]
            marker = SNIPPET.search(self.text[:block.start()])
            file = FILE.search(self.text[:block.start()])
            if file:
                body = self.put_file(block, file)
            elif block[1] == "cpp" and marker:
                stem = marker[1]
                source = (self.arguments.root / "docs" / "snippets" / f"{stem}.cpp").read_text(encoding="utf-8")
                code = textwrap.dedent(source.split("  // [snippet]\n")[1])
                body = self.expect(block, f"the code of {stem}", body, code)
            elif block[1] == "text" and stem:
                printed = subprocess.run([self.arguments.snippets, stem.split("_")[0]], capture_output=True, text=True,
                                         timeout=60, check=True).stdout
                body = self.expect(block, f"the output of {stem}", body, printed)
                stem = None
            elif block[1] == "console":
                body = self.console(block)
            self.pieces += [self.text[self.done:block.start()], f"```{block[1]}\n{body}```"]
            self.done = block.end()
        self.pieces.append(self.text[self.done:])
        if stem:
            self.failures.append(f"{self.path}: no ```text block after the snippet {stem}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("pages", type=pathlib.Path, help="a page, or a folder of pages")
    for name in ("snippets", "tps", "root"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    parser.add_argument("--but", action="append", default=[], metavar="COMMAND")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    paths = sorted(arguments.pages.glob("*.md")) if arguments.pages.is_dir() else [arguments.pages]
    pages = [Page(path, arguments) for path in paths]
    for page in pages:
        page.check()
        if arguments.write:
            page.path.write_text("".join(page.pieces), encoding="utf-8")
    failures = [failure for page in pages for failure in page.failures]
    print("\n".join(failures))
    compared = sum(page.compared for page in pages)
    print(f"{compared} blocks of {len(pages)} pages compared, {len(failures)} differ")
    return 1 if failures or compared == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
