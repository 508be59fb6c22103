"""Configurations held against their schemas: one sentence for the first thing that is wrong."""

import difflib
import json
import os
from pathlib import Path

import jsonschema
import yaml


def written(path):
    """Keys and indices as a person writes them: layers[0].bond_numbers."""
    text = ""
    for part in path:
        text += f"[{part}]" if isinstance(part, int) else f".{part}" if text else str(part)
    return text


def line_of(file, path):
    """Number of the line in a YAML file on which the value, or the last part of the path that is there, begins."""
    node = yaml.compose(Path(file).read_text())
    line = node.start_mark.line + 1
    for part in path:
        if isinstance(node, yaml.MappingNode):
            found = next(((key, value) for key, value in node.value if key.value == str(part)), None)
        elif isinstance(node, yaml.SequenceNode) and isinstance(part, int) and part < len(node.value):
            found = (node.value[part], node.value[part])
        else:
            found = None
        if found is None:
            break
        line, node = found[0].start_mark.line + 1, found[1]
    return line


def shown(file):
    """A file as the person who starts the workflow would name it."""
    relative = os.path.relpath(file)
    return str(file) if relative.startswith("..") else relative


def place(files, path):
    """File and line where the path is set; the last file that has its first key wins, as it does in Snakemake."""
    for file in reversed(files):
        content = yaml.safe_load(Path(file).read_text())
        if not path or (isinstance(content, dict) and path[0] in content):
            return f"{shown(file)}, line {line_of(file, path)}"
    return "--config" if path else shown(files[-1])


def unknown_key(error):
    """The first key that the schema does not know, what it may have been meant for, and what there is."""
    known = list(error.schema.get("properties", {}))
    key = next(key for key in error.instance if key not in known)
    close = difflib.get_close_matches(str(key), known, 1)
    hint = f"did you mean {close[0]}?" if close else f"the keys are {', '.join(known)}"
    return [*error.absolute_path, key], f"there is no such key; {hint}"


def explain(error):
    """Path and reason of one error of a schema."""
    path = list(error.absolute_path)
    if error.validator == "additionalProperties" and error.validator_value is False:
        return unknown_key(error)
    if error.validator == "required":
        missing = next(key for key in error.validator_value if key not in error.instance)
        return path, f"the key {missing} is missing"
    value = json.dumps(error.instance)
    tells_nothing = error.validator == "pattern" or len(error.message) >= 120
    reason = f"{value[:60]} is not possible here" if tells_nothing else error.message
    about = error.schema.get("description")
    return path, reason + (f" ({about.rstrip('.')})" if about else "")


def depth(error):
    """Errors further inside say more; among equals unknown keys come first, since others follow from them."""
    return len(error.absolute_path), error.validator == "additionalProperties"


def refusal(data, schema_file, files):
    """One sentence on what is wrong with `data`, read from the YAML files `files`; None where it is as the schema says."""
    schema = json.loads(Path(schema_file).read_text())
    data = json.loads(json.dumps(data, default=str))
    errors = list(jsonschema.Draft202012Validator(schema).iter_errors(data))
    if not errors:
        return None
    unknown = [error for error in errors if error.validator == "additionalProperties"]
    error = max(unknown or errors, key=depth)
    while error.context:  # of several alternatives the one that fits best
        error = max(error.context, key=depth)
    path, reason = explain(error)
    name = f"{written(path)}: " if path else ""
    return f"{place(files, path)}: {name}{reason}"
