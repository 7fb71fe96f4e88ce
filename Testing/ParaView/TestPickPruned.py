# SPDX-License-Identifier: BSD-3-Clause
"""Runs inside the user interface: first before TestPickPruned.xml, then as the macro that it calls
between its steps to see what the clicks have done and to show what is picked next."""

import os
import sys

sys.path.insert(0, os.environ["MEDIAL_TESTS"])
import session
from session import check_equal, column, field, filters, pv, servermanager


def prune():
    return pv.FindSource("MedialPrune1")


def ids(selection):
    """The ids in all lists of a selection, without numbers of processes."""
    return [number for one in selection.Input for number in list(one.IDs)[1::2]]


def note_picks(port=0):
    """Notes the cells of the input that are picked at an output, before the outputs change."""
    before = getattr(session, "picked", None)
    active = prune().SMProxy.GetSelectionInput(port)
    picks = ids(servermanager._getPyProxy(active))
    assert picks, "nothing was picked"
    lead = column(servermanager.Fetch(prune(), idx=port).GetCellData(), "InputCell")
    session.picked = sorted(int(lead[cell]) for cell in picks)
    assert session.picked != sorted(picks), "the ids are the same: the test tests nothing"
    assert session.picked != before, "the same as before: the test tests nothing"


def check_copied():
    check_equal(sorted(ids(prune().Selection)), session.picked, "ids of the input")


def show_only(source, port=0):
    view = pv.GetActiveView()
    pv.HideAll(view)
    pv.Show(servermanager.OutputPort(source, port), view)
    pv.SetActiveSource(prune())
    pv.Render()


def removed_by_hand():
    """The cells of the input that were removed by hand."""
    rows = servermanager.Fetch(prune(), idx=1)
    check_equal(column(rows, "ByHand")[-1:], [1], "ByHand")
    removed = servermanager.Fetch(prune(), idx=2).GetCellData()
    last = column(rows, "Iteration")[-1]
    return {int(cell) for cell, row in zip(column(removed, "InputCell"),
                                           column(removed, "Iteration")) if row == last}


def pruned_axis():
    """What TestPickPruned.xml finds: a pruned axis alone in the view."""
    session.show_pruned_axis()
    crust = filters.PowerCrust(registrationName="PowerCrust1", Input=pv.FindSource("PolarBalls1"),
                               Axis=prune())
    crust.UpdatePipeline()
    pv.SetActiveSource(prune())
    pv.Render()


def their_part_is_removed():
    check_copied()
    assert set(session.picked) <= removed_by_hand(), "another part was removed"
    check_equal(field(servermanager.Fetch(prune()), "BettiAxis"), [1, 0, 0], "BettiAxis")
    show_only(prune(), 2)


def removed_cells_are_translated():
    check_copied()
    show_only(prune())


def several_picks_are_translated():
    check_copied()


def note_points():
    session.picked = sorted(ids(servermanager._getPyProxy(prune().SMProxy.GetSelectionInput(0))))
    assert session.picked, "nothing was picked"


def points_keep_their_numbers():
    check_copied()
    show_only(pv.FindSource("PowerCrust1"))


def back_to_the_filter():
    pv.SetActiveSource(prune())


def other_cells_are_refused():
    check_copied()
    os.write(1, b"PICKED\n")


steps = [pruned_axis, note_picks, their_part_is_removed, lambda: note_picks(2),
         removed_cells_are_translated, note_picks, several_picks_are_translated, note_points,
         points_keep_their_numbers, back_to_the_filter, other_cells_are_refused]
session.take_step(steps)
