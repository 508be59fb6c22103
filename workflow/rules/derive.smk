# What follows from a scene without running it.


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
