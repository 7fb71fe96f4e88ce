#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Ends runs of SimplifyShape at any time, and checks that its folder has the old or the new results, whole.

  Testing/Robustness/killed_runs.py build/bin/SimplifyShape [--count 200] [--seed 1] [--every-step]

Each run has another input than the one before; those with the first one write the meshes of
parts, too. It is ended by one of
  KILL TERM INT   the signal, at a random time
  limit           files may not be larger than a random size (ulimit -f)
  kill full io    it dies, or the disk is full or fails, from a random change of a file or folder on
  nohard nolinks  not at all, but on a disk without hard links, or without any
  tmpfs           a disk with random space; only with --tmpfs DIR, a mounted tmpfs
--every-step tries kill, full and io at each change, one after the other, instead.
"""

import argparse
import collections
import hashlib
import json
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
EXIT_CODES = {"TERM": 143, "INT": 130}


def write_input(path, axes, count=200):
    """Points spread over an ellipsoid along a spiral."""
    golden = math.pi * (3 - math.sqrt(5))
    with open(path, "w") as file:
        for i in range(count):
            z = 1 - (2 * i + 1) / count
            r = math.sqrt(1 - z * z)
            file.write("%.17g %.17g %.17g\n" % (axes[0] * r * math.cos(golden * i),
                                                axes[1] * r * math.sin(golden * i), axes[2] * z))


def content(path):
    """What a file holds; of report.json only what doesn't depend on the run."""
    with open(path, "rb") as file:
        text = file.read()
    if path.endswith("report.json"):
        report = json.loads(text)
        del report["seconds"], report["peakMemoryMiB"]
        text = json.dumps(report).encode()
    return hashlib.sha256(text).hexdigest()


def results(folder):
    """The visible files of a folder by their names. A link to nothing is no file."""
    if not os.path.isdir(folder):
        return {}
    names = [name for name in os.listdir(folder) if not name.startswith(".")]
    return {name: content(os.path.join(folder, name)) for name in sorted(names)
            if os.path.isfile(os.path.join(folder, name))}


def hidden(place):
    """Drafts and the like, in the folder `place/out` and beside it."""
    out = os.path.join(place, "out")
    names = set(os.listdir(place)) - {"out"}
    return names | {name for name in (os.listdir(out) if os.path.isdir(out) else [])
                    if name.startswith(".") or os.path.islink(os.path.join(out, name))}


class Runs:
    def __init__(self, program, scratch, place, seed):
        self.program = program
        self.random = random.Random(seed)
        self.place = place
        self.out = os.path.join(place, "out")
        self.outcomes = collections.Counter()
        self.inputs = [os.path.join(scratch, "%d.xyz" % i) for i in range(2)]
        write_input(self.inputs[0], (1.0, 0.7, 0.5))
        write_input(self.inputs[1], (0.9, 0.8, 0.6))
        self.library = os.path.join(scratch, "failat.so")
        subprocess.run(["c++", "-shared", "-fPIC", "-O1", "-o", self.library,
                        os.path.join(HERE, "FailAt.cxx")], check=True)
        self.folders = [os.path.join(scratch, "expected%d" % i) for i in range(2)]
        for which, folder in enumerate(self.folders):
            begin = time.monotonic()
            subprocess.run(self.command(which, folder), check=True)
            self.duration = time.monotonic() - begin
        self.expected = [results(folder) for folder in self.folders]
        self.largest = max(os.path.getsize(os.path.join(folder, name)) for name in self.expected[1])
        self.total = sum(os.path.getsize(os.path.join(folder, name)) for name in self.expected[1])

    def prepare(self, which):
        """Makes what stands in the folder before the run: nothing, or whole results and files of the user."""
        shutil.rmtree(self.out, ignore_errors=True)
        if which is not None:
            shutil.copytree(self.folders[which], self.out)
            os.mkdir(os.path.join(self.out, "folder"))
            for name in ("notes.txt", "folder/notes.txt"):
                with open(os.path.join(self.out, name), "w") as file:
                    file.write("the user's")
        assert not hidden(self.place), "a run left %s" % hidden(self.place)

    def command(self, which, folder=None):
        more = ["--export-parts", "--ma"] if which == 0 else []
        return [self.program, self.inputs[which], "--quiet", "--output", folder or self.out, *more]

    def end_by_signal(self, way, which):
        with subprocess.Popen(self.command(which), stderr=subprocess.DEVNULL) as process:
            time.sleep(self.random.uniform(0, 1.1 * self.duration))
            ended = process.poll() is not None
            if not ended:
                process.send_signal(getattr(signal, "SIG" + way))
            begin = time.monotonic()
            process.wait()
        assert time.monotonic() - begin < 1, "%s took more than a second" % way
        if way in EXIT_CODES and not ended and process.returncode not in (0, EXIT_CODES[way]):
            # A signal before main() ends the program as it ends any.
            assert process.returncode < 0, "%s gave exit %d" % (way, process.returncode)

    def end_by_limit(self, which):
        size = self.random.randrange(self.largest)
        done = subprocess.run(self.command(which), capture_output=True, text=True, preexec_fn=lambda:
                              resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        self.check_message(done)

    def end_at_step(self, way, step, which):
        """True if the run had that many steps."""
        environment = dict(os.environ, LD_PRELOAD=self.library, MEDIAL_FAIL_AT=str(step), MEDIAL_FAIL_BY=way)
        done = subprocess.run(self.command(which), capture_output=True, text=True, env=environment)
        if way == "kill":
            assert done.returncode in (0, -9), done.returncode
        elif done.returncode != 0:
            self.check_message(done)
        return done.returncode != 0

    def run_without_links(self, way, which):
        environment = dict(os.environ, LD_PRELOAD=self.library, MEDIAL_NO_LINKS="hard" if way == "nohard" else "all")
        subprocess.run(self.command(which), check=True, env=environment)
        assert results(self.out).items() >= self.expected[which].items()

    def end_by_full_disk(self, which):
        free = os.statvfs(self.place).f_bavail * os.statvfs(self.place).f_frsize
        filler = os.path.join(self.place, "filler")
        with open(filler, "wb") as file:
            file.write(bytes(max(0, free - self.random.randrange(int(1.2 * self.total)))))
        done = subprocess.run(self.command(which), capture_output=True, text=True)
        os.remove(filler)
        self.check_message(done)

    @staticmethod
    def check_message(done):
        assert done.returncode in (0, 2), "exit %d: %s" % (done.returncode, done.stderr)
        assert done.returncode == 0 or done.stderr.count("\n") == 1, done.stderr

    def check(self, way, before, which):
        """The folder has what it had or the new results, whole."""
        after = results(self.out)
        files = {name: before[name] for name in before if name == "notes.txt"}
        new = {**files, **self.expected[which]}
        assert after in (before, new), "%s: neither old nor new: %s" % (
            way, sorted(name for name in {**new, **after} if after.get(name) != new.get(name)))
        if before:
            assert os.path.isfile(os.path.join(self.out, "folder/notes.txt"))
        if way in ("TERM", "INT", "limit", "full", "tmpfs", "nohard", "nolinks"):
            assert not hidden(self.place), "%s left %s" % (way, hidden(self.place))
        self.outcomes[way, "new" if after == new else "old"] += 1

    def end(self, way, which, step=0):
        if way in ("KILL", "TERM", "INT"):
            return self.end_by_signal(way, which)
        if way == "limit":
            return self.end_by_limit(which)
        if way == "tmpfs":
            return self.end_by_full_disk(which)
        if way.startswith("no"):
            return self.run_without_links(way, which)
        return self.end_at_step(way, step or self.random.randint(1, 160), which)

    def run(self, way, old, step=0):
        """A run with one input over the results of the other one, or over nothing. Then another run finds its
        way through what is left."""
        self.prepare(old)
        before = results(self.out)
        which = 0 if old is None else 1 - old
        went_on = self.end(way, which, step)
        self.check(way, before, which)
        subprocess.run(self.command(which), check=True)
        assert not hidden(self.place), "a whole run left %s" % hidden(self.place)
        return went_on

    def run_randomly(self, count, ways):
        for i in range(count):
            self.run(ways[i % len(ways)], self.random.choice([None, 0, 1]))

    def run_every_step(self):
        for way in ("kill", "full", "io"):
            for old in (None, 0):
                step = 1
                while self.run(way, old, step):
                    step += 1

    def print_outcomes(self):
        print("ended by  old  new")
        for way in sorted({way for way, _ in self.outcomes}):
            print("%-8s %4d %4d" % (way, self.outcomes[way, "old"], self.outcomes[way, "new"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--every-step", action="store_true")
    parser.add_argument("--tmpfs", help="folder on a small tmpfs")
    arguments = parser.parse_args()
    if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:  # as in the background of a script; the program inherits it
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    print("seed %d" % arguments.seed, flush=True)
    with tempfile.TemporaryDirectory() as scratch, tempfile.TemporaryDirectory(dir=arguments.tmpfs) as place:
        runs = Runs(os.path.abspath(arguments.program), scratch, place, arguments.seed)
        if arguments.every_step:
            runs.run_every_step()
        else:
            ways = ["KILL", "TERM", "INT", "limit", "kill", "full", "io", "KILL", "kill", "nohard", "nolinks"]
            runs.run_randomly(arguments.count, ["tmpfs"] if arguments.tmpfs else ways)
        runs.print_outcomes()


if __name__ == "__main__":
    sys.exit(main())
