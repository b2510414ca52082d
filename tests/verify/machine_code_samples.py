#!/usr/bin/env python3
"""Of each machine in samples/, built for both targets: which parts plcxx verify --object proves, as docs/verify.md has it.

machine_code_samples.py PLCXX [--time TIME] [--only NAME]
"""
import argparse
import os
import re
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SAMPLES = {
    "nc110/lathe_16k20": "lathe.sym fast.plc spindle.plc turret.plc --set iocfil=IOCFIL --set axcfil=AXCFIL "
                         "--set pgcfil=PGCFIL --set messages=RUMES5 --set menu=LGCMNU --set help=HELP",
    "host50/ck6150": "ck6150.il texts.il fast.il main.il spindle.il turret.il units.il mcodes.il",
    "prostep/mill_fnd32": "mill.plc texts.plc fast.plc loop.plc magazine.plc --dialect prostep",
    "technol/mcv_750": "mcv.plc main.plc nc.plc vymena.plc vypnuti.plc TAB_MCV.TCH --dialect technol",
    "hnc/mill_xk7132": "mill.cld",
}


def parts_of(plcxx, folder, arguments, target, time):
    with tempfile.TemporaryDirectory() as directory:
        common = [plcxx, "build"] + arguments + ["--target", target, "--quiet", "-o", directory]
        built = subprocess.run(common, cwd=folder, capture_output=True, text=True)
        if built.returncode != 0:
            return [("", "not built: " + built.stderr.strip()[-200:], 0)]
        library = next(f for f in os.listdir(directory) if f.endswith(".a"))
        said = subprocess.run([plcxx, "verify"] + arguments + ["--target", target, "--time", time, "--object",
                                                               os.path.join(directory, library)],
                              cwd=folder, capture_output=True, text=True)
    text = said.stdout + said.stderr
    found = re.findall(r"^  ([\w.]+): (proved|not decided|different)(.*)$", text, re.M)
    parts = []
    for name, result, rest in found:
        count = re.search(r"(\d+) instructions", rest)
        parts.append((name, result + ("" if result == "proved" else rest), int(count.group(1)) if count else 0))
    return parts or [("", text[-300:], 0)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("plcxx")
    parser.add_argument("--time", default="3s")
    parser.add_argument("--only", default="")
    settings = parser.parse_args()
    print("| machine | target | proved | instructions | not decided |\n|---|---|---|---|---|")
    for sample, arguments in SAMPLES.items():
        if settings.only not in sample:
            continue
        for target in ("rv32imac", "cortex-m4"):
            parts = parts_of(os.path.abspath(settings.plcxx), os.path.join(ROOT, "samples", sample), arguments.split(),
                             target, settings.time)
            proved = [part for part in parts if part[1] == "proved"]
            others = [part for part in parts if part[1] != "proved"]
            print(f"| `{sample}` | {target} | {len(proved)} of {len(parts)}: {', '.join(p[0] for p in proved)} | "
                  f"{sum(p[2] for p in proved)} | {'; '.join(p[0] + ': ' + p[1] for p in others)} |", flush=True)


if __name__ == "__main__":
    main()
