"""Kinds of statements that no single golden program shows: many names, declarations and calls, faults, what is never closed.

A program of a kind whose name begins with `wrong-` may be refused, of any other one it is accepted.
"""


def nc110(text):
    return lambda n: "".join(text.format(a=i % 20, b=i % 32, c=i % 4, k=i % 200) + "\n" for i in range(n)) + "$\n"


HNC = '#include "plc.h"\nint i;\nvoid init(void) { plc1_time = 8; plc2_time = 16; }\n'


def hnc(text):
    return lambda n: (HNC + "void plc2(void) {}\nvoid plc1(void) {\n" +
                      "".join(text.replace("@", str(i % 100)) + "\n" for i in range(n)) + "}\n")


def hnc_expression(text):
    return lambda n: hnc(text)(n).replace("plc1(void) {\n", "plc1(void) {\ni = X[0]\n").replace("\n}\n", ";\n}\n")


def numbered(text):
    """With names of its own in each line."""
    return lambda n: (HNC + "void plc2(void) {}\nvoid plc1(void) {\n" +
                      "".join(text.replace("@", str(i)) + "\n" for i in range(n)) + "}\n")


def declared(text):
    """A line at file level, n times."""
    return lambda n: (HNC + "void plc1(void) {}\n" + (text + "\n") * n + "void plc2(void) {}\n")


def prostep(text):
    return lambda n: (":MOD PM 1\n" + "".join(text.format(a=i % 64, b=i % 8, c=i % 200) for i in range(n)) + ":END PM 1\n")


def host50(text):
    return lambda n: ("SLOW\nNETWORK\n" + "".join(text.format(b=i % 2000, w=i % 300, t=i % 100) for i in range(n)) +
                      "END_SLOW\n")


def technol(text):
    return lambda n: (" DATA\nF: DFM A,B,C,D\n DATA_END\n MODULE_MAIN\n" + "".join(text.format(i=i) for i in range(n)) +
                      " MODULE_MAIN_END\n STOP\n")


def nests(loop, back, deep):
    """Loops one in the other, so deep, again and again; what begins a loop and what ends it, with its name."""
    def lines(n):
        names = [f"N{i:X}" for i in range(n // 4)]
        return "".join("".join(loop.format(l=name) for name in names[i:i + deep]) +
                       "".join(back.format(l=name) for name in reversed(names[i:i + deep])) for i in range(0, len(names), deep))
    return lines


def jumps_anywhere(n):
    return (" DATA\nF: DFM A,B,C,D\n DATA_END\n MODULE_MAIN\n" +
            "".join(f"L{i}: LDR A\n WR B\n LDR C\n JL1 L{(i * 7919 + 13) % n}\n" for i in range(n)) + " MODULE_MAIN_END\n STOP\n")


def waits(n):
    """With a jump from one into another one that is not the next: the choice among them has a label for each."""
    return (" DATA\nF: DFM A,B,C,D\n DATA_END\n MECH_BEGIN M\n LDR A\n JL1 LATE\n" + " EX\n" * n + "LATE: EX\n MECH_END M\n" +
            " MODULE_MAIN\n LDR A\n FL 1,M\n MODULE_MAIN_END\n STOP\n")


def entries(n):
    """Subprograms of which each runs on into the next one: more than a byte has numbers for."""
    return technol(" CALL S{i}\n")(n).replace(" STOP\n", "".join(f"S{i}: LDR A\n WR B\n" for i in range(n)) + " RET\n STOP\n")


def classicladder(row, expression=""):
    """Rungs with this row, n lines in all, each with an expression where there is one."""
    def program(n):
        rungs = range(max(1, n // 5))
        parts = {"general.txt": "".join(f"SIZE_NBR_{what}=10000\n" for what in ("RUNGS", "BITS", "ARITHM_EXPR")),
                 "sections.csv": f"000,0,-1,0,{rungs[-1]},0\n"}
        if expression:
            parts["arithmetic_expressions.csv"] = "".join(f"{i:04d},{expression.format(w=i % 20)}\n" for i in rungs)
        for i in rungs:
            after = i + 1 if i < rungs[-1] else -1
            parts[f"rung_{i}.csv"] = f"#LABEL=L{i}\n#NEXTRUNG={after}\n{row.format(i=i, b=i % 10000)}\n"
        return ("_FILES_CLASSICLADDER\n" +
                "".join(f"_FILE-{name}\n{text}_/FILE-{name}\n" for name, text in parts.items()) + "_/FILES_CLASSICLADDER\n")
    return program


KINDS = {
    "classicladder": (".clp", {
        "rung": classicladder("1-0-50/1 , 2-0-0/{b} , 9-0-0/0 , 50-0-0/{b}"),
        "edge": classicladder("3-0-50/1 , 52-0-0/{b}"),
        "jump": classicladder("1-0-50/1 , 54-0-0/0"),
        "expression": classicladder("99-0-0/0 , 99-0-0/0 , 20-0-0/{i} , 50-0-0/{b}", "@200/{w}@+1>@200/3@*2"),
        "wrong-element": classicladder("1-0-50/1 , 77-0-0/0 , 50-0-0/{b}"),
    }),
    "nc110": (".plc", {
        "assignment": nc110("U{a}A{b}=I{a}A{b}*I1A1"),
        "word": nc110("W{a}A{c}=[W{a}A{c}+1]"),
        "comparator": nc110("U{a}A{b}=[W{a}A{c}<W1K0]"),
        "block": nc110("DOF:I{a}A{b}\nU{a}K{b}=I0A0\nENDF"),
        "chain": nc110("DOF:I{a}A{b}\nU{a}K{b}=I0A0\nENDF\nDOE:I0A1\nU{a}K{b}=0\nENDE"),
        "timer": nc110("T{k}I(5)=I{a}A{b}"),
        "mux": nc110("W{a}K{c}=MUX(W1K0,W1K1),(I0A0,I0A1)"),
        "comment": nc110("; text {k}\nU{a}A{b}=I{a}A{b}"),
        "one-expression": lambda n: "U0A0=I0A0" + "*I1A1+I2A2" * (min(n, 1000) // 2) + "\n$\n",
        "wrong-word": nc110("U{a}A{b}=NOSUCH{k}"),
        "wrong-unclosed": nc110("U{a}A{b}=(I0A0"),
    }),
    "host50": (".il", {
        "rung": host50("LD %I1\nAND %B{b}\nOUT %B{b}\n"),
        "word": host50("LD %I1\nMOV %W{w}, %W1\n"),
        "operation": host50("LD %I1\nOPRT %W{w} = %W1 + 1\n"),
        "one-expression": lambda n: host50("AND %I{b}\nOR %B{w}\n")(n // 2)
                          .replace("NETWORK\n", "NETWORK\nLD 1\n").replace("END_SLOW", "OUT %B0\nEND_SLOW"),
        "wrong-word": host50("LD %I1\nNOSUCH %W{w}\n"),
        "subroutine": lambda n: ("SLOW\nNETWORK\nLD 1\n" + "".join(f"CALL SR{i % 90}\n" for i in range(n)) + "END_SLOW\n" +
                                 "".join(f"SUB SR{i}\nNETWORK\nLD %I1\nOUT %B{i}\nEND_SUB\n" for i in range(90))),
    }),
    "prostep": (".plc", {
        "bit": prostep(":A I {a}.{b}\n:= O {a}.{b}\n"),
        "one-expression": lambda n: prostep(":A I {a}.{b}\n:O O {a}.{b}\n")(n // 2).replace(":END", ":= O 0.0\n:END"),
        "wrong-word": prostep(":NOSUCH I {a}.{b}\n"),
        "branch": lambda n: (":MOD PM 1\n" + "".join(f":A I 0.0\n:JC L{i:03X}\n:A I {i % 64}.1\n:= O {i % 64}.1\nL{i:03X} :A I 0.1\n"
                                                    f":S O 1.1\n" for i in range(min(n, 4096))) + ":END PM 1\n"),
        "loops-in-each-other": lambda n: (":MOD PM 1\n" + nests("{l} :A I 0.1\n:= O 0.1\n", ":A F 7.1\n:JC {l}\n", 300)(n) +
                                          ":END PM 1\n"),
    }),
    "technol": (".plc", {
        "mechanism": technol(" MECH_BEGIN M{i}\n EX\n LDR A\n FL 1,B\n MECH_END M{i}\n"),
        "wrong-unclosed": technol(" MECH_BEGIN M{i}\n EX\n"),
        "label": technol("L{i}: LDR A\n JL1 L{i}\n"),
        "loops-in-each-other": lambda n: (" DATA\nWA: DS 2\n DATA_END\n MODULE_MAIN\n" +
                                          nests("L{l}: INC WA\n", " DEC WA\n JNZ L{l}\n", 300)(n) + " MODULE_MAIN_END\n STOP\n"),
        "jumps-anywhere": lambda n: jumps_anywhere(min(n // 4, 600)),
        "waits": lambda n: waits(n // 8),  # a report of it grows with the square: each wait is inside all that follow
        "entries": lambda n: entries(min(n // 3, 600)),
        "macro": lambda n: ("M MACRO X\n LDR X\n WR B\nENDM\n" + technol(" M A\n")(n)),
        "data": lambda n: (" DATA\nF: DFM A,B,C,D\n" + "".join(f"D{i}: DS 1\n" for i in range(n // 2)) + " DATA_END\n MODULE_MAIN\n" +
                           "".join(f" LOD D{i}\n STO D{i}\n" for i in range(n // 2)) + " MODULE_MAIN_END\n STOP\n"),
        "one-expression": lambda n: technol(" LA A\n LO B\n")(n // 2).replace(" MODULE_MAIN\n", " MODULE_MAIN\n LDR C\n")
                          .replace(" MODULE_MAIN_END", " WR D\n MODULE_MAIN_END"),
        "wrong-word": technol(" NOSUCH A{i}\n"),
    }),
    "hnc": (".cld", {
        "assignment": hnc("Y[@] = X[@];"),
        "if": hnc("if (X[@] & 1) Y[@] = 1; else Y[@] = 2;"),
        "jump": numbered("if (X[0]) goto l@; i = 1; l@: ;"),
        "jump-back": numbered("l@: i++; if (i < 3) goto l@;"),
        "byte-loop": hnc("for (i = 0; i < (X[@] & 15); i++) Y[1] = i;"),
        "loop": hnc("for (i = 0; i < 3; i++) Y[i] = X[@];"),
        "one-expression": hnc_expression("+ X[@]"),
        "one-condition": hnc_expression("&& X[@]"),
        "one-choice": hnc_expression("+ (X[@] ? 3 : X[1])"),
        "wrong-word": hnc("nosuch@ = 1;"),
        "wrong-function-again": declared("void f(void) {}"),
        "wrong-entry-again": declared("void plc2() { }"),
        "wrong-prototype-again": declared("void f(void);"),
        "wrong-variable-again": declared("int v;"),
        "wrong-external-again": declared("extern int v;"),
        "wrong-value-again": declared("int v = 1;"),
        "wrong-structure-again": declared("struct t;"),
        "wrong-type-again": declared("typedef int t;"),
        "wrong-no-type": declared("byte v;"),
        "wrong-local-again": hnc("int v;"),
        "wrong-label-again": hnc("again: i = 1;"),
        "function": lambda n: (HNC + "".join(f"void f{i}(void) {{ Y[{i % 100}] = {i % 200}; }}\n" for i in range(n)) +
                               "void plc2(void) {}\nvoid plc1(void) {\n" + "".join(f"f{i}();\n" for i in range(n)) + "}\n"),
        "variable": lambda n: (HNC + "".join(f"int v{i};\n" for i in range(n // 4)) + "void plc2(void) {}\nvoid plc1(void) {\n" +
                               "".join(f"v{i}++;\n" for i in range(n // 4)) + "}\n"),
        "wrong-cases": lambda n: (HNC + "void plc2(void) {}\nvoid plc1(void) {\nswitch (i) {\n" +
                                  "".join(f"case {i}:\n" for i in range(n)) + ";\n}\n}\n"),
        "wrong-cases-with-breaks": lambda n: (HNC + "void plc2(void) {}\nvoid plc1(void) {\nswitch (i) {\n" +
                                              "".join(f"case {i}: Y[1] = {i % 100}; break;\n" for i in range(n)) + "}\n}\n"),
        "macro": lambda n: (HNC + "".join(f"#define M{i} {i % 100}\n" for i in range(n)) + "void plc2(void) {}\nvoid plc1(void) {\n" +
                            "".join(f"Y[1] = M{i};\n" for i in range(n)) + "}\n"),
    }),
}
