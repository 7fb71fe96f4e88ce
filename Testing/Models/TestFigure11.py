#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""[TH03] Figure 11: noise on a back and a leg goes, the animal stays.

  TestFigure11.py FOLDER...
"""

import unittest

import numpy

from medialaxis import arrays
from models import Model, areas, corners, distances, find, history, main, read, triangulated


class Figure11(unittest.TestCase):
    def test_automatically_takes_the_noise(self):
        clean = read(find("koala_49999.ply"))
        ends = corners(clean)
        spacing = numpy.median(numpy.linalg.norm(ends - numpy.roll(ends, 1, axis=1), axis=2))
        noisy = Model(find("koala_noisy_48668_points.ply"))
        prune = noisy.pruned(Automatic=True)
        rows = history(prune)
        before, after = rows["PartsBefore"][0], rows["PartsAfter"][-1]
        surface = triangulated(noisy.surface(prune))
        near = distances(corners(surface).mean(axis=1), clean) < 2 * spacing
        share = areas(surface)[near].sum() / areas(surface).sum()
        samples = distances(arrays(noisy.balls.GetInput())["points"], clean) < 2 * spacing
        print("parts: %d, then %d; within 2 spacings of %.4g: %.2f %% of the surface, %.2f %% of the "
              "samples" % (before, after, spacing, 100 * share, 100 * samples.mean()))
        self.assertLessEqual(after, 0.1 * before)
        self.assertGreaterEqual(share, 0.99)


if __name__ == "__main__":
    main()
