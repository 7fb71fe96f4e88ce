# SPDX-License-Identifier: BSD-3-Clause
"""Checks the numbers that SimplifyShape measures, and its tables of many objects; run by check.py."""

import csv
import json
import math
import os
import signal
import subprocess
import time
import unittest

from program_test import PROGRAM, ProgramTest, ellipsoid, torus

BROKEN = {"empty.xyz": ("", "there are no points"), "words.xyz": ("no numbers\n", "line 1"),
          "nan.xyz": ("0 0 0\nnan 0 0\n", "NaN")}


def rows_of(text):
    return list(csv.DictReader(text.splitlines()))


class Cohorts(ProgramTest):

    def setUp(self):
        super().setUp()
        self.files = [self.write_xyz(ellipsoid(400 + 40 * i), "ellipsoid%d.xyz" % i) for i in range(4)]
        self.files.insert(2, self.write_xyz(torus(900), "torus, ring.xyz"))

    def environment(self, **variables):
        known = ("OMPI_", "PMI_", "PMIX_", "SLURM_")
        clean = {key: value for key, value in os.environ.items() if not key.startswith(known)}
        return {**clean, **{key: str(value) for key, value in variables.items()}}

    def cohort(self, files, *options, table="table.csv", code=0, environment=None):
        """Runs on files; returns the text of the table, or None where there is none."""
        done = self.run_program("--cohort", self.path(table), *files, *options,
                                environment=environment or self.environment())
        self.assertEqual(done.returncode, code, done.stderr)
        self.done = done
        if not os.path.exists(self.path(table)):
            return None
        with open(self.path(table)) as file:
            return file.read()

    def test_morphometry_of_a_known_solid(self):
        report, out = self.simplify(torus(3000), "--morphometry", "--unit", "mm", "--schedule", "")
        with open(os.path.join(out, "morphometry.csv")) as file:
            rows = rows_of(file.read())
        self.assertEqual(len(rows), 1)
        row = rows[0]
        self.assertEqual((row["Name"], row["Unit"], row["Verdict"]), ("points", "mm", "certified"))
        volume, area = 2 * math.pi**2 * 0.4**2, 4 * math.pi**2 * 0.4
        for name, known in (("TV", 2.8 * 2.8 * 0.8), ("BV", volume), ("BS", area),
                            ("BV/TV", volume / (2.8 * 2.8 * 0.8)), ("BS/BV", area / volume),
                            ("Conn.D", 1 / (2.8 * 2.8 * 0.8)), ("Tb.Th", 0.8)):
            self.assertAlmostEqual(float(row[name]), known, delta=0.02 * known, msg=name)
        self.assertEqual([row["Betti:%d" % i] for i in range(3)], ["1", "1", "0"])
        self.assertEqual(row["BettiSolid:0"], "")  # of points it isn't known
        self.assertEqual(float(row["Euler"]), 0)
        values, units = report["morphometry"]["values"], report["morphometry"]["units"]
        self.assertEqual(list(values), [name for name in row if name in values])
        for name, value in values.items():
            self.assertEqual("" if value is None else float(row[name]), "" if value is None else value)
        self.assertEqual((units["TV"], units["BS/BV"], units["DA"]), ("mm^3", "mm^-1", "1"))
        self.assertEqual(report["morphometry"]["name"], "points")

    def test_morphometry_in_bounds(self):
        options = "--morphometry", "--schedule", "", "--bounds"
        report, _ = self.simplify(torus(3000), *options, "0,2,-2,2,-1,1")
        values = report["morphometry"]["values"]
        self.assertAlmostEqual(values["TV"], 16)
        self.assertAlmostEqual(values["BV"], math.pi**2 * 0.4**2, delta=0.03)  # half of it
        self.assertIsNone(values["Conn.D"])
        self.assertAlmostEqual(values["Euler.VOI"], 0, delta=0.05)
        report, _ = self.simplify(torus(3000), *options, "-2,2,-2,2,-1,1", "--margin", "0.5")
        self.assertAlmostEqual(report["morphometry"]["values"]["TV"], 9)

    def test_without_morphometry_there_is_none(self):
        report, out = self.simplify(ellipsoid(400))
        self.assertIsNone(report["morphometry"])
        self.assertFalse(os.path.exists(os.path.join(out, "morphometry.csv")))

    def test_a_row_for_each_object_in_the_order_given(self):
        rows = rows_of(self.cohort(self.files[::-1], "--unit", "mm"))
        self.assertEqual([row["File"] for row in rows], self.files[::-1])
        self.assertEqual([row["Name"] for row in rows][2], "torus, ring")
        self.assertEqual([row["Betti:1"] for row in rows], ["0", "0", "1", "0", "0"])
        self.assertEqual({(row["Unit"], row["Error"]) for row in rows}, {("mm", "")})
        self.assertEqual(sorted(os.listdir(self.folder.name)),
                         sorted([os.path.basename(file) for file in self.files] +
                                ["table.csv", "table.csv.rows"]))

    def test_one_row_is_that_of_the_object_alone(self):
        row, = rows_of(self.cohort(self.files[:1]))
        self.run_program(self.files[0], "--morphometry", "--output", self.path("out"))
        with open(self.path("out/morphometry.csv")) as file:
            alone, = rows_of(file.read())
        self.assertEqual(row, {"File": self.files[0], **alone, "Error": ""})

    def test_ranks_make_the_same_table(self):
        expected = self.cohort(self.files, table="one.csv")
        for number, count in (("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"),
                              ("PMI_RANK", "PMI_SIZE"), ("SLURM_PROCID", "SLURM_NTASKS")):
            for rank in range(3):
                environment = self.environment(**{number: rank, count: 3, "SLURM_STEP_ID": 0})
                table = self.cohort(self.files, table=number + ".csv", environment=environment)
                self.assertEqual(table, expected if rank == 2 else None)
        # A batch script of Slurm isn't one of its steps.
        environment = self.environment(SLURM_PROCID=0, SLURM_NTASKS=3)
        self.assertEqual(self.cohort(self.files, table="b.csv", environment=environment), expected)

    def test_ranks_have_equal_shares(self):
        """By turns one of two ranks would have all large objects."""
        files = [self.write_xyz(ellipsoid(1200 if i % 2 == 0 else 400), "%d.xyz" % i) for i in range(8)]
        expected = self.cohort(files, table="one.csv")
        shares = []
        for rank in range(2):
            environment = self.environment(OMPI_COMM_WORLD_RANK=rank, OMPI_COMM_WORLD_SIZE=2, PMIX_NAMESPACE="run")
            table = self.cohort(files, environment=environment)
            self.assertEqual(table, expected if rank == 1 else None)
            measured = [line.split()[1].rstrip(":") for line in self.done.stdout.splitlines() if " s" in line[-2:]]
            shares.append(measured)
            self.assertEqual(sorted(os.path.getsize(file) for file in measured),
                             sorted(os.path.getsize(file) for file in files[:4]))
        self.assertEqual(sorted(shares[0] + shares[1]), files)
        # The order of the command line changes nothing but the order of the rows.
        environment = self.environment(OMPI_COMM_WORLD_RANK=0, OMPI_COMM_WORLD_SIZE=2, PMIX_NAMESPACE="turned")
        self.cohort(files[::-1], table="turned.csv", environment=environment)
        self.assertEqual([line.split()[1].rstrip(":") for line in self.done.stdout.splitlines()
                          if " s" in line[-2:]], shares[0][::-1])

    def test_broken_objects_have_reasons(self):
        broken = [self.write(name, text) for name, (text, _) in BROKEN.items()]
        files = self.files[:2] + broken + self.files[2:] + [self.path("missing.xyz")]
        rows = rows_of(self.cohort(files, code=4))
        self.assertEqual([row["File"] for row in rows], files)
        for row in rows:
            name = os.path.basename(row["File"])
            self.assertEqual(row["BV"] != "", row["File"] in self.files)
            self.assertIn(BROKEN[name][1] if name in BROKEN else "", row["Error"])
            self.assertEqual(row["Error"] == "", row["File"] in self.files)
        self.assertEqual(self.done.stderr.count("\n"), 4)
        rows = rows_of(self.cohort(broken, table="none.csv", code=4))  # no object is good
        self.assertEqual(len(rows), 3)
        self.assertIn("NaN", rows[2]["Error"])

    def test_a_failed_object_is_tried_again(self):
        late = self.path("late.xyz")
        self.cohort(self.files[:1] + [late], code=4)
        self.write_xyz(ellipsoid(400), "late.xyz")
        rows = rows_of(self.cohort(self.files[:1] + [late]))
        self.assertEqual([row["Error"] for row in rows], ["", ""])

    def test_an_old_failure_is_left_to_its_rank(self):
        """Who has nothing to do must not write the table before it was tried again: mpirun would stop the others."""
        files = [self.files[0], self.path("missing.xyz")]

        def run(rank, job, code):
            environment = self.environment(OMPI_COMM_WORLD_RANK=rank, OMPI_COMM_WORLD_SIZE=2, PMIX_NAMESPACE=job)
            return self.cohort(files, code=code, environment=environment)

        self.assertIsNone(run(0, "first", 0))
        self.assertIn("missing", run(1, "first", 4))
        os.remove(self.path("table.csv"))
        self.assertIsNone(run(0, "second", 0))
        self.assertIn("missing", run(1, "second", 4))

    def test_what_is_done_is_not_done_again(self):
        table = self.cohort(self.files)
        self.assertEqual(self.done.stdout.count(" s\n"), 5)
        self.assertEqual(self.cohort(self.files), table)
        self.assertEqual(self.done.stdout.count(" s\n"), 0)
        self.cohort(self.files, "--quiet", "--threads", "1")  # change nothing
        self.assertEqual(self.done.stdout, "")
        self.write_xyz(ellipsoid(500), os.path.basename(self.files[1]))
        self.assertNotEqual(self.cohort(self.files), table)
        self.assertEqual(self.done.stdout.count(" s\n"), 1)
        self.cohort(self.files, "--schedule", "")
        self.assertEqual(self.done.stdout.count(" s\n"), 5)

    def test_goes_on_where_it_was_killed(self):
        big = self.write_xyz(ellipsoid(30000), "big.xyz")
        files = self.files[:2] + [big] + self.files[2:]
        command = [PROGRAM, "--cohort", self.path("table.csv"), *files]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            for _ in range(2):
                process.stdout.readline()
            time.sleep(0.2)
            process.send_signal(signal.SIGKILL)
        self.assertFalse(os.path.exists(self.path("table.csv")))
        rows = rows_of(self.cohort(files, "--quiet"))
        self.assertEqual([row["Error"] for row in rows], [""] * 6)
        self.assertEqual(len(os.listdir(self.path("table.csv.rows"))), 6)

    def test_a_crash_costs_one_row(self):
        """Here somebody else ends the process of an object, as the system does where memory is short."""
        big = self.write_xyz(ellipsoid(30000), "big.xyz")
        files = self.files[:1] + [big] + self.files[1:2]
        command = [PROGRAM, "--cohort", self.path("table.csv"), *files]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            process.stdout.readline()
            time.sleep(0.3)
            with open("/proc/%d/task/%d/children" % (process.pid, process.pid)) as children:
                child, = children.read().split()
            os.kill(int(child), signal.SIGKILL)
            self.assertIn("Killed", process.stderr.read())
        self.assertEqual(process.returncode, 4)
        with open(self.path("table.csv")) as table:
            rows = rows_of(table.read())
        self.assertEqual([row["Error"] == "" for row in rows], [True, False, True])
        self.assertIn("Killed", rows[1]["Error"])

    def test_other_results_go_into_a_folder_each(self):
        self.cohort(self.files[:2], "--output", self.path("all"), "--strict")
        self.assertEqual(sorted(os.listdir(self.path("all"))), ["ellipsoid0", "ellipsoid1"])
        with open(self.path("all/ellipsoid1/report.json")) as file:
            self.assertEqual(json.load(file)["samples"], 440)
        steps = 0.8191725134, 0.6710436067, 0.5497004779
        volume = [tuple(i * step % 1 for step in steps) for i in range(1, 1500)]
        doubtful = self.write_xyz(volume, "volume.xyz")
        row, = rows_of(self.cohort([doubtful], "--strict", table="t.csv", code=4))
        self.assertIn("not certified", row["Error"])

    def test_wrong_usage(self):
        for words, message in ((["--unit", "mm"], "--morphometry"), (["--cohort", "t.csv"], "twice"),
                               (["--unit", "a,b", "--morphometry"], "--unit"),
                               (["--bounds", "0,1,2", "--morphometry"], "--bounds"),
                               (["--margin", "-1", "--morphometry"], "--margin"),
                               (["--cohort", ""], "--cohort"), (["--cohort", "t.csv", "--picture"], "--output")):
            inputs = self.files[:1] * (2 if message == "twice" else 1)
            done = self.run_program(*inputs, *words)
            self.assertEqual(done.returncode, 1, words)
            self.assertIn(message, done.stderr)
        points = self.write("points.csv", "x y z\n1 2 3\n")
        for table in self.files[0], points, self.write("empty.csv", ""):
            done = self.run_program("--cohort", table, *self.files[1:])
            self.assertEqual(done.returncode, 1)
            self.assertIn("table first", done.stderr)
            self.assertFalse(os.path.exists(table + ".rows"))
        done = self.run_program(*self.files[:1], "--cohort", self.path("t.csv"),
                                environment=self.environment(PMI_RANK=3, PMI_SIZE=2))
        self.assertEqual(done.returncode, 1)
        self.assertIn("PMI_RANK", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
