"""dev/mutants: see --help."""
import argparse
import concurrent.futures
import pathlib
import random
import re
import sys
import threading
import time

import judge
import prepare
import tests_seen

HERE = pathlib.Path(__file__).resolve().parent
RESULTS = prepare.PLACE / "results"
SURVIVORS = HERE / "survivors.txt"
OPEN = HERE / "open.txt"

DESCRIPTION = """\
Are the tests able to see a fault? Changes the lowerings, the passes, the emitter and the runtime in thousands of places,
one change at a time, and runs the tests that execute the changed place, until one fails (killed) or all have passed
(survived): a part of the scenarios, the unit tests, and for the runtime generated code that has the mutated headers. With
--thorough what survives that is run against all other scenarios that execute the place, the long tests, compiled programs (emit)
and random programs: those of hnc beside avr-gcc, those of the other dialects beside their second readings. That takes up to five
minutes a survivor, and has killed none of 32. A table at the end says what each of these killed and took.

All mutants are compiled into one binary, build/mutants/source/build/bin/plcxx; the environment variable PLCXX_MUTANT=ID chooses
one. Verdicts are kept in build/mutants/results, and a later run goes on from there; --again forgets them.
"""
EPILOG = """\
A survivor is a missing test, dead code, or a change without an effect. The last are in tests/mutants/survivors.txt, a key
a line (file | function | kind | text; ** stands for anything), its reason below it, indented.

  dev/mutants --folder nc110                 every mutant of nc110's lowering
  dev/mutants --sample 200 --seed 7          200 of each folder
  dev/mutants --folder emit --file chunks    those of cut_chunks.cc
  dev/mutants --folder hnc --open            those that open.txt has: do the tests kill them by now?
  dev/mutants --one 4711                     one, with what each test says
  dev/mutants --list survived                keys, files and lines of what survived; also: 'not reached', killed
"""


def read_survivors(path=SURVIVORS):
    """Key (a pattern) -> reason."""
    reasons, key = {}, None
    for line in path.read_text().split("\n") if path.exists() else []:
        if not line.strip() or line.startswith("#"):
            continue
        if line[0] != " ":
            key = line.strip()
            reasons[key] = ""
        elif key:
            reasons[key] += " " * bool(reasons[key]) + line.strip()
    return reasons


def pattern_of(key):
    """** stands for anything; nothing else does, for texts of C++ are full of *, ? and []."""
    return re.compile(".*".join(re.escape(part) for part in key.split("**")))


class Known:
    """What survivors.txt says of mutants without an effect."""

    def __init__(self, reasons):
        self.reasons = reasons
        self.patterns = [(pattern_of(key), reason) for key, reason in reasons.items() if "**" in key]
        self.used = set()

    def reason(self, key):
        if key in self.reasons:
            self.used.add(key)
            return self.reasons[key]
        for pattern, reason in self.patterns:
            if pattern.fullmatch(key):
                return reason
        return None


def read_results():
    results = {}
    if RESULTS.exists():
        for line in RESULTS.read_text().split("\n"):
            if line:
                key, verdict, killer = line.split("\t")
                results[key] = (verdict, killer)
    return results


def choose(mutants, folders, sample, seed, files=()):
    chosen = []
    for folder in folders:
        of_folder = [mutant for mutant in mutants
                     if mutant.folder == folder and (not files or any(part in mutant.file for part in files))]
        if sample and sample < len(of_folder):
            of_folder = sorted(random.Random(seed).sample(of_folder, sample), key=lambda mutant: mutant.id)
        chosen += of_folder
    return chosen


def table(mutants, results, known):
    rows = [("folder", "made", "looked at", "killed", "no effect", "survived", "not reached", "killed %")]
    total = [0] * 6
    for folder in prepare.FOLDERS:
        made = [mutant for mutant in mutants if mutant.folder == folder]
        if not made:
            continue
        verdicts = [(mutant, results[mutant.key][0]) for mutant in made if mutant.key in results]
        killed = sum(verdict == "killed" for _, verdict in verdicts)
        others = [(mutant, verdict) for mutant, verdict in verdicts if verdict != "killed"]
        without = sum(known.reason(mutant.key) is not None for mutant, _ in others)
        missed, survived = (sum(verdict == wanted and known.reason(mutant.key) is None for mutant, verdict in others)
                            for wanted in ("not reached", "survived"))
        row = [len(made), len(verdicts), killed, without, survived, missed]
        total = [a + b for a, b in zip(total, row)]
        rows.append((folder, *row, rate(row)))
    rows.append(("all", *total, rate(total)))
    return aligned(rows)


def ways_table(ways):
    """What each way of looking has killed, and what it took."""
    return aligned([("", "mutants", "killed", "s of the processor"),
                    *((name, asked, killed, f"{seconds:.0f}") for name, (asked, killed, seconds) in ways.items())])


def aligned(rows):
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(rows[0]))]
    return "\n".join("  ".join(str(cell).ljust(width) if not i else str(cell).rjust(width)
                               for i, (cell, width) in enumerate(zip(row, widths))) for row in rows)


def rate(row):
    """Of the mutants that have an effect; what no test reaches is not killed."""
    counted = row[1] - row[3]
    return f"{100 * row[2] / counted:.1f}" if counted else "-"


def run_all(todo, judged, jobs):
    lock = threading.Lock()
    started, counts, done = time.monotonic(), {}, 0

    def work(mutant):
        nonlocal done
        verdict, killer = judged.judge(mutant)
        with lock:
            done += 1
            counts[verdict] = counts.get(verdict, 0) + 1
            with open(RESULTS, "a", encoding="utf-8") as file:
                file.write(f"{mutant.key}\t{verdict}\t{killer.replace(chr(9), ' ')}\n")
            if done % 100 == 0:
                print(f"{done} of {len(todo)}, {time.monotonic() - started:.0f} s: {counts}", flush=True)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        list(pool.map(work, todo))


def show_one(mutant, judged):
    print(f"{mutant.id}: {mutant.file}:{mutant.line}\n{mutant.key}")
    seen = judged.seen
    print(f"reached by {len(seen.by_scenario.get(mutant.id, ()))} scenarios in the simulator, "
          f"{len(seen.by_emit.get(mutant.id, ()))} as compiled, {len(seen.by_unit.get(mutant.id, ()))} other tests")
    for number in list(seen.by_scenario.get(mutant.id, ()))[:10]:
        print(f"  {seen.scenarios[number].name}")
    for number in list(seen.by_unit.get(mutant.id, ()))[:10]:
        print(f"  {seen.units[number].name}")
    print(": ".join(judged.judge(mutant)))


def show_list(mutants, results, known, verdict):
    for mutant in mutants:
        if results.get(mutant.key, ("",))[0] == verdict and (verdict == "killed" or known.reason(mutant.key) is None):
            print(f"{mutant.id}\t{mutant.line}\t{mutant.key}\t{results[mutant.key][1]}")


def main():
    parser = argparse.ArgumentParser(prog="dev/mutants", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", action="append", choices=list(prepare.FOLDERS), help="only these are changed and looked at; may be repeated")
    parser.add_argument("--file", action="append", metavar="PART", help="only those of files with this in their path; may be repeated")
    parser.add_argument("--sample", type=int, default=0, metavar="N", help="N mutants of each folder, chosen by the seed")
    parser.add_argument("--seed", type=int, default=1, help="of the sample (1)")
    parser.add_argument("--jobs", type=int, default=2, help="mutants that are tested at a time (2)")
    parser.add_argument("--most", type=int, default=judge.MOST, metavar="N",
                        help="scenarios for a mutant in the first stage (%(default)d); the second has all of them")
    parser.add_argument("--thorough", action="store_true", help="the second stage, too")
    parser.add_argument("--open", action="store_true", help="those of open.txt, which tests may kill by now")
    parser.add_argument("--one", metavar="ID", help="one mutant: its number or its key")
    parser.add_argument("--list", metavar="VERDICT", help="of the last runs: survived, 'not reached' or killed")
    parser.add_argument("--again", action="store_true", help="forget the verdicts of earlier runs")
    parser.add_argument("--again-survivors", action="store_true", help="forget those of survivors: tests were added")
    parser.add_argument("--no-build", action="store_true", help="the binaries are what they were")
    parser.add_argument("--mutate", default=str(prepare.ROOT / "build/tests/plcxx_mutate"), help=argparse.SUPPRESS)
    wanted = parser.parse_args()
    folders = wanted.folder or list(prepare.FOLDERS)
    if not wanted.no_build and not wanted.list:
        prepare.make_sources(wanted.mutate, folders)
        prepare.build(wanted.jobs, folders)
    mutants = prepare.read_table()
    known = Known(read_survivors())
    if wanted.again:
        RESULTS.unlink(missing_ok=True)
    results = read_results()
    if wanted.list:
        show_list([mutant for mutant in mutants if mutant.folder in folders], results, known, wanted.list)
        return 0
    if wanted.again_survivors:
        results = {key: value for key, value in results.items() if value[0] == "killed"}
        RESULTS.write_text("".join(f"{key}\t{verdict}\t{killer}\n" for key, (verdict, killer) in results.items()))
    judged = judge.Judge(tests_seen.record_all(wanted.jobs, folders), wanted.seed, wanted.most, not wanted.thorough)
    if wanted.one:
        found = [mutant for mutant in mutants if wanted.one in (str(mutant.id), mutant.key)]
        if not found:
            print(f"there is no mutant '{wanted.one}'", file=sys.stderr)
            return 2
        show_one(found[0], judged)
        return 0
    chosen = choose(mutants, folders, wanted.sample, wanted.seed, wanted.file or ())
    if wanted.open:
        waiting = set(OPEN.read_text().splitlines())
        chosen = [mutant for mutant in chosen if mutant.key in waiting]
    todo = [mutant for mutant in chosen if mutant.key not in results]
    random.Random(wanted.seed).shuffle(todo)  # progress says something of all folders
    run_all(todo, judged, wanted.jobs)
    results = read_results()
    print(table(mutants, results, known))
    if todo:
        print(ways_table(judged.ways))
    unexplained = [mutant for mutant in chosen
                   if results[mutant.key][0] == "survived" and known.reason(mutant.key) is None]
    print(f"{len(unexplained)} survivors are not in {SURVIVORS.name}: dev/mutants --list survived")
    return 0


if __name__ == "__main__":
    sys.exit(main())
