"""The workflow's own helpers, so that beds and layers are cut out as in its report.

Figures take `style` from beside them once this is imported; it is not taken here, for it takes half a second that
hundreds of runs would wait for.
"""

import resource
import subprocess
import sys
import time

sys.path.insert(0, "workflow/scripts")

from bed_region import bed_region  # noqa: E402
from layer_region import layer_region  # noqa: E402
from reporting import Implausible, read_json, write_json  # noqa: E402
from states import read_state  # noqa: E402


class Clock:
    """Wall and processor seconds of what this process and its finished children did since then."""

    def __init__(self):
        self.start = time.monotonic(), self.processor()

    @staticmethod
    def processor():
        """Processor seconds of this process and its finished children."""
        used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
        return sum(usage.ru_utime + usage.ru_stime for usage in used)

    def record(self):
        """As entries of a file of results."""
        wall, processor = self.start
        return {"wall_seconds": time.monotonic() - wall, "processor_seconds": self.processor() - processor}


def solver_version(build):
    """Version and commit of the solver of a build."""
    command = [f"{build}/solver/recoat-solve", "--version"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip().removeprefix("recoat-solve ")


__all__ = [
    "Clock",
    "Implausible",
    "bed_region",
    "layer_region",
    "read_json",
    "read_state",
    "solver_version",
    "write_json",
]
