#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks who includes whom in Filters/. Prints what breaks a rule; silent otherwise.

  check_includes.py stages    a stage of Filters/Core includes only itself and stages before it
  check_includes.py circles   no unit includes itself through others
  check_includes.py folders   a stage's README.md and CMakeLists.txt name all that is in its folder

A unit is X.h with X.cxx. The order of the stages is that of the list in Filters/Core/CMakeLists.txt.
"""

import collections
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent
FILTERS = TOP / "Filters"
CORE = FILTERS / "Core"

# Line `line` of `file` names `target`; both are paths of files.
Include = collections.namedtuple("Include", "file line text target")


def stages():
    """The stages' names, in the order of the data."""
    text = (CORE / "CMakeLists.txt").read_text()
    found = re.search(r"foreach\s*\(\s*stage\s+IN\s+ITEMS\s+([^)]*)\)", text)
    if not found:
        sys.exit("Filters/Core/CMakeLists.txt: no list of stages: foreach (stage IN ITEMS ...)")
    return found.group(1).split()


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".h", ".cxx"))


def short(path):
    return path.relative_to(TOP).as_posix()


def unit_of(path):
    return short(path.with_suffix(""))


def included_file(name, including):
    """The file of Filters/ that an include names, looked for as the compiler does; else None."""
    for folder in (including.parent, FILTERS, CORE):
        path = (folder / name).resolve()
        if path.is_file() and FILTERS in path.parents:
            return path
    return None


def includes(folder=FILTERS):
    """All includes in a folder that name a file of Filters/."""
    for file in sources(folder):
        for line, text in enumerate(file.read_text().splitlines(), 1):
            found = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', text)
            target = found and included_file(found.group(1), file)
            if target:
                yield Include(file, line, text.strip(), target)


def place(include):
    return "%s:%d: %s" % (short(include.file), include.line, include.text)


def stage_of(path):
    """The stage whose folder holds a file, or None."""
    return path.relative_to(CORE).parts[0] if CORE in path.parents else None


def check_stages():
    """Includes of the core that lead to a later stage, or out of the core; and sources whose functions are
    declared elsewhere, so that no include tells who uses them."""
    order = stages()
    yield from ("%s has no header of its name: nothing tells who uses it" % short(path)
                for path in sources(CORE) if not path.with_suffix(".h").is_file())
    for include in includes(CORE):
        here, there = stage_of(include.file), stage_of(include.target)
        if there is None:
            yield "%s  (the core includes nothing outside Filters/Core)" % place(include)
        elif here in order and there in order and order.index(there) > order.index(here):
            yield "%s  (%s comes before %s)" % (place(include), here, there)


def unit_graph():
    """For each unit the units it includes, each with one include that says so."""
    graph = collections.defaultdict(dict)
    for include in includes():
        here, there = unit_of(include.file), unit_of(include.target)
        if here != there:
            graph[here].setdefault(there, include)
    return graph


def shortest_circle(graph, start):
    """A shortest list of includes that leads from a unit back to it, or None. Breadth first."""
    came_by = {}
    queue = collections.deque([start])
    while queue:
        unit = queue.popleft()
        for following, include in graph.get(unit, {}).items():
            if following in came_by:
                continue
            came_by[following] = include
            queue.append(following)
            if following == start:
                return circle_back(came_by, start)
    return None


def circle_back(came_by, start):
    circle = [came_by[start]]
    while unit_of(circle[0].file) != start:
        circle.insert(0, came_by[unit_of(circle[0].file)])
    return circle


def check_circles():
    """Shortest circles first; a unit of a circle that is named already is not named again."""
    graph = unit_graph()
    circles = [circle for circle in (shortest_circle(graph, unit) for unit in sorted(graph)) if circle]
    named = set()
    for circle in sorted(circles, key=len):
        units = [unit_of(include.file) for include in circle]
        if named.isdisjoint(units):
            named.update(units)
            yield " -> ".join(units + units[:1])
            yield from ("  " + place(include) for include in circle)


def check_folder(folder):
    """What the README.md and the CMakeLists.txt of a stage's folder leave out."""
    files = {"README.md": [path.stem for path in sources(folder)],
             "CMakeLists.txt": [path.name for path in sources(folder) if path.suffix == ".cxx"]}
    for name, needed in files.items():
        path = folder / name
        if not path.is_file():
            yield "%s is missing" % short(path)
            continue
        words = set(re.findall(r"[\w.]*\w", path.read_text()))
        words |= {word.split(".")[0] for word in words}
        yield from ("%s doesn't name %s" % (short(path), item)
                    for item in sorted(set(needed)) if item not in words)
        yield from ("%s names %s, which isn't there" % (short(path), word) for word in sorted(words)
                    if re.fullmatch(r"\w+\.(h|cxx)", word) and not any(CORE.rglob(word)))


def check_folders():
    order = stages()
    for folder in sorted(path for path in CORE.iterdir() if path.is_dir()):
        if folder.name in order:
            yield from check_folder(folder)
        else:
            yield "%s is not in the list of stages in Filters/Core/CMakeLists.txt" % short(folder)
    yield from ("%s belongs in the folder of a stage" % short(path)
                for path in sources(CORE) if path.parent == CORE)


CHECKS = {"stages": check_stages, "circles": check_circles, "folders": check_folders}

if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in CHECKS:
        sys.exit(__doc__)
    for broken in CHECKS[sys.argv[1]]():
        print(broken)
