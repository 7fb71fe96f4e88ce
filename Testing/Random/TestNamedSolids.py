#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random solids of seed 1 that once went wrong, and some that are at the limit.

  TestNamedSolids.py
"""

import collections
import unittest

from random_solids import run


class NamedSolids(unittest.TestCase):
    def outcomes(self, number):
        """The outcomes of a solid, of those that a run counts."""
        counts = collections.Counter()
        run(1, number, counts, None, False)
        return {key[1] for key in counts if key[0] in ("resolved", "coarse")}

    def test_these_were_wrong_and_are_right_and_certified(self):
        for number in (1166, 1407, 1693):
            with self.subTest(number):
                self.assertEqual(self.outcomes(number), {"right"})

    def test_these_are_right_though_doubted(self):
        for number in (1892, 2645, 2737, 3982, 3998, 5050, 5266):
            with self.subTest(number):
                self.assertLessEqual(self.outcomes(number), {"right", "right but not certified"})

    def test_what_these_samples_get_wrong_is_said(self):
        allowed = {"wrong but said", "right but not certified", "right", "fallback said", "balls put back"}
        for number in (15, 40, 44, 55):
            with self.subTest(number):
                self.assertLessEqual(self.outcomes(number), allowed)


if __name__ == "__main__":
    unittest.main()
