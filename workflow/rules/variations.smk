# Sensitivity: the grid's layers once more, with one choice changed at a time; see config/sensitivity.yaml.


rule sensitivity:
    """What each choice changes in the metrics that the paper speaks of: a table and a figure."""
    message:
        "Sensitivity of grid {params.name}"
    input:
        checks=case_files("checks.json", LAYERS + [case for case in VARIED if runs_anew(case.kind)]),
        layers=case_files("layer.json", LAYERS + VARIED),
        states=[case_file("spread.vtkhdf", source(case), source(case).kind) for case in LAYERS + VARIED],
        script=script_file("sensitivity"),
        modules=[
            script_file(name)
            for name in (
                *("layers", "layer_metrics", "pore_metrics", "resampling", "states", "reporting"),
                *("style", "verdicts", "measured"),
            )
        ],
    output:
        table=grid_file("tables/sensitivity.csv"),
        text=grid_file("tables/sensitivity.md"),
        vector=grid_file("figures/sensitivity.pdf"),
        bitmap=grid_file("figures/sensitivity.png"),
    params:
        name=config["name"],
        cases=case_labels(LAYERS + VARIED),
        kinds=[case.kind for case in LAYERS + VARIED],
        titles={f"vary-{name}": entry["title"] for name, entry in VARIATIONS.items()},
        bootstrap=config["bootstrap"],
    log:
        grid_file("logs/sensitivity.log"),
    benchmark:
        grid_file("benchmarks/sensitivity.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/sensitivity.py"
