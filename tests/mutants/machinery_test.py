"""machinery_test.py MUTATE COMPILER: what dev/mutants rests on, shown on the small program of fixture/.

Every mutant of the program, and what becomes of it, is in fixture/expected.txt: killed, survived or not reached.
"""
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import judge
import mutants
import prepare
import random_runs
import tests_seen

HERE = pathlib.Path(__file__).resolve().parent


def verdicts(mutate, compiler, place):
    table, program, reached = place / "table", place / "scale_test", place / "reached"
    prepare.rewrite(mutate, [str(HERE / "fixture/scale.cc")], HERE, place, table, 1, [HERE / "fixture"])
    subprocess.run([compiler, "-std=c++20", "-Wall", "-Wextra", "-I", prepare.ROOT, "-I", HERE / "fixture", "-o", program,
                    place / "fixture/scale.cc", HERE / "fixture/scale_test.cc"], check=True)
    marks, passed, _ = tests_seen.record([str(program)], str(reached), HERE)
    assert passed, "the program without a mutant does not pass"
    lines, counts = [], {}
    for line in table.read_text().split("\n"):
        if not line:
            continue
        mutant = prepare.Mutant("fixture", line, counts)
        verdict = "not reached"
        if mutant.id in marks:
            verdict = "killed" if judge.run([str(program)], mutant.id, 20, HERE) else "survived"
        lines.append(f"{verdict}: {mutant.key}")
    return lines


def check_fixture(mutate, compiler):
    with tempfile.TemporaryDirectory() as place:
        found = verdicts(mutate, compiler, pathlib.Path(place))
    golden = HERE / "fixture/expected.txt"
    if os.environ.get("PLCXX_UPDATE_GOLDEN"):
        golden.write_text("\n".join(found) + "\n")
    expected = golden.read_text().split("\n")[:-1]
    for line in sorted(set(found) ^ set(expected)):
        print(("only now: " if line in found else "only in expected.txt: ") + line)
    count = collections.Counter(line.split(":")[0] for line in found)
    assert found == expected, "other mutants, or other verdicts"
    assert min(count["killed"], count["survived"], count["not reached"]) > 0, count


def check_endless():
    assert judge.run(["sleep", "60"], 1, 0.2, HERE) == "took too long"
    assert judge.run(["sh", "-c", "while :; do :; done"], 1, 1, HERE) == "took too long"
    # What waits for the processor is not endless.
    assert judge.run(["sleep", "0.4"], 1, 0.2, HERE) is None
    assert judge.run(["sh", "-c", "echo 'FAILED  a.yaml'; sleep 60"], 1, 30, HERE) == "a.yaml"
    assert judge.run(["sh", "-c", "exit 3"], 1, 30, HERE) == "exit code 3"
    assert judge.run(["true"], 1, 30, HERE) is None


def check_survivors():
    reasons = mutants.read_survivors()
    assert all(reasons.values()), "a survivor without a reason"
    known = mutants.Known({"a.cc | F** | < to <= | **": "why", "b.cc | G | + to - | x[*] + y": "sum"})
    assert known.reason("a.cc | FG | < to <= | i < n") == "why"
    assert known.reason("b.cc | G | + to - | x[*] + y") == "sum"
    assert known.reason("b.cc | G | + to - | x[1] + y") is None
    assert known.reason("a.cc | FG | < to >= | i < n") is None


class Row:
    """Of a table of mutants."""

    def __init__(self, number, key):
        self.id, self.key, self.file = number, key, key.split(" | ")[0]


def check_moved():
    now = [Row(7, "a.cc | F | + to - | x + y"), Row(8, "a.cc | F | + to - | x + z"), Row(9, "b.cc | G | < to <= | i < n")]
    before = {1: "a.cc | F | + to - | x + y", 2: "a.cc | F | gone", 3: "b.cc | G | < to <= | i < n"}
    places = tests_seen.places_of(before, now)
    assert places == {1: [7, 8], 2: [8], 3: [9]}, places


class Reached:
    """By one mutant: so many scenarios."""

    def __init__(self, number, scenarios):
        self.scenarios = [tests_seen.Scenario(f"s{i}.yaml") for i in range(scenarios)]
        self.units, self.by_emit, self.by_unit = [], {}, {}
        self.by_scenario = {number: list(range(scenarios))} if scenarios else {}


class Stages(judge.Judge):
    """Without processes: what runs, and what of it fails."""

    def __init__(self, number, scenarios, killers, cheap_only=False):
        super().__init__(Reached(number, scenarios), 0, 20, cheap_only)
        self.killers_there, self.ran = killers, []

    def in_simulator(self, mutant, found, *options, engine="sim"):
        ran = [(index, *(options if engine == "sim" else (engine,))) for index in found]
        self.ran += ran
        return next((f"s{run[0]}" for run in ran if run in self.killers_there), None)

    def random_programs(self, mutant):
        self.ran.append("random")
        return "random" if "random" in self.killers_there else None


def check_stages():
    row = Row(7, "a.cc | F | + to - | x + y")
    row.folder, row.function = "hnc", "F"
    order = Stages(7, 50, ()).order(row)
    assert sorted(order) == list(range(50))
    # A scenario beyond those of the first stage is found by the second alone.
    last = (order[-1],)
    assert Stages(7, 50, [last]).judge(row) == ("killed", f"s{order[-1]}")
    assert Stages(7, 50, [last], cheap_only=True).judge(row) == ("survived", "")
    first = Stages(7, 50, [(order[0],)])
    assert first.judge(row)[0] == "killed" and len(first.ran) == judge.FIRST, "the second stage ran for nothing"
    # With the looks at what the lowering took for granted, and then what nobody wrote down.
    assert Stages(7, 50, [(order[3], "--checked")]).judge(row)[0] == "killed"
    survivor = Stages(7, 50, ())
    assert survivor.judge(row) == ("survived", "") and survivor.ran[-1] == "random"
    assert len(survivor.ran) == len(set(survivor.ran)) == 101, "a scenario twice"
    assert Stages(7, 50, ["random"]).judge(row) == ("killed", "random")
    assert Stages(7, 0, ()).judge(row) == ("not reached", "")
    assert Stages(7, 0, ["random"]).judge(row) == ("killed", "random")
    assert Stages(7, 0, ["random"], cheap_only=True).judge(row) == ("not reached", "")


def check_generated():
    """What generated code alone executes of the runtime is seen there, and what the simulator does is looked at in both."""
    row = Row(7, "a.h | F | + to - | x + y")
    row.folder, row.function = "runtime", "F"
    tests_seen.mutated_runtime = lambda: "compiler"
    alone = Stages(7, 0, [(3, "host")], cheap_only=True)
    assert alone.judge(row) == ("not reached", "")
    alone.seen.scenarios, alone.seen.by_emit = [tests_seen.Scenario(f"s{i}.yaml") for i in range(5)], {7: [2, 3]}
    assert alone.judge(row) == ("killed", "s3")
    assert Stages(7, 9, [(4, "host")], cheap_only=True).judge(row) == ("killed", "s4")
    row.folder = "hnc"
    assert Stages(7, 9, [(4, "host")], cheap_only=True).judge(row) == ("survived", "")


def check_ways():
    """What each way of looking was asked, and what it killed."""
    row = Row(7, "a.cc | F | + to - | x + y")
    row.folder, row.function = "hnc", "F"
    judged = Stages(7, 50, ["random"])
    judged.judge(row)
    asked = {name: (times, killed) for name, (times, killed, _) in judged.ways.items()}
    assert asked["some in simulator"] == (1, 0) and asked["random programs"] == (1, 1), asked
    assert mutants.ways_table(judged.ways).splitlines()[-1].split() == ["random", "programs", "1", "1", "0"]


def check_groups():
    """Tests that fail together without a mutant, too, are asked one by one."""
    row = Row(7, "a.cc | F | + to - | x + y")
    judged = Stages(7, 0, ())
    judged.seen.units = [tests_seen.Unit("a_test", name) for name in ("A.One", "A.Two")]
    judged.seen.by_unit = {7: [0, 1]}
    run = judge.run
    try:
        both, second = "=A.One:A.Two", "=A.Two"
        for failing, expected in (([(both, 7)], "a_test: wrong"), ([(both, 7), (both, 0)], None),
                                  ([(both, 7), (both, 0), (second, 7)], "A.Two: wrong")):
            judge.run = lambda command, number, seconds, failing=failing: next(
                ("wrong" for end, of in failing if command[1].endswith(end) and number == of), None)
            assert judged.units(row) == expected, (failing, judged.units(row))
    finally:
        judge.run = run


def check_random_runs():
    row = Row(7, "a.cc | F | + to - | x + y")
    row.folder = "nc110"
    commands = random_runs.commands
    random_runs.commands = lambda folder, seed, place: [["one", str(seed)], ["two", str(seed)]]
    try:
        # What fails without the mutant, too, has not seen it.
        assert random_runs.killer(row, lambda command, number, seconds: "exit code 1") is None
        assert random_runs.killer(row, lambda command, number, seconds: None) is None
        found = random_runs.killer(row, lambda command, number, seconds: "wrong" if command[0] == "two" and number else None)
        assert found == "random programs (two of seed 7): wrong", found
    finally:
        random_runs.commands = commands


def check_table():
    made = [Row(number, f"transpiler/emit/a.cc | F | + to - | {number}") for number in range(5)]
    for row in made:
        row.folder = "emit"
    verdicts = ("killed", "killed", "survived", "survived", "not reached")
    results = {row.key: (verdict, "") for row, verdict in zip(made, verdicts)}
    text = mutants.table(made, results, mutants.Known({made[2].key: "why"}))
    assert text.splitlines()[-1].split() == ["all", "5", "5", "2", "1", "1", "1", "50.0"], text


def check_choice():
    made = [Row(number, f"transpiler/emit/{name}.cc | F | + to - | {number}") for number, name in enumerate("abab")]
    for row in made:
        row.folder = "emit"
    chosen = [[row.id for row in mutants.choose(made, ["emit"], *more)] for more in ((0, 1), (0, 1, ["b.cc"]), (1, 1, ["a.", "c."]))]
    assert chosen[:2] == [[0, 1, 2, 3], [1, 3]] and chosen[2] in ([0], [2]), chosen
    assert not mutants.choose(made, ["hnc"], 0, 1)


def check_folders():
    """A folder whose files have moved is not left out in silence."""
    for folder, patterns in prepare.FOLDERS.items():
        for pattern in patterns:
            assert list(prepare.ROOT.glob(pattern)), f"{folder}: nothing is at {pattern}"
    # Marks of ids beyond it are in memory that is not there.
    most = re.search(r"kMost = 1U << (\d+);", (HERE / "mutation_points.h").read_text())
    assert len(prepare.FOLDERS) * prepare.MOST_OF_FOLDER < 1 << int(most[1]), "the ids of the last folder have no mark"


def main():
    check_choice()
    check_folders()
    check_stages()
    check_generated()
    check_ways()
    check_groups()
    check_random_runs()
    check_table()
    check_moved()
    check_endless()
    check_survivors()
    if not pathlib.Path(sys.argv[1]).exists():
        print("skipped: the small program, for which `ninja -C build plcxx_mutate` builds the tool")
        return 77
    check_fixture(sys.argv[1], sys.argv[2])
    return 0


if __name__ == "__main__":
    sys.exit(main())
