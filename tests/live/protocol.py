#!/usr/bin/env python3
"""plcxx live as a page, a script and somebody hostile see it.

    protocol.py PLCXX ROOT
"""

import json
import pathlib
import random
import signal
import socket
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from server import Events, Server  # noqa: E402

LAMP = "W3K0=[W3K0+1]\n$\n;<img src=x onerror=alert(1)> лампа 灯\nU4A8=I0A3*/I0A4+U4A8*/I0A4\n"
FAILING = """dialect: nc110
sources: [lamp.plc]
steps:
- run: {ms: 50}
- set: {I0A3: 1}
- run: {ms: 30}
- expect: {U4A8: 0}
"""


def runs_in_real_time(server):
    events = Events(server)
    first = events.next()
    assert first["at"]["period"] == 0 and not first["mode"]["running"], first
    outline = server.get("/api/program")
    names = [signal["name"] for signal in outline["signals"]]
    assert "U4A8" in names, names
    server.act("run")
    begin = time.monotonic()
    time.sleep(1)
    server.act("pause")
    passed = (time.monotonic() - begin) * 1000
    events.until(lambda state: not state["mode"]["running"] and state["at"]["period"] > 0)
    ms = events.state["at"]["ms"]
    assert 0.5 * passed < ms <= passed + 300, (ms, passed)
    server.act("set", name="I0A3", value="1")
    server.act("step", what="period")
    lamp = names.index("U4A8")
    events.until(lambda state: state["values"].get(lamp) == 1)
    server.act("back", periods=1)
    events.until(lambda state: state["values"].get(lamp) == 0)
    events.close()


def says_why(server):
    server.act("restart")
    server.act("set", name="I0A3", value="1")
    for _ in range(3):
        server.act("step", what="period")
    text = server.act("why", name="U4A8")["text"]
    assert "U4A8" in text and "I0A3" in text, text


def records(server, plcxx, folder):
    server.act("expect", names=["U4A8"])
    assert "I0A3: 1" in server.act("scenario")["yaml"]
    for name in ("../out.yaml", "/tmp/out.yaml", "out.txt", "a/b.yaml", ".yaml", ""):
        assert "name" in server.refused("save", file=name), name
    assert server.act("save", file="recorded.yaml")["file"] == "recorded.yaml"
    before = (folder / "recorded.yaml").read_bytes()
    assert "there already" in server.refused("save", file="recorded.yaml")
    assert "there already" in server.refused("save", file="failing.yaml")
    assert (folder / "recorded.yaml").read_bytes() == before
    ran = subprocess.run([plcxx, "test", "recorded.yaml"], cwd=folder, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr


def refuses_others(server):
    command = json.dumps({"do": "pause"})
    local = f"127.0.0.1:{server.port}"
    for headers in ({"Host": "evil.example"}, {"Host": f"evil.example:{server.port}"}, {"Origin": "http://evil.example"},
                    {"Origin": "null"}, {"Sec-Fetch-Site": "cross-site"}, {"Sec-Fetch-Site": "same-site"},
                    {"Content-Type": "text/plain"}, {"Content-Type": "application/x-www-form-urlencoded"}):
        status, _, _ = server.request("POST", "/api/command", command, headers)
        assert status == 403, (headers, status)
    assert server.request("POST", "/api/command", command, {"Origin": "http://" + local})[0] == 200
    assert server.request("GET", "/", headers={"Host": "evil.example"})[0] == 403
    status, headers, _ = server.request("OPTIONS", "/api/command", headers={"Origin": "http://evil.example"})
    assert status >= 400 and "Access-Control-Allow-Origin" not in headers, (status, headers)
    status, headers, text = server.request("GET", "/")
    assert status == 200 and "script-src 'self'" in headers["Content-Security-Policy"], headers
    assert headers["X-Content-Type-Options"] == "nosniff" and "<script type=\"module\"" in text
    for path in ("/../../etc/passwd", "/etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/lamp.plc", "/recorded.yaml", "/api",
                 "/api/file?name=lamp.plc", "//etc/passwd"):
        assert server.request("GET", path)[0] in (400, 403, 404), path
    for method in ("PUT", "DELETE", "PATCH"):
        assert server.request(method, "/api/command", command)[0] >= 400, method


def survives(server):
    """Hostile bodies, and bytes that are no HTTP."""
    shuffled = random.Random(7)
    status, _, _ = server.request("POST", "/api/command", "[" * 100_000)
    assert status == 400, status
    assert server.request("POST", "/api/command", "x" * (3 << 20))[0] in (400, 413)
    good = [json.dumps({"do": do, **words}) for do, words in (
        ("set", {"name": "I0A3", "value": "1"}), ("step", {"what": "statement"}), ("back", {"periods": 3}),
        ("breakCondition", {"text": "U4A8 and not I0A3 for 30 ms"}), ("watch", {"name": "U4A8"}), ("why", {"name": "U4A8"}),
        ("trigger", {"edge": "rising", "text": "I0A3", "baseMs": 10, "delayMs": 0, "samples": 10, "before": 20}),
        ("switch", {"statement": 0, "on": False}), ("goTo", {"period": 2}), ("expect", {"names": ["U4A8"]}))]
    for _ in range(600):
        text = list(shuffled.choice(good))
        for _ in range(shuffled.randrange(1, 4)):
            text[shuffled.randrange(len(text))] = shuffled.choice(['"', "{", "}", "-", "9" * 30, "\\u0000", "", "é", ":", "null"])
        status, _, answer = server.request("POST", "/api/command", "".join(text).encode())
        assert status in (200, 400), (status, text)
        json.loads(answer)
    for raw in (b"\0" * 5000, b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 100 + b"\r\n", b"POST /api/command HTTP/1.1\r\nContent-Length: -1\r\n\r\n",
                b"GET " + b"/" * 20_000 + b" HTTP/1.1\r\n\r\n", b"POST /api/command HTTP/1.1\r\nContent-Length: 99999999999\r\n\r\n{}"):
        with socket.create_connection(("127.0.0.1", server.port), timeout=20) as one:
            one.sendall(raw)
            one.shutdown(socket.SHUT_WR)
            try:
                while one.recv(65536):
                    pass
            except OSError:
                pass
    assert server.get("/api/program")["dialect"] == "nc110"


def resident_kb(server):
    with open(f"/proc/{server.process.pid}/status", encoding="utf-8") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS"))


def keeps_its_memory(plcxx, root):
    """A page that comes again and again takes what it took at first: each thread had a heap of its own, of 1.2 MB each."""
    with Server(plcxx, [str(root / "samples/nc110/lathe_16k20")], "/") as server:
        sizes = []
        for _ in range(120):
            server.request("GET", "/")
            server.get("/api/program")
            server.get("/api/rows?from=0&to=24")
            page = Events(server)
            page.next()
            page.close()
            server.act("pause")  # the stream notices that its page is gone
            sizes.append(resident_kb(server))
        print(f"reconnected 120 times: {sizes[0]} kB after the first, {sizes[59]} after 60, {sizes[-1]} after all")
        assert sizes[-1] - sizes[0] < 6000, sizes
        assert sizes[-1] - sizes[59] < 1500, sizes


def limits_pages(server):
    pages = [Events(server) for _ in range(8)]
    assert server.request("GET", "/api/events")[0] == 503
    pages[0].close()
    server.act("restart")
    end = time.monotonic() + 15
    while server_is_full(server):
        assert time.monotonic() < end, "a page that is gone still counts"
        server.act("pause")
        time.sleep(0.2)
    for page in pages[1:]:
        page.close()


def server_is_full(server):
    try:
        Events(server).close()
        return False
    except AssertionError:
        return True


def opens_a_scenario(plcxx, folder):
    with Server(plcxx, ["failing.yaml"], folder) as server:
        assert "U4A8 is 1, expected 0" in "".join(server.said), server.said
        events = Events(server)
        change = events.next()
        assert change["at"]["period"] == 8 and "step 4" in change["mode"]["opened"], change
        server.act("back", periods=4)
        events.until(lambda state: state["at"]["period"] == 4)
        events.close()


def opens_a_trace(plcxx, folder):
    ran = subprocess.run([plcxx, "sim", "lamp.plc", "--watch", "I0A3,U4A8", "--at", "100ms:I0A3=1", "--for", "300ms", "--vcd",
                          "trace.vcd"], cwd=folder, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    with Server(plcxx, ["lamp.plc", "--vcd", "trace.vcd"], folder) as server:
        lamp = [signal["name"] for signal in server.get("/api/program")["signals"]].index("U4A8")
        events = Events(server)
        events.next()
        events.until(lambda state: state["at"]["period"] > 20 and state["values"].get(lamp) == 1)
        server.act("goTo", period=5)
        events.until(lambda state: state["values"].get(lamp) == 0)
        events.close()


def needs_a_token(plcxx, folder):
    with Server(plcxx, ["lamp.plc", "--listen", "0.0.0.0"], folder) as server:
        assert len(server.token) == 32, server.url
        assert server.request("GET", "/api/program")[0] == 403
        assert server.request("GET", "/api/program", headers={"X-Plcxx-Token": "0" * 32})[0] == 403
        assert server.request("GET", "/api/program", headers={"X-Plcxx-Token": server.token})[0] == 200
        assert server.request("GET", "/api/program?token=" + server.token)[0] == 200
        server.process.send_signal(signal.SIGTERM)
        said = server.process.stderr.read()
        assert "everybody who knows this address" in said and "others write the name of this machine" in said, said


def wrong_use(plcxx, folder):
    def run(*arguments):
        return subprocess.run([plcxx, "live", "--no-browser", *arguments], cwd=folder, capture_output=True, text=True,
                              timeout=60, check=False)
    assert run("none.plc").returncode == 1
    assert run("lamp.plc", "--port", "0").returncode == 2
    for address in ("no.such.address.example", "198.51.100.77"):
        nowhere = run("lamp.plc", "--listen", address)
        assert nowhere.returncode == 2 and "this machine has no such address" in nowhere.stderr, nowhere
    (folder / "wrong.plc").write_text("$\nU4A8=\n")
    assert run("wrong.plc").returncode == 1
    with Server(plcxx, ["lamp.plc"], folder) as server:
        taken = run("lamp.plc", "--port", str(server.port))
        assert taken.returncode == 2 and "another program listens there" in taken.stderr, taken
        other = Server(plcxx, ["lamp.plc"], folder)
        assert other.port != server.port
        assert other.end(signal.SIGTERM) == 0
        assert server.end() == 0


def main(plcxx, root):
    root = pathlib.Path(root)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "lamp.plc").write_text(LAMP, encoding="utf-8")
        (folder / "failing.yaml").write_text(FAILING)
        with Server(plcxx, ["lamp.plc"], folder) as server:
            runs_in_real_time(server)
            says_why(server)
            records(server, plcxx, folder)
            refuses_others(server)
            survives(server)
            limits_pages(server)
        opens_a_scenario(plcxx, folder)
        opens_a_trace(plcxx, folder)
        needs_a_token(plcxx, folder)
        wrong_use(plcxx, folder)
    with Server(plcxx, [str(root / "samples/nc110/lathe_16k20")], "/") as server:
        assert server.get("/api/program")["name"] == "lathe"
    keeps_its_memory(plcxx, root)
    print("plcxx live: all as it should be")


if __name__ == "__main__":
    main(*sys.argv[1:])
