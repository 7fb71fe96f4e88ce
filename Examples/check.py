#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what SimplifyShape promises: files, report, exit codes, messages; and DrawPanels beside it.

  Examples/check.py build/bin/SimplifyShape
"""

import csv
import itertools
import json
import math
import os
import pty
import re
import struct
import subprocess
import unittest

from check_cohort import Cohorts  # tables of many objects; run with the rest
from check_dicom import Dicom  # the same of DICOM series; run with the rest
from check_exports import Exports  # the files for other programs; run with the rest
from check_first_results import FirstResults  # the README's first commands; run with the rest
from check_images import Images  # the same of images; run with the rest
from check_inputs import Inputs  # what the program reads and refuses; run with the rest
from check_meshes import Meshes  # what it makes of polygons; run with the rest
from check_outputs import Outputs  # whole results or none; run with the rest
from check_panels import Panels  # the program DrawPanels; run with the rest
from check_report import ReportPage  # the page for a browser; run with the rest
from input_files import xml
from program_test import PROGRAM, ProgramTest, ellipsoid, torus

__all__ = ["Cohorts", "Exports", "FirstResults", "Images", "Inputs", "Outputs", "Panels", "ReportPage",
           "SimplifyShape"]

DATA = {"balls.vtu", "samples.vtp", "axis.vtp", "parts.vtp", "pruned.vtp", "surface.vtp", "surface.stl",
        "parts.csv", "history.csv", "report.json"}
PICTURES = {"samples.png", "axis.png", "parts.png", "pruned.png", "surface.png", "overview.png"}


def noisy_ellipsoid(noise, step):
    """Points off an ellipsoid by up to `noise` of their distance from its middle."""
    return [tuple(c * (1 - noise + 2 * noise * (step * (i + 1) % 1)) for c in point)
            for i, point in enumerate(ellipsoid())]


def grid_cube(n, sides):
    """The points of some sides of a cube, (n + 1)^2 on each; the last side is the lid."""
    for axis, end in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)][:sides]:
        for i in range(n + 1):
            for j in range(n + 1):
                point = [end, end, end]
                point[axis - 2], point[axis - 1] = i / n, j / n
                yield point


def grid_squares(n, sides):
    """Their squares, with numbers of points from 1 on."""
    for side in range(sides):
        for i in range(n):
            for j in range(n):
                at = side * (n + 1)**2 + i * (n + 1) + j + 1
                yield at, at + 1, at + n + 2, at + n + 1


def triangles(stl):
    """The triangles of a binary .stl file, corners as tuples."""
    with open(stl, "rb") as file:
        content = file.read()
    count = struct.unpack_from("<I", content, 80)[0]
    assert len(content) == 84 + 50 * count
    for i in range(count):
        v = struct.unpack_from("<9f", content, 84 + 50 * i + 12)
        yield v[0:3], v[3:6], v[6:9]


class SimplifyShape(ProgramTest):
    def options(self):
        """Each option of --help with an example of its value, or None if it takes none."""
        examples = {"DIR": self.path("none"), '"W W ..."': "t5", "WORD": "none", "ID,ID": "0,1",
                    "N": "1", "L": "0.1", "F": "0.2", "R": "1", "X": "0.5", "WHICH": "largest"}
        found = re.findall(r"^  (--[a-z-]+)(?: (\S.*?))?  ", self.run_program("--help").stdout, re.M)
        return {name: examples.get(placeholder, "0,1,0,1,0,1") if placeholder else None
                for name, placeholder in found}

    def test_help_lists_the_options(self):
        done = self.run_program("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.run_program("-h").stdout, done.stdout)
        self.assertGreater(len(self.options()), 9)
        self.assertEqual(sorted(set(re.findall(r"--[a-z-]+", done.stdout))),
                         sorted(self.options()), "an option is mentioned but not described")

    def test_every_option_is_accepted(self):
        for option, value in self.options().items():
            with self.subTest(option):
                words = [option] if value is None else [option, value]
                self.assertEqual(self.run_program(*words, "--help").returncode, 0)
                joined = self.run_program(option + "=" + (value or ""), "--help")
                self.assertEqual(joined.returncode, 1 if value is None else 0)
                if value is not None:
                    alone = self.run_program(option)
                    self.assertEqual(alone.returncode, 1)
                    self.assertIn(option + " needs a value", alone.stderr)

    def test_wrong_usage_gives_1(self):
        points = self.write_xyz(ellipsoid(300))
        self.assert_fails(1, ["no input"])
        self.assert_fails(1, ["'x3'", "tN", "vP%"], points, "--schedule", "t5 x3")
        for word in ("v0.01", "v%", "v101%", "t", "t-1", "t1.5", "v1e1%", "v1%%",
                     "t5%", "a1%", "r", "r-1"):
            self.assert_fails(1, ["'" + word + "'", "tN", "vP%"], points, "--schedule", word)
        self.assert_fails(1, ["--topology", "'graph'"], points, "--topology", "graph")
        self.assert_fails(1, ["--threads", "'0'"], points, "--threads=0")
        self.assert_fails(1, ["'a'", "--remove-parts"], points, "--remove-parts", "1,a")
        self.assert_fails(1, ["no part 100000"], points, "--remove-parts", "100000")
        self.assert_fails(1, ["'--colour'"], points, "--colour")
        self.assert_fails(1, ["--automatic", "--schedule"], points, "--automatic", "--schedule", "t1")
        self.assert_fails(1, ["one input"], points, points)

    def test_lengths_are_numbers_from_0_on(self):
        points = self.write_xyz(ellipsoid(100))
        for word in ("-1", "0,1", "much", "inf", "nan"):
            for option in ("--merge-tolerance", "--trim"):
                self.assert_fails(1, [option, word], points, option, word)

    def test_output_that_is_a_file_gives_2(self):
        points = self.write_xyz(ellipsoid(300))
        done = self.run_program(points, "--output", points)
        self.assertEqual(done.returncode, 2)
        self.assertIn(points, done.stderr)

    def test_ellipsoid(self):
        report, out = self.simplify(ellipsoid(), "--strict")
        self.assertEqual(set(os.listdir(out)), DATA)
        self.assertEqual(report["samples"], 1500)
        self.assertEqual(report["duplicates"], 0)
        self.assertEqual(report["betti"], {"segmentation": None, "solid": None, **dict.fromkeys(
            ("powerShape", "axis", "pruned", "crust"), [1, 0, 0])})
        self.assertEqual((report["source"], report["sampling"]), ("points", None))
        self.assertIs(report["certificate"], True)
        self.assertEqual((report["fallback"], report["filledGaps"]), (False, 0))
        self.assertEqual(report["verdict"], {"name": "certified", "differs": []})
        self.assertEqual(report["warnings"], [])
        exact = 4 / 3 * math.pi * 0.7 * 0.5
        self.assertAlmostEqual(report["volume"]["crustBefore"] / exact, 1, delta=0.02)
        self.assertAlmostEqual(report["volume"]["crustAfter"] / exact, 1, delta=0.05)
        self.assertEqual(set(report["balls"]), {"inner", "outer", "hidden", "offAxis"})
        stages = {"image", "samples", "polarBalls", "medialAxis", "parts", "prune", "crust", "total"}
        self.assertEqual(set(report["seconds"]), stages)
        self.assertGreater(report["peakMemoryMiB"], 10)
        self.check_iterations(report, out)

    def check_iterations(self, report, out):
        rows, spacing = report["iterations"], report["moved"]["spacing"]
        default = [("triangleCount", 5)] * 2 + [("hausdorffDistance", spacing / 2), ("area", 2 * spacing ** 2)]
        self.assertEqual([(row["measure"], row["threshold"]) for row in rows], default)
        self.assertEqual(rows[0]["partsBefore"], report["parts"])
        for before, after in zip(rows, rows[1:]):
            self.assertEqual(before["partsAfter"], after["partsBefore"])
        with open(os.path.join(out, "parts.csv")) as file:
            parts = list(csv.DictReader(file))
        self.assertEqual(len(parts), report["parts"])
        self.assertAlmostEqual(sum(float(part["RelativeVolume"]) for part in parts), 1, places=9)
        with open(os.path.join(out, "history.csv")) as file:
            history = list(csv.DictReader(file))
        self.assertEqual([int(row["PartsAfter"]) for row in history],
                         [row["partsAfter"] for row in rows])

    def test_surface_reads_back_closed(self):
        """Also where sheets touch: readers of STL take corners at the same place for one point."""
        for name, points in (("torus", torus()), ("grid", map(tuple, grid_cube(12, 6)))):
            out = self.path(name)
            done = self.run_program(self.write_xyz(points), "--output", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            followers = {}
            for corners in triangles(os.path.join(out, "surface.stl")):
                for a, b, c in zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2]):
                    self.assertNotIn(b, followers.setdefault(a, {}), "an edge of several triangles")
                    followers[a][b] = c
            for a, fan in followers.items():
                first = at = next(iter(fan))
                for turns in range(1, len(fan) + 1):
                    at = fan.get(at)
                    if at in (None, first):
                        break
                self.assertEqual((at, turns), (first, len(fan)), "not one fan at %s" % (a,))

    def test_verdict_compares_all_stages(self):
        """Noise of 20 % of the radius makes tunnels that are narrower than the samples are apart."""
        for step in (0.6180339887, 0.7548776662, 0.5698402909):
            points = noisy_ellipsoid(0.2, step)
            out = self.path("noisy")
            done = self.run_program(self.write_xyz(points), "--output", out, "--strict")
            with open(os.path.join(out, "report.json")) as file:
                report = json.load(file)
            betti = [numbers for numbers in report["betti"].values() if numbers]
            against = sum(numbers != report["betti"]["powerShape"] for numbers in betti)
            against += sum(warning["doubtsSolid"] for warning in report["warnings"])
            name = "not certified" if against else "certified"
            self.assertEqual(report["verdict"]["name"], name)
            self.assertEqual(bool(report["verdict"]["differs"]), against > 0)
            self.assertEqual(done.returncode, 3 if against else 0)
            self.assertEqual("NOT CERTIFIED" in done.stdout, against > 0)
            for text in report["verdict"]["differs"]:
                self.assertIn(text, done.stdout)
            self.check_warnings(report, done)

    def test_filled_gaps_are_told(self):
        report, _ = self.simplify(noisy_ellipsoid(0.1, 0.5698402909))
        self.assertGreater(report["filledGaps"], 0)
        self.assertFalse(report["fallback"])

    def check_warnings(self, report, done):
        """The summary tells each warning, and nothing repeats it."""
        for warning in report["warnings"]:
            self.assertEqual(set(warning), {"code", "text", "count", "place", "doubtsSolid"})
            self.assertEqual(done.stdout.count("warning   " + warning["text"]), 1)
            self.assertTrue(warning["place"] is None or len(warning["place"]) == 3)
        self.assertNotIn("warning", done.stderr)
        self.assertEqual("fallback" in [warning["code"] for warning in report["warnings"]],
                         report["fallback"])

    def test_points_of_a_volume_are_not_certified(self):
        """The stages agree about a solid of many tunnels, but the points have no surface."""
        steps = 0.8191725134, 0.6710436067, 0.5497004779
        points = [tuple(i * step % 1 for step in steps) for i in range(1, 1500)]
        out = self.path("volume")
        done = self.run_program(self.write_xyz(points), "--output", out, "--strict",
                                "--schedule", "")
        self.assertEqual(done.returncode, 3)
        with open(os.path.join(out, "report.json")) as file:
            report = json.load(file)
        self.assertEqual(report["verdict"]["name"], "not certified")
        self.assertTrue(any(warning["doubtsSolid"] for warning in report["warnings"]))
        self.assertIn("may not determine the solid", "".join(report["verdict"]["differs"]))
        self.check_warnings(report, done)

    def test_open_surface_is_warned_of(self):
        """A cube of squares, whole and without its lid."""
        for sides, name in itertools.product((6, 5), ("cube.obj", "cube.vtp", "cube.vtu")):
            points, squares = list(grid_cube(12, sides)), list(grid_squares(12, sides))
            text = "".join("v %r %r %r\n" % tuple(point) for point in points)
            text += "".join("f %d %d %d %d\n" % square for square in squares)
            if name != "cube.obj":
                kind = "PolyData" if name == "cube.vtp" else "UnstructuredGrid"
                text = xml(kind, points, cells=[[c - 1 for c in square] for square in squares])
            out = self.path("%s%d" % (name, sides))
            done = self.run_program(self.write(name, text), "--output", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(out, "report.json")) as file:
                report = json.load(file)
            found = [warning for warning in report["warnings"] if warning["code"] == "open_surface"]
            self.assertEqual([warning["count"] for warning in found], [] if sides == 6 else [48])
            for warning in found:
                self.assertEqual(warning["place"][2], 1)
            self.check_warnings(report, done)

    def test_input_is_not_overwritten(self):
        _, out = self.simplify(ellipsoid(600))
        surface = os.path.join(out, "surface.stl")
        before = {name: os.path.getmtime(os.path.join(out, name)) for name in os.listdir(out)}
        done = self.run_program(surface, "--output", out, "--schedule", "")
        self.assertEqual(done.returncode, 2)
        self.assertIn("surface.stl: is the input", done.stderr)
        after = {name: os.path.getmtime(os.path.join(out, name)) for name in os.listdir(out)}
        self.assertEqual(after, before)

    def test_torus_keeps_its_tunnel(self):
        report, _ = self.simplify(torus(), "--schedule", "t5 v50%", "--strict")
        del report["betti"]["solid"], report["betti"]["segmentation"]
        for betti in report["betti"].values():
            self.assertEqual(betti, [1, 1, 0])

    def test_schedule_takes_every_measure(self):
        words = "t1 v0% p0% a0 m1 m1% r1 r1% o10 l1 l1% e0.1 e1% h0.1 h1% b0.1 b1%"
        letters = re.findall(r"^ {27}([a-z])[NPX]", self.run_program("--help").stdout, re.M)
        self.assertEqual(set(letters), {word[0] for word in words.split()})
        report, _ = self.simplify(torus(), "--schedule", words)
        self.assertEqual([row["measure"] for row in report["iterations"]],
                         ["triangleCount", "relativeVolume", "relativePoleVolume", "area",
                          "meanRadius", "meanRadius", "maximumRadius", "maximumRadius",
                          "objectAngle", "lambda", "lambda", "erosionThickness",
                          "erosionThickness", "hausdorffDistance", "hausdorffDistance",
                          "boundaryLength", "boundaryLength"])
        thresholds = [row["threshold"] for row in report["iterations"]]
        diagonal = thresholds[5] / 0.01
        for k, percent in ((7, 1), (10, 1), (12, 1), (14, 1), (16, 1)):
            self.assertAlmostEqual(thresholds[k], diagonal * percent / 100)
        self.assertEqual(thresholds[8], 10)

    def test_chooses_the_schedule_and_cuts_at_necks(self):
        points = [(2.2 + 0.4 * x, 0.4 * y, 0.4 * z) for x, y, z in ellipsoid(800, (1, 1, 1))]
        points += [point for point in ellipsoid(1500, (2, 2, 2)) if math.dist(point, (2, 0, 0)) > 0.4]
        whole, _ = self.simplify(points, "--automatic")
        cut, out = self.simplify(points, "--automatic", "--split-at-necks")
        self.assertGreater(len(cut["iterations"]), 0)
        self.assertGreater(cut["parts"], whole["parts"])
        with open(os.path.join(out, "parts.csv")) as file:
            ratios = [float(row["NeckRatio"]) for row in csv.DictReader(file)]
        self.assertEqual(len(ratios), cut["parts"])
        self.assertLess(min(ratios), 0.5)

    def test_part_by_hand(self):
        report, _ = self.simplify(ellipsoid(), "--schedule", "", "--remove-parts", "0",
                                  "--topology", "none")
        self.assertEqual([row["measure"] for row in report["iterations"]], ["byHand"])
        self.assertLess(report["iterations"][0]["partsAfter"], report["parts"])

    def test_formats_and_threads_agree(self):
        points = ellipsoid(600)
        reports = []
        for arguments in ([self.write_xyz(points)], [self.write_off(points)],
                          [self.write_off(points), "--threads=1"]):
            done = self.run_program(*arguments, "--output", self.path("same"), "--quiet")
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
            with open(self.path("same/report.json")) as file:
                reports.append(json.load(file))
            for key in ("seconds", "peakMemoryMiB"):
                del reports[-1][key]
        self.assertEqual(reports[0], reports[1])
        self.assertEqual(reports[0], reports[2])

    def test_no_bar_in_a_file(self):
        points = self.write_xyz(ellipsoid(300))
        plain = self.run_program(points, "--output", self.path("out"))
        self.assertEqual(plain.stderr, "")

    def test_bar_at_a_terminal(self):
        points = self.write_xyz(ellipsoid(300))
        seen = self.seen_at_terminal([PROGRAM, points, "--output", self.path("out")])
        for stage in ("polar balls", "medial axis", "parts", "prune", "crust"):
            self.assertIn(stage, seen)
        self.assertIn("100 %", seen)

    def seen_at_terminal(self, command):
        """What a program writes to standard error where that is a terminal."""
        try:
            master, terminal = pty.openpty()
        except OSError as error:
            self.skipTest("this machine gives no terminal: %s (is /dev/pts mounted?)" % error)
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=terminal) as process:
            os.close(terminal)
            seen = b""
            try:
                while True:
                    seen += os.read(master, 4096)
            except OSError:  # how Linux reports that the other side is closed
                pass
            os.close(master)
        self.assertEqual(process.returncode, 0)
        return seen.decode()

    def test_pictures_without_display_give_1(self):
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        points = self.write_xyz(ellipsoid(300))
        done = self.run_program(points, "--picture", "--output", self.path("none"), environment=environment)
        self.assertEqual(done.returncode, 1)
        self.assertIn("DISPLAY", done.stderr)
        self.assertIn("Examples/run", done.stderr)
        self.assertFalse(os.path.exists(self.path("none")))

    @unittest.skipUnless(os.environ.get("DISPLAY"), "needs an X server")
    def test_pictures(self):
        _, out = self.simplify(torus(1500), "--picture")
        self.assertEqual(set(os.listdir(out)), DATA | PICTURES)
        for name in PICTURES:
            with open(os.path.join(out, name), "rb") as file:
                size = struct.unpack(">II", file.read(24)[16:])
            self.assertEqual(size, (2500, 560) if name == "overview.png" else (900, 900))
        figure10 = os.path.join(os.path.dirname(os.path.abspath(__file__)), "figure10")
        subprocess.run([figure10, os.path.join(out, "history.csv"), self.path("10.png")], check=True)
        with open(self.path("10.png"), "rb") as file:
            self.assertEqual(struct.unpack(">II", file.read(24)[16:]), (900, 600))
        failed = subprocess.run([figure10], capture_output=True, text=True)
        self.assertEqual(failed.returncode, 1)
        self.assertIn("history.csv", failed.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)  # says why a test is skipped
