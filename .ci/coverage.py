#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tells which lines of Filters/ never ran in a build with --coverage.

  .ci/coverage.py BUILD [--under PERCENT]

Prints a row for each file, the best covered first, with the lines that never ran, and fails if fewer than PERCENT
of all lines ran. It reads what gcov prints as JSON. Debian's gcovr is no help here: GCC numbers the lines of some
headers one too low in some sources, gcovr stops at these, and with several jobs it waits for ever instead.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parent.parent


def counted_lines(data):
    """Pairs of file and line of one source, each with how often it ran; below 0 where threads counted at once."""
    run = subprocess.run(["gcov", "--json-format", "--stdout", data.name], cwd=data.parent, check=True,
                         capture_output=True, text=True)
    for document in run.stdout.splitlines():
        for file in json.loads(document)["files"]:
            path = pathlib.Path(data.parent, file["file"]).resolve()
            if TOP / "Filters" in path.parents:
                for line in file["lines"]:
                    yield path.relative_to(TOP), line["line_number"], line["count"]


def line_counts(build):
    """For each file, how often each of its lines ran in all sources together."""
    sources = sorted(build.rglob("*.gcno"))
    counts = collections.defaultdict(collections.Counter)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for lines in pool.map(lambda source: list(counted_lines(source)), sources):
            for path, line, count in lines:
                counts[path][line] += abs(count)
    return counts


def ranges(lines):
    """[3, 4, 5, 9] as "3-5,9"."""
    words = []
    for line in lines:
        if words and words[-1][1] == line - 1:
            words[-1][1] = line
        else:
            words.append([line, line])
    return ",".join("%d-%d" % (first, last) if first < last else str(first) for first, last in words)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--under", type=float, default=0)
    arguments = parser.parse_args()
    rows = []
    for path, lines in line_counts(arguments.build.resolve()).items():
        missing = sorted(line for line, count in lines.items() if count == 0)
        rows.append((len(missing) / len(lines), str(path), len(lines), missing))
    if not rows:
        sys.exit("%s has no data of a build with --coverage" % arguments.build)
    for share, path, count, missing in sorted(rows):
        print("%-60s %5d %4.0f %%  %s" % (path, count, 100 * (1 - share), ranges(missing)))
    total = sum(count for _, _, count, _ in rows)
    missing = sum(len(lines) for _, _, _, lines in rows)
    percent = 100 * (1 - missing / total)
    print("lines: %.1f %% (%d out of %d)" % (percent, total - missing, total))
    if percent < arguments.under:
        sys.exit("fewer than %g %% of the lines ran" % arguments.under)


if __name__ == "__main__":
    main()
