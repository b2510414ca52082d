"""Words of a command line that nobody meant: each option of a subcommand, with values from everywhere."""
import re
import subprocess

# Those that limit the work, and those that name a program to run.
KEPT = ("--time", "--time-limit", "--for", "--cycles", "--depth", "--help", "--jobs", "-j", "--cxx", "--compiler", "--engine",
        "--git-external", "--git", "--trigger", "--sampling", "--samples", "--delay")
VALUES = ("", " ", "x", "0", "1", "-1", "255", "65536", "4294967296", "99999999999999999999", "1e400", "nan", "0x", "0x10",
          "a=b", "=", "==", "a=", "=b", ",", "a,b", "a,,b", "..", ".", "/", "/dev/null", "/dev/full", "nosuch/x/y", "out", "-", "--",
          "-x", "%s%n", "\x1b[31m", "\u202e", "пила", "'", '"', "\\", "\n", "a\nb", "$(x)", "*", "[", "(" * 1000, "x" * 100_000,
          "1:2", "1ms:a=1", "rising:a", "all", "none", "text", "json", "utf-8", "on", "off", "99999h", "10ms", "10,2", "1..3")


def options(plcxx, command):
    """(option, takes a value) of the subcommand."""
    text = subprocess.run([plcxx, command, "--help"], capture_output=True, text=True, check=True).stdout
    rows = re.findall(r"^ +(-[\w-]+(?:,--[\w-]+)*)( [A-Z][A-Z=\w\[\]:.,]*)?", text, re.MULTILINE)
    found = [(names.split(",")[-1], bool(value)) for names, value in rows]
    return [(name, value) for name, value in found if name not in KEPT]


def keys(plcxx):
    """KEY of --set, of all dialects."""
    text = subprocess.run([plcxx, "emit", "--help"], capture_output=True, text=True, check=True).stdout
    table = re.search(r"^Options of the dialects.*\n((?:  .*\n)+)", text, re.MULTILINE).group(1)
    return re.findall(r"([A-Za-z][\w-]*)(?=,|$)", table, re.MULTILINE)


def wrong(random, table, words, names):
    """The command with one to three options of its own, before or behind the others."""
    added = []
    for _ in range(random.choice((1, 1, 2, 3))):
        option, takes_value = random.choice(table["options"][words[0]])
        if option == "--set" or random.random() < 0.3:
            added += ["--set", random.choice(table["keys"]) + random.choice(("=", "=", "=", "")) + random.choice(VALUES)]
            continue
        added.append(option)
        if takes_value and random.random() < 0.95:
            added.append(random.choice(VALUES + tuple(names)).replace("\0", ""))
    return [words[0], *added, *words[1:]] if random.random() < 0.5 else [*words, *added]
