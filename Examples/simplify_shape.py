#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Simplify a shape in numpy. Editors and Jupyter (by jupytext) take each `# %%` as a cell."""

# %% Points on the boundary of a solid, here of a ball with a small bump.
import numpy

from medialaxis import arrays, simplify

count = 3000
index = numpy.arange(count)
height = 1 - (2 * index + 1) / count
turn = numpy.pi * (3 - numpy.sqrt(5)) * index
around = numpy.sqrt(1 - height**2)
directions = numpy.stack([around * numpy.cos(turn), around * numpy.sin(turn), height], axis=1)
bump = 0.35 * numpy.exp(-(numpy.arccos(height) / 0.25)**2)
points = directions * (1 + bump)[:, None] * [1.6, 1.2, 1.0]

# %% Remove parts of at most 5 triangles, then those of at most a twentieth of the volume.
result = simplify(points, schedule=[("TriangleCount", 5), ("RelativeVolume", 0.05)])

# %% The parts that are left, the most voluminous first.
table = arrays(result.table)
for part in numpy.argsort(-table["RelativeVolume"]):
    print("part %d: %.1f %% of the volume, level %d, mean radius %.3f" % (
        table["PartId"][part], 100 * table["RelativeVolume"][part], table["Level"][part],
        table["MeanRadius"][part]))

# %% The surface: closed, with the points and polygons as arrays.
surface = arrays(result.surface)
print("certified: %s %s" % (result.verdict.certified, "; ".join(result.verdict.reasons)))
print("closed: %d, pieces, tunnels, voids: %s, volume: %.3f" % (
    surface["Closed"][0], surface["BettiCrust"][0], surface["Volume"][0]))
corners, offsets = surface["corners"], surface["offsets"]
print("%d points, %d polygons, the first: %s" % (
    len(surface["points"]), len(offsets) - 1, corners[offsets[0]:offsets[1]]))
top = surface["points"][:, 2].max()
print("highest point: %.3f before, %.3f after" % (points[:, 2].max(), top))
