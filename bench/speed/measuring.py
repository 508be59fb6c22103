"""Runs commands one after the other and says how busy the machine was with other things meanwhile."""

import os
import resource
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

# Processor seconds of others per second, above which a run counts as disturbed.
DISTURBED = 0.1


@dataclass
class Finished:
    """A command that has ended."""

    code: int
    output: str
    errors: str
    wall: float  # [s]
    processor: float  # of the command and its children [s]
    others: float  # cores that others kept busy meanwhile


def busy_seconds():
    """Processor seconds that the machine has spent since it started, those stolen by its host included."""
    fields = [int(field) for field in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:]]
    idle = fields[3] + fields[4]
    return (sum(fields[:8]) - idle) / os.sysconf("SC_CLK_TCK")


def own_seconds():
    """Processor seconds of this process and its finished children."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in used)


def run(command, timeout=None, **options):
    """Runs `command` to its end. After `timeout` seconds it and what it has started are ended, with code 124; code 127
    where there is no such program."""
    busy, own, start = busy_seconds(), own_seconds(), time.monotonic()
    code, output, errors = finish(list(map(str, command)), timeout, options)
    wall, processor = time.monotonic() - start, own_seconds() - own
    others = max(0.0, busy_seconds() - busy - processor) / max(wall, 1e-9)
    return Finished(code, output, errors, wall, processor, others)


def finish(command, timeout, options):
    """Exit code, standard output and standard error."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "errors": "replace", "start_new_session": True}
    try:
        process = subprocess.Popen(command, **pipes, **options)
    except FileNotFoundError as error:
        return 127, "", str(error)
    with process:
        try:
            output, errors = process.communicate(timeout=timeout)
        except BaseException as error:
            os.killpg(process.pid, signal.SIGKILL)
            if not isinstance(error, subprocess.TimeoutExpired):
                raise
            process.wait()
            return 124, "", f"not done after {timeout} s"
    return process.returncode, output, errors
