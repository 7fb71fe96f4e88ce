# SPDX-License-Identifier: BSD-3-Clause
"""Checks what SimplifyShape makes of polygons; run by check.py."""

import json
import unittest

from program_test import ProgramTest


class Meshes(ProgramTest):

    def test_mesh_is_sampled_and_compared_with_its_solid(self):
        box = self.write("box.obj", "".join("v %d %d %d\n" % (i & 1, (i >> 1 & 1) * 2, (i >> 2) * 3)
                                            for i in range(8)) +
                         "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")
        done = self.run_program(box, "--output", self.path("box"), "--strict", "--spacing", "0.1")
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        self.assertIn(" samples on 6 polygons", done.stdout)
        self.assertIn("solid 1 0 0, power shape 1 0 0", done.stdout)
        with open(self.path("box/report.json")) as file:
            report = json.load(file)
        self.assertEqual(report["source"], "triangles")
        self.assertEqual(report["betti"], {"segmentation": None, **dict.fromkeys(
            ("solid", "powerShape", "axis", "pruned", "crust"), [1, 0, 0])})
        self.assertEqual(report["sampling"]["polygons"], 6)
        self.assertAlmostEqual(report["sampling"]["volume"], 6)
        self.assertAlmostEqual(report["sampling"]["area"], 22)
        self.assertEqual(report["warnings"], [])
        self.assertAlmostEqual(report["volume"]["crustBefore"], 6, delta=0.1)
        done = self.run_program(box, "--output", self.path("corners"), "--points")
        self.assertEqual(done.returncode, 2, "eight corners are no samples: " + done.stdout)

    def test_mesh_that_bounds_no_solid_is_wrapped_on_request(self):
        corners = "".join("v %g %g %g\n" % (0.4 * at + (i & 1), 0.4 * at + (i >> 1 & 1), 0.4 * at + (i >> 2))
                          for at in (0, 1) for i in range(8))
        sides = ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6))
        boxes = self.write("boxes.obj", corners + "".join(
            "f %d %d %d %d\n" % tuple(8 * at + corner for corner in side) for at in (0, 1) for side in sides))
        for options in (["--wrap"], ["--wrap-width", "0.1"]):
            done = self.run_program(boxes, "--output", self.path("boxes"), "--strict", "--spacing", "0.1", *options)
            self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
            self.assertIn("samples on 12 polygons", done.stdout)
            self.assertIn("a surface around them", done.stdout)

    def test_polygons_without_invalid_corners_stay(self):
        corners = "".join("v %d %d %d\n" % (i & 1, (i >> 1 & 1) * 2, (i >> 2) * 3) for i in range(8))
        sides = "f 2 4 5 3\nf 6 7 9 8\nf 2 3 7 6\nf 4 8 9 5\nf 2 6 8 4\nf 3 5 9 7\n"
        for name, more, said in (("unused.obj", "", ""),
                                 ("used.obj", "f 1 2 4\nf 4 2 1\n", ", with 2 polygons at them")):
            box = self.write(name, "v nan 0 0\n" + corners + sides + more)
            self.assertEqual(self.run_program(box, "--output", self.path("box")).returncode, 2)
            done = self.run_program(box, "--output", self.path("box"), "--drop-invalid", "--strict",
                                    "--spacing", "0.1")
            self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
            self.assertIn(" samples on 6 polygons, 1 invalid ones dropped%s\n" % said, done.stdout)
            with open(self.path("box/report.json")) as file:
                report = json.load(file)
            self.assertEqual(report["source"], "triangles")
            self.assertEqual((report["invalid"], report["invalidPolygons"]), (1, 2 if more else 0))
            self.assertEqual(report["betti"]["crust"], [1, 0, 0])


if __name__ == "__main__":
    unittest.main()
