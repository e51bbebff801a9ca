"""docs/cost.md has the rows that data/cost.py measures, and a row, or a sentence, for each verb of the program.

  cost_rows_test.py TPS ROOT
"""
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile

tps, root = sys.argv[1], pathlib.Path(sys.argv[2])
page = (root / "docs/cost.md").read_text()
sys.argv = ["cost.py", tps]
specification = importlib.util.spec_from_file_location("cost", root / "data/cost.py")
cost = importlib.util.module_from_spec(specification)
specification.loader.exec_module(cost)
with tempfile.TemporaryDirectory() as folder:
    measured = [name for name, _ in cost.rows(pathlib.Path(folder))]
shown = re.findall(r"^\| (.+?) \|", page, flags=re.M)[1:]
if shown != measured:
    sys.exit(f"docs/cost.md has the rows {shown}; data/cost.py measures {measured}: take its output over")
verbs = re.findall(r"^  ([a-z]+) {2,}", subprocess.run([tps, "--help"], capture_output=True, text=True, check=True).stdout.split("Subcommands:")[1], flags=re.M)
missing = [verb for verb in verbs if not any(name.split(",")[0].split()[0] == verb for name in measured) and f"`{verb}`" not in page]
if len(verbs) < 10 or missing:
    sys.exit(f"docs/cost.md says nothing of {missing}, of the verbs {verbs}; add a row to data/cost.py or a sentence")
