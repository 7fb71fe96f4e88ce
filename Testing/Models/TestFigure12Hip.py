#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""[TH03] Figure 12 f-i: hip bones keep their narrow arch, around the only tunnel.

  TestFigure12Hip.py FOLDER...

With NONE the paper's schedule leaves the arch, too: it is of one part with the blade, which has more
than 5 % of the volume. A threshold above every part shows that the rule is what keeps it.
"""

import unittest

from medialaxis import vtkMedialPrune
from models import Model, betti, field, find, history, main, t, v

ARCH = [1, 1, 0]
ALL = (vtkMedialPrune.MAXIMUM_RADIUS, 1e9)  # millimetres


class Figure12Hip(unittest.TestCase):
    def check(self, name):
        hip = Model(find(name))
        prune = hip.pruned(t(5), t(5), t(5), v(5), v(5), v(5))
        rows = history(prune)
        print("parts: %d, then %s" % (rows["PartsBefore"][0], rows["PartsAfter"]))
        self.assertEqual(field(hip.axis.GetOutput(), "BettiAxis"), ARCH)
        self.assertEqual(rows["Betti"].tolist(), 6 * [ARCH])
        self.assertEqual(betti(prune.GetOutput()), ARCH)
        self.assertEqual(field(hip.surface(prune), "BettiCrust"), ARCH)
        for topology, last in (vtkMedialPrune.COLLAPSE, ARCH), (vtkMedialPrune.NONE, [1, 0, 0]):
            prune = hip.pruned(t(5), t(5), ALL, Topology=topology)
            self.assertEqual(history(prune)["Betti"].tolist(), [ARCH, ARCH, last])
            self.assertEqual(betti(prune.GetOutput()), last)

    def test_smooth(self):
        self.check("hip_bone_vh_70688_points.ply")

    def test_rough(self):
        self.check("hip_bone_jia_67030.ply")


if __name__ == "__main__":
    main()
