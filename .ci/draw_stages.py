#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws Filters/stages.svg: the stages, their folders, and the data between them.

  draw_stages.py           writes the picture
  draw_stages.py --check   says whether the picture is out of date

The folders' files, the order of the stages and who includes whom are read from the tree. Written here is
only what a stage takes and gives; the filters and arrays named must exist.
"""

import collections
import re
import sys
import textwrap
from xml.sax.saxutils import escape

from check_includes import CORE, FILTERS, includes, sources, stage_of, stages

PICTURE = FILTERS / "stages.svg"

Stage = collections.namedtuple("Stage", "does filter gives arrays")

FLOW = {
    "Images": Stage("cleans the voxels of a solid; VTK meshes them", "vtkImageBoundary", "mesh",
                    ["BettiSegmentation", "FilledCavities"]),
    "Samples": Stage("samples the surface of a solid", "vtkBoundarySamples", "samples",
                     ["Normals", "Spacing", "SourceCell"]),
    "Balls": Stage("finds the balls inside and outside", "vtkPolarBalls", "balls",
                   ["Radius", "Side", "Volume"]),
    "Axis": Stage("builds the medial axis from the inner balls", "vtkMedialAxis", "medial axis",
                  ["BallId", "Radius", "ErosionThickness"]),
    "Parts": Stage("divides the axis into parts and measures them", "vtkMedialPartDecomposition",
                   "parts", ["PartId", "PartLevel", "RelativeVolume"]),
    "Pruning": Stage("removes insignificant parts", "vtkMedialPrune", "pruned axis",
                     ["PartId", "KeepReason"]),
    "Crust": Stage("builds the surface around the kept balls", "vtkPowerCrust", "surface",
                   ["PartId", "InnerBall", "OuterBall"]),
    "Measuring": Stage("traces the middle of rods", "vtkMedialCenterlines", "curves", ["BranchId"]),
}
FOUNDATION = "Base"  # holds what all stages share, and takes no part in the flow
FIRST_DATA, LAST_DATA = "image", "curves"
SECOND_INPUT = "balls"  # of the last stage but one

WIDTH, LEFT, BOX, LINE = 810, 20, 710, 18
GAP = 64  # between two boxes, for the data


def text(x, y, words, style="", anchor="start"):
    return '<text x="%d" y="%d" text-anchor="%s" %s>%s</text>' % (x, y, anchor, style, escape(words))


def box_of(name, does, right, included, y):
    """The box of a stage: the lines of SVG, and its height."""
    units = sorted({path.stem for path in sources(CORE / name)})
    lines = textwrap.wrap(", ".join(units), 92)
    height = 58 + LINE * len(lines)
    svg = ['<rect x="%d" y="%d" width="%d" height="%d" rx="6" class="stage"/>' % (LEFT, y, BOX, height),
           text(LEFT + 14, y + 24, name, 'class="name"'),
           text(LEFT + 100, y + 24, does),
           text(LEFT + BOX - 14, y + 24, right, 'class="code"', "end")]
    svg += [text(LEFT + 14, y + 46 + LINE * i, line, 'class="code"') for i, line in enumerate(lines)]
    bottom = y + height - 12
    svg.append(text(LEFT + 14, bottom, "Filters/Core/%s" % name, 'class="note"'))
    if included:
        svg.append(text(LEFT + BOX - 14, bottom, "includes " + ", ".join(included), 'class="note"', "end"))
    return svg, height


def pill(x, y, width, words):
    return ['<rect x="%d" y="%d" width="%d" height="26" rx="13" class="data"/>' % (x - width // 2, y - 13, width),
            text(x, y + 5, words, 'class="name"', "middle")]


def arrow(path):
    return ['<path d="%s" class="flow" marker-end="url(#head)"/>' % path]


def data_at(y, name, arrays=()):
    """The data between two boxes, the first of which ends at y."""
    x = LEFT + 120
    svg = arrow("M %d %d V %d" % (x, y, y + 12)) if name != FIRST_DATA else []
    svg += arrow("M %d %d V %d" % (x, y + 41, y + GAP - 3)) if name != LAST_DATA else []
    if arrays:
        svg.append(text(x + 74, y + 33, "arrays " + ", ".join(arrays) + " ...", 'class="note"'))
    return svg + pill(x, y + 28, 120, name)


def second_input(start, end):
    """The way of the balls past the stages that don't take them."""
    x = LEFT + BOX + 35
    svg = arrow("M %d %d H %d V %d H %d" % (LEFT + BOX, start, x, end, LEFT + BOX + 3))
    return svg + pill(x, (start + end) // 2, 60, SECOND_INPUT)


def rooms_included():
    """For each stage the other stages that it includes, in order."""
    order = stages()
    pairs = {(stage_of(include.file), stage_of(include.target)) for include in includes(CORE)}
    return {name: [other for other in order if (name, other) in pairs and other != name] for name in order}


def check_names():
    tables = [FILTERS / "Conversion" / "ArrayNames.h", *CORE.glob("Parts/Measures.cxx")]
    arrays = "".join(table.read_text() for table in tables)
    for stage in FLOW.values():
        if not (FILTERS / (stage.filter + ".h")).is_file():
            sys.exit(".ci/draw_stages.py names %s, which isn't there" % stage.filter)
        for name in stage.arrays:
            if not re.search(r'"%s"' % name, arrays):
                sys.exit(".ci/draw_stages.py names the array %s, which isn't there" % name)


def drawing():
    order = stages()
    if order != [FOUNDATION] + list(FLOW):
        sys.exit(".ci/draw_stages.py knows other stages than Filters/Core/CMakeLists.txt: %s" % " ".join(order))
    check_names()
    included = rooms_included()
    body, middles = data_at(0, FIRST_DATA), {}
    y = GAP
    for name, stage in FLOW.items():
        svg, height = box_of(name, stage.does, stage.filter, included[name], y)
        middles[stage.gives] = y + height // 2
        y += height
        body += svg + data_at(y, stage.gives, stage.arrays)
        y += GAP
    body += second_input(middles[SECOND_INPUT], middles["surface"])
    svg, height = box_of(FOUNDATION, "holds what all stages share", "", included[FOUNDATION], y)
    return page(body + svg, y + height + 20)


def page(body, height):
    head = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}">
<!-- Written by .ci/draw_stages.py -->
<style>
text {{ font: 14px sans-serif; fill: #1f2933 }}
.name {{ font-weight: bold }}
.code {{ font: 12px monospace }}
.note {{ font-size: 12px; fill: #52606d }}
.stage {{ fill: #eaf1fb; stroke: #3a6ea5 }}
.data {{ fill: #fff3cf; stroke: #b8860b }}
.flow {{ fill: none; stroke: #1f2933; stroke-width: 1.5 }}
</style>
<defs><marker id="head" markerWidth="9" markerHeight="8" refX="7" refY="4" orient="auto">
<path d="M 0 0 L 8 4 L 0 8 z" fill="#1f2933"/></marker></defs>
<rect width="100%" height="100%" fill="#ffffff"/>
"""
    return head.format(WIDTH, height) + "\n".join(body) + "\n</svg>\n"


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        if not PICTURE.is_file() or PICTURE.read_text() != drawing():
            print("Filters/stages.svg is out of date: run .ci/draw_stages.py")
    elif len(sys.argv) == 1:
        PICTURE.write_text(drawing())
    else:
        sys.exit(__doc__)
