"""Changes of the bytes of a case: what a typo, a bad copy, another tool or somebody hostile does to a file."""
import re

HOSTILE = (b"\x1b]0;title\x07", b"\x1b[2J", "\u202e".encode(), "\u2066".encode(), b"\xff", b"\xc3", b"\x00", b"\x1a",
           "\ufeff".encode(), "\u0415".encode(), "\uff1b".encode(), b"\r", b"\n\n", b",", b"'", b'"', b"(" * 300,
           b"[" * 300, b"{" * 300, b"4294967296", b"-1", b"99999999999999999999", b"1e400", b"0x", b"*", b"&a", b"<<",
           b"../../../etc/passwd", b"/dev/zero")


MOST_BYTES = 1 << 20  # of a file that was changed


def tokens(data):
    return [match.span() for match in re.finditer(rb"[A-Za-z_%!#$]?[\w.]+|\S", data[:200_000])] or [(0, len(data))]


def one(random, data, others):
    spans = tokens(data)
    begin, end = random.choice(spans)
    lines = data.splitlines(keepends=True) or [b""]
    at = random.randrange(len(lines))
    other = random.choice(others)
    match random.randrange(13):
        case 0:
            return data[:begin] + data[end:]
        case 1:
            return data[:end] + b" " + data[begin:end] + data[end:]
        case 2:
            return data[:begin] + random.choice(HOSTILE) + data[begin:]
        case 3:
            return data[:begin] + random.choice(HOSTILE) + data[end:]
        case 4:
            return data[:random.randrange(len(data) + 1)]
        case 5:
            place = random.randrange(len(data) + 1)
            return data[:place] + bytes([random.randrange(256)]) + data[place + 1:]
        case 6:
            first, last = random.choice(tokens(other))
            return data[:begin] + other[first:last] + data[end:]
        case 7:
            # A file may be one line of a megabyte: no more copies than the file may have bytes.
            times = min(random.choice((2, 20, 2000)), MOST_BYTES // len(lines[at] or b" ") + 1)
            return b"".join(lines[:at] + lines[at:at + 1] * times + lines[at + 1:])
        case 8:
            return b"".join(lines[:at] + lines[at + 1:])
        case 9:
            to = random.randrange(len(lines))
            lines[at], lines[to] = lines[to], lines[at]
            return b"".join(lines)
        case 10:
            block = other.splitlines(keepends=True)
            start = random.randrange(len(block) + 1)
            return b"".join(lines[:at] + block[start:start + random.randrange(1, 9)] + lines[at:])
        case 11:
            first, last = random.choice(spans)
            return data[:begin] + data[first:last] + data[end:]
        case _:
            number = random.choice((b"0", b"1", b"255", b"256", b"65535", b"65536", b"2147483648", b"1000000000000"))
            return re.sub(rb"\d+", number, data[begin:end]).join((data[:begin], data[end:]))


def several(random, data, others):
    for _ in range(random.choice((1, 1, 1, 2, 4, 12))):
        data = one(random, data, others)[:MOST_BYTES]
    return data
