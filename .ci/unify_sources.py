#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prepares the core for clang-tidy, which spends its time on headers and would read them once for each source.

  .ci/unify_sources.py BUILD FOLDER

Writes one source for each stage of Filters/Core, which includes all sources of the stage, into FOLDER, with a
compile_commands.json made from that of BUILD. Sources that include CGAL stay alone: their headers are
the slow ones, and each has its own kernel. Prints the paths to check, the slowest first.

The analyzer follows the functions of included sources only if the including file is called UnifiedSource...
"""

import json
import pathlib
import sys

CORE = pathlib.Path(__file__).resolve().parent.parent / "Filters/Core"


def includes_cgal(path):
    return "#include <CGAL/" in path.read_text()


def compiled_sources(build):
    """The entries of compile_commands.json for the library of the core."""
    entries = json.loads((build / "compile_commands.json").read_text())
    found = {}
    for entry in entries:
        path = pathlib.Path(entry["file"])
        if CORE in path.parents and "medialCore.dir" in entry["command"]:
            found[path] = entry
    return found


def unified(stage, sources, entry, folder):
    """Writes a source that includes others, and returns its entry, made from that of one of them."""
    path = folder / ("UnifiedSource%s.cxx" % stage)
    # NOLINT: that sources are included is meant.
    path.write_text("".join('#include "%s" // NOLINT\n' % source for source in sources))
    return {"directory": entry["directory"], "file": str(path),
            "command": entry["command"].replace(entry["file"], str(path))}


def prepare(build, folder):
    compiled = compiled_sources(build)
    alone = [path for path in sorted(compiled) if includes_cgal(path)]
    entries = [compiled[path] for path in alone]
    for stage in sorted({path.parent.name for path in compiled}):
        sources = [path for path in sorted(compiled) if path.parent.name == stage and path not in alone]
        if sources:
            entries.append(unified(stage, sources, compiled[sources[0]], folder))
    (folder / "compile_commands.json").write_text(json.dumps(entries, indent=1))
    return [entry["file"] for entry in entries]


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    target = pathlib.Path(sys.argv[2]).resolve()
    target.mkdir(parents=True, exist_ok=True)
    print("\n".join(prepare(pathlib.Path(sys.argv[1]).resolve(), target)))
