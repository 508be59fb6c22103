"""Places that the Python tests need."""

import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]


def pytest_configure(config):
    config.addinivalue_line("markers", "slow: takes minutes; left out of 'make test'")


@pytest.fixture(scope="session")
def root():
    """Top folder of the project."""
    return ROOT


@pytest.fixture(scope="session")
def build():
    """Build folder with the programs under test: RECOAT_BUILD, or that of the release preset."""
    folder = Path(os.environ.get("RECOAT_BUILD", ROOT / "build/release"))
    if not (folder / "CMakeCache.txt").exists():
        pytest.fail(f"there is no build in {folder}; run 'make build' first")
    return folder
