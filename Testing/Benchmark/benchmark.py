#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the core's whole chain on made inputs and on models.

    Testing/Benchmark/benchmark.py build/bin/benchmark_chain [MODELS ...]
        [--only PATTERN ...] [--runs N] [--threads N] [--timeout S] [--json FILE] [--before FILE] [--write]

MODELS are .ply and .vtp files, whose points are the samples, or folders of them. Each input is run 5 times, in
turn with the others, and medians are printed. --only takes those inputs whose name fits a pattern, such as 'torus*' or
'*_1000000', which is left out otherwise. --json keeps all figures; --before names such a file of another build, and
tells how much time is needed now for 1 s then, and whether the results are the same to the last bit. --write puts the
table into README.md beside this script.
"""

import argparse
import fnmatch
import json
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "Robustness"))
import tables  # noqa: E402

SHAPES = ("bumpy_sphere", "bone", "slab", "slab_in_x", "torus", "capsule", "tube")
COUNTS = (1000, 10000, 50000, 1000000)
STAGES = ("balls", "axis", "parts", "pruning", "crust of all balls", "crust after pruning")
COLUMNS = ("input", "samples", "floor s", "chain / floor", *STAGES, "other threshold", "ms per 1000", "kB per sample")
HEADER = "| " + " | ".join(COLUMNS) + " |\n|---" + "|--:" * (len(COLUMNS) - 1) + "|\n"


def points_of(path):
    """The points of a model, as the program reads them."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = {".ply": vtkPLYReader, ".vtp": vtkXMLPolyDataReader}[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype("float64").tobytes()


def inputs(models):
    """For each input by its name: arguments of the program, and a function that makes its standard input."""
    result = {f"{shape}_{count}": ((shape, str(count)), bytes) for shape in SHAPES for count in COUNTS}
    for path in models:
        for file in sorted(path.iterdir()) if path.is_dir() else [path]:
            if file.suffix in (".ply", ".vtp"):
                result[file.stem] = (("-", "0"), lambda file=file: points_of(file))
    return result


def run(program, entry, threads, timeout):
    """The figures of one run; None where it took too long."""
    arguments, data = entry
    try:
        process = subprocess.run([program, *arguments, str(threads)], input=data(), stdout=subprocess.PIPE,
                                 timeout=timeout, check=True)
    except subprocess.TimeoutExpired:
        return None
    return json.loads(process.stdout)


def seconds(figures, group, kind, name=None):
    return sum(step[kind] for step in figures[group] if name in (None, step["name"]))


def medians(runs, threads):
    """One number for each column but the first two; ratios are those of each run."""
    kind = "cpu" if threads == 1 else "wall"

    def median(value):
        return statistics.median(value(figures) for figures in runs)

    def ratio(group, name=None):
        return median(lambda f: seconds(f, group, kind, name) / seconds(f, "floor", "cpu"))

    memory = median(lambda f: max(step["memory"] for step in f["chain"]) - f["memory before"])
    return {"floor s": median(lambda f: seconds(f, "floor", "cpu")), "chain / floor": ratio("chain"),
            **{stage: ratio("chain", stage) for stage in STAGES}, "other threshold": ratio("again"),
            "ms per 1000": median(lambda f: 1e6 * seconds(f, "chain", kind) / f["samples"]),
            "kB per sample": memory / runs[0]["samples"]}


def row(name, runs, threads, timeout):
    if None in runs:
        return f"| {name} | not done after {timeout} s " + "| " * (len(COLUMNS) - 2) + "|\n"
    values = [f"{value:.0f}" if value >= 100 else f"{value:.2f}" for value in medians(runs, threads).values()]
    return "| " + " | ".join([name, f"{runs[0]['samples']:,}", *values]) + " |\n"


def comparison(before, now):
    """In words: what one second of another build has become."""
    if None in before + now:
        return "not done in time"
    def time(runs):
        return statistics.median(seconds(f, "chain", "cpu") for f in runs)
    same = before[0]["fingerprint"] == now[0]["fingerprint"]
    return f"{time(now) / time(before):.2f}, {'same' if same else 'OTHER'} result"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("models", nargs="*", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--timeout", type=float, default=600)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--before", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()

    known = inputs(options.models)
    chosen = [name for name in known if any(fnmatch.fnmatch(name, pattern) for pattern in options.only)
              or (not options.only and not name.endswith("_1000000"))]
    runs = {name: [] for name in chosen}
    for _ in range(options.runs):
        for name in chosen:
            if None not in runs[name]:
                runs[name].append(run(options.program, known[name], options.threads, options.timeout))
    before = json.loads(options.before.read_text()) if options.before else {}
    rows = {name: row(name, runs[name], options.threads, options.timeout) for name in chosen}
    print(HEADER, end="")
    for name in chosen:
        print(rows[name].rstrip(), comparison(before[name], runs[name]) if name in before else "")
    if options.json:
        options.json.write_text(json.dumps(runs))
    if options.write:
        tables.write("times", HEADER, rows, list(known), HERE / "README.md")


if __name__ == "__main__":
    main()
