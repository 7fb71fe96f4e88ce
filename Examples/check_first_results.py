# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of README.md's section "From your data to a result" as they are written; run by check.py."""

import csv
import gzip
import json
import math
import os
import pathlib
import random
import re
import subprocess

from check_images import nii
from image_test import ball, voxels
from input_files import ascii_ply, ascii_stl, rows
from program_test import PROGRAM, ProgramTest, ellipsoid

README = pathlib.Path(__file__).resolve().parent / "README.md"
KINDS = ["Points", "A mesh", "A CT", "A scan", "Many bones"]


def commands_of_kinds():
    """The commands below each word in bold that begins a paragraph of the section."""
    section = re.search(r"^## From your data to a result\n(.*?)^## ", README.read_text(), re.S | re.M).group(1)
    kinds = re.split(r"^\*\*(.*?)\*\*", section, flags=re.M)[1:]
    return {kind: re.findall(r"^    (.*)", text, re.M) for kind, text in zip(kinds[::2], kinds[1::2])}


def torus_mesh(small, around=40, across=20):
    """The triangles of a torus."""
    def corner(i, j):
        u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
        r = 20 + small * math.cos(v)
        return r * math.cos(u), r * math.sin(u), small * math.sin(v)

    triangles = []
    for i in range(around):
        for j in range(across):
            a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
            triangles += [(a, b, c), (a, c, d)]
    return triangles


def scan():
    """An ellipsoid whose points are off by half a spacing and more, and one far from it."""
    noise = random.Random(1)
    points = [tuple(c + noise.gauss(0, 0.03) for c in point) for point in ellipsoid(3000)]
    return points + [(0, 0, 3)]


class FirstResults(ProgramTest):
    def setUp(self):
        super().setUp()
        os.makedirs(self.path("build/bin"))
        os.symlink(PROGRAM, self.path("build/bin/SimplifyShape"))

    def run_commands(self, kind, betti=None):
        """Runs the commands of a kind; each result is certified, and its surface has these Betti numbers."""
        commands = commands_of_kinds()[kind]
        self.assertTrue(1 <= len(commands) <= 3, commands)
        for command in commands:
            done = subprocess.run(["bash", "-euc", command], cwd=self.folder.name, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, command + "\n" + done.stderr)
            if betti:
                report = json.loads(pathlib.Path(self.path("result/report.json")).read_text())
                self.assertEqual(report["verdict"]["name"], "certified", done.stdout)
                self.assertEqual(report["betti"]["crust"], betti)
                self.assertEqual(os.path.exists(self.path("result/report.html")), "--report" in command)

    def test_kinds_are_those_that_are_run(self):
        self.assertEqual(list(commands_of_kinds()), KINDS)

    def test_points(self):
        self.write_xyz(ellipsoid(), "points.xyz")
        self.run_commands("Points", [1, 0, 0])

    def test_mesh(self):
        self.write("part.stl", ascii_stl(torus_mesh(8)))
        self.run_commands("A mesh", [1, 1, 0])

    def test_ct(self):
        values = voxels(lambda x, y, z: 1000 if ball(x, y, z) else 40 if z < 0 else -1000)  # bone, flesh, air
        pathlib.Path(self.path("ct.nii.gz")).write_bytes(gzip.compress(nii(values)))
        self.run_commands("A CT", [1, 0, 0])
        self.assertTrue(os.path.exists(self.path("result/morphometry.csv")))

    def test_scan(self):
        points = scan()
        self.write("scan.ply", ascii_ply(len(points), rows(points)))
        self.run_commands("A scan", [1, 0, 0])

    def test_many_bones(self):
        os.mkdir(self.path("bones"))
        for small in (6, 8):
            self.write("bones/%d.stl" % small, ascii_stl(torus_mesh(small)))
        self.run_commands("Many bones")
        with open(self.path("bones.csv")) as file:
            table = list(csv.DictReader(file))
        self.assertEqual([row["File"] for row in table], ["bones/6.stl", "bones/8.stl"])
        for row, small in zip(table, (6, 8)):
            self.assertEqual((row["Error"], row["Verdict"], row["Unit"]), ("", "certified", "mm"))
            self.assertAlmostEqual(float(row["Tb.Th"]), 2 * small, delta=0.05 * 2 * small)
