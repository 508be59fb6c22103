"""The programs of one build, and how fast they step a scene."""

import hashlib
import json
import os
from functools import cache
from pathlib import Path

from measuring import run

BAD_INPUT = 2


class Build:
    """A folder with bench/step-rate and solver/recoat-solve of one commit."""

    def __init__(self, name, folder):
        self.name = name
        self.folder = Path(folder).resolve()
        if not self.step_rate.exists():
            raise SystemExit(f"{self.step_rate} is missing; build it first, e.g. with make build")

    @property
    def step_rate(self):
        return self.folder / "bench/step-rate"

    @property
    def solver(self):
        return self.folder / "solver/recoat-solve"

    @cache
    def fingerprint(self):
        """Changes whenever the program does."""
        return hashlib.sha256(self.step_rate.read_bytes()).hexdigest()[:16]

    @cache
    def accepts(self, scene, settings):
        """Whether this commit's scenes have such settings, a tuple of a.b=v."""
        if not settings:
            return True
        done = run([self.solver, "run", scene, "--print-config", *with_set(settings)])
        if done.code not in (0, BAD_INPUT):
            raise RuntimeError(f"{self.solver}: {done.errors.strip()}")
        return done.code == 0

    @cache
    def instruction_set(self):
        """Whose loops the program runs here; None for a commit that has but one version of them."""
        version = run([self.solver, "--version"]).output
        return version.split("loops for ")[1].split()[0] if "loops for " in version else None

    def known(self, scene, settings):
        """Those of the settings that this commit's scenes have."""
        return tuple(setting for setting in settings if self.accepts(scene, (setting,)))

    def rate(self, scene, bond, threads, warm, steps, settings=(), instruction_set=None):
        """Makes one run; its record, or None where this commit's scenes do not have such settings."""
        if not self.accepts(scene, tuple(settings)):
            return None
        command = [self.step_rate, "--scene", scene, "--bond", f"{bond:g}", "--threads", threads, "--warm", warm, "--steps", steps]
        environment = os.environ | ({"RECOAT_INSTRUCTION_SET": instruction_set} if instruction_set else {})
        done = run([*command, *with_set(settings)], env=environment)
        if done.code != 0:
            raise RuntimeError(f"{' '.join(map(str, command))}: {done.errors.strip()}")
        return record(json.loads(done.output), done.others)


def with_set(settings):
    """As arguments of a program."""
    return [part for setting in settings for part in ("--set", setting)]


def record(line, others):
    """One run: rates [particle-steps/s] by the clock and by processor time, and how many cores others kept busy."""
    work = line["particles"] * line["steps"]
    return {
        "particles": line["particles"],
        "steps": line["steps"],
        "time_step": line["time_step"],
        "rate": work / line["seconds"],
        "processor_rate": work / line["processor_seconds"],
        "coordination": line["coordination_number"],
        "kinetic_energy": line["kinetic_energy"],
        "others": others,
    }
