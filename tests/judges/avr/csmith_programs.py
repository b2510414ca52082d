"""Programs that Csmith makes, through both: a generator that nobody here wrote. One text for both compilers.

Csmith spells each operation that C leaves undefined somewhere as a call (safe_add_func_int16_t_s_s); what such a call is
changes from program to program: the operator with its operands cast, the operator alone, or a function. What no program of
this control may have (a loop without a proof gets a bound; arrays of pointers, addresses of locals that stay) is left out.
"""
import collections
import random
import re
import subprocess
import time

import avr
from program import Observed, Program, Step, array, messages, run_on_avr, test

SHOWN = 300
ROUNDS = 40
TYPES = {"int8_t": "signed char", "uint8_t": "unsigned char", "int16_t": "int", "uint16_t": "unsigned", "int32_t": "long",
         "uint32_t": "unsigned long"}
OPERATORS = {"add": "+", "sub": "-", "mul": "*", "div": "/", "mod": "%", "lshift": "<<", "rshift": ">>"}
FOR_AVR = {"/": "CS_DIV({}, {})", "%": "CS_MOD({}, {})", "<<": "CS_SHL({}, {})", ">>": "CS_SHR({}, {})"}
ALWAYS = ["--no-longlong", "--no-math64", "--no-argc", "--no-volatile-pointers", "--concise", "--quiet", "--no-inline-function",
          "--max-pointer-depth", "1", "--strict-volatile-rule", "--no-packed-struct"]
# What is in a program; a unit of bit-fields is laid out in another way by avr-gcc, so that no union may show it.
KINDS = [["--no-pointers", "--no-unions", "--bitfields"], ["--no-pointers", "--no-bitfields"], ["--no-arrays", "--no-unions", "--no-structs"],
         ["--no-pointers", "--no-unions", "--no-bitfields", "--no-volatiles", "--no-consts"], ["--no-arrays", "--no-unions", "--bitfields"],
         ["--no-pointers", "--no-structs", "--no-unions"]]
LEVELS = ("-O0", "-O1", "-Os", "-O2")
SAFE = re.compile(r"\bsafe_(unary_minus|add|sub|mul|div|mod|lshift|rshift)_func_(u?int\d+_t)_[su](?:_[su])?\b")
LABEL = re.compile(r"^(lbl_\d+):")
JUMP = re.compile(r"^\s*goto (lbl_\d+);$")
LOOP = re.compile(r"^(\s*)for \((.*)\)$")
# The operators as 6.2 defines them, each operand evaluated once and spelled once.
PRELUDE = """
#define CS_ONCE(a, b, of, name) ({ __auto_type a_ = (a) + 0; __auto_type b_ = (b) + 0; OF_TYPE(of, name)(a_, b_); })
#define CS_DIV(a, b) CS_ONCE(a, b, a_ + b_, divide)
#define CS_MOD(a, b) CS_ONCE(a, b, a_ + b_, rest)
#define CS_SHL(a, b) CS_ONCE(a, (unsigned char)(b), a_, left)
#define CS_SHR(a, b) CS_ONCE(a, (unsigned char)(b), a_, right)
static unsigned rounds_[200];
#define CS_BOUND(n, most) (rounds_[n]++ < (most) || (fault(3), 0))
"""


def made_by_csmith(seed, directory):
    choice = random.Random(seed)
    (directory / "platform.info").write_text("integer size = 2\npointer size = 2\n")
    words = ["csmith", "--seed", str(seed), *ALWAYS, *KINDS[seed % len(KINDS)]]
    for name, least, most in (("max-funcs", 2, 6), ("max-block-depth", 2, 4), ("max-block-size", 2, 6), ("max-expr-complexity", 3, 10),
                              ("max-array-len-per-dim", 2, 6), ("max-array-dim", 1, 2)):
        words += [f"--{name}", str(choice.randint(least, most))]
    if choice.random() < 0.6:
        words.append("--no-jumps")
    made = subprocess.run(words, cwd=directory, capture_output=True, text=True, timeout=60, check=False)
    return made.stdout if made.returncode == 0 else None


def parts_of_loop(header):
    """The three expressions between the parentheses of a for, or none."""
    depth, parts, start = 0, [], 0
    for at, c in enumerate(header):
        depth += (c in "([{") - (c in ")]}")
        if c == ";" and depth == 0:
            parts.append(header[start:at])
            start = at + 1
    return [*parts, header[start:]] if len(parts) == 2 else None


def meaning(name, operation, kind, style, for_avr):
    """What stands for a call of Csmith's arithmetic."""
    if operation == "unary_minus":
        return f"#define {name}(a) " + ("(-(a))" if style == 1 else f"(({kind})(-({kind})(a)))")
    operator = OPERATORS[operation]
    second = "int" if "shift" in operation else kind
    spell = FOR_AVR.get(operator, "({} " + operator + " {})") if for_avr else "({} " + operator + " {})"
    if style == 2:
        return f"static {kind} {name}({kind} a, {second} b) {{ return " + spell.format("a", "b") + "; }"
    if style == 1:
        return f"#define {name}(a, b) " + spell.format("(a)", "(b)")
    return f"#define {name}(a, b) (({kind})" + spell.format(f"({kind})(a)", f"({second})(b)") + ")"


def both_texts(text, seed, bounded):
    """For plcxx and for avr-gcc. Loops whose line is in `bounded` get their bound."""
    choice = random.Random(seed + 1)
    text = re.sub(r"^#include.*|^#define NO_LONGLONG|^static long __undefined;|^//.*", "", text, flags=re.M)
    text = re.sub(r"\n{2,}", "\n", text)
    head, _, main = text.partition("int main (void)")
    main = re.sub(r"int print_hash_value.*|platform_main_\w+\(.*|crc32_gentab.*|return 0;|if \(print_hash_value\).*", "", main)
    if choice.random() < 0.5:  # constants of their natural types
        head = re.sub(r"\b(0x[0-9A-F]+|\d+)(?:L|UL)\b", r"\1", head)
    texts = []
    used = sorted(set(m.group(0) for m in SAFE.finditer(text)))
    styles = {name: choice.choice((0, 0, 1, 1, 2)) for name in used}
    for for_avr in (False, True):
        rows = [f"typedef {kind} {name};" for name, kind in TYPES.items()]
        rows += [meaning(name, *SAFE.fullmatch(name).groups(), styles[name], for_avr) for name in used]
        rows += [f"long shown[{SHOWN}]; int shows;", "#define transparent_crc(v, name, flag) do { if (shows < 300) shown[shows++] = (v); } while (0)"]
        for number, row in enumerate((head + ("plc1()" if not for_avr else f"static void plc1_cs{seed}(void)") + main).splitlines()):
            loop = LOOP.match(row)
            parts = parts_of_loop(loop[2]) if loop and number in bounded else None
            if parts and for_avr:
                row = f"{loop[1]}for (rounds_[{bounded.index(number)}] = 0, {parts[0]}; ({parts[1]}) && CS_BOUND({bounded.index(number)}, {ROUNDS}); {parts[2]})"
            elif parts:
                row = f"/*@loop_bound {ROUNDS}@*/ {row.strip()}"
            label, jump = LABEL.match(row), JUMP.match(row)
            if label and label[1] in bounded:
                row = (f"rounds_[{bounded.index(label[1])}] = 0; " if for_avr else f"/*@loop_bound {ROUNDS}@*/ ") + row
            elif jump and jump[1] in bounded and for_avr:
                row = f"if (CS_BOUND({bounded.index(jump[1])}, {ROUNDS - 1})) {row}"
            rows.append(row)
        texts.append("\n".join(rows) + "\n")
    parts = ("void init() { plc1_time = 1; plc2_time = 1; }\n", "void plc2() { }\n")
    plc = '#include "plc.h"\n' + parts[0] + texts[0] + parts[1]
    first = plc.count("\n", 0, plc.index("#define transparent_crc")) + 2  # the line of row 0 of Csmith's text
    avr_text = PRELUDE + texts[1] + f"static void init_cs{seed}(void) {{ plc1_time = 1; plc2_time = 1; }}\nstatic void plc2_cs{seed}(void) {{ }}\n"
    return plc, avr_text, first


def program_of(plcxx, seed, directory):
    """The program, or the code for which the language has not taken it."""
    text = made_by_csmith(seed, directory)
    if text is None:
        return "csmith"
    bounded = []
    for _ in range(6):
        plc, avr_text, first = both_texts(text, seed, bounded)
        path = directory / f"cs{seed}.cld"
        path.write_text(plc)
        found = messages(plcxx, str(path))
        if not found:
            return Program(f"cs{seed}", {f"cs{seed}.cld": plc}, avr_text, [Step({}, [])],
                           [array("shown", "long", SHOWN), Observed("shows", [("shows", "int")])])
        if any(code == "crash" for code, _, _ in found):
            return "crash " + found[0][2]
        other = [code for code, line, _ in found if code != "hnc-E032"]
        if other:
            return other[0]
        rows = plc.splitlines()
        for line in {line for _, line, _ in found}:
            jump = JUMP.match(rows[line - 1])
            new = jump[1] if jump else line - first
            # Another jump to the label would enter the loop without counting anew.
            if new in bounded or (plc.count(f"goto {new};") != 1 if jump else not LOOP.match(rows[line - 1])):
                return "hnc-E032"
            bounded.append(new)
    return "hnc-E032"


def judge(plcxx, runner, directory, seeds, engine, jobs, keep, report):
    """The number of programs that failed."""
    programs = values = failed_programs = 0
    refused = collections.Counter()
    said = time.monotonic()
    try:
        for seed in seeds:
            program = program_of(plcxx, seed, directory)
            if isinstance(program, str):
                refused[program[:30]] += 1
                if program.startswith("crash"):
                    report(f"FAILED cs{seed}: {program}")
                    failed_programs += 1
                continue
            try:
                found = run_on_avr([program], directory, program.name, runner, LEVELS[seed // 6 % len(LEVELS)])
            except avr.NotRun as error:
                refused["avr: " + str(error).splitlines()[0][-60:]] += 1
                continue
            path = program.write(directory, found[0])
            failed, output = test(plcxx, [path], engine, jobs)
            programs += 1
            values += found[0][0][-3][1] if found[0][0][-3][0] == "shows" else 0
            if failed:
                failed_programs += 1
                report(f"FAILED {path}\n" + "\n".join(output.splitlines()[:12]))
            elif not keep:
                for end in ("yaml", "cld", "c", "elf"):
                    (directory / f"{program.name}.{end}").unlink(missing_ok=True)
            if time.monotonic() - said >= 60:
                said = time.monotonic()
                report(f"{programs} programs, {values} values, {failed_programs} failed; left out {dict(refused)}")
    except KeyboardInterrupt:
        report("stopped before its end")
    report(f"{programs} programs of Csmith, {values} values, {failed_programs} programs failed; left out {dict(refused)}")
    return failed_programs
