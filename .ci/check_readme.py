#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the two programs of README.md with the installed package.

  .ci/check_readme.py README.md PREFIX SCRATCH

What is installed in /usr has to be found without being told where.
"""

import glob
import os
import re
import subprocess
import sys

readme, prefix, scratch = map(os.path.abspath, sys.argv[1:])
is_told_where = prefix != "/usr"


def program(language):
    """The first block of code in this language."""
    with open(readme) as file:
        return re.search("```" + language + "\n(.*?)```", file.read(), re.S).group(1)


def write(name, text):
    with open(os.path.join(scratch, name), "w") as file:
        file.write(text)


def run(*command, **environment):
    subprocess.run(command, cwd=scratch, env={**os.environ, **environment}, check=True)


def write_part():
    """A box, in the file that the programs read."""
    corners = [(x, 2 * y, 3 * z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    triangles = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7),
                 (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    lines = ["solid box"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex %d %d %d" % corners[corner] for corner in triangle]
        lines += ["endloop", "endfacet"]
    write("part.stl", "\n".join(lines) + "\nendsolid box\n")


def check_python():
    write("program.py", program("python") +
          "assert surface.GetOutput().GetNumberOfCells() > 1000\n")
    package, = glob.glob(prefix + "/lib/**/medialaxis", recursive=True)
    where = {"PYTHONPATH": os.path.dirname(package)} if is_told_where else {}
    run("/usr/bin/python3", "program.py", **where)


def check_cxx():
    body = program("cpp")
    headers = sorted(set(re.findall(r"vtkNew<(\w+)>", body)) | {"vtkNew", "vtkPolyData"})
    write("program.cxx", "".join("#include <%s.h>\n" % header for header in headers) +
          "int main()\n{\n" + body + "return surface->GetOutput()->GetNumberOfCells() < 1000;\n}\n")
    write("CMakeLists.txt", """cmake_minimum_required(VERSION 3.18)
project(Readme LANGUAGES CXX)
find_package(MedialAxis REQUIRED)
find_package(VTK REQUIRED COMPONENTS IOGeometry)
add_executable(program program.cxx)
target_compile_features(program PRIVATE cxx_std_17)
target_link_libraries(program PRIVATE VTK::FiltersMedial VTK::IOGeometry)
""")
    where = ["-DCMAKE_PREFIX_PATH=" + prefix] if is_told_where else []
    run("cmake", "-S", ".", "-B", ".", "-G", "Ninja", "--log-level=ERROR", *where)
    run("cmake", "--build", ".")
    run("./program")


os.makedirs(scratch, exist_ok=True)
write_part()
check_python()
check_cxx()
