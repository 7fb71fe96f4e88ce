#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""morphometry: a dict for each of many objects."""

import math
import unittest

import numpy

from medialaxis import MedialAxisWarning, morphometry
from vtkmodules.vtkFiltersSources import vtkCubeSource


def ellipsoid(axes, count=900):
    """Points spread over an ellipsoid along a spiral."""
    i = numpy.arange(count)
    z = 1 - (2 * i + 1) / count
    turn = numpy.pi * (3 - numpy.sqrt(5)) * i
    around = numpy.sqrt(1 - z * z)
    return numpy.stack([around * numpy.cos(turn), around * numpy.sin(turn), z], axis=1) * axes


class Morphometry(unittest.TestCase):
    def test_rows_of_known_solids(self):
        axes = [(1, 1, 1), (3, 2, 1), (1, 1, 2)]
        rows = morphometry((ellipsoid(one) for one in axes), names=["a", "b", "c"], unit="mm", schedule="")
        self.assertEqual([(row["Name"], row["Unit"], row["Error"]) for row in rows],
                         [(name, "mm", "") for name in "abc"])
        for row, (a, b, c) in zip(rows, axes):
            self.assertEqual(list(row), list(rows[0]))
            self.assertAlmostEqual(row["BV"] / (4 / 3 * math.pi * a * b * c), 1, delta=0.02)
            self.assertAlmostEqual(row["TV"] / (8 * a * b * c), 1, delta=0.02)
            self.assertAlmostEqual(row["DA"], 1 - (min(a, b, c) / max(a, b, c))**2, delta=0.02)
            self.assertEqual([row["Betti:%d" % i] for i in range(3)], [1, 0, 0])
            self.assertEqual((row["Euler"], row["Conn.D"], row["Verdict"]), (1, 0, "certified"))
            self.assertTrue(math.isnan(row["BettiSolid:0"]))

    def test_mesh_in_bounds(self):
        cube = vtkCubeSource()
        cube.SetXLength(2)
        cube.Update()
        row, = morphometry([cube.GetOutput()], bounds=(0, 2, -1, 1, -1, 1), schedule="")
        self.assertEqual(row["Name"], "0")
        self.assertAlmostEqual(row["TV"], 8)
        self.assertAlmostEqual(row["BV"], 1, delta=0.02)
        self.assertAlmostEqual(row["Euler.VOI"], 0.5, delta=0.01)
        self.assertEqual(row["BettiSolid:0"], 1)

    def test_what_fails_has_a_reason(self):
        good = ellipsoid((1, 1, 2))
        rows = morphometry([good, good[:2], numpy.zeros((5, 2)), good], margin=0.25)
        self.assertEqual([bool(row["Error"]) for row in rows], [False, True, True, False])
        self.assertTrue(math.isnan(rows[1]["BV"]))
        self.assertIn("shape", rows[2]["Error"])
        row, = morphometry([good], margin=5)
        self.assertIn("smaller margin", row["Error"])

    def test_doubts_tell_the_object(self):
        points = numpy.random.default_rng(1).random((300, 3))  # of a volume
        with self.assertWarnsRegex(MedialAxisWarning, "^cloud: "):
            morphometry([points], names=["cloud"])


if __name__ == "__main__":
    unittest.main()
