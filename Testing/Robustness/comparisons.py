# SPDX-License-Identifier: BSD-3-Clause
"""Runs of SimplifyShape, and how far their surfaces are from meshes."""

import json
import pathlib
import subprocess

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkIdList
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator, vtkStaticPointLocator


def run(program, path, folder, *options):
    """The report of a run, or the message of a refusal."""
    command = [program, path, "--output", folder, "--quiet", "--threads", "1", *options]
    process = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    report = pathlib.Path(folder, "report.json")
    return json.loads(report.read_text()) if report.exists() else process.stderr.strip()


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def spacing_at(samples):
    """A function that tells how far samples are apart near a place."""
    locator = vtkStaticPointLocator()
    locator.SetDataSet(samples)
    locator.BuildLocator()
    points = vtk_to_numpy(samples.GetPoints().GetData())
    found = vtkIdList()

    def spacing(place):
        locator.FindClosestNPoints(7, points[locator.FindClosestPoint(place)], found)
        near = points[[found.GetId(i) for i in range(found.GetNumberOfIds())]]
        return np.linalg.norm(near[1:] - near[0], axis=1).mean()

    return spacing


def distance_to(surface):
    """A function that tells how far a place is from cells; infinitely far from none."""
    if surface.GetNumberOfCells() == 0:
        return lambda place: np.inf
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()

    def distance(place):
        closest, squared = [0.0] * 3, mutable(0.0)
        locator.FindClosestPoint(place, closest, mutable(0), mutable(0), squared)
        return float(squared) ** 0.5

    return distance
