"""Random programs through both: 25 in an ELF, and all scenarios of a batch in one call of plcxx."""
import pathlib
import time

import avr
from generate import generate
from program import messages, run_on_avr, test

PROGRAMS_AN_ELF = 25
SECONDS_BETWEEN_LINES = 60
LEVELS = ("-O0", "-O1", "-O0", "-Os")  # compiling is most of the time


class Tally:
    def __init__(self):
        self.programs = self.values = self.failed = 0


def judge(plcxx, runner, directory, seeds, engine, jobs, keep, report, further):
    """The number of programs that failed. `keep`: leave the files of passed batches, too."""
    tally = Tally()
    begun = said = time.monotonic()
    try:
        for start in range(0, len(seeds), PROGRAMS_AN_ELF):
            if further.time_is_over():
                break
            batch(plcxx, runner, directory, seeds[start:start + PROGRAMS_AN_ELF], start // PROGRAMS_AN_ELF, engine, jobs, keep, report,
                  further, tally)
            if time.monotonic() - said >= SECONDS_BETWEEN_LINES:
                said = time.monotonic()
                report(f"{(said - begun) / 60:.0f} min: {tally.programs} programs, {tally.failed} failed")
    except KeyboardInterrupt:
        report("stopped before its end")
    report(f"{tally.programs} programs, {tally.values} values, {tally.failed} programs failed")
    further.row(tally.programs, tally.values, tally.failed, report)
    return tally.failed


def batch(plcxx, runner, directory, seeds, number, engine, jobs, keep, report, further, tally):
    programs = [generate(seed) for seed in seeds]
    values = judged(programs, directory, f"elf{seeds[0]}", runner, LEVELS[number % len(LEVELS)])
    paths = [p.write(directory, v) for p, v in zip(programs, values)]
    failed, output = test(plcxx, paths, engine, jobs)
    for path in failed:
        report(f"FAILED {path}")
        for code, line, text in messages(plcxx, path.replace(".yaml", ".cld"))[:3]:
            report(f"  {path.replace('.yaml', '.cld')}:{line}: {code} {text}")
    told = [row for row in output.splitlines() if ": expected " in row or "): " in row or row.startswith("plcxx:")]
    for row in told[:40]:
        report("  " + row)
    passed = [path for path in paths if path not in map(pathlib.Path, failed)]
    failed += further.judge(number, passed, report)
    tally.programs += len(programs)
    tally.values += sum(len(step) for v in values for step in v)
    tally.failed += len(failed)
    if not keep:
        tidy(directory, programs, failed, f"elf{seeds[0]}")


def judged(programs, directory, name, runner, level):
    """avr-gcc 5 finds no registers for some functions, and some batches are larger than its memory: then without
    optimisation, then in halves."""
    try:
        return run_on_avr(programs, directory, name, runner, level)
    except avr.NotRun:
        if level != "-O0":
            return judged(programs, directory, name, runner, "-O0")
        if len(programs) == 1:
            raise
        half = len(programs) // 2
        return judged(programs[:half], directory, name, runner, "-O1") + judged(programs[half:], directory, name, runner, "-O1")


def tidy(directory, programs, failed, name):
    for program in programs:
        if str(directory / f"{program.name}.yaml") not in failed:
            for file in (*program.files, f"{program.name}.yaml"):
                (directory / file).unlink()
    (directory / f"{name}.elf").unlink(missing_ok=True)
    if not failed:
        (directory / f"{name}.c").unlink()
