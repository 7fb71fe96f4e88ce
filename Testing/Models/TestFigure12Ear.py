#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""[TH03] Figure 12 a-e: an ear goes by naming one of its triangles, and nothing else moves.

  TestFigure12Ear.py FOLDER...

The paper names two, one for the ear and one for its stump; here both are one part.
"""

import unittest

import numpy

from medialaxis import arrays, vtkMedialPrune
from models import Model, corners, distances, field, find, history, main, t, triangulated, v

EAR = numpy.array([-48, -22, 110])  # millimetres; all of it, with its stump, is within RADIUS
RADIUS = 40


def distance_to_ear(points):
    return numpy.linalg.norm(points - EAR, axis=1)


def centres(axis):
    """The centres of the living triangles."""
    return corners(axis).mean(axis=1)


class Figure12Ear(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.head = Model(find("max_planck_closed_25044.ply"))
        cls.clean = cls.head.pruned(t(5), t(5), v(1), v(1))
        cls.edited = vtkMedialPrune()
        cls.edited.SetInputConnection(cls.clean.GetOutputPort())
        cls.edited.ClearIterations()
        # The tip: the triangle that is nearest to the sample farthest to this side.
        samples = arrays(cls.head.balls.GetInput())["points"]
        tip = samples[samples[:, 0].argmin()]
        axis = cls.clean.GetOutput()
        nearest = numpy.linalg.norm(centres(axis) - tip, axis=1).argmin()
        cls.edited.AddCellToRemove(axis.GetNumberOfCells() - axis.GetNumberOfPolys() + int(nearest))
        cls.edited.Update()

    def test_removes_one_part(self):
        rows = history(self.edited)
        self.assertEqual(rows["Removed"].tolist(), [1])
        self.assertEqual(rows["Betti"].tolist(), [[1, 0, 0]])

    def test_leaves_no_stump(self):
        self.assertLess(distance_to_ear(centres(self.clean.GetOutput())).min(), RADIUS)
        self.assertGreater(distance_to_ear(centres(self.edited.GetOutput())).min(), RADIUS)

    def test_moves_the_ear_and_nothing_else(self):
        before, after = (triangulated(self.head.surface(prune)) for prune in (self.clean, self.edited))
        spacing, = field(self.head.balls.GetOutput(), "SampleSpacing")
        for one, other in (before, after), (after, before):
            points = arrays(one)["points"]
            moved = distances(points, other) / spacing
            at_ear = distance_to_ear(points) < RADIUS
            print("moved, in spacings: ear %.2f, rest %.3f" % (moved[at_ear].max(), moved[~at_ear].max()))
            self.assertLess(moved[~at_ear].max(), 1)
            self.assertGreater(moved[at_ear].max(), 5)
        self.assertEqual(field(after, "BettiCrust"), [1, 0, 0])


if __name__ == "__main__":
    main()
