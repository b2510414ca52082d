"""The matrix of loops through both: who is refused, and what the others leave."""
import collections

import loops
from counting import Verdict, run, wrap
from program import Program, Step, array, messages, run_on_avr, test

LOOPS_A_PROGRAM = 40  # plcxx reports at most 50 errors
PROGRAMS_A_BATCH = 4
INPUTS = ({"P[0]": 9}, {"P[0]": 0}, {"P[0]": 14, "X[5]": 1, "X[7]": 30}, {"P[0]": 3, "X[0]": 1, "X[7]": 5})
FAR_INPUTS = INPUTS + ({"P[0]": 0xFFFF}, {"P[0]": 0x8003, "X[7]": 255})
ARRAYS = (("cnt", "unsigned"), ("hit", "unsigned"), ("use", "unsigned"), ("sum", "long"), ("end", "long"), ("got", "unsigned char"))
TABLE = "const unsigned char table[12] = {11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22};"


def statement(location, value):
    area, index = location.rstrip("]").split("[")
    return f"host.{area.lower()}[{index}] = {value};"


def program(name, group, inputs):
    """One program of some loops, and where they are."""
    plc = ['#include "plc.h"'] + [f"{kind} {array_name}[{LOOPS_A_PROGRAM}];" for array_name, kind in ARRAYS] + [TABLE]
    own = [f"static {kind} {array_name}_{name}[{LOOPS_A_PROGRAM}];" for array_name, kind in ARRAYS]
    own.append(f"static {TABLE.replace('table', f'table_{name}')}")
    rename = "".join(f"#undef {a}\n#define {a} {a}_{name}\n" for a in [a for a, _ in ARRAYS] + ["table", "other"])
    shared = ["void other(void) { R[90]++; }"]
    plc += shared
    own += [f"static {row}".replace("R[", "R.uc[") for row in shared]
    lines, made = [], []  # lines[i]: from the first to the last of group[i], and its keyword's
    for slot, loop in enumerate(group):
        loop.slot = slot
        if loop.place == "global":
            plc.append(f"{loop.kind} g{loop.serial};")
            made.append(f"static {loop.kind} g{loop.serial};")
        rows = loops.Text(loop).lines("plc")
        keyword = [i for i, row in enumerate(rows) if "/*loop*/" in row][0] + len(plc) + 1
        lines.append((range(len(plc) + 1, len(plc) + len(rows) + 1), keyword))
        plc += rows
        made += ["static " + row if row.startswith("void loop") else row for row in loops.Text(loop).lines("avr")]
    calls = [f"loop{x.serial}({loops.constant(x.start) if x.place == 'parameter' else ''});" for x in group]
    plc += ["void init() { plc1_time = 1; plc2_time = 1; }", "void plc1()", "{"] + calls + ["}", "void plc2() { }"]
    made += [f"static void init_{name}(void) {{ }}", f"static void plc1_{name}(void)", "{"] + calls + ["}",
             f"static void plc2_{name}(void) {{ }}"]
    steps = []
    before = {}
    for given in inputs:
        values = {**{key: 0 for key in before}, **given}
        before = {**before, **given}
        steps.append(Step(values, [statement(key, value) for key, value in values.items()]))
    observed = [array(a, kind, len(group), f"{a}_{name}") for a, kind in ARRAYS]
    for o in observed:
        o.locations += [(f"{o.locations[0][0].split('[')[0]}[{i}]", o.locations[0][1]) for i in range(len(group), LOOPS_A_PROGRAM)]
    text = rename + "\n".join(own + made) + "\n"
    return Program(name, {f"{name}.cld": "\n".join(plc) + "\n"}, text, steps, observed), lines


def grouped(items, size):
    return [items[i:i + size] for i in range(0, len(items), size)]


def judge(plcxx, runner, directory, thin, engine, jobs, report):
    """Exit value: the number of findings. `report` takes a line of text."""
    everything = list(loops.matrix(thin))
    refused, texts = set(), {}
    for number, group in enumerate(grouped(everything, LOOPS_A_PROGRAM)):
        made, lines = program(f"refusals{number}", group, INPUTS)
        made.write_sources(directory)
        for code, line, text in messages(plcxx, directory / f"refusals{number}.cld"):
            culprits = [loop for loop, (rows, _) in zip(group, lines) if line in rows]
            if code == "hnc-E032" and culprits:
                refused.add(culprits[0].serial)
                texts[culprits[0].serial] = text
            if code != "hnc-E032" or not culprits or line not in [keyword for _, keyword in lines] and "rounds" not in text:
                report(f"refusals{number}.cld:{line}: {code} {text}")
    tally = collections.Counter()
    findings = 0
    runnable = []
    for loop in everything:
        told = loop.verdict()
        is_refused = loop.serial in refused
        tally[told.value, "refused" if is_refused else "accepted"] += 1
        if told is Verdict.ACCEPT and is_refused:
            report(f"wrongly refused: {loop.name()} start {loop.start} limit {loop.limit_range()}: {texts[loop.serial]}")
            findings += 1
        if told is Verdict.REFUSE and not is_refused:
            report(f"wrongly accepted: {loop.name()} start {loop.start} limit {loop.limit_range()}")
            findings += 1
        if not is_refused and (loop.bound or told is Verdict.ACCEPT or told is Verdict.OPEN and ends(loop)):
            runnable.append(loop)
    report(", ".join(f"{told} {made}: {count}" for (told, made), count in sorted(tally.items())))

    def is_far(loop):
        return loop.limit in ("full", "cell") and loop.kind in ("int", "unsigned") and not loop.bound

    runnable.sort(key=is_far)
    groups = grouped(runnable, LOOPS_A_PROGRAM)
    programs = []
    for number, group in enumerate(groups):
        far = is_far(group[0]) and number % 4 == 0
        programs.append(program(f"loops{number}", group, FAR_INPUTS if far else INPUTS)[0])
    paths = []
    for number, batch in enumerate(grouped(programs, PROGRAMS_A_BATCH)):
        values = run_on_avr(batch, directory, f"batch{number}", runner, ("-Os", "-O1", "-O2")[number % 3])
        paths += [p.write(directory, v) for p, v in zip(batch, values)]
        for group, found in zip(groups[number * PROGRAMS_A_BATCH:], values):
            findings += sum(report(f"counted otherwise: {loop.name()}") or 1 for loop in group if not counted(loop, dict(found[0])))
    failed, output = test(plcxx, paths, engine, jobs)
    if failed:
        report(output)
    report(f"{len(everything)} loops, {len(runnable)} run in {len(paths)} programs, {len(failed)} programs failed")
    return findings + len(failed)


def counted(loop, values):
    """The AVR made the rounds that counting.py says, and so did the rules that judge refusals."""
    if loop.bound or loop.extra != "none" or loop.limit not in ("constant", "edge"):
        return True
    expected = run(loop.count(), loop.value)
    return (values[f"cnt[{loop.slot}]"], values[f"end[{loop.slot}]"]) == (expected.rounds & 0xFFFF, wrap(expected.end, "long"))


def ends(loop):
    if isinstance(loop.step, str):
        return False
    low, high = loop.limit_range()
    return all(run(loop.count(), value).ended for value in {low, high, 0, 9, 14, 3} if low <= value <= high)
