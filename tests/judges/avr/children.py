"""Programs that are called. Each is the first of a session of its own, and is ended with all that it started when its time is
over or this process is interrupted."""
import contextlib
import os
import signal
import subprocess


def run(words, seconds):
    with subprocess.Popen([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          start_new_session=True) as process:
        try:
            out, errors = process.communicate(timeout=seconds)
        except BaseException:
            with contextlib.suppress(ProcessLookupError):  # it has just ended
                os.killpg(process.pid, signal.SIGKILL)
            raise
    return subprocess.CompletedProcess(words, process.returncode, out, errors)
