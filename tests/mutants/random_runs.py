"""Random programs for a mutant that survives everything written down: hnc's beside avr-gcc (tests/judges/avr), those of
the other dialects beside their second readings (tests/reference), and for the emitter as compiled C++."""
import pathlib
import tempfile

import prepare

PROGRAMS = 100   # of hnc, with other ones for each mutant: 100 ms each
BESIDE = 200     # of a dialect with a second reading
COMPILED = 16    # of a dialect, for the emitter: a compiler's call takes as many together
SECONDS = 300
READ_TWICE = ("nc110", "host50", "prostep", "technol")


def avr_runner():
    return prepare.BUILD / "bin/plcxx_avr_runner"


def soak():
    return prepare.BUILD / "tests/plcxx_soak"


def of_hnc(place, seed, *more, programs=PROGRAMS):
    return ["python3", "-B", str(prepare.SOURCE / "tests/judges/avr/run.py"), str(prepare.BUILD / "bin/plcxx"), str(avr_runner()),
            f"{place}/hnc", "--programs", str(programs), "--seed", str(seed), "--jobs", "1", *more]


def beside_reference(place, seed, dialects, programs, *more):
    chosen = [word for dialect in dialects for word in ("--dialect", dialect)]
    return [str(soak()), *chosen, "--programs", str(programs), "--seed", str(seed), "--jobs", "1", "--save", f"{place}/soak", *more]


def commands(folder, seed, place):
    """What may notice a mutant of the folder; without the programs of what is not installed. The same seed gives the same."""
    found = []
    if soak().exists():
        if folder in READ_TWICE:
            found.append(beside_reference(place, seed, [folder], BESIDE))
        elif folder in prepare.SEEN_BY_ALL:
            found.append(beside_reference(place, seed, READ_TWICE, BESIDE // len(READ_TWICE)))
        elif folder == "emit":
            found.append(beside_reference(place, seed, READ_TWICE, COMPILED, "--compiled-every", "1", "--compiler", "g++ -O0"))
    if avr_runner().exists():
        if folder == "emit":
            found.append(of_hnc(place, seed, "--engine", "host", programs=COMPILED))
        elif folder == "hnc" or folder in prepare.SEEN_BY_ALL:
            found.append(of_hnc(place, seed))
    return found


def killer(mutant, run):
    """`run(command, mutant's number, seconds)` gives what failed, or None. A program that fails without the mutant, too,
    says nothing."""
    for number in range(len(commands(mutant.folder, mutant.id, "."))):
        with tempfile.TemporaryDirectory() as place:
            command = commands(mutant.folder, mutant.id, place)[number]
            failed = run(command, mutant.id, SECONDS)
            if failed and run(command, 0, SECONDS) is None:
                return f"random programs ({pathlib.Path(command[0]).name} of seed {mutant.id}): {failed}"
    return None
