"""machinery_test.py MUTATE COMPILER: what dev/mutants rests on, shown on the small program of fixture/.

Every mutant of the program, and what becomes of it, is in fixture/expected.txt: killed, survived or not reached.
"""
import collections
import os
import pathlib
import subprocess
import sys
import tempfile

import judge
import mutants
import prepare
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


def main():
    check_moved()
    check_endless()
    check_survivors()
    check_fixture(sys.argv[1], sys.argv[2])


if __name__ == "__main__":
    main()
