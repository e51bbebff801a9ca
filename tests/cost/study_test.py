"""tps cost as a program: one study as JSON, CSV, text and page, each with the same figures.

study_test.py PROGRAM ROOT
"""
import base64
import csv
import hashlib
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


def own(page):
    """The page without Vega, which is the distribution's, and without what the policy says of it. Nothing else is loaded or run."""
    script = page[page.rindex("<script>") + len("<script>"):page.rindex("</script>")]
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    policy = f"default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'"
    check(page.count(policy) == 1, "the policy allows another script than that of the page")
    markup = page.replace(script, "").replace(digest, "")
    check(not re.search(r"https?://|<link|@import|url\(| src=| on\w+=", markup), "the page needs something from elsewhere")
    return markup


def figures_of(markup):
    """What the marks of each figure say: [[text, …], …]."""
    tree = ElementTree.fromstring(markup.split("\n", 1)[1])  # without the doctype
    figures = [([item.text for item in figure.find("details").iter("li")], json.loads(figure.find("script").text)["points"]) for figure in tree.iter("figure")]
    check(all(len(tips) == len(points) for tips, points in figures), "a mark says nothing, or nothing is marked")
    return [tips for tips, _ in figures]


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
    figures = figures_of(own(page))
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
        found, expected = made.read_text(), (sample / made.name).read_text()
        if made == page:
            found, expected = own(found), own(expected)
        check(found == expected, f"docs/accuracy-cost/{made.name} is not what sample.json gives; make it "
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


def level_study(folder, *arguments):
    """A level's JSON, whose table has a row for each run and whose page comes again from the stored study."""
    study_file, table_file, page_file, again = (folder / name for name in ("level.json", "level.csv", "level.html", "level_again.html"))
    study_file.unlink(missing_ok=True)  # else the levels come to those that it has
    text = cost(*arguments, "--quiet", "--json", study_file, "--csv", table_file, "--page", page_file).stdout
    study = json.loads(study_file.read_text())
    jsonschema.Draft202012Validator(json.loads((root / "data/schemas/cost.schema.json").read_text())).validate(study)
    check(cost("--from", study_file, "--page", again).stdout == text, f"{arguments}: another text from the stored study")
    page = page_file.read_text()
    check(again.read_text() == page, f"{arguments}: another page from the stored study")
    markup = own(page)
    figures_of(markup)
    return study, list(csv.DictReader(io.StringIO(table_file.read_text()))), markup


def test_runs(folder):
    study, rows, page = level_study(folder, "--runs", "--events", "60")
    rows = [row for row in rows if row["level"] == "runs"]
    runs = study["runs"]["rows"]
    check([(r["scene"], r["scalar"], r["timing"]) for r in rows] == [(r["scene"], r["scalar"], r["timing"]) for r in runs], "other rows")
    check(all(float(row["events_per_second"]) == run["events_per_second"] for row, run in zip(rows, runs)), "other rates")
    check(all(r["events"] <= 70 for r in runs) and any(r["events"] == 60 for r in runs), "--events is not heeded")
    horizons, rates = figures_of(page)
    check(len(rates) == len(runs), "a mark for each rate")
    proven = study["runs"]["proven"]
    check([(p["scene"], p["events"]) for p in proven if p["starts"] == "rounding"] == [("gas", 60), ("three-body", 60)], f"proven is {proven}")
    check(not any("parts_at" in p for p in proven), "the run in 100 digits has another event than is proven")
    check(sum("proven" in mark for mark in horizons) == sum(p["ends_by"] not in ("events", "end") for p in proven), "a mark for each proof that has not all")


def test_command(folder):
    """Programs that speak the protocol, beside ours: the certified server, and eq. (2) with b² − 4ac in Python."""
    selection = ["--quick", "--quiet", "--questions", "60", "--repetitions", "2", "--stratum", "graze", "--variant", "certified-time"]
    study_file, page_file = folder / "own.json", folder / "own.html"
    for words, is_right in (([program, "serve"], True), ([sys.executable, "-B", root / "data/adapters/python/by_approach.py"], False)):
        cost(*selection, "--json", study_file, "--page", page_file, "--", *words)
        study = json.loads(study_file.read_text())
        cells = {c["variant"]: c for c in study["strata"][0]["cells"]}
        wrong = {name: c["missed"] + c["invented"] + c["moved"] for name, c in cells.items()}
        check((wrong["command"] == 0) == is_right, f"{words}: {wrong}")
        check(cells["command"]["ns"]["latency"]["median"] > cells["certified-time"]["ns"]["latency"]["median"], "a pipe takes no time")
        if is_right:
            check(cells["command"]["log2_error"]["max"] <= -53, "a time of the server is not rounded once")
        check(any(mark.startswith("command: ") for marks in figures_of(own(page_file.read_text())) for mark in marks), "no mark of the command")
        study_file.unlink()
    check("bye" not in cost(*selection, "--", "false", expect=4).stdout, "a program that says nothing")
    cost(*selection, "--", expect=2)
    cost("--runs", "--", "true", expect=2)


def test_responses(folder):
    study, rows, page = level_study(folder, "--responses", "--questions", "4")
    responses = study["responses"]["rows"]
    check(len(rows) == len(responses) and all(r["asked"] == 4 for r in responses), "a row for each, of four questions")
    check(all(float(row["ns"]) == r["ns"] for row, r in zip(rows, responses)), "other times")
    plain = [r for r in responses if r["stratum"] == "plain"]
    check(len(figures_of(page)[0]) == len(plain) == 24, "a mark for each operation and scalar on plain")


def test_model(folder):
    study, rows, page = level_study(folder, "--model")
    grouping, revolution = study["model"]["grouping"], study["model"]["revolution"]
    check([r["level"] for r in rows] == ["grouping"] * len(grouping) + ["revolution"] * len(revolution), "other rows")
    check(all(float(row["dt_restitute"]) == run["dt_restitute"] for row, run in zip(rows, grouping)), "another dt_restitute")
    collisions = figures_of(page)[0]
    check([int(re.search(r"(\d+) collisions", mark)[1]) for mark in collisions] == [r["collisions"] for r in grouping], "the figure shows other counts")


def test_hard_cases(folder):
    study, rows, page = level_study(folder, "--hard-cases", "--case", "grazing-train,retract-boundary")
    train, boundary = study["cases"]
    check(train["good_enough"] == "double stable" and train["good_enough"] in page, "what is good enough for a grazing train")
    check(train["proven_bits"] == 64 and "unproven" in boundary, "what proves a grazing train")
    check(boundary.get("rests_on_ties") and "good_enough" not in boundary, "to agree on a tie is luck")
    check(len(rows) == sum(len(c["outcomes"]) for c in study["cases"]), "a row for each outcome")


def test_whole_study(folder):
    """All levels in one file and on one page; taken up in the middle of each level, what was there stays as it was."""
    chosen = ["--queries", "--responses", "--runs", "--model", "--hard-cases", "--quick", "--questions", "3", "--repetitions", "1", "--events", "20", "--variant", "stable-double",
              "--stratum", "plain,graze", "--scene", "three-body,cradle,revolution", "--case", "resting,grazing-train"]
    study, rows, page = level_study(folder, *chosen)
    sections = re.findall(r"<h2 id=\"([a-z-]+)\"", page)
    check(sections == ["queries", "responses", "runs", "grouping", "revolution", "cases"] and all(f'href="#{s}"' in page for s in sections), f"sections {sections}")
    check({row["level"] for row in rows} == {"queries", "responses", "runs", "proven", "grouping", "revolution", "cases"}, "levels of the table")
    part = json.loads(json.dumps(study))
    part["strata"].pop()
    part["cases"].pop()
    part["model"]["revolution"] = []
    lost = part["responses"]["rows"][-1]["stratum"], part["responses"]["rows"][-1]["op"]
    part["responses"]["rows"] = [r for r in part["responses"]["rows"] if (r["stratum"], r["op"]) != lost]
    part["runs"] |= {"rows": [], "proven": [], "fits": []}
    taken_up = folder / "taken_up.json"
    taken_up.write_text(json.dumps(part))
    said = cost(*chosen, "--json", taken_up).stderr
    check(len(re.findall(r"\(\d+ of \d+\)", said)) == 5, f"five parts were missing, measured: {said}")
    again = json.loads(taken_up.read_text())
    check(again["strata"][0] == study["strata"][0] and again["model"]["grouping"] == study["model"]["grouping"], "what was there is another")
    check(again["model"] == study["model"] and again["cases"] == study["cases"], "what is the same on every machine is another")
    check([r["scalar"] for r in again["responses"]["rows"]] == [r["scalar"] for r in study["responses"]["rows"]], "other responses")
    check("/runs/events" in cost(*["30" if word == "20" else word for word in chosen], "--json", taken_up, expect=3).stderr, "another study is not named")


def test_refusals(folder):
    for arguments in (["--model", "--stratum", "plain"], ["--hard-cases", "--seed", "2"], ["--runs", "--case", "huge"], ["--runs", "--from", "x.json"],
                      ["--runs", "--questions", "5"], ["--hard-cases", "--case", "guessed"], ["--queries", "--events", "5"], ["--responses", "--scene", "gas"]):
        message = cost(*arguments, expect=2).stderr
        check(arguments[0] in message or arguments[-2] in message, f"{arguments}: {message}")
    half = folder / "half.json"
    study = json.loads((folder / "whole.json").read_text())
    del study["variants"]
    half.write_text(json.dumps(study))
    check("variants" in cost("--from", half, expect=3).stderr, "a missing key is not named")
    del study["strata"]
    half.write_text(json.dumps(study))
    check("runs" in cost("--from", half, expect=3).stderr, "a study of nothing is not named")


with tempfile.TemporaryDirectory() as name:
    for test in (test_reports, test_accuracy_is_reproducible_and_resumable, test_sample, test_bad_files, test_command, test_responses, test_runs, test_model, test_hard_cases, test_whole_study, test_refusals):
        test(pathlib.Path(name))
print("the study, its table, its text and its page agree")
