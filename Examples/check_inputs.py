# SPDX-License-Identifier: BSD-3-Clause
"""Checks which input files SimplifyShape reads and what it says of the others; run by check.py."""

import math

from program_test import ProgramTest, ellipsoid


class Inputs(ProgramTest):
    def test_unusable_files_give_2(self):
        self.assert_fails(2, ["nowhere.ply", "No such file"], self.path("nowhere.ply"))
        self.assert_fails(2, ["is a folder"], self.folder.name)
        self.assert_fails(2, ["'.txt'", ".xyz"], self.write("points.txt", "0 0 0\n"))
        self.assert_fails(2, ["bad.xyz", "line 2", "0 a 0"], self.write("bad.xyz", "0 0 0\n0 a 0\n"))
        self.assert_fails(2, ["bad.off", "line 1"], self.write("bad.off", "PLY\n"))
        self.assert_fails(2, ["of 9 points"], self.write("short.off", "OFF 9 0 0\n0 0 0\n"))
        self.assert_fails(2, ["binary"], self.write("binary.off", "OFF BINARY\n"))
        for name in ("bad.ply", "bad.vtp", "bad.vtu", "bad.stl", "bad.obj"):
            self.assert_fails(2, [name], self.write(name, "nonsense\n"))

    def test_unusable_points_give_2(self):
        self.assert_fails(2, ["4"], self.write_xyz([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))
        self.assert_fails(2, ["plane"], self.write_xyz([(i % 5, i // 5, 0) for i in range(25)]))
        self.assert_fails(2, ["line"], self.write_xyz([(i, 2 * i, 3 * i) for i in range(25)]))
        self.assert_fails(2, ["finite"], self.write_xyz(ellipsoid(100) + [(math.nan, 0, 0)]))
        self.assert_fails(2, [], self.write("empty.xyz", "# nothing\n"))

    def test_xyz_is_read_with_comments_and_more_columns(self):
        text = "".join("%.17g, %.17g; %.17g 255 0 abc\n\n" % point for point in ellipsoid(300))
        out = self.path("out")
        done = self.run_program(self.write("p.xyz", "# comment\n" + text), "--output", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("300 samples", done.stdout)
