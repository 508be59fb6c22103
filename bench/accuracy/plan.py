"""The runs that bench/accuracy/plan.yaml asks for, each once, and the groups that they belong to."""

from collections import namedtuple
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import yaml

PAPER_RATIO = 0.001  # of a group that names none
SHORTEST_STEP = 5e-9  # of two bodies [s]
TwoBodyCase = namedtuple("TwoBodyCase", "bond ratio scheme precision shortest_step")


@dataclass(frozen=True)
class PowderRun:
    """A small bed or layer; `seed` is of the random placement."""

    kind: str
    bond: float
    ratio: float
    time_step: float
    scheme: str
    precision: str
    shortcut: str
    skin: float
    close_steps: float
    seed: int
    overrides: tuple
    region: tuple

    @property
    def name(self):
        """A text that no other run has."""
        numbers = "_".join(
            f"{key}-{value:g}"
            for key, value in (
                ("bond", self.bond),
                ("ratio", self.ratio),
                ("step", self.time_step),
                ("skin", self.skin),
                ("close", self.close_steps),
                ("seed", self.seed),
            )
        )
        return f"{self.kind}_{numbers}_{self.scheme}_{self.precision}_{self.shortcut}"

    def settings(self):
        """What a run is made from, as plain values."""
        chosen = {
            "cohesion.bond_number": self.bond,
            "cohesion.scheme": self.scheme,
            "precision": self.precision,
            "stiffness_ratio": self.ratio,
            "time_step": f"{self.time_step!r} s",
            "pair_lists.skin": f"{self.skin!r} dp",
            "pair_lists.close_steps": self.close_steps,
            "seed": self.seed,
        }
        return {
            "kind": self.kind,
            "time_step": self.time_step,
            "overrides": dict(self.overrides) | chosen,
            "region": list(self.region),
            "about": {key: getattr(self, key) for key in KEYS},
        }


KEYS = ("kind", "bond", "ratio", "time_step", "scheme", "precision", "shortcut", "skin", "close_steps", "seed")


@dataclass
class Plan:
    """Everything to be run: `runs` and `two_body` by name, `groups` as lists of names by study; `grid` is
    the common part of all cases of two bodies."""

    scene: str
    folder: str
    grid: dict
    two_body: dict
    runs: dict
    groups: dict


def two_body_cases(grid):
    """Every scheme at the ratio of the paper, the default at the others; that in every precision."""
    cases = {}
    for ratio in map(float, grid["stiffness_ratios"]):
        schemes = grid["schemes"] if ratio == PAPER_RATIO else grid["schemes"][:1]
        shortest = {float(key): float(value) for key, value in grid["shortest_step"].items()}.get(ratio, SHORTEST_STEP)
        choices = [(schemes[0], precision) for precision in grid["precisions"]]
        choices += [(scheme, grid["precisions"][0]) for scheme in schemes[1:]]
        for bond, (scheme, precision) in product(grid["bond_numbers"], choices):
            case = TwoBodyCase(float(bond), ratio, scheme, precision, shortest)
            cases[f"bond-{bond:g}_ratio-{ratio:g}_{scheme}_{precision}"] = case
    return cases


def runs_of(group, plan):
    """The runs of one group."""
    powder = plan["powder"]
    for bond, (step, replicates), scheme, precision, shortcut, skin, close_steps in product(
        group["bond_numbers"],
        group["steps"].items(),
        group.get("schemes", ["discrete_gradient"]),
        group.get("precisions", ["double"]),
        group.get("shortcuts", ["none"]),
        group.get("skins", [0.1]),
        group.get("close_steps", [25]),
    ):
        overrides = powder["overrides"] | plan["shortcuts"][shortcut]
        for seed in range(1, replicates + 1):
            yield PowderRun(
                kind=group["kind"],
                bond=float(bond),
                ratio=float(group.get("stiffness_ratio", PAPER_RATIO)),
                time_step=float(step),
                scheme=scheme,
                precision=precision,
                shortcut=shortcut,
                skin=float(skin),
                close_steps=float(close_steps),
                seed=seed,
                overrides=tuple(overrides.items()),
                region=(powder["skip_start_dp"], powder["skip_end_dp"]),
            )


def read_plan(path):
    """The plan of a file."""
    plan = yaml.safe_load(Path(path).read_text())
    runs, groups = {}, {}
    for group in plan["groups"]:
        for run in runs_of(group, plan):
            runs[run.name] = run
            members = groups.setdefault(group["study"], [])
            if run.name not in members:
                members.append(run.name)
    grid = plan["two_body"]
    return Plan(
        scene=plan["scene"],
        folder=plan["folder"],
        grid={key: grid[key] for key in ("phases", "steps_per_decade", "ramp", "bond_numbers", "schemes")},
        two_body=two_body_cases(grid),
        runs=dict(sorted(runs.items(), key=lambda item: (item[1].kind, item[1].time_step))),
        groups=groups,
    )
