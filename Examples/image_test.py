# SPDX-License-Identifier: BSD-3-Clause
"""What the checks of images share: small ones, and runs of the program on them."""

import array
import json
import resource
import struct

from program_test import ProgramTest

SIZE = (14, 12, 10)


def voxels(value, size=SIZE):
    """value(x, y, z) with coordinates -1 ... 1 at the voxels, the first index fastest."""
    at = [[2 * (i + 0.5) / n - 1 for i in range(n)] for n in size]
    return [value(x, y, z) for z in at[2] for y in at[1] for x in at[0]]


def ball(x, y, z):
    return 5 if x * x + y * y + z * z < 0.6 else 0


def shorts(values):
    return array.array("h", values).tobytes()


class ImageTest(ProgramTest):
    """Runs SimplifyShape on images."""

    def write_bytes(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)
        return self.path(name)

    def read(self, name, content, *options):
        """Runs on a file with this content; returns report.json, and the middle of the surface."""
        return self.read_path(self.write_bytes(name, content), *options)

    def read_path(self, path, *options):
        """The same for a file, or a folder, that is there."""
        out = self.path("out")
        done = self.run_program(path, "--output", out, "--schedule", "", "--spacing", "1.5", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(out + "/report.json") as file:
            report = json.load(file)
        with open(out + "/surface.stl", "rb") as file:
            triangles = file.read()[84:]
        corners = [struct.unpack_from("<9f", triangles, at + 12) for at in range(0, len(triangles), 50)]
        middle = [(min(min(c[k::3]) for c in corners) + max(max(c[k::3]) for c in corners)) / 2
                  for k in range(3)]
        return report, middle

    def refuse(self, name, content, *fragments, options=()):
        """Exit 2 within a second of computing, and a line that names the file and says these fragments."""
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assert_fails(2, [name, *fragments], self.write_bytes(name, content), *options)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertLess(after.ru_utime + after.ru_stime - usage.ru_utime - usage.ru_stime, 1)

    def assert_middle(self, found, expected):
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=0.4)
