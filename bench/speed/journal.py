"""Runs that are done, one line each, so that a bench that was stopped goes on where it was."""

import json
from pathlib import Path

from machine import ROOT


class Journal:
    """Records by key; a key names program, its fingerprint, case and repeat. A line cut short is made anew."""

    def __init__(self, file):
        self.file = Path(file)
        self.records = {}
        text = self.file.read_text() if self.file.exists() else ""
        if text and not text.endswith("\n"):
            self.file.write_text(text[: text.rfind("\n") + 1])
        for line in text.splitlines():
            try:
                entry = json.loads(line)
            except json.JSONDecodeError:
                continue
            self.records[entry["key"]] = entry["record"]

    def once(self, key, make):
        """The record of `key`, made by `make()` unless it is known. A failure is kept as {"failed": sentence}."""
        if key not in self.records:
            try:
                record = make()
            except RuntimeError as error:
                record = {"failed": str(error).replace(f"{ROOT}/", "")[-600:]}
            self.file.parent.mkdir(parents=True, exist_ok=True)
            with self.file.open("a") as stream:
                stream.write(json.dumps({"key": key, "record": record}) + "\n")
            self.records[key] = record
        return self.records[key]

    def close(self):
        """All is done: the next bench starts anew, the lines stay beside."""
        if self.file.exists():
            self.file.rename(self.file.with_suffix(".finished"))
