"""A running `plcxx live`, for tests: its address, commands, the stream of its state."""

import http.client
import json
import re
import signal
import subprocess
import time


class Server:
    """Starts it; use as a context manager. What it has printed first is in `said`."""

    def __init__(self, plcxx, arguments, cwd):
        self.process = subprocess.Popen([plcxx, "live", "--no-browser", *arguments], cwd=cwd, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.said = []
        while True:
            line = self.process.stdout.readline()
            if not line:
                raise RuntimeError("it did not start: " + self.process.stderr.read())
            self.said.append(line)
            found = re.search(r"http://([0-9.]+):(\d+)/(?:#token=(\w+))?", line)
            if found:
                break
        self.address, self.port, self.token = found[1], int(found[2]), found[3]
        self.url = found[0]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def end(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        try:
            code = self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        self.process.stdout.close()
        self.process.stderr.close()
        return code

    def request(self, method, path, body=None, headers=None):
        """Status, headers and text of the answer."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        try:
            given = {"Content-Type": "application/json"} if body is not None else {}
            given.update(headers or {})
            connection.request(method, path, body, given)
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read().decode()
        finally:
            connection.close()

    def get(self, path):
        status, _, text = self.request("GET", path)
        assert status == 200, (path, status, text)
        return json.loads(text)

    def act(self, do, **words):
        status, _, text = self.request("POST", "/api/command", json.dumps({"do": do, **words}))
        assert status == 200, (do, words, text)
        return json.loads(text)

    def refused(self, do, **words):
        status, _, text = self.request("POST", "/api/command", json.dumps({"do": do, **words}))
        assert status == 400, (do, words, status, text)
        return json.loads(text)["error"]


class Events:
    """The stream of a page, put together as a page does."""

    def __init__(self, server):
        self.connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=10)
        self.connection.request("GET", "/api/events")
        self.answer = self.connection.getresponse()
        assert self.answer.status == 200, self.answer.read()
        self.state = {"values": {}}

    def next(self):
        """What has changed."""
        while True:
            line = self.answer.readline()
            if not line:
                raise EOFError
            if not line.startswith(b"data: "):
                continue
            change = json.loads(line[6:])
            self.state["values"].update(dict(change.get("values", [])))
            self.state.update({key: value for key, value in change.items() if key != "values"})
            return change

    def until(self, holds, what="", seconds=60):
        """Fails with what was seen last where it does not hold in time, however much else changes."""
        end = time.monotonic() + seconds
        while not holds(self.state):
            said = {key: self.state.get(key) for key in ("at", "link", "forced", "notes", "trigger")}
            assert time.monotonic() < end, f"{what or 'what is waited for'} does not come: {said}"
            self.next()

    def close(self):
        self.answer.close()
        self.connection.close()
