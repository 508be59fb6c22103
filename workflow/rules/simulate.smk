# Running recoat-solve.
#
# The solver works in a folder of its own below the case, which Snakemake does not know and so does not clear after a
# failure: an interrupted run continues from its last checkpoint. What it made is linked into place at the end.
# With GPUs sweep.smk takes the place of this file.

rule simulate_layer:
    """Fill, heap and spread one case; the state after each stage and the run's summary are the result."""
    message:
        "Spreading Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        turn
    input:
        solver=SOLVER,
        scene=config["scene"],
        derived=ancient(case_file("derived.json")),
    output:
        fill=case_file("fill.vtkhdf"),
        heap=case_file("heap.vtkhdf"),
        spread=case_file("spread.vtkhdf"),
        energy=case_file("energy.csv"),
        summary=case_file("summary.json"),
    wildcard_constraints:
        kind=SPREAD_KIND,
    params:
        work=lambda wildcards, output: Path(output.summary).parent / "run",
        settings=lambda wildcards: overrides(wildcards.kind, wildcards),
        backend=BACKEND,
    log:
        case_file("solve.log"),
    benchmark:
        case_file("solve.tsv")
    threads: config["solver_threads"]
    resources:
        runtime=run_time,
    conda:
        ENVIRONMENT
    shell:
        "{input.solver} run {input.scene} --out {params.work} --overwrite --threads {threads}"
        " --backend {params.backend} {params.settings}"
        " > {log} 2>&1 && for result in {output}; do ln -f {params.work}/$(basename $result) $result; done"


rule simulate_fill:
    """Fill one case and stop; the packed bed and the run's summary are the result."""
    message:
        "Filling Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        lambda wildcards: turn(wildcards, "fills")
    input:
        solver=SOLVER,
        scene=config["scene"],
        derived=ancient(case_file("derived.json", kind="fills")),
    output:
        fill=case_file("fill.vtkhdf", kind="fills"),
        summary=case_file("summary.json", kind="fills"),
    params:
        work=lambda wildcards, output: Path(output.summary).parent / "run",
        settings=lambda wildcards: overrides("fills", wildcards),
        backend=BACKEND,
    log:
        case_file("solve.log", kind="fills"),
    benchmark:
        case_file("solve.tsv", kind="fills")
    threads: config["solver_threads"]
    resources:
        runtime=run_time,
    conda:
        ENVIRONMENT
    shell:
        "{input.solver} run {input.scene} --out {params.work} --overwrite --threads {threads}"
        " --backend {params.backend} {params.settings}"
        " > {log} 2>&1 && for result in {output}; do ln -f {params.work}/$(basename $result) $result; done"
