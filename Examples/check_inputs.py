# SPDX-License-Identifier: BSD-3-Clause
"""Checks which input files SimplifyShape reads and what it says of the others; run by check.py."""

import json
import math
import os
import resource
import struct
import subprocess

from input_files import (FACES, XYZ, ascii_ply, ascii_stl, binary_ply, binary_stl, ply_header, rows, triples,
                         xml)
from program_test import PROGRAM, ProgramTest, ellipsoid, torus

POINTS = ellipsoid(300)


class Inputs(ProgramTest):
    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def read(self, name, content, *options):
        """Runs on a file with this content; returns report.json without what varies."""
        done = self.run_program(self.write(name, content), "--output", self.path("out"),
                                "--schedule", "", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        with open(self.path("out/report.json")) as file:
            report = json.load(file)
        for key in ("seconds", "peakMemoryMiB"):
            del report[key]
        # The few polygons that some of these files have are an open surface.
        report["warnings"] = [warning for warning in report["warnings"]
                              if warning["code"] not in ("open_surface", "not_a_solid")]
        return report

    def refuse(self, name, content, *fragments):
        """Exit 2 within a second of computing, and a line that names the file and says these fragments."""
        begin = self.seconds()
        self.assert_fails(2, [name, *fragments], self.write(name, content))
        self.assertLess(self.seconds() - begin, 1)

    def seconds(self):
        """The time that all runs so far took, not counting what other programs took meanwhile."""
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    def test_unusable_files_give_2(self):
        self.assert_fails(2, ["nowhere.ply", "No such file"], self.path("nowhere.ply"))
        self.assert_fails(2, ["no DICOM images"], self.folder.name)
        self.assert_fails(2, ["too long"], self.path("x" * 300 + ".ply"))
        self.assert_fails(2, ["'.txt'", ".xyz"], self.write("points.txt", "0 0 0\n"))
        for name in ("bad.ply", "bad.vtp", "bad.vtu", "bad.stl", "bad.obj", "bad.off", "bad.xyz"):
            self.refuse(name, "nonsense\n")
            self.refuse(name, "")
            self.refuse(name, bytes(range(256)) * 4)

    def test_files_beyond_the_memory_give_2(self):
        with open(self.path("large.xyz"), "wb") as file:
            file.truncate(1 << 33)  # takes no space on the disk
        done = subprocess.run(
            [PROGRAM, self.path("large.xyz"), "--output", self.path("none")], capture_output=True,
            text=True, check=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30)))
        self.assertEqual(done.returncode, 2)
        self.assertIn("not enough memory", done.stderr)
        self.assertNotIn("bad_alloc", done.stderr)
        self.assertFalse(os.path.exists(self.path("none")))

    def test_unusable_points_give_2(self):
        self.assert_fails(2, ["4"], self.write_xyz([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))
        self.assert_fails(2, ["plane"], self.write_xyz([(i % 5, i // 5, 0) for i in range(25)]))
        self.assert_fails(2, ["line"], self.write_xyz([(i, 2 * i, 3 * i) for i in range(25)]))
        self.refuse("empty.xyz", "# nothing\n", "no points")

    def test_invalid_points_are_refused_or_dropped(self):
        bad = [(math.nan, 0, 0), (0, math.inf, 0)]
        clean = self.read("clean.xyz", rows(POINTS))
        self.assertEqual(clean["invalid"], 0)
        for name, content in (
                ("bad.xyz", rows(POINTS[:7] + bad + POINTS[7:])),
                ("bad.obj", "".join("v " + row + "\n" for row in
                                    rows(POINTS[:7] + bad + POINTS[7:]).splitlines())),
                ("bad.ply", binary_ply("<", "d", POINTS[:7] + bad + POINTS[7:]))):
            self.refuse(name, content, "2 of 302 points", "point 7 ", "--drop-invalid")
            report = self.read(name, content, "--drop-invalid")
            self.assertEqual(report.pop("invalid"), 2)
            self.assertEqual(report, {k: v for k, v in clean.items() if k != "invalid"})
        done = self.run_program(self.path("bad.xyz"), "--drop-invalid", "--output", self.path("out"))
        self.assertIn("300 samples, 2 invalid ones dropped", done.stdout)
        self.refuse("all.xyz", "nan nan nan\n", "1 of 1 points")
        self.assert_fails(2, ["no samples"], self.path("all.xyz"), "--drop-invalid")

    def test_invalid_normals_do_not_matter(self):
        clean = self.read("clean.xyz", rows(POINTS))
        self.assertEqual(self.read("n.xyz", rows(POINTS, end=" nan nan nan\n")), clean)
        names = "".join("property float %s\n" % name for name in ("nx", "ny", "nz"))
        done = self.run_program(
            self.write("n.ply", ascii_ply(300, rows(POINTS, end=" nan nan nan\n"), XYZ + names)),
            "--output", self.path("out"), "--schedule", "")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/report.json")) as file:
            report = json.load(file)
        self.assertEqual(report["balls"], clean["balls"])
        self.assertIn("unusable_normals", [warning["code"] for warning in report["warnings"]])

    def test_clean_takes_outliers_from_points(self):
        clean = self.read("clean.xyz", rows(POINTS))
        self.assertIsNone(clean["cleaning"])
        stray = self.read("stray.csv", rows(POINTS + [(0, 0, 40)]), "--clean")
        self.assertEqual(stray["cleaning"]["outliers"], 1)
        self.assert_fails(2, ["at least 20"], self.write_xyz(POINTS[:9]), "--clean")
        self.assert_fails(1, ["--clean"], "scan.mha", "--clean")

    def test_formats_agree_at_map_coordinates(self):
        """Floats would put these points on a lattice of half a metre."""
        points = [(5e6 + x, 6e6 + y, z) for x, y, z in POINTS]
        expected = self.read("map.xyz", rows(points))
        self.assertEqual((expected["samples"], expected["duplicates"]), (300, 0))
        cases = {
            "ascii.ply": ascii_ply(300, rows(points)),
            "float.ply": ascii_ply(300, rows(points), XYZ.replace("double", "float")),
            "little.ply": binary_ply("<", "d", points),
            "big.ply": binary_ply(">", "d", points),
            "v.obj": "".join("v " + row + "\n" for row in rows(points).splitlines()),
            "text.stl": ascii_stl(triples(points)),
            "points.off": "OFF 300 0 0\n" + rows(points),
            "points.vtp": xml("PolyData", points), "points.vtu": xml("UnstructuredGrid", points)}
        for name, content in cases.items():
            with self.subTest(name):
                self.assertEqual(self.read(name, content), expected)

    def test_float_formats_agree(self):
        points = [struct.unpack("3f", struct.pack("3f", *point)) for point in POINTS]
        expected = self.read("f.xyz", rows(points))
        triangles = triples(points)
        for name, content in (("little.ply", binary_ply("<", "f", points)),
                              ("big.ply", binary_ply(">", "f", points)),
                              ("binary.stl", binary_stl(triangles)),
                              ("header.stl", binary_stl(triangles, text=b"\0"))):
            with self.subTest(name):
                self.assertEqual(self.read(name, content), expected)

    def test_corners_of_triangles_that_differ_slightly_are_one(self):
        points = torus(1200)
        for off in (4e-7, 4e-5):  # the spacing is 0.13
            soup = [tuple(c + off * ((i * (k + 2)) % 3 - 1) / 2 for k, c in enumerate(point))
                    for point in points for i in range(3)]
            text = "".join("v %.7f %.7f %.7f\n" % point for point in soup)
            report = self.read("soup.obj", text)
            self.assertEqual(report["betti"]["crust"], [1, 1, 0])
            self.assertEqual((report["samples"], report["duplicates"]), (3600, 2400))
            self.assertEqual([w["code"] for w in report["warnings"]], ["merged_duplicates"])
        report = self.read("soup.obj", text, "--merge-tolerance", "0")
        self.assertEqual((report["duplicates"], report["mergeTolerance"]), (0, 0))

    def test_digits_of_a_text_tell_what_is_near(self):
        points = torus(600)
        written = ["%.3f %.3f %.3f\n" % point for point in points]
        written += ["%.3f %.3f %.3f\n" % (x + 0.001, y, z) for x, y, z in points]
        bad = "nan 0.000 0.000\n"
        for name, content, *options in (("rounded.xyz", "".join(written)),
                                        ("dropped.xyz", bad + "".join(written), "--drop-invalid"),
                                        ("v.obj", "".join("v " + line for line in written))):
            with self.subTest(name):
                report = self.read(name, content, *options)
                self.assertEqual(report["mergeTolerance"], 0.002)
                self.assertEqual(report["duplicates"], 600)

    def test_text_is_read_as_people_write_it(self):
        expected = self.read("plain.xyz", rows(POINTS))
        text = rows(POINTS)
        commas = rows(POINTS, ",")
        for name, content in (
                ("comments and more columns", "# comment\n" + rows(POINTS, ", ", " 255 0 abc # x\n\n")),
                ("marks", rows(POINTS, ";")), ("commas", commas),
                ("a byte order mark", b"\xef\xbb\xbf" + text.encode()),
                ("line ends of a Mac", text.replace("\n", "\r")),
                ("line ends of Windows", text.replace("\n", "\r\n")),
                ("no end of the last line", text[:-1]), ("plus signs", "+" + text),
                ("a count", "300\n" + text), ("a header", "X Y Z Nx Ny Nz\n" + text),
                ("a header with marks", '"x","y","z"\n' + commas), ("slashes", "//X Y Z\n" + text)):
            with self.subTest(name):
                self.assertEqual(self.read("p.xyz", content), expected)

    def test_commas_between_whole_numbers_are_columns_where_the_file_tells(self):
        points = [(round(50 * x), round(50 * y), round(50 * z)) for x, y, z in POINTS]
        expected = self.read("plain.xyz", rows(points))
        for name, content in (("three", rows(points, ",")), ("blanks", rows(points, ", ")),
                              ("a header", "x,y,z,r,g,b\n" + rows(points, ",", ",1,2,3\n")),
                              ("semicolons", rows(points, ";", ";1;2\n")),
                              ("a label", rows(points, ",", ",p.1\n")),
                              ("points elsewhere", rows(points, ",", ",0,0.5\n"))):
            with self.subTest(name):
                self.assertEqual(self.read("p.xyz", content), expected)

    def test_text_that_misleads_is_refused(self):
        text = rows(POINTS)
        comma = text.replace(".", ",")
        for name, content, *fragments in (
                ("a word", "0 0 0\n0 a 0\n", "line 2", "'0 a 0'"),
                ("words for numbers", text.replace("0.", "zz"), "line 1"),
                ("decimal commas", comma, "line 1", "decimal comma", "0.5"),
                ("decimal commas, marks", comma.replace(" ", ";"), "line 1", "decimal comma"),
                ("decimal commas, tabs", comma.replace(" ", "\t"), "line 1", "decimal comma"),
                ("decimal commas, commas", "1,05,2,5,3,5\n", "line 1", "decimal comma"),
                ("commas that may be either", "1,5,2,5,3,5\n" * 9, "line 1", "'1,5,2,5,3,5'",
                 "name the columns"),
                ("commas of some numbers", "1,2,3\n1,5,2,3\n", "line 2", "decimal commas"),
                ("commas, blanks", comma.replace(" ", ", "), "line 1", "decimal comma"),
                ("a count", "2\n1,5,2,5,3,5\n1,2,3\n", "line 2", "decimal commas"),
                ("decimal commas and exponents", "1,5e3 2,5 3,5\n", "line 1", "decimal comma"),
                ("two columns", text + "1 2\n", "line 301", "expected x y z"),
                ("other columns", "id x y z\n" + text, "line 1", "header"),
                ("a wrong count", "301\n" + text, "line 1", "301", "300"),
                ("UTF-16", text.encode("utf-16"), "UTF-16")):
            with self.subTest(name):
                self.refuse("p.xyz", content, *fragments)

    def test_off_files_that_contradict_themselves_are_refused(self):
        text = rows(POINTS[:9])
        for name, content, *fragments in (
                ("no keyword", "PLY\n", "line 1"), ("cut", "OFF 9 0 0\n0 0 0\n", "1 of 9 points"),
                ("binary", "OFF BINARY\n", "binary"), ("no counts", "OFF\n", "missing"),
                ("a huge count", "OFF 99999999999999 0 0\n" + text, "9 of 99999999999999"),
                ("a negative count", "OFF -1 0 0\n", "line 1"),
                ("cut faces", "OFF 9 2 0\n" + text + "3 0 1 2\n", "1 of 2 faces"),
                ("an index", "OFF 9 1 0\n" + text + "3 0 1 9\n", "line 11", "0 to 8"),
                ("a short face", "OFF 9 1 0\n" + text + "3 0 1\n", "line 11"),
                ("too many points", "OFF 8 0 0\n" + text, "line 10", "more")):
            with self.subTest(name):
                self.refuse("p.off", content, *fragments)

    def test_ply_files_of_all_shapes_are_read(self):
        expected = self.read("plain.xyz", rows(POINTS))
        flipped = "property double z\nproperty list uchar float extra\n" + \
            "property double y\nproperty uchar red\nproperty double x\n"
        body = "".join("%.17g 2 7 -8 %.17g 255 %.17g\n" % (z, y, x) for x, y, z in POINTS)
        edges = ("edge", 2, "property int vertex1\nproperty int vertex2\n")
        faces = ("face", 2, "property uchar flags\n" + FACES)
        for name, content in (
                ("another order", ascii_ply(300, body, flipped)),
                ("elements before", ply_header([edges, ("vertex", 300, XYZ)]) + "0 1\n1 2\n" +
                 rows(POINTS)),
                ("faces before", ply_header([faces, ("vertex", 300, XYZ)]) + "0 3 0 1 2\n1 0\n" +
                 rows(POINTS)),
                ("empty faces", ascii_ply(300, rows(POINTS), more=[("face", 0, FACES)])),
                ("Windows", ascii_ply(300, rows(POINTS)).replace("\n", "\r\n")),
                ("Windows, binary", binary_ply("<", "d", POINTS, end="\r\n")),
                ("Mac, binary", binary_ply(">", "d", POINTS, end="\r")),
                ("binary faces", binary_ply("<", "d", POINTS, more=[("face", 1, FACES)],
                                            tail=struct.pack("<B3i", 3, 0, 1, 299)))):
            with self.subTest(name):
                self.assertEqual(self.read("p.ply", content), expected)

    def test_ply_files_that_contradict_themselves_are_refused(self):
        text = rows(POINTS)
        whole = binary_ply("<", "f", POINTS)
        many = "".join("property float p%d\n" % i for i in range(90))

        def face(row, count=1):
            return ascii_ply(300, text + row, more=[("face", count, FACES)])

        def binary_face(tail, count=1):
            return binary_ply("<", "f", POINTS, more=[("face", count, FACES)], tail=tail)

        for name, content, *fragments in (
                ("cut", whole[:1000], "row ", "vertex", "300 rows", "cut"),
                ("cut header", whole[:60], "end_header"),
                ("more rows announced", ascii_ply(400, text), "300 of 400 rows", "vertex"),
                ("fewer rows announced", ascii_ply(299, text), "more rows", "line 308"),
                ("bytes left", whole + b"1234", "4 bytes more"),
                ("a huge count", binary_ply("<", "f", POINTS, 99999999999999), "99999999999999"),
                ("a count beyond all", binary_ply("<", "f", POINTS, 10 ** 30), "line 4"),
                ("a negative count", ascii_ply(-300, text), "line 4"),
                ("a huge count of faces", binary_face(b"", 100000), "face", "100000 rows"),
                ("a huge count of nothing", ply_header([("x", 10 ** 17, ""), ("vertex", 300, XYZ)]) +
                 text, "element x"),
                ("a face's corner", face("3 0 1 9999999\n"), "line 311", "does not exist"),
                ("a negative corner", face("3 0 1 -1\n"), "line 311", "does not exist"),
                ("a face's length", face("200 0 1\n"), "line 311", "vertex_indices"),
                ("a negative length", face("-1\n"), "line 311", "vertex_indices"),
                ("a binary face's length", binary_face(b"\xff\0\0\0"), "face", "vertex_indices"),
                ("a cut face", face("3 0 1\n"), "line 311"),
                ("short rows", ascii_ply(300, text, XYZ + many), "line 99"),
                ("long rows", ascii_ply(300, rows(POINTS, end=" 1\n")), "line 9", "3 numbers"),
                ("shifted rows", ascii_ply(2, "0 0\n0 1 1 1\n"), "line 9"),
                ("no x", ascii_ply(300, text, XYZ.replace(" x", " q")), "no x"),
                ("a list for x", ascii_ply(300, text, XYZ.replace("double x", "list uchar int x"))),
                ("two x", ascii_ply(300, text, XYZ + "property float x\n"), "line 8", "two"),
                ("no vertices", ply_header([("face", 0, FACES)]), "vertex"),
                ("words", ascii_ply(300, text.replace("0.", "zz")), "line 9"),
                ("decimal commas", ascii_ply(300, text.replace(".", ",")), "line 9", "decimal comma"),
                ("an unknown type", ascii_ply(300, text, XYZ.replace("double", "real")), "line 5"),
                ("an unknown format", ascii_ply(300, text).replace("ascii", "utf8"), "line 2")):
            with self.subTest(name):
                self.refuse("p.ply", content, *fragments)

    def test_obj_files(self):
        text = "".join("v " + row + "\n" for row in rows(POINTS).splitlines())
        expected = self.read("plain.xyz", rows(POINTS))
        for content in (text + "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 -300/1\nf 1 2// \\\n 3/\nl 1 2\n",
                        "# faces first\no name\ng a b\nusemtl m\nf 1 2 300\n" + text,
                        text.replace("\n", " 1.0\n"), text.replace("\n", " 255 0 0\r\n")):
            self.assertEqual(self.read("p.obj", content), expected)
        for row, *fragments in (
                ("f 1/5/7 2/9/9 3//4\n", "vt 9"), ("f 1 2 301\n", "line 301", "v 301", "300"),
                ("f 1 2 0\n", "line 301"), ("f 1 2 -301\n", "line 301"), ("f 1 2\n", "line 301"),
                ("f 1 2 /3\n", "line 301"), ("f 1 2 3/1/1/1\n", "line 301"), ("v 0 0\n", "line 301"),
                ("v 0 0 zz\n", "line 301", "'v 0 0 zz'"), ("V 0 0 0\n", "line 301", "'V 0 0 0'"),
                ("v 0,5 0 0\n", "line 301", "decimal comma"), ("f 1 2 99999999999999999999\n",)):
            with self.subTest(row):
                self.refuse("p.obj", text + row, *fragments)

    def test_stl_files_that_contradict_themselves_are_refused(self):
        triangles = triples(POINTS[:30])
        whole, text = binary_stl(triangles), ascii_stl(triangles)
        for name, content, *fragments in (
                ("cut", whole[:800], "28 triangles", "1484 bytes", "800"),
                ("a huge count", binary_stl(triangles, 2 ** 32 - 1), "4294967295"),
                ("bytes left", whole + b"12", "1486"),
                ("cut text", text[:400], "line "), ("no end", text[:-9], "endsolid"),
                ("two corners", text.replace("  vertex", "  # vertex", 1), "line 4"),
                ("four corners", text.replace(" endloop", "  vertex 0 0 0\n endloop", 1), "line 7"),
                ("a word", text.replace("vertex ", "vertex a", 1), "line 4")):
            with self.subTest(name):
                self.refuse("p.stl", content, *fragments)

    def test_points_beyond_the_number_in_xml_are_refused(self):
        """VTK's readers leave them out without a word."""
        for kind, name in (("PolyData", "p.vtp"), ("UnstructuredGrid", "p.vtu")):
            for number in ("Float32", "Float64"):
                self.refuse(name, xml(kind, POINTS, "299", number=number), "NumberOfPoints", "299")

    def test_cells_in_xml_that_name_no_points_are_refused(self):
        cells = [(0, 1, 2), (2, 3, 300)]
        for kind, name in (("PolyData", "p.vtp"), ("UnstructuredGrid", "p.vtu")):
            self.refuse(name, xml(kind, POINTS, cells=cells), "names point 300", "300")
            self.refuse(name, xml(kind, POINTS, cells=cells[:1], count=0), "more cells")

    def test_damage_that_upsets_the_readers_of_vtk_is_refused(self):
        """On these VTK 9.1's readers crash, run away, or ask for terabytes."""
        for kind, name in (("PolyData", "p.vtp"), ("UnstructuredGrid", "p.vtu")):
            for content in (
                    xml(kind, POINTS, "99999999999999"), xml(kind, POINTS, "-1"),
                    xml(kind, POINTS, count="99999999999999"),
                    xml(kind, POINTS, components="18446744073709551616"),
                    xml(kind, POINTS, "301"), xml(kind, POINTS)[:9000],
                    xml(kind, POINTS).replace("0.", "zz"), xml(kind, [])):
                with self.subTest(name, content=content[:120]):
                    self.refuse(name, content)
