#!/usr/bin/python3
"""A program with `--host modbus`, against a second implementation of the protocol (pymodbus) and against peers that
answer garbage: as a server, as a client, and with a connection that is lost.

    modbus.py PLCXX
"""
import os
import pathlib
import random
import socket
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = """$
U4A0 = I0A0 + U4A0*/I0A1
U4A1 = I0A2
W5A1 = W1A0
"""
TIMEOUT_MS = 300
LIMIT_S = 10


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def until(what, condition):
    end = time.monotonic() + LIMIT_S
    while not condition():
        if time.monotonic() > end:
            sys.exit("not within %d s: %s" % (LIMIT_S, what))
        time.sleep(0.01)


class Machine:
    """The program as a process; ends with the block."""

    def __init__(self, folder, *arguments):
        self.errors = open(os.path.join(folder, "errors"), "w+")
        self.process = subprocess.Popen(
            [os.path.join(folder, "fan_modbus"), "--", "--timeout", str(TIMEOUT_MS), "--safe", "i0a2=1", "--safe", "w1a0=7", *arguments],
            stderr=self.errors)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        if self.process.wait(LIMIT_S) != 0:
            sys.exit("ended with %d:\n%s" % (self.process.returncode, self.said()))

    def said(self):
        self.errors.flush()
        return pathlib.Path(self.errors.name).read_text()


def build(plcxx, folder):
    source = os.path.join(folder, "fan.plc")
    pathlib.Path(source).write_text(PROGRAM)
    subprocess.run([plcxx, "emit", source, "-o", folder + "/", "--host", "modbus", "--quiet"], check=True)
    subprocess.run(["c++", "-std=c++17", "-O1", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror", "-I", ROOT / "runtime_support", "fan.cpp",
                    "fan_pins.cpp", "fan_modbus.cpp", "-lmodbus", "-lpthread", "-o", "fan_modbus"], cwd=folder, check=True)


def as_server(folder):
    from pymodbus.client import ModbusTcpClient
    port = free_port()
    with Machine(folder, "--server", "127.0.0.1:%d" % port) as machine:
        client = ModbusTcpClient("127.0.0.1", port=port)
        until("the server listens", client.connect)
        outputs = lambda: client.read_discrete_inputs(0, 2).bits[:2]
        number = lambda: client.read_input_registers(0, 2).registers

        assert not client.write_coils(0, [True, False, False]).isError()
        assert not client.write_registers(0, [0, 42]).isError()
        until("the outputs follow the inputs", lambda: outputs() == [True, False] and number() == [0, 42])
        client.write_registers(0, [1, 0])  # 65536 is more than a byte holds
        until("a number that does not fit is the greatest that does", lambda: number() == [0, 255])
        assert client.write_coils(500, [True]).isError(), "there is no coil 500"
        assert "connected" in machine.said(), machine.said()

        # Silence: after the declared time the safe values, of which I0A2 = 1 and W1A0 = 7.
        client.write_coils(0, [True, False, False])
        client.close()
        time.sleep(TIMEOUT_MS / 1000 + 0.2)
        assert "connection lost: safe inputs" in machine.said(), machine.said()
        client = ModbusTcpClient("127.0.0.1", port=port)
        assert client.connect()
        # The first answer after the silence is still made of the safe inputs.
        assert client.read_discrete_inputs(0, 2).bits[:2] == [True, True]
        assert client.read_input_registers(0, 2).registers[1] in (7, 255)
        client.write_coils(0, [False, True, False])
        until("the inputs count again", lambda: outputs() == [False, False])

        # Peers that talk something else: each is closed, the good one goes on.
        generator = random.Random(1)
        for i in range(60):
            with socket.create_connection(("127.0.0.1", port)) as peer:
                peer.sendall(generator.randbytes(1 + i * 5))
                if i % 10 == 0:
                    peer.settimeout(2)
                    try:
                        peer.recv(256)
                    except OSError:
                        pass
            if i % 20 == 0:
                assert outputs() == [False, False]
        assert machine.process.poll() is None, machine.said()
        client.close()


def remote_terminals(port):
    """pymodbus as the remote I/O; gives its tables and what stops it."""
    import asyncio

    from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
    try:
        from pymodbus.server.async_io import ModbusTcpServer
    except ImportError:  # where newer versions have it
        from pymodbus.server import ModbusTcpServer

    block = lambda: ModbusSequentialDataBlock(0, [0] * 16)
    tables = ModbusSlaveContext(di=block(), co=block(), hr=block(), ir=block(), zero_mode=True)
    loop = asyncio.new_event_loop()
    holder = {}

    async def serve():
        server = ModbusTcpServer(ModbusServerContext(slaves=tables, single=True), address=("127.0.0.1", port))
        holder["server"] = server
        await server.serve_forever()

    def work():
        asyncio.set_event_loop(loop)
        try:
            loop.run_until_complete(serve())
        except (Exception, asyncio.CancelledError):  # stopped
            pass

    thread = threading.Thread(target=work, daemon=True)
    thread.start()

    def stop():
        asyncio.run_coroutine_threadsafe(holder["server"].shutdown(), loop).result(LIMIT_S)

    return tables, stop


DISCRETE, COILS, HOLDING, INPUTS = 2, 1, 3, 4  # the function codes by which pymodbus names its tables


def as_client(folder):
    port = free_port()
    tables, stop = remote_terminals(port)
    with Machine(folder, "--client", "127.0.0.1:%d" % port, "--poll", "20") as machine:
        tables.setValues(DISCRETE, 0, [1, 0, 0])
        tables.setValues(INPUTS, 0, [0, 99])
        until("the remote outputs follow", lambda: tables.getValues(COILS, 0, 2) == [True, False] and tables.getValues(HOLDING, 0, 2) == [0, 99])
        assert "connected" in machine.said(), machine.said()
        stop()
        until("the loss is noticed", lambda: "connection lost: safe inputs" in machine.said())


def garbage_answers(folder):
    """A peer that accepts and answers each request with noise, wrong lengths or exceptions."""
    generator = random.Random(2)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
        stop = threading.Event()
        answered = []

        def answer(request):
            head = request[:4]
            kind = len(answered) % 5
            if kind == 0:
                return generator.randbytes(40)
            if kind == 1:
                return head + b"\x00\x03\xff\x82\x02"  # an exception
            if kind == 2:
                return head + b"\xff\xff\xff\x02\xff" + b"\x55" * 300  # far too long
            if kind == 3:
                return head + b"\x00\x05\xff\x02\x09\x01\x01"  # says 9 bytes, has 2
            return b""

        def serve():
            listener.settimeout(0.1)
            while not stop.is_set():
                try:
                    peer, _ = listener.accept()
                except OSError:
                    continue
                with peer:
                    peer.settimeout(0.2)
                    try:
                        request = peer.recv(256)
                        if request:
                            peer.sendall(answer(request))
                            answered.append(request)
                    except OSError:
                        pass

        thread = threading.Thread(target=serve)
        thread.start()
        with Machine(folder, "--client", "127.0.0.1:%d" % port, "--poll", "20") as machine:
            until("ten answers", lambda: len(answered) >= 10)
            assert machine.process.poll() is None, machine.said()
            assert "no good answer from 127.0.0.1:%d" % port in machine.said(), machine.said()
            assert "connected" not in machine.said(), machine.said()  # nothing of it was taken
        stop.set()
        thread.join()


def wrong_options(folder):
    for arguments, words in (([], "missing: --server ADDRESS:PORT, or --client HOST:PORT"),
                             (["--client", "here"], "no address: write HOST:PORT"),
                             (["--client", ":502"], "no address: write HOST:PORT"),
                             (["--client", "a:1", "--server", "b:2"], "a second address: one of --server and --client, once"),
                             (["--client", "a:1", "--safe", "pump=1"], "no input of the program"),
                             (["--client", "a:1", "--safe", "i0a0=2"], "the pin cannot have this value"),
                             (["--client", "a:1", "--timeout", "0"], "no timeout: 1 to 60000 ms"),
                             (["--client", "a:1", "--timeout", " 5"], "no timeout: 1 to 60000 ms"),
                             (["--client", "a:1", "--unit", "-0"], "no unit: 0 to 255"),
                             (["--client", "a:1", "--poll", "5", "--poll", "6"], "given twice"),
                             (["--server", "127.0.0.1:1", "--poll", "5"], "'--poll': is between the requests of a client"),
                             (["--client", "a:1", "--safe", "i0a0=1", "--safe", "i0a0=0"], "given twice"),
                             (["--coil", "1"], "no option; there are: --server")):
        ran = subprocess.run([os.path.join(folder, "fan_modbus"), "--", *arguments], capture_output=True, text=True, timeout=LIMIT_S)
        assert ran.returncode == 2 and words in ran.stderr, (arguments, ran)
    for arguments in (["--map"], ["--map", "foo"], ["--map", "server", "--periods", "1"]):
        ran = subprocess.run([os.path.join(folder, "fan_modbus"), *arguments], capture_output=True, text=True, timeout=LIMIT_S)
        assert ran.returncode == 2 and "'--map': takes server or client, alone on the command line" in ran.stderr, (arguments, ran)
    help_text = subprocess.run([os.path.join(folder, "fan_modbus"), "--help"], capture_output=True, text=True, check=True).stdout
    for option in ("--retentive", "--client", "--server", "--timeout", "--safe", "--poll", "--unit", "--map"):
        assert option in help_text, (option, help_text)
    table = subprocess.run([os.path.join(folder, "fan_modbus"), "--map", "client"], capture_output=True, text=True, check=True).stdout
    assert table.splitlines()[0].split()[:5] == ["discrete", "input", "0", "in", "i0a0"], table


def unreachable(folder):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        free, used = free_port(), taken.getsockname()[1]
        for arguments, words in ((["--client", "127.0.0.1:%d" % free], "cannot connect to 127.0.0.1:%d: Connection refused" % free),
                                 # A name that nobody can know (RFC 6761); without a name server the resolver says why instead.
                                 (["--client", "plc.invalid:502"], "cannot connect to plc.invalid:502: "),
                                 (["--server", "plc.invalid:502"], "cannot listen at plc.invalid:502: "),
                                 (["--server", "127.0.0.1:%d" % used], "cannot listen at 127.0.0.1:%d: Address already in use" % used)):
            with Machine(folder, *arguments) as machine:
                until(words, lambda: words in machine.said())
                assert "Connection refused" in words or "Connection refused" not in machine.said(), machine.said()


def main():
    try:
        import logging

        import pymodbus
        logging.disable(logging.CRITICAL)  # of a server that is stopped on purpose
    except ImportError:
        print("pymodbus is not installed (python3-pymodbus)")
        sys.exit(77)
    with tempfile.TemporaryDirectory(prefix="plcxx-test-") as folder:
        build(sys.argv[1], folder)
        for check in (wrong_options, unreachable, as_server, as_client, garbage_answers):
            check(folder)
            print("%s: as it should be, with pymodbus %s" % (check.__name__, pymodbus.__version__), flush=True)


main()
