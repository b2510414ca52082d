#!/usr/bin/env python3
"""The longest paths of `plcxx build` against QEMU: no execution of a sample's parts may take more instructions.

emulated_bounds.py PLCXX   exit code 77: no emulator, or no compiler for it

Each sample is built for a Cortex-M4 and an RV32. Its parts run some hundred times with random signals, and the
instructions of each execution are counted; those of host functions, empty here, are in the count and not in the bound.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "bench"))
import emulated  # noqa: E402

# Folder below samples/, sources and options.
SAMPLES = {
    "nc110": ("nc110/lathe_16k20", "lathe.sym fast.plc spindle.plc turret.plc --set iocfil=IOCFIL --set axcfil=AXCFIL --set slices=4"),
    "host50": ("host50/ck6150", "ck6150.il texts.il fast.il main.il spindle.il turret.il units.il mcodes.il"),
    "prostep": ("prostep/mill_fnd32", "mill.plc texts.plc fast.plc loop.plc magazine.plc"),
    "technol": ("technol/mcv_750", "mcv.plc main.plc nc.plc vymena.plc vypnuti.plc TAB_MCV.TCH"),
    "hnc": ("hnc/mill_xk7132", "mill.cld"),
}
TARGETS = {"M4": "cortex-m4", "RV32": "rv32imac"}
SCANS = 300
# The timer of the Cortex-M board counts steps of 40 instructions, a call among them: so many may not be the part's own.
INEXACT = {"M4": 50, "RV32": 0}
ARGUMENTS = {"slice": "0", "elapsed_ms": "12", "now_ms": "now", "number": "10"}

HARNESS = r"""
namespace {
uint32_t seed = 1;
uint32_t now = 0, answer = 0;
uint32_t Random() { seed = seed * 1664525u + 1013904223u; return seed >> 8; }
}
namespace sample {
struct Host {};
%(stubs)s
}
static sample::State state;
static sample::Host host;
static uint32_t worst[%(count)d], call_alone[%(count)d];
// A call without a part; its return is the part's own.
[[gnu::noipa]] static void Nothing(sample::State&, sample::Host&) { asm volatile(""); }
[[gnu::noipa]] static void Nothing(sample::State&, uint32_t, sample::Host&) { asm volatile(""); }
static void Note(uint32_t which, uint32_t ticks) { if (ticks > worst[which]) worst[which] = ticks; }
static const uint16_t kBits[] = {%(bits)s};
void Measure() {
  sample::init(state, host);
%(empty_calls)s
  for (uint32_t i = 0; i < %(scans)d; ++i, now += 10) {
    answer = Random();
    for (const uint16_t bit : kBits)
      if (Random() %% 4 == 0) reinterpret_cast<unsigned char*>(&state)[bit] = Random() & 1;
%(calls)s
  }
  for (uint32_t i = 0; i < %(count)d; ++i) {
    const uint32_t around = kInstructions == 1 ? call_alone[i] - 1 : 0;
    Print(uint64_t{worst[i] - around} * kInstructions);
  }
}
"""


def stubs_of(header):
    """Host functions that do nothing; what they give is random."""
    text = ""
    for result, name, rest in re.findall(r"^(\w+) (\w+)\(Host& host(.*)\) noexcept;$", header, re.M):
        body = "" if result == "void" else "return now; " if name == "now_ms" else f"return static_cast<{result}>(answer); "
        parameters = re.sub(r"(\w+)(?=,|$)", "", rest)
        text += f"{result} {name}(Host&{parameters}) noexcept {{ {body}}}\n"
    return text


def calls_of(header, partitions):
    """(name, function, arguments, figures) of each part, and of each slice."""
    calls = []
    for part in partitions:
        parameters = re.search(rf"^void {part['name']}\(State& m(.*), Host& host\) noexcept;$", header, re.M)
        if part["name"] == "init" or parameters is None:
            continue
        names = [word.split()[-1] for word in parameters[1].split(",") if word.strip()]
        arguments = "".join(", " + ARGUMENTS[name] for name in names)
        calls.append((part["name"], f"sample::{part['name']}", f"(state{arguments}, host)", part))
        for piece in part.get("slices", []):
            calls.append((f"{part['name']}, slice {piece['slice']}", f"sample::{part['name']}", f"(state, {piece['slice']}, host)", piece))
    return calls


def compare(plcxx, dialect, board, base):
    """Rows (dialect, board, part, longest path, worst execution)."""
    folder, arguments = SAMPLES[dialect]
    out = base / f"{dialect}_{board}"
    subprocess.run([plcxx, "build", *arguments.split(), "--name", "sample", "-q", "--target", TARGETS[board], "-o", out],
                   cwd=ROOT / "samples" / folder, check=True, capture_output=True)
    header = (out / "sample.hpp").read_text()
    build = json.loads((out / "sample.report.json").read_text())["build"]
    bits = [symbol["offset"] for symbol in json.loads((out / "sample.map.json").read_text())["symbols"]
            if symbol["type"] == "bit" and "bit" not in symbol]
    calls = calls_of(header, build["partitions"])
    text = "".join(f"    {{ const uint32_t begin = Ticks(); {function}{given}; Note({i}, Ticks() - begin); }}\n"
                   for i, (_, function, given, _) in enumerate(calls))
    empty = "".join(f"  {{ const uint32_t begin = Ticks(); Nothing{given}; call_alone[{i}] = Ticks() - begin; }}\n"
                    for i, (_, _, given, _) in enumerate(calls))
    main = "#include \"sample.hpp\"\n" + HARNESS % {"stubs": stubs_of(header), "count": len(calls), "bits": ", ".join(map(str, bits)),
                                                   "scans": SCANS, "calls": text, "empty_calls": empty}
    printed = emulated.execute(board, out, main, ["libsample.a"], ["-I", "."])
    if printed is None:
        print(f"skipped: no compiler or emulator for {board}")
        sys.exit(77)
    counts = [int(number) for number in re.findall(r"\d+", printed)]
    if len(counts) != len(calls):
        sys.exit(f"FAILED: {dialect} on {board}: {printed}")
    return [(dialect, board, name, part["instructions"], count, part["not_counted"]) for (name, _, _, part), count in zip(calls, counts)]


def main():
    plcxx = str(pathlib.Path(sys.argv[1]).resolve())
    failed = False
    with tempfile.TemporaryDirectory() as base:
        for board in TARGETS:
            for dialect in SAMPLES:
                for _, _, part, bound, worst, not_counted in compare(plcxx, dialect, board, pathlib.Path(base)):
                    exceeds = worst - INEXACT[board] > bound
                    failed = failed or exceeds
                    print(f"{'FAILED' if exceeds else 'ok'}: {dialect} {board} {part}: longest path {bound}, worst in QEMU {worst}, "
                          f"ratio {bound / max(1, worst):.2f}{' not counted: ' + ', '.join(not_counted) if exceeds else ''}", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
