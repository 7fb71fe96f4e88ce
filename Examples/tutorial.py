#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A tutorial for Python: points, a mesh and an image; parts as arrays; removing a part; thickness.

Editors and Jupyter (by jupytext) take each `# %%` as a cell. The tests run all of it.
"""

# %% Points on the boundary of a solid: of a ball with a small bump, as an array of shape (n, 3).
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

# %% Simplified by the default schedule, "noise", the solid has two parts: the ball and the bump. `result` has the four
# outputs of vtkSimplifyShape, and `arrays` shows any of them as numpy arrays without a copy. Parts are rows of the table;
# each cell of the axis has the number of its part.
result = simplify(points)
table, axis = arrays(result.table), arrays(result.axis)
for part in numpy.argsort(-table["RelativeVolume"]):
    cells = numpy.flatnonzero(axis["PartId"] == table["PartId"][part])
    print("part %d: %.1f %% of the volume, level %d, mean radius %.3f, %d cells" % (
        table["PartId"][part], 100 * table["RelativeVolume"][part], table["Level"][part],
        table["MeanRadius"][part], len(cells)))
assert len(table["PartId"]) == 2 and numpy.isclose(table["RelativeVolume"].sum(), 1)

# %% Is it right? The verdict compares the pieces, tunnels and voids of all stages; doubts tell what speaks against the
# points, and where.
print("certified:", result.verdict.certified, result.verdict.reasons)
for doubt in result.doubts:  # none here
    print(doubt.code, doubt.place, doubt.text)
assert result.verdict.certified and not result.doubts

# %% Without parts of at most a tenth of the volume the bump is gone. The surface is closed: points, and polygons as
# numbers of their corners.
ball = simplify(points, schedule=[("TriangleCount", 5), ("RelativeVolume", 0.1)])
surface = arrays(ball.surface)
corners, offsets = surface["corners"], surface["offsets"]
print("pieces, tunnels, voids: %s, volume: %.3f" % (surface["BettiCrust"][0], surface["Volume"][0]))
print("%d points, %d polygons, the first: %s" % (
    len(surface["points"]), len(offsets) - 1, corners[offsets[0]:offsets[1]]))
print("highest point: %.3f before, %.3f after" % (points[:, 2].max(), surface["points"][:, 2].max()))
assert surface["points"][:, 2].max() < points[:, 2].max() - 0.2

# %% A mesh, as any reader of VTK gives it (vtkSTLReader, vtkPLYReader ...). Its triangles are sampled, however few they
# are, and all results are compared with the solid that they bound. This one is a box of 12 triangles.
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource

cube, triangles = vtkCubeSource(), vtkTriangleFilter()
cube.SetXLength(4)
cube.SetYLength(2)
triangles.SetInputConnection(cube.GetOutputPort())
triangles.Update()
box = simplify(triangles.GetOutput(), "noise")
print("a box has %d parts: %s" % (len(arrays(box.table)["PartId"]), "certified" if box.verdict.certified else box.doubts))
assert box.verdict.certified and len(arrays(box.table)["PartId"]) == 13

# %% An image: a CT with `iso`, a label map with `label`, as a vtkImageData or an array of voxels [i, j, k]. This one
# holds a ring; its Betti numbers are 1 piece, 1 tunnel, 0 voids.
x, y, z = numpy.meshgrid(*[numpy.arange(-20, 21)] * 3, indexing="ij")
voxels = (numpy.hypot(numpy.hypot(x, y) - 12, z) < 5).astype(numpy.uint8)
ring = simplify(voxels, label=1, spacing=(0.5, 0.5, 0.5))  # in mm
print("pieces, tunnels, voids:", arrays(ring.surface)["BettiCrust"][0])
assert list(arrays(ring.surface)["BettiCrust"][0]) == [1, 1, 0]

# %% The filters behind `simplify`, one by one, give everything in between: the balls, the whole axis, what has gone.
from medialaxis import (
    vtkBoundarySamples, vtkLocalThickness, vtkMedialAxis, vtkMedialPartDecomposition, vtkMedialPrune,
    vtkPowerCrust)

samples, medial, noise, parts = vtkBoundarySamples(), vtkMedialAxis(), vtkMedialPrune(), vtkMedialPartDecomposition()
samples.SetInputConnection(triangles.GetOutputPort())
medial.SetInputConnection(samples.GetOutputPort(2))  # their balls
noise.SetInputConnection(medial.GetOutputPort())
parts.SetInputConnection(noise.GetOutputPort())
parts.Update()
whole = arrays(medial.GetOutput())
print("%d points, %d cells, radii %.3f ... %.3f" % (
    len(whole["points"]), len(whole["offsets"]) - 1, whole["Radius"].min(), whole["Radius"].max()))

# %% Removing a part by its number: of the twelve sheets that run into the edges of the box, the largest. (Tables are had by
# GetOutputDataObject(port).) A box with a rounded edge is left.
rows = arrays(parts.GetOutputDataObject(1))
sheet = max(range(len(rows["PartId"])), key=lambda row: (rows["Level"][row] == 1) * rows["RelativeVolume"][row])
print("part %d is %.1f %% of the volume" % (rows["PartId"][sheet], 100 * rows["RelativeVolume"][sheet]))
rounded, crust = vtkMedialPrune(), vtkPowerCrust()
rounded.SetInputConnection(parts.GetOutputPort())
rounded.ClearIterations()  # nothing else goes
rounded.AddPartToRemove(int(rows["PartId"][sheet]))
crust.SetInputConnection(samples.GetOutputPort(2))
crust.SetAxisConnection(rounded.GetOutputPort())
crust.Update()
solid = arrays(crust.GetOutput())
print("removed parts: %s, volume %.3f of 8, %s" % (
    arrays(rounded.GetOutputDataObject(1))["Removed"], solid["Volume"][0], solid["Verdict"][0]))
assert arrays(rounded.GetOutputDataObject(1))["Removed"][0] == 1
assert 7.5 < solid["Volume"][0] < 7.99

# %% Thickness: at each point of a surface, and its mean over the volume (Tb.Th of bone morphometry). The box is 1 thick.
thickness = vtkLocalThickness()
thickness.SetInputConnection(samples.GetOutputPort(2))
thickness.SetPlacesData(box.surface)
thickness.Update()
at_points, means = arrays(thickness.GetOutput(0))["Thickness"], arrays(thickness.GetOutputDataObject(1))
mean = means["Mean"][means["Weight"].index("volume")]
print("at the surface %.3f ... %.3f, mean over the volume %.3f" % (
    numpy.nanmin(at_points), numpy.nanmax(at_points), mean))
assert 0.8 < mean < 1.01

# %% pyvista: its PolyData is a vtkPolyData, so `simplify` takes it, and results become its own without a copy:
#
#     import pyvista
#     result = simplify(pyvista.read("part.stl"))
#     pyvista.wrap(result.surface).plot(scalars="PartId")
