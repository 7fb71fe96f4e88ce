#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""simplify with arrays of voxels."""

import unittest

import numpy

from medialaxis import arrays, simplify


def ring(label=3):
    """Voxels of a torus around the third axis, longer than wide."""
    x, y, z = numpy.meshgrid(*(numpy.linspace(-1, 1, n) for n in (32, 28, 16)), indexing="ij")
    inside = (numpy.hypot(x, y) - 0.55) ** 2 + (0.6 * z) ** 2 < 0.09
    return (label * inside).astype(numpy.int16)


class SimplifyImages(unittest.TestCase):
    def test_an_array_of_voxels_is_an_image(self):
        result = simplify(ring(), spacing=(0.5, 0.5, 1), origin=(100, 0, 0))
        self.assertTrue(result.verdict.certified, result.verdict.reasons)
        self.assertEqual(arrays(result.surface)["BettiCrust"].tolist(), [[1, 1, 0]])
        self.assertEqual(arrays(result.surface)["BettiSegmentation"].tolist(), [[1, 1, 0]])
        points = arrays(result.surface)["points"]
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        numpy.testing.assert_allclose(middle, [100 + 31 / 4, 27 / 4, 7.5], atol=0.3)

    def test_order_in_memory_and_type_make_no_difference(self):
        expected = arrays(simplify(ring(), label=3).surface)["points"]
        for voxels, label in ((numpy.asfortranarray(ring().astype(float)), 3), (ring() > 0, 1)):
            found = arrays(simplify(voxels, label=label).surface)["points"]
            numpy.testing.assert_array_equal(found, expected)

    def test_says_what_the_image_has(self):
        voxels = ring()
        voxels[:, :14] *= 2
        with self.assertRaisesRegex(ValueError, "the labels are 0, 3, 6: choose a label"):
            simplify(voxels)
        with self.assertRaisesRegex(ValueError, "no voxel has the label 4"):
            simplify(voxels, label=4)
        self.assertEqual(arrays(simplify(voxels, iso=3).surface)["BettiCrust"].tolist(), [[1, 1, 0]])

    def test_refuses_what_contradicts_itself(self):
        with self.assertRaisesRegex(ValueError, "not both"):
            simplify(ring(), iso=1, label=3)
        with self.assertRaisesRegex(ValueError, "for images"):
            simplify(numpy.eye(3), iso=1)
        with self.assertRaisesRegex(ValueError, "numbers"):
            simplify(numpy.zeros((3, 3, 3), dtype=complex))


if __name__ == "__main__":
    unittest.main()
