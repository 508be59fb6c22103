# Tables and the report.


rule metrics_table:
    """One row per case: every scalar metric with its interval."""
    message:
        "Table of metrics"
    input:
        checks=case_files("checks.json", LAYERS),
        layers=case_files("layer.json", LAYERS),
        states=case_files("spread.vtkhdf", LAYERS),
        script=script_file("metrics_table"),
        modules=[
            script_file(name)
            for name in (
                *("layers", "layer_metrics", "pore_metrics", "extremes", "resampling", "states", "reporting"),
                *("verdicts", "measured"),
            )
        ],
    output:
        grid_file("tables/metrics.csv"),
    params:
        cases=case_labels(LAYERS),
        bootstrap=config["bootstrap"],
    log:
        grid_file("logs/metrics.log"),
    benchmark:
        grid_file("benchmarks/metrics.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/metrics_table.py"


rule beds_table:
    """Global packing density of every packed bed with its interval [paper, eq. 14]."""
    message:
        "Table of packed beds"
    input:
        checks=case_files("checks.json", CASES),
        layers=case_files("bed.json", CASES),
        states=case_files("fill.vtkhdf", CASES),
        script=script_file("beds_table"),
        modules=[script_file("layers"), script_file("resampling"), script_file("states"), script_file("reporting")],
    output:
        grid_file("tables/beds.csv"),
    params:
        cases=case_labels(CASES),
        bootstrap=config["bootstrap"],
    log:
        grid_file("logs/beds.log"),
    benchmark:
        grid_file("benchmarks/beds.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/beds_table.py"


rule derived_table:
    """The derived numbers of every case, one column per case."""
    message:
        "Table of derived numbers"
    input:
        derived=case_files("derived.json", CASES),
        script=script_file("derived_table"),
        modules=[script_file("reporting")],
    output:
        grid_file("tables/derived.csv"),
    params:
        cases=case_labels(CASES),
    log:
        grid_file("logs/derived.log"),
    benchmark:
        grid_file("benchmarks/derived.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/derived_table.py"


rule runtime_table:
    """Steps, wall time and particle-steps per second of every stage of every case."""
    message:
        "Table of run times"
    input:
        summaries=case_files("summary.json", CASES),
        script=script_file("runtime_table"),
        modules=[script_file("reporting")],
    output:
        grid_file("tables/runtime.csv"),
    params:
        cases=case_labels(CASES),
    log:
        grid_file("logs/runtime.log"),
    benchmark:
        grid_file("benchmarks/runtime.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/runtime_table.py"


rule energy_table:
    """Energy lost while spreading, by collisions, sliding and rolling, of every layer [paper, section 5.5]."""
    message:
        "Table of energy losses"
    input:
        checks=case_files("checks.json", LAYERS),
        energies=case_files("energy.csv", LAYERS),
        summaries=case_files("summary.json", LAYERS),
        script=script_file("energy_losses"),
        modules=[script_file("reporting")],
    output:
        grid_file("tables/energy.csv"),
    params:
        cases=case_labels(LAYERS),
    log:
        grid_file("logs/energy.log"),
    benchmark:
        grid_file("benchmarks/energy.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/energy_losses.py"


rule comparison_table:
    """What the paper states beside what this grid gives."""
    message:
        "Comparison with the paper"
    input:
        metrics=grid_file("tables/metrics.csv"),
        beds=grid_file("tables/beds.csv"),
        energy=grid_file("tables/energy.csv"),
        runtime=grid_file("tables/runtime.csv"),
        derived=case_files("derived.json", REFERENCE_LAYERS),
        script=script_file("comparison_table"),
        modules=[
            script_file(name)
            for name in (
                *("statements", "packing_statements", "cluster_statements", "surface_statements", "pore_statements"),
                "mechanism_statements",
                *("pore_metrics", "extremes", "comparisons", "verdicts", "measured", "reporting"),
            )
        ],
    output:
        grid_file("tables/comparison.csv"),
    params:
        cases=case_labels(REFERENCE_LAYERS),
        reference_ratio=float(REFERENCE_RATIO),
    log:
        grid_file("logs/comparison.log"),
    benchmark:
        grid_file("benchmarks/comparison.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/comparison_table.py"


rule report:
    """One self-contained page: figures, captions, tables, versions, seeds, files."""
    message:
        "Writing the report of grid {params.name}"
    input:
        figures=[grid_file(f"figures/{name}.png") for name in FIGURES],
        sources=[grid_file(f"figures/{name}.json") for name in FIGURES],
        comparison=grid_file("tables/comparison.csv"),
        metrics=grid_file("tables/metrics.csv"),
        beds=grid_file("tables/beds.csv"),
        derived=grid_file("tables/derived.csv"),
        energy=grid_file("tables/energy.csv"),
        runtime=grid_file("tables/runtime.csv"),
        summaries=case_files("summary.json", CASES),
        checks=case_files("checks.json", CASES),
        captions="workflow/report/figures.yaml",
        template="workflow/report/report.html.j2",
        script=script_file("report"),
        modules=[script_file(name) for name in ("readable", "verdicts", "reporting")],
    output:
        grid_file("report.html"),
    params:
        name=config["name"],
        cases=case_labels(CASES),
        configuration=CONFIGURATION,
    log:
        grid_file("logs/report.log"),
    benchmark:
        grid_file("benchmarks/report.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/report.py"
