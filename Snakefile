# From a grid of cases to figures and a report; see docs/workflow.md.

from snakemake.utils import min_version, validate

min_version("9.0")

if "name" not in config:

    configfile: "config/reduced.yaml"


include: "workflow/rules/configuration.smk"


refuse_wrong(config, "grid.schema.json", " and ".join(map(str, workflow.configfiles)) or "--config")
validate(config, "config/schema/grid.schema.json")  # puts the defaults in place


include: "workflow/rules/common.smk"
include: "workflow/rules/sweep.smk" if config["gpus"] else "workflow/rules/simulate.smk"
include: "workflow/rules/derive.smk"
include: "workflow/rules/analyze.smk"
include: "workflow/rules/check.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/report.smk"


rule all:
    """The report of the grid, with every figure and table."""
    default_target: True
    message:
        "Report: {input}"
    input:
        grid_file("report.html"),
