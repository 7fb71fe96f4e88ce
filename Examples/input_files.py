# SPDX-License-Identifier: BSD-3-Clause
"""Files of points and meshes, as text or bytes, for the checks of SimplifyShape."""

import itertools
import struct

XYZ = "property double x\nproperty double y\nproperty double z\n"
FACES = "property list uchar int vertex_indices\n"


def rows(points, separator=" ", end="\n"):
    return "".join(separator.join("%.17g" % c for c in point) + end for point in points)


def ply_header(elements, kind="ascii", end="\n"):
    """The header for (name, number of rows, properties)."""
    text = "ply\nformat %s 1.0\ncomment made by a test\n" % kind
    for name, count, properties in elements:
        text += "element %s %s\n%s" % (name, count, properties)
    return (text + "end_header\n").replace("\n", end)


def ascii_ply(count, body, properties=XYZ, more=()):
    return ply_header([("vertex", count, properties), *more]) + body


def binary_ply(byte_order, letter, points, count=None, more=(), tail=b"", end="\n"):
    """byte_order: as in struct, < or >; letter: f or d."""
    name = {"f": "float", "d": "double"}[letter]
    kind = {"<": "binary_little_endian", ">": "binary_big_endian"}[byte_order]
    vertex = ("vertex", len(points) if count is None else count, XYZ.replace("double", name))
    body = b"".join(struct.pack(byte_order + "3" + letter, *point) for point in points)
    return ply_header([vertex, *more], kind, end).encode() + body + tail


def binary_stl(triangles, count=None, text=b"solid made by a test"):
    return text.ljust(80) + struct.pack("<I", len(triangles) if count is None else count) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0) for a, b, c in triangles)


def ascii_stl(triangles):
    text = "solid made by a test\n"
    for triangle in triangles:
        text += "facet normal 0 0 0\n outer loop\n"
        text += "".join("  vertex " + row + "\n" for row in rows(triangle).splitlines())
        text += " endloop\nendfacet\n"
    return text + "endsolid\n"


def xml(kind, points, numbers=None, cells=(), count=None, components="3", number="Float64"):
    """A .vtp (PolyData) or .vtu (UnstructuredGrid) file as text.

    numbers, count  what it announces of points and cells
    """
    def array(type_, name, text="", more=""):
        return '<DataArray type="%s" Name="%s" format="ascii"%s>%s</DataArray>' % (
            type_, name, more, text)

    def texts(values):
        return " ".join("%d" % value for value in values)

    ends = itertools.accumulate(len(cell) for cell in cells)
    return ('<?xml version="1.0"?><VTKFile type="{0}" version="0.1"><{0}><Piece NumberOfPoints="{1}" '
            'NumberOfCells="{2}" NumberOfPolys="{2}"><Points>{3}</Points><{4}>{5}</{4}></Piece></{0}>'
            '</VTKFile>').format(
                kind, len(points) if numbers is None else numbers,
                len(cells) if count is None else count,
                array(number, "Points", rows(points), ' NumberOfComponents="%s"' % components),
                "Polys" if kind == "PolyData" else "Cells",
                array("Int64", "connectivity", texts(itertools.chain(*cells))) +
                array("Int64", "offsets", texts(ends)) +
                array("UInt8", "types", texts(7 for _ in cells)))


def triples(points):
    """Triangles with all the points as corners."""
    return [(points[i], points[i + 1], points[i + 2]) for i in range(len(points) - 2)]
