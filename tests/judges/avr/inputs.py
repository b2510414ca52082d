"""What a random program is given before each of its steps, and what of the areas is looked at."""
from expressions import AREA_BYTES, WINDOWS
from program import Observed, Step

SCANS = 3
HANDLED = (0, 1)  # channels whose words are looked at
HOST = {"X": "host.x[{}]", "F": "host.f[{}]", "P": "host.p[{}]"}


class Inputs:
    def inputs(self):
        steps = []
        for _ in range(SCANS):
            locations, statements = {}, []
            for area, count, most in (("X", WINDOWS["X"], 256), ("P", WINDOWS["P"] // 2, 65536), ("F", WINDOWS["F"] // 2, 65536)):
                for i in range(count):
                    if self.chance(50):
                        value = self.random.choice((self.random.randrange(most), 0, 1, most - 1, most // 2, most // 2 - 1))
                        locations[f"{area}[{i}]"] = value
                        statements.append(f"{HOST[area].format(i)} = {value}u;")
            for channel in HANDLED if self.registered or self.chance(20) else ():
                words = {163: self.random.choice((0, 0x100, 0x300, 0xF00, 0x400, 0x800, 0x2100, 0x8100, 0x2F00))}
                words |= {word: self.random.choice((0, 1, 3, 30, 65535, 303)) for word in range(164, 168) if self.chance(50)}
                for word, value in words.items():
                    locations[f"F[{word + 20 * channel}]"] = value
                    statements.append(f"host.f[{word + 20 * channel}] = {value}u;")
                if self.chance(20):
                    locations[f"MODAL[{channel}]"] = 1
                    statements.append(f"asked[{channel}] = 1;")
            for word in sorted(at for area, at in self.words if area == "F" and at >= 16):
                if self.chance(40) and f"F[{word}]" not in locations:
                    value = self.random.choice((0, 1, 200, 32767, 65535, self.random.randrange(65536)))
                    locations[f"F[{word}]"] = value
                    statements.append(f"host.f[{word}] = {value}u;")
            for wheel in range(4) if self.uses_system else ():
                if self.chance(30):
                    value = self.random.choice((1, -1, 7, -300, 32767))
                    locations[f"HW[{wheel}]"] = value
                    statements.append(f"hw[{wheel}] = {value};")
            for i in range(WINDOWS["R"]):
                if self.chance(25):
                    value = self.random.randrange(256)
                    locations[f"R[{i}]"] = value
                    statements.append(f"R.uc[{i}] = {value};")
            unit, cycles = self.random.choice(("ms", "ms", "ms", "ms", "fast", "slow")), self.random.choice((1, 1, 1, 2, 3, 6))
            # One that has stopped is due no more.
            steps.append(Step(locations, statements, cycles, "ms" if self.options.get("faults") else unit, bool(steps) and self.chance(8)))
        return steps

    def areas(self):
        made = []
        for channel in HANDLED:
            first = 163 + 20 * channel
            made.append(Observed(f"*(unsigned (*)[12])&G.ui[{first}]", [(f"G[{first + i}]", "unsigned") for i in range(12)]))
        seen = {163 + 20 * channel + i for channel in HANDLED for i in range(12)} | set(range(WINDOWS["G"] // 2))
        for word in sorted(at for area, at in self.words if area == "G" and at not in seen):
            made.append(Observed(f"G.ui[{word}]", [(f"G[{word}]", "unsigned")]))
        if self.uses_system:
            made += [Observed(f"hw[{wheel}]", [(f"HW[{wheel}]", "int")]) for wheel in range(4)]
        made.append(Observed("plc1_time", [("plc1_time", "unsigned")]))
        made.append(Observed("plc2_time", [("plc2_time", "unsigned")]))
        for area, window in WINDOWS.items():
            view = "" if area in "FG" else "_uc"
            if area in "FG":
                made.append(Observed(f"*({'unsigned (*)'}[{window // 2}])&{area}", [(f"{area}[{i}]", "unsigned") for i in range(window // 2)]))
                continue
            size = AREA_BYTES[area] if self.chance(5) else window
            made.append(Observed(f"*(unsigned char (*)[{size}])&{area}", [(f"{area}{view}[{i}]", "unsigned char") for i in range(size)]))
        return made
