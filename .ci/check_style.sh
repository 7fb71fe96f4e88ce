#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# The rules of CONTRIBUTING.md that a machine can check. Prints what breaks one; silent otherwise.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mapfile -t sources < <(find Examples Filters ParaView Testing -name '*.cxx' -o -name '*.h' | sort)
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
  grep -nE '#[[:space:]]*include[[:space:]]*[<"]CGAL/' "${sources[@]}" |
    grep -vE '^Filters/Core/[A-Za-z]+/[A-Za-z]+\.cxx:' || true
}

vtk_in_core()
{
  grep -rnE '#[[:space:]]*include[[:space:]]*[<"]vtk' Filters/Core Testing/Core || true
}

loops_in_filters()
{
  grep -nE '\b(for|while)[[:space:]]*\(' Filters/vtk*.cxx || true
}

long_functions()
{
  ctags -x --language-force=C++ --c++-kinds=f --_xformat='%{input}:%{line} %{name} %{end}' \
    "${sources[@]}" |
    awk '{ split($1, at, ":"); if ($3 - at[2] + 1 > 60) print $1, $2, $3 - at[2] + 1, "lines" }'
}

not_ascii()
{
  LC_ALL=C grep -nP '[^\x00-\x7F]' "${sources[@]}" || true
}

without_licence()
{
  grep -L 'SPDX-License-Identifier: BSD-3-Clause' "${sources[@]}" || true
}

badly_formatted()
{
  local file
  for file in "${sources[@]}"; do
    clang-format-14 --style=file "$file" | cmp -s - "$file" ||
      printf '%s: run clang-format-14 -i %s\n' "$file" "$file"
  done
}

rule "CGAL is included by Filters/Core/*.cxx alone" cgal_outside_core
rule "the core knows no VTK" vtk_in_core
rule "filters contain no loops; they belong in Conversion or the core" loops_in_filters
rule "a function has at most 60 lines" long_functions
rule "sources are ASCII" not_ascii
rule "a source begins with its licence" without_licence
rule "sources are formatted by clang-format 14" badly_formatted
exit $broken
