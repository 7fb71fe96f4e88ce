#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The five filters from Python: the chain runs, and its arrays can be read."""

import math
import os
import tempfile
import unittest

from medialaxis import (vtkMedialAxis, vtkMedialMeshReader, vtkMedialMeshWriter,
                        vtkMedialPartDecomposition, vtkMedialPrune, vtkPolarBalls, vtkPowerCrust)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData


def ellipsoid(count=800):
    """Points spread over an ellipsoid along a spiral."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        around = math.sqrt(1 - z * z)
        turn = math.pi * (3 - math.sqrt(5)) * i
        points.InsertNextPoint(3 * around * math.cos(turn), 2 * around * math.sin(turn), z)
    result = vtkPolyData()
    result.SetPoints(points)
    return result


def field(data, name):
    array = data.GetFieldData().GetArray(name)
    return list(array.GetTuple(0))


class Pipeline(unittest.TestCase):
    def test_makes_a_closed_surface(self):
        balls = vtkPolarBalls()
        balls.SetInputData(ellipsoid())
        axis = vtkMedialAxis()
        axis.SetInputConnection(balls.GetOutputPort())
        parts = vtkMedialPartDecomposition()
        parts.SetInputConnection(axis.GetOutputPort())
        prune = vtkMedialPrune()
        prune.SetInputConnection(parts.GetOutputPort())
        prune.ClearIterations()
        prune.AddIteration(vtkMedialPrune.TRIANGLE_COUNT, 5)
        crust = vtkPowerCrust()
        crust.SetInputConnection(balls.GetOutputPort())
        crust.SetAxisConnection(prune.GetOutputPort())
        crust.Update()
        surface = crust.GetOutput()
        self.assertEqual(field(surface, "Closed"), [1])
        self.assertEqual(field(surface, "BettiCrust"), [1, 0, 0])
        self.assertEqual(field(axis.GetOutput(), "Certificate"), [1])
        self.assertAlmostEqual(field(surface, "Volume")[0] / (8 * math.pi), 1, delta=0.05)
        history = prune.GetOutputDataObject(1)
        self.assertEqual(history.GetNumberOfRows(), 1)

    def test_medial_mesh_is_read_back(self):
        balls, axis = vtkPolarBalls(), vtkMedialAxis()
        balls.SetInputData(ellipsoid())
        axis.SetInputConnection(balls.GetOutputPort())
        writer, reader = vtkMedialMeshWriter(), vtkMedialMeshReader()
        writer.SetInputConnection(axis.GetOutputPort())
        with tempfile.TemporaryDirectory() as folder:
            writer.SetFileName(os.path.join(folder, "axis.ma"))
            self.assertEqual(writer.Write(), 1)
            reader.SetFileName(writer.GetFileName())
            reader.Update()
        writer.WriteToOutputStringOn()
        writer.Write()
        text = writer.GetOutputString()
        writer.SetInputConnection(reader.GetOutputPort())
        writer.Write()
        self.assertEqual(writer.GetOutputString(), text)
        self.assertEqual(reader.GetOutput().GetNumberOfPolys(), axis.GetOutput().GetNumberOfPolys())

    def test_part_has_a_color(self):
        colors = []
        for part in range(30):
            rgb = [0, 0, 0]
            vtkMedialPartDecomposition.GetPartColor(part, rgb)
            self.assertTrue(all(0 <= component <= 1 for component in rgb), rgb)
            colors.append(tuple(rgb))
        self.assertEqual(len(set(colors)), 30)

    def test_reports_errors(self):
        balls = vtkPolarBalls()
        balls.SetInputData(ellipsoid(3))
        messages = []
        balls.AddObserver("ErrorEvent", lambda *_: messages.append(1))
        balls.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        balls.Update()
        self.assertEqual(messages, [1])
        self.assertNotEqual(balls.GetErrorCode(), 0)
        self.assertEqual(balls.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
