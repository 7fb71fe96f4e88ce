#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""[TH03] Figure 5: the axis of a box has a part for each of the twelve edges, and one within.

  TestFigure5.py FOLDER...
"""

import unittest

import numpy

from medialaxis import arrays
from models import Model, at_edges, betti, cells, field, find, history, main, sheets, t


class Figure5(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.box = Model(find("box.ply"))
        cls.clean = cls.box.pruned(t(5))
        cls.axis = cls.clean.GetOutput()
        cls.triangles = cells(cls.axis.GetPolys(), 3)

    def test_twelve_parts_at_the_border_and_one_within(self):
        rows = history(self.clean)
        print("parts: %d, then %d" % (rows["PartsBefore"][0], rows["PartsAfter"][0]))
        part, first = numpy.unique(arrays(self.axis)["PartId"], return_index=True)
        self.assertEqual(part.tolist(), list(range(13)))
        self.assertEqual(sorted(arrays(self.axis)["PartLevel"][first]), 12 * [1] + [2])

    def test_counted_anew_they_are_the_same(self):
        self.assertEqual(len(self.triangles), self.axis.GetNumberOfCells())
        triangle, start, count = at_edges(self.triangles)
        sheet = sheets(triangle, start, count)
        level = numpy.where(numpy.isin(sheet, sheet[triangle[start[count == 1]]]), 1, 2)
        rows = numpy.unique(numpy.stack([sheet, level], axis=1), axis=0)
        self.assertEqual(sorted(rows[:, 1]), 12 * [1] + [2])
        ours = arrays(self.axis)
        self.assertEqual(len(set(zip(sheet, ours["PartId"]))), 13)
        self.assertEqual(level.tolist(), ours["PartLevel"].tolist())

    def test_the_topology_is_a_balls(self):
        self.assertEqual(field(self.box.axis.GetOutput(), "BettiAxis"), [1, 0, 0])
        self.assertEqual(betti(self.axis), [1, 0, 0])


if __name__ == "__main__":
    main()
