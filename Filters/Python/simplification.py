# SPDX-License-Identifier: BSD-3-Clause
"""The filters for those who think in numpy."""

from __future__ import annotations

import time
import warnings
from typing import Any, Callable, Iterable, NamedTuple, Sequence

from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkImageData, vtkPointSet, vtkPolyData, vtkTable)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .vtkFiltersMedial import vtkBackgroundUpdate, vtkCleanScan, vtkSimplifyShape


class Stopped(Exception):
    """Raised by `simplify` where its `progress` has returned False."""


class MedialAxisWarning(UserWarning):
    """What `simplify` issues, by Python's `warnings`, about doubtful points and results."""


class Doubt(NamedTuple):
    """A warning of a filter; Filters/README.md lists the codes."""

    code: str  # the kind, for programs
    text: str  # what was seen and what to do
    count: int  # how many points, edges, ... it is about
    place: tuple[float, float, float] | None  # where one of them is
    doubts_solid: bool  # the points may not determine the solid


class Verdict(NamedTuple):
    """Do all stages agree, and does nothing speak against the points? See vtkPowerCrust."""

    certified: bool
    reasons: list[str]  # what differs or speaks against it, a sentence each


class Simplified(NamedTuple):
    """What `simplify` returns: outputs 0 to 3 of vtkSimplifyShape."""

    surface: vtkPolyData  # oriented outwards; closed, if it is certified
    axis: vtkPolyData  # pruned, with PartId
    table: vtkTable  # a row for each part
    history: vtkTable  # a row for each iteration

    @property
    def verdict(self) -> Verdict:
        """The verdict on the surface and all stages before it."""
        return verdict_of(self.surface)

    @property
    def doubts(self) -> list[Doubt]:
        """The warnings of all stages."""
        return doubts_of(self.surface)


def simplify(points: Any, schedule: str | Iterable[Sequence] | None = None,
             progress: Callable[[float], Any] | None = None,
             merge_tolerance: float | None = None,
             use_triangles: bool | None = None,
             wrap: bool | float = False,
             iso: float | None = None, label: float | None = None,
             spacing: Sequence[float] = (1, 1, 1),
             origin: Sequence[float] = (0, 0, 0),
             normals: Any = None, clean: bool = False, trim: float = 0) -> Simplified:
    """Simplifies the solid that is given by an image, by a mesh, or by points of its boundary.

    Other threads of Python go on meanwhile. Ctrl-C stops it within a second.

    points    an array of shape (n, 3), or a vtkPointSet; a mesh is one with polygons, whose surface is
              sampled if it bounds a solid. An image is a vtkImageData, or an array with 3 dimensions:
              voxels [i, j, k] along x, y and z
    schedule  what pruning removes: "noise", "details", "features", "skeleton" or "paper"; or words like
              "t5 t5 h0.5s a2s", see vtkMedialPrune; or iterations (measure, threshold) or (measure, threshold,
              passes), where measure is a name like "RelativeVolume"; None: the default, "noise"
    progress  is called from time to time with how much is done, 0 ... 1, on the thread that called
              simplify; where it returns False, the work stops and Stopped is raised. What it raises
              stops the work, too, and is raised again
    merge_tolerance  samples within this distance of each other are one where they stand apart from all
              others, see MergeTolerance of vtkPolarBalls; None: what the rounding of the points explains
    use_triangles  True: it is an error if the polygons don't bound a solid; False: the points of the mesh
              are the samples; None: decided by the mesh, with a warning where it bounds none
    wrap      where the polygons bound no solid, sample the closed surface around them; True, or the width of
              the gaps and holes that it crosses, see Wrap of vtkBoundarySamples
    iso       of an image: voxels of at least this value are the solid
    label     of an image: voxels of this value are the solid; without iso and label it is the one of two
              values that isn't 0
    spacing, origin  of an array of voxels: their distances, and where the centre of the first one is
    normals   of the surface at each point, outwards, an array of shape (n, 3): they tell what is inside, where
              points are the samples; None: those that the vtkPointSet has, if any
    clean     take outliers and noise from the points first, see vtkCleanScan; polygons are left out then.
              Other threads wait for that
    trim      leave out rims of the axis that small bumps of the surface make, up to this erosion thickness in
              spacings of the samples, see Trim of vtkMedialAxis; 0.2 takes most of them
    Raises ValueError where the points or the schedule can't be used; the message says why.
    Issues a MedialAxisWarning for each doubt, and where the surface is not certified.
    """
    filter = updated_filter(points, schedule, progress, merge_tolerance, use_triangles, wrap, iso, label,
                            spacing, origin, normals, clean, trim)
    result = Simplified(*(filter.GetOutputDataObject(port) for port in range(4)))
    for text in issues(result, result.surface):
        warnings.warn(text, MedialAxisWarning, stacklevel=2)
    return result


def updated_filter(points: Any, schedule: str | Iterable[Sequence] | None = None,
                   progress: Callable[[float], Any] | None = None,
                   merge_tolerance: float | None = None,
                   use_triangles: bool | None = None,
                   wrap: bool | float = False,
                   iso: float | None = None, label: float | None = None,
                   spacing: Sequence[float] = (1, 1, 1),
                   origin: Sequence[float] = (0, 0, 0),
                   normals: Any = None, clean: bool = False, trim: float = 0) -> vtkSimplifyShape:
    """The filter behind `simplify`, with the same arguments and errors, when it has run."""
    filter = vtkSimplifyShape()
    prune = filter.GetMedialPrune()
    quiet = prune.AddObserver("ErrorEvent", lambda *_: None)  # else VTK prints what is raised below
    given = _input(points, spacing, origin)
    if normals is not None:
        given = _with_normals(given, normals)
    filter.SetInputData(_cleaned(given) if clean else given)
    if iso is not None and label is not None:
        raise ValueError("give iso or label, not both")
    if iso is not None or label is not None:
        if not isinstance(filter.GetInputDataObject(0, 0), vtkImageData):
            raise ValueError("iso and label are for images: a vtkImageData, or an array with 3 dimensions")
        voxels = filter.GetImageBoundary()
        voxels.SetSolid(voxels.LABEL if iso is None else voxels.ISO_VALUE)
        voxels.SetLabel(label or 0)
        voxels.SetIsoValue(iso or 0)
    if merge_tolerance is not None:
        filter.SetMergeTolerance(merge_tolerance)
    if use_triangles is not None:
        filter.SetUseTriangles(filter.ON if use_triangles else filter.OFF)
    filter.SetTrim(trim)
    filter.KeepAxisOff()
    filter.SetWrap(wrap is not False)
    filter.SetWrapWidth(0 if isinstance(wrap, bool) else wrap)
    if isinstance(schedule, str):
        filter.SetSchedule(schedule)
    elif schedule is not None:
        filter.ClearIterations()
        for iteration in schedule:
            filter.AddIterationByName(*iteration)
    prune.RemoveObserver(quiet)  # another thread must not call into Python
    if not filter.GetErrorMessage():
        update(filter, progress)
    if filter.GetErrorMessage():
        raise ValueError(filter.GetErrorMessage())
    return filter


def doubts_of(output: vtkDataObject) -> list[Doubt]:
    """The warnings in the field data of any output of the filters, in the order they were found."""
    field = arrays(output)
    return [
        Doubt(code, field["WarningText"][i], int(field["WarningCount"][i]),
              tuple(field["WarningPlace"][i].tolist()) if field["WarningHasPlace"][i] else None,
              bool(field["WarningDoubtsSolid"][i]))
        for i, code in enumerate(field.get("WarningCode", []))]


def verdict_of(surface: vtkDataObject) -> Verdict:
    """The verdict in the field data of a surface, from the filters or from a file.

    Raises ValueError where it has none.
    """
    field = arrays(surface)
    if "Verdict" not in field:
        raise ValueError("there is no field array 'Verdict': take the output of vtkPowerCrust or vtkSimplifyShape")
    return Verdict(field["Verdict"] == ["certified"], field.get("VerdictReasons", []))


def arrays(data: vtkDataObject) -> dict[str, Any]:
    """The arrays of an output as numpy arrays that share its memory: by their names those of points,
    cells, rows and field (texts as lists of str); further "points" (n, 3), and of the polygons
    "offsets" and "corners": polygon i has the points corners[offsets[i]:offsets[i + 1]].
    """
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if data is None:  # VTK returns None where an output isn't of the kind that GetOutput() is for
        raise TypeError("there is no data; take GetOutputDataObject(port) of a filter, which also gives tables")
    result = {}
    for kind in range(vtkDataObject.NUMBER_OF_ATTRIBUTE_TYPES):
        attributes = data.GetAttributesAsFieldData(kind)
        for i in range(attributes.GetNumberOfArrays() if attributes else 0):
            array = attributes.GetAbstractArray(i)
            if isinstance(array, vtkStringArray):
                result[array.GetName()] = [
                    array.GetValue(k) for k in range(array.GetNumberOfValues())]
            else:
                result[array.GetName()] = vtk_to_numpy(array)
    if isinstance(data, vtkPointSet) and data.GetPoints():
        result["points"] = vtk_to_numpy(data.GetPoints().GetData())
    if isinstance(data, vtkPolyData):
        result["offsets"] = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
        result["corners"] = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    return result


def issues(result: Simplified, last: vtkDataObject) -> Iterable[str]:
    """The warnings in the last output, and that a surface is not certified."""
    for doubt in doubts_of(last):
        yield doubt.text
    if not result.verdict.certified:
        yield "the surface is not certified: " + "; ".join(result.verdict.reasons)


def update(filter: vtkAlgorithm, progress: Callable[[float], Any] | None = None) -> None:
    """Runs a filter on a thread of its own; other threads of Python go on, and Ctrl-C stops it."""
    work = vtkBackgroundUpdate()
    work.Start(filter)
    try:
        shown, pause = -1.0, 0.001
        while work.IsRunning():
            time.sleep(pause)
            pause = min(2 * pause, 0.02)
            done = work.GetProgress()
            if progress and done > shown:
                shown = done
                if progress(done) is False:
                    raise Stopped("simplify was stopped at %.0f %%" % (100 * done))
        if progress and shown < work.GetProgress():
            progress(work.GetProgress())
    finally:
        work.Stop()
        while work.IsRunning():
            time.sleep(0.001)


def _input(given: Any, spacing: Sequence[float], origin: Sequence[float]) -> vtkDataObject:
    import numpy

    if isinstance(given, (vtkPointSet, vtkImageData)):
        return given
    values = numpy.asarray(given)
    return _image(values, spacing, origin) if values.ndim == 3 else _cloud(values)


def _image(values: Any, spacing: Sequence[float], origin: Sequence[float]) -> vtkImageData:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk

    if values.dtype.kind not in "buif":
        raise ValueError("voxels of type %s; give numbers" % values.dtype)
    if values.dtype.kind == "b" or values.dtype == numpy.float16:
        values = values.astype(numpy.float32)  # VTK has no such types
    result = vtkImageData()
    result.SetDimensions(values.shape)
    result.SetSpacing(*spacing)
    result.SetOrigin(*origin)
    result.GetPointData().SetScalars(
        numpy_to_vtk(numpy.ascontiguousarray(values.ravel(order="F")), deep=True))
    return result


def _cloud(points: Any) -> vtkPolyData:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk

    given = numpy.asarray(points)
    isSingle = given.dtype == numpy.float32  # tells to what the coordinates were rounded
    coordinates = numpy.ascontiguousarray(given, dtype=given.dtype if isSingle else float)
    if coordinates.ndim != 2 or coordinates.shape[1] != 3:
        raise ValueError("points have the shape %s; give an array of shape (n, 3)"
                         % (coordinates.shape,))
    places = vtkPoints()
    places.SetData(numpy_to_vtk(coordinates, deep=True))
    result = vtkPolyData()
    result.SetPoints(places)
    return result


def _cleaned(given: vtkDataObject) -> vtkPolyData:
    from vtkmodules.util.misc import calldata_type
    from vtkmodules.util.vtkConstants import VTK_STRING

    if not isinstance(given, vtkPointSet):
        raise ValueError("clean is for points, not for voxels")
    errors = []

    @calldata_type(VTK_STRING)
    def note(_scan, _event, text):
        errors.append(text.strip())

    scan = vtkCleanScan()
    scan.AddObserver("ErrorEvent", note)
    scan.SetInputData(given)
    scan.Update()
    if errors:
        raise ValueError("; ".join(errors))
    return scan.GetOutput()


def _with_normals(given: vtkDataObject, normals: Any) -> vtkPointSet:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk

    if not isinstance(given, vtkPointSet):
        raise ValueError("normals are for points, not for voxels")
    values = numpy.ascontiguousarray(normals, dtype=float)
    if values.shape != (given.GetNumberOfPoints(), 3):
        raise ValueError("normals have the shape %s; give one for each of the %d points, of shape (n, 3)"
                         % (values.shape, given.GetNumberOfPoints()))
    result = given.NewInstance()
    result.ShallowCopy(given)
    array = numpy_to_vtk(values, deep=True)
    array.SetName("Normals")
    result.GetPointData().SetNormals(array)
    return result
