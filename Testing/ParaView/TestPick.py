# SPDX-License-Identifier: BSD-3-Clause
"""Runs inside the user interface: first before TestPick.xml, then as the macro that it calls after each
of its steps to see what the clicks have done."""

import os
import sys

sys.path.insert(0, os.environ["MEDIAL_TESTS"])
import session
from session import check_equal, column, field, filters, pv, servermanager


def pruned_axis():
    """What TestPick.xml finds: a pruned axis alone in the view, of which it selects some triangles."""
    session.show_pruned_axis()


def history():
    return servermanager.Fetch(pv.FindSource("MedialPrune2"), idx=1)


def nothing_is_removed():
    check_equal(pv.FindSource("MedialPrune2").Selection, None, "Selection")
    check_equal([value for value in column(history(), "ByHand") if value], [], "ByHand")


def picked_part_is_removed():
    second = pv.FindSource("MedialPrune2")
    assert second.Selection is not None, "nothing was copied"
    check_equal(column(history(), "ByHand")[-1:], [1], "ByHand")
    check_equal(column(history(), "Removed")[-1:], [1], "Removed")
    axis = servermanager.Fetch(second)
    check_equal(field(axis, "BettiAxis"), [1, 0, 0], "BettiAxis")


def picked_part_is_protected():
    check_equal(pv.FindSource("MedialPrune2").SelectionRole, "Protect", "SelectionRole")
    check_equal([value for value in column(history(), "ByHand") if value], [], "ByHand")
    assert 4 in column(servermanager.Fetch(pv.FindSource("MedialPrune2")).GetCellData(), "KeepReason")


def measures_are_chosen():
    rows = list(pv.FindSource("MedialPrune2").Schedule)
    measures = ["Area", "TriangleCount", "HausdorffDistance", "Area", "ErosionThickness"]
    check_equal(rows[0::3], measures, "measures")
    check_equal(column(history(), "Measure")[0], 3, "Measure")


def only_numbers_are_taken():
    rows = list(pv.FindSource("MedialPrune2").Schedule)
    check_equal(rows[6:9], ["HausdorffDistance", "0.05", "2"], "the third iteration")
    check_equal(column(history(), "Threshold")[2:3], [0.05], "Threshold")


def preset_is_taken(thresholds):
    """Of the iterations after the first two, which remove slivers."""
    rows = list(pv.FindSource("MedialPrune2").Schedule)
    check_equal(rows[:6], ["TriangleCount", "5", "0"] * 2, "the first two iterations")
    check_equal(rows[6:], thresholds, "the other iterations")
    check_equal(len(column(history(), "ByHand")), 3 + len(thresholds) // 3, "rows of the history")


def crust_has_its_axis():
    crust = pv.FindSource("PowerCrust1")
    check_equal(crust.Axis.SMProxy, pv.FindSource("MedialPrune2").SMProxy, "Axis")
    surface = servermanager.Fetch(crust)
    check_equal(field(surface, "BettiCrust"), [1, 0, 0], "BettiCrust")
    unpruned = filters.PowerCrust(Input=pv.FindSource("PolarBalls1"))
    assert field(surface, "Volume") < field(servermanager.Fetch(unpruned), "Volume"), "not pruned"
    os.write(1, b"PICKED\n")


steps = [pruned_axis, nothing_is_removed, picked_part_is_removed, picked_part_is_protected,
         measures_are_chosen, only_numbers_are_taken,
         lambda: preset_is_taken(["HausdorffDistance", "0.5s", "0", "HausdorffDistance", "1%", "0"]),
         lambda: preset_is_taken(["RelativeVolume", "0.01", "0"]), crust_has_its_axis]
session.take_step(steps)
