#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The title picture of [TH03]: the bunny without its ears.

  TestTitle.py FOLDER...
"""

import unittest

from medialaxis import arrays
from models import Model, bunny, cells, edges, field, main, pieces, t, triangulated, v

HEAD = 0.84  # of the bunny's height; only the ears reach higher


class Title(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bunny = Model(bunny())

    def ears(self, surface):
        """How many pieces of the surface are higher than the head."""
        height = arrays(self.bunny.balls.GetInput())["points"][:, 1]
        limit = (1 - HEAD) * height.min() + HEAD * height.max()
        triangles = cells(triangulated(surface).GetPolys(), 3)
        above = arrays(surface)["points"][:, 1] > limit
        links = edges(triangles[above[triangles].all(axis=1)]).reshape(-1, 2)
        return len(set(pieces(len(above), links)[links.ravel()]))

    def test_pruned_weakly_has_both_ears(self):
        surface = self.bunny.surface(self.bunny.pruned(t(5), t(5), v(1)))
        self.assertEqual(self.ears(surface), 2)
        self.assertEqual(field(surface, "BettiCrust"), [1, 0, 0])

    def test_pruned_strongly_has_none(self):
        surface = self.bunny.surface(self.bunny.pruned(t(5), t(5), v(20)))
        self.assertEqual(self.ears(surface), 0)
        self.assertEqual(field(surface, "BettiCrust"), [1, 0, 0])
        self.assertEqual(field(surface, "Closed"), [1])


if __name__ == "__main__":
    main()
