# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server on this machine: the client builds the session, the server computes."""

import os
import socket
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from session import Chain, check_equal, column, field, filters, load_plugin, pv, samples, servermanager


def free_port():
    with socket.socket() as test:
        test.bind(("127.0.0.1", 0))
        return test.getsockname()[1]


def main():
    port = free_port()
    server = subprocess.Popen(
        ["stdbuf", "-oL", os.environ["MEDIAL_PVSERVER"], "--server-port=%d" % port,
         "--hostname=127.0.0.1"], stdout=subprocess.PIPE, text=True)
    try:
        for line in server.stdout:
            if "Connection URL" in line:
                break
        pv.Connect("127.0.0.1", port)
        load_plugin(remote=True)
        load_plugin()
        chain = Chain(samples())
        surface = servermanager.Fetch(chain.crust)
        check_equal(field(surface, "Closed"), [1], "Closed")
        check_equal(field(surface, "BettiCrust"), [1, 0, 0], "BettiCrust")
        history = servermanager.Fetch(chain.prune, idx=1)
        check_equal(column(history, "Threshold")[:2], [5, 5], "Threshold")
        check_equal(column(history, "Measure"), [0, 0, 9, 3], "Measure")
        one = servermanager.Fetch(filters.SimplifyShape(Input=chain.balls.Input))
        check_equal(field(one, "Volume"), field(surface, "Volume"), "Volume")
    finally:
        server.kill()


main()
