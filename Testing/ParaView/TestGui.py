# SPDX-License-Identifier: BSD-3-Clause
"""Runs inside the user interface, before TestGui.xml clicks through the menu."""

import os
import sys
import traceback

sys.path.insert(0, os.environ["MEDIAL_TESTS"])


def main():
    from session import Chain, check_equal, field, filters, pv, samples, servermanager
    vars(filters).update((name, getattr(pv, name)) for name in dir(pv))
    source = samples()
    chain = Chain(source)
    view = pv.GetActiveViewOrCreate("RenderView")
    display = pv.Show(chain.prune, view)
    check_equal(list(display.ColorArrayName), ["CELLS", "PartRank"], "color of the parts")
    pv.Show(chain.crust, view).Opacity = 0.3
    pv.ResetCamera(view)
    pv.SaveScreenshot(os.path.join(os.getcwd(), "window.png"), pv.GetLayout())
    surface = servermanager.Fetch(chain.crust)
    check_equal(field(surface, "BettiCrust"), [1, 0, 0], "BettiCrust")
    pv.SetActiveSource(source)


try:
    main()
except BaseException:
    traceback.print_exc()
    sys.stderr.flush()
    os._exit(1) # the user interface would go on
