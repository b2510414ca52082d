"""Changes of one instruction in a compiler's assembler: the wrong code that a compiler, a linker or a memory fault could
make, and that must not be proved."""
import re

INVERSE = {"eq": "ne", "ne": "eq", "lt": "ge", "ge": "lt", "ltu": "geu", "geu": "ltu", "gtu": "leu", "leu": "gtu", "gt": "le",
           "le": "gt", "cs": "cc", "cc": "cs", "mi": "pl", "pl": "mi", "hi": "ls", "ls": "hi", "vs": "vc", "vc": "vs"}
OTHER_SIGN = {"lt": "ltu", "ge": "geu", "ltu": "lt", "geu": "ge", "gtu": "gt", "leu": "le", "gt": "gtu", "le": "leu"}
ARM_SIGN = {"lt": "cc", "ge": "cs", "cc": "lt", "cs": "ge", "hi": "gt", "ls": "le", "gt": "hi", "le": "ls", "mi": "lt", "pl": "ge"}
CONDITION = "eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le"


def plus(number, by=1):
    return str(int(number, 0) + by)


def name(words):
    """A mnemonic for another one."""
    table = dict(words)
    return lambda m: "\t" + table[m.group(1)] + m.group(2)


def mnemonics(*pairs):
    table = {}
    for a, b in pairs:
        table[a], table[b] = b, table.get(b, a)
    return rf"\t({'|'.join(re.escape(a) for a in table)})(\t.*)", name(table)


def lines(*all):
    """A line for several."""
    return "\n".join("\t" + one.replace(" ", "\t", 1) if not one.endswith(":") else one for one in all)


def another_function(m):
    """The same call, m[1], of another function than m[2]."""
    return f"\t{m[1]}\t" + {
        "read_inputs": "_ZN6turret13write_outputsERNS_4HostERKNS_5StateE",
        "write_outputs": "_ZN6turret11read_inputsERNS_4HostERNS_5StateE",
        "fast": "_ZN6turret4initERNS_5StateERNS_4HostE",
        "now_ms": "_ZN6turret11read_inputsERNS_4HostERNS_5StateE"}[m[2]]


# (what, pattern of a whole line, line from the match)
RISCV = [
    ("branch inverted", r"\tb(\w+?)(z?)(\t.*)", lambda m: f"\tb{INVERSE[m[1]]}{m[2]}{m[3]}" if m[1] in INVERSE else None),
    ("branch by the other sign", r"\tb(\w+?)(\t.*)", lambda m: f"\tb{OTHER_SIGN[m[1]]}{m[2]}" if m[1] in OTHER_SIGN else None),
    ("another operation", *mnemonics(("add", "sub"), ("and", "or"), ("xor", "or"), ("andi", "ori"), ("xori", "ori"),
                                     ("seqz", "snez"), ("sltu", "slt"), ("sgtu", "sgt"), ("sltiu", "slti"), ("srai", "srli"),
                                     ("sra", "srl"), ("srl", "sra"), ("sll", "srl"), ("slli", "srli"), ("div", "divu"),
                                     ("rem", "remu"), ("mul", "mulhu"), ("mulh", "mulhu"), ("neg", "mv"), ("not", "mv"))),
    ("operands swapped", r"\t(sub|sltu|sgtu|slt|sll|srl|sra|div\w*|rem\w*)\t(\w+),(\w+),(\w+)",
     lambda m: f"\t{m[1]}\t{m[2]},{m[4]},{m[3]}"),
    ("another number", r"\t(li|addi|andi|ori|xori|sltiu|slti|slli|srli|srai)\t(.*),(-?\w+)",
     lambda m: f"\t{m[1]}\t{m[2]},{plus(m[3])}"),
    ("another width or sign", *mnemonics(("lb", "lbu"), ("lh", "lhu"), ("lw", "lh"), ("sb", "sh"), ("sw", "sh"))),
    ("another place", r"\t(lbu?|lhu?|lw|sb|sh|sw)\t(\w+),(-?\d+)\((\w+)\)",
     lambda m: f"\t{m[1]}\t{m[2]},{plus(m[3], {'b': 1, 'h': 2, 'w': 4}[m[1][1]])}({m[4]})"),
    ("another value stored", r"\t(s[bhw])\t(\w+),(-?\d+\(a0\))",
     lambda m: f"\t{m[1]}\t{'a1' if m[2] != 'a1' else 'a2'},{m[3]}"),
    ("store dropped", r"\ts[bhw]\t.*", lambda m: "\tnop"),
    ("load dropped", r"\tl[bhw]u?\t.*", lambda m: "\tnop"),
    ("move dropped", r"\tmv\t.*", lambda m: "\tnop"),
    ("call dropped", r"\t(?:call|tail)\t.*", lambda m: "\tnop"),
    ("another function called", r"\t(call|tail)\t.*(read_inputs|write_outputs|fast|now_ms).*", another_function),
    ("a function's middle called", r"\t(call|tail)\t(\w+)", lambda m: f"\t{m[1]}\t{m[2]}+4"),
    ("another register saved", r"\tsw\t(s0|ra),(\d+\(sp\))", lambda m: f"\tsw\t{'s1' if m[1] == 's0' else 's0'},{m[2]}"),
    ("another register restored", r"\tlw\t(s0|ra),(\d+\(sp\))", lambda m: f"\tlw\t{'s1' if m[1] == 's0' else 's0'},{m[2]}"),
    ("saved below the stack", r"\tsw\t(\w+),(\d+)\(sp\)", lambda m: f"\tsw\t{m[1]},-{m[2]}(sp)"),
    ("a kept register used", r"\tli\t(a[45]),(.*)", lambda m: f"\tli\ts5,{m[2]}\n\tmv\t{m[1]},s5"),
    ("another stack pointer at a call", r"\tcall\t(.*(?:now_ms|memset).*)",
     lambda m: lines("addi sp,sp,-4", "call " + m[1], "addi sp,sp,4")),
    ("another global pointer at a call", r"\tcall\t(.*now_ms.*)",
     lambda m: lines("addi sp,sp,-16", "sw gp,0(sp)", "li gp,5", "call " + m[1], "lw gp,0(sp)", "addi sp,sp,16")),
    ("another thread pointer at a call", r"\tcall\t(.*now_ms.*)",
     lambda m: lines("addi sp,sp,-16", "sw tp,0(sp)", "li tp,5", "call " + m[1], "lw tp,0(sp)", "addi sp,sp,16")),
    ("a label called as the library's function", r"\tcall\tmemset",
     lambda m: lines("call memset", '.pushsection .text.judge,"ax"', "memset:", "ret", ".popsection")),
    ("bytes that the linker takes away", r"\tand\t(a[2-5]),\1,(a[2-5])",
     lambda m: lines(".reloc ., R_RISCV_ALIGN, 2", f"and {m[1]},{m[1]},{m[2]}")),
    ("a word below the stack", r"\tand\t(a[2-5]),\1,(a[2-5])",
     lambda m: lines(f"and {m[1]},{m[1]},{m[2]}", "addi t3,sp,-8", f"sw {m[1]},0(t3)", "j 1f", "1:", f"lw {m[1]},0(t3)")),
]

ARM = [
    ("branch inverted", rf"\tb({CONDITION})(\t.*)", lambda m: f"\tb{INVERSE[m[1]]}{m[2]}"),
    ("branch by the other sign", rf"\tb({CONDITION})(\t.*)", lambda m: f"\tb{ARM_SIGN[m[1]]}{m[2]}" if m[1] in ARM_SIGN else None),
    ("branch by zero inverted", *mnemonics(("cbz", "cbnz"))),
    ("another operation", *mnemonics(("adds", "subs"), ("add", "sub"), ("ands", "orrs"), ("and", "orr"), ("eor", "orr"),
                                     ("eors", "orrs"), ("bic", "and"), ("bics", "ands"), ("mvn", "mov"), ("mvns", "movs"),
                                     ("rsb", "sub"), ("rsbs", "subs"), ("adc", "add"), ("sbc", "sub"), ("cmp", "cmn"),
                                     ("tst", "teq"), ("lsl", "lsr"), ("lsls", "lsrs"), ("asr", "lsr"), ("asrs", "lsrs"),
                                     ("ror", "lsr"), ("udiv", "sdiv"), ("umull", "smull"), ("mla", "mls"), ("mul", "and"))),
    ("flags not set", r"\t(add|sub|and|orr|eor|lsl|lsr|asr)s(\t.*)", lambda m: f"\t{m[1]}.w{m[2]}"),
    ("flags set", r"\t(add|sub|and|orr|eor|ubfx|lsl|lsr|asr|bic|mov)(\t.*)", lambda m: f"\t{m[1]}s{m[2]}"),
    ("operands swapped", r"\t(subs?|cmp|rsbs?|lsls?|lsrs?|asrs?|udiv|sdiv)\t(?:(\w+), )?(\w+), (\w+)$",
     lambda m: f"\t{m[1]}\t{m[2] + ', ' if m[2] else ''}{m[4]}, {m[3]}"),
    ("another number", r"\t(\w+)\t(.*), #(-?\w+)$", lambda m: f"\t{m[1]}\t{m[2]}, #{plus(m[3])}"),
    ("another shift", r"\t(\w+)\t(.*), (lsl|lsr|asr) #(\d+)$", lambda m: f"\t{m[1]}\t{m[2]}, {m[3]} #{plus(m[4])}"),
    ("another field", r"\t(ubfx|sbfx|bfi|bfc)(\t.*)#(\d+), #(\d+)", lambda m: f"\t{m[1]}{m[2]}#{m[3]}, #{plus(m[4])}"),
    ("another width or sign", *mnemonics(("ldrb", "ldrsb"), ("ldrh", "ldrsh"), ("ldr", "ldrh"), ("strb", "strh"), ("str", "strh"),
                                         ("uxtb", "sxtb"), ("uxth", "sxth"), ("ubfx", "sbfx"))),
    ("another place", r"\t(ldr\w*|str\w*)\t(\w+), \[(\w+), #(-?\d+)\](.*)",
     lambda m: f"\t{m[1]}\t{m[2]}, [{m[3]}, #{plus(m[4], 1 if 'b' in m[1] else 2 if 'h' in m[1] else 4)}]{m[5]}"),
    ("another value stored", r"\t(strb?|strh)\t(\w+), (\[r0, .*)", lambda m: f"\t{m[1]}\t{'r1' if m[2] != 'r1' else 'r2'}, {m[3]}"),
    ("pair swapped", r"\t(ldrd|strd)\t(\w+), (\w+), (.*)", lambda m: f"\t{m[1]}\t{m[3]}, {m[2]}, {m[4]}"),
    ("store dropped", r"\tstr\w*\t.*", lambda m: "\tnop"),
    ("load dropped", r"\tldr\w*\t.*", lambda m: "\tnop"),
    ("move dropped", r"\tmov\t.*", lambda m: "\tnop"),
    ("comparison dropped", r"\t(?:cmp|tst|cmn)\t.*", lambda m: "\tnop"),
    ("call dropped", r"\tbl?\t_Z.*", lambda m: "\tnop"),
    ("another function called", r"\t(bl?)\t_Z.*(read_inputs|write_outputs|fast|now_ms).*", another_function),
    ("a function's middle called", r"\t(bl?)\t(_Z\w+)", lambda m: f"\t{m[1]}\t{m[2]}+4"),
    ("a list without a register", r"\t(push|pop|ldm\w*|stm\w*)\t(.*)\{(\w+), (.*)\}(.*)", lambda m: f"\t{m[1]}\t{m[2]}{{{m[4]}}}{m[5]}"),
    ("another list", r"\t(push|pop|ldm\w*|stm\w*)\t(.*)\{(.*)r4(.*)\}(.*)", lambda m: f"\t{m[1]}\t{m[2]}{{{m[3]}r8{m[4]}}}{m[5]}"),
    ("a kept register used", r"\tmovs?\t(r[0-3]), #(.*)", lambda m: f"\tmov\tr9, #{m[2]}\n\tmov\t{m[1]}, r9"),
    ("constants between instructions", r"\tands\tr([0-3]), r\1, r([0-3])",
     lambda m: lines(f"ands r{m[1]}, r{m[1]}, r{m[2]}", f".short {0x2000 + 256 * int(m[1]):#x}")),
    ("another stack pointer at a call", r"\tbl\t(.*(?:now_ms|memset).*)",
     lambda m: lines("sub sp, sp, #4", "bl " + m[1], "add sp, sp, #4")),
    ("half a word off the stack at a call", r"\tbl\t(.*now_ms.*)",
     lambda m: lines("sub sp, sp, #2", "bl " + m[1], "add sp, sp, #2")),
    ("a word below the stack", r"\tands\t(r[0-3]), \1, (r[0-3])",
     lambda m: lines(f"ands {m[1]}, {m[1]}, {m[2]}", "sub r12, sp, #8", f"str {m[1]}, [r12]", "b 1f", "1:", "b 1f", "1:",
                     f"ldr {m[1]}, [r12]")),
]


def invert_block(lines, at):
    """An IT block under the other condition; none: there is no block."""
    found = re.fullmatch(rf"\ti(t[te]*)\t({CONDITION})", lines[at])
    if found is None:
        return None
    changed = [f"\ti{found[1]}\t{INVERSE[found[2]]}"]
    left = len(found[1])
    for line in lines[at + 1:]:
        if left == 0:
            return changed
        if line.startswith("\t") and not line.startswith(("\t.", "\t@")):
            inner = re.fullmatch(rf"\t(\w+?)({found[2]}|{INVERSE[found[2]]})(\.w)?(\t.*)", line)
            if inner is None:
                return None
            line = f"\t{inner[1]}{INVERSE[inner[2]]}{inner[3] or ''}{inner[4]}"
            left -= 1
        changed.append(line)
    return None


def stores_exchanged(lines, at):
    """What two stores in a row write is exchanged between their places."""
    pattern = r"\t(sb|sh|sw|strb|strh|str)\t(\w+)(,.*)"
    a = re.fullmatch(pattern, lines[at])
    b = re.fullmatch(pattern, lines[at + 1]) if at + 1 < len(lines) else None
    if a is None or b is None or a[1] != b[1] or a[2] == b[2]:
        return None
    return [f"\t{a[1]}\t{b[2]}{a[3]}", f"\t{b[1]}\t{a[2]}{b[3]}"]


def changes(lines, is_arm):
    """(what, number of the line, lines that stand there instead), each alone."""
    for at, line in enumerate(lines):
        bare = re.sub(r"\s*[@#] .*$", "", line) if is_arm else line
        for what, pattern, change in ARM if is_arm else RISCV:
            found = re.fullmatch(pattern, bare)
            other = change(found) if found else None
            if other is not None and other != bare:
                yield what, at, [other], 1
        if is_arm:
            block = invert_block(lines, at)
            if block is not None:
                yield "a block under the other condition", at, block, len(block)
        pair = stores_exchanged(lines, at)
        if pair is not None:
            yield "values exchanged", at, pair, 2
