#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The rules of CONTRIBUTING.md that a machine can check. Prints what breaks one; silent otherwise.
#
#   .ci/check_style.sh               checks the tree
#   .ci/check_style.sh --self-test   checks that each rule finds what breaks it
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ "${1:-}" != --self-test ] || exec /usr/bin/python3 .ci/test_check_style.py

folders=(Examples Filters ParaView Testing)
mapfile -t sources < <(find "${folders[@]}" -name '*.cxx' -o -name '*.h' | sort)
mapfile -t scripts < <(find "${folders[@]}" .ci -name '*.py' -o -name '*.sh' | sort)
broken=0

# Runs a check that prints what breaks the rule.
rule()
{
  local text=$1 lines
  lines=$("$2")
  if [ -n "$lines" ]; then
    printf 'Broken rule: %s\n%s\n' "$text" "$lines"
    broken=1
  fi
}

cgal_outside_core()
{
  grep -HnE '#[[:space:]]*include[[:space:]]*[<"]CGAL/' "${sources[@]}" |
    grep -vE '^(Filters/Core/[A-Za-z]+/[A-Za-z]+|Testing/Benchmark/Floor)\.cxx:' || true
}

vtk_in_core()
{
  grep -rnE '#[[:space:]]*include[[:space:]]*[<"]vtk' Filters/Core Testing/Core || true
}

loops_in_filters()
{
  grep -HnE '\b(for|while)[[:space:]]*\(' Filters/vtk*.cxx || true
}

# Definitions of these kinds (see `ctags --list-kinds=C++`) with more lines than allowed.
long_definitions()
{
  ctags -x --language-force=C++ --c++-kinds="$1" --_xformat='%{input}:%{line} %{name} %{end}' \
    "${sources[@]}" |
    awk -v most="$2" '{ split($1, at, ":"); lines = $3 - at[2] + 1 }
      lines > most { printf "%s: %s has %d lines\n", $1, $2, lines }'
}

long_functions() { long_definitions f 60; }

# Comments don't count: the declaration of a filter is mostly its documentation.
long_classes()
{
  local place name file lines begin
  long_definitions cs 200 | while read -r place name _ lines _; do
    file=${place%%:*} begin=${place#*:} begin=${begin%:}
    lines=$(tail -n "+$begin" "$file" | head -n "$lines" | grep -vcE '^[[:space:]]*(//|/?\*)' || true)
    [ "$lines" -le 200 ] || printf '%s %s has %d lines\n' "$place" "$name" "$lines"
  done
}

long_files()
{
  awk 'FNR > 400 { lines[FILENAME] = FNR }
    END { for (name in lines) printf "%s has %d lines\n", name, lines[name] }' \
    "${sources[@]}" "${scripts[@]}" | sort
}

later_stages() { .ci/check_includes.py stages; }

circles() { .ci/check_includes.py circles; }

folders_without_list() { .ci/check_includes.py folders; }

warnings_without_row() { .ci/check_warnings.py; }

stale_picture() { .ci/draw_stages.py --check; }

not_ascii()
{
  LC_ALL=C grep -HnP '[^\x00-\x7F]' "${sources[@]}" || true
}

without_licence()
{
  awk 'FNR == 1 && !/SPDX-License-Identifier: BSD-3-Clause/ { print FILENAME }' "${sources[@]}"
}

# Versions of clang-format differ: a release without ours checks all but the format.
badly_formatted()
{
  command -v clang-format-14 >/dev/null || { echo "The format is not checked: no clang-format-14." >&2; return 0; }
  clang-format-14 --style=file --dry-run --ferror-limit=1 "${sources[@]}" 2>&1 |
    sed -n 's/^\([^:]*\):.*should be clang-formatted.*/\1: run clang-format-14 -i \1/p' | sort -u
}

rule "CGAL is included by Filters/Core/*.cxx and Testing/Benchmark/Floor.cxx alone" cgal_outside_core
rule "the core knows no VTK" vtk_in_core
rule "filters contain no loops; they belong in Conversion or the core" loops_in_filters
rule "a stage of the core includes only itself and stages before it" later_stages
rule "includes form no circle" circles
rule "README.md and CMakeLists.txt of a stage name all that is in its folder" folders_without_list
rule "the table of Filters/README.md has all codes of warnings" warnings_without_row
rule "Filters/stages.svg is what .ci/draw_stages.py draws" stale_picture
rule "a function has at most 60 lines" long_functions
rule "a class has at most 200 lines without comments" long_classes
rule "a file has at most 400 lines" long_files
rule "sources are ASCII" not_ascii
rule "a source begins with its licence" without_licence
rule "sources are formatted by clang-format 14" badly_formatted
exit $broken
