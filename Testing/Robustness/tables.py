# SPDX-License-Identifier: BSD-3-Clause
"""Tables of Testing/README.md that scripts write."""

import csv
import fnmatch
import multiprocessing.pool
import os
import pathlib
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
README = HERE.parent / "README.md"


def in_words(betti):
    """Pieces, tunnels and voids, or - if they are unknown."""
    return " ".join(str(int(number)) for number in betti) if betti else "-"


def key_of(line):
    """What the first cell of a row says."""
    return line.split("|")[1].strip(" `")


def write(name, header, rows, keys, readme=README):
    """Puts rows, by their first cells, into the table of a name; keeps its other rows.

    rows    the new rows
    keys    the first cells of all rows, in the table's order
    readme  the file that has the table
    """
    begin, end = f"<!-- table of {name}: begin -->\n", f"<!-- table of {name}: end -->\n"
    before, found, rest = readme.read_text().partition(begin)
    table, _, after = rest.partition(end)
    if not found:
        raise ValueError(f"{readme} has no table of {name}")
    old = {key_of(line): line for line in table.splitlines(keepends=True) if line.startswith("|")}
    lines = [rows.get(key) or old.get(key, "") for key in keys]
    readme.write_text(before + begin + "\n" + header + "".join(lines) + "\n" + end + after)


def tabulate(usage, name, header, right, row, what_fine):
    """The main function of a script that runs a program on files: PROGRAM DATA [--write] [PATTERN ...]

    right      the .csv file beside this one that has the column file and what is right for each
    row        a function of program, folder of data and row of that file that returns a row of the table,
               and whether it is as it must be
    what_fine  the words for that
    """
    arguments = [word for word in sys.argv[1:] if word != "--write"]
    if len(arguments) < 2:
        sys.exit(usage)
    program, data, *patterns = arguments
    with open(HERE / right, newline="", encoding="utf-8") as file:
        entries = list(csv.DictReader(file))
    chosen = [entry for entry in entries
              if not patterns or any(fnmatch.fnmatch(entry["file"], p) for p in patterns)]

    def timed(entry):
        begin = time.monotonic()
        return *row(program, pathlib.Path(data), entry), time.monotonic() - begin

    rows, failures = {}, 0
    with multiprocessing.pool.ThreadPool(os.cpu_count()) as pool:
        for entry, (line, fine, seconds) in zip(chosen, pool.imap(timed, chosen)):
            print(f"{seconds:6.1f} s {line}", end="", flush=True)
            rows[entry["file"]] = line
            failures += not fine
    print(f"{len(rows) - failures} of {len(rows)} {what_fine}")
    if "--write" in sys.argv:
        write(name, header, rows, [entry["file"] for entry in entries])
    sys.exit(failures > 0)
