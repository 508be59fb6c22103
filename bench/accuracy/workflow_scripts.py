"""The workflow's own helpers, so that beds and layers are cut out and figures drawn as in its report."""

import sys

sys.path.insert(0, "workflow/scripts")

from bed_region import bed_region  # noqa: E402
from layer_region import layer_region  # noqa: E402
from reporting import read_json, write_json  # noqa: E402
from states import read_state  # noqa: E402
from style import MARKERS, PAGE, pyplot  # noqa: E402

__all__ = ["MARKERS", "PAGE", "bed_region", "layer_region", "pyplot", "read_json", "read_state", "write_json"]
