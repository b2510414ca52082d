"""The command lines that a case goes through: each subcommand, in every form of its output.

A command is its words and whether its output is messages (safe for a terminal) or data.
"""
PHASES = ("source", "tokens", "syntax", "ir", "ir-structured", "ir-optimized", "ir-emittable", "cpp")
TABLES = ("--print-symbols", "--cross-reference", "--cost-listing", "--resources", "--lists")
FLAVOURS = ([], ["--debug"], ["--single-file"], ["--line-directives"], ["--preemptive"], ["--parts", "3"])
FORMS = ("text", "json", "sarif")


def program(case):
    words = [name if not name.startswith("-") else "./" + name for name in case.sources] + ["--dialect", case.dialect]
    for option in case.options:
        key, _, value = option.partition("=")
        if key == "encoding":
            words += ["--encoding", value]
        elif key == "system-include":
            words += ["--system-include", value]
        else:
            words += ["--set", option]
    return words


def of(case):
    """(words, output is messages, seconds)"""
    base = program(case)
    for form in FORMS:
        yield ["check", *base, "--diagnostics", form], True, 20
    yield ["check", *base, "--preemptive", "--max-messages", "3"], True, 20
    for flavour in FLAVOURS:
        yield ["emit", *base, "-o", "out", *flavour], True, 20
    for phase in PHASES:
        yield ["print", phase, *base], False, 20
    for table in TABLES:
        yield ["report", *base, table], True, 20
    yield ["report", *base, "-o", "out"], True, 20
    yield ["report", *base, "-o", "-"], False, 20
    yield ["report", *base, "--ladder", "-o", "-"], False, 20
    yield ["sim", *base, "--for", "200ms", "--time-limit", "5"], True, 20
    yield ["test", case.scenario.name, "--engine", "sim"], True, 60
    yield ["diff", case.scenario.name, case.scenario.name, "--time", "2s"], True, 60
