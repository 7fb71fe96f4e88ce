#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""While simplify works, Python goes on: other threads, progress, stops and Ctrl-C."""

import os
import signal
import threading
import time
import unittest

import numpy

from medialaxis import Stopped, arrays, simplify


def ellipsoid(count):
    """Points spread over an ellipsoid along a spiral."""
    i = numpy.arange(count)
    z = 1 - (2 * i + 1) / count
    turn = numpy.pi * (3 - numpy.sqrt(5)) * i
    around = numpy.sqrt(1 - z * z)
    return numpy.stack([3 * around * numpy.cos(turn), 2 * around * numpy.sin(turn), z], axis=1)


MANY = ellipsoid(8000)


class Interrupts(unittest.TestCase):
    def test_lets_other_threads_work(self):
        done, counts = threading.Event(), []

        def count():
            while not done.is_set():
                counts.append(time.monotonic())
                time.sleep(0.002)

        other = threading.Thread(target=count)
        begin = time.monotonic()
        other.start()
        try:
            simplify(MANY)
        finally:
            done.set()
            other.join()
        pauses = numpy.diff([begin, *counts])
        self.assertGreater(len(counts), 20)
        self.assertLess(pauses.max(), (counts[-1] - begin) / 2, "the other thread had to wait")

    def test_works_in_several_threads(self):
        expected = arrays(simplify(ellipsoid(800)).surface)["points"]
        results = [None] * 3

        def work(i):
            results[i] = arrays(simplify(ellipsoid(800)).surface)["points"]

        threads = [threading.Thread(target=work, args=(i,)) for i in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            numpy.testing.assert_array_equal(result, expected)

    def test_reports_progress_on_its_own_thread(self):
        reports = []
        simplify(MANY, progress=lambda done: reports.append((done, threading.get_ident())))
        self.assertGreater(len(reports), 5)
        self.assertEqual({thread for _, thread in reports}, {threading.get_ident()})
        values = [done for done, _ in reports]
        self.assertEqual(values, sorted(set(values)))
        self.assertGreaterEqual(values[0], 0)
        self.assertEqual(values[-1], 1)

    def test_stops_where_progress_returns_false(self):
        reports = []

        def progress(done):
            reports.append(done)
            return done < 0.3

        with self.assertRaisesRegex(Stopped, "%"):
            simplify(MANY, progress=progress)
        self.assertGreaterEqual(reports[-1], 0.3)
        self.assertLess(reports[-1], 1)
        self.assertEqual(arrays(simplify(ellipsoid(800)).surface)["Closed"][0], 1)

    def test_stops_where_progress_fails(self):
        def progress(done):
            if done > 0.1:
                raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            simplify(MANY, progress=progress)

    def test_stops_at_control_c(self):
        sent, reports = [], []

        def interrupt():
            while not reports or reports[-1] < 0.1:
                time.sleep(0.005)
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        other = threading.Thread(target=interrupt)
        other.start()
        with self.assertRaises(KeyboardInterrupt):
            simplify(MANY, progress=reports.append)
        self.assertLess(time.monotonic() - sent[0], 5)  # 0.1 s on an idle machine
        self.assertLess(reports[-1], 1)
        other.join()

    def test_still_raises_what_is_wrong(self):
        with self.assertRaisesRegex(ValueError, "points"):
            simplify(numpy.zeros((3, 3)), progress=lambda done: None)
        with self.assertRaisesRegex(ValueError, "no measure 'Beauty'"):
            simplify(ellipsoid(400), [("Beauty", 1)])


if __name__ == "__main__":
    unittest.main()
