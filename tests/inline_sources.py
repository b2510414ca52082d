"""Programs that are written in their scenario: `sources:` with names and texts, as tests/golden has them."""
import pathlib
import re
import sys

BLOCK = re.compile(r"^sources:[ \t]*\n((?:  [^\s].*\n|    .*\n|[ \t]*\n)+)", re.MULTILINE)
TEXT = re.compile(r"^  ([^\s:]+): \|2?([-+]?)\n((?:    .*\n|[ \t]*\n)*)", re.MULTILINE)


def sources_of(scenario):
    """Name: text, in their order; empty where the scenario names files, or none."""
    block = BLOCK.search(scenario if scenario.endswith("\n") else scenario + "\n")
    texts = {}
    for name, ends, lines in TEXT.findall(block[1]) if block else ():
        text = "".join(line[4:] or "\n" for line in lines.splitlines(keepends=True))
        texts[name] = text if ends == "+" else text.rstrip("\n") + ("" if ends == "-" else "\n")
    return texts


def unfold(folder, into):
    """Copies a folder of scenarios; what is written in them becomes a file beside them, too. Gives the number of files."""
    count = 0
    for path in sorted(folder.rglob("*")):
        if not path.is_file():
            continue
        copy = into / path.relative_to(folder)
        copy.parent.mkdir(parents=True, exist_ok=True)
        data = path.read_bytes()
        copy.write_bytes(data)
        count += 1
        if path.suffix != ".yaml":
            continue
        for name, text in sources_of(data.decode("utf-8", "surrogateescape")).items():
            copy.with_name(name).write_bytes(text.encode("utf-8", "surrogateescape"))
            count += 1
    return count


if __name__ == "__main__":  # inline_sources.py FOLDER INTO
    sys.exit(0 if unfold(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])) else "no files")
