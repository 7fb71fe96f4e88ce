#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does the benchmark run, give the same results in each run, and are its inputs what their names say?

    Testing/Benchmark/test_benchmark.py build/bin/benchmark_chain
"""

import pathlib
import sys
import tempfile
import unittest

import benchmark
import plot

PROGRAM = sys.argv.pop()
PIECES_TUNNELS_VOIDS = {"bone": [1, 1, 0], "torus": [1, 1, 0], "tube": [1, 1, 0]}


class TestBenchmark(unittest.TestCase):
    def run_input(self, shape, threads=1):
        return benchmark.run(PROGRAM, ((shape, "1000"), bytes), threads, 100)

    def test_inputs_have_their_topology_and_size(self):
        for shape in benchmark.SHAPES:
            with self.subTest(shape=shape):
                figures = self.run_input(shape)
                self.assertEqual(figures["betti"], [PIECES_TUNNELS_VOIDS.get(shape, [1, 0, 0])] * 4)
                self.assertLess(abs(figures["samples"] - 1000), 120)

    def test_threads_do_not_change_the_result(self):
        self.assertEqual(self.run_input("bone")["fingerprint"], self.run_input("bone", 2)["fingerprint"])

    def test_rows_have_all_columns(self):
        figures = self.run_input("capsule")
        for runs in ([figures, figures], [figures, None]):
            self.assertEqual(benchmark.row("capsule", runs, 1, 10).count("|"), benchmark.HEADER.count("|") // 2)

    def test_the_plot_reads_what_the_table_has(self):
        figures = self.run_input("slab")
        with tempfile.NamedTemporaryFile("w", suffix=".md") as readme:
            readme.write("# Title\n\n| other | table |\n|---|---|\n\n" + benchmark.HEADER)
            for name in ("slab_1000", "bunny_34835", "slab_10000"):
                readme.write(benchmark.row(name, [figures], 1, 10))
            readme.write(benchmark.row("torus_1000", [None], 1, 10))
            readme.flush()
            series = plot.series_of(pathlib.Path(readme.name), "ms per 1000")
        self.assertEqual({name: len(points) for name, points in series.items()}, {"slab": 2, plot.MODELS: 1})
        samples, milliseconds = series["slab"][0]
        self.assertEqual(samples, figures["samples"])
        expected = 1e6 * benchmark.seconds(figures, "chain", "cpu") / samples
        self.assertAlmostEqual(milliseconds, expected, delta=0.51)

    def test_a_slow_run_ends(self):
        self.assertIsNone(benchmark.run(PROGRAM, (("torus", "20000"), bytes), 1, 0.2))


unittest.main()
