# SPDX-License-Identifier: BSD-3-Clause
"""Writes DICOM files, for check_dicom.py."""

import struct

CT = "1.2.840.10008.5.1.4.1.1.2"
PLAIN, RLE = "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.5"


def element(group, number, kind, value):
    """A data element, explicit and little-endian."""
    if isinstance(value, str):
        value = value.encode()
    if len(value) % 2:
        value += b"\0" if kind in ("UI", "OB") else b" "
    head = struct.pack("<HH2s", group, number, kind.encode())
    if kind in ("OB", "OW"):
        return head + struct.pack("<HI", 0, len(value)) + value
    return head + struct.pack("<H", len(value)) + value


def short(group, number, value):
    return element(group, number, "US", struct.pack("<H", value))


def runs(data):
    """Packed by DICOM's RLE: runs of up to 128 equal bytes."""
    result = bytearray()
    at = 0
    while at < len(data):
        end = at + 1
        while end < len(data) and end - at < 128 and data[end] == data[at]:
            end += 1
        result += bytes([0, data[at]] if end == at + 1 else [257 - (end - at), data[at]])
        at = end
    return bytes(result) + bytes(len(result) % 2)


def packed(words):
    """The pixel data of one frame of 16 bit, packed by RLE."""
    high, low = runs(words[1::2]), runs(words[0::2])  # the high bytes come first
    frame = struct.pack("<16I", 2, 64, 64 + len(high), *[0] * 13) + high + low
    item = struct.pack("<HHI", 0xfffe, 0xe000, 0)  # no table of offsets
    item += struct.pack("<HHI", 0xfffe, 0xe000, len(frame)) + frame
    return (struct.pack("<HH2sHI", 0x7fe0, 0x0010, b"OB", 0, 0xffffffff) + item
            + struct.pack("<HHI", 0xfffe, 0xe0dd, 0))


def dicom(words, size, number, position, orientation=(1, 0, 0, 0, 1, 0), spacing=(1, 1), thickness=1.5,
          series="1.2.3.4", name="BONE", intercept=-1000, syntax=PLAIN):
    """A file with a slice of a CT: `words` are its values of 16 bit in memory, the rows one after the other."""
    uid = "%s.%d" % (series, number)
    meta = (element(2, 1, "OB", b"\0\1") + element(2, 2, "UI", CT) + element(2, 3, "UI", uid)
            + element(2, 0x10, "UI", syntax))

    def texts(numbers):
        return "\\".join("%.10g" % value for value in numbers)
    body = (element(8, 0x16, "UI", CT) + element(8, 0x18, "UI", uid) + element(8, 0x60, "CS", "CT")
            + element(8, 0x103e, "LO", name) + element(0x10, 0x20, "LO", "P1")
            + element(0x18, 0x50, "DS", texts([thickness])) + element(0x20, 0x0d, "UI", "1.2.3")
            + element(0x20, 0x0e, "UI", series) + element(0x20, 0x13, "IS", str(number))
            + element(0x20, 0x32, "DS", texts(position)) + element(0x20, 0x37, "DS", texts(orientation))
            + short(0x28, 2, 1) + element(0x28, 4, "CS", "MONOCHROME2") + short(0x28, 0x10, size[1])
            + short(0x28, 0x11, size[0]) + element(0x28, 0x30, "DS", texts(spacing[::-1]))
            + short(0x28, 0x100, 16) + short(0x28, 0x101, 16) + short(0x28, 0x102, 15) + short(0x28, 0x103, 1)
            + element(0x28, 0x1052, "DS", texts([intercept])) + element(0x28, 0x1053, "DS", "1"))
    pixels = packed(words) if syntax == RLE else element(0x7fe0, 0x10, "OW", words)
    return (bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + body + pixels)
