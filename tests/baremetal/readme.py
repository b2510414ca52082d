#!/usr/bin/env python3
"""The commands of samples/baremetal/README.md, one after the other, as somebody types them at the root of plcxx.

readme.py PLCXX ROOT    exit code 77: a compiler or an emulator is not there
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PLCXX, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()

for tool in ("arm-none-eabi-g++", "qemu-system-arm", "riscv64-unknown-elf-g++", "qemu-system-riscv32"):
    if shutil.which(tool) is None:
        print(f"skipped: there is no {tool}")
        sys.exit(77)
fences = re.findall(r"^```sh\n(.*?)^```$", (ROOT / "samples/baremetal/README.md").read_text(), re.M | re.S)
assert len(fences) == 4, f"{len(fences)} fences"
with tempfile.TemporaryDirectory(prefix="plcxx-test-") as name:
    for folder in ("runtime_support", "samples"):
        (pathlib.Path(name) / folder).symlink_to(ROOT / folder)
    # The board in the background ends also where a command fails.
    script = "trap 'kill $board 2>/dev/null || true' EXIT\n" + "".join(fences)
    with open(pathlib.Path(name) / "said", "w") as output:
        ran = subprocess.run(["sh", "-e", "-c", script], cwd=name, stdout=output, stderr=subprocess.STDOUT, timeout=240,
                             env={**os.environ, "PATH": f"{PLCXX.parent}:{os.environ['PATH']}"})
    said = (pathlib.Path(name) / "said").read_text()
print(said)
assert ran.returncode == 0, ran.returncode
assert said.count("the lathe ran") == 2, "both boards say what they did"
assert re.search(r"^DOOR = 1\nGUARD = 1$", said, re.M), "the door is shut"
assert re.search(r" ms  DOOR 0  GUARD 0$", said, re.M), "it is forced open"
