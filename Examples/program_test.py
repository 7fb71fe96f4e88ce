# SPDX-License-Identifier: BSD-3-Clause
"""What the checks of SimplifyShape share: points of simple solids, and runs of the program."""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))


def ellipsoid(count=1500, axes=(1.0, 0.7, 0.5)):
    """Points spread over an ellipsoid along a spiral."""
    golden = math.pi * (3 - math.sqrt(5))
    points = []
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        r = math.sqrt(1 - z * z)
        points.append((axes[0] * r * math.cos(golden * i), axes[1] * r * math.sin(golden * i),
                       axes[2] * z))
    return points


def torus(count=3000, big=1.0, small=0.4):
    """Points spread over a torus, of even density, by two irrational steps."""
    points = []
    for i in range(count):
        u = 2 * math.pi * (i * 0.7548776662466927 % 1)
        area = i * 0.5698402909980532 % 1
        v = 2 * math.pi * area
        for _ in range(20):  # area(v) = (v + small / big sin v) / 2 pi
            v = 2 * math.pi * area - small / big * math.sin(v)
        r = big + small * math.cos(v)
        points.append((r * math.cos(u), r * math.sin(u), small * math.sin(v)))
    return points


class ProgramTest(unittest.TestCase):
    """A test that runs the program in a folder of its own."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def write_xyz(self, points, name="points.xyz"):
        return self.write(name, "".join("%.17g %.17g %.17g\n" % point for point in points))

    def write_off(self, points, name="points.off"):
        return self.write(name, "OFF\n# made by a test\n%d 0 0\n\n" % len(points) +
                          "".join("%.17g %.17g %.17g\n" % point for point in points))

    def run_program(self, *arguments, environment=None):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, errors="replace",
                              stdin=subprocess.DEVNULL, env=environment)

    def simplify(self, points, *arguments):
        """Runs on points; returns the report and the folder."""
        out = self.path("out")
        done = self.run_program(self.write_xyz(points), "--output", out, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(out, "report.json")) as file:
            return json.load(file), out

    def assert_fails(self, code, fragments, *arguments):
        done = self.run_program(*arguments, "--output", self.path("none"))
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, "one line expected: " + done.stderr)
        for fragment in fragments:
            self.assertIn(fragment, done.stderr)
        self.assertFalse(os.path.exists(self.path("none")), "a failed run left results")
