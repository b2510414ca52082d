#!/usr/bin/python3
"""In the place of an operator: five tool changes and the spindle, each with its time. The exit code says whether all
of them came to their end."""
import sys
import time

import hal
import linuxcnc

TOOLS = (5, 2, 8, 3, 1)
LIMIT_S = 30

command = linuxcnc.command()
status = linuxcnc.stat()


def wait_for(condition, what):
    end = time.monotonic() + LIMIT_S
    while True:
        status.poll()
        if condition():
            return
        if time.monotonic() > end:
            sys.exit("not within %d s: %s" % (LIMIT_S, what))
        time.sleep(0.005)


def run(line):
    """One block; gives how long it took in seconds."""
    begin = time.monotonic()
    command.mdi(line)
    command.wait_complete(LIMIT_S)
    wait_for(lambda: status.interp_state == linuxcnc.INTERP_IDLE and status.exec_state == linuxcnc.EXEC_DONE, line)
    return time.monotonic() - begin


def main():
    watcher = hal.component("changes")
    watcher.ready()
    command.state(linuxcnc.STATE_ESTOP_RESET)
    command.wait_complete()
    command.state(linuxcnc.STATE_ON)
    wait_for(lambda: status.task_state == linuxcnc.STATE_ON, "machine on")
    for joint in (0, 1):
        command.home(joint)
    wait_for(lambda: status.homed[:2] == (1, 1), "axes homed")
    wait_for(lambda: hal.get_value("machine.ready"), "the PLC's machine on")
    command.mode(linuxcnc.MODE_MDI)
    command.wait_complete()
    for tool in TOOLS:
        seconds = run("T%d M6" % tool)
        status.poll()
        turret = hal.get_value("lathe.tnow")
        print("T%d M6: %.2f s, turret at %d, LinuxCNC has %d" % (tool, seconds, turret, status.tool_in_spindle), flush=True)
        if (turret, status.tool_in_spindle) != (tool, tool) or hal.get_value("lathe.tflt"):
            sys.exit("the tool is not in its place")
    run("M3 S100")
    wait_for(lambda: hal.get_value("machine.spindle-at-speed") and hal.get_value("lathe.spreach"), "spindle at speed")
    print("M3: the converter is on (%d), the program has released the block" % hal.get_value("lathe.spen"), flush=True)
    run("M5")
    wait_for(lambda: hal.get_value("machine.standstill") and not hal.get_value("lathe.u11k3"), "standstill")
    print("M5: standstill", flush=True)
    print("longest period: %d ns" % hal.get_value("lathe.period.tmax"), flush=True)
    command.state(linuxcnc.STATE_OFF)
    command.state(linuxcnc.STATE_ESTOP)


main()
