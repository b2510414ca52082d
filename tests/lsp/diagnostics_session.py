#!/usr/bin/env python3
"""Diagnostics while typing: the same as `plcxx check` of the saved files, in all languages and encodings, after random
edits as in a fresh server; and clients that are broken."""
import json
import pathlib
import random
import sys
import tempfile
import time

from client import Client, uri_of
from programs import FOLDERS, Sample, as_check_says, as_client_sees

EDITS = 200  # of each language
TOGGLES = 80  # of a header, a macro, a type, a function in C

HEADER = """#define SIZE 8
#define MASK 7
#define LIMIT 100
#define x(g,b) (X[g]&(1<<(b)))
typedef int INT;
typedef struct { INT low; INT high; } BOUNDS;
INT limited(INT v, INT most);
"""
MAIN = """#include "plc.h"
#include "types.h"
unsigned total;
INT table[SIZE];
BOUNDS bounds = { 0, LIMIT };
INT limited(INT v, INT most) { return v > most ? most : v < bounds.low ? bounds.low : v; }
void count(void)
{
    INT i;
    for (i = 0; i < SIZE; i++) table[i] = limited(table[i] + 1, bounds.high);
    if (x(1,2)) total++; else R[0] = table[total & MASK];
}
void wait(void)
{
    static unsigned left = 3;  // scans
    if (left > 2) { left--; }
    R[5] = left;
}
void init() { plc1_time = 16; plc2_time = 32; }
void plc1() { count(); }
void plc2() { bounds.high = LIMIT; wait(); }
"""
# Of the header, then of the source: what may be written instead. Each is somewhere else in the text.
CHANGES = [("types.h", "SIZE 8", "SIZE 4"), ("types.h", "MASK 7", "MASK 15"), ("types.h", "LIMIT 100", "LIMIT 70000"),
           ("types.h", "(1<<(b))", "1<<b"), ("types.h", "typedef int INT", "typedef unsigned char INT"),
           ("types.h", "INT high;", "float high;"), ("types.h", "INT most);", "INT most, INT step);"),
           ("main.cld", "unsigned total;", "static long total;"), ("main.cld", "INT table[SIZE];", "INT table[2];"),
           ("main.cld", "v > most ?", "v = most ?"), ("main.cld", "INT i;", "INT i, j;"), ("main.cld", "i < SIZE", "i <= SIZE"),
           ("main.cld", "total++;", "total == 1;"), ("main.cld", "{ count(); }", "{ }"),
           ("main.cld", "plc1_time = 16;", "count();"), ("main.cld", "void plc2() {", "void plc2() { X[1] = 0;"),
           ("main.cld", "{ left--; }", "{ left--; "), ("main.cld", "R[5] = left;", "R[5] = lost;"),
           ("main.cld", "// scans", "/* scans"), ("main.cld", "static unsigned left", "static signed char left"),
           ("main.cld", "if (left > 2)", "if (left = 2)"), ("main.cld", "wait(); }", "wate(); }")]


def found_by_client(client, sample):
    """By file: only those of the sample's folder."""
    prefix = uri_of(sample.folder) + "/"
    return {uri[len(prefix):]: sorted(as_client_sees(one) for one in found)
            for uri, found in client.diagnostics.items() if uri.startswith(prefix) and found}


def found_by_check(plcxx, sample):
    by_file = {}
    for one in sample.check(plcxx):
        name = pathlib.PurePath(one["file"] or sample.sources[0]).name
        by_file.setdefault(name, []).append(as_check_says(one))
    return {name: sorted(found) for name, found in by_file.items()}


def position(text, offset):
    line = text.count("\n", 0, offset)
    return {"line": line, "character": offset - (text.rfind("\n", 0, offset) + 1)}


def random_edit(rng, text, words):
    """A change and the text behind it; line ends stay whole, for a text has one kind of them."""
    kind = rng.randrange(4)
    at = rng.randrange(len(text) + 1)
    while 0 < at < len(text) and text[at - 1] == "\r":
        at += 1
    length, new = 0, ""
    if kind == 0:
        new = rng.choice(words)
    elif kind == 1:
        length = min(rng.randrange(12), len(text) - at)
    elif kind == 2:
        new, length = rng.choice(words), min(rng.randrange(6), len(text) - at)
    else:
        new = rng.choice([" ", "(", ")", ";", "1", "A", "\n", "="])
    removed = text[at:at + length]
    if "\r" in removed or (removed.startswith("\n") and at > 0 and text[at - 1] == "\r"):
        length = 0
    change = {"range": {"start": position(text, at), "end": position(text, at + length)}, "text": new}
    return change, text[:at] + new + text[at + length:]


def edited(plcxx, root, dialect, directory, rng):
    sample = Sample(root, dialect, directory)
    options = {"programs": [sample.program()]}
    client = Client(plcxx, options, encodings=("utf-32",))
    names = [name for name in sample.sources if sample.encoding_of(name) and not name.endswith(".TCH")]
    texts = {name: sample.path(name).read_bytes().decode(sample.encoding_of(name)) for name in names}
    originals = dict(texts)
    for name in names:
        client.open(sample.path(name), texts[name])
    versions = dict.fromkeys(names, 1)
    words = [word for text in texts.values() for word in text.split()][:2000]
    for number in range(EDITS):
        name = rng.choice(names)
        change, texts[name] = random_edit(rng, texts[name], words)
        versions[name] += 1
        client.change(sample.path(name), [change], versions[name])
        if number % 40 == 20:
            client.wait_for(sample.path(name), versions[name])
        if number % 50 == 49 and number + 1 < EDITS:  # a person undoes it, and the program is whole for a while
            for other in names:
                versions[other] += 1
                texts[other] = originals[other]
                client.change(sample.path(other), [{"text": texts[other]}], versions[other])
    for name in names:
        client.wait_for(sample.path(name), versions[name])
    fresh = Client(plcxx, options, encodings=("utf-32",))
    for name in names:
        fresh.open(sample.path(name), texts[name])
    for name in names:
        fresh.wait_for(sample.path(name), 1)
    assert found_by_client(client, sample) == found_by_client(fresh, sample), f"{dialect}: not as in a fresh server"
    for name in names:
        sample.path(name).write_bytes(texts[name].encode(sample.encoding_of(name), errors="replace"))
    expected, found = found_by_check(plcxx, sample), found_by_client(fresh, sample)
    assert found == expected, f"{dialect}: not as check says:\n{found}\n{expected}"
    assert client.shut_down() == 0 and fresh.shut_down() == 0
    count = sum(len(of_file) for of_file in found.values())
    print(f"{dialect}: {EDITS} edits, {count} diagnostics in the end")
    return count


def toggled(plcxx, directory, rng):
    """What one place of a C program says is found at others: after each change the same as in a fresh server."""
    folder = pathlib.Path(directory).resolve()
    folder.mkdir()
    texts = {"types.h": HEADER, "main.cld": MAIN}
    for name, text in texts.items():
        (folder / name).write_text(text)
    options = {"programs": [{"sources": ["main.cld"], "dialect": "hnc", "base": str(folder)}]}

    def found(client):
        return {uri: sorted(as_client_sees(one) for one in rows) for uri, rows in client.diagnostics.items() if rows}

    def opened():
        client = Client(plcxx, options, encodings=("utf-32",))
        for name in texts:
            client.open(folder / name, texts[name])
        for name in texts:
            client.wait_for(folder / name, 1)
        return client

    client = opened()
    assert not found(client), found(client)
    seen, versions, done = set(), dict.fromkeys(texts, 1), [False] * len(CHANGES)
    for number in range(TOGGLES):
        which = number if number < len(CHANGES) else rng.randrange(len(CHANGES))
        if number < len(CHANGES) and number > 0:  # each by itself first, then all together
            toggle_back = number - 1
            name, old, new = CHANGES[toggle_back]
            texts[name], done[toggle_back] = texts[name].replace(new, old, 1), False
            versions[name] += 1
            client.change(folder / name, [{"text": texts[name]}], versions[name])
        name, old, new = CHANGES[which]
        if done[which]:
            old, new = new, old
        assert old in texts[name], (name, old)
        at = texts[name].index(old)
        change = {"range": {"start": position(texts[name], at), "end": position(texts[name], at + len(old))}, "text": new}
        texts[name], done[which] = texts[name].replace(old, new, 1), not done[which]
        versions[name] += 1
        client.change(folder / name, [change], versions[name])
        client.wait_for(folder / name, versions[name])
        fresh = opened()
        assert found(client) == found(fresh), f"{CHANGES[which]}: not as in a fresh server:\n{found(client)}\n{found(fresh)}"
        seen |= {row[4] for rows in found(client).values() for row in rows}
        assert fresh.shut_down() == 0
    assert client.shut_down() == 0
    print(f"hnc: {TOGGLES} changes of header and source, {len(seen)} kinds of diagnostics")
    assert len(seen) >= 7, seen


def whole(plcxx, root, dialect, directory):
    """Nothing edited: the files on the disk, one of them open."""
    sample = Sample(root, dialect, directory)
    client = Client(plcxx, {"programs": [sample.program()]}, encodings=("utf-32",))
    name = next(name for name in sample.sources if sample.encoding_of(name))
    client.open(sample.path(name), sample.path(name).read_bytes().decode(sample.encoding_of(name)), version=7)
    client.wait_for(sample.path(name), 7)
    assert found_by_client(client, sample) == found_by_check(plcxx, sample), dialect
    client.close(sample.path(name))
    assert client.shut_down() == 0


def project_file(plcxx, root, dialect, directory):
    """Without options: plcxx.yaml says which files are a program; it is edited, too."""
    sample = Sample(root, dialect, directory)
    client = Client(plcxx, encodings=("utf-32",))
    name = next(name for name in sample.sources if sample.encoding_of(name))
    text = sample.path(name).read_bytes().decode(sample.encoding_of(name))
    client.open(sample.path(name), text)
    client.wait_for(sample.path(name), 1)
    assert found_by_client(client, sample) == found_by_check(plcxx, sample), dialect
    said = sample.path("plcxx.yaml").read_text(encoding="utf-8")
    client.open(sample.path("plcxx.yaml"), said.replace("dialect:", "dialekt:"))
    faults = client.wait_for(sample.path("plcxx.yaml"), 1)
    assert len(faults) >= 1 and "dialekt" in faults[0]["message"], faults
    client.change(sample.path("plcxx.yaml"), [{"text": said}], 2)
    assert client.wait_for(sample.path("plcxx.yaml"), 2) == []
    client.change(sample.path(name), [{"text": text}], 3)
    client.wait_for(sample.path(name), 3)
    assert found_by_client(client, sample) == found_by_check(plcxx, sample), dialect
    assert client.shut_down() == 0


def fixits(plcxx, directory):
    path = pathlib.Path(directory) / "lamp.plc"
    text = "$\nU4A0=IOA7*I0A1\n"
    client = Client(plcxx)
    client.open(path, text)
    found = client.wait_for(path, 1)
    assert [one["code"] for one in found] == ["nc110-1"], found
    actions = client.request("textDocument/codeAction", {
        "textDocument": {"uri": uri_of(path)}, "range": found[0]["range"], "context": {"diagnostics": found}})
    assert len(actions) == 1 and actions[0]["kind"] == "quickfix", actions
    edits = actions[0]["edit"]["changes"][uri_of(path)]
    client.change(path, [{"range": edit["range"], "text": edit["newText"]} for edit in edits], 2)
    assert "nc110-1" not in [one["code"] for one in client.wait_for(path, 2)]
    client.close(path)
    assert client.shut_down() == 0


def broken_clients(plcxx, directory):
    path = pathlib.Path(directory) / "lamp.plc"
    client = Client(plcxx, initialize=False)
    early = client.raw_request("textDocument/hover", client.at(path, 0, 0))
    assert early["error"]["code"] == -32002, early
    for garbage in [b"Content-Length: 5\r\n\r\n{}{}}", b"Content-Length: x\r\n\r\n", b"Content-Length: 2\r\n\r\n\xff\xfe",
                    b"GET / HTTP/1.1\r\n\r\n", b"Content-Length: 20\r\n\r\n{}"]:
        client.send_bytes(garbage)
    client.request("initialize", {"capabilities": {"general": {"positionEncodings": 7}}, "rootUri": 5})
    assert client.raw_request("initialize", {})["error"]["code"] == -32600
    client.open(path, "$\nU4A0=I0A1\n")
    wrong = [("textDocument/hover", {}), ("textDocument/hover", []), ("textDocument/codeAction", {"textDocument": 7}),
             ("textDocument/codeAction", {"textDocument": {"uri": "http://x/y"}}),
             ("textDocument/codeAction", {"textDocument": {"uri": uri_of(path)}, "range": {"start": 1, "end": 2}})]
    for method, params in wrong:
        answer = client.raw_request(method, params)
        assert answer["error"]["code"] in (-32602, -32601), (method, params, answer)
    assert client.raw_request("no/such", {})["error"]["code"] == -32601
    far = {"start": {"line": 4000000, "character": -5}, "end": {"line": -3, "character": 1 << 40}}
    client.request("textDocument/codeAction", {"textDocument": {"uri": uri_of(path)}, "range": far})
    for params in [{}, {"textDocument": {"uri": uri_of(path)}}, {"textDocument": {"uri": uri_of(path)}, "contentChanges": [7]},
                   {"textDocument": {"uri": uri_of("/no/such")}, "contentChanges": []},
                   {"textDocument": {"uri": uri_of(path)}, "contentChanges": [{"range": far, "text": "$"}]}]:
        client.notify("textDocument/didChange", params)
    client.close("/no/such")
    client.notify("$/cancelRequest", {"id": {}})
    client.notify("textDocument/didOpen", {"textDocument": {"uri": "file:///x%00y", "text": "", "languageId": "", "version": 1}})
    client.open(path, "$\nU4A0=", 9)
    assert client.wait_for(path, 9), "an error is found as before"
    client.request("shutdown", None)
    assert client.raw_request("textDocument/hover", {})["error"]["code"] == -32600
    client.notify("exit", None)
    assert client.process.wait(timeout=20) == 0
    for last in [{"method": "exit"}, None]:
        rude = Client(plcxx)
        if last:
            rude.send(last)
        else:
            rude.process.stdin.close()
        assert rude.process.wait(timeout=20) == 1, "exit without shutdown"


def main():
    plcxx, root = sys.argv[1:3]
    rng = random.Random(20)
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as directory:
        broken_clients(plcxx, directory)
        toggled(plcxx, f"{directory}/toggled", random.Random(5))
        fixits(plcxx, directory)
        found = 0
        for dialect in FOLDERS:
            start = time.monotonic()
            whole(plcxx, root, dialect, f"{directory}/whole")
            project_file(plcxx, root, dialect, f"{directory}/project")
            found += edited(plcxx, root, dialect, f"{directory}/edited", rng)
            print(f"{dialect}: {time.monotonic() - start:.1f} s")
        assert found > 50, "random edits break something"


if __name__ == "__main__":
    main()
