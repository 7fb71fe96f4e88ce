#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the schedules with names leave of meshes, and what they move.

    PYTHONPATH=build/lib/python3/dist-packages Testing/Robustness/tabulate_presets.py [--write] MESH...

For each closed mesh, a .ply, .stl or .vtp: the parts before pruning; then of each schedule the parts left, and how far 99 %
of the samples and all are from the simplified surface, in mean spacings of the samples. --write puts the table into
Filters/README.md.
"""

import pathlib
import sys

from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from medialaxis import arrays, vtkMedialPrune, vtkSimplifyShape

import tables

READERS = {".ply": vtkPLYReader, ".stl": vtkSTLReader, ".vtp": vtkXMLPolyDataReader}
README = tables.HERE.parents[1] / "Filters" / "README.md"


def presets():
    """The names of all presets, in their order."""
    names = []
    while vtkMedialPrune.GetPresetName(len(names)):
        names.append(vtkMedialPrune.GetPresetName(len(names)))
    return names


def field(data, name):
    return float(arrays(data)[name][0])


def row(path):
    """A row of the table."""
    reader = READERS[path.suffix]()
    reader.SetFileName(str(path))
    chain = vtkSimplifyShape()
    chain.SetInputConnection(reader.GetOutputPort())
    cells = []
    for preset in presets():
        chain.SetSchedule(preset)
        chain.Update()
        surface, axis = chain.GetPowerCrust().GetOutput(), chain.GetMedialPrune().GetOutput()
        spacing = field(surface, "SampleSpacing")
        cells.append(f"{field(axis, 'NumberOfParts'):,.0f}: {field(surface, 'MovedBy') / spacing:.1f}, "
                     f"{field(surface, 'MovedAtMost') / spacing:.1f}")
    unpruned = chain.GetUnprunedPartDecomposition()
    unpruned.Update()
    parts = field(unpruned.GetOutput(), "NumberOfParts")
    return f"| {path.stem} | {parts:,.0f} | " + " | ".join(cells) + " |\n"


def main():
    paths = [pathlib.Path(word) for word in sys.argv[1:] if word != "--write"]
    if not paths:
        sys.exit(__doc__)
    header = "| mesh | parts | " + " | ".join(f"`{name}`" for name in presets()) + " |\n|---|--:|" + "--:|" * len(presets()) + "\n"
    print(header, end="")
    rows = {}
    for path in paths:
        rows[path.stem] = row(path)
        print(rows[path.stem], end="", flush=True)
    if "--write" in sys.argv:
        tables.write("presets", header, rows, [path.stem for path in paths], README)


if __name__ == "__main__":
    main()
