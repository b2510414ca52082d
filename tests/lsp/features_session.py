#!/usr/bin/env python3
"""What a word means, where it is defined and mentioned, what can be written, in all five languages: on the sample
machines, by a client that has every file open that it asks about."""
import pathlib
import sys
import tempfile

from client import Client, uri_of
from programs import Sample


class Session:
    def __init__(self, plcxx, root, dialect, directory):
        self.sample = Sample(root, dialect, directory)
        self.client = Client(plcxx, {"programs": [self.sample.program()]}, encodings=("utf-32",))
        self.texts = {}

    def text(self, name):
        if name not in self.texts:
            data = self.sample.path(name).read_bytes()
            self.texts[name] = data.decode(self.sample.encoding_of(name) or "utf-8")
            self.client.open(self.sample.path(name), self.texts[name])
        return self.texts[name]

    def place(self, name, line_with, word, last=False):
        """The beginning of a word in the first line that holds a text."""
        for number, line in enumerate(self.text(name).splitlines()):
            if line_with in line:
                at = line.rfind(word) if last else line.find(word)
                assert at >= 0, (line, word)
                return number, at
        raise AssertionError(f"{name} has no line with '{line_with}'")

    def ask(self, method, name, line_with, word, behind=0, last=False, **more):
        line, character = self.place(name, line_with, word, last)
        return self.client.request(method, self.client.at(self.sample.path(name), line, character + behind, **more))

    def refused(self, method, name, line_with, word, **more):
        line, character = self.place(name, line_with, word)
        answer = self.client.raw_request(method, self.client.at(self.sample.path(name), line, character, **more))
        return answer["error"]["message"]

    def hover(self, *where, **more):
        found = self.ask("textDocument/hover", *where, **more)
        return found["contents"]["value"] if found else ""

    def places(self, method, *where, **more):
        """As "file:line", counted from 1."""
        found = self.ask(method, *where, **more)
        return sorted(f"{pathlib.PurePath(one['uri']).name}:{one['range']['start']['line'] + 1}" for one in found)

    def document(self, method, name, **more):
        self.text(name)
        return self.client.request(method, {"textDocument": {"uri": uri_of(self.sample.path(name))}, **more})

    def line_of(self, name, line_with):
        return f"{name}:{self.place(name, line_with, '')[0] + 1}"

    def labels(self, name, line_with, word, behind, last=False):
        found = self.ask("textDocument/completion", name, line_with, word, behind=behind, last=last)
        return {item["label"]: item for item in found["items"]}

    def rename(self, new_name, *where):
        """How many places change in which file."""
        found = self.ask("textDocument/rename", *where, newName=new_name)
        return {pathlib.PurePath(uri).name: len(edits) for uri, edits in found["changes"].items()}

    def calls(self, name, line_with, word, direction):
        items = self.ask("textDocument/prepareCallHierarchy", name, line_with, word)
        found = self.client.request(f"callHierarchy/{direction}Calls", {"item": items[0]})
        return sorted(one["from" if direction == "incoming" else "to"]["name"] for one in found)

    def check_document(self, name):
        """What every document has: tokens in order, foldings of several lines, symbols around their names."""
        text = self.text(name).splitlines()
        data = self.document("textDocument/semanticTokens/full", name)["data"]
        line = character = 0
        for i in range(0, len(data), 5):
            character = data[i + 1] + (character if data[i] == 0 else 0)
            line += data[i]
            assert data[i + 2] > 0 and character + data[i + 2] <= len(text[line]), (name, line, text[line], data[i:i + 5])
        assert len(data) > 5 * 20, name
        for folding in self.document("textDocument/foldingRange", name):
            assert 0 <= folding["startLine"] < folding["endLine"] <= len(text), folding

        def check(symbols, outer):
            for symbol in symbols:
                begin, end = symbol["range"]["start"]["line"], symbol["range"]["end"]["line"]
                assert outer[0] <= begin <= symbol["selectionRange"]["start"]["line"] <= end <= outer[1], symbol
                check(symbol.get("children", []), (begin, end))
        symbols = self.document("textDocument/documentSymbol", name)
        check(symbols, (0, len(text)))
        return [symbol["name"] for symbol in symbols]

    def end(self):
        assert self.client.shut_down() == 0


def has(text, *parts):
    for part in parts:
        assert part in text, f"'{part}' is missing in: {text}"


def nc110(session):
    hover = session.hover("fast.plc", "!KDRV =", "!KDRV", behind=2)
    has(hover, "contactor of the drives", "U4A0", "written: [fast.plc:16]", "read: [fast.plc:17]", "bit in")
    has(session.hover("fast.plc", "U10K20 = I6K21", "U10K20"), "written: [fast.plc:14]")
    has(session.hover("fast.plc", "!EMAXIS = LOW", "LOW"), "`LOW word`")
    definition = session.line_of("lathe.sym", "KDRV     = U4A0")
    assert session.places("textDocument/definition", "fast.plc", "T1I(10) = !KDRV", "!KDRV", behind=1) == [definition]
    assert session.places("textDocument/definition", "fast.plc", "U10K20 = I6K21", "U10K20") == ["fast.plc:14"]
    mentions = session.places("textDocument/references", "lathe.sym", "KDRV     = U4A0", "KDRV")
    assert {definition, "fast.plc:16", "fast.plc:17"} <= set(mentions), mentions
    assert mentions == session.places("textDocument/references", "lathe.sym", "KDRV     = U4A0", "U4A0"), "by address"
    without = session.places("textDocument/references", "fast.plc", "!KDRV =", "KDRV", context={"includeDeclaration": False})
    assert definition not in without and "fast.plc:16" in without, without
    changed = session.rename("KDRIVES", "fast.plc", "!KDRV =", "KDRV")
    assert changed == {"lathe.sym": 1, "fast.plc": 2}, changed
    has(session.refused("textDocument/rename", "fast.plc", "!KDRV =", "KDRV", newName="ESTOK"), "refused", "ESTOK")
    has(session.refused("textDocument/rename", "fast.plc", "U10K20 = I6K21", "U10K20", newName="X"), "address")
    labels = session.labels("fast.plc", "!KDRV =", "!KDRV", 3)
    assert labels["KDRV"]["documentation"].startswith("contactor"), labels
    assert labels["KDRV"]["textEdit"]["newText"] == "KDRV", "the mark is there already"
    labels = session.labels("fast.plc", "U10K20 = I6K21", "U10K20", 4)
    assert any(item.get("documentation") for item in labels.values()), "signals of the control with their meaning"
    help_text = session.ask("textDocument/signatureHelp", "fast.plc", "!EMAXIS = LOW", "LOW(", behind=4)
    assert help_text["signatures"][0]["label"] == "LOW(word)", help_text
    session.check_document("fast.plc")
    assert "KDRV" in session.check_document("lathe.sym")
    assert "DOF EMERG: I0K0" in [one["name"] for one in session.document("textDocument/documentSymbol", "fast.plc")]
    found = session.client.request("workspace/symbol", {"query": "kdrv"})
    assert [one["name"] for one in found] == ["KDRV"], found


def technol(session):
    has(session.hover("konst.inc", "EQUI DOBA_LUZKA", "DOBA_LUZKA"), "pocket down or up", "= 100")
    definition = session.line_of("konst.inc", "EQUI SEKUNDA,50")
    assert session.places("textDocument/definition", "konst.inc", "EQUI DOBA_LUZKA", "SEKUNDA") == [definition]
    mentions = session.places("textDocument/references", "konst.inc", "EQUI SEKUNDA,50", "SEKUNDA")
    assert len(mentions) > 8 and definition in mentions, mentions
    changed = session.rename("SEKUNDY", "konst.inc", "EQUI SEKUNDA,50", "SEKUNDA")
    assert changed["konst.inc"] == len([one for one in mentions if one.startswith("konst.inc")]), changed
    has(session.refused("textDocument/rename", "konst.inc", "EQUI SEKUNDA,50", "SEKUNDA", newName="LDR"), "refused")
    has(session.hover("main.plc", "CALL POLOZKA", "CALL"), "`CALL label`")
    assert "SUMA" in session.labels("main.plc", "IN_SUMA:  CALL SUMA", "SUMA", 2, last=True)
    help_text = session.ask("textDocument/signatureHelp", "main.plc", "CALL POLOZKA", "POLOZKA", behind=1)
    assert help_text["signatures"][0]["label"] == "CALL label", help_text
    callers = session.calls("main.plc", "CALL POLOZKA", "POLOZKA", "incoming")
    assert "MODULE_MAIN" in callers, callers
    assert session.calls("main.plc", "CALL POLOZKA", "CALL", "outgoing"), "what the module around it calls"
    session.check_document("main.plc")
    session.check_document("konst.inc")


def host50(session):
    has(session.hover("main.il", "AND  SAFE", "SAFE"), "%", "written:", "read:")
    has(session.hover("main.il", "[/HYD_FAULT ]", "HYD_FAULT"), "%B602", "main.il:18", "main.il:20")
    has(session.hover("main.il", "TONS T_SECOND", "TONS"), "`TONS")
    definition = session.line_of("ck6150.il", "%B602 HYD_FAULT")
    assert session.places("textDocument/definition", "main.il", "(R HYD_FAULT )", "HYD_FAULT") == [definition]
    mentions = session.places("textDocument/references", "main.il", "(R HYD_FAULT )", "HYD_FAULT")
    assert {definition, "main.il:16", "main.il:18", "main.il:20"} <= set(mentions), mentions
    assert session.rename("HYD_ALARM", "main.il", "LD   HYD_FAULT", "HYD_FAULT")["main.il"] >= 4
    labels = session.labels("main.il", "LD   HYD_FAULT", "HYD_FAULT", 3)
    assert {"HYD_FAULT", "HYD_PRESS"} <= set(labels), labels
    assert labels["HYD_PRESS"]["documentation"] == "hydraulic pressure there", labels["HYD_PRESS"]
    help_text = session.ask("textDocument/signatureHelp", "main.il", "TONS T_SECOND, 1", ", 1", behind=2)
    assert help_text["activeParameter"] == 1 and help_text["signatures"][0]["label"].startswith("TONS "), help_text
    assert session.calls("main.il", "CALL SR40", "SR40", "incoming") == ["SLOW"]
    assert "SR40" in session.calls("main.il", 'SLOW "', "SLOW", "outgoing")
    assert session.places("textDocument/definition", "main.il", "CALL SR40", "SR40") == [session.line_of("mcodes.il", "SUB SR40")]
    assert session.check_document("main.il") == ["SLOW"]
    session.check_document("ck6150.il")


def prostep(session):
    has(session.hover("fast.plc", "A I 20.1", "I 20.1"), "bit in", "read:")
    has(session.hover("fast.plc", ":S C 1", "S"), "`S")
    labels = [session.line_of("fast.plc", "PIERW :L")]
    assert session.places("textDocument/definition", "fast.plc", ":JC PIERW", "PIERW") == labels
    mentions = session.places("textDocument/references", "fast.plc", ":JC PIERW", "PIERW")
    assert len(mentions) == 2, f"each module has a label of this name: {mentions}"
    assert session.rename("NOWY", "fast.plc", ":JC PIERW", "PIERW") == {"fast.plc": 2}
    assert session.calls("loop.plc", ":JC PM 20", "PM 20", "incoming"), "who calls PM 20"
    assert session.places("textDocument/definition", "loop.plc", ":JC PM 20", "PM 20")
    found = session.labels("fast.plc", ":JC PIERW", "PIERW", 2)
    assert list(found) == ["PIERW"], found
    assert "JC" in session.labels("fast.plc", ":JC PIERW", "JC", 1)
    has(session.ask("textDocument/signatureHelp", "fast.plc", "A I 20.1", "I 20.1", behind=3)["signatures"][0]["label"], "A ")
    assert "PM 0" in session.check_document("fast.plc")
    session.check_document("mill.plc")


def hnc(session):
    has(session.hover("mill.cld", "fill_magazine();", "fill_magazine"), "void fill_magazine()")
    has(session.hover("axes.h", "set_axis_home(a, 0)", "set_axis_home"), "void set_axis_home(int, int);")
    assert session.places("textDocument/definition", "mill.cld", "        fill_magazine();", "fill_magazine") == ["mill.cld:20"]
    mentions = session.places("textDocument/references", "tools.h", "if (wanted_tool == tool_in_spindle)", "tool_in_spindle")
    assert {"state.h:23", "tools.h:43", "mill.cld:27"} <= set(mentions), mentions
    changed = session.rename("tool_in_use", "state.h", "#define tool_in_spindle", "tool_in_spindle")
    assert {"state.h": 1, "mill.cld": 1}.items() <= changed.items() and changed["tools.h"] > 5, changed
    assert session.rename("full_magazine", "mill.cld", "void fill_magazine()", "fill_magazine") == {"mill.cld": 2}
    has(session.refused("textDocument/rename", "mill.cld", "void fill_magazine()", "fill_magazine", newName="init"), "refused")
    local = session.rename("pocket", "mill.cld", "    int p;", "p")
    assert local == {"mill.cld": 6}, local
    help_text = session.ask("textDocument/signatureHelp", "axes.h", "set_axis_home(a, 0)", ", 0", behind=2)
    assert help_text["activeParameter"] == 1, help_text
    assert help_text["signatures"][0]["label"] == "set_axis_home(int, int)", help_text
    assert "fill_magazine" in session.labels("mill.cld", "        fill_magazine();", "fill_magazine", 4)
    assert session.calls("mill.cld", "void fill_magazine()", "fill_magazine", "incoming") == ["init"]
    assert "fill_magazine" in session.calls("mill.cld", "void init()", "init", "outgoing")
    names = session.check_document("mill.cld")
    assert {"fill_magazine", "init"} <= set(names), names
    session.check_document("tools.h")


def comments_of_their_own(plcxx, directory):
    """What a comment behind a definition says is about this one, and not about the next one: START is not STOP."""
    path = pathlib.Path(directory) / "press.cld"
    text = ("#define START (X[0] & 1)  /* start */\n#define STOP (X[0] & 2)\nint a; // first\nint b;\n"
            "/* about c */\nint c;\nvoid plc1(void) { a = b; Y[0] = c; }\n")
    client = Client(plcxx)
    client.open(path, text)

    def hover(line, character):
        return client.request("textDocument/hover", client.at(path, line, character))["contents"]["value"]
    has(hover(0, 9), "start")
    has(hover(2, 4), "first")
    has(hover(5, 4), "about c")
    assert "start" not in hover(1, 9), hover(1, 9)
    assert "first" not in hover(3, 4), hover(3, 4)
    names = pathlib.Path(directory) / "names.plc"
    client.open(names, "          DATA\nIN0:      DFM A   ; the key\n          DATA_END\n          STOP\n")
    value = client.request("textDocument/hover", client.at(names, 1, 14))["contents"]["value"]
    assert value.count("the key") == 1, value
    assert client.shut_down() == 0


def page_of_a_message(plcxx, directory):
    path = pathlib.Path(directory) / "lamp.plc"
    client = Client(plcxx)
    client.open(path, "$\nU4A0=IOA7*I0A1\n")
    has(client.request("textDocument/hover", client.at(path, 1, 6))["contents"]["value"], "# nc110-1")
    for line, character in [(0, 0), (1, 500), (7, 0), (-1, -1), (1, 4)]:
        for method in ["hover", "definition", "references", "completion", "signatureHelp", "documentHighlight",
                       "prepareCallHierarchy"]:
            answer = client.raw_request(f"textDocument/{method}", client.at(path, line, character))
            assert "result" in answer, (method, answer)
    assert client.shut_down() == 0


def main():
    plcxx, root = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as directory:
        page_of_a_message(plcxx, directory)
        comments_of_their_own(plcxx, directory)
        for check in [nc110, technol, host50, prostep, hnc]:
            session = Session(plcxx, root, check.__name__, directory)
            check(session)
            session.end()
            print(check.__name__, "passed")


if __name__ == "__main__":
    main()
