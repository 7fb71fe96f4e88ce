#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""simplify and arrays: from numpy to numpy; errors; stubs."""

import ast
import os
import subprocess
import sys
import unittest

import numpy

import medialaxis
from medialaxis import arrays, simplify
from vtkmodules.vtkCommonDataModel import vtkPolyData


def ellipsoid(count=800):
    """Points spread over an ellipsoid along a spiral."""
    i = numpy.arange(count)
    z = 1 - (2 * i + 1) / count
    turn = numpy.pi * (3 - numpy.sqrt(5)) * i
    around = numpy.sqrt(1 - z * z)
    return numpy.stack([3 * around * numpy.cos(turn), 2 * around * numpy.sin(turn), z], axis=1)


class Simplify(unittest.TestCase):
    def test_goes_from_numpy_to_numpy(self):
        result = simplify(ellipsoid(), schedule=[("TriangleCount", 5), ("RelativeVolume", 0.01, 1)])
        surface = arrays(result.surface)
        self.assertEqual(surface["Closed"][0], 1)
        self.assertEqual(surface["BettiCrust"].tolist(), [[1, 0, 0]])
        self.assertEqual(surface["points"].shape[1], 3)
        self.assertEqual(surface["corners"].max(), len(surface["points"]) - 1)
        self.assertEqual(surface["offsets"][-1], len(surface["corners"]))
        self.assertEqual(len(surface["PartId"]), len(surface["offsets"]) - 1)
        table = arrays(result.table)
        self.assertAlmostEqual(table["RelativeVolume"].sum(), 1)
        self.assertEqual(len(table["PartId"]), arrays(result.axis)["NumberOfParts"][0])
        self.assertEqual(arrays(result.history)["Threshold"].tolist(), [5, 0.01])

    def test_takes_lists_and_the_default_schedule(self):
        listed = simplify(ellipsoid(400).tolist())
        self.assertEqual(arrays(listed.history)["Threshold"].tolist(), [5, 5, 0.01])

    def test_takes_a_schedule_in_words(self):
        words = simplify(ellipsoid(400), "t5 v1%")
        listed = simplify(ellipsoid(400), [("TriangleCount", 5), ("RelativeVolume", 0.01)])
        self.assertEqual(arrays(words.history)["Word"], ["t5", "v1%"])
        for output in ("surface", "axis"):
            numpy.testing.assert_array_equal(arrays(getattr(words, output))["points"],
                                             arrays(getattr(listed, output))["points"])
        self.assertEqual(arrays(words.history)["Threshold"].tolist(),
                         arrays(listed.history)["Threshold"].tolist())
        with self.assertRaisesRegex(ValueError, "word 2 of the schedule, 'x3'"):
            simplify(ellipsoid(400), "t5 x3")

    def test_says_what_is_wrong(self):
        with self.assertRaisesRegex(ValueError, "shape"):
            simplify(ellipsoid().T)
        with self.assertRaisesRegex(ValueError, "points"):
            simplify(numpy.zeros((3, 3)))
        with self.assertRaisesRegex(ValueError, "no measure 'Beauty'"):
            simplify(ellipsoid(), [("Beauty", 1)])
        with self.assertRaisesRegex(ValueError, "threshold"):
            simplify(ellipsoid(), [("Area", -1)])

    def test_raises_the_plain_message_and_prints_nothing(self):
        program = ("import numpy; from medialaxis import simplify\n"
                   "points = numpy.random.default_rng(1).normal(size=(300, 3))\n"
                   "for arguments in [(points[:3],), (points, [('Beauty', 1)]), (points, [('Area', -1)])]:\n"
                   "    try: simplify(*arguments)\n"
                   "    except ValueError as error: print(error)\n")
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual(done.stderr, "")
        messages = done.stdout.splitlines()
        self.assertEqual(len(messages), 3, done.stdout)
        for message, word in zip(messages, ("points", "there is no measure 'Beauty'", "threshold")):
            self.assertIn(word, message)
            self.assertNotRegex(message, r"ERROR|line \d|\(0x")

    def test_filter_tells_its_error(self):
        filter = medialaxis.vtkSimplifyShape()
        self.assertEqual(filter.GetErrorMessage(), "")
        for sender in (filter, filter.GetExecutive()):
            sender.AddObserver("ErrorEvent", lambda *_: None)
        filter.SetInputData(vtkPolyData())
        filter.Update()
        self.assertIn("points", filter.GetErrorMessage())

    def test_has_a_stub_for_each_filter(self):
        folder = os.path.dirname(medialaxis.__file__)
        with open(os.path.join(folder, "vtkFiltersMedial.pyi")) as file:
            stub = ast.parse(file.read())
        methods = {item.name: [member.name for member in item.body if isinstance(member, ast.FunctionDef)]
                   for item in stub.body if isinstance(item, ast.ClassDef)}
        filters = [name for name in dir(medialaxis) if name.startswith("vtk")
                   and isinstance(getattr(medialaxis, name), type)]
        self.assertEqual(sorted(methods), sorted(filters))
        self.assertIn("AddIterationByName", methods["vtkMedialPrune"])
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))


if __name__ == "__main__":
    unittest.main()
