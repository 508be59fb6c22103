# What follows from a scene without running it.


rule derive:
    """Every number that follows from the scene of one case: moduli, time step limits, the run time to expect here."""
    message:
        "Derived numbers of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}"
    priority:
        turn
    input:
        solver=SOLVER,
        scene=config["scene"],
    output:
        case_file("derived.json"),
    params:
        settings=lambda wildcards: overrides(wildcards.kind, wildcards),
        backend=BACKEND,
    log:
        case_file("derive.log"),
    benchmark:
        case_file("derive.tsv")
    threads: config["solver_threads"]
    resources:
        gpu=config["gpus"],
    conda:
        ENVIRONMENT
    shell:
        "{input.solver} check {input.scene} --json --threads {threads} --backend {params.backend} {params.settings}"
        " > {output} 2> {log}"
