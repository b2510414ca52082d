"""What the control has beside the language: its system functions, the words of the NC under their names, handwheels, critical
sections, options and the steps of a scenario."""
import dataclasses

import spelled
from spelled import FAULT, POSTFIX, UNARY, VIEWS, Spelled

# Names of the header (9.3): view, first word, words a number, how many numbers.
F_WORDS = {"axis_stat": ("ui", 0, 10, 16), "axis_pout": ("l", 1, 10, 16), "axis_pact": ("l", 3, 10, 16), "axis_speed": ("i", 5, 10, 16),
           "axis_current": ("i", 6, 10, 16), "axis_vmax": ("i", 7, 10, 16), "ch_user_out": ("ul", 160, 20, 4), "ch_stat": ("ui", 162, 20, 4),
           "ch_mst_stb": ("ui", 163, 20, 4), "ch_M_code": ("i", 164, 20, 4), "ch_T_code": ("i", 165, 20, 4), "ch_B_code": ("i", 166, 20, 4),
           "ch_S_code": ("i", 167, 20, 4), "sys_stat": ("ui", 250, 0, 0), "sys_iip_time": ("ui", 251, 0, 0), "sys_pm1um": ("ui", 252, 0, 0),
           "sys_pr1md": ("ui", 253, 0, 0), "sys_var1": ("ui", 240, 1, 10)}
G_WORDS = {"axis_ctrl": ("ui", 0, 10, 16), "axis_pic_a": ("l", 1, 10, 16), "axis_pic_v": ("i", 3, 10, 16), "axis_pvcmd": ("i", 4, 10, 16),
           "axis_pecmd": ("i", 5, 10, 16), "ch_user_in": ("ul", 160, 20, 4), "ch_ctrl": ("ui", 162, 20, 4), "ch_mst_ack": ("ui", 163, 20, 4),
           "ch_feedover": ("ui", 164, 20, 4), "ch_rapidover": ("ui", 165, 20, 4), "ch_cut_inuse": ("i", 166, 20, 4), "ch_spdl_speed": ("i", 167, 20, 4),
           "ch_skip_sw": ("ui", 168, 20, 4), "sys_ctrl": ("ui", 250, 0, 0), "sys_ext_alm": ("ui", 251, 0, 0), "sys_var2": ("ui", 240, 1, 10)}
G_VALUES = {"mod_M_code": 170, "mod_S_code": 171, "mod_T_code": 172, "mod_B_code": 173, "mod_mst_busy": 174, "msthold_dis": 174, "mod_m00_m01": 174}
AXES = (0, 1, 15)  # of which words are looked at
SYSTEM = frozenset({"F", "G"}) | FAULT
# name: result, parameters; a is an axis
STORING = {"set_axis_home": "ai", "set_axis_jog": "ai", "set_axis_step": "al", "set_axis_move": "ali", "set_axis_moveto": "ali", "set_axis_stop": "a",
           "handwheel": "hai"}
GIVING = {"get_axis_pos": ("long", "a"), "get_axis_den": ("int", "a"), "get_handwheel": ("int", "h")}
OPTIONS = {"char": ("unsigned",), "abs": ("long",), "x-mirror": (0, 5), "handler-calls": ("once",), "m00-flags": ("off",), "stop": ("printed",),
           "faults": ("stop",), "base-cycle": (2, 5)}
SETTINGS = {"x-mirror": "mirrored", "handler-calls": "calls_once", "m00-flags": "flags_off", "stop": "stop_printed", "faults": "stop_at_fault",
            "base-cycle": "base"}


class Control:
    def control_word(self, area, depth):
        """*axis_stat(1), *ch_ctrl(i & 3), mod_mst_busy(0): an lvalue."""
        names = F_WORDS if area == "F" else G_WORDS
        if area == "G" and self.chance(15):
            name, channel = self.random.choice(list(G_VALUES)), self.random.choice((0, 0, 1, 2))
            at = G_VALUES[name] + 20 * channel
            self.words.add(("G", at))
            return Spelled(f"{name}({channel})", f"WORD(G, int, {at})", "int", POSTFIX, frozenset({"G"}), target=frozenset({"G"}))
        if self.chance(8):
            index = self.random.randrange(6)
            plc = self.random.choice((f"*cutter_in_mag({index})", f"cutter_in_mag(0)[{index}]", "*tot_mag_pos()"))
            avr, kind = ("B.ui[0]", "unsigned") if "tot" in plc else (f"B.i[{1 + index}]", "int")
            return Spelled(plc, avr, kind, UNARY, frozenset({"B"}), target=frozenset({"B"}))
        if self.chance(10):
            word = self.random.randrange(10)
            name, view, at = ("ch_var", "ui", 170) if area == "F" else ("ch_mst_mod", "i", 170)
            self.words.add((area, at + word))
            return Spelled(f"*{name}(0, {word})", f"WORD({area}, {VIEWS[view]}, {at + word})", VIEWS[view], UNARY, frozenset({area}), target=frozenset({area}))
        name = self.random.choice(list(names))
        view, first, width, most = names[name]
        kind, index, number = VIEWS[view], None, 0
        if most > 4:
            number = self.random.choice(AXES if width == 10 else range(most))
        elif most:
            number = self.random.choice((0, 0, 1, 2))
        if most and depth > 0 and self.chance(25):
            inner = self.integer(depth - 1)
            if not inner.constant:
                index = spelled.binary("&", inner, spelled.literal("1"))
        for at in ((0, 1) if index else (number,)):
            self.words |= {(area, first + width * at + part) for part in range(spelled.SIZES[kind] // 2)}
        text = index.plc if index else str(number) if most else ""
        avr = f"{first} + {width} * ({index.avr})" if index else str(first + width * number)
        found = index or spelled.literal("0")
        return Spelled(f"*{name}({text})", f"WORD({area}, {kind}, {avr})", kind, UNARY, found.reads | {area}, found.writes | (FAULT if index else frozenset()),
                       target=frozenset({area}))

    def system_arguments(self, letters, depth):
        made = []
        for letter in letters:
            value = self.integer(depth)
            if letter in "ah":
                value = spelled.literal(str(self.random.choice(AXES if letter == "a" else range(4))))
                if self.chance(30) and not (inner := self.integer(depth)).constant and inner.kind not in ("long", "unsigned long"):
                    value = spelled.binary("&", inner, spelled.literal("1" if letter == "a" else "3"))
                    if self.chance(20):
                        value = spelled.binary("%", inner, spelled.literal("2"))  # below 0, too
                self.words |= {("G", word + 10 * axis) for axis in (0, 1) for word in range(6)}
            made.append(value)
        return made

    def system_call(self, depth):
        """A statement; what it stores is in G."""
        from statements import both
        if {"G", "F"} & self.protected:
            return both(";")
        name = self.random.choice(list(STORING))
        self.words |= {("G", word + 150) for word in range(6)} | {("F", 151), ("F", 152), ("F", 157), ("F", 251)}
        made = spelled.call(SystemFunction(name, "void"), self.system_arguments(STORING[name], depth))
        self.uses_system = True
        return self.simple(made)

    def system_value(self, depth):
        name = self.random.choice(list(GIVING))
        kind, letters = GIVING[name]
        self.words |= {("F", 151), ("F", 152)}
        self.uses_system = True
        return spelled.call(SystemFunction(name, kind), self.system_arguments(letters, depth - 1))

    def critical(self):
        """Nothing happens in between, and nothing else than in C."""
        from statements import Lines
        inner = self.simple(self.assigned(2))
        begin, end = self.random.choice((("asm cli", "asm sti"), ("asm cli;", "asm { sti }"), ("_asm CLI", "__asm sti;"), ("disable();", "enable();")))
        self.headers.add("dos")
        return Lines([begin], []) + inner + Lines([end], [])

    # options and steps

    def choose_options(self):
        if not self.chance(35):
            return
        for name in self.random.sample(list(OPTIONS), self.random.choice((1, 1, 2, 3))):
            self.options[name] = self.random.choice(OPTIONS[name])

    def settings(self):
        """Statements for avr-gcc's side, before power-on."""
        rows = [f"{name} = {default};" for name, default in (("mirrored", 28), ("calls_once", 0), ("flags_off", 0), ("stop_printed", 0),
                                                             ("stop_at_fault", 0), ("base", 1))]
        for name, value in self.options.items():
            if name in SETTINGS:
                rows.append(f"{SETTINGS[name]} = {value if isinstance(value, int) else 1};")
        return rows


@dataclasses.dataclass
class SystemFunction:
    name: str
    kind: str
    reads: frozenset = frozenset({"F", "G", "HW"})
    writes: frozenset = SYSTEM | {"HW"}
