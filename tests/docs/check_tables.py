"""Fails when a page does not contain what a program prints: check_tables.py PAGE PROGRAM "WORDS"…; each as one call."""

import pathlib
import subprocess
import sys


def main():
    page, program, *calls = sys.argv[1:]
    text = pathlib.Path(page).read_text(encoding="utf-8")
    wrong = False
    for words in calls:
        table = subprocess.run([program, *words.split()], capture_output=True, text=True, check=True).stdout
        if table not in text:
            wrong = True
            print(f"{page}: differs from what {pathlib.Path(program).name} {words} prints; put this there:\n{table}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
