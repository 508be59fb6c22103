# What needs the states kept on the way; asked for by name, such as results/NAME/layers/bond-5_ratio-0.001_seed-1/animation.gif.


rule animation:
    """A run from the side, particles coloured by their velocity along x."""
    message:
        "Animating Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    input:
        summary=case_file("summary.json"),
        script=script_file("animation"),
        modules=[script_file(name) for name in ("from_side", "states", "style", "reporting")],
    output:
        case_file("animation.gif"),
    params:
        run=lambda wildcards, output: Path(output[0]).parent / "run",
    log:
        case_file("animation.log"),
    benchmark:
        case_file("animation.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/animation.py"


rule stopping:
    """How far particles travel once the blade has released them, beside the inertial lengths [paper, section 5.5]."""
    message:
        "Stopping distances of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    input:
        summary=case_file("summary.json"),
        state=case_file("spread.vtkhdf"),
        region=case_file("layer_region.json"),
        derived=case_file("derived.json"),
        script=script_file("stopping"),
        modules=[script_file(name) for name in ("states", "reporting")],
    output:
        case_file("stopping.json"),
    wildcard_constraints:
        kind=SPREAD_KIND,
    params:
        trajectory=lambda wildcards, output: Path(output[0]).parent / "run" / "trajectory.vtkhdf",
    log:
        case_file("stopping.log"),
    benchmark:
        case_file("stopping.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/stopping.py"
