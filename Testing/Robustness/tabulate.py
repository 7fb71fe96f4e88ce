#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs SimplifyShape on inputs that are broken, hostile, or were reported, and says what it made of them.

    Testing/Robustness/tabulate.py build/bin/SimplifyShape DATA [--write] [PATTERN ...]

DATA is the folder that holds hostile/, faults/ and reports/. expectations.csv beside this script says what is
right for each file: what stands between | is right as well.

    refused             exit 2, with a message
    doubted             the result is not certified, and the program says why
    any                 one of these, or a certified result
    1 0 1               certified, with these pieces, tunnels and voids at all stages
    1 0 1 with CODE     the same, and this warning

Runs one file on each core, each on one thread, for some minutes in all. --write puts the table into
Testing/README.md; with patterns, such as 'reports/soup/*', only the rows of these files change. The exit code
is 1 where an outcome is not expected.
"""

import json
import pathlib
import resource
import signal
import subprocess
import tempfile

import tables

HEADER = "| file | what | right | outcome | why, or warnings | as expected |\n|---|---|---|---|---|---|\n"
LIMIT = 600  # seconds of work for one file, however busy the machine is
PATIENCE = 3600  # seconds, if it waits for ever


def run(program, path):
    """What the program makes of a file: the outcome as in expectations.csv, the codes of warnings, the reason."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder, "out")
        command = [program, path, "--output", output, "--quiet", "--strict", "--threads", "1"]
        try:
            process = subprocess.run(
                command, capture_output=True, text=True, errors="replace", timeout=PATIENCE, check=False,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 10)))
        except subprocess.TimeoutExpired:
            return "hangs", [], f"no end after {PATIENCE} s"
        report = output / "report.json"
        said = json.loads(report.read_text()) if report.exists() else None
    if process.returncode == 2 and said is None:
        return "refused", [], process.stderr.strip().splitlines()[-1].split(": ", 2)[-1]
    if process.returncode == -signal.SIGXCPU:
        return "hangs", [], f"no end after {LIMIT} s of work"
    if process.returncode not in (0, 3) or said is None:
        return "crashes", [], f"exit code {process.returncode}"
    codes = [warning["code"] for warning in said["warnings"]]
    betti = tables.in_words(said["betti"]["crust"])
    if process.returncode == 0:
        return betti, codes, "; ".join(codes)
    # The one reason that names warnings says no more than they do.
    others = [reason for reason in said["verdict"]["differs"] if "see what is warned of" not in reason]
    return "doubted", codes, f"{betti}: " + "; ".join(codes + others)


def is_expected(outcome, codes, expected):
    """Is the outcome one of those between | ?"""
    for alternative in expected.split("|"):
        right, _, code = alternative.partition(" with ")
        if right == outcome or (right == "any" and outcome not in ("hangs", "crashes")):
            if not code or code in codes:
                return True
    return False


def row(program, data, entry):
    """A row of the table, and whether it is as expected."""
    outcome, codes, why = run(program, data / entry["file"])
    fine = is_expected(outcome, codes, entry["expected"])
    cells = [f"`{entry['file']}`", entry["what"], entry["expected"].replace("|", " or "), outcome,
             why.replace("|", "/"), "yes" if fine else "**no**"]
    return "| " + " | ".join(cells) + " |\n", fine


tables.tabulate(__doc__, "hostile inputs", HEADER, "expectations.csv", row, "as expected")
