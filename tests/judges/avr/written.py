"""Programs that were written by hand, as somebody writes them who knows the language and the control, through both.

Each is one text for both compilers: accesses to the register areas are spelled anew for avr-gcc, and nothing in it is what
the specification defines and C does not. Its head says what is looked at, and what is set before each scan:

    // shows: NAME TYPE COUNT, ...
    // sets: LOCATION VALUE, ... [cycles N]
"""
import pathlib
import re

from program import Observed, Program, Step, array, messages, run_on_avr, test

PROGRAMS = pathlib.Path(__file__).resolve().parent / "written"
HOST = {"X": "host.x[{}]", "F": "host.f[{}]", "P": "host.p[{}]", "R": "R.uc[{}]"}
VIEWS = (("uc", "unsigned char"), ("c", "char"), ("ui", "unsigned"), ("i", "int"), ("ul", "unsigned long"), ("l", "long"))
BASIC = {"X": "uc", "Y": "uc", "R": "uc", "P": "ui", "B": "ui"}
AREA = re.compile(r"\b([XYRPB])(?:_(uc|c|ui|i|ul|l))?\b(?!\.|')")
HANDLER = re.compile(r"set_mst_func\((\d), '(.)', &?(\w+)\);")
LEVELS = ("-O0", "-O1", "-Os", "-O2")


def tables():
    """F_T and G_T are what the specification says they are: tables of pointers, a word apart."""
    rows, fills = [], []
    for area in "FG":
        for view, kind in VIEWS:
            rows.append(f"static {kind} *{area}_{view}[256];")
            fills.append(f"{area}_{view}[k] = ({kind} *)&{area}.uc[2 * k];")
    words = [f"#define mod_{letter}_code(ch) (*G_i[(ch) * 20 + {170 + at}])" for at, letter in enumerate("MSTB")] + ["#define near", "#define far"]
    return "\n".join([*rows, "static void fill_tables(void)", "{", "int k;", "for (k = 0; k < 256; k++) {", *fills, "}", "}", *words]) + "\n"


def for_avr(text, name):
    """The text with the areas' unions, and the parts under the names that the driver calls."""
    text = AREA.sub(lambda m: f"{m[1]}.{m[2] or BASIC[m[1]]}", text)
    text = HANDLER.sub(lambda m: f"handler[{m[1]}][{'MSTBE'.index(m[2])}] = {m[3]};", text)
    for part in ("init", "plc1", "plc2"):
        text = re.sub(rf"\b{part}\b", f"{part}_{name}", text)
    return text.replace(f"init_{name}()", f"init_{name}(void)", 1)


def read(path):
    name, text = path.stem, path.read_text()
    observed = []
    for item in re.search(r"^// shows: (.*)", text, re.M)[1].split(", "):
        variable, *kind, count = item.split()
        kind = " ".join(kind)
        observed.append(array(variable, kind, int(count)) if int(count) > 1 else Observed(variable, [(variable, kind)]))
    steps = []
    for row, cycles in re.findall(r"^// sets: (.*?)(?: cycles (\d+))?$", text, re.M):
        values = {location: int(value) for location, value in (item.split() for item in row.split(", "))}
        places = [re.fullmatch(r"(\w)\[(\d+)\]", location).groups() for location in values]
        statements = [f"{HOST[area].format(at)} = {value}u;" for (area, at), value in zip(places, values.values())]
        steps.append(Step(values, statements, int(cycles or 1)))
    steps[0].statements.insert(0, "fill_tables();")
    observed += [Observed("*(unsigned char (*)[64])&R", [(f"R[{i}]", "unsigned char") for i in range(64)]),
                 Observed("*(unsigned char (*)[16])&Y", [(f"Y[{i}]", "unsigned char") for i in range(16)]),
                 Observed("*(unsigned (*)[20])&G", [(f"G[{i}]", "unsigned") for i in range(20)]),
                 Observed("*(unsigned (*)[16])&G.ui[162]", [(f"G[{i}]", "unsigned") for i in range(162, 178)])]
    plc = '#include "plc.h"\n' + text
    return Program(name, {f"{name}.cld": plc}, tables() + for_avr(text, name) + "\n", steps, observed)


def judge(plcxx, runner, directory, engine, jobs, report):
    """The number of programs that failed."""
    programs = [read(path) for path in sorted(PROGRAMS.glob("*.c"))]
    paths, values = [], 0
    for number, program in enumerate(programs):
        # One in an ELF: they share names.
        found = run_on_avr([program], directory, program.name, runner, LEVELS[number % len(LEVELS)])[0]
        values += sum(len(step) for step in found)
        paths.append(program.write(directory, found))
    failed, output = test(plcxx, paths, engine, jobs)
    for path in failed:
        report(f"FAILED {path}")
        for code, line, text in messages(plcxx, path.replace(".yaml", ".cld"))[:3]:
            report(f"  {path.replace('.yaml', '.cld')}:{line}: {code} {text}")
    if failed:
        report(output)
    report(f"{len(programs)} written programs, {values} values, {len(failed)} programs failed")
    return len(failed)
