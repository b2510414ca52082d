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
    for form in ("text", "json"):
        yield ["why", case.maps.partition("=")[0], "--scenario", case.scenario.name, "--format", form], True, 60
    yield ["diff", case.scenario.name, case.scenario.name, "--time", "2s"], True, 60
    yield ["mutate", case.scenario.name, "--most", "20", "--time-limit", "10"], True, 60
    yield ["soak", case.scenario.name, "--for", "5s", "--time", "2s", "-o", "soaked"], True, 60
    # The case's plcxx.yaml, mutated like its other files; else the one that init makes.
    yield ["init", "--pipeline", "github"], True, 60
    yield ["check"], True, 20
    yield ["check", "--write-baseline", "--baseline", "accepted"], True, 20
    yield ["check", "--baseline", "accepted"], True, 20
    yield ["test", "--engine", "sim", "--time-limit", "5"], True, 60


def dear(case):
    """What calls compilers and solvers, likewise. A property that holds and one that is violated; the old version is the
    program before it was mutated (in `old/`)."""
    base = program(case)
    yield ["prove", *base, "--property", "properties", "--time", "1s", "--depth", "3"], True, 60
    yield ["prove", *base, "--property", "properties", "--time", "1s", "--depth", "3", "--format", "json", "--counterexamples",
           "found"], True, 60
    for form in ("text", "markdown", "json", "sarif", "html"):
        yield ["diff", "old", ".", "--sources", *case.sources, *base[len(case.sources):], "--time", "1s", "--format", form], True, 60
    yield ["diff", "old", ".", "--sources", *case.sources, *base[len(case.sources):], "--time", "1s", "--map",
           case.maps, "--counterexamples", "found"], True, 60
    yield ["verify", *base, "--time", "1s", "--jobs", "1"], True, 120
    yield ["build", *base, "--target", "host", "-o", "built", "-O", "0"], True, 120
    yield ["identify", case.sources[0], *base], True, 30
    yield ["test", case.scenario.name, "--engine", "host", "--time-limit", "20"], True, 120
    yield ["test", case.scenario.name, "--engine", "sim", "--junit", "out.xml", "--vcd", "out.vcd"], True, 60
    yield ["sim", *base, "--for", "50ms", "--time-limit", "5", "--vcd", "out.vcd"], True, 30
    yield ["explain", case.maps], True, 10
