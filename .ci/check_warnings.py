#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the codes of warnings in the core with the table of Filters/README.md. Prints what is in one of
them alone.

A code is the word in quotes with which a list in braces begins, or that is assigned to `code`, in a source
that makes warnings:  { "noise", text(...), ...   or   warning.code = "gaps";
"""

import pathlib
import re

TOP = pathlib.Path(__file__).resolve().parent.parent
README = TOP / "Filters/README.md"
CODE = re.compile(r'(?:\{\s*|\bcode = )"([a-z]+(?:[_-][a-z]+)*)"\s*[,;]')


def codes_of_sources():
    """For each code a source that has it."""
    result = {}
    for path in sorted((TOP / "Filters/Core").rglob("*.cxx")):
        text = path.read_text()
        if re.search(r"\bWarnings?\b", text):
            result.update(dict.fromkeys(CODE.findall(text), path.relative_to(TOP).as_posix()))
    return result


def codes_of_table():
    """Those of the rows of the table whose head begins with "code"."""
    text = README.read_text() if README.is_file() else ""
    table = re.search(r"^\| code \|.*\n\|[-|]*\n((?:\|.*\n)*)", text, re.M)
    return set(re.findall(r"^\| `([^`]*)` \|", table.group(1), re.M)) if table else set()


if __name__ == "__main__":
    sources, rows = codes_of_sources(), codes_of_table()
    for code in sorted(set(sources) - rows):
        print("%s: Filters/README.md has no row for the warning %s" % (sources[code], code))
    for code in sorted(rows - set(sources)):
        print("Filters/README.md: nothing warns of %s" % code)
