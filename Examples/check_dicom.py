# SPDX-License-Identifier: BSD-3-Clause
"""Checks which series of DICOM files SimplifyShape reads; run by check.py."""

import os
import random

from dicom_files import RLE, dicom
from image_test import SIZE, ImageTest, ball, shorts, voxels

VALUES = voxels(lambda *at: 2000 if ball(*at) else 0)  # 1000 after rescaling, and -1000
ISO = ("--iso", "0")


def slices(values, place=lambda k: (100, 0, -7 + 1.5 * k), **options):
    """Files of a series, in any order."""
    area = SIZE[0] * SIZE[1]
    files = [dicom(shorts(values[k * area:(k + 1) * area]), SIZE, k + 1, place(k), **options)
             for k in range(SIZE[2])]
    random.Random(5).shuffle(files)
    return files


class Dicom(ImageTest):
    def write_series(self, folder, files):
        os.makedirs(self.path(folder), exist_ok=True)
        for i, content in enumerate(files):
            self.write_bytes(os.path.join(folder, "IM%d" % i), content)
        return self.path(folder)

    def check(self, folder, middle, *options):
        report, found = self.read_path(self.path(folder), *ISO, *options)
        self.assertEqual(report["betti"]["segmentation"], [1, 0, 0])
        self.assertEqual(report["verdict"]["name"], "certified")
        self.assert_middle(found, middle)
        return report

    def test_a_folder_gives_its_series(self):
        self.write_series("plain", slices(VALUES))
        self.write_bytes("plain/README.TXT", b"A disk\n")
        plain = self.check("plain", (106.5, 5.5, -0.25))
        self.write_series("packed/IMAGES", slices(VALUES, syntax=RLE))
        packed = self.check("packed", (106.5, 5.5, -0.25))
        self.assertEqual(plain["volume"], packed["volume"])

    def test_directions_and_tilt_are_heeded(self):
        # Rows along z, columns along -y, slices towards -x.
        self.write_series("sagittal", slices(
            VALUES, lambda k: (50 - 1.5 * k, 10, 3), orientation=(0, 0, 1, 0, -1, 0)))
        self.check("sagittal", (50 - 6.75, 10 - 5.5, 3 + 6.5))
        self.write_series("tilted", slices(VALUES, lambda k: (0, -k, 1.5 * k)))
        report = self.check("tilted", (6.5, 5.5 - 4.5, 6.75))
        # Shearing keeps volumes.
        self.write_series("straight", slices(VALUES, lambda k: (0, 0, 1.5 * k)))
        straight = self.check("straight", (6.5, 5.5, 6.75))
        self.assertAlmostEqual(report["sampling"]["volume"] / straight["sampling"]["volume"], 1, places=9)

    def test_one_of_several_series_is_chosen(self):
        folder = self.write_series("disk", slices(VALUES))
        smaller = voxels(lambda *at: 2000 if ball(*[1.3 * x for x in at]) else 0)
        self.write_series("disk/more", slices(smaller, series="1.2.3.5", name="SOFT"))
        self.assert_fails(2, ["several series", "--series N", "'BONE', 10 files", "'SOFT'"], folder, *ISO)
        self.assert_fails(2, ["no series 3", "'BONE'"], folder, "--series", "3", *ISO)
        self.assert_fails(1, ["--series"], folder, "--series", "0")
        self.assert_fails(1, ["--series"], self.path("a.mha"), "--series", "1")
        first, second = (self.check("disk", (106.5, 5.5, -0.25), "--series", n) for n in "12")
        self.assertGreater(first["volume"]["crustAfter"], 1.5 * second["volume"]["crustAfter"])

    def test_damaged_series_give_2(self):
        self.assert_fails(2, ["no DICOM images"], self.write_series("empty", []))
        files = slices(VALUES)
        self.assert_fails(2, ["slices are missing"],
                          self.write_series("missing", [f for f in files if b"1.2.3.4.4\0" not in f]), *ISO)
        self.assert_fails(2, ["one slice"], self.write_bytes("one.dcm", files[0]), *ISO)
        for name, syntax in (("cut", {}), ("cutrle", {"syntax": RLE})):
            files = slices(VALUES, **syntax)
            files[2] = files[2][:-100]
            self.assert_fails(2, [name], self.write_series(name, files), *ISO)
        self.assert_fails(2, ["junk"], self.write_bytes("junk.dcm", bytes(range(256)) * 10))
