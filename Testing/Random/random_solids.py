#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random solids, whose topology is known, go through the whole chain.

  random_solids.py [--seed S] [--first I] [--count N] [--seconds T] [--save DIR] [--coarse]

Solid I of seed S is a union of balls, boxes and tori, some with a bubble in it. Its boundary is sampled at
random density, with noise of up to a tenth of the spacing. Its Betti numbers are those of the mesh that
Flying Edges makes on a grid; a solid for which two grids disagree is left out.

A solid is resolved if growing and shrinking it by a spacing doesn't change its topology. Then the power
shape, the axis, the pruned axis and the surface should have its Betti numbers, and the surface be a closed
manifold. If not, it counts as "wrong but said" where the verdict is "not certified": the samples are random,
so some don't show the solid. What must not be, and ends the run with exit code 1:

  error                an error instead of results
  wrong and certified  a resolved solid is wrong, or the stages of any solid contradict each other, and the
                       verdict is "certified"
  fallback unsaid      the axis is the collapsed power shape, and no warning says so

Each of these and each "wrong but said" is printed with the options that repeat it; the table of all outcomes
comes last. A coarse solid, one that isn't resolved, is also wrong where its samples show another solid
without a doubt; its row of the table says how often, and --coarse prints these too.
"""

import argparse
import collections
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPointLocator, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkPolyDataConnectivityFilter

from medialaxis import vtkSimplifyShape

HALF = 1.5  # of the cube that holds each solid
GRIDS = (56, 80)  # points on an edge of it
SCHEDULES = ("", "t5 t5 v1%", "t5 t5 v1% v10%", "t5 t5 r5%")


class Ball:
    """A ball; distance: negative inside."""

    def __init__(self, random):
        self.radius = random.uniform(0.2, 0.5)
        self.center = random.uniform(-0.7, 0.7, 3)

    def distance(self, points):
        return numpy.linalg.norm(points - self.center, axis=-1) - self.radius

    def area(self):
        return 4 * numpy.pi * self.radius**2

    def surface(self, random, count):
        """Random points of the surface, equally dense everywhere."""
        return self.center + self.radius * directions(random, count)


class Box:
    """A turned box."""

    def __init__(self, random):
        self.half = random.uniform(0.12, 0.5, 3)
        self.center = random.uniform(-0.6, 0.6, 3)
        self.axes = rotation(random)

    def distance(self, points):
        outside = numpy.abs((points - self.center) @ self.axes) - self.half
        return (numpy.linalg.norm(numpy.maximum(outside, 0), axis=-1) +
                numpy.minimum(outside.max(axis=-1), 0))

    def area(self):
        x, y, z = self.half
        return 8 * (x * y + y * z + z * x)

    def surface(self, random, count):
        x, y, z = self.half
        sides = numpy.array([y * z, z * x, x * y])
        side = random.choice(3, count, p=sides / sides.sum())
        points = random.uniform(-1, 1, (count, 3)) * self.half
        points[numpy.arange(count), side] = random.choice([-1, 1], count) * self.half[side]
        return points @ self.axes.T + self.center


class Torus:
    """A turned torus."""

    def __init__(self, random):
        self.ring = random.uniform(0.35, 0.6)
        self.tube = random.uniform(0.1, 0.55) * self.ring
        self.center = random.uniform(-0.5, 0.5, 3)
        self.axes = rotation(random)

    def distance(self, points):
        local = (points - self.center) @ self.axes
        around = numpy.hypot(local[..., 0], local[..., 1]) - self.ring
        return numpy.hypot(around, local[..., 2]) - self.tube

    def area(self):
        return 4 * numpy.pi**2 * self.ring * self.tube

    def surface(self, random, count):
        angle = random.uniform(0, 2 * numpy.pi, 4 * count)
        radius = self.ring + self.tube * numpy.cos(angle)
        # As many as the circle at this angle is long.
        taken = random.uniform(0, self.ring + self.tube, 4 * count) < radius
        angle, radius = angle[taken][:count], radius[taken][:count]
        turn = random.uniform(0, 2 * numpy.pi, len(angle))
        local = numpy.stack([radius * numpy.cos(turn), radius * numpy.sin(turn),
                             self.tube * numpy.sin(angle)], axis=1)
        return local @ self.axes.T + self.center


class Solid:
    """The union of some of these, less bubbles."""

    def __init__(self, random):
        kinds = random.choice([Ball, Box, Torus], random.integers(1, 6))
        self.parts = [kind(random) for kind in kinds]
        self.bubbles = []
        if random.random() < 0.3:
            bubble = Ball(random)
            bubble.radius = random.uniform(0.1, 0.25)
            bubble.center = self.parts[0].center
            self.bubbles.append(bubble)

    def distance(self, points):
        """Right outside and in sign; inside at most as deep as it is."""
        result = numpy.min([part.distance(points) for part in self.parts], axis=0)
        for bubble in self.bubbles:
            result = numpy.maximum(result, -bubble.distance(points))
        return result

    def boundary(self, random, count):
        """About `count` random points of the boundary."""
        surfaces = self.parts + self.bubbles
        whole = sum(each.area() for each in surfaces)
        points = numpy.concatenate([
            each.surface(random, int(count * each.area() / whole) + 1) for each in surfaces])
        return points[numpy.abs(self.distance(points)) < 1e-9], whole

    def grid_distances(self, grid):
        ticks = numpy.linspace(-HALF, HALF, grid)
        z, y, x = numpy.meshgrid(ticks, ticks, ticks, indexing="ij")
        return self.distance(numpy.stack([x, y, z], axis=-1))


def mesh_below(distances, level=0.0):
    """The boundary of the places with a distance below the level; one unit is the width of the grid."""
    image = vtkImageData()
    image.SetDimensions(distances.shape)
    image.GetPointData().SetScalars(numpy_to_vtk(distances.ravel(), deep=True))
    edges = vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.ComputeNormalsOff()
    edges.ComputeScalarsOff()
    edges.SetValue(0, level)
    edges.Update()
    return edges.GetOutput()


def betti_below(distances, level=0.0):
    """Of the places with a distance below the level: pieces, tunnels, voids."""
    return betti_of_mesh(mesh_below(distances, level))


def betti_of_mesh(mesh):
    """Of the solid in a closed mesh, whose triangles are oriented alike; its largest piece bounds a solid, not a void."""
    if not mesh.GetNumberOfPoints():
        return (0, 0, 0)
    pieces = vtkPolyDataConnectivityFilter()
    pieces.SetInputData(mesh)
    pieces.SetExtractionModeToAllRegions()
    pieces.ColorRegionsOn()
    pieces.Update()
    mesh = pieces.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    piece = vtk_to_numpy(mesh.GetPointData().GetScalars())
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    # Three half edges a triangle.
    euler = numpy.bincount(piece) - numpy.bincount(piece[triangles[:, 0]]) / 2
    a, b, c = (points[triangles[:, k]] for k in range(3))
    volume = numpy.bincount(piece[triangles[:, 0]], numpy.einsum("ij,ij->i", numpy.cross(a, b), c))
    outer = int(numpy.count_nonzero(volume * volume[numpy.abs(volume).argmax()] > 0))
    return (outer, int((1 - euler / 2).sum()), len(volume) - outer)


def directions(random, count):
    result = random.normal(size=(count, 3))
    return result / numpy.linalg.norm(result, axis=1, keepdims=True)


def rotation(random):
    axes, _ = numpy.linalg.qr(random.normal(size=(3, 3)))
    return axes


def spread(points, distance):
    """Those of the points that are not nearer than `distance` to one taken before."""
    locator = vtkPointLocator()
    locator.SetTolerance(distance)
    locator.InitPointInsertion(vtkPoints(), (-HALF, HALF) * 3, len(points))
    taken = []
    for point in points.tolist():
        if locator.IsInsertedPoint(point) < 0:
            locator.InsertNextPoint(point)
            taken.append(point)
    return numpy.array(taken).reshape(-1, 3)


def samples_of(solid, random):
    """Samples of the boundary, their largest spacing, and the noise in spacings."""
    wanted = random.integers(500, 3000)
    candidates, area = solid.boundary(random, 12 * wanted)
    random.shuffle(candidates)
    spacing = numpy.sqrt(0.7 * area / wanted)
    noise = random.choice([0, random.uniform(0, 0.1)])
    ratio = random.choice([1, 1, 1.5])  # some solids are sampled less on one side
    side = candidates[:, 0] > 0
    samples = []
    for candidates, distance in ((candidates[~side], spacing), (candidates[side], ratio * spacing)):
        places = spread(candidates, distance)
        shift = random.uniform(0, 1, (len(places), 1))**(1 / 3) * directions(random, len(places))
        samples.append(places + noise * distance * shift)
    return numpy.concatenate(samples), ratio * spacing, noise


def cloud_of(points):
    """Points without cells."""
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(places)
    return cloud


def simplified(data, schedule):
    """The Betti numbers of the four stages, and what is said of them; or the error's message."""
    chain = vtkSimplifyShape()
    for each in (chain, chain.GetExecutive()):
        each.AddObserver("ErrorEvent", lambda *_: None)
        each.AddObserver("WarningEvent", lambda *_: None)
    chain.SetInputData(data)
    chain.SetSchedule(schedule)
    chain.Update()
    if chain.GetErrorMessage():
        return chain.GetErrorMessage()

    def field(data, name):
        return tuple(int(x) for x in data.GetFieldData().GetArray(name).GetTuple(0))

    def texts(data, name):
        array = data.GetFieldData().GetAbstractArray(name)
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []

    axis, surface = chain.GetMedialAxis().GetOutput(), chain.GetOutputDataObject(0)
    history = chain.GetOutputDataObject(3).GetColumnByName("Betti")
    last = history.GetNumberOfTuples() - 1 if history else -1
    return {
        "power shape": field(axis, "BettiPowerShape"),
        "axis": field(axis, "BettiAxis"),
        "pruned axis": (tuple(int(x) for x in history.GetTuple(last)) if last >= 0 else
                        field(axis, "BettiAxis")),
        "surface": field(surface, "BettiCrust"),
        "fallback": field(axis, "Fallback")[0],
        "closed manifold": field(surface, "Closed")[0] and field(surface, "Manifold")[0],
        "put back": field(surface, "PutBackBalls")[0],
        "certified": texts(surface, "Verdict") == ["certified"],
        "reasons": texts(surface, "VerdictReasons"),
        "warnings": texts(surface, "WarningCode"),
    }


STAGES = ("power shape", "axis", "pruned axis", "surface")


def contradictions(result):
    """What contradicts something else of the result, in words."""
    found = ["%s has %s, %s %s" % (stage, result[stage], before, result[before])
             for before, stage in zip(STAGES, STAGES[1:]) if result[stage] != result[before]]
    return found + ["surface is not a closed manifold"] * (not result["closed manifold"])


def outcome_of(result, truth, resolved):
    """The outcome's name in the table, and what is wrong, in words."""
    if isinstance(result, str):
        return "error", [result]
    against = contradictions(result)
    wrong = ["%s has %s" % (stage, result[stage]) for stage in STAGES if result[stage] != truth][:1] + against
    if not result["certified"]:
        said = ["said: " + reason for reason in result["reasons"]]
        return ("wrong but said", wrong + said) if wrong else ("right but not certified", said)
    if against or (wrong and resolved):
        return "wrong and certified", wrong
    return ("another solid", wrong) if wrong else ("right", [])


def outcomes_of(result, truth, resolved):
    """The outcome and what happened besides, by their names in the table; and what is wrong, in words."""
    outcome, words = outcome_of(result, truth, resolved)
    outcomes = [outcome]
    if outcome != "error":
        outcomes += ["balls put back"] * (result["put back"] > 0)
        if result["fallback"]:
            outcomes.append("fallback said" if "fallback" in result["warnings"] else "fallback unsaid")
    return outcomes, words


FAILURES = ("error", "wrong and certified", "fallback unsaid")


def run(seed, number, counts, save, coarse):
    """Tries one solid and counts its outcomes."""
    random = numpy.random.default_rng([seed, number])
    solid = Solid(random)
    distances = [solid.grid_distances(grid) for grid in GRIDS]
    truth = betti_below(distances[1])
    if betti_below(distances[0]) != truth or not truth[0]:  # or a bubble took all of it
        counts["left out"] += 1
        return
    samples, spacing, noise = samples_of(solid, random)
    schedule = str(random.choice(SCHEDULES))
    kind = ("resolved" if all(betti_below(distances[1], level) == truth for level in (-spacing, spacing)) else
            "coarse")
    result = simplified(cloud_of(samples), schedule)
    outcomes, words = outcomes_of(result, truth, kind == "resolved")
    outcome = outcomes[0]
    for each in outcomes:
        counts[kind, each] += 1
    failed = any(each in FAILURES for each in outcomes)
    counts["failed"] += failed
    shown = failed or "fallback said" in outcomes or (
        outcome != "right" and (coarse or (kind == "resolved" and outcome != "right but not certified")))
    if not shown:
        return
    print("%s: --seed %d --first %d --count 1: %d samples, noise %.3f, schedule '%s', %s, true %s"
          % ("FAILED" if failed else ", ".join(outcomes), seed, number, len(samples), noise, schedule, kind,
             truth))
    for text in (outcomes if failed else []) + words:
        print("    " + text, flush=True)
    if save:
        numpy.savetxt("%s/solid_%d_%d.xyz" % (save, seed, number), samples, fmt="%.17g")


OUTCOMES = ("right", "right but not certified", "wrong but said", "wrong and certified", "another solid",
            "error")
BESIDES = ("fallback said", "fallback unsaid", "balls put back")


def print_table(solids, counts, kinds):
    """The outcomes of each kind, of which each solid has one, and what happened besides."""
    print("%d solids, %d of them left out" % (solids, counts["left out"]))
    print(("%-26s" + " %9s" * len(kinds)) % ("", *kinds))
    rows = [("all", OUTCOMES)] + [(name, (name,)) for name in OUTCOMES + BESIDES]
    for name, names in rows:
        numbers = (sum(counts[kind, each] for each in names) for kind in kinds)
        print(("%-26s" + " %9d" * len(kinds)) % (name, *numbers))


def parser_of(doc):
    """For the options that say which solids are tried."""
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, metavar="I", help="the first solid")
    parser.add_argument("--count", type=int, default=sys.maxsize, metavar="N", help="solids at most")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="time at most")
    parser.add_argument("--save", metavar="DIR", help="where the input of what is printed goes")
    return parser


def try_all(arguments, kinds, try_one):
    """Tries solids and prints the table. The exit code: 1 if one failed, or none was tried."""
    if arguments.count == sys.maxsize and arguments.seconds == float("inf"):
        arguments.count = 20
    end = time.monotonic() + arguments.seconds
    counts = collections.Counter()
    solids = 0
    for number in range(arguments.first, arguments.first + arguments.count):
        if time.monotonic() > end:
            break
        try_one(number, counts)
        solids += 1
    print_table(solids, counts, kinds)
    tried = any(counts[kind, name] for kind in kinds for name in OUTCOMES)
    return 1 if counts["failed"] or not tried else 0


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--coarse", action="store_true", help="prints the wrong ones of the coarse solids, too")
    arguments = parser.parse_args()
    return try_all(arguments, ("resolved", "coarse"), lambda number, counts: run(
        arguments.seed, number, counts, arguments.save, arguments.coarse))


if __name__ == "__main__":
    sys.exit(main())
