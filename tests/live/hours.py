#!/usr/bin/env python3
"""Hours of the machine's time with a page that looks, as fast as possible: the server takes no more memory than at first.

    hours.py PLCXX ROOT [HOURS]
"""

import os
import sys

sys.dont_write_bytecode = True
from protocol import resident_kb  # noqa: E402
from server import Events, Server  # noqa: E402

MS_PER_HOUR = 3_600_000
MOST_KB = 2000  # after the past of 10,000 periods, which is kept, is full


def main(plcxx, root, hours="8"):
    with Server(plcxx, [os.path.join(root, "samples/nc110/lathe_16k20")], "/") as server:
        for name in ("MACON", "TURCOD", "T48U", "KEYON"):
            server.act("watch", name=name)
        server.act("speed", times=0)
        server.act("run")
        events = Events(server)
        sizes = []
        for hour in [0.1, *range(1, int(hours) + 1)]:
            events.until(lambda state, end=hour * MS_PER_HOUR: state.get("at", {"ms": 0})["ms"] >= end)
            sizes.append(resident_kb(server))
            print(f"{hour} h: {sizes[-1]} kB", flush=True)
        assert sizes[-1] - sizes[0] < MOST_KB, sizes


if __name__ == "__main__":
    main(*sys.argv[1:])
