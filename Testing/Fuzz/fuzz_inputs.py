#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs SimplifyShape on damaged input files.

  Testing/Fuzz/fuzz_inputs.py build/bin/SimplifyShape --count 5000 --seed 1

Small solids are written in all formats and damaged: cut, bytes and lines changed, numbers replaced. The vertices
of meshes are the samples (--points), since sampling triangles takes long; in one run of eight, that of each seed
that eight divides, triangles are sampled as they are by default, and invalid points dropped. Each run must end within 10 s of work
with exit 0, 2 or 3, however busy the machine is. After exit 2 there is one line that says why. After exit 0 the
surface is closed and encloses a volume. Files that fail are kept, with the seed of each in its name.
With --sanitized, the program is built with AddressSanitizer: it may take five times as long and any memory.
"""

import argparse
import collections
import json
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLPolyDataWriter,
                                 vtkXMLUnstructuredGridWriter)

LONGEST = 10  # seconds of work
HANGING = 600  # seconds that pass
MEMORY = 3 << 30  # bytes; the files have some thousand


def sphere():
    """An octahedron divided twice, stretched: 66 points, 128 triangles."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(x, y, z) if (x + y + z) % 2 else (x, z, y)
             for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    for _ in range(2):
        middles = {}

        def middle(a, b):
            if (min(a, b), max(a, b)) not in middles:
                sum_ = numpy.add(points[a], points[b])
                middles[min(a, b), max(a, b)] = len(points)
                points.append(tuple(sum_ / numpy.linalg.norm(sum_)))
            return middles[min(a, b), max(a, b)]

        divided = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            divided += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = divided
    return numpy.array(points) * (1.0, 0.8, 0.65), faces


def box():
    """The grid points of a box's boundary, 98 of them, and its squares."""
    number, points, faces = {}, [], []

    def point(*place):
        if place not in number:
            number[place] = len(points)
            points.append(place)
        return number[place]

    for axis in range(3):
        for side in (0, 4):
            for u in range(4):
                for v in range(4):
                    corners = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)]
                    faces.append([point(*(c[:axis] + (side,) + c[axis:])) for c in corners])
    return numpy.array(points) * (0.5, 0.3, 0.25), faces


def text(rows, begin="", end="\n"):
    return "".join(begin + " ".join("%.9g" % value for value in row) + end for row in rows)


def ply(points, faces, kind, name):
    header = "ply\nformat %s 1.0\nelement vertex %d\n" % (kind, len(points))
    header += "".join("property %s %s\n" % (name, axis) for axis in "xyz")
    header += "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % len(faces)
    if kind == "ascii":
        return (header + text(points) + text(faces, "%d " % len(faces[0]))).encode()
    order = "<" if kind == "binary_little_endian" else ">"
    body = points.astype(order + ("f4" if name == "float" else "f8")).tobytes()
    for face in faces:
        body += bytes([len(face)]) + numpy.array(face, order + "i4").tobytes()
    return header.encode() + body


def stl(points, faces, is_text):
    triangles = [[points[face[0]], points[face[i]], points[face[i + 1]]]
                 for face in faces for i in range(1, len(face) - 1)]
    if is_text:
        facets = ["facet normal 0 0 0\nouter loop\n" + text(triangle, "vertex ") +
                  "endloop\nendfacet\n" for triangle in triangles]
        return ("solid s\n" + "".join(facets) + "endsolid s\n").encode()
    rows = numpy.zeros(len(triangles), "(3,)<f4, (3,3)<f4, <u2")
    rows["f1"] = triangles
    return b"binary".ljust(80) + numpy.array([len(triangles)], "<u4").tobytes() + rows.tobytes()


def xml(points, faces, writer_class, mode):
    """mode: 0 text, 1 base64, 2 appended, 3 appended raw; the last three are compressed."""
    data = vtkPolyData() if writer_class is vtkXMLPolyDataWriter else vtkUnstructuredGrid()
    own = vtkPoints()
    own.SetData(numpy_to_vtk(points, deep=1))
    data.SetPoints(own)
    cells = vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), face)
    if isinstance(data, vtkPolyData):
        data.SetPolys(cells)
    else:
        data.SetCells(7, cells)
    writer = writer_class()
    writer.SetInputData(data)
    writer.WriteToOutputStringOn()
    writer.SetDataMode(min(mode, 2))
    writer.SetEncodeAppendedData(mode == 2)
    writer.Write()
    result = writer.GetOutputString()
    return result if isinstance(result, bytes) else result.encode("utf-8", "surrogateescape")


def originals():
    """Pairs of an extension and the bytes of a whole file."""
    files = []
    for points, faces in (sphere(), box()):
        for kind in ("ascii", "binary_little_endian", "binary_big_endian"):
            files += [(".ply", ply(points, faces, kind, name)) for name in ("float", "double")]
        files += [(".stl", stl(points, faces, is_text)) for is_text in (True, False)]
        corners = [[index + 1 for index in face] for face in faces]
        files.append((".obj", (text(points, "v ") + text(corners, "f ")).encode()))
        counts = "OFF\n%d %d 0\n" % (len(points), len(faces))
        files.append((".off", (counts + text(points) +
                               text(faces, "%d " % len(faces[0]))).encode()))
        files.append((".xyz", text(points).encode()))
        files.append((".xyz", ("%d\n" % len(points) + text(points)).encode()))
        for mode in range(3):
            files.append((".vtp", xml(points, faces, vtkXMLPolyDataWriter, mode)))
            files.append((".vtu", xml(points, faces, vtkXMLUnstructuredGridWriter, mode)))
    return files


NUMBERS = [b"0", b"-1", b"1", b"3", b"255", b"65536", b"2147483647", b"4294967295", b"99999999999999",
           b"18446744073709551616", b"1e300", b"-1e-300", b"nan", b"inf", b"0,5", b"zz", b"", b"1e5"]


def cut(data, rng):
    return data[:rng.randrange(len(data))]


def junk(data, rng):
    """Some bytes become others, near to each other."""
    data, at = bytearray(data), rng.randrange(len(data))
    for _ in range(rng.choice((1, 1, 4, 30))):
        data[min(len(data) - 1, at + rng.randrange(40))] = rng.randrange(256)
    return bytes(data)


def flip(data, rng):
    data = bytearray(data)
    data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    return bytes(data)


def move(data, rng):
    """A piece is left out, repeated, or put elsewhere."""
    begin = rng.randrange(len(data))
    piece = data[begin:begin + rng.choice((1, 4, 50, 500))]
    rest = data[:begin] + data[begin + len(piece):]
    at = rng.randrange(len(rest) + 1)
    return rng.choice((rest, data[:at] + piece + data[at:], rest[:at] + piece + rest[at:]))


def change_number(data, rng):
    """A number becomes another one, in the header more often than elsewhere."""
    limit = rng.choice((200, 1500, len(data)))
    starts = [i for i in range(min(limit, len(data)))
              if data[i:i + 1].isdigit() and not data[i - 1:i].isalnum()]
    if not starts:
        return junk(data, rng)
    begin = end = rng.choice(starts)
    while data[end:end + 1].isdigit():
        end += 1
    return data[:begin] + rng.choice(NUMBERS) + data[end:]


def change_word(data, rng):
    """A word of the beginning becomes another one of it."""
    words = data[:1500].split()
    old, new = rng.choice(words), rng.choice(words)
    return data.replace(old, new, rng.choice((1, 1, -1)))


def change_lines(data, rng):
    """A line is left out, doubled, or changes places with another one."""
    lines = data.split(b"\n")
    i, k = rng.randrange(min(len(lines), 30)), rng.randrange(len(lines))
    choice = rng.randrange(3)
    if choice == 0:
        del lines[i]
    elif choice == 1:
        lines.insert(i, lines[i])
    else:
        lines[i], lines[k] = lines[k], lines[i]
    return b"\n".join(lines)


CHANGES = (cut, junk, flip, move, change_number, change_number, change_word, change_lines)


def damaged(files, seed):
    rng = random.Random(seed)
    extension, data = rng.choice(files)
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        data = rng.choice(CHANGES)(data, rng) if data else data
    return extension, data


def surface_fault(folder):
    """What is wrong with surface.vtp, or None."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(folder, "surface.vtp"))
    reader.Update()
    surface = reader.GetOutput()
    if surface.GetNumberOfPolys() == 0:
        return "empty"
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    edges = collections.Counter()
    for a, b, c in triangles.tolist():
        for p, q in ((a, b), (b, c), (c, a)):
            edges[p, q] += 1
            edges[q, p] -= 1
    if any(edges.values()):
        return "not closed"
    corners = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    corners = (corners - corners.mean(axis=0))[triangles]
    corners /= numpy.abs(corners).max()
    volume = numpy.linalg.det(corners).sum()
    return None if volume > 0 else "no volume"


def limit(sanitized):
    """For a child: no more memory and work than this. AddressSanitizer reserves all addresses there are."""
    if sanitized:
        resource.setrlimit(resource.RLIMIT_CPU, (5 * LONGEST, 5 * LONGEST))
    else:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))


def work():
    """Seconds that all children have worked."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def options_of(seed):
    """The options of a run, see above."""
    return ["--points"] if seed % 8 else ["--drop-invalid"]


def require_start(program):
    """Else a program that can't start, as one that misses a library, would look like one with odd faults."""
    try:
        done = subprocess.run([program, "--help"], stdin=subprocess.DEVNULL, capture_output=True, check=False)
        said = done.stderr.decode(errors="replace").strip()
    except OSError as error:
        sys.exit("%s does not start: %s" % (program, error))
    if done.returncode != 0 or b"--points" not in done.stdout:
        sys.exit("%s does not start: exit %d %s" % (program, done.returncode, said))


def run(program, file, folder, sanitized, how):
    """Runs the program with options; returns what happened and whether it is a fault."""
    begin, longest = work(), 5 * LONGEST if sanitized else LONGEST
    try:
        done = subprocess.run(
            [program, file, "--output", folder, "--quiet", "--strict", "--threads", "1", *how],
            stdin=subprocess.DEVNULL, capture_output=True, timeout=HANGING, check=False,
            preexec_fn=lambda: limit(sanitized))
    except subprocess.TimeoutExpired:
        return "hangs", True
    if done.returncode < 0 and work() - begin > longest - 0.5:
        return "longer than %d s" % longest, True
    if done.returncode not in (0, 2, 3):
        sys.stdout.write(done.stderr.decode(errors="replace"))
        return "exit %d" % done.returncode, True
    if done.returncode == 2:
        if work() - begin > longest / 2:
            return "slow to refuse", True
        if done.stderr.count(b"\n") != 1 or not done.stderr.startswith(b"SimplifyShape: "):
            return "exit 2 without one line", True
        if b"not enough memory" in done.stderr:
            return "memory without need", True
    if done.returncode == 0:
        fault = surface_fault(folder)
        if fault:
            return fault, True
        with open(os.path.join(folder, "report.json")) as file:
            json.load(file)
    return "exit %d" % done.returncode, False


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=500, help="runs (default: 500)")
    parser.add_argument("--seed", type=int, default=1, help="of the first run; the next has the next")
    parser.add_argument("--keep", default="fuzz-inputs", help="folder for the files that fail")
    parser.add_argument("--sanitized", action="store_true", help="the program has AddressSanitizer")
    parser.add_argument("--formats", default="", help="only these, as in .vtp,.vtu")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    counts, failed = collections.Counter(), []
    files = [pair for pair in originals() if pair[0] in (options.formats or pair[0])]
    require_start(program)
    with tempfile.TemporaryDirectory() as folder:
        for extension, data in files:  # undamaged
            file, out = os.path.join(folder, "input" + extension), os.path.join(folder, "out")
            with open(file, "wb") as stream:
                stream.write(data)
            what, is_fault = run(program, file, out, options.sanitized, options_of(1))
            if is_fault or what == "exit 2":
                sys.exit("A whole %s file fails: %s" % (extension, what))
        for seed in range(options.seed, options.seed + options.count):
            extension, data = damaged(files, seed)
            file, out = os.path.join(folder, "input" + extension), os.path.join(folder, "out")
            with open(file, "wb") as stream:
                stream.write(data)
            what, is_fault = run(program, file, out, options.sanitized, options_of(seed))
            shutil.rmtree(out, ignore_errors=True)
            counts[extension, what] += 1
            if is_fault:
                os.makedirs(options.keep, exist_ok=True)
                kept = os.path.join(options.keep, "%d%s" % (seed, extension))
                shutil.copy(file, kept)
                failed.append(kept)
                print("%s: %s" % (kept, what), flush=True)
    for (extension, what), count in sorted(counts.items()):
        print("%-5s %-28s %6d" % (extension, what, count))
    print("%d runs from seed %d: %d faults" % (options.count, options.seed, len(failed)))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
