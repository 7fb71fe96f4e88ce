# SPDX-License-Identifier: BSD-3-Clause
"""Checks that SimplifyShape's results appear together or not at all, whatever ends a run; run by check.py."""

import contextlib
import fcntl
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

from program_test import PROGRAM, ProgramTest, ellipsoid

KILLED_RUNS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../Testing/Robustness/killed_runs.py")


def contents(folder):
    """The files of a folder and those below it."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(place, name), "rb") as file:
                found[os.path.relpath(os.path.join(place, name), folder)] = file.read()
    return found


ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def setUpModule():
    """A program inherits which signals are ignored: under nohup, and in the background of a script."""
    for number in ENDING:
        if signal.getsignal(number) == signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)


def limit_files(size):
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


@contextlib.contextmanager
def x_server(*options):
    """An X server on a display of its own. It resets when its last client goes, unless it is told not to."""
    reading, writing = os.pipe()
    with subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-nolisten", "tcp", *options], pass_fds=[writing],
                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as server:
        os.close(writing)
        with open(reading) as file:
            number = file.readline().strip()
        try:
            yield server, dict(os.environ, DISPLAY=":" + number, LIBGL_ALWAYS_SOFTWARE="1")
        finally:
            server.kill()


class Outputs(ProgramTest):
    def start(self, points, *arguments, environment=None, setup=None):
        """Begins a run into the folder `out` that takes seconds."""
        return subprocess.Popen(
            [PROGRAM, self.write_xyz(points), "--output", self.path("out"), *arguments], text=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment, preexec_fn=setup)

    def assert_nothing_hidden(self, *visible):
        self.assertEqual(set(os.listdir(self.folder.name)), {"points.xyz", *visible})

    def test_trim_leaves_the_surface(self):
        points = ellipsoid()
        whole, plain = self.simplify(points, "--schedule", "")
        trimmed, out = self.simplify(points, "--schedule", "", "--trim", "0.5")
        self.assertLess(trimmed["parts"], whole["parts"])
        self.assertEqual(trimmed["verdict"]["name"], whole["verdict"]["name"])
        with open(os.path.join(plain, "surface.stl"), "rb") as a, open(os.path.join(out, "surface.stl"), "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_new_results_replace_all_old_ones_and_nothing_else(self):
        _, out = self.simplify(ellipsoid(300))
        self.write("out/overview.png", "of the old results")
        self.write("out/notes.txt", "the user's")
        os.mkdir(self.path("out/folder"))
        self.write("out/folder/surface.vtp", "the user's")
        before = contents(out)
        number = os.stat(out).st_ino
        self.simplify(ellipsoid(400))
        after = contents(out)
        self.assertEqual(os.stat(out).st_ino, number, "who works in the folder has lost it")
        self.assertEqual(set(after), set(before) - {"overview.png"})
        for name in before:
            user = name in ("notes.txt", "folder/surface.vtp")
            if name != "overview.png":
                self.assertEqual(after[name] == before[name], user, name)
        self.assert_nothing_hidden("out")
        self.assertFalse(any(os.path.islink(os.path.join(out, name)) for name in after))

    def test_any_way_to_name_the_folder(self):
        points = self.write_xyz(ellipsoid(300))
        os.mkdir(self.path("out"))
        os.symlink("out", self.path("link"))
        for name, folder, place in (("out/", "out", "."), ("link", "out", "."), (".", "here", "here"),
                                    ("new/in/new/", "new/in/new", ".")):
            with self.subTest(name):
                os.makedirs(self.path(place), exist_ok=True)
                done = subprocess.run([PROGRAM, points, "--output", name], cwd=self.path(place),
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(len(os.listdir(self.path(folder))), 10)
        self.assertTrue(os.path.islink(self.path("link")))
        self.assert_nothing_hidden("out", "link", "here", "new")

    def test_folder_in_the_way_leaves_the_old_results(self):
        _, out = self.simplify(ellipsoid(300))
        os.remove(self.path("out/history.csv"))
        os.mkdir(self.path("out/history.csv"))
        before = contents(out)
        done = self.run_program(self.write_xyz(ellipsoid(400)), "--output", out)
        self.assertEqual(done.returncode, 2)
        self.assertIn("Is a directory", done.stderr)
        self.assertEqual(contents(out), before)
        self.assert_nothing_hidden("out")

    def test_link_in_the_folder_is_replaced_and_what_it_leads_to_stays(self):
        _, out = self.simplify(ellipsoid(300))
        self.write("theirs.vtp", "the user's")
        os.remove(self.path("out/axis.vtp"))
        os.symlink("../theirs.vtp", self.path("out/axis.vtp"))
        self.simplify(ellipsoid(400))
        self.assertFalse(os.path.islink(self.path("out/axis.vtp")))
        with open(self.path("theirs.vtp")) as file:
            self.assertEqual(file.read(), "the user's")
        self.assert_nothing_hidden("out", "theirs.vtp")

    def test_folder_whose_parent_cannot_be_written_to(self):
        # Root could write there. It may still go wherever the checkout is, unlike another user.
        obeying = ["setpriv", "--bounding-set", "-dac_override"] if os.getuid() == 0 else []
        points = self.write_xyz(ellipsoid(300))
        os.makedirs(self.path("parent/out"))
        os.chmod(self.path("parent"), 0o555)
        self.addCleanup(os.chmod, self.path("parent"), 0o755)
        self.assertNotEqual(subprocess.run([*obeying, "touch", self.path("parent/file")], check=False,
                                           stderr=subprocess.DEVNULL).returncode, 0)
        for _ in range(2):
            done = subprocess.run([*obeying, PROGRAM, points, "--output", self.path("parent/out")],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(len(os.listdir(self.path("parent/out"))), 10)
        done = subprocess.run([*obeying, PROGRAM, points, "--output", self.path("parent/new")],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("Permission denied", done.stderr)

    def test_full_disk_gives_2_and_leaves_the_old_results(self):
        _, out = self.simplify(ellipsoid(600))
        before = contents(out)
        sizes = sorted(len(text) for text in before.values())
        for folder, files in ((out, before), (self.path("new"), {})):
            for size in (0, 1, sizes[3] + 1, sizes[-3] + 1, sizes[-1] - 1):
                done = subprocess.run([PROGRAM, self.path("points.xyz"), "--output", folder],
                                      capture_output=True, text=True, preexec_fn=limit_files(size))
                self.assertEqual(done.returncode, 2, "%d bytes: %s" % (size, done.stderr))
                self.assertRegex(done.stderr, "[a-z.]+: can't be written: (File too large|No space left)")
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertEqual(contents(folder), files)
                self.assert_nothing_hidden("out")

    def test_signals_end_the_program_within_a_second(self):
        for number, code in zip(ENDING, (130, 143, 129)):
            for delay in (0.5, 1.5):
                with self.subTest(signal=number, delay=delay), self.start(ellipsoid(20000)) as process:
                    time.sleep(delay)
                    process.send_signal(number)
                    begin = time.monotonic()
                    _, message = process.communicate()
                    self.assertLess(time.monotonic() - begin, 1)
                    self.assertEqual(process.returncode, code)
                    self.assertIn("ended by", message)
                    self.assert_nothing_hidden()

    def test_signal_removes_the_folders_that_were_made(self):
        points = self.write_xyz(ellipsoid(20000))
        with subprocess.Popen([PROGRAM, points, "--output", self.path("a/b/c")], stderr=subprocess.DEVNULL) as process:
            while not os.path.exists(self.path("a/b")):
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
        self.assertEqual(process.returncode, 130)
        self.assert_nothing_hidden()

    def test_ignored_signals_stay_ignored(self):
        """As under nohup, and in the background of a script."""
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)
            signal.signal(signal.SIGINT, signal.SIG_IGN)
        with self.start(ellipsoid(3000), setup=ignore) as process:
            time.sleep(0.3)
            process.send_signal(signal.SIGHUP)
            process.send_signal(signal.SIGINT)
            process.communicate()
        self.assertEqual(process.returncode, 0)

    def test_drafts_of_dead_runs_are_removed_and_no_others(self):
        self.simplify(ellipsoid(300))
        drafts = {name: self.path(name) for name in (
            ".out.SimplifyShape-deaddd", ".out.SimplifyShape-living", ".out.SimplifyShape-theirs",
            ".other.SimplifyShape-aaaaaa", "out/.SimplifyShape-deaddd")}
        for draft in drafts.values():
            os.makedirs(os.path.join(draft, "new"))
        self.write(".out.SimplifyShape-theirs/notes.txt", "the user's")
        lock = os.open(drafts[".out.SimplifyShape-living"], os.O_RDONLY)
        self.addCleanup(os.close, lock)
        fcntl.flock(lock, fcntl.LOCK_EX)
        self.simplify(ellipsoid(300))
        self.assertEqual({name for name, draft in drafts.items() if not os.path.exists(draft)},
                         {".out.SimplifyShape-deaddd", "out/.SimplifyShape-deaddd"})

    def test_concurrent_runs_give_the_results_of_one(self):
        inputs = [self.write_xyz(ellipsoid(300 + 50 * i), "%d.xyz" % i) for i in range(4)]
        for _ in range(3):
            runs = [subprocess.Popen([PROGRAM, file, "--quiet", "--output", self.path("out")]) for file in inputs]
            self.assertEqual([run.wait() for run in runs], [0] * len(runs))
            self.assertEqual(len(os.listdir(self.path("out"))), 10)
            alone = [self.path("alone%d" % i) for i in range(4)]
            for file, folder in zip(inputs, alone):
                subprocess.run([PROGRAM, file, "--quiet", "--output", folder], check=True)
            result = contents(self.path("out"))
            del result["report.json"]
            self.assertTrue(any(result.items() <= contents(folder).items() for folder in alone))

    def test_killed_runs_leave_whole_results(self):
        done = subprocess.run([sys.executable, KILLED_RUNS, PROGRAM, "--count", "22"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    @unittest.skipUnless(shutil.which("Xvfb"), "needs Xvfb")
    def test_pictures_at_a_server_that_resets(self):
        points = self.write_xyz(ellipsoid(300))
        with x_server() as (_, environment):
            for _ in range(4):
                done = self.run_program(points, "--picture", "--output", self.path("out"), environment=environment)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(len(os.listdir(self.path("out"))), 16)

    @unittest.skipUnless(shutil.which("Xvfb"), "needs Xvfb")
    def test_panels_at_a_server_that_resets_and_on_a_full_disk(self):
        _, out = self.simplify(ellipsoid(300))
        picture = self.write("panels.png", "older")
        command = [os.path.join(os.path.dirname(PROGRAM), "DrawPanels"), picture, os.path.join(out, "surface.vtp") + ":a"]
        with x_server() as (_, environment):
            failed = subprocess.run(command, env=environment, capture_output=True, text=True, preexec_fn=limit_files(500))
            self.assertEqual(failed.returncode, 2)
            self.assertIn("panels.png: can't be written: File too large", failed.stderr)
            self.assertEqual(contents(self.folder.name)["panels.png"], b"older")
            self.assert_nothing_hidden("out", "panels.png")
            for _ in range(4):
                done = subprocess.run(command, env=environment, capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(contents(self.folder.name)["panels.png"].startswith(b"\x89PNG"))

    @unittest.skipUnless(shutil.which("Xvfb"), "needs Xvfb")
    def test_signal_while_it_draws_costs_only_the_pictures(self):
        with x_server("-noreset") as (_, environment):
            with self.start(ellipsoid(3000), "--picture", environment=environment) as process:
                while not os.path.exists(self.path("out")):
                    time.sleep(0.01)
                process.send_signal(signal.SIGINT)
                process.communicate()
        self.assertEqual(process.returncode, 130)
        self.assertEqual(len(os.listdir(self.path("out"))), 10)
        self.assert_nothing_hidden("out")

    @unittest.skipUnless(shutil.which("Xvfb"), "needs Xvfb")
    def test_server_that_vanishes_costs_only_the_pictures(self):
        with x_server("-noreset") as (server, environment):
            with self.start(ellipsoid(8000), "--picture", "--output", self.path("a/out"),
                            environment=environment) as process:
                while not os.path.exists(self.path("a")):  # by then the program has found the server
                    time.sleep(0.01)
                server.kill()
                _, message = process.communicate()
        self.assertEqual(process.returncode, 0, message)
        self.assertIn("there are no pictures: the X server", message)
        self.assertEqual(len(os.listdir(self.path("a/out"))), 10)
        self.assertEqual(os.listdir(self.path("a")), ["out"])


if __name__ == "__main__":
    unittest.main()
