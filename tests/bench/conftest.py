"""The scripts of bench/speed, which import each other by their plain names."""

import importlib
import sys

import pytest


@pytest.fixture(scope="session")
def speed(root):
    """Gives a script of bench/speed by its name."""
    sys.path.insert(0, str(root / "bench/speed"))
    yield importlib.import_module
    sys.path.remove(str(root / "bench/speed"))
