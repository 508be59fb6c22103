# From a grid of cases to figures and a report; see docs/workflow.md.

import sys

from snakemake.utils import min_version

min_version("9.0")

if not workflow.configfiles:

    configfile: "config/reduced.yaml"


sys.path.append(f"{workflow.basedir}/workflow/scripts")


include: "workflow/rules/common.smk"
include: "workflow/rules/sweep.smk" if config["gpus"] else "workflow/rules/simulate.smk"
include: "workflow/rules/derive.smk"
include: "workflow/rules/analyze.smk"
include: "workflow/rules/check.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/animation.smk"
include: "workflow/rules/report.smk"


if VARIATIONS:

    include: "workflow/rules/variations.smk"


rule all:
    """The report of the grid, with every figure and table."""
    default_target: True
    message:
        "Report: {input}"
    input:
        grid_file("report.html"),
