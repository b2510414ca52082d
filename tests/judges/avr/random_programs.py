"""Random programs through both: 25 in an ELF, and all scenarios of a batch in one call of plcxx."""
import pathlib
import time

import avr
from generate import generate
from program import messages, run_on_avr, test

PROGRAMS_AN_ELF = 25
SECONDS_BETWEEN_LINES = 60
LEVELS = ("-O0", "-O0", "-O0", "-O1", "-O0", "-O0", "-O0", "-Os")  # compiling is half of the time, and twice that with -Os
MOST_CYCLES = 600_000_000  # of the simulated machine; a batch takes some ten millions
ONE_ALONE = ("-O0", "-O1", "-Os", "-O2")


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
    programs, failed = [], []
    for seed in seeds:
        try:
            programs.append(generate(seed))
        except Exception as fault:  # of one seed; the others are judged
            report(f"FAILED seed {seed}: the generator: {fault!r}")
            failed.append(f"seed {seed}")
    judged, refused = values_on_avr(programs, directory, f"elf{seeds[0]}", runner, LEVELS[number % len(LEVELS)])
    for program, why in refused:
        program.write_sources(directory)
        report(f"FAILED {directory / program.name} (avr-gcc): {why}")
        failed.append(str(directory / f"{program.name}.yaml"))
    paths = [p.write(directory, v) for p, v in judged]
    wrong, output = test(plcxx, paths, engine, jobs) if paths else ([], "")
    for path in wrong:
        report(f"FAILED {path}")
        alone(next(pair for pair in judged if pair[0].name == pathlib.Path(path).stem), directory, runner, report)
        for code, line, text in messages(plcxx, path.replace(".yaml", ".cld"))[:3]:
            report(f"  {path.replace('.yaml', '.cld')}:{line}: {code} {text}")
    told = [row for row in output.splitlines() if ": expected " in row or "): " in row or row.startswith("plcxx:")]
    for row in told[:40]:
        report("  " + row)
    passed = [path for path in paths if path not in map(pathlib.Path, wrong)]
    failed += wrong + further.judge(number, passed, report)
    tally.programs += len(seeds)
    tally.values += sum(len(step) for _, v in judged for step in v)
    tally.failed += len(failed)
    if not keep:
        tidy(directory, programs, failed, f"elf{seeds[0]}")


def alone(judged, directory, runner, report):
    """Leaves the program of a disagreement by itself as it is for avr-gcc, and says when its values were its neighbours' doing."""
    program, values = judged
    try:
        if run_on_avr([program], directory, program.name, runner, "-O0")[0] != values:
            report(f"  {directory / program.name}.c has other values without its batch")
    except avr.NotRun as refusal:
        report(f"  without its batch: {refusal}")


def values_on_avr(programs, directory, name, runner, level):
    """(program, values) of those that ran, and (program, why) of those that avr-gcc or the simulator did not take.

    avr-gcc 5 finds no registers for some functions, and some batches are larger than its memory: then without optimisation,
    then in halves, so that what is left is one program, which gets each level once. What does not end is known by how much
    had been shown."""
    if not programs:
        return [], []
    levels = ONE_ALONE if len(programs) == 1 else (level, "-O0") if level != "-O0" else (level,)
    for own in levels:
        try:
            return list(zip(programs, run_on_avr(programs, directory, name, runner, own, MOST_CYCLES))), []
        except avr.NotRun as refusal:
            why, shown = str(refusal), refusal.shown
        if shown is not None and len(programs) > 1:
            # Alone it may end: the others' memory is beside its own in the batch.
            at = next((at for at in range(len(programs)) if sum(p.blocks() for p in programs[:at + 1]) > shown), len(programs) - 1)
            return joined(values_on_avr(part, directory, name, runner, "-O0") for part in (programs[at:at + 1], programs[:at] + programs[at + 1:]))
        if shown is not None:
            break
    if len(programs) == 1:
        return [], [(programs[0], why)]
    half = len(programs) // 2
    return joined(values_on_avr(part, directory, name, runner, "-O1") for part in (programs[:half], programs[half:]))


def joined(parts):
    judged, refused = zip(*parts)
    return sum(judged, []), sum(refused, [])


def tidy(directory, programs, failed, name):
    for program in programs:
        if str(directory / f"{program.name}.yaml") not in failed:
            for file in (*program.files, f"{program.name}.yaml"):
                (directory / file).unlink(missing_ok=True)
    (directory / f"{name}.elf").unlink(missing_ok=True)
    if not failed:
        (directory / f"{name}.c").unlink(missing_ok=True)
