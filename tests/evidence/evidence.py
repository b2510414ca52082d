#!/usr/bin/env python3
"""Makes docs/evidence.md: what plcxx promises, which check keeps each promise, and the figures of these checks.

    dev/evidence                     counts scenarios and rules of the present commit, writes the page anew
    dev/evidence --record NAME FILE  takes the figures of a run (the text that it printed) into the record, then writes
    dev/evidence --check             fails when the page is not what the record and the sources give

The record is docs/evidence.json: for each run the commit that was measured, its command and its closing lines. Figures
of long runs are only as old as their commit says; a figure is never changed by hand.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, RECORD = ROOT / "docs/evidence.md", ROOT / "docs/evidence.json"

# (promise, kept by, path that must be there, record or none)
PROMISES = [
    ("nc110 and host50 compute what their specifications say", "a second reading of each, written from the "
     "specification alone, runs in lockstep over all scenarios and over random programs", "tests/reference", "soak"),
    ("prostep and technol compute what their specifications say", "second readings, likewise", "tests/reference",
     "soak"),
    ("hnc computes what C with a 16-bit int says", "avr-gcc and libsimavr judge random programs and the whole matrix of "
     "loops", "tests/judges/avr", "avr"),
    ("classicladder computes what LinuxCNC's own engine computes", "the engine of LinuxCNC 2.9 runs random projects beside "
     "the simulator, scan by scan", "tests/judges/classicladder", "classicladder"),
    ("a program in LinuxCNC's real-time thread does what its scenarios say", "LinuxCNC plays the lathe's scenarios period by period, "
     "and changes five tools with it", "tests/host/linuxcnc.py", "linuxcnc"),
    ("every loop of hnc that is accepted ends, with the right value of its counter", "the matrix of types, relations, "
     "steps and limits against exact arithmetic", "tests/differential/loops", None),
    ("what is decided from ranges and bounds is so, in every language", "each decision states its fact; all scenarios "
     "execute them as assertions (`plcxx test --checked`), and a false one of each kind is found", "transpiler/ir/facts.h",
     None),
    ("of one program, what is decided from ranges and bounds is so for every state", "`plcxx verify` proves each fact or "
     "lists it", "transpiler/prove/verify/facts", None),
    ("the compiled code of one program does what the program means, for every state and every input, on each target",
     "`plcxx verify` proves each function or says why not; changed code and changed instructions are not proved",
     "tests/verify/table.py", "verify"),
    ("the simulator and the generated C++ are one meaning", "each scenario runs in both in lockstep, a part of them on "
     "emulated Cortex-M and RISC-V", "tests/golden", None),
    ("each effect of a program is in its C++ exactly once", "a record that the printer follows, and a check after "
     "printing: otherwise nothing is written", "transpiler/emit/print/spelled_once.cc", None),
    ("generated code is bounded, without heap, recursion or undefined behaviour", "`plcxx build` audits the object; "
     "scenarios run under the sanitizers in the preset `asan`", "transpiler/compile/audit", None),
    ("no type of the tool is two types", "a rule over all sources with a failing fixture", "tests/policy/namespaces.cc",
     None),
    ("each rule of a specification's checklist has a test", "`covers:` of tests against the checklists",
     "tests/policy/coverage.cc", None),
    ("each message has a page whose programs do what it says", "the programs of the pages are compiled",
     "tests/policy/explain.cc", None),
    ("code in a remedy compiles", "the code of the help texts is taken out and compiled (nc110, host50)",
     "tests/fuzz/cases", None),
    ("nothing grows with the square of a program", "every kind of statement, so many lines and ten times as many",
     "tests/fuzz/cases/growth.py", "growth"),
    ("broken and hostile input gives a message, never a crash, a hang or a leak", "a fuzzer of whole cases over all "
     "subcommands", "tests/fuzz/cases/run.py", "cases"),
    ("each subcommand takes each program", "every form of every subcommand over goldens and samples",
     "tests/fuzz/cases/everything.py", "everything"),
    ("the tool reads and writes only what is its own, does nothing undefined, and leaks nothing", "the tool with the "
     "sanitizers of Clang, in every form of every subcommand over goldens and samples, and over mutated cases",
     "dev/sanitize", "sanitize"),
    ("what `plcxx diff` calls equal is equal, and what it calls different was seen", "random pairs of programs, mutated or "
     "written in another way; equal ones are attacked with runs, counterexamples replayed (`build/tests/plcxx_pairs`)",
     "tests/pairs", "pairs"),
    ("each option of each dialect changes something", "a row with a program for each option", "tests/options", None),
    ("the tests see a fault in the lowerings, passes, emitter and runtime", "mutants: one change at a time, and the tests that "
     "execute it (`dev/mutants`); survivors are listed with reasons", "tests/mutants", "mutants"),
    ("the whole suite", "`./dev/test`", "dev/test", "suite"),
]

NOT_PROMISED = [
    "That a specification reads its control's manual rightly: a second reading shares the specification with the first.",
    "The timing of a real machine: periods are simulated, and costs are estimates until `plcxx build` measures a target.",
    "f64 of hnc against another machine: avr-gcc has none; it is compared with the host's compiler only.",
    "That a decision of the front end which states no fact is right: facts are of ranges, bounds and known constants, "
    "not of the reading of a language.",
    "Targets that no emulator here runs, and compilers other than GCC and Clang.",
]


def commit():
    return subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], cwd=ROOT, check=True, capture_output=True,
                          text=True).stdout.strip()


def count(pattern, *folders):
    return sum(path.name != "plcxx.yaml" for folder in folders for path in (ROOT / folder).rglob(pattern))


def counted():
    """For each language its scenarios, and the rules of its checklist."""
    rows = []
    for dialect in ("nc110", "technol", "host50", "prostep", "hnc", "classicladder"):
        ids = [line for line in (ROOT / f"tests/policy/checklist_{dialect}.txt").read_text().splitlines()
               if re.match(r"[A-Z0-9]+-\w+", line)]
        rows.append([dialect, count("*.yaml", f"tests/golden/{dialect}", f"samples/{dialect}"), len(ids)])
    return rows


def page(records):
    lines = ["# Evidence", "", "What plcxx promises, the check that keeps each promise, and what was measured. Made by "
             "`dev/evidence`; long", "runs are recorded with the commit that they looked at.", "",
             "| promise | kept by | where | last run |", "|---|---|---|---|"]
    for promise, kept, where, record in PROMISES:
        if not (ROOT / where).exists():
            raise SystemExit(f"evidence: '{where}' is not there: the promise '{promise}' has no check")
        run = f"[{record}](#{record})" if record in records else "each `dev/test`"
        lines.append(f"| {promise} | {kept} | `{where}` | {run} |")
    sources = records.pop("sources")
    lines += ["", "## In the sources", "", f"At {sources['commit']}:", "", "| language | scenarios | rules of the checklist, each named by a test |",
              "|---|---|---|"]
    lines += [f"| {name} | {scenarios} | {rules} |" for name, scenarios, rules in sources["figures"]]
    for name, record in sorted(records.items()):
        lines += ["", f"## {name}", "", f"`{record['command']}` at {record['commit']}:", "", "```text",
                  *record["figures"], "```"]
    lines += ["", "## Not promised", "", *[f"- {text}" for text in NOT_PROMISED]]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--record", nargs=2, metavar=("NAME", "FILE"))
    parser.add_argument("--command", help="of the recorded run")
    parser.add_argument("--commit", help="that the recorded run looked at, when it is not the present one")
    parser.add_argument("--check", action="store_true")
    asked = parser.parse_args()
    records = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    if asked.record:
        name, file = asked.record
        known = {record for *_, record in PROMISES if record}
        if name not in known:
            raise SystemExit(f"evidence: no promise names the run '{name}'; there are {', '.join(sorted(known))}")
        if not asked.command:
            raise SystemExit("evidence: --command says how to run it again")
        text = pathlib.Path(file).read_text().rstrip().splitlines()
        records[name] = {"command": asked.command, "commit": asked.commit or commit(), "figures": text}
    if not asked.check:
        records["sources"] = {"commit": commit(), "figures": counted()}
        RECORD.write_text(json.dumps(records, indent=1, ensure_ascii=False, sort_keys=True) + "\n")
    text = page(records)
    if asked.check:
        if not PAGE.exists() or PAGE.read_text() != text:
            sys.exit("docs/evidence.md is not what the sources and docs/evidence.json give: run dev/evidence")
        return
    PAGE.write_text(text)


if __name__ == "__main__":
    main()
