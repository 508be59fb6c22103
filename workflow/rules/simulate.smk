# Running recoat-solve.
#
# The solver works in a folder of its own below the case, which Snakemake does not know and so does not clear after a
# failure: an interrupted run continues from its last checkpoint. What it made is linked into place at the end.

STAGES = ["fill", "heap", "spread"]


rule simulate_layer:
    """Fill, heap and spread one case; the state after each stage and the run's summary are the result."""
    message:
        "Spreading Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    input:
        solver=SOLVER,
        scene=config["scene"],
    output:
        fill=case_file("fill.vtkhdf", kind="layers"),
        heap=case_file("heap.vtkhdf", kind="layers"),
        spread=case_file("spread.vtkhdf", kind="layers"),
        summary=case_file("summary.json", kind="layers"),
    params:
        work=lambda wildcards, output: Path(output.summary).parent / "run",
        settings=lambda wildcards: overrides("layers", wildcards),
    log:
        case_file("solve.log", kind="layers"),
    benchmark:
        case_file("solve.tsv", kind="layers")
    threads: config["solver_threads"]
    resources:
        gpu=config["gpus"],
    conda:
        ENVIRONMENT
    shell:
        "{input.solver} run {input.scene} --out {params.work} --overwrite --threads {threads} {params.settings}"
        " > {log} 2>&1 && for result in {output}; do ln -f {params.work}/$(basename $result) $result; done"


rule simulate_fill:
    """Fill one case and stop; the packed bed and the run's summary are the result."""
    message:
        "Filling Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    input:
        solver=SOLVER,
        scene=config["scene"],
    output:
        fill=case_file("fill.vtkhdf", kind="fills"),
        summary=case_file("summary.json", kind="fills"),
    params:
        work=lambda wildcards, output: Path(output.summary).parent / "run",
        settings=lambda wildcards: overrides("fills", wildcards),
    log:
        case_file("solve.log", kind="fills"),
    benchmark:
        case_file("solve.tsv", kind="fills")
    threads: config["solver_threads"]
    resources:
        gpu=config["gpus"],
    conda:
        ENVIRONMENT
    shell:
        "{input.solver} run {input.scene} --out {params.work} --overwrite --threads {threads} {params.settings}"
        " > {log} 2>&1 && for result in {output}; do ln -f {params.work}/$(basename $result) $result; done"


rule derive:
    """Every number that follows from the scene of one case: moduli, Hamaker constants, time step limits."""
    message:
        "Derived numbers of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}"
    input:
        solver=SOLVER,
        scene=config["scene"],
    output:
        case_file("derived.json"),
    params:
        settings=lambda wildcards: overrides(wildcards.kind, wildcards),
    log:
        case_file("derive.log"),
    benchmark:
        case_file("derive.tsv")
    conda:
        ENVIRONMENT
    shell:
        "{input.solver} check {input.scene} --json {params.settings} > {output} 2> {log}"
