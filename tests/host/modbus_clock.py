#!/usr/bin/env python3
"""How long after the last good answer the inputs of a program with `--host modbus` are safe, by the clock: the peer is gone, says
nothing, answers garbage, exceptions, or a byte now and then.

    modbus_clock.py PLCXX
"""
import os
import pathlib
import random
import socket
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = "$\nU4A0 = I0A0\nW5A1 = W1A0\n"
PERIOD_MS = 10
SLACK_MS = 250  # of a machine that others use
GOOD_S, BAD_S = 0.6, 0.6
# Each change of an input with the time at which the program sees it, by the clock of all processes.
MAIN = """#include <plcxx_host/modbus.h>

#include "fan_pins.hpp"

struct Io : plcxx::host::ModbusIo<fan_pins::Machine> {
  void Read(plcxx::host::Value* pins, int64_t now) noexcept {
    plcxx::host::ModbusIo<fan_pins::Machine>::Read(pins, now);
    const bool is = pins[fan::Host::At::I0A0].bit;
    if (is != was && count < 64) times[count++] = plcxx::host::ClockNs();
    was = is;
  }
  void Close() noexcept {
    plcxx::host::ModbusIo<fan_pins::Machine>::Close();
    for (int i = 0; i < count; ++i) printf("%s %.6f\\n", i % 2 == 0 ? "live" : "safe", static_cast<double>(times[i]) / 1e9);
  }
  bool was = false;
  int count = 0;
  int64_t times[64] = {};
};

int main(int argc, char** argv) {
  static Io io;
  return plcxx::host::RunLoop<fan_pins::Machine>(argc, argv, io);
}
"""


def answer(request):
    """All bits 1, all numbers 0."""
    transaction, _, _, unit, function = struct.unpack(">HHHBB", request[:8])
    data = request[8:12]
    if function in (1, 2):
        count = struct.unpack(">HH", data)[1]
        data = bytes([(count + 7) // 8]) + b"\xff" * ((count + 7) // 8)
    elif function in (3, 4):
        count = struct.unpack(">HH", data)[1]
        data = bytes([2 * count]) + bytes(2 * count)
    return struct.pack(">HHHBB", transaction, 0, len(data) + 2, unit, function) + data


def fail(kind, listener, peer, request, generator):
    """What the peer does instead of an answer; false: it does nothing more."""
    if kind in ("closes", "resets"):
        if kind == "resets":
            peer.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        peer.close()
        listener.close()
    elif kind == "answers garbage":
        peer.sendall(generator.randbytes(generator.choice((1, 7, 9, 40, 260))))
        return True
    elif kind == "answers exceptions":
        peer.sendall(request[:4] + b"\x00\x03" + request[6:7] + bytes([request[7] | 0x80, 2]))
        return True
    elif kind == "answers bytewise":
        for byte in answer(request):
            peer.sendall(bytes([byte]))
            time.sleep(0.1)
    return False


def lost(folder, kind, timeout_ms):
    generator = random.Random(kind)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
        machine = subprocess.Popen([os.path.join(folder, "fan"), "--", "--client", "127.0.0.1:%d" % port, "--timeout", str(timeout_ms)],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        peer, _ = listener.accept()
        with peer:
            peer.settimeout(5)
            begin = time.monotonic()
            last = begin
            try:
                while request := peer.recv(300):
                    if time.monotonic() - begin < GOOD_S:
                        peer.sendall(answer(request))
                        last = time.monotonic()
                    elif not fail(kind, listener, peer, request, generator) or time.monotonic() - begin > GOOD_S + BAD_S:
                        break
            except OSError:
                pass
            time.sleep((timeout_ms + SLACK_MS) / 1000)
            machine.terminate()
            said, errors = machine.communicate(timeout=10)
    changes = [line.split() for line in said.splitlines()]
    safe = [1000 * (float(when) - last) for what, when in changes if what == "safe" and float(when) > last]
    assert machine.returncode == 0 and safe, (kind, said, errors)
    print("the peer %-20s %4d ms declared, safe after %4.0f ms" % (kind + ":", timeout_ms, safe[0]), flush=True)
    # A period that begins when the time is just not over sees it in the next one.
    assert timeout_ms - SLACK_MS < safe[0] < timeout_ms + PERIOD_MS + SLACK_MS, (kind, said, errors)
    assert "connection lost: safe inputs" in errors, errors


def main():
    if not pathlib.Path("/usr/include/modbus/modbus.h").exists():
        print("libmodbus is not installed (libmodbus-dev)")
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as folder:
        pathlib.Path(folder, "fan.plc").write_text(PROGRAM)
        pathlib.Path(folder, "main.cpp").write_text(MAIN)
        subprocess.run([sys.argv[1], "emit", "fan.plc", "-o", ".", "--host", "modbus", "--quiet"], cwd=folder, check=True)
        subprocess.run(["c++", "-std=c++17", "-O1", "-Wall", "-Wextra", "-I", ROOT / "runtime_support", "fan.cpp", "fan_pins.cpp", "main.cpp",
                        "-lmodbus", "-lpthread", "-o", "fan"], cwd=folder, check=True)
        for kind in ("closes", "resets", "says nothing", "answers garbage", "answers exceptions", "answers bytewise"):
            lost(folder, kind, 400)
        lost(folder, "says nothing", 1500)


main()
