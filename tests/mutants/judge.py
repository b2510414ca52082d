"""One mutant against the tests that reach it, in two stages: what is cheap, and for what survives that everything else."""
import functools
import math
import os
import random
import signal
import subprocess
import threading

import prepare
import random_runs
import tests_seen

BATCHES = (3, 12, 100, 1000)  # scenarios in one process: most mutants are killed by the first
FIRST = 15                  # scenarios, before other tests
KILLERS = 8                 # of a function, tried first
MOST = 200                  # scenarios of the first stage; --most N
COMPILED, ALL_COMPILED = 5, 40  # scenarios whose C++ is another one: so many are compiled, in the first stage and in all
GENERATED = 20              # scenarios whose C++ is compiled with the mutated headers of the runtime
WAITING = 5                 # times its processor time, before a test is ended
LONG = 180                  # seconds: a longer test is left out of the second stage, too

used = threading.local()    # seconds: the processor's seconds of the processes of this thread, with their own children


def run(command, mutant, seconds, place=prepare.SOURCE):
    """None: passed. Otherwise what failed first. The seconds are the processor's, of one process: a machine that has other
    work kills no mutant. What waits is ended after several times as long."""
    limited = ["prlimit", f"--cpu={math.ceil(seconds)}", *map(str, command)]
    with subprocess.Popen(limited, cwd=place, env=tests_seen.environment(mutant), text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          start_new_session=True) as process:
        late = []

        def end():
            late.append(True)
            os.killpg(process.pid, signal.SIGKILL)

        timer = threading.Timer(WAITING * seconds, end)
        timer.start()
        failed = None
        for line in process.stdout:
            if line.startswith(("FAILED  ", "ERROR   ")):
                failed = line[8:].strip()
                break
        if failed:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        _, status, spent = os.wait4(process.pid, 0)
        timer.cancel()
        code = process.returncode = os.waitstatus_to_exitcode(status)
        used.seconds = getattr(used, "seconds", 0.0) + spent.ru_utime + spent.ru_stime
    if late or (code in (-signal.SIGXCPU, -signal.SIGKILL) and not failed):
        return "took too long"
    if failed:
        return failed
    return f"exit code {code}" if code != 0 else None


def limit(seconds):
    """What an endless one may take, where it takes so many seconds without a mutant; checks and compilers take more."""
    return 20 + 10 * seconds


class Judge:
    def __init__(self, seen, seed=0, most=MOST, cheap_only=False):
        self.seen, self.seed, self.most, self.cheap_only = seen, seed, most, cheap_only
        self.killers = {}  # by function: indices of scenarios that killed a mutant of it
        self.ways = {}     # by name: [mutants that were run against it, killed, seconds of the processor]
        self.lock = threading.Lock()
        self.index = {scenario.name: number for number, scenario in enumerate(seen.scenarios)}

    def reached(self, mutant):
        if mutant.folder in ("emit", "runtime") and mutant.id in self.seen.by_emit:
            return True
        return mutant.id in self.seen.by_scenario or mutant.id in self.seen.by_unit

    def judge(self, mutant):
        """(killed | survived | not reached, by what)"""
        if not self.reached(mutant):
            # Of what nobody wrote down a random program may still execute it.
            killer = None if self.cheap_only else self.measured(self.random_programs, mutant)
            return ("killed", killer) if killer else ("not reached", "")
        return self.first(mutant, *self.cheap(mutant), *([] if self.cheap_only else self.thorough(mutant)))

    def cheap(self, mutant):
        if mutant.folder == "runtime":
            return [self.units, self.some_in_simulator, self.more_in_simulator, self.as_generated]
        if mutant.folder == "emit":
            return [self.units, self.some_in_simulator, self.as_compiled]
        return [self.some_in_simulator, self.units, self.more_in_simulator]

    def thorough(self, mutant):
        """Everything that reaches it and was not run: what nearly all scenarios execute is often seen by one alone."""
        return [self.all_in_simulator, self.long_units, *([self.all_as_compiled] if mutant.folder == "emit" else []),
                self.random_programs]

    def first(self, mutant, *ways):
        for way in ways:
            killer = self.measured(way, mutant)
            if killer:
                return "killed", killer
        return "survived", ""

    def measured(self, way, mutant):
        used.seconds = 0.0
        killer = way(mutant)
        with self.lock:
            row = self.ways.setdefault(way.__name__.replace("_", " "), [0, 0, 0.0])
            row[0], row[1], row[2] = row[0] + 1, row[1] + bool(killer), row[2] + used.seconds
        return killer

    def order(self, mutant, table=None):
        """Scenarios: those that killed a neighbour; a few that reach little else; then as it comes."""
        found = (self.seen.by_scenario if table is None else table).get(mutant.id, ())
        by_size = sorted(found, key=lambda number: len(self.seen.scenarios[number].reaches))
        rest = by_size[3:]
        random.Random(self.seed + mutant.id).shuffle(rest)
        reaching = set(found)
        near = [number for number in self.killers.get((mutant.file, mutant.function), []) if number in reaching]
        return list(dict.fromkeys(near + by_size[:3] + rest))

    def some_in_simulator(self, mutant):
        return self.in_simulator(mutant, self.order(mutant)[:FIRST])

    def more_in_simulator(self, mutant):
        return self.in_simulator(mutant, self.order(mutant)[FIRST:self.most])

    def all_in_simulator(self, mutant):
        found = self.order(mutant)
        return self.in_simulator(mutant, found[self.most:]) or (
            self.in_simulator(mutant, found, "--checked") if mutant.folder == "hnc" else None)

    def random_programs(self, mutant):
        return random_runs.killer(mutant, run)

    def as_generated(self, mutant):
        """The runtime as generated code has it: first what that alone executes."""
        found = [*self.order(mutant, self.seen.by_emit), *self.order(mutant)][:GENERATED]
        return self.in_simulator(mutant, found, "--cxx", tests_seen.mutated_runtime(), engine="host")

    def in_simulator(self, mutant, found, *options, engine="sim"):
        at, number = 0, 0
        while at < len(found):
            size = BATCHES[min(number, len(BATCHES) - 1)]
            paths = [self.seen.scenarios[index].name for index in found[at:at + size]]
            took = [self.seen.scenarios[index].seconds for index in found[at:at + size]]
            longest, seconds = max(took), limit(sum(took))
            command = functools.partial(tests_seen.scenario_command, engine=engine,
                                        limit=math.ceil(20 + WAITING * longest))
            failed = run(command(paths, *options), mutant.id, seconds)
            # One that does not pass now without a mutant has not seen this one: its limit is of the clock.
            if failed in paths and run(command([failed], *options), 0, seconds):
                failed = None
            if failed:
                self.remember(mutant, failed)
                return failed
            at, number = at + size, number + 1
        return None

    def remember(self, mutant, failed):
        if failed in self.index:
            killers = self.killers.setdefault((mutant.file, mutant.function), [])
            if self.index[failed] not in killers:
                killers.insert(0, self.index[failed])
                del killers[KILLERS:]

    def units(self, mutant):
        tests = [self.seen.units[index] for index in self.seen.by_unit.get(mutant.id, ())]
        tests = sorted((test for test in tests if test.seconds < tests_seen.LIMIT), key=lambda test: test.seconds)
        cheap, alone = {}, []
        for test in tests:
            if test.seconds < 0.5:
                cheap.setdefault(test.binary, []).append(test)
        # Together in one process; what is only kept as it was printed says least.
        for binary, found in sorted(cheap.items(), key=lambda item: item[0] in ("golden_test", "printed_test")):
            for at in range(0, len(found), 50):
                group = found[at:at + 50]
                together = tests_seen.Unit(binary, ":".join(test.name for test in group))
                command = [*tests_seen.unit_command(together), "--gtest_fail_fast"]
                seconds = limit(sum(test.seconds for test in group))
                failed = run(command, mutant.id, seconds)
                # They were recorded one by one: together they may fail without a mutant, and then say nothing.
                if failed and run(command, 0, seconds) is None:
                    return f"{binary}: {failed}"
                alone += group if failed else []
        return self.each_unit(mutant, alone + [test for test in tests if test.seconds >= 0.5])

    def long_units(self, mutant):
        tests = [self.seen.units[index] for index in self.seen.by_unit.get(mutant.id, ())]
        return self.each_unit(mutant, sorted((test for test in tests if tests_seen.LIMIT <= test.seconds < LONG),
                                             key=lambda test: test.seconds))

    @staticmethod
    def each_unit(mutant, tests):
        for test in tests:
            failed = run(tests_seen.unit_command(test), mutant.id, limit(test.seconds))
            if failed:
                return f"{test.name}: {failed}"
        return None

    def as_compiled(self, mutant):
        return self.compiled(mutant, self.order(mutant, self.seen.by_emit)[:self.most], COMPILED)

    def all_as_compiled(self, mutant):
        return self.compiled(mutant, self.order(mutant, self.seen.by_emit), ALL_COMPILED)

    def compiled(self, mutant, found, most):
        """Only where the text of the program is another one: of these at most `most`."""
        compiled = 0
        for index in found:
            scenario = self.seen.scenarios[index]
            text = tests_seen.emitted_text(scenario.name, mutant.id)
            if text == scenario.text:
                continue
            if not text or text == "endless":
                return f"{scenario.name}: nothing emitted"
            failed = run(tests_seen.scenario_command([scenario.name], engine="all"), mutant.id, 300)
            if failed:
                self.remember(mutant, scenario.name)
                return f"{scenario.name} (compiled)"
            compiled += 1
            if compiled == most:
                break
        return None
