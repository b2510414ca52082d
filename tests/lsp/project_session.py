#!/usr/bin/env python3
"""What a plcxx.yaml says to plcxx lsp beside the sources: warnings that are accepted, and which program a file
belongs to, why a signal is so in its scenarios, its plant and its panel.

usage: project_session.py PLCXX PROJECT
"""
import pathlib
import subprocess
import sys
import tempfile

from client import Client, uri_of

PROGRAM = ":MOD PM 9\n:A I 0.0\n:= F 5.2\n:END PM 9\n"
PROJECT = "name: mill\ndialect: prostep\nsources: [mill.plc]\nwarnings: {baseline: plcxx.baseline}\n"


def codes(found):
    return sorted(one["code"] for one in found if "code" in one)


def baseline(plcxx, folder):
    """Accepted warnings are not shown, as check does not show them; new ones are."""
    source, project, accepted = folder / "mill.plc", folder / "plcxx.yaml", folder / "plcxx.baseline"
    source.write_text(PROGRAM)
    project.write_text(PROJECT.replace("warnings", "# warnings"))
    before = Client(plcxx)
    before.open(source, PROGRAM)
    all_of_them = codes(before.wait_for(source, 1))
    assert all_of_them, "the program has warnings"
    assert before.shut_down() == 0

    project.write_text(PROJECT)
    subprocess.run([plcxx, "check", "--write-baseline"], cwd=folder, check=True, capture_output=True)
    client = Client(plcxx)
    client.open(source, PROGRAM)
    assert client.wait_for(source, 1) == []
    more = PROGRAM.replace(":END PM 9", ":A I 0.1\n:= F 5.3\n:END PM 9")
    client.change(source, [{"text": more}], 2)
    fresh = client.wait_for(source, 2)
    assert codes(fresh) and all(one["range"]["start"]["line"] == 4 for one in fresh), fresh
    client.change(source, [{"text": "\n\n" + PROGRAM}], 3)
    assert client.wait_for(source, 3) == [], "a statement that moves keeps its warnings accepted"

    accepted.write_text("no baseline\n")
    client.open(project, PROJECT)
    faults = client.wait_for(project, 1)
    assert len(faults) == 1 and "plcxx.baseline" in faults[0]["message"], faults
    client.change(source, [{"text": PROGRAM}], 4)
    assert codes(client.wait_for(source, 4)) == all_of_them, "without a baseline nothing is accepted"
    accepted.unlink()
    client.change(project, [{"text": PROJECT.replace("warnings", "# warnings")}], 2)
    assert client.wait_for(project, 2) == []
    assert client.shut_down() == 0


def program_of(plcxx, root, folder):
    """plcxx/program: of a file that is open or not, of one without project, of none."""
    lathe = root / "samples/nc110/lathe_16k20"
    client = Client(plcxx)
    said = client.request("plcxx/program", {"textDocument": {"uri": uri_of(lathe / "fast.plc")}})
    assert said["dialect"] == "nc110" and said["program"] == "lathe", said
    assert said["project"] == str((lathe / "plcxx.yaml").resolve()), said
    assert [pathlib.Path(source).name for source in said["sources"]] == ["lathe.sym", "fast.plc", "spindle.plc", "turret.plc"]
    mill = root / "samples/hnc/mill_xk7132"
    said = client.request("plcxx/program", {"textDocument": {"uri": uri_of(mill / "axes.h")}})
    assert said["dialect"] == "hnc", "a file that is included"
    assert client.request("plcxx/program", {"textDocument": {"uri": uri_of(root / "LICENSE")}}) is None
    assert "error" in client.raw_request("plcxx/program", {})
    alone = folder / "alone" / "x.plc"
    alone.parent.mkdir()
    assert client.request("plcxx/program", {"textDocument": {"uri": uri_of(alone)}}) is None
    client.open(alone, PROGRAM)
    said = client.request("plcxx/program", {"textDocument": {"uri": uri_of(alone)}})
    assert said == {"dialect": "prostep", "project": None, "program": "", "sources": [str(alone.resolve())]}, said
    client.close(alone)
    # The client's name of the language counts where no project says it.
    for language, dialect in [("technol", "technol"), ("plc", "prostep")]:
        client.notify("textDocument/didOpen",
                      {"textDocument": {"uri": uri_of(alone), "languageId": language, "version": 1, "text": PROGRAM}})
        said = client.request("plcxx/program", {"textDocument": {"uri": uri_of(alone)}})
        assert said["dialect"] == dialect, (language, said)
        client.close(alone)
    assert client.shut_down() == 0


PLANT = """elements:
- cylinder: {name: door, extend: U4A8, extend-time: 200 ms, retract-time: 100 ms, extended: I0A6, retracted: I0A7}
"""
PANEL = """groups:
- controls:
  - button: {text: GO, input: I0A3, lamp: U4A9}
"""


def machine(plcxx, folder):
    """The plant and the panel of a program are checked as they are in the editor, and complete its locations."""
    folder.mkdir()
    source, plant, panel = folder / "door.plc", folder / "plant.yaml", folder / "panel.yaml"
    source.write_text("$\nU4A8=I0A3*I0A4\nU4A9=I0A6*U4A8\n")
    plant.write_text(PLANT)
    panel.write_text(PANEL)
    (folder / "plcxx.yaml").write_text("name: door\ndialect: nc110\nsources: [door.plc]\nplant: plant.yaml\npanel: panel.yaml\n")
    client = Client(plcxx)
    client.open(plant, PLANT)
    assert client.wait_for(plant, 1) == []
    client.change(plant, [{"text": PLANT.replace("extend: U4A8", "extend: NOPE").replace("name: door,", "name: door, stroke: 5,")}], 2)
    faults = client.wait_for(plant, 2)
    assert len(faults) == 1 and "stroke" in faults[0]["message"] and faults[0]["range"]["start"]["line"] == 1, faults
    client.change(plant, [{"text": PLANT.replace("extend: U4A8", "extend: NOPE")}], 3)
    faults = client.wait_for(plant, 3)
    assert len(faults) == 1 and "NOPE" in faults[0]["message"] and faults[0]["range"]["start"]["character"] == 33, faults
    client.change(plant, [{"text": PLANT}], 4)
    assert client.wait_for(plant, 4) == []
    # What the plant drives is no button's.
    client.open(panel, PANEL.replace("I0A3", "I0A6"))
    faults = client.wait_for(panel, 1)
    assert len(faults) == 1 and "driven by the plant" in faults[0]["message"], faults
    client.change(panel, [{"text": PANEL}], 2)
    assert client.wait_for(panel, 2) == []
    # Another program: a location that is gone.
    client.open(source, "$\nU4A8=I0A3*I0A4\nU4A9=I0A6*\n")
    assert client.wait_for(source, 1)
    at = {"textDocument": {"uri": uri_of(plant)}, "position": {"line": 1, "character": 36}}
    labels = [item["label"] for item in client.request("textDocument/completion", at)["items"]]
    assert "U4A8" in labels and "I0A3" not in labels, labels
    assert client.request("textDocument/hover", at) is None
    assert client.shut_down() == 0


def why(plcxx, folder):
    """Why a signal is what it is at the end of each scenario that runs the program, of the text as it is in the editor."""
    source = folder / "lamp.plc"
    source.write_text("$\nU4A8=I0A3*I0A4\n")
    (folder / "plcxx.yaml").write_text("name: lamp\ndialect: nc110\nsources: [lamp.plc]\n")
    (folder / "scenarios").mkdir()
    steps = "steps:\n- set: {I0A3: 1}\n- run: {slow: 2}\n"
    (folder / "scenarios" / "one.yaml").write_text(steps)
    (folder / "scenarios" / "other.yaml").write_text(f"dialect: nc110\nsources: [other.plc]\n{steps}")
    (folder / "scenarios" / "other.plc").write_text("$\nU4A8=I0A5\n")
    (folder / "scenarios" / "broken.yaml").write_text("steps: 7\n")
    client = Client(plcxx)
    client.open(source, "$\nU4A8=I0A3*I0A4\n")
    at = {"start": {"line": 1, "character": 0}, "end": {"line": 1, "character": 0}}
    asked = {"textDocument": {"uri": uri_of(source)}, "range": at, "context": {"diagnostics": []}}
    actions = [one for one in client.request("textDocument/codeAction", asked) if one["kind"] == "plcxx.why"]
    assert [one["title"] for one in actions] == ["Why is U4A8 so at the end of one.yaml?"], actions
    command = {key: actions[0]["command"][key] for key in ("command", "arguments")}
    text = client.request("workspace/executeCommand", command)
    assert text.startswith("U4A8 is 0 at 10 ms: ") and "\n  I0A4 is 0: as at power-on\n" in text, text
    assert [one["params"]["message"] for one in client.messages if one["method"] == "window/showMessage"] == [text]
    client.change(source, [{"text": "$\nU4A8=I0A3*I0A5\n"}], 2)
    text = client.request("workspace/executeCommand", command)
    assert "I0A5 is 0" in text, "a buffer that is not saved counts"
    nothing = {"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 0}}
    assert client.request("textDocument/codeAction", {**asked, "range": nothing}) == []
    argument = command["arguments"][0]
    for wrong in ({"command": "rm"}, {"command": "plcxx.why"}, {"command": "plcxx.why", "arguments": [7]},
                  {"command": "plcxx.why", "arguments": [{**argument, "scenario": "/etc/passwd"}]},
                  {"command": "plcxx.why", "arguments": [{**argument, "signal": 5}]}):
        assert "error" in client.raw_request("workspace/executeCommand", wrong), wrong
    unknown = {"command": "plcxx.why", "arguments": [{**argument, "signal": "NOPE"}]}
    assert "is no location" in client.request("workspace/executeCommand", unknown)
    assert client.shut_down() == 0


def main():
    plcxx, root = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as directory:
        folder = pathlib.Path(directory).resolve()
        (folder / "baseline").mkdir()
        baseline(plcxx, folder / "baseline")
        program_of(plcxx, pathlib.Path(root), folder)
        (folder / "why").mkdir()
        why(plcxx, folder / "why")
        machine(plcxx, folder / "machine")


if __name__ == "__main__":
    main()
