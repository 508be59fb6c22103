# What is wrong with a configuration, in one sentence.

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(workflow.basedir) / "workflow/scripts"))

from configuration import refusal


def refuse_wrong(values, schema, name):
    """Stop with one sentence where the values of a file do not follow the schema."""
    with open(f"{workflow.basedir}/config/schema/{schema}") as file:
        sentence = refusal(values, json.load(file))
    if sentence:
        raise WorkflowError(f"{name}: {sentence}")
