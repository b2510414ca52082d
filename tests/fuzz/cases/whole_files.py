"""Changes of a whole file: what a copy through another system, a generator gone wild, or somebody hostile makes of it."""
import re

DEEP = 100_000
# What opens and closes in each language, and what a line of it must begin with.
BRACKETS = {
    "classicladder": (("_FILE-rung_0.csv\n", "_/FILE-rung_0.csv\n"), ("_FILE-sections.csv\n", "_/FILE-sections.csv\n"), ("(", ")"),
                      ("!", ""), ("-", ""), ("@200/1[200/", "]@"), ("1-0-50/0 , ", ""), ("ABS(", ")"), ("#COMMENT=", "")),
    "nc110": (("(", ")"), ("[", "]"), ("/", ""), ("DOF:I0A0\n", "ENDF\n"), ("SGN(", ")"), ("DEC(", ")")),
    "host50": (("(", ")"), ("MPS\n", "MPP\n"), ("LD %I1\n", "ANB\n"), ("SLOW\n", "END_SLOW\n"), ("SUB 1\n", "END_SUB\n"),
               ("LADDER\n", "END_LADDER\n"), ("|--[ %I0 ]", ""), ("(* ", " *)")),
    "prostep": ((":A(\n", ":)\n"), (":O(\n", ":)\n"), (":MOD PM 1\n", ":END PM 1\n"), (":O\n", "")),
    "technol": (("(", ")"), ("[", "]"), (" MECH_BEGIN M\n", " MECH_END M\n"), ("M MACRO\n", "ENDM\n"), (" PUSH AX\n", " POP AX\n"),
                (" MODULE_MAIN\n", " MODULE_MAIN_END\n"), ("NOT ", ""), ("-", "")),
    "hnc": (("(", ")"), ("[", "]"), ("{", "}"), ("if (1) ", ""), ("/*", "*/"), ("#if 1\n", "#endif\n"), ("-", ""), ("!", ""),
            ("*", ""), ("sizeof ", ""), ("struct {", "} a;"), ("while (1) {", "}"), ("switch (1) { case 1: ", "}"),
            ("1 ? 1 : ", "1"), ("(int)", ""), ("x = ", "1"), ("1 + ", "1")),
    "yaml": (("[", "]"), ("{a: ", "}"), ("- ", ""), ("? ", ""), ("'", "'"), ("!a ", ""), ("&a ", ""), ("<<: *a\n", "")),
}
ENCODINGS = ("utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-8-sig", "gb18030", "cp866", "cp1251", "koi8-r", "cp852", "cp1250",
             "utf-7", "cp037")


def encoded(random, data, _language):
    text = data.decode("utf-8", "replace")
    if random.random() < 0.5:  # letters that the code page has, or does not
        text = re.sub(r"[a-z]", lambda found: chr(0x430 + ord(found[0]) - 97) if random.random() < 0.1 else found[0], text)
    return text.encode(random.choice(ENCODINGS), "replace")


def cut_letters(random, data, _language):
    """Letters of several bytes, some without their end."""
    return b"".join(line + random.choice((b"", b"\xd0", b"\xe2\x82", b"\xf0\x9f\x92", b"\xc0\xaf", b"\xed\xa0\x80", b"\x81\x30"))
                    for line in data.splitlines(keepends=True))


def line_ends(random, data, _language):
    data = data.replace(b"\r\n", b"\n")
    match random.randrange(6):
        case 0:
            return data.replace(b"\n", b"\r")
        case 1:
            return data.replace(b"\n", b"\r\n")
        case 2:
            return data.replace(b"\n", b"\n\r")
        case 3:
            return data.rstrip(b"\n")
        case 4:
            return data.replace(b"\n", random.choice((b"\x0c", b"\x0b", "\u2028".encode(), b"\x85", b" ")))
        case _:
            return data + random.choice((b"\x1a", b"\0", b"\0" * 100_000, b"\n" * 100_000, b"\x1a" + data))


def nested(random, data, language):
    opening, closing = random.choice(BRACKETS[language])
    count = random.choice((300, 5000, DEEP))
    text = (opening * count + random.choice(("", "X", closing * count, closing * (count + 1)))).encode()
    at = random.choice([found.start() for found in re.finditer(rb"^|$|[ =:(]", data, re.MULTILINE)] or [0])
    return data[:at] + text + data[at:]


def huge(random, data, _language):
    """One number, name, text or line that is longer than anybody writes."""
    spans = [found.span() for found in re.finditer(rb"\d+|[A-Za-z_]\w*|'[^'\n]*'|\"[^\"\n]*\"|[^\n]+", data)] or [(0, 0)]
    begin, end = random.choice(spans)
    piece = data[begin:end] or b"1"
    grown = piece[:1] + piece[1:-1] * 1 + piece[-1:] * random.choice((20, 5000, 1 << 20))
    return data[:begin] + grown[:1 << 20] + data[end:]


def repeated(random, data, _language):
    lines = data.splitlines(keepends=True) or [b""]
    first = random.randrange(len(lines))
    last = random.randrange(first, min(len(lines), first + 5)) + 1
    block = b"".join(lines[first:last])
    count = min(random.choice((100, 3000, 30000)), (1 << 20) // max(1, len(block)))
    return b"".join(lines[:first]) + block * count + b"".join(lines[last:])


def other_kind(random, data, _language):
    return random.choice((b"", b"\0", b"\n", data[::-1], b"\x7fELF" + data, b"%PDF-1.4\n" + data, b"PK\x03\x04" + data,
                          bytes(random.randrange(256) for _ in range(3000))))


CHANGES = (encoded, cut_letters, line_ends, line_ends, nested, nested, nested, huge, huge, repeated, repeated, other_kind)


def change(random, data, language):
    return random.choice(CHANGES)(random, data, language)[:4 << 20]
