#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""By no measure does pruning change the Betti numbers; parts share the volume and the area.

  TestMeasures.py FOLDER|FILE...   all models (.ply, .off) of the folders; these models
"""

import os
import unittest

import numpy

from medialaxis import arrays, vtkMedialPartDecomposition, vtkMedialPrune
from models import PLACES, Model, areas, betti, field, history, main

ROUNDING = 1e-9


def paths():
    for place in PLACES:
        names = sorted(os.listdir(place)) if os.path.isdir(place) else [""]
        yield from (os.path.join(place, name).rstrip("/") for name in names
                    if (name or place).endswith((".ply", ".off")))


def thresholds(suggested, values):
    """The suggested one, else the median; and what takes nearly all parts of level 1."""
    small = suggested or numpy.median(values)
    large = max(4 * small, numpy.quantile(values, 0.95))
    return small, max(small, min(large, numpy.max(values)))  # a share above 1 is an error


class Measures(unittest.TestCase):
    def test_of_models(self):
        every = list(paths())
        self.assertTrue(every, "no models in %s" % PLACES)
        for path in every:
            with self.subTest(os.path.basename(path)):
                self.check(Model(path))

    def check(self, model):
        axis = model.axis.GetOutput()
        numbers = field(axis, "BettiAxis")
        self.assertEqual(betti(axis), numbers)
        self.assertEqual(field(axis, "Certificate"), [1])
        parts = vtkMedialPartDecomposition()
        parts.SetInputConnection(model.axis.GetOutputPort())
        parts.Update()
        table = arrays(parts.GetOutputDataObject(1))
        self.assertAlmostEqual(table["RelativeVolume"].sum(), 1, delta=ROUNDING)
        area = areas(axis).sum()
        self.assertAlmostEqual(table["Area"].sum(), area, delta=ROUNDING * area)
        outer = table["Level"] == 1
        outer |= not outer.any()  # a closed sheet has no border
        print("%d parts, Betti numbers %s" % (len(outer), numbers))
        for measure, suggested in enumerate(field(parts.GetOutput(), "SuggestedThreshold")):
            name = vtkMedialPrune.GetMeasureName(measure)
            with self.subTest(name):
                steps = thresholds(suggested, table[name][outer])
                self.check_pruning(model, measure, steps, numbers)

    def check_pruning(self, model, measure, steps, numbers):
        prune = model.pruned(*((measure, threshold) for threshold in steps))
        rows = history(prune)
        print("  %-18s %s parts" % (vtkMedialPrune.GetMeasureName(measure), rows["PartsAfter"]), flush=True)
        self.assertEqual(rows["Betti"].tolist(), [numbers, numbers])
        self.assertEqual(betti(prune.GetOutput()), numbers)


if __name__ == "__main__":
    main()
