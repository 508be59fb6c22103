# Animations: asked for by name, such as results/NAME/layers/bond-5_ratio-0.001_seed-1/animation.gif.


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
