#!/usr/bin/env python3
"""The lathe on an emulated board, and plcxx live --link beside it.

link.py BOARD PLCXX ROOT BUILD EMULATOR...

Its serial port is a TCP connection, a socket's file or a serial line (a pseudo terminal): QEMU's character devices. Values are
read, watched, written, forced and released; a machine with another program and one that permits reading only are refused
to be changed. Then the machine runs its 200 periods while rubbish and frames with right CRCs come as fast as it takes them:
its State must be, period by period, what it is in a run without a link.
"""
import contextlib
import pathlib
import random
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading

sys.dont_write_bytecode = True
from board import COUNTED, Board, linked  # noqa: E402

PLCXX, ROOT = sys.argv[2], pathlib.Path(sys.argv[3])
BOARD = Board(sys.argv[1], sys.argv[4], sys.argv[5:])
LATHE = ROOT / "samples" / "nc110" / "lathe_16k20"


def live(address, *words, project=LATHE, code=0):
    run = subprocess.run([PLCXX, "live", str(project), "--link", address, *words], capture_output=True, text=True, timeout=120)
    assert run.returncode == code, f"{words}: exit code {run.returncode}, not {code}: {run.stdout}{run.stderr}"
    return run.stdout + run.stderr


def operate(transport, folder):
    with BOARD.running("linked", transport, folder) as address:
        text = live(address, "--read", "P24OK,DOOR", "--read", "TURCOD")
        assert text == "P24OK = 1\nDOOR = 1\nTURCOD = 49\n", text
        text = live(address, "--write", "CNTHIGH=42", "--read", "CNTHIGH")
        assert text == "CNTHIGH = 42\n", text
        # An input against what the machine reads, an output against the program; both are let go with the command.
        waveform = folder / "forced.vcd"
        text = live(address, "--force", "DOOR=0,LIGHT=1", "--watch", "DOOR,LIGHT,GUARD,TURCOD", "--for", "2s", "--save", str(waveform))
        last = text.splitlines()[-2]
        assert "DOOR 0  LIGHT 1  GUARD 0  TURCOD 49" in last, text
        samples, lost = map(int, re.search(r"(\d+) samples, (\d+) lost", text).groups())
        assert samples > 5, text
        print(f"{BOARD.name}, {transport}: {samples} samples, {lost} lost in 2 s")
        assert "$var" in waveform.read_text()
        text = live(address, "--read", "DOOR,GUARD")
        assert text == "DOOR = 1\nGUARD = 1\n", text
        # Another program: one comment differs.
        other = folder / "other"
        shutil.copytree(LATHE, other)
        with open(other / "turret.plc", "a") as file:
            file.write(";other\n")
        text = live(address, "--read", "DOOR", project=other, code=1)
        assert "runs another program: other sources" in text, text
        shutil.rmtree(other)
        assert "NOWHERE" in live(address, "--read", "NOWHERE", code=2)
    with BOARD.running("linked_shown", transport, folder) as address:
        for words in (["--write", "CNTHIGH=42"], ["--force", "LIGHT=1", "--for", "1s"]):
            text = live(address, *words, code=1)
            assert "permits reading only" in text, text


def crc(data):
    value = 0xFFFF
    for byte in data:
        value ^= byte << 8
        for _ in range(8):
            value = (value << 1 ^ (0x1021 if value & 0x8000 else 0)) & 0xFFFF
    return value


def hostile(generator):
    if generator.random() < 0.3:
        return bytes(generator.choice([0xA5, generator.randrange(256)]) for _ in range(generator.randrange(100)))
    payload = generator.randbytes(generator.choice([0, 1, 2, 2, generator.randrange(65)]))
    offset = generator.choice([generator.randrange(1200), generator.randrange(1 << 32)])
    body = bytes([len(payload), generator.randrange(10), 1]) + offset.to_bytes(4, "little") + payload
    return b"\xa5" + body + crc(body).to_bytes(2, "big")


def digest(program, *options):
    run = subprocess.run(BOARD.command(program, *COUNTED, *options), capture_output=True, text=True, timeout=250)
    return re.search(r"digest [0-9a-f]{8}", run.stdout + run.stderr).group(0)


def attack(folder):
    alone = digest("unlinked")
    assert digest("linked_reading") == alone, "a link that nobody uses changes the machine"
    received = []
    with socket.socket(socket.AF_UNIX) as server:
        path = folder / "attack.socket"
        server.bind(str(path))
        server.listen()
        ended = threading.Event()

        def send():
            generator = random.Random(20261126)
            with server.accept()[0] as peer:
                peer.settimeout(0.05)
                while not ended.is_set():
                    with contextlib.suppress(TimeoutError):
                        peer.sendall(hostile(generator))
                    with contextlib.suppress(TimeoutError):
                        data = peer.recv(4096)
                        if not data:
                            return
                        received.append(data)

        def attacker():
            with contextlib.suppress(OSError):
                send()

        thread = threading.Thread(target=attacker)
        thread.start()
        attacked = digest("linked_reading", *linked(f"socket,path={path}"))
        ended.set()
        thread.join()
    count = sum(map(len, received))
    assert attacked == alone, f"hostile bytes have changed the machine: {attacked}, without a link {alone}"
    # How many there are is the computer's load; tests/link/cost.py has the most that a period takes.
    assert count > 50, f"only {count} bytes were answered: was it attacked?"
    print(f"{BOARD.name}: {alone} also while {count} bytes of answers were asked for by hostile frames")


with tempfile.TemporaryDirectory() as name:
    FOLDER = pathlib.Path(name)
    for kind in ("socket", "serial") if BOARD.name == "riscv" else ("tcp", "serial"):
        BOARD.patiently(lambda: operate(kind, FOLDER))
    BOARD.patiently(lambda: attack(FOLDER))
