#!/usr/bin/env python3
"""A new mnemonic that becomes an operation which is there costs two files, beside grammar, checklist and test.

new_mnemonic.py COMPILER WORK            a mnemonic for each dialect, put into a copy of the project: which files change;
                                         what changed is read by the compiler
new_mnemonic.py COMPILER WORK --build    the copy is built, and a golden case of an older mnemonic with the same meaning
                                         passes when it is written with the new one
"""
import pathlib
import re
import subprocess
import sys

from copied_tree import build_copy, check_sources, copy_to

# Dialect: lines as (file, the line that they come after, lines); golden case, the old word and the new one in it.
MNEMONICS = {
    "nc110": (
        [("transpiler/dialects/nc110/machine/functions.def", 'PLCXX_WORD_FUNCTION(Xch, ',
          ['PLCXX_WORD_FUNCTION(Swp, "SWP", SwapNibbles8, 255)']),
         ("transpiler/diagnostics/catalogue_nc110.def", "PLCXX_DIAG(Nc110XchClose, ",
          ['PLCXX_DIAG(Nc110SwpAsSignal, "nc110-30", kError, (), "SWP gives a word, but a signal is needed here", "compare it")',
           'PLCXX_DIAG(Nc110SwpOpen, "nc110-30", kError, (Text), "SWP: \'(\' expected, found {0}", "write SWP(W1K0)")',
           'PLCXX_DIAG(Nc110SwpClose, "nc110-37", kError, (Text), "SWP: \')\' expected, found {0}", "close it")'])],
        "tests/golden/nc110/functions/all_values", r"\bXCH\b", "SWP"),
    "host50": (
        [("transpiler/dialects/host50/machine/machine.def", "HOST50_INSTRUCTION(Wxor, ",
          ['HOST50_INSTRUCTION(Xorw, "XORW", kBlock, kOutput, kNone, kStateless, kFunctionBlocks, "", kIntSource, '
           'kIntSource, kIntResult)']),
         ("transpiler/dialects/host50/lowering/blocks.cc", "    {Op::kWxor, ",
          ["    {Op::kXorw, Type::kInteger, OpKind::kXor32},"]),
         ("transpiler/dialects/host50/lowering/blocks.cc", "    case Op::kWxor:", ["    case Op::kXorw:"])],
        "tests/golden/host50/blocks/wxor", r"\bWXOR\b", "XORW"),
    "prostep": (
        [("transpiler/dialects/prostep/machine/machine.def", "PROSTEP_FUNCTION(XorLong, ",
          ["PROSTEP_FUNCTION(DifferLong, None, 2, Long, Long, LongWritten)"]),
         ("transpiler/dialects/prostep/machine/machine.def", "PROSTEP_FUNCTION_NUMBER(66, ",
          ["PROSTEP_FUNCTION_NUMBER(67, DifferLong)"]),
         ("transpiler/dialects/prostep/lowering/functions.cc", "    case Function::kOrLong:",
          ["    case Function::kDifferLong:"]),
         ("transpiler/dialects/prostep/lowering/functions.cc", "      return long_words_.Combine(instruction, OpKind::kXor32);",
          ["    case Function::kDifferLong:", "      return long_words_.Combine(instruction, OpKind::kXor32);"])],
        "tests/golden/prostep/functional/fm_64_65_66", r"\bFM 66\b", "FM 67"),
    "technol": (
        [("transpiler/dialects/technol/machine/machine.def", "TECHNOL_ASSEMBLER(Not, ",
          ['TECHNOL_ASSEMBLER(Com, "COM", One, ReadWrite, Pure, None, 0, 0, 0)']),
         ("transpiler/dialects/technol/lowering/assembler.cc", "      return arithmetic_.Negate(instruction);",
          ["    case Op::kCom:"])],
        "tests/golden/technol/assembler/not_changes_no_flag", r"\bNOT\b", "COM"),
    "hnc": (
        [("transpiler/dialects/hnc/machine/functions.def", "HNC_FUNCTION(Fabs, ",
          ['HNC_FUNCTION(Dabs, "dabs", "math.h", "double dabs(double);", Real, OpKind::kAbsF64, Nothing)'])],
        "tests/golden/hnc/library/mathematics", r"\bfabs\b", "dabs"),
}


def insert(tree, path, after, lines, faults):
    """After the first line that begins so."""
    old = (tree / path).read_text().split("\n")
    at = next((i for i, line in enumerate(old) if line.startswith(after)), None)
    if at is None:
        faults.append(f"{path}: no line begins with '{after}'")
        return
    (tree / path).write_text("\n".join(old[:at + 1] + lines + old[at + 1:]))


def main():
    compiler, work = sys.argv[1:3]
    tree = copy_to(pathlib.Path(work))
    faults = []
    for dialect, (changes, case, old, new) in MNEMONICS.items():
        changed = []
        for path, after, lines in changes:
            insert(tree, path, after, lines, faults)
            if path not in changed:
                changed.append(path)
        if len(changed) > 2:
            faults.append(f"{dialect}: a mnemonic changes {len(changed)} files: {' '.join(changed)}")
        print(f"{dialect}: {', '.join(changed)}")
        program = min((path for path in tree.glob(f"{case}.*") if path.suffix in (".plc", ".il", ".cld", ".yaml")),
                      key=lambda path: path.suffix == ".yaml")  # a scenario may hold its program
        text = program.read_text(encoding="latin-1")
        if not re.search(old, text):
            faults.append(f"{program.name} does not use {old}")
        program.write_text(re.sub(old, new, text), encoding="latin-1")
        folder = f"transpiler/dialects/{dialect}"
        tables = [path for path in changed if path.startswith(folder) and path.endswith(".def")]
        users = [path.relative_to(tree).as_posix() for path in (tree / folder).glob("*.cc")
                 if any(table in path.read_text() for table in tables)]
        said = "" if faults else check_sources(compiler, tree, users + [path for path in changed if path.endswith(".cc")
                                                                       and path not in users])
        if said:
            faults.append(f"{dialect}: {said}")
    if not faults and "--build" in sys.argv:
        said = build_copy(compiler, tree, "plcxx")
        if said:
            faults.append(said)
        for _, case, _, _ in MNEMONICS.values() if not said else ():
            done = subprocess.run(["build/bin/plcxx", "test", f"{case}.yaml"], cwd=tree, capture_output=True, text=True)
            if done.returncode != 0:
                faults.append(f"{case}: {done.stdout}{done.stderr}")
    print("\n".join(faults) if faults else "two files each")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
