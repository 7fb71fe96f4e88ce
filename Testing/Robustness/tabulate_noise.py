#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs SimplifyShape on the vertices of closed meshes with Gaussian noise, and compares the results with the meshes.

    Testing/Robustness/tabulate_noise.py build/bin/SimplifyShape DATA [--write] [PATTERN ...]

DATA is the folder that holds models/. noise.csv beside this script has the meshes with the standard deviations of the
noise, in mean distances between neighbouring vertices, and the Betti numbers of the solids. The seed is 1. Each cloud
is cleaned (--clean) and run twice:

    without pruning    the volume, against the mesh's
    by default         the Betti numbers of all stages, the verdict; so many spacings are 99 of 100 of the surface's points
                       from the mesh at most

--write puts the table into Testing/README.md. The exit code is 1 where something wrong is certified, or where noise of at
most half a spacing doesn't give the solid's Betti numbers, its volume within 1 %, and 99 % within two spacings.
"""

import pathlib
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import tables
from comparisons import distance_to, read, run, spacing_at

HEADER = ("| file and noise | right | power shape | axis | pruned | surface | verdict | volume | 99 % | seconds |\n"
          "|---|---|---|---|---|---|---|--:|--:|--:|\n")
STAGES = ("powerShape", "axis", "pruned", "crust")


def volume(mesh):
    triangles, properties = vtkTriangleFilter(), vtkMassProperties()
    triangles.SetInputData(mesh)
    properties.SetInputConnection(triangles.GetOutputPort())
    properties.Update()
    return properties.GetVolume()


def mean_spacing(mesh):
    spacing = spacing_at(mesh)
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    return np.mean([spacing(place) for place in points[::20]])


def row(program, data, entry):
    """A row of the table, and whether it is as it must be."""
    name, noise = entry["file"].split(" + ")
    mesh, right = read(vtkPLYReader(), data / name), entry["right"]
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    spacing = mean_spacing(mesh)
    noisy = points + np.random.default_rng(1).normal(0, float(noise) * spacing, points.shape)
    with tempfile.TemporaryDirectory() as folder:
        cloud, unpruned, pruned = (pathlib.Path(folder, word) for word in ("noisy.xyz", "unpruned", "pruned"))
        np.savetxt(cloud, noisy, fmt="%.17g")
        report = run(program, cloud, pruned, "--clean")
        before = run(program, cloud, unpruned, "--clean", "--schedule", "")
        if isinstance(report, str) or isinstance(before, str):
            return f"| `{entry['file']}` | {right} | refused: {report} " + "| " * 7 + "|\n", False
        volumes = volume(read(vtkXMLPolyDataReader(), unpruned / "surface.vtp")) / volume(mesh)
        to_mesh, surface = distance_to(mesh), read(vtkXMLPolyDataReader(), pruned / "surface.vtp")
        far = [to_mesh(place) for place in vtk_to_numpy(surface.GetPoints().GetData())]
    stages = [tables.in_words(report["betti"][stage]) for stage in STAGES]
    most, verdict = np.quantile(far, 0.99) / spacing, report["verdict"]["name"]
    cells = [f"`{entry['file']}`", right, *stages, verdict + (", fallback" if report["fallback"] else ""),
             f"{volumes - 1:+.2%}", f"{most:.2f}", f"{report['seconds']['total']:.0f}"]
    exact = set(stages) == {right}
    if float(noise) <= 0.5:
        fine = exact and abs(volumes - 1) <= 0.01 and most <= 2
    else:
        fine = exact or verdict != "certified"
    return "| " + " | ".join(cells) + " |\n", fine


tables.tabulate(__doc__, "noise", HEADER, "noise.csv", row, "as they must be")
