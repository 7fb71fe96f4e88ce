# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of models share: models, the five filters, and measuring what comes out.

Measured by numpy and VTK alone, so that the tests don't believe the code that they test.
"""

import os
import sys
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance, vtkTriangleFilter
from vtkmodules.vtkIOPLY import vtkPLYReader

from medialaxis import arrays, vtkMedialAxis, vtkMedialPrune, vtkPolarBalls, vtkPowerCrust

PLACES = []  # the arguments: folders with models, or models


def main():
    """Runs the tests of the calling script."""
    PLACES.extend(sys.argv[1:])
    if not PLACES:
        sys.exit("usage: %s FOLDER..." % sys.argv[0])
    unittest.main(argv=sys.argv[:1])


def find(*names):
    """The path of the first of these files that is in a folder."""
    paths = [os.path.join(place, name) for name in names for place in PLACES]
    for path in paths:
        if os.path.isfile(path):
            return path
    raise FileNotFoundError("there is no " + " nor ".join(paths))


def bunny():
    """The path of the paper's bunny (34,835 points), or Debian's."""
    return find("bunny_34835.ply", "bunny00.off")


def read(path):
    """A file's points and, of a .ply, polygons."""
    os.stat(path)  # VTK's readers don't raise
    if path.endswith(".ply"):
        reader = vtkPLYReader()
        reader.SetFileName(path)
        reader.Update()
        return reader.GetOutput()
    with open(path) as file:
        rows = [row for row in (line.partition("#")[0].split() for line in file) if row]
    count = int(rows[1][0])  # .off: OFF; how many points, faces, edges; the points; the faces
    coordinates = numpy.array([row[:3] for row in rows[2:2 + count]], dtype=float)
    points, result = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(coordinates, deep=True))
    result.SetPoints(points)
    return result


def t(triangles):
    return vtkMedialPrune.TRIANGLE_COUNT, triangles


def v(percent):
    return vtkMedialPrune.RELATIVE_VOLUME, percent / 100


class Model:
    """A file's balls and medial axis, made once; and what becomes of them."""

    def __init__(self, path):
        self.balls, self.axis = vtkPolarBalls(), vtkMedialAxis()
        self.balls.SetInputData(read(path))
        self.axis.SetInputConnection(self.balls.GetOutputPort())
        self.axis.Update()

    def pruned(self, *schedule, **properties):
        """A filter that has pruned the axis, by iterations (measure, threshold)."""
        prune = vtkMedialPrune()
        prune.SetInputConnection(self.axis.GetOutputPort())
        prune.ClearIterations()
        for measure, threshold in schedule:
            prune.AddIteration(measure, threshold)
        for name, value in properties.items():
            getattr(prune, "Set" + name)(value)
        prune.Update()
        return prune

    def surface(self, prune=None):
        """The power crust of the pruned axis, or of the whole one."""
        crust = vtkPowerCrust()
        crust.SetInputConnection(self.balls.GetOutputPort())
        crust.SetAxisConnection((prune or self.axis).GetOutputPort())
        crust.Update()
        return crust.GetOutput()


def history(prune):
    return arrays(prune.GetOutputDataObject(1))


def field(data, name):
    return vtk_to_numpy(data.GetFieldData().GetArray(name)).ravel().tolist()


def cells(polys, corners):
    """The cells of a vtkCellArray that have so many corners, one a row."""
    offsets = vtk_to_numpy(polys.GetOffsetsArray())
    first = offsets[:-1][numpy.diff(offsets) == corners]
    points = vtk_to_numpy(polys.GetConnectivityArray()).astype(numpy.int64)
    return points[first[:, None] + numpy.arange(corners)]


def triangulated(surface):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    return triangles.GetOutput()


def corners(surface):
    """The places of its triangles' corners: an array of shape (n, 3, 3)."""
    return arrays(surface)["points"][cells(surface.GetPolys(), 3)]


def areas(surface):
    """The areas of its triangles."""
    a, b, c = corners(surface).transpose(1, 0, 2)
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2


def edges(triangles):
    """The ends of the three edges of each triangle: an array of shape (n, 3, 2)."""
    return triangles[:, [[0, 1], [1, 2], [2, 0]]]


def names(links):
    """A number for each pair of points, whichever comes first."""
    return links.min(axis=-1) << 32 | links.max(axis=-1)


def distances(points, surface):
    """From each of the points to a surface of triangles."""
    distance, result = vtkImplicitPolyDataDistance(), vtkDoubleArray()
    distance.SetInput(surface)
    distance.EvaluateFunction(numpy_to_vtk(points, deep=True), result)
    return numpy.abs(vtk_to_numpy(result))


def pieces(count, links):
    """Labels 0, 1, ... of `count` things: the same where links, rows of two things, connect them."""
    label = numpy.arange(count)
    while True:
        low = label.copy()
        for here, there in (links.T, links.T[::-1]):
            numpy.minimum.at(low, label[here], label[there])
        while (low[low] != low).any():
            low = low[low]
        low = low[label]
        if (low == label).all():
            return numpy.unique(label, return_inverse=True)[1]
        label = low


def at_edges(triangles):
    """The triangles, edge by edge; for each edge the first one's place, and how many it has."""
    edge, count = numpy.unique(names(edges(triangles)), return_inverse=True, return_counts=True)[1:]
    return numpy.argsort(edge.ravel(), kind="stable") // 3, numpy.cumsum(count) - count, count


def sheets(triangle, start, count):
    """Labels of the triangles: the same where edges with exactly two connect them."""
    pairs = start[count == 2]
    return pieces(len(triangle) // 3, triangle[numpy.stack([pairs, pairs + 1], axis=1)])


def betti(axis):
    """Pieces, tunnels and voids of the complex of an axis' cells, from their definition over Z/2."""
    vertices, lines, triangles = (cells(array, 1 + i) for i, array in enumerate(
        (axis.GetVerts(), axis.GetLines(), axis.GetPolys())))
    links = numpy.unique(names(numpy.concatenate([lines, edges(triangles).reshape(-1, 2)])))
    links = numpy.stack([links >> 32, links & 0xffffffff], axis=1)
    points, ends = numpy.unique(numpy.concatenate([links.ravel(), vertices.ravel()]),
                                return_inverse=True)
    b0 = len(set(pieces(len(points), ends[:links.size].reshape(-1, 2))))
    b2 = voids(triangles)
    return [b0, b0 + b2 - (len(points) - len(links) + len(triangles)), b2]


def voids(triangles):
    """The dimension of the space of those sets of triangles that have an even number at each edge.

    A triangle that is alone at an edge is in none, and of two both are in such a set or neither.
    So the unknowns are sheets, whose triangles go together, and the rest is linear algebra.
    """
    while True:
        triangle, start, count = at_edges(triangles)
        sheet = sheets(triangle, start, count)
        bounded = numpy.isin(sheet, sheet[triangle[start[count == 1]]])
        if not bounded.any():
            break
        triangles = triangles[~bounded]
    rows = []
    for first, size in zip(start[count > 2], count[count > 2]):
        row = 0
        for one in sheet[triangle[first:first + size]]:
            row ^= 1 << int(one)
        rows.append(row)
    return len(set(sheet)) - rank(set(rows))


def rank(rows):
    """Of a matrix over Z/2 whose rows are the bits of integers."""
    pivots = {}
    for row in rows:
        while row:
            top = row.bit_length()
            if top not in pivots:
                pivots[top] = row
                break
            row ^= pivots[top]
    return len(pivots)
