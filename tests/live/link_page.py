#!/usr/bin/env python3
"""plcxx live --link: what the page is told of a running machine, and what it may do to it.

    link_page.py PLCXX ROOT
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from server import Events, Server  # noqa: E402
from station import Station, build  # noqa: E402


class Shown:
    """What a page knows: values by name."""

    def __init__(self, server):
        self.outline = server.get("/api/program")
        self.number = {signal["name"]: i for i, signal in enumerate(self.outline["signals"])}
        self.events = Events(server)
        self.events.next()

    def value(self, name):
        return self.events.state["values"].get(self.number[name])

    def until(self, name, value):
        self.events.until(lambda _: self.value(name) == value, f"{name} = {value}, which was {self.value(name)},")

    def until_link(self, **words):
        self.events.until(lambda state: all(state["link"][key] == value for key, value in words.items()))
        return self.events.state["link"]


def sees_values(server, station, shown):
    link = shown.until_link(connected=True, mayWrite=False)
    assert link["canWrite"] and link["reason"] == "", link
    assert shown.events.state["mode"]["running"], shown.events.state["mode"]
    count = shown.value("W3K0")
    shown.events.until(lambda _: shown.value("W3K0") not in (count, None))
    assert shown.events.state["at"]["period"] > 0
    station.tell("3")
    shown.until("I0A3", 1)
    shown.until("U4A8", 1)
    # The power flow follows: some nets carry power that did not before.
    shown.events.until(lambda state: state.get("power"))
    timer = next(name for name, i in shown.number.items() if shown.outline["signals"][i]["group"] == "instance")
    shown.events.until(lambda _: "done" in str(shown.value(timer)) or shown.value("U4A10") == 1)


def refuses_what_a_simulation_does(server, shown):
    refused = shown.outline["link"]["refused"]
    assert set(refused) >= {"run", "step", "back", "goTo", "powerOff", "switch", "breakStatement", "why", "save", "panelPress"}, refused
    for do, reason in refused.items():
        assert server.refused(do) == reason and reason, do
    assert "reading only" in server.refused("force", name="U4A9", value="0")
    assert "reading only" in server.refused("set", name="W2K2", value="1")
    assert "anew in each scan" in server.refused("toggle", name="I0A3")
    assert "'U4A9' takes 0 to 1" in server.refused("set", name="U4A9", value="2")
    assert "NOSUCH" in server.refused("watch", name="NOSUCH")
    assert "is not forced" in server.refused("release", name="U4A9")


def watches_with_a_trigger(server, station, shown):
    server.act("watch", name="W3K0")
    server.act("watch", name="I0A5")
    wish = {"baseMs": 10, "delayMs": 0, "samples": 20, "before": 50}
    assert "conditions" in server.refused("trigger", edge="condition", text="I0A5", **wish)
    assert "watch 'I0A4' first" in server.refused("trigger", edge="rising", text="I0A4", **wish)
    server.act("trigger", edge="rising", text="I0A5", **wish)
    time.sleep(0.3)
    station.tell("5")
    shown.events.until(lambda state: (state.get("trigger") or {}).get("state") == "complete" and "kept" in state)
    kept = shown.events.state["kept"]
    assert len(kept) == 20, kept
    scans = [sample[0] for sample in kept]
    assert scans == list(range(scans[0], scans[0] + 20)), scans
    counts = [sample[2][0] for sample in kept]
    assert counts == list(range(counts[0], counts[0] + 20)), counts
    edges = [sample[2][1] for sample in kept]
    assert edges == sorted(edges) and edges[0] == 0 and edges[-1] == 1, edges
    server.act("unwatch", number=0)
    server.act("triggerOff")
    station.tell("5")


def forces(server, station, shown):
    station.tell("w")
    shown.until_link(mayWrite=True)
    shown.until("U4A9", 1)
    server.act("force", name="I0A5", value="1")
    shown.events.until(lambda state: state["forced"] == [["I0A5", 1]])
    shown.until("U4A9", 0)
    assert shown.until_link(forcedBytes=1)
    server.act("toggle", name="I0A5")
    shown.until("U4A9", 1)
    server.act("release", name="I0A5")
    shown.events.until(lambda state: state["forced"] == [])
    shown.until_link(forcedBytes=0)
    # What the key switch takes away is gone, and said.
    server.act("force", name="U4A9", value="0")
    station.tell("r")
    shown.events.until(lambda state: state["forced"] == [] and any("let go" in note["text"] for note in state["notes"]))
    station.tell("w")
    shown.until_link(mayWrite=True)


def comes_back(server, program, socket, station, shown):
    server.act("force", name="U4A9", value="0")
    server.act("watch", name="U4A8")
    station.end()
    reason = shown.until_link(connected=False)["reason"]
    assert reason, shown.events.state["link"]
    assert not shown.events.state["mode"]["running"]
    assert "no connection" in server.refused("set", name="W2K2", value="1")
    # Another program is not believed, however its State looks.
    with Station(program, socket, "other"):
        shown.events.until(lambda state: "another program" in state["link"]["reason"])
    with Station(program, socket) as again:
        shown.until_link(connected=True)
        shown.events.until(lambda state: any("U4A9" in note["text"] for note in state["notes"]))
        shown.events.until(lambda state: state["forced"] == [])
        shown.until("U4A8", 0)
        again.tell("3")
        shown.until("U4A8", 1)
        shown.events.until(lambda state: any(sample[2][-1] == 1 for sample in state.get("more", [])))
        server.act("unwatch", number=0)
        # The end of the command lets go what it has forced.
        again.tell("w")
        shown.until_link(mayWrite=True)
        server.act("force", name="U4A8", value="0")
        assert server.end() == 0
        time.sleep(0.1)
        read = subprocess.run([server.process.args[0], "live", "lamp.plc", "--link", "socket:" + socket, "--read", "U4A8"],
                              cwd=os.path.dirname(socket), capture_output=True, text=True, check=False)
        assert read.stdout == "U4A8 = 1\n", (read.stdout, read.stderr)


def wrong_use(plcxx, folder, socket):
    def run(*arguments):
        return subprocess.run([plcxx, "live", "--no-browser", "lamp.plc", *arguments], cwd=folder, capture_output=True, text=True,
                              timeout=60, check=False)
    nobody = run("--link", "socket:" + socket + ".none")
    assert nobody.returncode == 1 and "no connection" in nobody.stderr, nobody
    assert run("--link", "socket:" + socket, "--for", "1s").returncode == 2
    assert run("--link", "socket:" + socket, "--panel", "x.yaml").returncode == 2


def main(plcxx, root):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program = build(plcxx, root, folder)
        socket = str(folder / "link.socket")
        wrong_use(plcxx, folder, socket)
        with Station(program, socket) as station, Server(plcxx, ["lamp.plc", "--link", "socket:" + socket], folder) as server:
            shown = Shown(server)
            sees_values(server, station, shown)
            refuses_what_a_simulation_does(server, shown)
            watches_with_a_trigger(server, station, shown)
            forces(server, station, shown)
            comes_back(server, program, socket, station, shown)
        with Station(program, socket, "other"):
            other = subprocess.run([plcxx, "live", "--no-browser", "lamp.plc", "--link", "socket:" + socket], cwd=folder,
                                   capture_output=True, text=True, timeout=60, check=False)
            assert other.returncode == 1 and "another program" in other.stderr, other
    print("plcxx live over a link: all as it should be")


if __name__ == "__main__":
    main(*sys.argv[1:])
