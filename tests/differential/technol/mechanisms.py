"""Random programs of waiting mechanisms, and the state machine of 6.4, 6.7 and 7 that they are, apart from plcxx.

A program is a list of (instruction, operand...); a mechanism inside a module is ("MECH", name). Loops are left by the
guard, whose limit is small here.
"""
BITS = [f"B{i}" for i in range(8)]
CELLS = ["C0", "C1", "C2"]
TIMERS = ["T0", "T1"]
MECHANISMS = ["M0", "M1", "M2"]
RELATIONS = {"EQ": lambda a, b: a == b, "NE": lambda a, b: a != b, "LT": lambda a, b: a < b, "LE": lambda a, b: a <= b,
             "GT": lambda a, b: a > b, "GE": lambda a, b: a >= b}
PURE = {"LDR", "LA", "LO", "LX", "LOD", "AD", "AND", *RELATIONS}


class Generator:
    def __init__(self, rng):
        self.rng = rng

    def condition(self):
        rng = self.rng
        if rng.random() < 0.75:
            names = ["LDR"] + [rng.choice(["LA", "LO", "LX"]) for _ in range(rng.randint(0, 2))]
            return [(name, rng.choice(["", "-"]), rng.choice(BITS + MECHANISMS)) for name in names]
        return [("LOD", rng.choice(CELLS)), ("AD", rng.randint(0, 3)),
                (rng.choice(list(RELATIONS)), rng.randint(0, 6))]

    def body(self, count, prefix, waits, subprograms):
        rng, program = self.rng, []
        labels = {at: f"{prefix}L{at}" for at in rng.sample(range(count + 1), min(rng.randint(0, 3), count + 1))}
        targets = list(labels.values())
        for at in range(count + 1):
            if at in labels:
                program.append(("LABEL", labels[at]))
            if at == count:
                break
            kind = rng.random()
            if kind < 0.15:
                program.append(("FL", rng.randint(0, 1), rng.choice(BITS + MECHANISMS)))
            elif kind < 0.30:
                program += self.condition() + [("WR", rng.choice(BITS))]
            elif kind < 0.38:
                flag = (rng.choice(["FL1", "FL0"]), rng.randint(0, 1), rng.choice(BITS + MECHANISMS))
                program += self.condition() + [flag]
            elif kind < 0.50:
                program += [("LOD", rng.choice(CELLS)), ("AD", rng.randint(1, 3)), ("AND", 15),
                            ("STO", rng.choice(CELLS))]
            elif kind < 0.58 and targets:
                program += self.condition() + [(rng.choice(["JL1", "JL0"]), rng.choice(targets))]
            elif kind < 0.61 and targets:
                program.append(("JUM", rng.choice(targets)))
            elif kind < 0.65 and prefix != "S":
                program.append(("MECH_INIT", rng.choice(MECHANISMS)))
            elif kind < 0.70 and subprograms:
                program.append(("CALL", "S0"))
            elif waits and kind < 0.78:
                program += self.condition() + [(rng.choice(["EX0", "EX1"]),)]
            elif waits and kind < 0.84:
                program.append(("EX",))
            elif waits and kind < 0.92:
                program.append(("TIM", rng.choice(["-", *TIMERS]), rng.choice([0, 1, 2, 3, "C0"])))
            elif waits and targets:
                supervision = (rng.choice(["TEX0", "TEX1"]), rng.choice(["-", "T0"]), rng.choice([0, 1, 2, "C1"]))
                program += self.condition() + [(*supervision, rng.choice(targets))]
            else:
                program.append(("FL", 1, rng.choice(BITS)))
        return program


def text(program, bodies):
    lines = []
    for name, *operands in program:
        if name == "LABEL":
            lines.append(f"{operands[0]}:")
        elif name == "MECH":
            lines += mechanism_text(operands[0], bodies)
        elif name in ("LDR", "LA", "LO", "LX"):
            lines.append(f"        {name} {operands[0]}{operands[1]}")
        elif name in ("AD", "AND", *RELATIONS):
            lines.append(f"        {name} CNST.{operands[0]}")
        else:
            lines.append(f"        {name} {','.join(map(str, operands))}".rstrip())
    return lines


def mechanism_text(name, bodies):
    return [f"        MECH_BEGIN {name}", *text(bodies[name], bodies), f"        MECH_END {name}"]


class GuardTrips(Exception):
    """The backward jump behind the last allowed one."""


class StopsItself(Exception):
    """MECH_INIT of the mechanism that runs."""


class Control:
    def __init__(self, bodies, subprogram, limit):
        self.bodies, self.subprogram, self.limit = bodies, subprogram, limit
        self.values = dict.fromkeys(BITS + CELLS + TIMERS + MECHANISMS, 0)
        self.steps = dict.fromkeys(MECHANISMS, 0)  # a position in the body; 0 is the beginning
        self.automatic = {}
        self.rlo = self.dr = 0

    def run_pass(self, main, behind):
        try:
            self.run(main, None, 0, [0])
        except GuardTrips:
            pass
        for name in behind:
            self.mechanism(name)

    def mechanism(self, name):
        if not self.values[name]:
            return
        entered = self.steps[name]
        try:
            if self.run(self.bodies[name], name, entered, [0]):
                self.stop(name)
        except GuardTrips:
            self.steps[name] = entered
        except StopsItself:
            pass

    def stop(self, name):
        self.values[name] = self.steps[name] = 0
        for timer in self.automatic:
            if timer[0] == name:
                self.automatic[timer] = 0

    def run(self, program, unit, at, jumps):
        """Executes from `at`; True: the end was reached, False: it waits. `jumps` counts the backward ones."""
        positions = {operands[0]: i for i, (name, *operands) in enumerate(program) if name == "LABEL"}
        while at < len(program):
            name, *operands = program[at]
            target = None
            if name in ("LDR", "LA", "LO", "LX"):
                self.combine(name, self.values[operands[1]] ^ (operands[0] == "-"))
            elif name in RELATIONS:
                self.rlo = int(RELATIONS[name](self.dr, operands[0]))
            elif name in ("JUM", "JL1", "JL0"):
                if name == "JUM" or self.rlo == int(name[2]):
                    target = operands[0]
            elif name == "CALL":
                self.run(self.subprogram, unit, 0, jumps)
            elif name == "RET":
                return True
            elif name == "MECH_INIT":
                self.stop(operands[0])
                if operands[0] == unit:
                    raise StopsItself
            elif name == "MECH":
                self.mechanism(operands[0])
            elif name in ("EX", "EX0", "EX1"):
                if name == "EX" or self.rlo == int(name[2]):
                    self.steps[unit] = at + 1 if name == "EX" else self.resume_point(program, at)
                    return False
            elif name in ("TIM", "TEX0", "TEX1"):
                passed, target = self.timed_wait(name, operands, unit, at)
                if not passed:
                    self.steps[unit] = at if name == "TIM" else self.resume_point(program, at)
                    return False
            else:
                self.simple(name, operands)
            if target is None:
                at += 1
                continue
            if positions[target] <= at:
                if jumps[0] == self.limit:
                    raise GuardTrips
                jumps[0] += 1
            at = positions[target]
        return True

    @staticmethod
    def resume_point(program, at):
        while at > 0 and program[at - 1][0] in PURE:
            at -= 1
        return at

    def combine(self, name, bit):
        self.rlo = {"LDR": bit, "LA": self.rlo & bit, "LO": self.rlo | bit, "LX": self.rlo ^ bit}[name]

    def simple(self, name, operands):
        if name == "WR":
            self.values[operands[0]] = self.rlo
        elif name == "FL" or name in ("FL1", "FL0") and self.rlo == int(name[2]):
            self.values[operands[1]] = operands[0]
        elif name == "LOD":
            self.dr = self.values[operands[0]]
        elif name == "STO":
            self.values[operands[0]] = self.dr
        elif name == "AD":
            self.dr = (self.dr + operands[0]) & 0xFFFF
        elif name == "AND":
            self.dr &= operands[0]

    def timed_wait(self, name, operands, unit, at):
        """(does it go on, the label it goes to)."""
        cell, limit, *label = operands
        store, key = (self.automatic, (unit, at)) if cell == "-" else (self.values, cell)
        limit = self.values[limit] if isinstance(limit, str) else limit
        count = store.get(key, 0)
        if name != "TIM" and self.rlo == int(name == "TEX0"):
            store[key] = 0
            return True, None
        if count >= limit:
            store[key] = 0
            return True, label[0] if label else None
        store[key] = count + 1
        return False, None


def make(rng):
    """The text of a program, its options and the steps of its scenario."""
    generator = Generator(rng)
    with_subprogram = rng.random() < 0.6
    subprogram = generator.body(rng.randint(1, 4), "S", False, False) + [("RET",)] if with_subprogram else []
    bodies = {name: generator.body(rng.randint(1, 7), name, True, with_subprogram) for name in MECHANISMS}
    main = generator.body(rng.randint(1, 5), "X", False, with_subprogram)
    place = rng.randint(0, len(main))
    while place > 0 and main[place - 1][0] in PURE:  # between whole conditions
        place -= 1
    inside = rng.sample(MECHANISMS, rng.randint(0, 2))
    for name in inside:
        main.insert(place, ("MECH", name))
    behind = [name for name in MECHANISMS if name not in inside]
    limit = rng.choice([2, 5])

    lines = ["        DATA", f"BITY: DFM {','.join(BITS)}", *[f"{c}: DS 2" for c in CELLS + TIMERS],
             "        DATA_END", "        MODULE_MAIN", *text(main, bodies), "        MODULE_MAIN_END"]
    lines += ["S0:", *text(subprogram, bodies)] if with_subprogram else []
    for name in behind:
        lines += mechanism_text(name, bodies)
    lines += ["        STOP", ""]

    control, steps = Control(bodies, subprogram, limit), []
    for _ in range(14):
        written = {bit: rng.randint(0, 1) for bit in BITS if rng.random() < 0.25}
        written.update({name: int(rng.random() < 0.8) for name in MECHANISMS if rng.random() < 0.35})
        if written:
            steps.append(("set", written))
            control.values.update(written)
        control.run_pass(main, behind)
        steps += [("run", {"slow": 1}), ("expect", dict(control.values))]
    return "\n".join(lines), {"loop-limit": limit}, steps
