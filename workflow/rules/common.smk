# The cases of the grid and where their files are. Every path below results/ is made by grid_file or case_file.

import json
import math
import os
import shlex
import sys
from collections import namedtuple
from itertools import product
from pathlib import Path

import yaml
from configuration import refusal
from snakemake.utils import validate


def require(data, schema, files):
    """Stop with one sentence, as bad input, where data that was read from these files is not as the schema says."""
    sentence = refusal(data, f"{workflow.basedir}/config/schema/{schema}", files)
    if sentence:
        print(f"recoat: {sentence}", file=sys.stderr)
        sys.exit(2)


require(config, "grid.schema.json", workflow.configfiles)
validate(config, "../../config/schema/grid.schema.json")  # puts in the defaults
with open(config["scene"]) as scene_file:
    require(yaml.safe_load(scene_file), "scene.schema.json", [config["scene"]])


wildcard_constraints:
    kind="layers|fills|vary-[A-Za-z0-9_-]+",
    stage="fill|heap|spread",
    bond=r"[0-9.e+-]+",
    ratio=r"[0-9.e+-]+",
    seed="[0-9]+",
    sweep="(layers|fills|vary-[A-Za-z0-9_-]+)-[0-9]+",


Case = namedtuple("Case", "kind bond ratio seed")

SPREAD_KIND = "layers|vary-[A-Za-z0-9_-]+"  # cases that are run through fill, heap and spread

STAGES = ["fill", "heap", "spread"]

ENVIRONMENT = "../envs/python.yaml"
SOLVER = ancient(f"{config['build_directory']}/solver/recoat-solve")
BACKEND = config.get("backend", "cuda" if config["gpus"] else "auto")
ANALYZER = ancient(f"{config['build_directory']}/analyzer/recoat-analyze")


def grid_file(name):
    """Path of a file that belongs to the whole grid."""
    return f"results/{config['name']}/{name}"


def case_file(name, case=None, kind="{kind}"):
    """Path of a file of one case, or the pattern of all such paths."""
    pattern = grid_file(f"{kind}/bond-{{bond}}_ratio-{{ratio}}_seed-{{seed}}/{name}")
    return pattern.format(**case._asdict()) if case else pattern


def case_files(name, cases):
    """The same file of several cases, in their order."""
    return [case_file(name, case, case.kind) for case in cases]


def tag(value):
    """A number as it is written in paths: 1e-3, 0.001 and .001 give one name."""
    return f"{float(value):.12g}"


def cases_of(kind, groups):
    """Every case of the groups, each once, in the order of the configuration."""
    cases = {}
    for group in groups:
        for bond, ratio, seed in product(group["bond_numbers"], group["stiffness_ratios"], config["seeds"]):
            cases[Case(kind, tag(bond), tag(ratio), str(seed))] = None
    return list(cases)


LAYERS = cases_of("layers", config["layers"])
FILL_ONLY = [case for case in cases_of("fills", config["fills"]) if case._replace(kind="layers") not in LAYERS]
CASES = LAYERS + FILL_ONLY
VARIATIONS = {entry["name"]: entry for entry in config["variations"]}
VARIED = [case._replace(kind=f"vary-{name}") for name in VARIATIONS for case in LAYERS]

# Cases in the order in which they are begun: all with the first seed, then all with the second, so that a grid that is
# stopped early has a layer of every Bond number.
IN_TURN = sorted(CASES, key=lambda case: [str(seed) for seed in config["seeds"]].index(case.seed))
TURNS = {case: len(IN_TURN) - number for number, case in enumerate(IN_TURN)}
AT_ONCE = len(CASES) + 1  # priority of what follows a finished case, so that it can be looked at while others run


def turn(wildcards, kind=None):
    """Priority of a case: the higher, the sooner it is its turn; one that is asked for beside the grid comes last."""
    return TURNS.get(Case(kind or wildcards.kind, wildcards.bond, wildcards.ratio, wildcards.seed), 0)


REFERENCE_RATIO = min((case.ratio for case in LAYERS), key=float)
REFERENCE_LAYERS = [case for case in LAYERS if case.ratio == REFERENCE_RATIO]


def time_step(bond, ratio):
    """The first of time_steps that is for this stiffness ratio and reaches this Bond number; else the automatic one."""
    for entry in config["time_steps"]:
        if tag(entry["stiffness_ratio"]) == ratio and float(bond) <= entry.get("largest_bond_number", float("inf")):
            return entry["time_step"]
    return "auto"


def ratio_cases():
    """Layers of the Bond numbers that were spread at several stiffness ratios."""
    ratios = {bond: {case.ratio for case in LAYERS if case.bond == bond} for bond in {case.bond for case in LAYERS}}
    return [case for case in LAYERS if len(ratios[case.bond]) > 1]


def bed_cases():
    """Packed beds of the Bond numbers that were filled at several stiffness ratios; all where there are none."""
    ratios = {bond: {case.ratio for case in CASES if case.bond == bond} for bond in {case.bond for case in CASES}}
    return [case for case in CASES if len(ratios[case.bond]) > 1] or CASES


def rendered_case():
    """The layer of the three-dimensional picture: the reference layer nearest to the Bond number asked for."""
    wanted = float(config["rendered_bond_number"])
    return [min(REFERENCE_LAYERS, key=lambda case: abs(float(case.bond) - wanted))]


# Every figure: the script workflow/scripts/NAME.py draws it from the metrics of these cases, and
# workflow/report/figures.yaml holds its title and caption. A figure without cases is left out.
FIGURES = {
    name: cases
    for name, cases in {
        "fig01_schematic": rendered_case(),
        "fig02_global_packing": bed_cases(),
        "fig03_layers_by_ratio": ratio_cases(),
        "fig04_packing_by_ratio": ratio_cases(),
        "fig05_layer_maps": REFERENCE_LAYERS,
        "fig05_rendered_layer": rendered_case(),
        "fig06_coordination_number": REFERENCE_LAYERS,
        "fig07_vertical_distribution": REFERENCE_LAYERS,
        "fig08_packing_by_bond": REFERENCE_LAYERS,
        "fig09_clusters": REFERENCE_LAYERS,
        "fig10_cluster_size": REFERENCE_LAYERS,
        "fig11_cluster_orientation": REFERENCE_LAYERS,
        "fig12_surface_height": REFERENCE_LAYERS,
        "fig13_roughness": REFERENCE_LAYERS,
        "fig14_pore_maps": REFERENCE_LAYERS,
        "fig15_pore_size_distribution": REFERENCE_LAYERS,
        "fig16_pore_size_groups": REFERENCE_LAYERS,
    }.items()
    if cases
}

BED_FIGURES = ["fig02_global_packing"]


def figure_metrics(wildcards):
    """The analysed files a figure is drawn from."""
    name = "bed.json" if wildcards.figure in BED_FIGURES else "layer.json"
    return case_files(name, FIGURES[wildcards.figure])


def figure_states(wildcards):
    """The particle states behind those files."""
    if wildcards.figure == "fig01_schematic":
        return [case_file(f"{stage}.vtkhdf", case, case.kind) for case in rendered_case() for stage in STAGES]
    name = "fill.vtkhdf" if wildcards.figure in BED_FIGURES else "spread.vtkhdf"
    return case_files(name, FIGURES[wildcards.figure])


def case_labels(cases):
    """Bond number, stiffness ratio and seed of each case, for scripts."""
    return [{"bond": float(case.bond), "ratio": float(case.ratio), "seed": int(case.seed)} for case in cases]


def fill_stage():
    """The scene's list of stages cut off after its first stage, as a --set value."""
    with open(config["scene"]) as scene_file:
        stages = yaml.safe_load(scene_file)["stages"]
    return yaml.safe_dump(stages[:1], default_flow_style=True, width=float("inf")).strip()


def settings_of(kind, case):
    """What one case sets, as texts "a.b=v"; a case that ends with the fill stage has no others to set."""
    settings = dict(config["scene_overrides"])
    if kind == "fills":
        later = [key for key in settings if key.startswith("stages.") and not key.startswith("stages.fill.")]
        settings = {"stages": fill_stage()} | {key: value for key, value in settings.items() if key not in later}
    settings["cohesion.bond_number"] = case.bond
    settings["stiffness_ratio"] = case.ratio
    settings["time_step"] = time_step(case.bond, case.ratio)
    settings["seed"] = case.seed
    settings |= varied(kind).get("set", {})
    return [f"{key}={value}" for key, value in settings.items()]


def overrides(kind, case):
    """The same as --set options."""
    return " ".join(f"--set {shlex.quote(setting)}" for setting in settings_of(kind, case))


def runs_anew(kind):
    """Whether a variation changes the scene, and not only what is analysed of the layer."""
    return bool(varied(kind).get("set"))


def varied(kind):
    """What a variation changes; nothing for the grid's own layers and fills."""
    return VARIATIONS.get(kind.removeprefix("vary-"), {}) if kind.startswith("vary-") else {}


def source(case):
    """The case whose states one is analysed from: that of the grid itself where the scene is the same."""
    kind = "layers" if case.kind.startswith("vary-") and not runs_anew(case.kind) else case.kind
    return Case(kind, case.bond, case.ratio, case.seed)


def spread_state(wildcards):
    """An input function: the state that the layer of a case is analysed from."""
    found = source(wildcards)
    return case_file("spread.vtkhdf", found, found.kind)


def region_of(kind, key):
    """What is left out of the analysis at the start or behind the blade [d_p]."""
    return varied(kind).get("layer_region", {}).get(key, config["layer_region"][key])


def sweeps_of(kind):
    """The cases of one kind that are in the grid, in groups that share a GPU, by the name of the group."""
    cases, size = [case for case in CASES + VARIED if case.kind == kind], config["cases_per_gpu"]
    return {f"{kind}-{i // size + 1}": cases[i : i + size] for i in range(0, len(cases), size)}


# Layers and fills apart: a sweep takes as long as its longest case.
SWEEPS = {}
for kind in ["layers", "fills", *(f"vary-{name}" for name in VARIATIONS)]:
    SWEEPS |= sweeps_of(kind)


def sweep_report(kind=None):
    """An input function: the report of the sweep that a case is in."""

    def report(wildcards):
        wanted = Case(kind or wildcards.kind, wildcards.bond, wildcards.ratio, wildcards.seed)
        return [grid_file(f"sweeps/{name}.txt") for name, cases in SWEEPS.items() if wanted in cases]

    return report


def expected_seconds(file):
    """Run time at most of one case [s], as recoat-solve check measured it."""
    with open(file) as derived:
        return json.load(derived)["expected"]["seconds"]


def minutes(seconds):
    """Run time to ask for: half as much again, since machines differ, and ten minutes; no more than the grid says."""
    return min(10 + math.ceil(1.5 * seconds / 60), math.ceil(60 * config["longest_job_hours"]))


def run_time(wildcards, input):
    """Run time of the job that simulates one case [min]; not known before its derived.json is there."""
    return minutes(expected_seconds(input.derived))


def sweep_run_time(wildcards, input):
    """Run time of a sweep [min]: its cases share one device."""
    return minutes(sum(expected_seconds(file) for file in input.derived))


def sweep_device(name):
    """Number of the CUDA device of a sweep: the devices take turns."""
    return config["devices"][list(SWEEPS).index(name) % len(config["devices"])]


def sweep_content(name):
    """What a sweep file holds; paths start from its folder."""
    folder = grid_file("sweeps")
    return {
        "scene": os.path.relpath(config["scene"], folder),
        "cases": [
            {"out": os.path.relpath(case_file("run", case, case.kind), folder), "set": settings_of(case.kind, case)}
            for case in SWEEPS[name]
        ],
    }


def script_file(name):
    """Path of a script, so that a rule can name it as an input."""
    return f"workflow/scripts/{name}.py"


with open("workflow/report/figures.yaml") as captions_file:
    CAPTIONS = yaml.safe_load(captions_file)

CONFIGURATION = yaml.safe_dump(json.loads(json.dumps(config)), sort_keys=False)
