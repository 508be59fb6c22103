# Running recoat-solve where there are GPUs: several cases share one, which none of them fills.
#
# As without GPUs, each case has a folder of its own, which Snakemake does not know: cases that are finished are left as
# they are, interrupted ones continue. What it made is linked into place by a job of its own, and touched because the
# report of the sweep is newer.

rule sweep_file:
    """The cases of one sweep and what each of them sets."""
    message:
        "Cases of the sweep {wildcards.sweep}"
    input:
        script=script_file("sweep_file"),
        modules=[script_file("reporting")],
    output:
        grid_file("sweeps/{sweep}.yaml"),
    params:
        content=lambda wildcards: sweep_content(wildcards.sweep),
    log:
        grid_file("sweeps/{sweep}_file.log"),
    benchmark:
        grid_file("sweeps/{sweep}_file.tsv")
    localrule: True
    conda:
        ENVIRONMENT
    script:
        "../scripts/sweep_file.py"


rule sweep:
    """Run several cases at the same time on one GPU; the result is a line on each."""
    message:
        "Running the sweep {wildcards.sweep} (threads: {threads}, gpu: {resources.gpu})"
    input:
        solver=SOLVER,
        scene=config["scene"],
        file=grid_file("sweeps/{sweep}.yaml"),
        derived=lambda wildcards: [ancient(file) for file in case_files("derived.json", SWEEPS[wildcards.sweep])],
    output:
        grid_file("sweeps/{sweep}.txt"),
    params:
        backend=BACKEND,
        device=lambda wildcards: sweep_device(wildcards.sweep),
        threads_per_case=config["solver_threads"],
    log:
        grid_file("sweeps/{sweep}.log"),
    benchmark:
        grid_file("sweeps/{sweep}.tsv")
    threads: lambda wildcards: config["solver_threads"] * len(SWEEPS[wildcards.sweep])
    resources:
        gpu=config["gpus"],
        runtime=sweep_run_time,
    conda:
        ENVIRONMENT
    shell:
        "{input.solver} sweep {input.file} --overwrite --threads {params.threads_per_case}"
        " --backend {params.backend} --device {params.device} > {output} 2> {log}"


rule collect_layer:
    """The states of one case of a sweep run through fill, heap and spread, and the run's summary."""
    message:
        "Collecting Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    input:
        sweep_report(),
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
    log:
        case_file("solve.log"),
    benchmark:
        case_file("solve.tsv")
    localrule: True
    conda:
        ENVIRONMENT
    shell:
        "for result in {output}; do ln -f {params.work}/$(basename $result) $result || exit; done > {log} 2>&1"
        " && touch {output}"


rule collect_fill:
    """The packed bed of one case of a sweep that ends with it, and the run's summary."""
    message:
        "Collecting the bed of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    input:
        sweep_report("fills"),
    output:
        fill=case_file("fill.vtkhdf", kind="fills"),
        summary=case_file("summary.json", kind="fills"),
    params:
        work=lambda wildcards, output: Path(output.summary).parent / "run",
    log:
        case_file("solve.log", kind="fills"),
    benchmark:
        case_file("solve.tsv", kind="fills")
    localrule: True
    conda:
        ENVIRONMENT
    shell:
        "for result in {output}; do ln -f {params.work}/$(basename $result) $result || exit; done > {log} 2>&1"
        " && touch {output}"
