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
import array
import json
import os
import pathlib
import plistlib
import subprocess
import sys
import tarfile
import tempfile
import time

import tables

SCAN = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3"
BONE = 226  # Hounsfield units; from here on InVesalius takes bone
HEADER = ("| region | voxels | segmentation | surface | power shape | axis | pruned | final | verdict | samples "
          "| parts | time | memory | warnings |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n")
# First and last + 1 along x (to the left), y (to the front), z (to the head).
REGIONS = {
    "jaw": ((60, 200), (120, 225), (0, 26)),
    "face": ((60, 200), (140, 225), (0, 60)),
    "vault": ((50, 210), (15, 225), (60, 108)),
    "whole": ((0, 256), (0, 256), (0, 108)),
}


def read_scan():
    """The voxels, x fastest; how many there are along x, y and z; their distances in mm."""
    with tarfile.open(SCAN) as archive:
        names = {pathlib.PurePath(name).name: name for name in archive.getnames()}
        about = plistlib.loads(archive.extractfile(names["main.plist"]).read())
        voxels = array.array("h", archive.extractfile(names["matrix.dat"]).read())
    if sys.byteorder == "big":
        voxels.byteswap()
    return voxels, about["matrix"]["shape"][::-1], about["spacing"]


def write_region(path, scan, region):
    """A .mha file of a part of the scan, in its place; returns the number of voxels along x, y and z."""
    voxels, size, spacing = scan
    (x0, x1), (y0, y1), (z0, z1) = region
    header = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = %s\n"
              "Offset = %.9g %.9g %.9g\nElementSpacing = %.9g %.9g %.9g\nDimSize = %d %d %d\n"
              "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" % (
                  sys.byteorder == "big", x0 * spacing[0], y0 * spacing[1], z0 * spacing[2], *spacing,
                  x1 - x0, y1 - y0, z1 - z0))
    with open(path, "wb") as file:
        file.write(header.encode())
        for z in range(z0, z1):
            for y in range(y0, y1):
                row = size[0] * (y + size[1] * z)
                file.write(voxels[row + x0:row + x1].tobytes())
    return x1 - x0, y1 - y0, z1 - z0


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
