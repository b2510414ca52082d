#!/usr/bin/env python3
"""A sitting with Kate, set up as docs/editors/kate.md says: the file is asked about, and its error comes back.

Arguments in the environment: PLCXX, PLCXX_FOLDER (a copy of the sample lathe), PLCXX_PAGE (kate.md), HOME (an empty folder).
Kate shows nothing that could be read without a screen: what is looked at is the talk of its client with the server.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import time

SECONDS = 60


def set_up(home, page, plcxx):
    """The two files of the page, and the answer to the question that Kate asks once."""
    text = page.read_text()
    mode = home / ".local/share/org.kde.syntax-highlighting/syntax/plc.xml"
    servers = home / ".config/kate/lspclient/settings.json"
    for path, language in ((mode, "xml"), (servers, "json")):
        path.parent.mkdir(parents=True)
        path.write_text(re.search(rf"```{language}\n(.*?)```", text, re.S).group(1))
    command = json.loads(servers.read_text())["servers"]["plc"]["command"]
    (home / ".config/katerc").write_text(
        f"[Kate Plugins]\nlspclientplugin=true\n\n[lspclient]\nAllowedServerCommandLines={home}/bin/{' '.join(command)}\n")
    # In PATH, as the page wants it; what goes through it is written down.
    (home / "bin").mkdir()
    tool = home / "bin/plcxx"
    tool.write_text(f'#!/bin/bash\nexec "{plcxx}" "$@" < <(tee -a "{home}/asked") > >(tee -a "{home}/answered")\n')
    tool.chmod(0o755)


def check_mode(page):
    """The control's disks have names in capitals, and Kate tells the letters apart."""
    names = set(re.search(r'extensions="(.*?)"', page.read_text()).group(1).split(";"))
    assert {"*.plc", "*.sym", "*.il", "*.pst", "*.tch", "*.clp"} <= names, names
    assert all(name.upper() in names for name in names - {"*.clp"}), names


def messages(path):
    data = path.read_bytes() if path.exists() else b""
    found, at = [], 0
    while head := re.compile(rb"Content-Length: (\d+)\r\n(?:[^\r\n]+\r\n)*\r\n").match(data, at):
        end = head.end() + int(head.group(1))
        if end > len(data):
            break
        found.append(json.loads(data[head.end():end]))
        at = end
    return found


def errors_of(messages_, name):
    """Of the last list of the file; none: there was no list."""
    lists = [one["params"] for one in messages_ if one.get("method") == "textDocument/publishDiagnostics"]
    lists = [one["diagnostics"] for one in lists if one["uri"].endswith("/" + name)]
    return [one["code"] for one in lists[-1]] if lists else None


def main():
    home = pathlib.Path(os.environ["HOME"])
    folder = pathlib.Path(os.environ["PLCXX_FOLDER"])
    source = folder / "turret.plc"
    source.write_bytes(source.read_bytes().replace(b"\n!TURFWD =", b"\n!TURFWX =", 1))
    check_mode(pathlib.Path(os.environ["PLCXX_PAGE"]))
    set_up(home, pathlib.Path(os.environ["PLCXX_PAGE"]), os.environ["PLCXX"])
    (home / "run").mkdir(mode=0o700)
    del os.environ["XDG_DATA_HOME"], os.environ["XDG_CONFIG_HOME"]  # where the page says that the files are
    environment = {**os.environ, "PATH": f"{home}/bin:{os.environ['PATH']}", "QT_QPA_PLATFORM": "offscreen",
                   "XDG_RUNTIME_DIR": str(home / "run")}
    with open(home / "log", "w") as log:
        kate = subprocess.Popen(["kate", "--new", source], env=environment, cwd=folder, stdout=log, stderr=log)
    try:
        end = time.monotonic() + SECONDS
        while errors_of(messages(home / "answered"), source.name) is None:
            if time.monotonic() > end or kate.poll() is not None:
                sys.exit(f"no messages of {source.name}; Kate says:\n" + (home / "log").read_text()[-2000:])
            time.sleep(0.1)
    finally:
        kate.kill()
        kate.wait()
    opened = next(one["params"]["textDocument"] for one in messages(home / "asked")
                  if one.get("method") == "textDocument/didOpen")
    assert "Станок" in opened["text"], "it is opened in its code page"
    found = errors_of(messages(home / "answered"), source.name)
    assert found == ["nc110-49"], found
    print("kate: as it should be")


main()
