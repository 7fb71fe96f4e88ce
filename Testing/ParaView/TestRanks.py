# SPDX-License-Identifier: BSD-3-Clause
"""Prints what must not depend on the number of ranks. TestRanks.cmake compares."""

import hashlib
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from session import (Chain, box, check_equal, column, field, filters, load_plugin, pv, samples,
                     servermanager, write)

from vtkmodules.util.numpy_support import vtk_to_numpy


def digest(data):
    """Of points, cells and their arrays."""
    arrays = [data.GetPoints().GetData(), data.GetPolys().GetConnectivityArray()]
    for attributes in (data.GetPointData(), data.GetCellData()):
        names = [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]
        arrays += [attributes.GetArray(name) for name in sorted(names)
                   if not name.startswith("vtk")]
    return digest_of(arrays)


def digest_of(arrays):
    total = hashlib.sha256()
    for array in arrays:
        total.update(vtk_to_numpy(array).tobytes())
    return total.hexdigest()


def collection():
    """Boxes of several sizes, each in a block."""
    return pv.GroupDatasets(Input=[
        pv.XMLPolyDataReader(FileName=[write(box(spacing), "box%d.vtp" % i)])
        for i, spacing in enumerate((0.3, 0.15, 0.25, 0.2, 0.35))])


def blocks(data):
    """Of a collection, in order."""
    iterator = data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def print_blocks(name, filter):
    """In the order of the collection; Fetch has that of the ranks."""
    found = {field(block, "ObjectId")[0]: block for block in blocks(servermanager.Fetch(filter))}
    for number, block in sorted(found.items()):
        print("RESULT", name, number, block.GetNumberOfCells(), digest(block), flush=True)


load_plugin()
chain = Chain(samples())
one = filters.SimplifyShape(Input=chain.balls.Input)
for name, filter in (("crust", chain.crust), ("prune", chain.prune), ("one", one)):
    filter.UpdatePipeline()
    result = servermanager.Fetch(filter)
    print("RESULT", name, result.GetNumberOfCells(), digest(result), flush=True)

shared = filters.ShareOutObjects(Input=collection())
print_blocks("collection at once", filters.SimplifyShape(Input=shared))
print_blocks("collection in stages", Chain(shared).crust)
simplified = filters.SimplifyShape(Input=shared, Schedule=["TriangleCount", "5", "0"])
runs = []
simplified.SMProxy.GetClientSideObject().AddObserver("EndEvent", lambda *_: runs.append(1))
simplified.UpdatePipeline()
collected = filters.CollectParts(Input=servermanager.OutputPort(simplified, 2),
                                 Parts=servermanager.OutputPort(simplified, 1), UniquePartIds=1)
table = servermanager.Fetch(collected)
check_equal(column(table, "PartId"), list(range(table.GetNumberOfRows())), "PartId of the table")
parts = [set(column(block.GetCellData(), "PartId"))
         for block in blocks(servermanager.Fetch(collected, idx=1))]
check_equal(sorted(sum(map(list, parts), [])), column(table, "PartId"), "PartId of the parts")
rows = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
print("RESULT", "table", table.GetNumberOfRows(), digest_of(rows), flush=True)
mine = len(list(blocks(shared.SMProxy.GetClientSideObject().GetOutputDataObject(0))))
check_equal(len(runs), mine + 1, "executions, one for each object and one around them")
print("SHARE", mine, flush=True)
