#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the stub of a wrapped VTK module, from the signatures in its docstrings, for editors and type checkers.

  write_stubs.py MODULE FILE
"""

import importlib
import inspect
import re
import sys

HOMES = ["vtkmodules." + name
         for name in ("vtkCommonCore", "vtkCommonDataModel", "vtkCommonExecutionModel", "vtkIOCore")]


def signatures(method):
    """Each way to call a method, as Python wants it: "(self, port: int) -> None"."""
    text = re.sub(r"\n\s+", " ", method.__doc__)
    for call in re.findall(r"^\w+(\(.*\) -> .*)$", text, re.M):
        yield re.sub(r":(?=\S)", ": ", call)


def stub_of_method(name, method):
    calls = list(signatures(method))
    lines = []
    for call in calls:
        is_static = not call.startswith("(self")
        lines += ["    @overload"] * (len(calls) > 1) + ["    @staticmethod"] * is_static
        lines += ["    def %s%s: ..." % (name, call)]
    return lines


def stub_of_class(cls):
    """Enums are numbers; what VTK inherits is described by VTK."""
    lines = ["class %s(%s):" % (cls.__name__, cls.__mro__[1].__name__)]
    for name, value in vars(cls).items():
        if inspect.isclass(value):
            lines += ["    class %s(int): ..." % name]
        elif isinstance(value, int):
            lines += ["    %s: %s" % (name, type(value).__name__)]
        elif not name.startswith("_") and inspect.isroutine(value):
            lines += stub_of_method(name, value)
    return lines + [""]


def imports(text, known):
    """Where the classes in the text come from."""
    for home in HOMES:
        module = importlib.import_module(home)
        names = sorted(set(re.findall(r"\bvtk\w+", text)) - known)
        found = [name for name in names if hasattr(module, name)]
        known |= set(found)
        if found:
            yield "from %s import %s" % (home, ", ".join(found))
    for name in sorted(set(re.findall(r"\bvtk\w+", text)) - known):
        yield "%s = Any" % name


def main(module_name, path):
    module = importlib.import_module(module_name)
    classes = [value for value in vars(module).values() if inspect.isclass(value)]
    body = "\n".join("\n".join(stub_of_class(cls)) for cls in classes)
    header = ["from typing import Any, overload"]
    header += imports(body, {cls.__name__ for cls in classes})
    with open(path, "w") as file:
        file.write("\n".join(header) + "\n\n" + body)


main(*sys.argv[1:])
