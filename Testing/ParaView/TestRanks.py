# SPDX-License-Identifier: BSD-3-Clause
"""Prints what must not depend on the number of ranks. TestRanks.cmake compares."""

import hashlib
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from session import Chain, filters, load_plugin, samples, servermanager

from vtkmodules.util.numpy_support import vtk_to_numpy


def digest(data):
    """Of points, cells and their arrays."""
    total = hashlib.sha256()
    arrays = [data.GetPoints().GetData(), data.GetPolys().GetConnectivityArray()]
    for attributes in (data.GetPointData(), data.GetCellData()):
        names = [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]
        arrays += [attributes.GetArray(name) for name in sorted(names)
                   if not name.startswith("vtk")]
    for array in arrays:
        total.update(vtk_to_numpy(array).tobytes())
    return total.hexdigest()


load_plugin()
chain = Chain(samples())
one = filters.SimplifyShape(Input=chain.balls.Input)
for name, filter in (("crust", chain.crust), ("prune", chain.prune), ("one", one)):
    filter.UpdatePipeline()
    result = servermanager.Fetch(filter)
    print("RESULT", name, result.GetNumberOfCells(), digest(result), flush=True)
