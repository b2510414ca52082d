#!/usr/bin/env python3
"""What a plcxx.yaml says to plcxx lsp beside the sources: warnings that are accepted, and which program a file belongs to.

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


def main():
    plcxx, root = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as directory:
        folder = pathlib.Path(directory).resolve()
        (folder / "baseline").mkdir()
        baseline(plcxx, folder / "baseline")
        program_of(plcxx, pathlib.Path(root), folder)


if __name__ == "__main__":
    main()
