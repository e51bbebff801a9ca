"""tps cost as a program: one study as JSON, CSV, text and page, each with the same figures.

study_test.py PROGRAM ROOT
"""
import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import jsonschema

program, root = sys.argv[1], pathlib.Path(sys.argv[2])
SELECTION = ["--quick", "--quiet", "--questions", "150", "--variant", "stable-double,certified-time,stable-quad", "--stratum", "graze,touching"]


def cost(*arguments, expect=0):
    done = subprocess.run([program, "cost", *arguments], capture_output=True, text=True, timeout=120)
    assert done.returncode == expect, (arguments, done.returncode, done.stderr)
    return done


def check(condition, what):
    if not condition:
        sys.exit(what)


def figures_of(page):
    """What the marks of each figure say: [[text, …], …]."""
    tree = ElementTree.fromstring(page.split("\n", 1)[1])  # without the doctype
    return [[mark.get("aria-label") for mark in figure.iter("g")] for figure in tree.iter("figure")]


def test_reports(folder):
    study_file, table_file, page_file = (folder / name for name in ("study.json", "study.csv", "study.html"))
    text = cost(*SELECTION, "--repetitions", "3", "--json", study_file, "--csv", table_file, "--page", page_file).stdout
    study = json.loads(study_file.read_text())
    jsonschema.Draft202012Validator(json.loads((root / "data/schemas/cost.schema.json").read_text())).validate(study)
    cells = {(s["name"], c["variant"]): c for s in study["strata"] for c in s["cells"]}
    check(len(cells) == 8, f"2 strata of 4 variants (the baseline is always there), found {sorted(cells)}")

    rows = list(csv.DictReader(io.StringIO(table_file.read_text())))
    check(len(rows) == len(cells), "the table has a row for each cell")
    for row in rows:
        cell = cells[row["stratum"], row["variant"]]
        check(float(row["ns_throughput_median"]) == cell["ns"]["throughput"]["median"], f"another median in {row}")
        check(int(row["missed"]) == cell["missed"], f"another count in {row}")
    check(all(f"{c['ns']['throughput']['median']:.1f}" in text for c in cells.values()), "the text lacks a time")

    page = page_file.read_text()
    check(not re.search(r"<script|https?://|<link|@import|url\(", page), "the page needs something from elsewhere")
    figures = figures_of(page)
    check(len(figures) == 2 + 3 + 3, f"{len(figures)} figures")
    for stratum, marks in zip(study["strata"], figures):
        expected = {f"{c['variant']}: {c['ns']['throughput']['median']:.4g} ns" for c in stratum["cells"] if "p99" in c["log2_error"]}
        check({m.split(",")[0] for m in marks} == expected, f"{stratum['name']}: the figure shows {marks}")
    wrong = sum(b["missed"] + b["invented"] + b["moved"] for b in study["strata"][0]["by_tangency"] if b["variant"] == "printed-double")
    shown = sum(int(re.search(r"(\d+) of \d+ wrong", m)[1]) for m in figures[2] if m.startswith("printed-double"))
    check(wrong == shown > 0, f"the figure shows {shown} wrong verdicts of {wrong}")

    # A stored study gives the same reports.
    again = folder / "again.html"
    cost("--from", study_file, "--page", again)
    check(again.read_text() == page, "another page from the stored study")


def test_accuracy_is_reproducible_and_resumable(folder):
    whole, part = folder / "whole.json", folder / "part.json"
    cost(*SELECTION, "--without-times", "--json", whole)
    study = json.loads(whole.read_text())
    check("ns" not in study["strata"][0]["cells"][0], "times where none were asked for")
    # As a call leaves it that was ended behind the first stratum.
    study["strata"] = study["strata"][:1]
    part.write_text(json.dumps(study))
    cost(*SELECTION, "--without-times", "--json", part)
    check(part.read_text() == whole.read_text(), "the study that was taken up differs")
    refused = cost(*SELECTION, "--seed", "2", "--without-times", "--json", part, expect=3).stderr
    check("/settings" in refused and "another study" in refused, refused)


def test_sample(folder):
    sample, page, table = root / "docs/accuracy-cost", folder / "sample.html", folder / "sample.csv"
    cost("--from", sample / "sample.json", "--page", page, "--csv", table)
    for made in (page, table):
        check(made.read_bytes() == (sample / made.name).read_bytes(), f"docs/accuracy-cost/{made.name} is not what sample.json gives; make it "
              "again: tps cost --from sample.json --page sample.html --csv sample.csv")


def test_bad_files(folder):
    bad = folder / "bad.json"
    bad.write_text('{"cost": 1, "settings": {}}')
    check("/settings" in cost("--from", bad, expect=3).stderr, "a bad study is not named")
    study = json.loads((folder / "whole.json").read_text())
    study["strata"][0]["cells"][0]["variant"] = "guessed"
    bad.write_text(json.dumps(study))
    check("guessed" in cost("--from", bad, expect=3).stderr, "an unknown variant is not named")
    cost("--variant", "guessed", expect=2)


with tempfile.TemporaryDirectory() as name:
    for test in (test_reports, test_accuracy_is_reproducible_and_resumable, test_sample, test_bad_files):
        test(pathlib.Path(name))
print("the study, its table, its text and its page agree")
