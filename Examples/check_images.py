# SPDX-License-Identifier: BSD-3-Clause
"""Checks which images SimplifyShape reads and what it says of the others; run by check.py."""

import array
import base64
import gzip
import itertools
import math
import random
import struct
import zlib

from image_test import SIZE, ImageTest, ball, shorts, voxels


def mha(values, size=SIZE, matrix="1 0 0 0 1 0 0 0 1", packed=False):
    body = zlib.compress(shorts(values)) if packed else shorts(values)
    return ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "CompressedData = %s\n%sTransformMatrix = %s\nOffset = 100 0 -7\nElementSpacing = 1 1 1.5\n"
            "DimSize = %d %d %d\nElementType = MET_SHORT\nElementDataFile = LOCAL\n"
            % (packed, "CompressedDataSize = %d\n" % len(body) if packed else "", matrix, *size)
            ).encode() + body


def nrrd(values, axes="(1,0,0) (0,1,0) (0,0,1.5)"):
    return ("NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: %d %d %d\n"
            "space directions: %s\nkinds: domain domain domain\nendian: little\nencoding: raw\n"
            "space origin: (100,0,-7)\n\n" % (*SIZE, axes)).encode() + shorts(values)


def nii(values, size=SIZE, rows=((1, 0, 0, 100), (0, 1, 0, 0), (0, 0, 1.5, -7)), slope=1.0, intercept=0.0):
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *size, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 4, 16)  # signed short
    spacing = [math.hypot(*(row[k] for row in rows)) for k in range(3)]
    struct.pack_into("<8f", header, 76, 1, *spacing, 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352, slope, intercept)
    struct.pack_into("<2h", header, 252, 0, 1)
    for row, numbers in enumerate(rows):
        struct.pack_into("<4f", header, 280 + 16 * row, *numbers)
    header[344:348] = b"n+1\0"
    return bytes(header) + shorts(values)


def vti(values, size=SIZE, packed=False):
    body, format = " ".join(map(str, values)), "ascii"
    if packed:
        block = zlib.compress(shorts(values))
        head = struct.pack("<4I", 1, 2 * len(values), 0, len(block))
        body, format = (base64.b64encode(part).decode() for part in (head, block)), "binary"
    extent = "0 %d 0 %d 0 %d" % tuple(n - 1 for n in size)
    return ('<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt32" %s>'
            '<ImageData WholeExtent="%s" Origin="100 0 -7" Spacing="1 1 1.5"><Piece Extent="%s">'
            '<PointData Scalars="v"><DataArray type="Int16" Name="v" format="%s">%s</DataArray></PointData>'
            '</Piece></ImageData></VTKFile>' % ('compressor="vtkZLibDataCompressor"' if packed else "", extent,
                                                extent, format, "".join(body))).encode()


class Images(ImageTest):
    def test_all_kinds_of_files_give_the_same(self):
        values = voxels(ball)
        for name, content in (("a.mha", mha(values)), ("p.mha", mha(values, packed=True)),
                              ("a.nrrd", nrrd(values)), ("a.nii", nii(values)), ("a.vti", vti(values)),
                              ("p.vti", vti(values, packed=True)),
                              ("a.nii.gz", gzip.compress(nii(values)))):
            report, middle = self.read(name, content)
            self.assertEqual(report["source"], "image", name)
            self.assertEqual(report["image"]["label"], 5, name)
            self.assertEqual(report["betti"]["segmentation"], [1, 0, 0], name)
            self.assertEqual(report["betti"]["crust"], [1, 0, 0], name)
            self.assertEqual(report["verdict"]["name"], "certified", name)
            self.assert_middle(middle, (106.5, 5.5, -0.25))

    def test_directions_of_axes_are_heeded(self):
        values = voxels(ball)  # i along y, j along -x, k along z
        turned = (100 - 5.5, 6.5, -7 + 6.75)
        for name, content in (
                ("a.mha", mha(values, matrix="0 1 0 -1 0 0 0 0 1")),
                ("a.nrrd", nrrd(values, "(0,1,0) (-1,0,0) (0,0,1.5)")),
                ("a.nii", nii(values, SIZE, ((0, -1, 0, 100), (1, 0, 0, 0), (0, 0, 1.5, -7))))):
            self.assert_middle(self.read(name, content)[1], turned)

    def test_values_of_nifti_are_rescaled(self):
        content = nii(voxels(lambda *at: 10 * ball(*at)), slope=2.0, intercept=-10.0)
        report, _ = self.read("a.nii", content, "--iso", "80")
        self.assertEqual(report["image"]["isoValue"], 80)
        self.refuse("a.nii", content, "-10, 90", options=("--iso", "91"))

    def test_options_tell_the_solid(self):
        values = voxels(lambda x, y, z: 0 if ball(x, y, z) == 0 else 2 if x < 0 else 7)
        self.refuse("a.mha", mha(values), "the labels are 0, 2, 7", "--label N")
        self.refuse("a.mha", mha(values), "no voxel has the label 3", options=("--label", "3"))
        report, middle = self.read("a.mha", mha(values), "--label", "7")
        self.assertGreater(middle[0], 107.5)
        self.assertEqual(report["image"]["label"], 7)
        self.refuse("a.mha", mha(values), "no piece", options=("--label", "7", "--pieces", "100000"))
        self.assert_fails(1, ["--iso or --label"], self.path("a.mha"), "--iso", "1", "--label", "2")
        self.assert_fails(1, ["for images"], self.path("a.ply"), "--iso", "1")
        self.assert_fails(1, ["a number"], self.path("a.mha"), "--iso", "x")

    def test_cuts_and_fillings_are_told(self):
        def tube(x, y, z):
            return 1 if 0.4 < math.hypot(x, y) < 0.9 else 0
        report, _ = self.read("a.mha", mha(voxels(tube)))
        self.assertEqual([w["code"] for w in report["warnings"]], ["cut_at_border"])
        self.assertEqual(report["betti"]["crust"], [1, 1, 0])
        self.assertGreater(report["image"]["cutVoxels"][4], 20)

        def hollow(x, y, z):
            return ball(x, y, z) if x * x + y * y + z * z > 0.12 else 0
        filled, _ = self.read("a.mha", mha(voxels(hollow)))
        self.assertEqual(filled["image"]["filledCavities"], 1 if filled["image"]["filledVoxels"] else 0)
        kept, _ = self.read("a.mha", mha(voxels(hollow)), "--no-fill")
        self.assertEqual(kept["image"]["filledVoxels"], 0)
        self.assertEqual(kept["betti"]["segmentation"], [1, 0, 1])
        every, _ = self.read("a.mha", mha(voxels(hollow)), "--fill-cavities", "1000", "--pieces", "largest")
        self.assertEqual(every["betti"]["segmentation"], [1, 0, 0])

    def test_gaussian_smooths_more_or_not_at_all(self):
        areas = [self.read("a.mha", mha(voxels(ball)), "--gaussian", radius)[0]["sampling"]["area"]
                 for radius in ("0", "0.7", "1.2")]
        usual = self.read("a.mha", mha(voxels(ball)))[0]["sampling"]["area"]
        self.assertEqual(areas[1], usual)
        self.assertGreater(areas[0], usual)
        self.assertLess(areas[2], usual)
        self.assert_fails(1, ["--gaussian", "'11'"], "a.mha", "--gaussian", "11")
        self.assert_fails(1, ["--gaussian are for images"], "a.xyz", "--gaussian", "1")

    def test_hollow_bone_with_islands(self):
        def bone(x, y, z):
            distance = math.hypot(x, y, z)
            islands = (math.dist((x, y, z), (0.25 * k, 0.2 * k * k, 0)) for k in (-1, 0, 1))
            return 1 if 0.6 < distance < 0.9 or min(islands) < 0.12 else 0
        content = mha(voxels(bone, (40, 40, 30)), (40, 40, 30))
        fill, largest = ("--fill-cavities", "100000"), ("--pieces", "largest")
        for options, expected in ((("--no-fill", "--pieces", "1"), [4, 0, 1]), (largest, [1, 0, 1]),
                                  (fill, [1, 0, 0]), (fill + largest, [1, 0, 0])):
            report, _ = self.read("a.mha", content, *options)
            self.assertEqual(report["betti"]["segmentation"], expected)
            self.assertEqual(report["betti"]["crust"], expected)
            self.assertEqual(report["verdict"]["name"], "certified")

    def test_damaged_files_give_2(self):
        values = voxels(ball)
        for name, content in (("a.mha", mha(values)), ("p.mha", mha(values, packed=True)),
                              ("a.nrrd", nrrd(values)), ("a.nii", nii(values)), ("a.vti", vti(values)),
                              ("a.nii.gz", gzip.compress(nii(values)))):
            for share in (0, 0.05, 0.5, 0.9):
                self.refuse(name, content[:int(share * len(content))])
            self.refuse(name, b"nonsense\n")
        self.refuse("a.mha", mha(values, size=(100000, 100000, 100000)), "announces")
        # A few voxels under headers that announce much more, but not more than so small a file can hold.
        few, size = array.array("h", random.Random(1).randbytes(200000)), (500, 500, 300)
        self.refuse("p.mha", mha(few, size=size, packed=True), "announces")
        self.refuse("a.nii.gz", gzip.compress(nii(few, size)), "announces")
        self.refuse("a.vti", vti(few, size, packed=True))

    def test_large_packed_images_are_read(self):
        """Packed to a thousandth: what reading takes can't be told from the size of the file."""
        size = (300, 300, 200)
        values = array.array("h", bytes(2 * math.prod(size)))
        for x, y, z in itertools.product(range(200, 206), range(100, 106), range(180, 186)):
            values[x + size[0] * (y + size[1] * z)] = 5
        for name, content in (("p.mha", mha(values, size, packed=True)), ("p.vti", vti(values, size, packed=True)),
                              ("a.nii.gz", gzip.compress(nii(values, size)))):
            self.assert_fails(2, [name, "no piece"], self.write_bytes(name, content), "--pieces", "1000")
