#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How long each filter works without a report of progress, and after it was asked to stop.

  PYTHONPATH=build/lib/python3/dist-packages Testing/Robustness/progress_gaps.py --count 100000

The samples are those of a bumpy sphere. Exit code 1: more than the longest time allowed.
"""

import argparse
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from medialaxis import (vtkMedialAxis, vtkMedialPartDecomposition, vtkMedialPrune, vtkPolarBalls,
                        vtkPowerCrust)


def bumpy_sphere(count):
    """Evenly spread samples."""
    height = 1 - 2 * (numpy.arange(count) + 0.5) / count
    angle = numpy.pi * (1 + 5**0.5) * numpy.arange(count)
    x, y = numpy.sqrt(1 - height**2) * (numpy.cos(angle), numpy.sin(angle))
    samples = numpy.stack([x, y, height], axis=1)
    samples *= 1 + 0.1 * (numpy.sin(6 * x) * numpy.sin(7 * y) * numpy.cos(5 * height))[:, None]
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(samples, deep=True))
    result = vtkPolyData()
    result.SetPoints(points)
    return result


def update(stage, stop_at=2.0):
    """Updates a filter. Returns the longest time without a report, where it began, and all the time.

    stop_at  the progress at which it is asked to stop; the first time is then from there to the end"""
    times, places = [time.perf_counter()], [0.0]

    def note(caller, _event):
        times.append(time.perf_counter())
        places.append(caller.GetProgress())
        if places[-1] >= stop_at and not caller.GetAbortExecute():
            caller.SetAbortExecute(1)
            times[:] = times[-1:]

    observer = stage.AddObserver("ProgressEvent", note)
    begin = times[0]
    stage.Update()
    stage.RemoveObserver(observer)
    times.append(time.perf_counter())
    if stop_at <= 1:
        return times[-1] - times[0], stop_at, times[-1] - begin
    longest, place = max(zip(numpy.diff(times), places))
    return longest, place, times[-1] - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=100000, help="samples (default: 100000)")
    parser.add_argument("--longest", type=float, default=1, help="seconds allowed (default: 1)")
    options = parser.parse_args()
    balls, axis, parts, prune, crust = (vtkPolarBalls(), vtkMedialAxis(), vtkMedialPartDecomposition(),
                                        vtkMedialPrune(), vtkPowerCrust())
    balls.SetInputData(bumpy_sphere(options.count))
    for one, other in ((balls, axis), (axis, parts), (axis, prune), (balls, crust)):
        other.SetInputConnection(one.GetOutputPort())
    crust.SetAxisConnection(prune.GetOutputPort())
    failed = False
    for stage in balls, axis, parts, prune, crust:
        stopped = update(stage, 0.5)[0]
        stage.SetAbortExecute(0)
        stage.Modified()
        gap, place, total = update(stage)
        print("%-28s %6.2f s, at most %.2f s without a report, from %.3f on; stops within %.2f s"
              % (stage.GetClassName(), total, gap, place, stopped), flush=True)
        failed |= max(gap, stopped) > options.longest
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
