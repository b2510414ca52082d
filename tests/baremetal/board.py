"""An emulated board of samples/baremetal that runs the lathe: how it is started, and the address of its serial port."""
import contextlib
import pathlib
import re
import socket
import subprocess
import sys
import time

COUNTED = ["-icount", "shift=4,sleep=off"]  # time is instructions: every run is the same
# Likewise, at most as fast as real time: a busy computer is no reason for the machine's watchdog.
IN_REAL_TIME = ["-icount", "shift=4,sleep=on"]


def linked(chardev):
    return ["-chardev", f"{chardev},id=link", "-serial", "chardev:link"]


def free_port():
    with socket.socket() as some:
        some.bind(("127.0.0.1", 0))
        return some.getsockname()[1]


ATTEMPTS = 4  # of what a starved machine ended


class Board:
    """`build` has the programs, each for this board; `emulator` is its command with the machine's options."""

    def __init__(self, name, build, emulator):
        self.name, self.build, self.emulator = name, pathlib.Path(build), emulator
        self.starved = False  # the watchdog of the last machine ended it: this computer had no time for the emulator

    def patiently(self, act):
        """Calls it, anew where the machine was starved: a computer that stands still for longer than the machine's watchdog
        waits says nothing about what is tested."""
        for attempt in range(1, ATTEMPTS + 1):
            try:
                return act()
            except Exception:
                if not self.starved or attempt == ATTEMPTS:
                    raise

    def command(self, program, *options):
        return [*self.emulator, "-nodefaults", "-display", "none", *options, "-semihosting-config", "enable=on,target=native",
                "-kernel", str(self.build / f"{program}.{self.name}.elf")]

    @contextlib.contextmanager
    def running(self, program, transport, folder, port=None):
        """A running machine; gives the address for --link. A socket is there again under its name; `port`: so is it over TCP."""
        path, port = folder / "link.socket", port or free_port()
        path.unlink(missing_ok=True)
        chardev = {"socket": f"socket,path={path},server=on,wait=off",
                   "tcp": f"socket,host=127.0.0.1,port={port},server=on,wait=off", "serial": "pty"}[transport]
        process = subprocess.Popen(self.command(program, *IN_REAL_TIME, *linked(chardev)), stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True)
        try:
            if transport == "serial":
                terminal = re.search(r"/dev/pts/[0-9]+", process.stdout.readline())
                yield f"serial:{terminal.group(0)}:115200"
            else:
                end = time.monotonic() + 30
                while time.monotonic() < end:
                    with contextlib.suppress(OSError), socket.socket(
                            socket.AF_UNIX if transport == "socket" else socket.AF_INET) as some:
                        some.connect(str(path) if transport == "socket" else ("127.0.0.1", port))
                        break
                    time.sleep(0.05)
                yield f"socket:{path}" if transport == "socket" else f"tcp:127.0.0.1:{port}"
            if process.poll() is not None:
                raise RuntimeError("the emulator ended by itself")
        finally:
            ended = process.poll()
            process.kill()
            process.wait()
            said = process.stdout.read() if ended is not None else ""
            self.starved = "watchdog" in said
            if ended is not None:
                print(f"the emulator ended by itself, with {ended}: {said}", file=sys.stderr)
            process.stdout.close()
