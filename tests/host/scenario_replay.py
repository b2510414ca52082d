"""Scenarios of the NC-110 lathe in LinuxCNC's real-time thread: LinuxCNC's own streamer plays what they set, period by
period, its sampler records the pins, and what they expect is compared in the very period that it is expected in."""
import re

import yaml

PERIOD_MS = 10
MAX_PERIODS = 1500
PINS_A_COMPONENT = 20  # of one streamer or sampler
COMPONENTS = 8
CODES = {"Bit": "b", "S32": "s", "U32": "u", "Float": "f"}


class NotReplayed(Exception):
    """The scenario does what cannot be done through pins."""


def is_scenario(path):
    return "steps" in yaml.safe_load(path.read_text())


def number(value):
    text = str(value).upper()
    return int(text[:-1], 16) if text.endswith("H") else int(text)


class Pins:
    """By what scenarios write: a signal's symbol, its address, or a byte whose bits are pins."""

    def __init__(self, rows):
        self.rows = {name: (kind, direction) for name, kind, direction, _, _ in rows}
        self.by_address = {}
        for name, _, direction, role, address in rows:
            if role != "Event":
                self.by_address.setdefault(address, name)

    def find(self, location):
        """Pins with the bit of the location's value that each is; None: the whole value. Empty: there are none."""
        location = str(location)
        name = location.lstrip("!").lower().replace("_", "-")
        if name in self.rows:
            return [(name, None)]
        if location in self.by_address:
            return [(self.by_address[location], None)]
        byte = re.fullmatch(r"W(\d+)([A-Z])(\d+)", location)
        found = []
        for bit in range(8) if byte else ():
            for address in ("I%s%s%d" % (byte[1], byte[2], 8 * int(byte[3]) + bit), "%s bit %d" % (location, bit)):
                if address in self.by_address:
                    found.append((self.by_address[address], bit))
        return found


class Replay:
    """What a scenario sets in each period, and what it expects after which."""

    def __init__(self, path, pins):
        self.pins = pins
        self.state, self.frames, self.expected, self.without_pin = {}, [], [], 0
        scenario = yaml.safe_load(path.read_text())
        if "plant" in scenario:
            raise NotReplayed("inputs are those of a plant")
        for step in scenario["steps"]:
            for word, what in step.items():
                if word == "set":
                    self.set(what)
                elif word == "run":
                    self.run(what)
                elif word == "expect":
                    self.expect(what)
                elif not word.startswith("expect_"):
                    raise NotReplayed("step '%s'" % word)

    def set(self, what):
        for location, value in what.items():
            found = self.pins.find(location)
            unknown = not found and not re.fullmatch(r"W\d+[AKN]\d+", str(location))
            directions = {self.pins.rows[pin][1] for pin, _ in found}
            # A parameter that is played has to be played from the beginning: before, its value is the program's.
            if unknown or "Out" in directions or ("Both" in directions and self.frames):
                raise NotReplayed("sets %s" % location)
            for pin, bit in found:
                self.state[pin] = number(value) if bit is None else number(value) >> bit & 1

    def run(self, what):
        if set(what) & {"fast"}:
            raise NotReplayed("the fast part alone")
        ms = number(what.get("ms", 0)) + 1000 * what.get("s", 0)
        if ms % PERIOD_MS:
            raise NotReplayed("%d ms" % ms)
        count = what.get("slow", 0) + int(ms) // PERIOD_MS
        self.frames += [dict(self.state)] * count
        if len(self.frames) > MAX_PERIODS:
            raise NotReplayed("more than %d periods" % MAX_PERIODS)

    def expect(self, what):
        for location, value in what.items():
            found = self.pins.find(location)
            if not found:
                self.without_pin += 1
            for pin, bit in found:
                self.expected.append((len(self.frames), pin, number(value) if bit is None else number(value) >> bit & 1, location))

    def components(self, names):
        """Groups of pins, one for each streamer or sampler."""
        names = sorted(names)
        groups = [names[i:i + PINS_A_COMPONENT] for i in range(0, len(names), PINS_A_COMPONENT)]
        assert len(groups) <= COMPONENTS, "%d pins are too many" % len(names)
        return groups

    def hal_lines(self, folder):
        inputs = self.components({pin for frame in self.frames for pin in frame})
        outputs = self.components({pin for _, pin, _, _ in self.expected})
        self.outputs = outputs
        count = len(self.frames)
        cfg = lambda groups: ",".join("".join(CODES[self.pins.rows[pin][0]] for pin in group) for group in groups)
        depths = lambda groups: ",".join([str(count + 10)] * len(groups))
        lines = ["loadrt threads name1=t period1=%d" % (PERIOD_MS * 1000000), "loadrt streamer depth=%s cfg=%s" % (depths(inputs), cfg(inputs)),
                 "loadrt sampler depth=%s cfg=%s" % (depths(outputs), cfg(outputs)), "loadrt lathe"]
        for i, group in enumerate(inputs):
            text = "\n".join(" ".join(str(frame.get(pin, 0)) for pin in group) for frame in self.frames)
            (folder / ("in%d" % i)).write_text(text + "\n")
            lines += ["net in-%d-%d streamer.%d.pin.%d => lathe.%s" % (i, k, i, k, pin) for k, pin in enumerate(group)]
            lines.append("loadusr -w halstreamer -c %d in%d" % (i, i))
            lines.append("addf streamer.%d t" % i)
        lines.append("addf lathe.period t")
        for i, group in enumerate(outputs):
            already = {pin: "in-%d-%d" % (a, b) for a, names in enumerate(inputs) for b, pin in enumerate(names)}
            for k, pin in enumerate(group):
                signal = already.get(pin, "out-%d-%d" % (i, k))
                lines.append("net %s %s => sampler.%d.pin.%d" % (signal, "" if pin in already else "lathe." + pin, i, k))
            lines.append("addf sampler.%d t" % i)
            lines.append("loadusr halsampler -c %d -n %d out%d" % (i, count, i))
        return lines + ["loadusr -w sleep 0.3", "start", "loadusr -w sleep %.1f" % (count * PERIOD_MS / 1000 + 1), "getp lathe.period.tmax"]

    def compare(self, folder):
        """Gives the number of expectations that were compared."""
        samples = {}
        for i, group in enumerate(self.outputs):
            rows = (folder / ("out%d" % i)).read_text().splitlines()
            assert len(rows) >= len(self.frames), "sampler %d has %d of %d periods" % (i, len(rows), len(self.frames))
            for k, pin in enumerate(group):
                samples[pin] = [int(float(row.split()[k])) for row in rows]
        for period, pin, value, location in self.expected:
            found = samples[pin][period - 1]
            assert found == value, "after period %d: %s (lathe.%s) is %d, expected %d" % (period, location, pin, found, value)
        return len(self.expected)
