"""The cases of the tree: each a scenario with the files that it names, read without a YAML library."""
import dataclasses
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent))
from inline_sources import sources_of  # noqa: E402

DIALECTS = ("classicladder", "hnc", "host50", "nc110", "prostep", "technol")


@dataclasses.dataclass
class Case:
    scenario: pathlib.Path
    dialect: str
    sources: list        # names as the scenario writes them
    options: list        # "key=value"
    files: dict          # name -> bytes: the scenario, and every file beside it that it names
    maps: str = "A=B"    # what `diff --map` gets


def scenarios(root, dialects):
    for base in ("tests/golden", "samples"):
        for dialect in (each for each in DIALECTS if each in dialects):
            folder = root / base / dialect
            if folder.is_dir():
                yield from ((dialect, path) for path in sorted(folder.rglob("*.yaml"))
                            if path.name != "plcxx.yaml")


def words_of(text, key):
    """`key: word`, `key: [a, b]` or a list below it."""
    match = re.search(rf"^{key}: *(.*(?:\n +- .*|\n- .*)*)", text, re.MULTILINE)
    if not match:
        return []
    return [word.strip(" '\"") for word in re.split(r"[\[\],\n]|- ", match.group(1).split(" #")[0]) if word.strip(" '\"")]


def options_of(text):
    match = re.search(r"^options: *(\{.*\}|(?:\n +.*)+)", text, re.MULTILINE)
    pairs = re.findall(r"([\w-]+): *(\[[^\]]*\]|'[^']*'|\"[^\"]*\"|[^,}\n#]+)", match.group(1)) if match else []
    return [f"{key}={value.strip(' []').replace(', ', ',').strip(chr(39) + chr(34))}" for key, value in pairs]


def read(dialect, path):
    text = path.read_bytes().decode("utf-8", "replace")
    files = {path.name: path.read_bytes()}
    inline = sources_of(text)
    files.update({name: text.encode("utf-8", "surrogateescape") for name, text in inline.items()})
    project = path.parent / "plcxx.yaml"
    if not inline and not words_of(text, "sources") and project.is_file():  # the scenario leaves them out
        text += "\n" + project.read_bytes().decode("utf-8", "replace")
        files[project.name] = project.read_bytes()
    for name in set(re.findall(r"[^\s\[\]{},:'\"]+", text)):
        beside = path.parent / name
        if len(name) < 256 and ".." not in name and not name.startswith("/") and beside.is_file():
            files[name] = beside.read_bytes()
    return Case(path, dialect, list(inline) or words_of(text, "sources"), options_of(text), files)


def cases(root, dialects=DIALECTS):
    for dialect, path in scenarios(root, dialects):
        case = read(dialect, path)
        if case.sources and all(name in case.files for name in case.sources):
            yield case


def write(folder, files):
    """Files by name, with the folders that they lie in."""
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
