#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs SimplifyShape on the bone in a CT of a head, and says what came out, how long it took, and how much memory.

    Testing/Robustness/tabulate_scans.py build/bin/SimplifyShape [--write] [--keep DIR] [NAME ...]

The CT is Cranium.inv3 of Debian's package invesalius-examples, which must be installed. With names, only these
regions run. They run one after the other, for half an hour in all. --write puts the table into
Testing/README.md; rows of regions that don't run stay. --keep keeps images and results in a folder. The exit
code is 1 where something isn't certified.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import tables

sys.path.append(str(pathlib.Path(__file__).parents[2] / "Examples"))
from cranium import BONE, REGIONS, read_scan, write_region  # noqa: E402, the path is known only now

HEADER = ("| region | voxels | segmentation | surface | power shape | axis | pruned | final | verdict | samples "
          "| parts | time | memory | warnings |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n")


def row(program, folder, name, scan):
    """A row of the table; is it certified?"""
    image, output = folder / (name + ".mha"), folder / name
    size = write_region(image, scan, REGIONS[name])
    begin = time.monotonic()
    subprocess.run([program, image, "--iso", str(BONE), "--pieces", "largest", "--output", output, "--quiet"],
                   check=True)
    seconds = time.monotonic() - begin
    report = json.loads((output / "report.json").read_text())
    betti = [tables.in_words(report["betti"][stage])
             for stage in ("segmentation", "solid", "powerShape", "axis", "pruned", "crust")]
    verdict = report["verdict"]
    cells = [name, "%d x %d x %d" % size, *betti,
             "; ".join([verdict["name"], *verdict["differs"]]).replace("|", "/"),
             "{:,}".format(report["samples"]), "{:,}".format(report["parts"]), "%.0f s" % seconds,
             "%.1f GiB" % (report["peakMemoryMiB"] / 1024),
             "; ".join(warning["code"] for warning in report["warnings"])]
    return "| " + " | ".join(cells) + " |\n", verdict["name"] == "certified"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    arguments = parser.parse_intermixed_args()
    scan = read_scan()
    rows, failures = {}, 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or pathlib.Path(scratch)
        os.makedirs(folder, exist_ok=True)
        for name in arguments.names or REGIONS:
            rows[name], fine = row(os.path.abspath(arguments.program), folder, name, scan)
            print(rows[name], end="", flush=True)
            failures += not fine
            if arguments.write:
                tables.write("scans", HEADER, rows, REGIONS)
    sys.exit(failures > 0)


main()
