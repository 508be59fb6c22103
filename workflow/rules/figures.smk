# Drawing. To add a figure: a script, its name in FIGURES (common.smk), its title and caption in report/figures.yaml.


rule figure:
    """Draw one figure from checked cases: vector, 300 dpi bitmap, and what it was drawn from."""
    message:
        "Drawing {wildcards.figure}"
    input:
        checks=lambda wildcards: case_files("checks.json", FIGURES[wildcards.figure]),
        metrics=figure_metrics,
        states=figure_states,
        script=script_file("{figure}"),
        modules=[
            script_file(name)
            for name in (
                "layers", "from_above", "from_side", "measured", "replicates", "pore_metrics", "resampling", "states", "style",
                "reporting",
            )
        ],
    output:
        vector=grid_file("figures/{figure}.pdf"),
        bitmap=report(grid_file("figures/{figure}.png"), caption="../report/figure.rst", category="Figures"),
        sources=grid_file("figures/{figure}.json"),
    params:
        cases=lambda wildcards: case_labels(FIGURES[wildcards.figure]),
        bootstrap=config["bootstrap"],
        caption=lambda wildcards: CAPTIONS[wildcards.figure]["caption"],
    log:
        grid_file("logs/{figure}.log"),
    benchmark:
        grid_file("benchmarks/{figure}.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/{wildcards.figure}.py"
