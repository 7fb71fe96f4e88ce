# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of many objects, for those who think in tables."""

from __future__ import annotations

import warnings
from typing import Any, Iterable, Sequence

from vtkmodules.vtkCommonDataModel import vtkTable

from .simplification import MedialAxisWarning, Simplified, issues, update, updated_filter
from .vtkFiltersMedial import vtkMorphometry, vtkSimplifyShape


def morphometry(objects: Iterable[Any], names: Sequence[str] | None = None, unit: str = "",
                bounds: Sequence[float] | None = None, margin: float = 0,
                **options: Any) -> list[dict[str, Any]]:
    """Measures solids with the names of bone morphometry; see vtkMorphometry. One object is in memory at a time
    if `objects` makes them one by one, as a generator does.

    objects   what `simplify` takes: arrays of points, meshes, images
    names     of the objects; None: "0", "1" ...
    unit      of the coordinates, such as "mm"
    bounds    of the volume of interest: least and largest x, y and z; None: the bounding box of the samples
    margin    by how much it is smaller on each side
    options   further arguments of `simplify`, the same for all objects, such as schedule or label

    Returns a dict for each object, all with the same keys in the same order, as pandas.DataFrame takes them: Name,
    Unit, the quantities (nan: not known), Betti:0 ... BettiSolid:2, Verdict, Error. An object that can't be
    used has the reason in Error and nan in the others; the rest goes on. Issues a MedialAxisWarning for each
    doubt, with the object's name.
    """
    rows = []
    for number, one in enumerate(objects):
        name = str(number) if names is None else names[number]
        try:
            rows.append(_row(_measured(updated_filter(one, **options), name, unit, bounds, margin)))
        except ValueError as error:
            rows.append({"Name": name, "Unit": unit, "Error": str(error)})
    columns = _columns()
    return [{column: row.get(column, "" if column in ("Verdict", "Error") else float("nan"))
             for column in columns} for row in rows]


def _columns() -> list[str]:
    result = ["Name", "Unit"]
    while (quantity := vtkMorphometry.GetQuantityName(len(result) - 2)) is not None:
        result.append(quantity)
    result += ["%s:%d" % (array, i) for array in ("Betti", "BettiSolid") for i in range(3)]
    return result + ["Verdict", "Error"]


def _measured(filter: vtkSimplifyShape, name: str, unit: str, bounds: Sequence[float] | None,
              margin: float) -> vtkTable:
    measure = vtkMorphometry()
    measure.SetInputData(filter.GetBalls())
    measure.SetAxisData(filter.GetMedialPrune().GetOutput())
    measure.SetSurfaceData(filter.GetOutput())
    measure.SetName(name)
    measure.SetUnit(unit)
    measure.SetMargin(margin)
    if bounds is not None:
        measure.UseBoundsOn()
        measure.SetBounds(*bounds)
    update(measure)
    if measure.GetErrorMessage():
        raise ValueError(measure.GetErrorMessage())
    result = Simplified(*(filter.GetOutputDataObject(port) for port in range(4)))
    for text in issues(result, measure.GetOutput()):
        warnings.warn("%s: %s" % (name, text), MedialAxisWarning, stacklevel=3)
    return measure.GetOutput()


def _row(table: vtkTable) -> dict[str, Any]:
    columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
    values = {column.GetName(): column.GetValue(0) for column in columns}
    return {**values, "Error": ""}
