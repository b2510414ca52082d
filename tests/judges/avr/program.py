"""A program in both forms, with its inputs and what is looked at; its run on the AVR and its scenario for plcxx."""
import dataclasses
import json
import struct
import subprocess

import avr
import children

# The letters of struct for the types of the language.
LETTERS = {"char": "b", "signed char": "b", "unsigned char": "B", "short": "h", "unsigned short": "H", "int": "h",
           "unsigned": "H", "long": "i", "unsigned long": "I"}
HEAD = '#include "judge.h"\n'
SECONDS_BASE, SECONDS_EACH = 600, 60  # for one call of plcxx, and more for each scenario


@dataclasses.dataclass
class Observed:
    """Objects of the program that are shown with one call: an lvalue of the AVR's program and the locations in it."""
    text: str
    locations: list  # (name of the location, type), in the order of their bytes
    value: bool = False  # the text is an expression of type long, as of a bit-field

    def decode(self, data):
        if self.value:
            return [(self.locations[0][0], struct.unpack("<i", data)[0])]
        letters = "<" + "".join(LETTERS[kind] for _, kind in self.locations)
        return list(zip((name for name, _ in self.locations), struct.unpack(letters, data)))

    def row(self):
        """Of the table of what is shown; a value is no object, and has a statement instead."""
        return f"{{&({self.text}), sizeof({self.text})}},"

    def show(self):
        return f"{{ long value_ = ({self.text}); show(&value_, 4); }}"


def array(name, kind, count, text=None):
    return Observed(text or name, [(f"{name}[{i}]", kind) for i in range(count)])


@dataclasses.dataclass
class Step:
    """Locations set, in the names of scenarios and as statements of the AVR's program; then some cycles of 1 ms."""
    locations: dict
    statements: list
    cycles: int = 1
    unit: str = "ms"  # or fast, slow: so many of these
    power_cycle: bool = False  # before all else
    forced: dict = dataclasses.field(default_factory=dict)


@dataclasses.dataclass
class Program:
    name: str
    files: dict  # name of the file: text for plcxx; the first is the main source
    avr: str  # definitions; the parts are init_NAME, plc1_NAME, plc2_NAME
    steps: list
    observed: list
    faults: bool = True
    options: dict = dataclasses.field(default_factory=dict)
    settings: list = dataclasses.field(default_factory=list)  # the options, as statements of the AVR's program

    def driver(self):
        # The compiler takes a row of a table in a tenth of the time that a call costs it, and a program has 30 of them.
        rows = [f"static const struct shown shown_{self.name}[] = {{", *(o.row() for o in self.observed if not o.value),
                "{&fault_code, 2}, {&fault_count, 4}};", f"static void show_{self.name}(void)", "{",
                f"show_all(shown_{self.name}, sizeof shown_{self.name} / sizeof *shown_{self.name});",
                *(o.show() for o in self.observed if o.value), "}"]
        rows += [f"static void run_{self.name}(void)", "{", *self.settings, "power_on();"]
        for number, step in enumerate(self.steps):
            if step.power_cycle:
                rows += ["power_cycle();", *self.settings]
            # The first run step begins with init(), to which the parameters are there.
            rows += step.statements
            if number == 0 or step.power_cycle:
                rows += ["memcpy(P.uc, host.p, 200);", f"init_{self.name}();", "is_stopped(0);"]
            call = f"cycle(plc1_{self.name}, plc2_{self.name});"
            if step.unit == "ms":
                rows += [call] * step.cycles
            else:
                due = "was_due1" if step.unit == "fast" else "was_due2"
                rows.append(f"{{ int runs_ = 0; while (runs_ < {step.cycles}) {{ {call} runs_ += {due}; }} }}")
            rows.append(f"show_{self.name}();")
        return "\n".join(rows + ["}", ""])

    def blocks(self):
        """How many times it shows something."""
        return len(self.steps) * (len(self.observed) + 2)

    def read(self, blocks):
        """The values after each step; takes its blocks from the iterator."""
        result = []
        for _ in self.steps:
            values = [pair for o in self.observed if not o.value for pair in o.decode(next(blocks))]
            code, count = (struct.unpack(form, next(blocks))[0] for form in ("<h", "<i"))
            values += [pair for o in self.observed if o.value for pair in o.decode(next(blocks))]
            if self.faults:
                values += [("FAULT.code", code), ("FAULT.count", count)]
            result.append(values)
        return result

    def write(self, directory, values):
        """Sources and scenario; the scenario's path."""
        self.write_sources(directory)
        rows = ["dialect: hnc", f"sources: [{next(iter(self.files))}]"]
        rows += ["options: " + flow(self.options.items())] if self.options else []
        rows.append("steps:")
        for step, expected in zip(self.steps, values):
            if step.power_cycle:
                rows.append("- power_cycle: {}")
            if step.locations:
                rows.append("- set: " + flow(step.locations.items()))
            count = step.cycles * self.options.get("base-cycle", 1) if step.unit == "ms" else step.cycles
            rows += [f"- run: {{{step.unit}: {count}}}", "- expect: " + flow(expected)]
        path = directory / f"{self.name}.yaml"
        path.write_text("\n".join(rows) + "\n")
        return path

    def write_sources(self, directory):
        for name, text in self.files.items():
            (directory / name).write_text(text)


def flow(pairs):
    return "{" + ", ".join(f'"{name}": {value}' for name, value in pairs) + "}"


def run_on_avr(programs, directory, name, runner, level="-Os", cycles=avr.MOST_CYCLES):
    """The values of each program, in its order."""
    text = HEAD + "".join(p.avr + p.driver() for p in programs)
    text += "int main(void)\n{\n" + "".join(f"run_{p.name}();\n" for p in programs) + "stop();\nreturn 0;\n}\n"
    source = directory / f"{name}.c"
    source.write_text(text)
    blocks = avr.run(source, runner, level=level, cycles=cycles)
    expected = sum(p.blocks() for p in programs)
    if len(blocks) != expected:
        raise avr.NotRun(f"{source}: shows {len(blocks)} times instead of {expected}")
    rest = iter(blocks)
    return [p.read(rest) for p in programs]


def messages(plcxx, path):
    """What `plcxx check` says of a program, as (code, line, text); errors only."""
    result = children.run([plcxx, "check", "--diagnostics", "json", path], 300)
    if result.returncode > 1:
        return [("crash", 0, f"exit {result.returncode}: {result.stderr[-500:]}")]
    return [(m["code"], m["line"], m["message"]) for m in json.loads(result.stdout) if m["severity"] == "error"]


def test(plcxx, paths, engine, jobs=2):
    """Runs the scenarios in one call: those that failed, and all that was said."""
    try:
        result = children.run([plcxx, "test", "--engine", engine, "--jobs", jobs, *paths], SECONDS_BASE + SECONDS_EACH * len(paths))
        code, output = result.returncode, result.stdout + result.stderr
    except subprocess.TimeoutExpired as late:
        code, output = -1, f"plcxx: {late}\n"
    failed = [line.split()[1] for line in output.splitlines() if line.startswith("FAILED")]
    if code not in (0, 1) or (code == 1) != bool(failed):
        # One scenario ended the whole call.
        if len(paths) > 1:
            halves = [test(plcxx, half, engine, jobs) for half in (paths[:len(paths) // 2], paths[len(paths) // 2:])]
            return halves[0][0] + halves[1][0], halves[0][1] + halves[1][1]
        failed = [str(paths[0])]
    return failed, output
