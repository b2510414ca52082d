#!/usr/bin/env python3
"""Nothing grows with the square of a program: every kind of statement, 4,000 and 40,000 of them.

    growth.py PLCXX [--kinds DIALECT[.KIND]] [--most EXPONENT]

The time is that of the processor, without the start of the tool; the best of three, as other work only adds to it.
"""
import argparse
import math
import os
import pathlib
import subprocess
import sys
import tempfile

FEW, MANY = 4000, 40000
NOISE_SECONDS = 0.02  # what a run of the small program may be off by



def nc110(text):
    return lambda n: "".join(text.format(a=i % 20, b=i % 32, c=i % 4, k=i % 200) + "\n" for i in range(n)) + "$\n"


def hnc(text):
    head = '#include "plc.h"\nint i;\nvoid init(void) { plc1_time = 8; plc2_time = 16; }\n'
    return lambda n: (head + "void plc2(void) {}\nvoid plc1(void) {\n" +
                      "".join(text.replace("@", str(i % 200)) + "\n" for i in range(n)) + "}\n")


def prostep(text):
    return lambda n: (":MOD PM 1\n" + "".join(text.format(a=i % 64, b=i % 8, c=i % 200) for i in range(n)) + ":END PM 1\n")


def host50(text):
    return lambda n: ("SLOW\nNETWORK\n" + "".join(text.format(b=i % 2000, w=i % 300, t=i % 100) for i in range(n)) +
                      "END_SLOW\n")


KINDS = {
    "nc110": (".plc", {
        "assignment": nc110("U{a}A{b}=I{a}A{b}*I1A1"),
        "word": nc110("W{a}A{c}=[W{a}A{c}+1]"),
        "comparator": nc110("U{a}A{b}=[W{a}A{c}<W1K0]"),
        "block": nc110("DOF:I{a}A{b}\nU{a}K{b}=I0A0\nENDF"),
        "chain": nc110("DOF:I{a}A{b}\nU{a}K{b}=I0A0\nENDF\nDOE:I0A1\nU{a}K{b}=0\nENDE"),
        "timer": nc110("T{k}I(5)=I{a}A{b}"),
        "mux": nc110("W{a}K{c}=MUX(W1K0,W1K1),(I0A0,I0A1)"),
        "comment": nc110("; text {k}\nU{a}A{b}=I{a}A{b}"),
        "error": nc110("U{a}A{b}=NOSUCH{k}"),
        "unclosed": nc110("U{a}A{b}=(I0A0"),
    }),
    "host50": (".il", {
        "rung": host50("LD %I1\nAND %B{b}\nOUT %B{b}\n"),
        "word": host50("LD %I1\nMOV %W{w}, %W1\n"),
        "operation": host50("LD %I1\nOPRT %W{w} = %W1 + 1\n"),
        "error": host50("LD %I1\nNOSUCH %W{w}\n"),
    }),
    "prostep": (".plc", {
        "bit": prostep(":A I {a}.{b}\n:= O {a}.{b}\n"),
        "error": prostep(":NOSUCH I {a}.{b}\n"),
    }),
    "hnc": (".cld", {
        "assignment": hnc("Y[@] = X[@];"),
        "if": hnc("if (X[@] & 1) Y[@] = 1; else Y[@] = 2;"),
        "loop": hnc("for (i = 0; i < 3; i++) Y[i] = X[@];"),
        "error": hnc("nosuch@ = 1;"),
    }),
}


def seconds(plcxx, words):
    best = math.inf
    for _ in range(3):
        process = subprocess.Popen([plcxx, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode not in (0, 1, 2):
            return math.inf
        best = min(best, usage.ru_utime + usage.ru_stime)
    return best


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("plcxx")
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--most", type=float, default=1.1)
    args = parser.parse_args()
    wanted = args.kinds.split(",")
    faults = 0
    start = seconds(args.plcxx, ["--version"])
    with tempfile.TemporaryDirectory(prefix="plcxx_growth_") as scratch:
        for dialect, (suffix, kinds) in KINDS.items():
            for kind, program in kinds.items():
                if dialect not in wanted and f"{dialect}.{kind}" not in wanted:
                    continue
                times = []
                for count in (FEW, MANY):
                    path = pathlib.Path(scratch) / f"p{count}{suffix}"
                    path.write_text(program(count))
                    times.append(seconds(args.plcxx, ["check", str(path), "--dialect", dialect]))
                few, many = (max(time - start, 0.001) for time in times)
                exponent = math.log(many / (few + NOISE_SECONDS), MANY / FEW) if many < math.inf else math.inf
                wrong = exponent > args.most
                faults += wrong
                print(f"{dialect}.{kind}: {few:.3f} s, {many:.3f} s, exponent {exponent:.2f}{'  TOO MUCH' if wrong else ''}",
                      flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
