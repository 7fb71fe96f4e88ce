# SPDX-License-Identifier: BSD-3-Clause
"""Checks the files that SimplifyShape writes for other programs: --ma and --export-parts; run by check.py."""

import collections
import csv
import os
import re
import resource
import struct
import subprocess
import unittest

from program_test import PROGRAM, ProgramTest, ellipsoid, torus


def triangles(stl):
    """The corners of each triangle of a binary file, as bytes."""
    with open(stl, "rb") as file:
        content = file.read()
    count, = struct.unpack_from("<I", content, 80)
    if len(content) != 84 + 50 * count:
        raise ValueError(stl)
    for i in range(count):
        corners = content[84 + 50 * i + 12:84 + 50 * i + 48]
        yield corners[:12], corners[12:24], corners[24:]


def is_closed(patch):
    edges = collections.Counter()
    for a, b, c in patch:
        edges.update(((a, b), (b, c), (c, a)))
    return all(count == edges[b, a] for (a, b), count in edges.items())


class Exports(ProgramTest):
    def box(self):
        """A box, whose axis has many sheets."""
        return self.write("box.obj", "".join("v %d %d %d\n" % (i & 1, (i >> 1 & 1) * 2, (i >> 2) * 3) for i in range(8)) +
                          "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")

    def export(self, points, *arguments):
        out = self.path("out")
        done = self.run_program(points, "--output", out, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out, done.stdout

    def part_files(self):
        return {name for name in os.listdir(self.path("out")) if name.startswith("part-")}

    def rows(self):
        with open(self.path("out/exported.csv"), newline="") as file:
            return list(csv.DictReader(file))

    def medial_mesh(self, name):
        """Points with radii, edges, triangles of a file, as its first line counts them."""
        with open(self.path("out/" + name)) as file:
            counts = [int(word) for word in file.readline().split()]
            lines = [line.split() for line in file]
        self.assertEqual([line[0] for line in lines], ["v"] * counts[0] + ["e"] * counts[1] + ["f"] * counts[2])
        points = [tuple(map(float, line[1:])) for line in lines if line[0] == "v"]
        edges = [frozenset(map(int, line[1:])) for line in lines if line[0] == "e"]
        faces = [tuple(map(int, line[1:])) for line in lines if line[0] == "f"]
        return points, edges, faces

    def test_medial_meshes_hold_the_axis(self):
        for points, euler in ((ellipsoid(1000), 1), (torus(2000), 0)):
            out, text = self.export(self.write_xyz(points), "--ma", "--strict")
            for name in ("axis.ma", "pruned.ma"):
                points, edges, faces = self.medial_mesh(name)
                self.assertEqual({len(point) for point in points}, {4})
                self.assertGreater(min(point[3] for point in points), 0)
                self.assertEqual(len(points) - len(edges) + len(faces), euler, name)
                self.assertEqual(len(set(edges)), len(edges))
                self.assertEqual(set(edges), set(edges) | {
                    frozenset((face[i - 1], face[i])) for face in faces for i in range(3)})
                self.assertEqual(set().union(*edges), set(range(len(points))), "an unused point")
            count, = re.search("axis +([0-9,]+) triangles", text).groups()
            self.assertEqual(len(self.medial_mesh("axis.ma")[2]), int(count.replace(",", "")))
            self.assertEqual(self.part_files(), set())
            self.assertFalse(os.path.exists(os.path.join(out, "exported.csv")))

    def test_meshes_of_parts_are_the_surface(self):
        out, text = self.export(self.box(), "--spacing", "0.15", "--export-parts")
        rows = self.rows()
        self.assertGreater(len(rows), 8)
        self.assertEqual(len(rows), int(re.findall("-> ([0-9]+) part", text)[-1]))
        self.assertEqual({int(row["PartId"]) for row in rows}, set(range(len(rows))))
        volumes = [float(row["RelativeVolume"]) for row in rows]
        self.assertEqual(volumes, sorted(volumes, reverse=True))
        self.assertAlmostEqual(sum(volumes), 1)
        self.assertEqual(self.part_files(), {row["File"] for row in rows} - {""})
        found = []
        for row in rows:
            patch = list(triangles(os.path.join(out, row["File"]))) if row["File"] else []
            self.assertEqual(row["File"], "part-%s.stl" % row["PartId"] if patch else "")
            self.assertEqual(len(patch), int(row["Triangles"]))
            self.assertEqual(bool(patch) and is_closed(patch), row["Closed"] == "1")
            found += patch
        self.assertEqual(sorted(found), sorted(triangles(os.path.join(out, "surface.stl"))))
        self.assertFalse(os.path.exists(os.path.join(out, "axis.ma")))

    def test_only_part_is_the_closed_surface(self):
        out, _ = self.export(self.write_xyz(ellipsoid(1000)), "--schedule", "skeleton", "--export-parts")
        row, = self.rows()
        self.assertEqual((row["PartId"], row["File"], row["Closed"]), ("0", "part-0.stl", "1"))
        self.assertEqual(float(row["RelativeVolume"]), 1)
        self.assertEqual(sorted(triangles(os.path.join(out, "part-0.stl"))),
                         sorted(triangles(os.path.join(out, "surface.stl"))))

    def test_new_results_replace_the_old_parts_and_nothing_else(self):
        out, _ = self.export(self.box(), "--spacing", "0.2", "--export-parts", "--ma")
        before = self.part_files()
        self.assertGreater(len(before), 4)
        mine = {"part-07.stl", "part-1.stl.txt", "my-part-1.stl", "part-.stl", "part-900.stl"}
        for name in mine - {"part-900.stl"}:
            self.write("out/" + name, "the user's")
        os.mkdir(self.path("out/part-900.stl"))
        self.export(self.write_xyz(ellipsoid(1000)), "--schedule", "skeleton", "--export-parts")
        self.assertEqual({name for name in os.listdir(out) if "part-" in name}, mine | {"part-0.stl"})
        self.assertFalse(os.path.exists(os.path.join(out, "axis.ma")))
        self.export(self.write_xyz(ellipsoid(1000)))
        self.assertEqual({name for name in os.listdir(out) if "part-" in name}, mine)
        self.assertFalse(os.path.exists(os.path.join(out, "exported.csv")))

    def test_mesh_of_a_part_that_is_the_input_is_not_replaced(self):
        out, _ = self.export(self.write_xyz(ellipsoid(1000)), "--schedule", "skeleton", "--export-parts")
        part = os.path.join(out, "part-0.stl")
        for arguments in ((), ("--export-parts",)):
            done = self.run_program(part, "--output", out, *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn("part-0.stl: is the input", done.stderr)
        self.assertTrue(os.path.exists(part))

    def test_full_disk_leaves_nothing(self):
        points = self.write_xyz(ellipsoid(600))
        out, _ = self.export(points, "--ma", "--export-parts")
        sizes = {name: os.path.getsize(os.path.join(out, name)) for name in ("axis.ma", "pruned.ma", "part-0.stl")}
        for name, size in sizes.items():
            done = subprocess.run([PROGRAM, points, "--output", self.path("new"), "--ma", "--export-parts"],
                                  capture_output=True, text=True, preexec_fn=lambda size=size: resource.setrlimit(
                                      resource.RLIMIT_FSIZE, (size - 1, size - 1)))
            self.assertEqual(done.returncode, 2, name)
            self.assertRegex(done.stderr, "can't be written: (File too large|No space left)")
            self.assertFalse(os.path.exists(self.path("new")))


if __name__ == "__main__":
    unittest.main()
