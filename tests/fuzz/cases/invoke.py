"""Runs the tool under the limits that nothing may exceed, and says what is wrong with how it ended."""
import functools
import os
import resource
import select
import subprocess
import tempfile

MOST_BYTES = 1 << 30
SANITIZER_EXIT = 99
# What acts on a terminal or turns the direction of a line: never in messages.
CONTROLS = frozenset(list(range(0, 32)) + [0x7F] + list(range(0x80, 0xA0)) + list(range(0x202A, 0x202F)) +
                     list(range(0x2066, 0x206A)) + [0x200E, 0x200F]) - {9, 10}


sanitized = False  # the tool is built with sanitizers: it takes more memory and time
most = {"MB": 0, "seconds": 0.0}  # of all runs so far


@functools.cache
def limit_children():
    """Limits of this process, which its children inherit: Python copies all of a large process for each child that sets
    its own ones."""
    if not sanitized:
        resource.setrlimit(resource.RLIMIT_AS, (3 * MOST_BYTES, 3 * MOST_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_BYTES, MOST_BYTES))


def environment():
    options = f"exitcode={SANITIZER_EXIT}:handle_abort=1:print_stacktrace=1:allocator_may_return_null=0"
    return {**os.environ, "ASAN_OPTIONS": options, "UBSAN_OPTIONS": options, "LSAN_OPTIONS": f"exitcode={SANITIZER_EXIT}"}


def unsafe(data):
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        return f"no UTF-8 at byte {error.start}: {data[max(0, error.start - 30):error.start + 10]!r}"
    bad = next((i for i, c in enumerate(text) if ord(c) in CONTROLS), None)
    return None if bad is None else f"U+{ord(text[bad]):04X} behind {text[max(0, bad - 40):bad]!r}"


def own_kilobytes():
    pages = int(open("/proc/self/statm", encoding="ascii").read().split()[1])
    return pages * resource.getpagesize() // 1024


def ends_within(child, seconds):
    ended = os.pidfd_open(child)
    try:
        poll = select.poll()
        poll.register(ended, select.POLLIN)
        return bool(poll.poll(1000 * seconds))
    finally:
        os.close(ended)


def run(command, folder, seconds, safe_output):
    """What is wrong, or None; and the exit code."""
    limit_children()
    if sanitized:
        seconds *= 10
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
        own = own_kilobytes()
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=errors,
                                   start_new_session=True, env=environment())
        if not ends_within(process.pid, seconds):
            os.killpg(process.pid, 9)
            os.wait4(process.pid, 0)
            process.returncode = -9
            return f"hang: over {seconds} s", -9
        _, status, usage = os.wait4(process.pid, 0)
        code = process.returncode = os.waitstatus_to_exitcode(status)
        # A child begins as a copy of this process: what is not above our own size at that time is ours.
        taken = usage.ru_maxrss if usage.ru_maxrss > own * 1.1 + 20_000 else 0
        most["MB"] = max(most["MB"], taken // 1024)
        most["seconds"] = max(most["seconds"], usage.ru_utime + usage.ru_stime)
        out.seek(0)
        errors.seek(0)
        printed, told = out.read(), errors.read()
    if code == SANITIZER_EXIT or b"Sanitizer" in told or b"runtime error:" in told:
        return "sanitizer: " + told.decode("utf-8", "replace")[-4000:], code
    if code < 0:
        return f"signal {-code}", code
    if code == 3 or b"internal fault" in told:
        return "exit 3: " + told.decode("utf-8", "replace")[-300:], code
    if code not in (0, 1, 2):
        return f"exit {code}", code
    if taken * 1024 > MOST_BYTES and not sanitized:
        return f"{taken // 1024} MB of memory", code
    for name, data in (("messages", told), ("output", printed if safe_output else b"")):
        if problem := unsafe(data):
            return f"{name}: {problem}", code
    return None, code
