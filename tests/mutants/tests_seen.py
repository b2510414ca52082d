"""The tests that can see mutants, and which mutants each of them reaches."""
import array
import concurrent.futures
import functools
import os
import pathlib
import pickle
import re
import subprocess
import tempfile
import threading
import zlib

import prepare

# Not about what is mutated here, or they compile the headers by themselves.
LEFT_OUT = re.compile(r"^(Speed|Compilers|Headers|GoldenRunner|Mutation|Golden[.](Cases|Every))|[.]Speed")
EMITTED = 4  # one scenario in so many is looked at as C++, too
LIMIT = 10  # seconds: a longer test is left out
REACHED = re.compile(b"\x01")


# Other files of YAML are beside them: panels, plants.
SCENARIO = re.compile(r"^(steps|expect_error|warnings|properties):", re.M)
DIALECTS = ("nc110", "host50", "prostep", "technol", "hnc", "classicladder")


class Scenario:
    """Of tests/golden, samples or the programs judged by an AVR: runs in the simulator; as compiled C++ for what the
    emitter writes."""

    def __init__(self, path):
        self.name, self.seconds, self.text = path, 0.0, ""
        self.reaches, self.emits = array.array("i"), array.array("i")


class Unit:
    """One GoogleTest."""

    def __init__(self, binary, name):
        self.binary, self.name, self.seconds = binary, name, 0.0
        self.reaches = array.array("i")


def environment(mutant=0, **more):
    values = dict(os.environ, **more)
    values.pop("PLCXX_MUTANT", None)
    if mutant:
        values["PLCXX_MUTANT"] = str(mutant)
    return values


def plcxx():
    return str(prepare.BUILD / "bin" / "plcxx")


def scenario_command(paths, *more, engine="sim", limit=20):
    return [plcxx(), "test", "--engine", engine, "--jobs", "1", "--time-limit", str(limit), *more, *paths]


def unit_command(unit):
    return [str(prepare.BUILD / "tests" / unit.binary), f"--gtest_filter={unit.name}", "--gtest_brief=1"]


# Instead of a compiler: notes what it would compile, and fails.
NO_COMPILER = """#!/bin/sh
while [ "$1" != -o ]; do [ "$1" != -I ] || place=$2; shift; done
cat "$place"/*pp | sha256sum >> "$PLCXX_MUTANTS_TEXT"
exit 1
"""


# A compiler that takes the mutated headers of the runtime: generated code marks its mutants, and one of them is active.
MUTATED_RUNTIME = """#!/bin/sh
[ -z "$PLCXX_MUTANTS_TEXT" ] || {no_compiler} "$@"
exec c++ -I {source} -I {source}/mutated_runtime "$@"
"""


def script(name, text):
    path = prepare.PLACE / name
    if not path.exists() or path.read_text() != text:
        path.write_text(text)
        path.chmod(0o755)
    return str(path)


def no_compiler():
    return script("no_compiler", NO_COMPILER)


def mutated_runtime():
    return script("mutated_runtime", MUTATED_RUNTIME.format(no_compiler=no_compiler(), source=prepare.SOURCE))


def emitted_text(path, mutant=0, reached=None):
    """What stands for the C++ of a scenario's program; "" when there is none. What is recorded is compiled and executed, too:
    of the runtime it reaches what the simulator does not."""
    with tempfile.NamedTemporaryFile("r") as text:
        more = {"PLCXX_MUTANTS_TEXT": text.name}
        compiler = no_compiler()
        if reached:
            more["PLCXX_MUTANTS_REACHED"] = reached
            compiler = mutated_runtime()
        try:
            subprocess.run(scenario_command([path], "--cxx", compiler, engine="host"), cwd=prepare.SOURCE,
                           env=environment(mutant, **more), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                           timeout=300)
        except subprocess.TimeoutExpired:
            return "endless"
        return text.read()


def record(command, reached, place=prepare.SOURCE):
    """Runs it without a mutant: which it reached, whether it passed, how long it took."""
    with open(reached, "wb"):
        pass
    with subprocess.Popen(command, cwd=place, env=environment(PLCXX_MUTANTS_REACHED=reached), stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as process:
        timer = threading.Timer(300, process.kill)
        timer.start()
        _, status, used = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
    # Of the processor: which tests are left out does not depend on what else the machine does.
    return read_reached(reached), process.returncode == 0, used.ru_utime + used.ru_stime


def read_reached(path):
    return array.array("i", (match.start() for match in REACHED.finditer(pathlib.Path(path).read_bytes())))


def record_scenario(scenario):
    with tempfile.TemporaryDirectory() as place:
        reached = os.path.join(place, "reached")
        scenario.reaches, passed, scenario.seconds = record(scenario_command([scenario.name]), reached)
        if passed and is_emitted(scenario):
            with open(reached, "wb"):
                pass
            scenario.text = emitted_text(scenario.name, reached=reached)
            if scenario.text:
                known = set(scenario.reaches)
                scenario.emits = array.array("i", (mutant for mutant in read_reached(reached) if mutant not in known))
    return scenario if passed else None


def record_unit(unit):
    with tempfile.TemporaryDirectory() as place:
        unit.reaches, passed, unit.seconds = record(unit_command(unit), os.path.join(place, "reached"))
    return unit if passed else None


def reaches_none(name, folders):
    """Whether it is about dialects, and about none of them that is looked at."""
    of = [dialect for dialect in DIALECTS if dialect in name.lower()]
    return bool(of) and not set(folders).intersection([*of, *prepare.SEEN_BY_ALL])


def is_emitted(scenario):
    return zlib.crc32(scenario.name.encode()) % EMITTED == 0


def units(folders):
    found = []
    for path in sorted((prepare.BUILD / "tests").glob("*_test")):
        if not path.name.startswith(prepare.TESTS) or not prepare.concerns(path.name, folders):
            continue
        lines = subprocess.run([path, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
        suite = ""
        for line in lines.split("\n"):
            word = line.split("#")[0].strip()
            if not line.startswith(" "):
                suite = word
            elif word and not LEFT_OUT.search(suite + word):
                generates = "emit" in folders and path.name in ("golden_test", "printed_test")
                if generates or not reaches_none(suite + word, folders):
                    found.append(Unit(path.name, suite + word))
    return found


def scenarios(folders):
    found = [Scenario(str(path.relative_to(prepare.SOURCE)))
             for place in ("tests/golden", "samples", prepare.JUDGED.relative_to(prepare.SOURCE))
             for path in sorted((prepare.SOURCE / place).rglob("*.yaml")) if path.name != "plcxx.yaml" and SCENARIO.search(path.read_text())]
    return [scenario for scenario in found
            if ("emit" in folders and is_emitted(scenario)) or not reaches_none(scenario.name, folders)]


class Seen:
    """By mutant: the tests that reach it."""

    def __init__(self, recorded_scenarios, recorded_units):
        self.scenarios, self.units = recorded_scenarios, recorded_units
        self.by_scenario, self.by_emit, self.by_unit = {}, {}, {}
        for table, tests, field in ((self.by_scenario, self.scenarios, "reaches"), (self.by_emit, self.scenarios, "emits"),
                                    (self.by_unit, self.units, "reaches")):
            for index, test in enumerate(tests):
                for mutant in getattr(test, field):
                    table.setdefault(mutant, array.array("i")).append(index)


def identity(test):
    """A scenario that says something else, or whose program does, is another test, and so is a printed program. Of other
    unit tests the name stands: what they reach beyond the record makes a survivor, never a killed one."""
    if not isinstance(test, Scenario):
        return f"{test.name} {printed_programs()}" if test.binary == "printed_test" else test.name
    path = prepare.SOURCE / test.name
    return " ".join([test.name, *(str(zlib.crc32(part.read_bytes())) for part in sorted(path.parent.glob(path.stem + ".*")))])


@functools.cache
def printed_programs():
    return zlib.crc32(b"".join(path.read_bytes() for path in sorted((prepare.SOURCE / "tests/printed").rglob("*.*"))))


def moved(result, places):
    """What a test was recorded to reach, by the numbers that the mutants have now."""
    for field in ("reaches", "emits") if isinstance(result, Scenario) else ("reaches",):
        now = {number for before in getattr(result, field) for number in places.get(before, ())}
        setattr(result, field, array.array("i", sorted(now)))
    return result


def places_of(keys_before, mutants):
    """By number before: the mutant's number now. A mutant that is new, for its code was edited, is taken to be reached by
    what reached any of its file: tests that do not reach it can only let it survive."""
    number_of = {mutant.key: mutant.id for mutant in mutants}
    known = set(keys_before.values())
    new_of_file = {}
    for mutant in mutants:
        if mutant.key not in known:
            new_of_file.setdefault(mutant.file, []).append(mutant.id)
    return {before: ([number_of[key]] if key in number_of else []) + new_of_file.get(key.split(" | ")[0], [])
            for before, key in keys_before.items()}


def keep(place, keys, results):
    """What did not pass may pass by then. A run that is ended goes on from here."""
    with open(place, "wb") as file:
        pickle.dump((keys, {test: result for test, result in results.items() if result is not None}), file)


def recorded(name, tests, record_one, jobs):
    """What an earlier run has recorded stands, by the mutants' keys: only new tests are run."""
    kept = prepare.PLACE / f"seen_{name}.pickle"
    mutants = prepare.read_table()
    keys = {mutant.id: mutant.key for mutant in mutants}
    results = {}
    if kept.exists():
        with open(kept, "rb") as file:
            keys_before, results = pickle.load(file)
        # A folder that was not mutated then was not looked at.
        if {key.split(" | ")[0].rpartition("/")[0] for key in keys.values()} - {
                key.split(" | ")[0].rpartition("/")[0] for key in keys_before.values()}:
            results = {}
        elif keys_before != keys:
            places = places_of(keys_before, mutants)
            results = {test: result and moved(result, places) for test, result in results.items()}
    todo = [test for test in tests if identity(test) not in results]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for number, (test, result) in enumerate(zip(todo, pool.map(record_one, todo)), 1):
            results[identity(test)] = result
            if result is None:
                print(f"  does not pass without a mutant, left out: {test.name}")
            if number % 500 == 0:
                print(f"what {name} reach: {number} of {len(todo)}", flush=True)
                keep(kept, keys, results)
    keep(kept, keys, results)
    return [results[identity(test)] for test in tests if results[identity(test)] is not None]


def record_all(jobs, folders):
    """Of the tests that may reach mutants of the folders."""
    return Seen(recorded("scenarios", scenarios(folders), record_scenario, jobs),
                recorded("units", units(folders), record_unit, jobs))
