"""The derived numbers of recoat-solve check, one row per number and one column per case."""

import pandas

from reporting import describe, logged, read_json, write_text

MACHINE = ["expected", "notes"]  # what belongs to the machine where the workflow runs, and sentences: no numbers


def named(number, item):
    """The key and value of a list item."""
    if isinstance(item, dict) and "name" in item:
        return item["name"], {key: value for key, value in item.items() if key != "name"}
    return number, item


def flatten(value, name=""):
    """Nested dictionaries and lists as dotted names; list items are named by their own name where they have one."""
    if isinstance(value, dict):
        items = value.items()
    elif isinstance(value, list):
        items = (named(number, item) for number, item in enumerate(value))
    else:
        return {name: value}
    result = {}
    for key, item in items:
        result |= flatten(item, f"{name}.{key}" if name else str(key))
    return result


def table(cases, derived):
    """Rows in the order of the first case that has them."""
    columns = {}
    for case, values in zip(cases, derived, strict=True):
        of_case = {name: value for name, value in values.items() if name not in MACHINE}
        columns[describe(case)] = pandas.Series(flatten(of_case), dtype=object)
    names = dict.fromkeys(name for column in columns.values() for name in column.index)
    result = pandas.DataFrame(columns).reindex(list(names))
    result.index.name = "quantity"
    return result


if __name__ == "__main__":
    with logged(snakemake):
        derived = [read_json(path) for path in snakemake.input.derived]
        write_text(snakemake.output[0], table(snakemake.params.cases, derived).to_csv())
