#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that each rule of check_style.sh finds what breaks it.

A small tree that keeps all rules is made in a temporary folder. Each test breaks one rule in it and expects
exactly the lines that name the place.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parent.parent
LICENCE = "// SPDX-License-Identifier: BSD-3-Clause\n"

sys.path.insert(0, str(TOP / ".ci"))
from draw_stages import FLOW  # the filters and arrays that the picture names

STAGES = ["Base", *FLOW]


def header(*included):
    return LICENCE + "".join('#include "%s"\n' % name for name in included)


def function(name, lines):
    return "void %s()\n{\n%s}\n" % (name, "  again();\n" * (lines - 3))


class StyleCheck(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.top = pathlib.Path(self.folder.name)
        shutil.copytree(TOP / ".ci", self.top / ".ci", ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copy(TOP / ".clang-format", self.top)
        for name in ("Examples", "ParaView", "Testing/Core"):
            (self.top / name).mkdir(parents=True)
        self.write("Filters/Core/CMakeLists.txt", "foreach (stage IN ITEMS %s)\n" % " ".join(STAGES))
        for stage in STAGES:
            self.write("Filters/Core/%s/One%s.h" % (stage, stage), header())
            self.write("Filters/Core/%s/One%s.cxx" % (stage, stage), header("%s/One%s.h" % (stage, stage)))
            self.write("Filters/Core/%s/CMakeLists.txt" % stage, "One%s.cxx\n" % stage)
            self.write("Filters/Core/%s/README.md" % stage, "`One%s` does one thing.\n" % stage)
        names = sorted({name for stage in FLOW.values() for name in stage.arrays})
        self.write("Filters/Conversion/ArrayNames.h", LICENCE + "".join('// "%s"\n' % name for name in names))
        for stage in FLOW.values():
            self.write("Filters/%s.h" % stage.filter, header())
            self.write("Filters/%s.cxx" % stage.filter, header(stage.filter + ".h"))
        self.draw()

    def tearDown(self):
        self.folder.cleanup()

    def write(self, path, text):
        file = self.top / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def draw(self):
        subprocess.run(["/usr/bin/python3", str(self.top / ".ci/draw_stages.py")], check=True)

    def expect(self, rule, *lines):
        """The check fails with this rule and these lines and with nothing else."""
        run = subprocess.run([str(self.top / ".ci/check_style.sh")], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual(run.stdout.splitlines(), ["Broken rule: " + rule, *lines])
        self.assertEqual(run.returncode, 1)

    def test_the_small_tree_keeps_all_rules(self):
        run = subprocess.run([str(self.top / ".ci/check_style.sh")], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual(run.stdout, "")
        self.assertEqual(run.returncode, 0)

    def test_a_later_stage_is_included(self):
        self.write("Filters/Core/Balls/OneBalls.cxx", header("Balls/OneBalls.h", "Crust/OneCrust.h"))
        self.draw()
        self.expect("a stage of the core includes only itself and stages before it",
                    'Filters/Core/Balls/OneBalls.cxx:3: #include "Crust/OneCrust.h"  '
                    "(Balls comes before Crust)")

    def test_the_order_is_that_of_the_list(self):
        swapped = ["Balls"] + [stage for stage in STAGES if stage != "Balls"]
        self.write("Filters/Core/CMakeLists.txt", "foreach (stage IN ITEMS %s)\n" % " ".join(swapped))
        self.write("Filters/Core/Balls/OneBalls.h", header("Base/OneBase.h"))
        run = subprocess.run([str(self.top / ".ci/check_includes.py"), "stages"], stdout=subprocess.PIPE,
                             universal_newlines=True)
        self.assertEqual(run.stdout, 'Filters/Core/Balls/OneBalls.h:2: #include "Base/OneBase.h"  '
                                     "(Balls comes before Base)\n")

    def test_the_core_includes_what_is_outside(self):
        self.write("Filters/Core/Base/OneBase.h", header("Conversion/ArrayNames.h"))
        self.expect("a stage of the core includes only itself and stages before it",
                    'Filters/Core/Base/OneBase.h:2: #include "Conversion/ArrayNames.h"  '
                    "(the core includes nothing outside Filters/Core)")

    def test_a_source_of_the_core_has_no_header(self):
        self.write("Filters/Core/Base/Alone.cxx", LICENCE)
        self.write("Filters/Core/Base/CMakeLists.txt", "OneBase.cxx\nAlone.cxx\n")
        self.write("Filters/Core/Base/README.md", "`OneBase`, `Alone`\n")
        self.draw()
        self.expect("a stage of the core includes only itself and stages before it",
                    "Filters/Core/Base/Alone.cxx has no header of its name: nothing tells who uses it")

    def test_includes_form_a_circle(self):
        self.write("Filters/Pipeline/A.h", header("Pipeline/B.h"))
        self.write("Filters/Pipeline/B.h", header())
        self.write("Filters/Pipeline/B.cxx", header("B.h", "Pipeline/C.h"))
        self.write("Filters/Pipeline/C.h", header("A.h"))
        self.expect("includes form no circle",
                    "Filters/Pipeline/A -> Filters/Pipeline/B -> Filters/Pipeline/C -> Filters/Pipeline/A",
                    '  Filters/Pipeline/A.h:2: #include "Pipeline/B.h"',
                    '  Filters/Pipeline/B.cxx:3: #include "Pipeline/C.h"',
                    '  Filters/Pipeline/C.h:2: #include "A.h"')

    def test_a_list_leaves_out_a_file(self):
        self.write("Filters/Core/Axis/OneAxisMore.h", header())
        self.write("Filters/Core/Axis/OneAxisMore.cxx", header())
        self.write("Filters/Core/Axis/README.md", "`OneAxis`, and `Gone.h`, which was deleted.\n")
        self.draw()
        self.expect("README.md and CMakeLists.txt of a stage name all that is in its folder",
                    "Filters/Core/Axis/README.md doesn't name OneAxisMore",
                    "Filters/Core/Axis/README.md names Gone.h, which isn't there",
                    "Filters/Core/Axis/CMakeLists.txt doesn't name OneAxisMore.cxx")

    def test_a_readme_is_missing(self):
        (self.top / "Filters/Core/Axis/README.md").unlink()
        self.expect("README.md and CMakeLists.txt of a stage name all that is in its folder",
                    "Filters/Core/Axis/README.md is missing")

    def test_a_folder_is_no_stage(self):
        self.write("Filters/Core/Attic/README.md", "")
        self.expect("README.md and CMakeLists.txt of a stage name all that is in its folder",
                    "Filters/Core/Attic is not in the list of stages in Filters/Core/CMakeLists.txt")

    def test_a_warning_is_missing_in_the_table(self):
        self.write("Filters/README.md", "| code | | what |\n|---|---|---|\n| `gone` | | a |\n| `told` | | b |\n")
        self.write("Filters/Core/Axis/OneAxis.cxx", header("Axis/OneAxis.h", "Base/OneBase.h") +
                   'Warnings a{ { "told", "A." } };\nWarning b{ "one_more", "B." };\n'
                   'Warning c;\nvoid d()\n{\n  c.code = "last";\n}\n')
        self.draw()
        self.expect("the table of Filters/README.md has all codes of warnings",
                    "Filters/Core/Axis/OneAxis.cxx: Filters/README.md has no row for the warning last",
                    "Filters/Core/Axis/OneAxis.cxx: Filters/README.md has no row for the warning one_more",
                    "Filters/README.md: nothing warns of gone")

    def test_the_picture_is_out_of_date(self):
        self.write("Filters/Core/Parts/OneParts.h", header("Balls/OneBalls.h"))
        self.expect("Filters/stages.svg is what .ci/draw_stages.py draws",
                    "Filters/stages.svg is out of date: run .ci/draw_stages.py")

    def test_a_function_is_long(self):
        self.write("Testing/Long.cxx", LICENCE + function("fits", 60) + "\n" + function("longer", 61))
        self.expect("a function has at most 60 lines", "Testing/Long.cxx:63: longer has 61 lines")

    def test_a_class_is_long(self):
        members = "  int a;\n"
        self.write("Examples/Fits.h", LICENCE + "class Fits\n{\n%s};\n" % (members * 197))
        self.write("Examples/Explained.h",
                   LICENCE + "class Explained\n{\n%s%s};\n" % ("  /// a\n" * 90, members * 190))
        self.write("Examples/Long.cxx", LICENCE + "namespace\n{\nstruct Long\n{\n%s};\n}\n" % (members * 198))
        self.expect("a class has at most 200 lines without comments",
                    "Examples/Long.cxx:4: Long has 201 lines")

    def test_a_file_is_long(self):
        self.write("ParaView/Fits.h", LICENCE + "//\n" * 399)
        self.write("ParaView/Long.h", LICENCE + "//\n" * 400)
        self.expect("a file has at most 400 lines", "ParaView/Long.h has 401 lines")

    def test_cgal_is_in_a_header(self):
        self.write("Filters/Core/Base/OneBase.cxx", LICENCE + "#include <CGAL/Origin.h>\n")
        self.write("Filters/Core/Base/OneBase.h", LICENCE + "#include <CGAL/Origin.h>\n")
        self.expect("CGAL is included by Filters/Core/*.cxx and Testing/Benchmark/Floor.cxx alone",
                    "Filters/Core/Base/OneBase.h:2:#include <CGAL/Origin.h>")

    def test_the_core_knows_vtk(self):
        self.write("Filters/Core/Base/OneBase.h", LICENCE + '#include "vtkType.h"\n')
        self.expect("the core knows no VTK", 'Filters/Core/Base/OneBase.h:2:#include "vtkType.h"')

    def test_a_filter_has_a_loop(self):
        self.write("Filters/vtkLoop.cxx", LICENCE + "void f()\n{\n  while (true)\n  {\n  }\n}\n")
        self.expect("filters contain no loops; they belong in Conversion or the core",
                    "Filters/vtkLoop.cxx:4:  while (true)")

    def test_a_letter_is_not_ascii(self):
        self.write("Testing/Letter.h", LICENCE + "// \u00e9\n")
        self.expect("sources are ASCII", "Testing/Letter.h:2:// \u00e9")

    def test_the_licence_is_missing(self):
        self.write("Testing/Free.h", "// nothing\n")
        self.expect("a source begins with its licence", "Testing/Free.h")

    @unittest.skipUnless(shutil.which("clang-format-14"), "no clang-format-14 here")
    def test_the_format_is_wrong(self):
        self.write("Testing/Format.h", LICENCE + "int  two;\n")
        self.expect("sources are formatted by clang-format 14",
                    "Testing/Format.h: run clang-format-14 -i Testing/Format.h")


if __name__ == "__main__":
    unittest.main()
