#!/usr/bin/python3
"""The lathe around its PLC program: contactors, turret, spindle, and the old control's half of the interface."""
import time

import hal

STEP_S = 0.005
POSITIONS = 8
TURN_S = 0.1  # from one position of the turret to the next
LOCK_S = 0.1
STROBE_S = 0.05  # the old control held M, S and T for two slow cycles
SPIN_UP_S = 0.3

machine = hal.component("machine")
for name in ("turret-forward", "turret-reverse", "hydraulics", "machine-on", "spindle-cw", "spindle-enable", "released",
             "turret-works", "turret-fault", "tool-change", "spindle-wanted", "program-runs"):
    machine.newpin(name, hal.HAL_BIT, hal.HAL_IN)
for name in ("code-0", "code-1", "code-2", "code-3", "code-valid", "locked", "key-on", "pressure", "ready", "standstill",
             "at-speed", "t-strobe", "s-strobe", "s-range-1", "m-strobe", "tool-changed", "spindle-at-speed"):
    machine.newpin(name, hal.HAL_BIT, hal.HAL_OUT)
machine.newpin("tool-number", hal.HAL_S32, hal.HAL_IN)
machine.newpin("tool-in-place", hal.HAL_U32, hal.HAL_IN)
for name in ("t-code", "s-code", "m-code"):
    machine.newpin(name, hal.HAL_U32, hal.HAL_OUT)


def bcd(number):
    return number // 10 << 4 | number % 10


class Turret:
    """Turns forward past its positions; turned backwards it falls into its lock."""

    def __init__(self):
        self.at = 0.0
        self.pressed = LOCK_S

    def step(self):
        if machine["turret-forward"]:
            self.at = (self.at + STEP_S / TURN_S) % POSITIONS
            self.pressed = 0.0
        elif machine["turret-reverse"]:
            self.at = float(round(self.at) % POSITIONS)
            self.pressed += STEP_S
        position = round(self.at) % POSITIONS
        for bit in range(4):
            machine["code-%d" % bit] = bool(position + 1 >> bit & 1)
        machine["code-valid"] = abs(self.at - round(self.at)) < 0.3
        machine["locked"] = self.pressed >= LOCK_S


def strobe(word, code):
    """Hands a function over as the old control did; the program answers by taking 'released' away until it is done."""
    machine[word + "-code"] = code
    machine[word + "-strobe"] = True
    yield from wait(STROBE_S)
    machine[word + "-strobe"] = False


def wait(seconds):
    for _ in range(round(seconds / STEP_S)):
        yield


def power_on():
    machine["standstill"] = True
    while not machine["program-runs"]:  # LinuxCNC starts its threads last
        yield
    machine["key-on"] = True
    yield from wait(0.1)
    machine["key-on"] = False
    while not machine["machine-on"]:
        yield
    machine["ready"] = True
    machine["s-range-1"] = True
    yield from wait(0.2)


def control():
    yield from power_on()
    spindle = False
    while True:
        if machine["tool-change"]:
            yield from strobe("t", bcd(machine["tool-number"]))
            while machine["turret-works"] or machine["tool-in-place"] != machine["tool-number"]:
                yield
            machine["tool-changed"] = True
            while machine["tool-change"]:
                yield
            machine["tool-changed"] = False
        if machine["spindle-wanted"] != spindle:
            spindle = machine["spindle-wanted"]
            yield from strobe("m", 0x03 if spindle else 0x05)
            machine["m-code"] = 0
            while not machine["released"]:
                yield
            machine["spindle-at-speed"] = spindle
        yield


def spindle():
    running = 0.0
    while True:
        running = min(running + STEP_S, SPIN_UP_S) if machine["spindle-cw"] and machine["spindle-enable"] else max(running - STEP_S, 0.0)
        machine["standstill"] = running == 0.0
        machine["at-speed"] = running == SPIN_UP_S
        yield


def main():
    turret = Turret()
    tasks = [control(), spindle()]
    machine.ready()
    try:
        while True:
            machine["pressure"] = machine["hydraulics"]
            turret.step()
            for task in tasks:
                next(task)
            time.sleep(STEP_S)
    except KeyboardInterrupt:
        pass


main()
