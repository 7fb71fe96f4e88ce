#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws time and memory against the number of samples, from the table of times in README.md.

    xvfb-run -a Testing/Benchmark/plot.py [scaling.png]

Both axes are logarithmic. Made inputs are lines, one for each shape; models are points. A horizontal line means that a
sample costs the same however many there are. Needs python3-vtk9 and an X server (xvfb-run will do).
"""

import collections
import pathlib
import sys

from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartMatrix
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable, vtkVector2i
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, draws the charts
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws their text

import benchmark

HERE = pathlib.Path(__file__).resolve().parent
MODELS = "models"
FIGURES = {"ms per 1000": "Time: CPU ms per 1000 samples", "kB per sample": "Memory: peak in kB per sample"}
COLORS = ((31, 119, 180), (255, 127, 14), (44, 160, 44), (214, 39, 40), (148, 103, 189), (140, 86, 75), (23, 190, 207),
          (0, 0, 0))


def number(cell):
    return float(cell.replace(",", ""))


def series_of(readme, figure):
    """For each shape, and for all models together: numbers of samples, ascending, and the figure for each."""
    result = collections.defaultdict(list)
    for line in readme.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not line.startswith("| ") or len(cells) != len(benchmark.COLUMNS) or not cells[1][:1].isdigit():
            continue
        row = dict(zip(benchmark.COLUMNS, cells))
        shape, _, count = row["input"].rpartition("_")
        name = shape if shape in benchmark.SHAPES and count.isdigit() else MODELS
        result[name].append((number(row["samples"]), number(row[figure])))
    return {name: sorted(points) for name, points in result.items()}


def table_of(name, points):
    table = vtkTable()
    for title, values in (("samples", [x for x, _ in points]), (name, [y for _, y in points])):
        array = vtkDoubleArray()
        array.SetName(title)
        for value in values:
            array.InsertNextValue(value)
        table.AddColumn(array)
    return table


def draw(chart, title, series):
    for color, (name, points) in zip(COLORS, series.items()):
        for kind in (vtkChart.LINE, vtkChart.POINTS) if name != MODELS else (vtkChart.POINTS,):
            plot = chart.AddPlot(kind)
            plot.SetInputData(table_of(name, points), 0, 1)
            plot.SetColor(*color, 255)
            plot.SetWidth(2 if kind == vtkChart.LINE else 7)
            plot.SetLegendVisibility(kind == vtkChart.LINE or name == MODELS)
    chart.SetTitle(title)
    chart.SetShowLegend(True)
    chart.GetLegend().SetVerticalAlignment(vtkChartLegend.TOP)
    chart.GetLegend().SetHorizontalAlignment(vtkChartLegend.LEFT)
    for place, label in ((vtkAxis.BOTTOM, "samples"), (vtkAxis.LEFT, "")):
        chart.GetAxis(place).SetTitle(label)
        chart.GetAxis(place).SetLogScale(True)


def main(picture):
    view = vtkContextView()
    view.GetRenderWindow().SetOffScreenRendering(True)
    view.GetRenderWindow().SetSize(1200, 550)
    view.GetRenderer().SetBackground(1, 1, 1)
    matrix = vtkChartMatrix()
    matrix.SetSize(vtkVector2i(len(FIGURES), 1))
    for i, (figure, title) in enumerate(FIGURES.items()):
        draw(matrix.GetChart(vtkVector2i(i, 0)), title, series_of(HERE / "README.md", figure))
    view.GetScene().AddItem(matrix)
    view.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(view.GetRenderWindow())
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(picture))
    writer.Write()


if __name__ == "__main__":
    if len(sys.argv) > 2 or sys.argv[1:2] == ["--help"]:
        sys.exit(__doc__)
    main(*(sys.argv[1:] or [HERE / "scaling.png"]))
