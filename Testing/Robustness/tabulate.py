#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs SimplifyShape on inputs that are broken, hostile, or were reported, and says what it made of them.

    Testing/Robustness/tabulate.py build/bin/SimplifyShape DATA [--write] [PATTERN ...]

DATA is the folder that holds hostile/, faults/ and reports/. expectations.csv beside this script says what
is right for each file: what stands between | is right as well.

    refused     exit 2, with a message
    doubted     the result is not certified, and the program says why
    any         one of these, or a certified result
    1 0 1       certified, with these pieces, tunnels and voids at all stages

--write puts the table into Testing/README.md. The exit code is 1 where an outcome is not expected.
"""

import csv
import fnmatch
import json
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
README = HERE.parent / "README.md"
BEGIN, END = "<!-- table of hostile inputs: begin -->\n", "<!-- table of hostile inputs: end -->\n"
LIMIT = 600  # seconds for one file


def run(program, path):
    """What the program says of a file: the outcome as in expectations.csv, and the reason."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder, "out")
        command = [program, path, "--output", output, "--quiet", "--strict"]
        try:
            process = subprocess.run(command, capture_output=True, text=True, errors="replace",
                                     timeout=LIMIT, check=False)
        except subprocess.TimeoutExpired:
            return "hangs", f"no end after {LIMIT} s"
        report = output / "report.json"
        said = json.loads(report.read_text()) if report.exists() else None
    if process.returncode == 2 and said is None:
        return "refused", process.stderr.strip().splitlines()[-1].split(": ", 2)[-1]
    if process.returncode not in (0, 3) or said is None:
        return "crashes", f"exit code {process.returncode}"
    codes = [warning["code"] for warning in said.get("warnings", [])]
    verdict = said["verdict"]
    reasons = verdict.get("reasons", []) if isinstance(verdict, dict) else verdict
    why = "; ".join(codes) or "; ".join(reasons if isinstance(reasons, list) else [])
    betti = " ".join(str(int(number)) for number in said["betti"]["crust"])
    if process.returncode == 3:
        return "doubted", f"{betti}: {why}"
    return betti, why


def row(program, data, entry):
    """A row of the table and whether it is as expected."""
    begin = time.monotonic()
    outcome, why = run(program, data / entry["file"])
    seconds = time.monotonic() - begin
    allowed = entry["expected"].split("|")
    fine = outcome in allowed or ("any" in allowed and outcome not in ("hangs", "crashes"))
    cells = [f"`{entry['file']}`", entry["what"], entry["expected"].replace("|", " or "), outcome,
             why.replace("|", "/")[:160], f"{seconds:.1f}", "yes" if fine else "**no**"]
    return "| " + " | ".join(cells) + " |\n", fine


def write(rows):
    text = README.read_text()
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    header = "| file | what | right | outcome | why | s | as expected |\n|---|---|---|---|---|--:|---|\n"
    README.write_text(before + BEGIN + "\n" + header + "".join(rows) + "\n" + END + after)


def main():
    arguments = [word for word in sys.argv[1:] if word != "--write"]
    if len(arguments) < 2:
        sys.exit(__doc__)
    program, data, *patterns = arguments
    with open(HERE / "expectations.csv", newline="", encoding="utf-8") as file:
        entries = [entry for entry in csv.DictReader(file)
                   if not patterns or any(fnmatch.fnmatch(entry["file"], p) for p in patterns)]
    rows, failures = [], 0
    for entry in entries:
        line, fine = row(program, pathlib.Path(data), entry)
        print(line, end="", flush=True)
        rows.append(line)
        failures += not fine
    print(f"{len(rows) - failures} of {len(rows)} as expected")
    if "--write" in sys.argv:
        write(rows)
    sys.exit(failures > 0)


main()
