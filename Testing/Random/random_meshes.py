#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random closed meshes, whose topology is known, go through the whole chain with default options.

  random_meshes.py [--seed S] [--first I] [--count N] [--seconds T] [--save DIR]

Mesh I of seed S is of one of these kinds, turned, moved and in any unit, some inside out, some in single
precision:

  plate    a polygon with up to 20 holes, as thick as one likes; with needles of triangles
  blocks   boxes of a grid, united and cut out, with walls and gaps down to 1 % of the diagonal
  nested   boxes in boxes, with walls and gaps down to 1 %; some have a window
  turned   a tube with thin walls, closed to a ring or not
  smooth   balls, boxes and tori, united by Flying Edges, some with a bubble
  frame    struts between some corners of a grid, with up to 20 tunnels

A quarter of the first four are two solids with a narrow gap between them. The Betti numbers are those of the
mesh itself: of its Euler characteristic and of the volumes of its pieces. A smooth mesh is left out if
growing or shrinking it by half a percent of the diagonal changes them.

The outcomes are those of random_solids.py; a mesh always shows its solid, so that "right" is what should be.
The exit code is 1 after an error, after a mesh that is wrong and certified, and after a fallback unsaid.
"""

import itertools
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOPLY import vtkPLYWriter

from random_solids import (FAILURES, HALF, Solid, betti_of_mesh, cloud_of, mesh_below, outcomes_of, parser_of,
                           rotation, simplified, try_all)

NARROWEST = 0.01  # wall or gap, of the diagonal
GENUS = 20  # at most


class Mesh:
    """Points, and triangles that are counter-clockwise seen from outside."""

    def __init__(self, points, triangles):
        self.points = numpy.asarray(points, float)
        self.triangles = numpy.asarray(triangles, int)

    def diagonal(self):
        return numpy.linalg.norm(numpy.ptp(self.points, axis=0))

    def united(self, other):
        return Mesh(numpy.concatenate([self.points, other.points]),
                    numpy.concatenate([self.triangles, other.triangles + len(self.points)]))

    def polydata(self):
        result = cloud_of(self.points)
        result.SetPolys(cells_of(self.triangles.ravel(), 3 * numpy.arange(len(self.triangles) + 1)))
        return result


def cells_of(corners, offsets):
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(numpy.asarray(offsets, numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.asarray(corners, numpy.int64), deep=True))
    return cells


def mesh_of(polydata):
    corners = vtk_to_numpy(polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return Mesh(vtk_to_numpy(polydata.GetPoints().GetData()), corners)


def log_uniform(random, low, high):
    return numpy.exp(random.uniform(numpy.log(low), numpy.log(high)))


def quads(a, b, c, d):
    """Two triangles for each polygon with these corners."""
    return numpy.concatenate([numpy.stack([a, b, c], axis=-1).reshape(-1, 3),
                              numpy.stack([a, c, d], axis=-1).reshape(-1, 3)])


def circle(center, radius, corners, turn):
    angle = turn + 2 * numpy.pi * numpy.arange(corners) / corners
    return center + radius * numpy.stack([numpy.cos(angle), numpy.sin(angle)], axis=-1)


def around_hole(corners, hole):
    """Delaunay triangles between the corners of a rectangle and those of a polygon in a circle inside it, both
    counter-clockwise; numbers of the corners first."""
    n = len(hole)
    begin, end = hole, numpy.roll(hole, -1, axis=0)
    a, b = begin[:, None] - corners, end[:, None] - corners
    cross = a[..., 1] * b[..., 0] - a[..., 0] * b[..., 1]  # positive where the corner is outside of the edge
    angle = numpy.arctan2(cross, (a * b).sum(axis=-1))
    apex = numpy.where(cross > 0, angle, -1).argmax(axis=1)  # the circle through it is empty
    triangles = [(4 + (k + 1) % n, 4 + k, apex[k]) for k in range(n)]
    for k in range(n):
        for step in range((apex[k] - apex[k - 1]) % 4):
            corner = apex[k - 1] + step
            triangles.append((4 + k, corner % 4, (corner + 1) % 4))
    return triangles


def extruded(nodes, holes, height):
    """A grid of rectangles with a hole in some of them.

    nodes  corners of the rectangles [i, j]
    holes  rectangle (i, j) to a polygon in a circle, counter-clockwise
    """
    number = numpy.arange(len(nodes) * nodes.shape[1]).reshape(nodes.shape[:2])
    flat, top = [nodes.reshape(-1, 2)], []
    loops = [numpy.concatenate([number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]])]
    for i, j in itertools.product(*(range(n - 1) for n in number.shape)):
        corners = numpy.array([number[i, j], number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]])
        if (i, j) not in holes:
            top += [corners[[0, 1, 2]], corners[[0, 2, 3]]]
            continue
        hole = holes[i, j]
        loop = sum(map(len, flat)) + numpy.arange(len(hole))
        triangles = around_hole(flat[0][corners], hole)
        top += list(numpy.concatenate([corners, loop])[numpy.array(triangles)])
        flat.append(hole)
        loops.append(loop[::-1])
    flat, top = numpy.concatenate(flat), numpy.array(top)
    points = numpy.concatenate([numpy.c_[flat, numpy.full(len(flat), z)] for z in (0, height)])
    begin = numpy.concatenate(loops)
    end = numpy.concatenate([numpy.roll(loop, -1) for loop in loops])
    sides = quads(begin, end, end + len(flat), begin + len(flat))
    return Mesh(points, numpy.concatenate([top[:, ::-1], top + len(flat), sides]))


def plate(random):
    counts = random.integers(1, 6), random.integers(1, 5)
    cell = random.uniform(0.5, 1, 2)
    nodes = cell * numpy.stack(numpy.meshgrid(*(numpy.arange(n + 1) for n in counts), indexing="ij"), axis=-1)
    size = 1.05 * numpy.linalg.norm(cell * counts)  # the thickness makes it longer
    wall = log_uniform(random, NARROWEST, 0.1) * size
    places = list(itertools.product(*map(range, counts)))
    holes = {}
    for i in random.permutation(len(places))[:random.integers(0, len(places) + 1)]:
        radius = (cell.min() - wall) / 2 * random.uniform(0.3, 1)
        free = numpy.maximum(cell / 2 - radius - wall / 2, 0)
        center = cell * (numpy.array(places[i]) + 0.5) + random.uniform(-1, 1, 2) * free
        holes[places[i]] = circle(center, radius, random.choice([3, 4, 6, 12, 32, 64]), random.uniform(0, 7))
    return extruded(nodes, holes, log_uniform(random, NARROWEST, 0.3) * size)


def grid_lines(random, cells):
    """Three lists of coordinates, some of which are close to the next."""
    widths = [random.uniform(0.1, 0.5, n) for n in cells]
    whole = 1.3 * numpy.linalg.norm([each.sum() for each in widths])
    for each in widths:
        thin = random.random(len(each)) < 0.4
        each[thin] = [log_uniform(random, NARROWEST, 0.05) * whole for _ in range(thin.sum())]
    return [numpy.concatenate([[0], numpy.cumsum(each)]) for each in widths]


def is_manifold(filled):
    """Is the boundary of these cells one? Around each corner of cells, both the filled ones and the others must
    hang together by their sides."""
    cells = numpy.pad(filled, 1)
    neighbors = [[b for b in range(8) if (a ^ b) in (1, 2, 4)] for a in range(8)]

    def in_one_piece(members):
        found, open_ = set(), members[:1]
        while open_:
            found.update(open_)
            open_ = [b for a in open_ for b in neighbors[a] if b in members and b not in found]
        return len(found) == len(members)

    bits = sum((cells[i:cells.shape[0] - 1 + i, j:cells.shape[1] - 1 + j, k:cells.shape[2] - 1 + k].astype(int)
                << (4 * i + 2 * j + k)) for i, j, k in itertools.product((0, 1), repeat=3))
    return all(in_one_piece([b for b in range(8) if (pattern >> b & 1) == value])
               for pattern in numpy.unique(bits) for value in (0, 1))


def boundary(filled, lines):
    """Of these cells of a grid, which must be manifold."""
    cells = numpy.pad(filled, 1)
    shape = numpy.array(filled.shape) + 1
    polygons = []
    for axis in range(3):
        inside, outside = numpy.delete(cells, -1, axis), numpy.delete(cells, 0, axis)
        u, v = numpy.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
        for wall, turned in ((inside & ~outside, False), (outside & ~inside, True)):
            corner = numpy.argwhere(wall) - 1
            corner[:, axis] += 1
            around = [numpy.ravel_multi_index((corner + step).T, shape) for step in (0 * u, u, u + v, v)]
            polygons.append(quads(*(around[::-1] if turned else around)))
    triangles = numpy.concatenate(polygons)
    used, renumbered = numpy.unique(triangles, return_inverse=True)
    points = numpy.stack(numpy.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3)
    return Mesh(points[used], renumbered.reshape(-1, 3))


def random_range(random, cells):
    a, b = sorted(random.choice(cells + 1, 2, replace=False))
    return slice(a, b)


def blocks(random):
    while True:
        cells = random.integers(2, 8, 3)
        filled = numpy.zeros(cells, bool)
        for value in [True] * random.integers(1, 6) + [False] * random.integers(0, 5):
            filled[tuple(random_range(random, n) for n in cells)] = value
        if filled.any() and is_manifold(filled):
            return boundary(filled, grid_lines(random, cells))


def nested(random):
    layers = random.integers(1, 4)
    widths = numpy.array([log_uniform(random, 1.5 * NARROWEST, 0.1) for _ in range(layers)])
    halves = random.uniform(0.4, 1, 3) * 0.5 + widths.sum()  # the diagonal is below 2
    bounds = numpy.concatenate([[0], numpy.cumsum(widths)])
    lines = []
    for half in halves:
        middle = [half - 0.06, half + 0.06]  # of a window
        lines.append(numpy.concatenate([bounds, middle, 2 * half - bounds[::-1]]))
    count = 2 * layers + 3
    depth = numpy.minimum(numpy.arange(count), numpy.arange(count)[::-1])
    deepest = numpy.minimum(numpy.minimum(depth[:, None, None], depth[:, None]), depth)
    filled = numpy.minimum(deepest, layers) % 2 == 0
    if random.random() < 0.4:
        filled[0, layers + 1, layers + 1] = False
    return boundary(filled, lines)


def turned(random):
    """A rectangle or a circle, turned around an axis beside it."""
    wall = log_uniform(random, 0.02, 0.3)
    height = random.uniform(0.05, 1)
    if random.random() < 0.5:
        profile = numpy.array([(0, 0), (wall, 0), (wall, height), (0, height)])
    else:
        profile = circle((wall, 0), wall, random.integers(5, 24), 0)
    profile = profile + (random.uniform(0.3, 0.6), 0)
    steps = random.integers(6, 80)
    closed = random.random() < 0.6
    whole = 2 * numpy.pi if closed else random.uniform(1, 5.5)
    angle = numpy.linspace(0, whole, steps + 1)[:steps + (not closed)]
    radius, z = profile.T
    points = numpy.stack([numpy.outer(numpy.cos(angle), radius), numpy.outer(numpy.sin(angle), radius),
                          numpy.broadcast_to(z, (len(angle), len(z)))], axis=-1)
    number = numpy.arange(len(angle) * len(z)).reshape(len(angle), len(z))
    here, there = (number, numpy.roll(number, -1, axis=0)) if closed else (number[:-1], number[1:])
    sides = [quads(here, there, numpy.roll(there, -1, axis=1), numpy.roll(here, -1, axis=1))]
    # Profiles are convex.
    fan = numpy.array([(0, k, k + 1) for k in range(1, len(z) - 1)])
    sides += [] if closed else [number[0][fan], number[-1][fan[:, ::-1]]]
    return Mesh(points.reshape(-1, 3), numpy.concatenate(sides))


def flying_edges(random, distance, finest):
    """The places with negative distance; None if a little more or less is another solid."""
    grid = random.integers(36, finest)
    ticks = numpy.linspace(-HALF, HALF, grid)
    z, y, x = numpy.meshgrid(ticks, ticks, ticks, indexing="ij")
    distances = distance(numpy.stack([x, y, z], axis=-1)) * (grid - 1) / (2 * HALF)
    meshes = [mesh_below(distances)]
    if not meshes[0].GetNumberOfCells():
        return None
    result = mesh_of(meshes[0])
    level = NARROWEST / 2 * result.diagonal()
    meshes += [mesh_below(distances, sign * level) for sign in (-1, 1)]
    if len({betti_of_mesh(each) for each in meshes}) > 1:
        return None
    return Mesh(result.points, result.triangles[:, ::-1])


def smooth(random):
    return flying_edges(random, Solid(random).distance, 60)


def frame(random):
    """Struts of a connected graph."""
    counts = random.integers(2, 4, 3)
    places = [numpy.linspace(-1, 1, n) if n > 1 else numpy.zeros(1) for n in counts]
    nodes = numpy.stack(numpy.meshgrid(*places, indexing="ij"), axis=-1).reshape(-1, 3)
    nodes += random.uniform(-0.15, 0.15, nodes.shape)
    number = numpy.arange(len(nodes)).reshape(counts)
    struts = []
    for axis in range(3):
        struts += zip(numpy.delete(number, -1, axis).ravel(), numpy.delete(number, 0, axis).ravel())
    root = list(range(len(nodes)))  # of each node's tree
    taken, more = [], random.integers(0, GENUS + 1)
    for a, b in (struts[i] for i in random.permutation(len(struts))):
        if root[a] != root[b]:
            root = [root[a] if each == root[b] else each for each in root]
        elif more > 0:
            more -= 1
        else:
            continue
        taken.append((nodes[a], nodes[b]))
    radius = random.uniform(0.06, 0.22)

    def distance(points):
        result = numpy.full(points.shape[:-1], numpy.inf)
        for a, b in taken:
            along = numpy.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
            result = numpy.minimum(result, numpy.linalg.norm(points - a - along[..., None] * (b - a), axis=-1))
        return result - radius

    return flying_edges(random, distance, 72)


KINDS = {each.__name__: each for each in (plate, blocks, nested, turned, smooth, frame)}
SMOOTH = (smooth, frame)


def beside(random, mesh, other):
    """Two with a gap between them, down to the narrowest."""
    shift = -other.points.min(axis=0)
    shift[1:] += mesh.points.min(axis=0)[1:]
    shift[0] += mesh.points.max(axis=0)[0]
    shift[0] += log_uniform(random, NARROWEST, 0.05) * (mesh.diagonal() + other.diagonal())
    other.points += shift
    return mesh.united(other)


def placed(random, mesh):
    """Turned, moved, and in another unit."""
    unit = log_uniform(random, 1e-3, 1e3)
    points = unit * (mesh.points @ rotation(random).T + random.uniform(-2, 2, 3))
    if random.random() < 0.3:  # as in a binary .stl file
        points = points.astype(numpy.float32)
    return Mesh(points, mesh.triangles[:, ::-1] if random.random() < 0.2 else mesh.triangles)


def made(random):
    """The name of a kind and a mesh of it; None where it is left out."""
    name = str(random.choice(list(KINDS)))
    kind = KINDS[name]
    mesh = kind(random)
    if mesh and kind not in SMOOTH and random.random() < 0.25:
        others = [each for each in KINDS.values() if each not in SMOOTH]
        mesh = beside(random, mesh, others[random.integers(len(others))](random))
    return name, mesh and placed(random, mesh)


def run(seed, number, counts, save):
    """Tries one mesh and counts its outcomes."""
    kind, mesh = made(numpy.random.default_rng([seed, number]))
    data = mesh and mesh.polydata()
    truth = betti_of_mesh(data) if data else (0, 0, 0)
    if not truth[0] or truth[1] > GENUS:
        counts["left out"] += 1
        return
    outcomes, words = outcomes_of(simplified(data, ""), truth, True)
    for each in outcomes:
        counts[kind, each] += 1
    failed = any(each in FAILURES for each in outcomes)
    counts["failed"] += failed
    if outcomes == ["right"]:
        return
    print("%s: --seed %d --first %d --count 1: %s, %d triangles, true %s"
          % ("FAILED" if failed else ", ".join(outcomes), seed, number, kind, len(mesh.triangles), truth))
    for text in (outcomes if failed else []) + words:
        print("    " + text, flush=True)
    if save:
        writer = vtkPLYWriter()
        writer.SetFileName("%s/mesh_%d_%d.ply" % (save, seed, number))
        writer.SetInputData(data)
        writer.Write()


def main():
    arguments = parser_of(__doc__).parse_args()
    return try_all(arguments, tuple(KINDS), lambda number, counts: run(
        arguments.seed, number, counts, arguments.save))


if __name__ == "__main__":
    sys.exit(main())
