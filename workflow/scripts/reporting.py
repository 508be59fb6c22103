"""What every script of the workflow does around its work: keep a log, fail with one sentence, write whole files."""

import contextlib
import json
import os
import sys
import traceback
from pathlib import Path


class Implausible(Exception):
    """A result or an input that must not be used; the message is one sentence for the user."""


@contextlib.contextmanager
def logged(snakemake):
    """Send warnings and errors to the rule's log; an Implausible result is also said on the terminal."""
    with open(snakemake.log[0], "w") as log:
        try:
            with contextlib.redirect_stderr(log):
                yield
        except Implausible as error:
            log.write(f"{error}\n")
            sys.exit(f"recoat: {error}")
        except Exception:
            traceback.print_exc(file=log)
            raise


def read_json(path):
    """A JSON file as dictionaries and lists."""
    return json.loads(Path(path).read_text())


def write_text(path, text):
    """Write a file whole or not at all."""
    path = Path(path)
    temporary = path.with_name(path.name + ".part")
    temporary.write_text(text)
    os.replace(temporary, path)


def write_json(path, value):
    """Write a JSON file; not-a-number is refused rather than written."""
    write_text(path, json.dumps(value, indent=1, allow_nan=False) + "\n")


def describe(label):
    """A case in words: Bond number, stiffness ratio, seed."""
    return f"Bo = {label['bond']:g}, stiffness ratio {label['ratio']:g}, seed {label['seed']}"
