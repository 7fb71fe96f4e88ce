# SPDX-License-Identifier: BSD-3-Clause
"""Tables of Testing/README.md that scripts write."""

import pathlib

README = pathlib.Path(__file__).resolve().parent.parent / "README.md"


def write(name, header, rows, files):
    """Puts rows, by their files, into the table of a name; keeps its rows of other files.

    rows   the new rows, each by the file that it begins with in backquotes
    files  all files that the table lists, in its order
    """
    begin, end = f"<!-- table of {name}: begin -->\n", f"<!-- table of {name}: end -->\n"
    before, found, rest = README.read_text().partition(begin)
    table, _, after = rest.partition(end)
    if not found:
        raise ValueError(f"{README} has no table of {name}")
    old = {line.split("`")[1]: line for line in table.splitlines(keepends=True) if line.startswith("| `")}
    lines = [rows.get(file) or old.get(file, "") for file in files]
    README.write_text(before + begin + "\n" + header + "".join(lines) + "\n" + end + after)
