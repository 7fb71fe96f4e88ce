#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the two programs of README.md with the installed package.

  .ci/check_readme.py README.md PREFIX SCRATCH
"""

import glob
import math
import os
import re
import subprocess
import sys

readme, prefix, scratch = map(os.path.abspath, sys.argv[1:])


def program(language):
    """The first block of code in this language."""
    with open(readme) as file:
        return re.search("```" + language + "\n(.*?)```", file.read(), re.S).group(1)


def write(name, text):
    with open(os.path.join(scratch, name), "w") as file:
        file.write(text)


def run(*command, **environment):
    subprocess.run(command, cwd=scratch, env={**os.environ, **environment}, check=True)


def write_bunny(count=1200):
    """Not quite a bunny: an ellipsoid, in the file that the programs read."""
    lines = ["ply", "format ascii 1.0", "element vertex %d" % count]
    lines += ["property float %s" % axis for axis in "xyz"] + ["end_header"]
    golden = math.pi * (3 - math.sqrt(5))
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        r = math.sqrt(1 - z * z)
        lines.append("%.9g %.9g %.9g" % (r * math.cos(golden * i), 0.7 * r * math.sin(golden * i),
                                         0.5 * z))
    write("bunny.ply", "\n".join(lines) + "\n")


def check_python():
    package, = glob.glob(prefix + "/lib/**/medialaxis", recursive=True)
    write("program.py", program("python") +
          "assert surface.GetOutput().GetNumberOfCells() > 1000\n")
    run("/usr/bin/python3", "program.py", PYTHONPATH=os.path.dirname(package))


def check_cxx():
    body = program("cpp")
    headers = sorted(set(re.findall(r"vtkNew<(\w+)>", body)) | {"vtkNew", "vtkPolyData"})
    write("program.cxx", "".join("#include <%s.h>\n" % header for header in headers) +
          "int main()\n{\n" + body + "return surface->GetOutput()->GetNumberOfCells() < 1000;\n}\n")
    write("CMakeLists.txt", """cmake_minimum_required(VERSION 3.18)
project(Readme LANGUAGES C CXX)
find_package(MedialAxis REQUIRED)
find_package(VTK REQUIRED COMPONENTS IOPLY)
add_executable(program program.cxx)
target_compile_features(program PRIVATE cxx_std_17)
target_link_libraries(program PRIVATE VTK::FiltersMedial VTK::IOPLY)
""")
    run("cmake", "-S", ".", "-B", ".", "-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + prefix,
        "--log-level=ERROR")
    run("cmake", "--build", ".")
    run("./program")


os.makedirs(scratch, exist_ok=True)
write_bunny()
check_python()
check_cxx()
