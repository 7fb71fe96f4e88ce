#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The enumeration of vtkMedialPrune and the table of measures in the core say the same."""

import re
import unittest

from medialaxis import vtkMedialPrune


def enumeration():
    """The constants of vtkMedialPrune::MeasureType by their numbers."""
    return {int(value): name for name, value in vars(vtkMedialPrune).items()
            if isinstance(value, vtkMedialPrune.MeasureType)}


def spoken(name):
    """TRIANGLE_COUNT for TriangleCount."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).upper()


class Measures(unittest.TestCase):
    def test_have_the_same_numbers(self):
        numbers = enumeration()
        self.assertGreater(len(numbers), 10)
        self.assertEqual(sorted(numbers), list(range(len(numbers))))
        for number, name in numbers.items():
            self.assertEqual(spoken(vtkMedialPrune.GetMeasureName(number)), name)
        for number in (-1, len(numbers)):
            self.assertIsNone(vtkMedialPrune.GetMeasureName(number))
            self.assertEqual(vtkMedialPrune.GetMeasureWord(number), "")

    def test_are_all_described(self):
        for number in enumeration():
            self.assertTrue(vtkMedialPrune.GetMeasureDescription(number))
            self.assertIn(vtkMedialPrune.GetMeasureUnit(number),
                          ("count", "share of the volume", "length", "area", "degrees"))
            self.assertRegex(vtkMedialPrune.GetMeasureWord(number), "^[a-z](N|P%|X)$")

    def test_make_the_words_of_a_schedule(self):
        prune = vtkMedialPrune()
        for number in enumeration():
            word = vtkMedialPrune.GetMeasureWord(number)
            prune.SetSchedule(word[0] + "2" + ("%" if word.endswith("%") else ""))
            self.assertEqual(prune.GetNumberOfIterations(), 1)
            self.assertEqual(prune.GetIterationMeasure(0), number)
            prune.ClearIterations()
            prune.AddIterationByName(vtkMedialPrune.GetMeasureName(number), 0.02)
            self.assertEqual(prune.GetIterationMeasure(0), number)


if __name__ == "__main__":
    unittest.main()
