#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""[TH03] Figure 10: how many parts of a bunny each iteration leaves.

  TestFigure10.py FOLDER...
"""

import unittest

import numpy

from models import Model, bunny, history, main, t, v


class Figure10(unittest.TestCase):
    def test_triangle_counts_remove_much_and_then_hardly_any(self):
        rows = history(Model(bunny()).pruned(t(5), t(5), t(5), v(1)))
        parts = numpy.append(rows["PartsBefore"][0], rows["PartsAfter"])
        print("parts:", *parts)
        self.assertEqual(rows["PartsBefore"].tolist(), parts[:-1].tolist())
        first, second, third, volume = parts[:-1] - parts[1:]
        self.assertGreater(first, parts[0] / 2)
        self.assertLess(second, first / 100)
        self.assertLess(third, first / 100)
        self.assertGreater(volume, parts[3] / 2)


if __name__ == "__main__":
    main()
