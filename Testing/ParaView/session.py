# SPDX-License-Identifier: BSD-3-Clause
"""What the tests share: samples of a box, the plugin, the five filters one after another."""

import os
import random
import traceback
import types

from paraview import servermanager
from paraview import simple as pv
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

# The filters of the plugin, once it is loaded; LoadPlugin ignores a namespace without names.
filters = types.SimpleNamespace(plugin="MedialAxis")

SIZE = (3.0, 2.0, 1.0)

step = -1  # the last one that take_step has taken


def box(spacing=0.15, seed=1):
    """A point somewhere in each square of a grid on the faces, another on each piece of an edge."""
    numbers = random.Random(seed)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    counts = [round(length / spacing) for length in SIZE]
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            for i in range(counts[u]):
                for j in range(counts[v]):
                    point = [0, 0, 0]
                    point[axis] = side * SIZE[axis]
                    point[u] = (i + numbers.uniform(0.2, 0.8)) * SIZE[u] / counts[u]
                    point[v] = (j + numbers.uniform(0.2, 0.8)) * SIZE[v] / counts[v]
                    points.InsertNextPoint(point)
    result = vtkPolyData()
    result.SetPoints(points)
    return result


def write(data, name):
    """The path of a new file with the data in the folder of the test."""
    path = os.path.join(os.getcwd(), name)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.SetDataModeToBinary()  # a patched expat can't read raw data after the XML
    writer.Write()
    return path


def load_plugin(remote=False):
    pv.LoadPlugin(os.environ["MEDIAL_PLUGIN"], remote=remote, ns=vars(filters))


def samples():
    return pv.XMLPolyDataReader(FileName=[write(box(), "samples.vtp")])


def show_pruned_axis():
    """What the tests of picking begin with, in the user interface: a pruned axis alone in the view."""
    vars(filters).update((name, getattr(pv, name)) for name in dir(pv))
    balls = filters.PolarBalls(registrationName="PolarBalls1", Input=samples())
    axis = filters.MedialAxis(registrationName="MedialAxis1", Input=balls)
    pruned = filters.MedialPrune(registrationName="MedialPrune1", Input=axis)
    view = pv.GetActiveViewOrCreate("RenderView")
    pv.Show(pruned, view)
    view.CameraPosition, view.CameraFocalPoint = [1.5, 1, 9], [1.5, 1, 0.5]
    pv.SetActiveSource(pruned)
    pv.Render()


def take_step(steps):
    """Calls the next of the steps. A macro calls this anew each time; this module stays loaded."""
    global step
    step += 1
    try:
        steps[step]()
    except BaseException:
        os.write(2, traceback.format_exc().encode())  # of a macro sys.stderr would go to a window
        os._exit(1)  # the user interface would go on


class Chain:
    """The five filters."""

    def __init__(self, source):
        self.balls = filters.PolarBalls(Input=source)
        self.axis = filters.MedialAxis(Input=self.balls)
        self.parts = filters.MedialPartDecomposition(Input=self.axis)
        self.prune = filters.MedialPrune(Input=self.parts)
        self.crust = filters.PowerCrust(Input=self.balls, Axis=self.prune)


def field(data, name):
    """The first entry of a field array."""
    return list(data.GetFieldData().GetArray(name).GetTuple(0))


def column(table, name):
    """The values of an array of a table or of attributes."""
    array = getattr(table, "GetRowData", lambda: table)().GetArray(name)
    return [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())]


def check_equal(value, expected, what):
    if value != expected:
        raise AssertionError("%s: %r instead of %r" % (what, value, expected))
