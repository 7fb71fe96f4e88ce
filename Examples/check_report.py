# SPDX-License-Identifier: BSD-3-Clause
"""Checks the page that SimplifyShape writes with --report; run by check.py."""

import base64
import collections
import html.parser
import json
import math
import os
import re
import resource
import struct
import subprocess
import unittest

from program_test import PROGRAM, ProgramTest, ellipsoid, torus

VOID = {"meta", "img", "br", "hr", "link", "input", "source", "wbr", "area", "base", "col", "embed", "track"}
ITSELF = ("data:image/png;base64,", "#")


class Page(html.parser.HTMLParser):
    """The elements of a page, its text, and the rows of its tables as texts and exact numbers."""

    def __init__(self, text):
        super().__init__()
        self.open, self.elements, self.text, self.rows, self.faults = [], [], "", [], []
        self.feed(text)
        self.close()
        self.faults += ["%s is not closed" % tag for tag in self.open]

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
        if tag == "data" and "tr" in self.open:
            self.rows[-1][-1] = float(dict(attrs)["value"])

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append("</%s> at %s" % (tag, self.getpos()))

    def handle_data(self, data):
        self.text += data
        if self.open and self.open[-1] in ("td", "th", "sup"):
            self.rows[-1][-1] += "^" + data if self.open[-1] == "sup" else data

    def row(self, name):
        found, = [row for row in self.rows if row and row[0] == name]
        return found[1:]

    def all(self, tag):
        return [attributes for name, attributes in self.elements if name == tag]


class ReportPage(ProgramTest):
    def blind(self):
        return {key: value for key, value in os.environ.items() if key != "DISPLAY"}

    def page(self, points, *arguments, environment=None, code=0):
        """Runs on a file; returns the page, the report and what was said."""
        out = self.path("out")
        done = self.run_program(points, "--report", "--output", out, *arguments, environment=environment)
        self.assertEqual(done.returncode, code, done.stderr)
        with open(os.path.join(out, "report.html"), encoding="utf-8") as file:
            text = file.read()
        with open(os.path.join(out, "report.json")) as file:
            report = json.load(file)
        return self.checked(text), report, done

    def checked(self, text):
        """A page that stands alone."""
        self.assertTrue(text.startswith("<!DOCTYPE html>\n<html lang=\"en\">"))
        page = Page(text)
        self.assertEqual(page.faults, [])
        for tag, attributes in page.elements:
            self.assertNotIn(tag, ("script", "link", "iframe", "object"))
            for name in ("src", "href", "srcset", "xlink:href"):
                self.assertTrue(attributes.get(name, "#").startswith(ITSELF), name)
            self.assertFalse([name for name in attributes if name.startswith("on")])
        self.assertEqual(set(re.findall(r"url\((.)", text)) - {"#"}, set())
        self.assertNotRegex(re.sub("base64,[^\"]*", "", text), "https?:|@import|nan|inf")
        names = collections.Counter(attributes["id"] for _, attributes in page.elements if "id" in attributes)
        self.assertEqual(set(names.values()) - {1}, set())
        for image in page.all("img"):
            self.assertTrue(image["alt"])
        self.assertTrue(all(svg["aria-label"] for svg in page.all("svg")))
        return page

    def check_numbers(self, page, report):
        self.assertEqual(page.row("samples"), [report["samples"]])
        self.assertEqual(page.row("parts before pruning"), [report["parts"]])
        self.assertEqual(page.row("parts after pruning"), [report["iterations"][-1]["partsAfter"]])
        moved, volume = report["moved"], report["volume"]
        self.assertEqual(page.row("mean distance between samples"), [moved["spacing"]])
        self.assertEqual(page.row("pruning moved 99 % of the samples by at most"), [moved["percentile99"]])
        self.assertEqual(page.row("pruning moved all samples by at most"), [moved["largest"]])
        self.assertEqual(page.row("volume before pruning"), [volume["crustBefore"]])
        self.assertEqual(page.row("volume after pruning"), [volume["crustAfter"]])
        for key, name in (("segmentation", "voxels"), ("solid", "solid of the input"), ("powerShape", "power shape"),
                          ("axis", "medial axis"), ("pruned", "pruned axis"), ("crust", "simplified surface")):
            rows = [row[1:] for row in page.rows if row and row[0] == name]
            self.assertEqual(rows, [report["betti"][key]] if report["betti"][key] else [])

    def test_page_tells_what_the_report_tells(self):
        page, report, done = self.page(self.write_xyz(torus()), environment=self.blind())
        self.check_numbers(page, report)
        self.assertIn("Verdict: certified", page.text)
        self.assertIn("points.xyz", page.text)
        self.assertNotIn(self.path(""), page.text)  # a folder's name is nobody's business
        mean, deviation, smallest, largest, number = page.row("Thickness")
        self.assertAlmostEqual(mean, 0.8, delta=0.012)  # of a tube with the radius 0.4
        self.assertLess(deviation, 0.03)
        self.assertTrue(smallest < mean < largest < 0.83)
        self.assertGreater(number, 9000)
        self.assertGreater(page.row("Separation")[0], 0.5)
        self.assertEqual([svg["aria-label"].split(":")[0] for svg in page.all("svg")],
                         ["Histogram of the Thickness", "Histogram of the Separation"])
        self.assertIn("no pictures", done.stderr)

    def test_unit_and_morphometry_are_on_the_page(self):
        points = self.write_xyz(ellipsoid(800))
        page, _, _ = self.page(points, "--unit", "<mm>", environment=self.blind())
        self.assertIn("Lengths are in <mm>, volumes in <mm>\u00b3.", page.text)
        self.assertIn("Thickness (<mm>)", page.text)
        self.assertNotIn("Bouxsein", page.text)
        page, report, _ = self.page(points, "--morphometry", "--unit", "mm", environment=self.blind())
        self.assertIn("Bouxsein", page.text)
        with open(self.path("out/thickness.vtp")) as thickness:
            self.assertIn('Name="Unit"', thickness.read())
        values, units = report["morphometry"]["values"], report["morphometry"]["units"]
        self.assertGreater(len(values), 10)
        for name, value in values.items():
            self.assertEqual(page.row(name), ["\u2013" if value is None else value, units[name], ""], name)
        for code in report["morphometry"]["warnings"]:
            self.assertIn(code, page.text)

    def test_morphometry_and_page_have_the_same_means(self):
        points = self.write_xyz(ellipsoid(800))
        alone, _, _ = self.page(points, environment=self.blind())
        page, report, _ = self.page(points, "--morphometry", environment=self.blind())
        for name in "Thickness", "Separation":
            self.assertEqual(page.row(name), alone.row(name))
        self.assertEqual([svg["aria-label"] for svg in page.all("svg")],
                         [svg["aria-label"] for svg in alone.all("svg")])
        values = report["morphometry"]["values"]
        self.assertAlmostEqual(page.row("Thickness")[0], values["Tb.Th"], delta=1e-3 * values["Tb.Th"])
        # In a volume of interest the page is still that of the whole solid.
        cut, report, _ = self.page(points, "--morphometry", "--bounds", "0,2,-2,2,-2,2", environment=self.blind())
        self.assertEqual(cut.row("Thickness"), alone.row("Thickness"))
        self.assertNotEqual(report["morphometry"]["values"]["Tb.Th"], values["Tb.Th"])

    def test_cohort_has_a_page_for_each(self):
        files = [self.write_xyz(ellipsoid(400), "a.xyz"), self.write_xyz(ellipsoid(500), "b.xyz")]
        self.assert_fails_plainly("--output", "--cohort", self.path("t.csv"), "--report", *files)
        done = self.run_program("--cohort", self.path("t.csv"), "--report", *files, "--output", self.path("out"),
                                environment=self.blind())
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in "ab":
            with open(self.path("out/%s/report.html" % name)) as file:
                self.assertIn(name + ".xyz", self.checked(file.read()).text)

    def assert_fails_plainly(self, fragment, *arguments):
        done = self.run_program(*arguments)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))
        self.assertIn(fragment, done.stderr)

    def test_page_tells_reasons_and_warnings(self):
        steps = 0.8191725134, 0.6710436067, 0.5497004779
        points = [tuple(i * step % 1 for step in steps) for i in range(1, 1500)]
        page, report, _ = self.page(self.write_xyz(points), "--strict", code=3, environment=self.blind())
        self.check_numbers(page, report)
        self.assertIn("Verdict: not certified", page.text)
        self.assertTrue(report["verdict"]["differs"] and report["warnings"])
        for text in report["verdict"]["differs"] + [warning["text"] for warning in report["warnings"]]:
            self.assertIn(text, page.text)

    def test_thin_places_are_listed_the_thinnest_first(self):
        """A square plate that is thinnest in its middle, 0.2, and grows to 1 at its corners."""
        steps = [-1 + i / 20 for i in range(41)]
        height = {(x, y): 0.1 + 0.2 * (x * x + y * y) for x in steps for y in steps}
        points = [(x, y, side * z) for (x, y), z in height.items() for side in (-1, 1)]
        for (x, y), z in height.items():
            if 1 in (abs(x), abs(y)):
                rows = round(2 * z / 0.05)
                points += [(x, y, -z + 2 * z * k / rows) for k in range(1, rows)]
        page, _, _ = self.page(self.write_xyz(points), environment=self.blind())
        places = [row for row in page.rows if len(row) == 6 and row[0].isdigit()]
        self.assertTrue(1 <= len(places) <= 10)
        self.assertEqual([row[1] for row in places], sorted(row[1] for row in places))
        self.assertAlmostEqual(places[0][1], 0.2, delta=0.005)
        self.assertLess(math.dist(places[0][2:5], (0, 0, 0)), 0.1)

    def test_names_are_text(self):
        points = self.write_xyz(ellipsoid(600))
        for name, shown in ((b"<b>&\"x'</title>.xyz", "<b>&\"x'"), (b"a\xff\xc3\xa4\x01b.xyz", "a?\u00e4?b.xyz")):
            named = os.path.join(os.fsencode(self.folder.name), name.replace(b"/", b"|"))
            os.replace(points, named)
            page, _, _ = self.page(named, environment=self.blind())
            self.assertIn(shown, page.text)
            self.assertEqual(page.all("b"), [])
            os.replace(named, points)

    def test_page_is_the_same_for_any_number_of_threads(self):
        texts = set()
        for threads in "12":
            self.page(self.write_xyz(torus(1500)), "--threads", threads, environment=self.blind())
            with open(self.path("out/report.html")) as file:
                texts.add(file.read())
        self.assertEqual(len(texts), 1)

    def test_page_without_display_says_so(self):
        points = self.write_xyz(ellipsoid(600))
        for environment in (self.blind(), {**os.environ, "DISPLAY": ":98765"}):
            page, _, done = self.page(points, environment=environment)
            self.assertEqual(page.all("img"), [])
            self.assertIn("There are no pictures: a picture needs an X server", page.text)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    @unittest.skipUnless(os.environ.get("DISPLAY"), "needs an X server")
    def test_pictures_are_part_of_the_page(self):
        page, _, done = self.page(self.write_xyz(torus(1500)), "--picture")
        self.assertEqual(done.stderr, "")
        images = page.all("img")
        self.assertEqual(len(images), 3)
        self.assertEqual(len({image["src"] for image in images}), 3)
        for image in images:
            content = base64.b64decode(image["src"].partition(",")[2], validate=True)
            self.assertEqual(content[:4], b"\x89PNG")
            self.assertEqual(struct.unpack(">II", content[16:24]), (760, 760))
        self.assertEqual(len(page.all("svg")), 4)  # with legends
        self.assertTrue(os.path.exists(self.path("out/overview.png")))

    def test_files_come_and_go_with_the_other_results(self):
        points, out = self.write_xyz(ellipsoid(600)), self.path("out")
        self.run_program(points, "--output", out)
        plain = set(os.listdir(out))
        self.page(points)
        self.assertEqual(set(os.listdir(out)) - plain, {"report.html", "thickness.vtp"})
        with open(os.path.join(out, "thickness.vtp")) as thickness, open(os.path.join(out, "surface.vtp")) as surface:
            self.assertEqual(set(re.findall('Name="(Thickness|Separation)"', thickness.read())), {"Thickness"})
            self.assertNotIn('"Thickness"', surface.read())
        self.run_program(points, "--output", out)
        self.assertEqual(set(os.listdir(out)), plain)
        self.assertEqual([name for name in os.listdir(self.folder.name) if name.startswith(".")], [])

    def test_full_disk_leaves_nothing(self):
        points = self.write_xyz(ellipsoid(600))
        self.page(points)
        size = os.path.getsize(self.path("out/thickness.vtp")) - 1
        done = subprocess.run([PROGRAM, points, "--report", "--output", self.path("new")], capture_output=True, text=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertFalse(os.path.exists(self.path("new")))
        self.assertEqual([name for name in os.listdir(self.folder.name) if name.startswith(".")], [])


if __name__ == "__main__":
    unittest.main()
