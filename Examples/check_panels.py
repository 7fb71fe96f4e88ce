# SPDX-License-Identifier: BSD-3-Clause
"""Checks the program DrawPanels, which draws files of SimplifyShape; run by check.py."""

import os
import struct
import subprocess
import unittest

from program_test import PROGRAM, ProgramTest, torus


class Panels(ProgramTest):
    @unittest.skipUnless(os.environ.get("DISPLAY"), "needs an X server")
    def test_panels(self):
        _, out = self.simplify(torus(1500))
        surface, axis = os.path.join(out, "surface.vtp"), os.path.join(out, "parts.vtp")
        done = self.draw_panels(self.path("panels.png"), "--columns", "2", "--size=100",
                                "--view", "1,-1,0.3", surface + ":a", axis + ":PartId:b",
                                axis + ":PartArea:c")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        with open(self.path("panels.png"), "rb") as file:
            self.assertEqual(struct.unpack(">II", file.read(24)[16:]), (200, 200))
        for code, message, *arguments in (
                (2, "no array Nothing", axis + ":Nothing:a"), (2, "nowhere.vtp", "nowhere.vtp:a"),
                (1, "'nowhere.vtp'", "nowhere.vtp"), (1, "no panel"),
                (1, "'1,2'", axis + ":PartId:b", "--view", "1,2"),
                (1, "--size", axis + ":PartId:b", "--size", "0")):
            failed = self.draw_panels(self.path("none.png"), *arguments)
            self.assertEqual(failed.returncode, code, failed.stderr)
            self.assertIn(message, failed.stderr)
            self.assertFalse(os.path.exists(self.path("none.png")))

    def draw_panels(self, *arguments):
        program = os.path.join(os.path.dirname(PROGRAM), "DrawPanels")
        return subprocess.run([program, *arguments], capture_output=True, text=True)


if __name__ == "__main__":
    unittest.main()
