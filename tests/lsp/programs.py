"""The sample machines as programs that a client has open: copies of their folders, their sources and options."""
import codecs
import json
import pathlib
import re
import shutil
import subprocess

FOLDERS = {"nc110": "lathe_16k20", "technol": "mcv_750", "host50": "ck6150", "prostep": "mill_fnd32", "hnc": "mill_xk7132"}
# Python knows no Mazovia; the samples use it in one file, which these tests leave on the disk.
ENCODINGS = {"nc110": ["utf-8", "cp866", "cp1251", "koi8-r"], "technol": ["utf-8", "cp1250"], "host50": ["utf-8", "gb18030"],
             "prostep": ["utf-8"], "hnc": ["utf-8", "gb18030"]}


class Sample:
    def __init__(self, root, dialect, directory):
        self.dialect = dialect
        folder = pathlib.Path(root) / "samples" / dialect / FOLDERS[dialect]
        self.folder = pathlib.Path(directory).resolve() / dialect
        shutil.copytree(folder, self.folder)
        project = (folder / "plcxx.yaml").read_text(encoding="utf-8")
        sources = re.search(r"^sources: \[?([^\]\n]*)", project, re.MULTILINE)[1]
        self.sources = [word.strip() for word in sources.split(",")]
        options = re.search(r"^options: \{(.*)\}", project, re.MULTILINE)
        pairs = [pair.split(":") for pair in options[1].split(",")] if options else []
        self.options = {key.strip(): value.strip() for key, value in pairs}

    def program(self):
        return {"sources": self.sources, "dialect": self.dialect, "base": str(self.folder), "options": self.options}

    def path(self, name):
        return self.folder / name

    def encoding_of(self, name):
        data = self.path(name).read_bytes()
        for encoding in ENCODINGS[self.dialect]:
            try:
                data.decode(encoding)
                return encoding
            except UnicodeDecodeError:
                continue
        return None

    def check(self, plcxx):
        """What `plcxx check` finds in the files as they are on the disk."""
        command = [plcxx, "check", "--dialect", self.dialect, "--diagnostics=json"]
        for key, value in self.options.items():
            command += ["--set", f"{key}={value}"]
        found = subprocess.run(command + self.sources, cwd=self.folder, capture_output=True)
        return json.loads(found.stdout)


def as_check_says(diagnostic):
    """A row of check's JSON, as a client with UTF-32 sees it."""
    line, column = diagnostic["line"] or 1, diagnostic["column"] or 1
    end_line, end_column = diagnostic["endLine"] or line, diagnostic["endColumn"] or column
    text = diagnostic["message"] + (f"\nhelp: {diagnostic['help']}" if diagnostic["help"] else "")
    return (line - 1, column - 1, end_line - 1, end_column - 1, diagnostic["code"], diagnostic["severity"], text)


def as_client_sees(diagnostic):
    start, end = diagnostic["range"]["start"], diagnostic["range"]["end"]
    severity = {1: "error", 2: "warning", 3: "note"}[diagnostic["severity"]]
    return (start["line"], start["character"], end["line"], end["character"], diagnostic["code"], severity,
            diagnostic["message"])
