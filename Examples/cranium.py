#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Takes a region out of the CT of a head.

    Examples/cranium.py REGION FILE.mha

The CT is Cranium.inv3 of Debian's package invesalius-examples, which must be installed. Regions: jaw, face, vault, whole.
"""

import array
import pathlib
import plistlib
import sys
import tarfile

SCAN = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3"
BONE = 226  # Hounsfield units; from here on InVesalius takes bone
# First and last + 1 along x (to the left), y (to the front), z (to the head).
REGIONS = {
    "jaw": ((60, 200), (120, 225), (0, 26)),
    "face": ((60, 200), (140, 225), (0, 60)),
    "vault": ((50, 210), (15, 225), (60, 108)),
    "whole": ((0, 256), (0, 256), (0, 108)),
}


def read_scan():
    """The voxels, x fastest; how many there are along x, y and z; their distances in mm."""
    with tarfile.open(SCAN) as archive:
        names = {pathlib.PurePath(name).name: name for name in archive.getnames()}
        about = plistlib.loads(archive.extractfile(names["main.plist"]).read())
        voxels = array.array("h", archive.extractfile(names["matrix.dat"]).read())
    if sys.byteorder == "big":
        voxels.byteswap()
    return voxels, about["matrix"]["shape"][::-1], about["spacing"]


def write_region(path, scan, region):
    """A .mha file of a part of the scan, in its place; returns the number of voxels along x, y and z."""
    voxels, size, spacing = scan
    (x0, x1), (y0, y1), (z0, z1) = region
    header = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = %s\n"
              "Offset = %.9g %.9g %.9g\nElementSpacing = %.9g %.9g %.9g\nDimSize = %d %d %d\n"
              "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" % (
                  sys.byteorder == "big", x0 * spacing[0], y0 * spacing[1], z0 * spacing[2], *spacing,
                  x1 - x0, y1 - y0, z1 - z0))
    with open(path, "wb") as file:
        file.write(header.encode())
        for z in range(z0, z1):
            for y in range(y0, y1):
                row = size[0] * (y + size[1] * z)
                file.write(voxels[row + x0:row + x1].tobytes())
    return x1 - x0, y1 - y0, z1 - z0


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in REGIONS:
        sys.exit(__doc__)
    write_region(sys.argv[2], read_scan(), REGIONS[sys.argv[1]])


if __name__ == "__main__":
    main()
