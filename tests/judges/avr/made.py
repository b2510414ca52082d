#!/usr/bin/env python3
"""What the generator of C programs makes: each operator with each type, conversions, statements within statements, the
functions and words of the control, options with their values, steps.

made.py PLCXX [--programs N] [--all]

A construct that no random program has is one that none tests. What there is follows from the specification (2.4, 3, 5, 6, 9,
10.5); what a program has, from `plcxx print syntax`, and of what is no syntax from its text. What is never made fails, or has
its reason in never_made.txt.
"""
import argparse
import collections
import itertools
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True  # the source tree stays clean
import children  # noqa: E402
import syntax  # noqa: E402
from generate import generate  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
TYPES = ("signed char", "unsigned char", "int", "unsigned int", "long", "unsigned long")  # char and short are two of them
REAL = ("float", "double")
PROMOTED = ("int", "unsigned int", "long", "unsigned long")
COMPARISONS = ("<", ">", "<=", ">=", "==", "!=")
BITS = ("%", "&", "|", "^")
LOOPS = ("while", "do while", "for")
FUNCTIONS = ("abs labs _rotl _rotr _lrotl _lrotr memset memcpy memmove memcmp fabs floor ceil sqrt set_axis_home set_axis_jog set_axis_step "
             "set_axis_move set_axis_moveto set_axis_stop get_axis_pos get_axis_den handwheel get_handwheel set_mst_func").split()
WORDS = ("max min disable enable asm axis_stat axis_pout axis_pact axis_speed axis_current axis_vmax ch_user_out ch_stat ch_mst_stb ch_M_code "
         "ch_T_code ch_B_code ch_S_code ch_var sys_stat sys_iip_time sys_pm1um sys_pr1md sys_var1 axis_ctrl axis_pic_a axis_pic_v axis_pvcmd "
         "axis_pecmd ch_user_in ch_ctrl ch_mst_ack ch_feedover ch_rapidover ch_cut_inuse ch_spdl_speed ch_skip_sw ch_mst_mod sys_ctrl sys_ext_alm "
         "sys_var2 tot_mag_pos cutter_in_mag mod_M_code mod_S_code mod_T_code mod_B_code mod_mst_busy msthold_dis mod_m00_m01 "
         "auto const enum extern register short signed sizeof static struct typedef union unsigned void volatile near far huge cdecl pascal "
         "#define #undef #if #ifdef #ifndef #elif #else #endif #include #line #pragma ## /* // loop_bound").split()
OPTIONS = ("char=unsigned", "abs=long", "x-mirror=0", "handler-calls=once", "m00-flags=off", "stop=printed", "faults=stop", "base-cycle=2",
           "loop-warn=10", "sysfunc=host", "system-header=own.h")
STEPS = ("set X", "set F", "set P", "set R", "set HW", "set MODAL", "run ms", "run fast", "run slow", "power_cycle", "force")


def everything():
    """All (group, name)."""
    def rows(group, *parts):
        return [(group, " ".join(words)) for words in itertools.product(*parts)]

    arithmetic = (*PROMOTED, "double")
    made = rows("operator", ("+", "-", "*", "/", *COMPARISONS), arithmetic)
    made += rows("operator", BITS, PROMOTED) + rows("operator", ("<<", ">>"), PROMOTED, ("by",), PROMOTED)
    made += rows("operator", ("+x", "-x"), arithmetic) + rows("operator", ("~x",), PROMOTED) + rows("operator", ("!x",), (*PROMOTED, "double", "pointer"))
    made += rows("operator", ("p+", "p-", "p-p", "==", "!=", "<", ">", "<=", ">="), ("pointer",))
    # Promotions and casts of numbers are conversions, too.
    made += [("conversion", f"{a} to {b}") for a, b in itertools.product(TYPES + REAL, repeat=2)
             if a != b and (a in (*PROMOTED, "double") or b in (*PROMOTED, "double") or "float" in (a, b))]
    made += [("cast", "pointer to pointer")]
    made += rows("compound", ("+=", "-=", "*=", "/="), TYPES + REAL) + rows("compound", ("%=", "&=", "|=", "^=", "<<=", ">>="), TYPES)
    made += rows("computed in", ("+=", "-=", "*=", "/="), arithmetic) + rows("computed in", ("%=", "&=", "|=", "^=", "<<=", ">>="), PROMOTED)
    made += rows("step", syntax.STEPS, (*TYPES, *REAL, "pointer"))
    made += rows("load", (*TYPES, *REAL, "pointer", "struct", "union")) + rows("assign", (*TYPES, *REAL, "pointer", "struct", "union"))
    made += rows("?:", (*PROMOTED, "double", "pointer", "struct", "void")) + rows("comma", (*PROMOTED, *REAL, "struct"))
    made += rows("tested by", ("if", "while", "do while", "&&", "||", "?:"), (*PROMOTED, "double", "pointer"))
    made += rows("tested by", ("switch",), PROMOTED)
    made += rows("place", ("[] of array", "[] of pointer", "* of a pointer", "bit-field")) + rows("place", ("member",), (*TYPES, *REAL, "array", "struct", "union"))
    made += rows("address", (*TYPES, *REAL, "struct", "array")) + rows("index", PROMOTED) + [("leaf", "string"), ("leaf", "null")]
    made += rows("member", (*TYPES, *REAL, "array", "struct", "union")) + rows("member", ("field of",), ("int", "unsigned int", "unsigned char", "signed char"))
    for storage in ("global", "static local", "automatic"):
        made += rows("variable", (storage,), (*TYPES, *REAL, "pointer", "array", "struct", "union"))
    made += rows("parameter", (*TYPES, *REAL, "pointer", "struct", "union")) + rows("parameter", TYPES, ("without prototype",))
    made += rows("parameters", "01234") + rows("result", (*TYPES, *REAL, "void", "pointer", "struct", "union")) + rows("depth", "0123456")
    made += rows("initial value", (*TYPES, *REAL, "array", "pointer"))
    made += rows("statement", ("if", "switch", *LOOPS, "return", "case", "default", "label", "goto", "continue", "break", "empty", "cli", "sti",
                               "expression", "for with all", "for without start", "for without test", "for without step", "for without start, test, step"))
    made += rows("statement in", ("if", "switch", *LOOPS), ("in",), ("if", "else", "switch", *LOOPS))
    made += rows("statement in", ("return", "goto", "continue", "break"), ("in",), ("switch", *LOOPS))
    made += [("call", name) for name in ("own", *FUNCTIONS)] + [("word", name) for name in WORDS]
    made += [("view", f"{area}{view}") for area in "XYRPBFG" for view in ("", "_uc", "_c", "_ui", "_i", "_ul", "_l")]
    return made + [("option", name) for name in OPTIONS] + [("step", name) for name in STEPS]


def count_text(program, counts):
    text = "\n".join(program.files.values())
    for word in set(re.findall(r"#\w+|\w+|##|/\*|//", text)):
        counts["word", word] += 1
        if re.fullmatch(r"[XYRPBFG](_(uc|c|ui|i|ul|l))?", word):
            counts["view", word] += 1
    for name, value in program.options.items():
        counts["option", f"{name}={value}"] += 1
    for step in program.steps:
        for location in step.locations:
            counts["step", "set " + re.match(r"[A-Z]*", location)[0]] += 1
        counts["step", "run " + step.unit] += 1
        counts["step", "power_cycle"] += step.power_cycle
        counts["step", "force"] += bool(step.forced)


def count(plcxx, seeds):
    counts = collections.Counter()
    with tempfile.TemporaryDirectory(prefix="plcxx_made_") as folder:
        for seed in seeds:
            program = generate(seed)
            program.write_sources(pathlib.Path(folder))
            options = [word for name, value in program.options.items() for word in ("--set", f"{name}={value}")]
            result = children.run([plcxx, "print", "syntax", *options, pathlib.Path(folder) / next(iter(program.files))], 300)
            if result.returncode != 0:
                raise SystemExit(f"seed {seed}: {result.stderr[:2000]}")
            syntax.Reader(counts).read(result.stdout)
            count_text(program, counts)
    return counts


def never():
    rows = (row.partition(" -- ") for row in (HERE / "never_made.txt").read_text().splitlines() if row and not row.startswith("#"))
    return {name: reason for name, _, reason in rows}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plcxx", type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=300)
    parser.add_argument("--all", action="store_true", help="print what is made, too")
    arguments = parser.parse_args()
    counts, reasons, failed = count(arguments.plcxx, range(arguments.programs)), never(), 0
    for row in everything():
        excepted = reasons.get(" ".join(row))
        wrong = (counts[row] != 0) == (excepted is not None)
        failed += wrong
        if arguments.all or wrong:
            print(f"{row[0]:13} {row[1]:36} {counts[row]:8}" + ("" if not wrong else "  is made, against never_made.txt" if excepted else "  NEVER MADE"))
    print(f"{len(everything())} forms, {failed} of them wrong")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
