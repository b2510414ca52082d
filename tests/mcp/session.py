#!/usr/bin/env python3
"""Each tool of `plcxx mcp` on small programs, and clients that are broken or ask for too much."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

LAMP = """$
U4A8=I0A3*/I0A4+U4A8*I0A5
"""
CHANGED = LAMP.replace("/I0A4", "I0A4")
SCENARIO = """dialect: nc110
sources: [lamp.plc]
steps:
- set: {I0A3: 1}
- run: {slow: 1}
- expect: {U4A8: 1}
"""

# Two words that this makes the same are the same, which no solver finds in seconds.
MIXED = """#include "plc.h"
static unsigned long a, b, p, q;
void init() { plc1_time = 16; plc2_time = 32; }
void plc1()
{
    a = ((unsigned long)X[0] << 24) | ((unsigned long)X[1] << 16) | ((unsigned long)X[2] << 8) | X[3];
    b = ((unsigned long)X[4] << 24) | ((unsigned long)X[5] << 16) | ((unsigned long)X[6] << 8) | X[7];
    p = a;
    q = b;
    p ^= p >> 16; p *= 0x85ebca6bul; p ^= p >> 13; p *= 0xc2b2ae35ul; p ^= p >> 16;
    q ^= q >> 16; q *= 0x85ebca6bul; q ^= q >> 13; q *= 0xc2b2ae35ul; q ^= q >> 16;
    if (p == q && a != b) Y[0] |= 1;
}
void plc2() {}
"""


class Client:
    def __init__(self, plcxx, folder, *options):
        self.process = subprocess.Popen([plcxx, "mcp", str(folder), *options], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        self.next_id = 1

    def send_line(self, line):
        self.process.stdin.write(line + b"\n")
        self.process.stdin.flush()

    def receive(self):
        line = self.process.stdout.readline()
        assert line, "the server is gone"
        return json.loads(line)

    def ask(self, method, params=None):
        number = self.next_id
        self.next_id += 1
        self.send_line(json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params or {}}).encode())
        answer = self.receive()
        assert answer["id"] == number, answer
        return answer

    def call(self, tool, **arguments):
        answer = self.ask("tools/call", {"name": tool, "arguments": arguments})
        assert "error" not in answer, (tool, answer)
        result = answer["result"]
        assert json.loads(result["content"][0]["text"]) == result["structuredContent"], tool
        return result["structuredContent"]

    def refused(self, tool, **arguments):
        answer = self.ask("tools/call", {"name": tool, "arguments": arguments})
        assert "error" in answer, (tool, arguments, answer)
        assert answer["error"]["code"] == -32602, answer
        return answer["error"]["message"]

    def end(self):
        self.process.stdin.close()
        assert self.process.wait(timeout=30) == 0


def files_of(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def tools(client, folder):
    listed = client.ask("tools/list")["result"]["tools"]
    names = {tool["name"] for tool in listed}
    assert names >= {"project", "check", "explain", "emit", "simulate", "test", "why",
                     "diff", "prove", "cross_reference", "ladder"}
    for tool in listed:
        assert tool["inputSchema"]["type"] == "object" and tool["description"], tool

    found = client.call("project")
    assert found["sources"] == ["lamp.plc", "new/lamp.plc", "wrong.plc"] and found["scenarios"] == ["lamp.yaml"], found

    assert client.call("check", sources=["lamp.plc"])["ok"]
    found = client.call("why", signal="U4A8", scenario="lamp.yaml")
    assert [one["signal"] for one in found["why"]["conditions"]] == ["U4A8", "I0A3", "I0A4"], found
    assert found["why"]["conditions"][0]["statement"]["line"] == 2, found
    found = client.call("why", signal="U4A8", can=True, sources=["lamp.plc"])
    assert found["why"]["can"] == "shown" and "I0A3: 1" in found["why"]["scenario"], found
    assert "scenario" in client.refused("why", signal="U4A8")

    found = client.call("check", sources=["wrong.plc"])
    assert not found["ok"] and found["exitCode"] == 1, found
    first = found["diagnostics"][0]
    assert (first["code"], first["file"], first["line"], first["column"]) == ("nc110-1", "wrong.plc", 2, 6), first
    assert client.call("check", sources=["lamp.plc"], options={"slices": 2})["ok"]
    assert client.call("check", sources=["lamp.plc"], options={"no-such": 2})["exitCode"] == 2

    assert client.call("explain", code="nc110-1")["page"].startswith("# nc110-1")
    assert "nc110-1" in client.call("explain")["codes"]

    before = files_of(folder)
    shown = client.call("emit", sources=["lamp.plc"])
    assert {"lamp.cpp", "lamp.hpp"} <= {one["name"] for one in shown["files"]}, shown
    assert files_of(folder) == before, "what is only shown is not written"
    client.call("emit", sources=["lamp.plc"], output="generated")
    assert (folder / "generated" / "lamp.cpp").exists()

    found = client.call("simulate", sources=["lamp.plc"], watch=["I0A3", "U4A8"], at=["100ms:I0A3=1"],
                        changes=False, **{"for": "300ms"})
    assert found["columns"] == ["ms", "I0A3", "U4A8"], found
    assert len(found["rows"]) >= 2, found

    # A byte is shown as bits and as a number: it is one column.
    found = client.call("simulate", sources=["lamp.plc"], watch=["U4A8", "W4A1", "W0A0"], at=["10ms:W0A0=10"],
                        changes=False, **{"for": "30ms"})
    assert found["columns"] == ["ms", "U4A8", "W4A1", "W0A0"], found
    assert [row["W0A0"] for row in found["rows"]] == ["0", "10", "10"], found
    assert all(set(row) == {"ms", "U4A8", "W4A1", "W0A0"} for row in found["rows"]), found

    assert client.call("test", scenarios=["lamp.yaml"])["passed"]
    (folder / "failing.yaml").write_text(SCENARIO.replace("U4A8: 1", "U4A8: 0"))
    found = client.call("test", scenarios=["failing.yaml"])
    assert not found["passed"] and "U4A8" in json.dumps(found), found

    found = client.call("diff", old="lamp.plc", new="new/lamp.plc")
    assert found["exitCode"] == 1 and "U4A8" in json.dumps(found["diff"]), found
    assert client.call("diff", old="lamp.plc", new="lamp.plc")["exitCode"] in (0, 2)

    found = client.call("prove", sources=["lamp.plc"], properties=["never U4A8 and I0A4 and not U4A8"])
    assert "proof" in found or "messages" in found, found
    found = client.call("prove", sources=["lamp.plc"], properties=["never U4A8"])
    assert found["exitCode"] == 1 and "violated" in json.dumps(found["proof"]), found

    found = client.call("cross_reference", sources=["lamp.plc"], signal="U4A8")
    assert found["signals"][0]["written"] == [{"file": "lamp.plc", "line": 2}], found

    found = client.call("ladder", sources=["lamp.plc"])["ladder"]
    assert found == """routine slow
; lamp.plc:2  U4A8=I0A3*/I0A4+U4A8*I0A5
|--+--[ I0A3 ]--[/I0A4 ]--+--( U4A8 )
|  +--[ U4A8 ]--[ I0A5 ]--+
""", found
    assert "U4A8" not in client.call("ladder", sources=["lamp.plc"], signal="U9A9")["ladder"]
    found = client.call("ladder", sources=["lamp.plc"], signal="U4AA8")
    assert found["exitCode"] == 2 and "did you mean 'U4A8'" in found["messages"], found
    found = client.call("prove", sources=["lamp.plc"], properties=["never U4AA8"])
    assert found["messages"].startswith("properties:1:7: error: 'U4AA8' is no location"), found


def of_a_project(client, folder):
    """What plcxx.yaml says needs no argument; a folder's name may have a blank in it."""
    (folder / "cell 1").mkdir()
    (folder / "cell 1" / "lamp.plc").write_text((folder / "lamp.plc").read_text())
    (folder / "cell 1" / "lamp.prop").write_text("U4A8 implies U4A8\n")
    (folder / "cell 1" / "lit.yaml").write_text("steps:\n- run: {slow: 1}\n- expect: {U4A8: 0}\n")
    (folder / "plcxx.yaml").write_text("folder: cell 1\ndialect: nc110\nsources: lamp.plc\nproperties: lamp.prop\n")
    found = client.call("test")
    assert found["passed"] and "cell 1/lit.yaml" in found["report"], found
    found = client.call("prove")
    assert found["proof"]["properties"][0]["verdict"] == "proved", found
    found = client.call("cross_reference", signal="U4A8")
    assert found["signals"][0]["written"] == [{"file": "cell 1/lamp.plc", "line": 2}], found
    assert "git" in client.call("diff")["messages"]
    (folder / "plcxx.yaml").unlink()


def ends_in_time(client, folder):
    """What was found until then is the answer: the tool is given less time than after which it is ended."""
    (folder / "mixed.cld").write_text(MIXED)
    (folder / "other.cld").write_text(MIXED.replace("|= 1", "|= 3"))
    sources = ["mixed.cld"]
    for properties in (["never Y0.0"], ["never Y0.0", "never Y0.0 and X0.0"]):
        found = client.call("prove", sources=sources, properties=properties, seconds=4)
        verdicts = [(one["verdict"], one.get("reason")) for one in found.get("proof", {"properties": []})["properties"]]
        assert verdicts == [("not decided", "the time was not enough")] * len(properties), found
    found = client.call("why", signal="Y0.0", can=True, sources=sources, seconds=4)
    assert not found.get("timedOut") and found["why"]["can"] == "undecided", found
    found = client.call("diff", old="mixed.cld", new="other.cld", seconds=4)
    assert not found.get("timedOut") and found["diff"], found


def wrong(client, folder, outside):
    for path in ["../outside.plc", "/etc/passwd", "-o", "", "new/../../outside.plc", "link/outside.plc"]:
        client.refused("check", sources=[path])
        client.refused("emit", sources=["lamp.plc"], output=path)
        client.refused("test", scenarios=[path])
        client.refused("diff", old=path, new="lamp.plc")
        if path:
            client.refused("ladder", sources=["lamp.plc"], options={"help": path})
            client.refused("emit", sources=["lamp.plc"], options={"messages": path})
    client.refused("ladder", sources=["lamp.plc"], options={"help": "-"})
    client.refused("ladder", sources=["lamp.plc"], options={"help=../outside.plc": ""})
    client.refused("ladder", sources=["lamp.plc"], include=["new"], options={"help": "way/outside.plc"})
    (folder / "plcxx.yaml").write_text("folder: new\ndialect: nc110\nsources: lamp.plc\n")
    client.refused("ladder", options={"help": "way/outside.plc"})
    (folder / "plcxx.yaml").unlink()
    (folder / "help").write_text("I0A3 START\n")
    assert client.call("ladder", sources=["lamp.plc"], options={"help": "help", "slices": 2})["exitCode"] == 0
    client.refused("check", sources="lamp.plc")
    client.refused("check", sources=[7])
    client.refused("check")
    assert "plcxx.yaml" in client.refused("check", sources=[]), "no project either"
    client.refused("check", project="../plcxx.yaml")
    client.refused("check", sources=["lamp.plc"], colour="red")
    client.refused("check", sources=["lamp.plc"], options=["slices"])
    client.refused("check", sources=["lamp.plc"], seconds="soon")
    client.refused("check", sources=["lamp.plc"], seconds=0)
    client.refused("check", sources=["lamp.plc"], dialect="--help")
    client.refused("emit", sources=["lamp.plc"], name="-x")
    client.refused("explain", code="nc110-99999")
    client.refused("no_such_tool")
    assert client.ask("tools/call", {"name": 7})["error"]["code"] == -32602
    assert client.ask("tools/call", {"name": "check", "arguments": [1]})["error"]["code"] == -32602
    assert client.ask("no/such")["error"]["code"] == -32601
    client.send_line(b"{")
    assert client.receive()["error"]["code"] == -32700
    client.send_line(b"\xff\xfe")
    assert client.receive()["error"]["code"] == -32700
    assert client.call("check", sources=["missing.plc"])["exitCode"] != 0
    found = client.call("simulate", sources=["lamp.plc"], watch=["U4A8"], seconds=1, changes=False, **{"for": "20min"})
    assert found.get("timedOut") or found.get("cutOff") or found["exitCode"] != 0, list(found)
    assert outside.read_text() == "secret", "nothing outside is written"


def main():
    plcxx, root = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as directory:
        folder = pathlib.Path(directory) / "machine"
        (folder / "new").mkdir(parents=True)
        outside = pathlib.Path(directory) / "outside.plc"
        outside.write_text("secret")
        (folder / "lamp.plc").write_text(LAMP)
        (folder / "new" / "lamp.plc").write_text(CHANGED)
        (folder / "wrong.plc").write_text("$\nU4A0=IOA7\n")
        (folder / "lamp.yaml").write_text(SCENARIO)
        client = Client(plcxx, folder)
        info = client.ask("initialize", {"protocolVersion": "2025-03-26", "capabilities": {}, "clientInfo": {"name": "x", "version": "1"}})
        assert info["result"]["protocolVersion"] == "2025-03-26" and info["result"]["serverInfo"]["name"] == "plcxx", info
        client.send_line(b'{"jsonrpc":"2.0","method":"notifications/initialized"}')
        assert client.ask("ping")["result"] == {}
        tools(client, folder)
        of_a_project(client, folder)
        ends_in_time(client, folder)
        (folder / "link").symlink_to(directory)
        (folder / "new" / "way").symlink_to(directory)
        wrong(client, folder, outside)
        client.end()
        for dialect, folder_name, sources in [("host50", "ck6150", None)]:
            sample = pathlib.Path(directory) / dialect
            shutil.copytree(pathlib.Path(root) / "samples" / dialect / folder_name, sample)
            client = Client(plcxx, sample)
            sources = ["ck6150.il", "texts.il", "fast.il", "main.il", "spindle.il", "turret.il", "units.il", "mcodes.il"]
            assert client.call("check", sources=sources)["ok"]
            assert client.call("check")["ok"], "by plcxx.yaml"
            said = client.call("project")["projects"][0]["programs"][0]
            assert said["dialect"] == "host50" and said["sources"] == sources, said
            ladder = client.call("ladder", sources=sources, signal="HYD_FAULT")["ladder"]
            assert "(S HYD_FAULT )" in ladder and "(R HYD_FAULT )" in ladder, ladder
            assert client.call("test", scenarios=["power_on.yaml"])["passed"]
            client.end()


if __name__ == "__main__":
    main()
