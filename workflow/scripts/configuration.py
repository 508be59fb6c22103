"""Says in one sentence what is wrong with a configuration, where its schema would say it in pages."""

import difflib

import jsonschema

LONGEST = 160  # characters of a sentence of jsonschema, which may quote whole sections


def dotted(*parts):
    """The place of a value, "layers.0.bond_numbers"."""
    return ".".join(str(part) for part in parts)


def describe(error):
    """One error of jsonschema as "place: what is wrong; what to do"."""
    if error.validator == "additionalProperties":
        known = sorted(error.schema["properties"])
        key = next(str(key) for key in error.instance if key not in known)
        meant = difflib.get_close_matches(key, known, n=1, cutoff=0.75)
        advice = f'did you mean "{meant[0]}"?' if meant else f"remove it or use one of {', '.join(known)}"
        return f"{dotted(*error.absolute_path, key)}: the key is unknown; {advice}"
    message = error.message if len(error.message) <= LONGEST else error.message[: LONGEST - 3] + "..."
    place = dotted(*error.absolute_path)
    return f"{place}: {message}" if place else message


def innermost(error):
    """The error itself or, of alternatives none of which fits, that of the one that fits best."""
    return innermost(jsonschema.exceptions.best_match([error])) if error.context else error


def refusal(config, schema):
    """What is wrong with the configuration, a misspelt key before what follows from it; None where nothing is."""
    errors = [innermost(error) for error in jsonschema.Draft202012Validator(schema).iter_errors(config)]
    errors.sort(key=lambda error: error.validator != "additionalProperties")
    return describe(errors[0]) if errors else None
