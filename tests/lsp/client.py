"""A client of the Language Server Protocol for the tests: it knows nothing of plcxx but its command line."""
import json
import os
import pathlib
import select
import subprocess
import time
import urllib.parse


def uri_of(path):
    return "file://" + urllib.parse.quote(str(pathlib.Path(path).resolve()))


class Client:
    def __init__(self, plcxx, options=None, encodings=("utf-16",), initialize=True):
        self.process = subprocess.Popen([plcxx, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.buffer = b""
        self.next_id = 1
        self.diagnostics = {}  # by URI
        self.versions = {}
        self.messages = []  # notifications that are no diagnostics
        if initialize:
            self.capabilities = self.request(
                "initialize",
                {"processId": None, "rootUri": None, "initializationOptions": options or {},
                 "capabilities": {"general": {"positionEncodings": list(encodings)}}})["capabilities"]
            self.notify("initialized", {})

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        body = json.dumps(message).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def notify(self, method, params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def receive(self, seconds=60):
        """The next message; None when nothing comes in time or the server is gone."""
        end = time.monotonic() + seconds
        while True:
            head, separator, rest = self.buffer.partition(b"\r\n\r\n")
            if separator:
                length = int(head.split(b":")[1])
                if len(rest) >= length:
                    self.buffer = rest[length:]
                    return json.loads(rest[:length])
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.process.stdout], [], [], left)[0]:
                return None
            data = os.read(self.process.stdout.fileno(), 1 << 20)  # not the stream, which would keep some for itself
            if not data:
                return None
            self.buffer += data

    def take(self, message):
        if message.get("method") == "textDocument/publishDiagnostics":
            params = message["params"]
            self.diagnostics[params["uri"]] = params["diagnostics"]
            self.versions[params["uri"]] = params.get("version")
        else:
            self.messages.append(message)

    def answer_to(self, number, seconds=60):
        while True:
            message = self.receive(seconds)
            assert message is not None, f"no answer to request {number}"
            if message.get("id") == number and "method" not in message:
                return message
            self.take(message)

    def start_request(self, method, params):
        number = self.next_id
        self.next_id += 1
        self.send({"jsonrpc": "2.0", "id": number, "method": method, "params": params})
        return number

    def raw_request(self, method, params, seconds=60):
        return self.answer_to(self.start_request(method, params), seconds)

    def request(self, method, params, seconds=60):
        answer = self.raw_request(method, params, seconds)
        assert "error" not in answer, f"{method}: {answer['error']}"
        return answer["result"]

    def open(self, path, text, version=1):
        self.notify("textDocument/didOpen",
                    {"textDocument": {"uri": uri_of(path), "languageId": "plc", "version": version, "text": text}})

    def change(self, path, changes, version):
        self.notify("textDocument/didChange",
                    {"textDocument": {"uri": uri_of(path), "version": version}, "contentChanges": changes})

    def close(self, path):
        self.notify("textDocument/didClose", {"textDocument": {"uri": uri_of(path)}})

    def wait_for(self, path, version, seconds=60):
        """The diagnostics of a document as of a version."""
        uri = uri_of(path)
        end = time.monotonic() + seconds
        while self.versions.get(uri) != version:
            message = self.receive(max(0.0, end - time.monotonic()))
            assert message is not None, f"no diagnostics of {path}, version {version}"
            self.take(message)
        self.raw_request("$/nothing", {})  # what was published with it has come before the answer
        return self.diagnostics[uri]

    def at(self, path, line, character, **more):
        """Parameters of a request about a place."""
        return {"textDocument": {"uri": uri_of(path)}, "position": {"line": line, "character": character}, **more}

    def shut_down(self):
        self.request("shutdown", None)
        self.notify("exit", None)
        return self.process.wait(timeout=20)
