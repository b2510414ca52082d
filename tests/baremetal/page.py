#!/usr/bin/env python3
"""The page of the lathe on an emulated board: plcxx live --link, as a browser speaks with it.

page.py BOARD PLCXX ROOT BUILD EMULATOR...

Over QEMU's character devices: a socket's file or TCP, and a serial line. The page shows what the board computes, and what
the operator does to it there reaches the program; a board that permits reading only is not changed; one that is switched
off and on again is found again, with nothing forced.
"""
import contextlib
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from board import Board, free_port  # noqa: E402

PLCXX, ROOT = sys.argv[2], pathlib.Path(sys.argv[3])
BOARD = Board(sys.argv[1], sys.argv[4], sys.argv[5:])
LATHE = ROOT / "samples" / "nc110" / "lathe_16k20"
sys.path.insert(0, str(ROOT / "tests" / "live"))
from link_page import Shown  # noqa: E402
from server import Server  # noqa: E402


def sees(shown):
    link = shown.until_link(connected=True)
    assert link["reason"] == "", link
    for name, value in (("P24OK", 1), ("DOOR", 1), ("TURCOD", 0x31), ("GUARD", 1)):
        shown.until(name, value)
    # Pictures of the whole machine, one after the other; its clock goes on.
    period = shown.events.state["at"]["period"]
    shown.events.until(lambda state: state["at"]["period"] > period + 20)
    shown.events.until(lambda state: state.get("power"))


def sees_it_fall(server, shown):
    """An input against what the board reads: the program answers to it. Whether there is a picture from before the edge,
    too: the board goes on by its clock, and where an emulated network has the host wait, some are missing."""
    server.act("trigger", edge="falling", text="DOOR", baseMs=10, delayMs=0, samples=200, before=50)
    server.act("force", name="DOOR", value="0")
    shown.until("GUARD", 0)
    shown.events.until(lambda state: (state.get("trigger") or {}).get("state") == "complete" and "kept" in state)
    kept = shown.events.state["kept"]
    doors = [sample[2][0] for sample in kept]
    assert len(kept) > 10 and doors == sorted(doors, reverse=True) and doors[-1] == 0, kept
    return doors[0] == 1


def operates(server, shown):
    shown.until_link(mayWrite=True)
    # The board makes parts all the time, but not 256 of them.
    server.act("set", name="CNTHIGH", value="42")
    shown.until("CNTHIGH", 42)
    server.act("watch", name="DOOR")
    server.act("watch", name="GUARD")
    for _ in range(4):
        if sees_it_fall(server, shown):
            break
        server.act("releaseAll")
        shown.until("GUARD", 1)
    else:
        raise AssertionError(f"no picture from before the edge: {shown.events.state['kept']}")
    assert shown.until_link(forcedBytes=1)
    server.act("releaseAll")
    shown.until("GUARD", 1)
    shown.until_link(forcedBytes=0)
    assert "anew in each scan" in server.refused("toggle", name="DOOR")
    server.act("force", name="DOOR", value="0")
    shown.until("GUARD", 0)


def comes_back(server, shown):
    shown.until_link(connected=True)
    shown.events.until(lambda state: state["forced"] == [] and any("DOOR" in note["text"] for note in state["notes"]))
    shown.until("GUARD", 1)
    shown.until("CNTHIGH", 0)
    server.act("unwatch", number=0)


def page(address, folder):
    return Server(PLCXX, [str(LATHE), "--link", address], folder)


def operate(transport, folder):
    port = free_port()
    with contextlib.ExitStack() as servers:  # one that is left would take the next machine's link
        with BOARD.running("linked", transport, folder, port) as address:
            server = servers.enter_context(page(address, folder))
            shown = Shown(server)
            sees(shown)
            operates(server, shown)
        assert shown.until_link(connected=False)["reason"]
        assert "no connection" in server.refused("set", name="CNTHIGH", value="1")
        if transport != "serial":  # another pseudo terminal has another name
            with BOARD.running("linked", transport, folder, port):
                comes_back(server, shown)
        assert server.end() == 0
    with BOARD.running("linked_shown", transport, folder) as address, page(address, folder) as server:
        shown = Shown(server)
        sees(shown)
        shown.until_link(canWrite=False)
        for do in ("set", "force"):
            assert "reading only" in server.refused(do, name="CNTHIGH", value="1"), do
        shown.until("CNTHIGH", 0)
    print(f"{BOARD.name}, {transport}: the page shows the board, and operates it")


with tempfile.TemporaryDirectory(prefix="plcxx-test-") as name:
    for kind in ("socket", "serial") if BOARD.name == "riscv" else ("tcp", "serial"):
        BOARD.patiently(lambda: operate(kind, pathlib.Path(name)))
