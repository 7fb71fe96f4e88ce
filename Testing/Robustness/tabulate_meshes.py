#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs SimplifyShape on closed meshes and compares each stage with the solid.

    Testing/Robustness/tabulate_meshes.py build/bin/SimplifyShape DATA [--write] [PATTERN ...]

DATA is the folder that holds meshes/ and models/. meshes.csv beside this script has the pieces, tunnels and voids
of each solid, from the sources of the data, not from the program. A mesh is run three times with default options:

    as a mesh             Betti numbers of all stages, verdict
    without pruning       how far the surface is from the mesh, in spacings: 99 of 100 of its points are nearer,
                          and the farthest. Not counted is what is nearer than a spacing to a sharp edge of the
                          mesh (30 degrees). A spacing is the mean distance of a sample to its six nearest ones.
    with --points         what its vertices alone give

Runs one mesh on each core, each on one thread, for half an hour in all. --write puts the table into
Testing/README.md; with patterns, such as 'meshes/*', only their rows change. The exit code is 1 where something
wrong is certified, or a mesh is not right and certified at all stages.
"""

import pathlib
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import tables
from comparisons import distance_to, read, run, spacing_at

HEADER = ("| file | right | samples | parts | power shape | axis | pruned | surface | verdict | distance 99 % | farthest "
          "| seconds | for balls | as points |\n|---|---|--:|--:|---|---|---|---|---|--:|--:|--:|--:|---|\n")
SHARP = 30  # degrees
STAGES = ("powerShape", "axis", "pruned", "crust")


def sharp_edges(mesh):
    edges = vtkFeatureEdges()
    edges.SetInputData(mesh)
    edges.SetFeatureAngle(SHARP)
    edges.BoundaryEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput()


def distances(mesh, folder):
    """How far the corners and middles of a surface's triangles are from the mesh, in spacings."""
    surface = read(vtkXMLPolyDataReader(), pathlib.Path(folder, "surface.vtp"))
    spacing = spacing_at(read(vtkXMLPolyDataReader(), pathlib.Path(folder, "samples.vtp")))
    to_mesh, to_edges = distance_to(mesh), distance_to(sharp_edges(mesh))
    corners = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    result = []
    for place in np.concatenate([corners, corners[triangles].mean(axis=1)]):
        length = spacing(place)
        if to_edges(place) > length:
            result.append(to_mesh(place) / length)
    return np.array(result)


def row(program, data, entry):
    """A row of the table, and whether it is as it must be."""
    path, right = data / entry["file"], entry["right"]
    with tempfile.TemporaryDirectory() as folder:
        report = run(program, path, pathlib.Path(folder, "mesh"))
        points = run(program, path, pathlib.Path(folder, "points"), "--points")
        if isinstance(report, str):
            return f"| `{entry['file']}` | {right} | refused: {report} " + "| " * 12 + "|\n", False
        run(program, path, pathlib.Path(folder, "unpruned"), "--schedule", "")
        far = distances(read(vtkPLYReader(), path), pathlib.Path(folder, "unpruned"))
    stages = [tables.in_words(report["betti"][stage]) for stage in STAGES]
    verdict = report["verdict"]["name"] + (", fallback" if report["fallback"] else "")
    if isinstance(points, str):
        vertices, vertices_certified = "refused", False
    else:
        vertices_certified = points["verdict"]["name"] == "certified"
        vertices = tables.in_words(points["betti"]["crust"]) + ", " + points["verdict"]["name"]
    seconds = report["seconds"]
    balls = seconds["samples"] + seconds["polarBalls"]
    farthest, most = (far.max(), np.quantile(far, 0.99)) if len(far) else (0, 0)
    cells = [f"`{entry['file']}`", right, f"{report['samples']:,}", f"{report['parts']:,}", *stages, verdict,
             f"{most:.2f}", f"{farthest:.2f}", f"{seconds['total']:.0f}", f"{balls / seconds['total']:.0%}", vertices]
    fine = set(stages) == {right} and verdict == "certified"
    return "| " + " | ".join(cells) + " |\n", fine and (not vertices_certified or vertices.startswith(right + ","))


tables.tabulate(__doc__, "meshes", HEADER, "meshes.csv", row, "right and certified")
