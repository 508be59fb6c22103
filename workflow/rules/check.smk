# Judging results before anything is drawn from them.


rule check_layer:
    """Refuse a spread layer whose run is implausible; no figure is drawn from it then."""
    message:
        "Checking Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        AT_ONCE
    input:
        summary=case_file("summary.json"),
        states=[case_file(f"{stage}.vtkhdf") for stage in STAGES],
        metrics=[case_file("bed.json"), case_file("layer.json")],
        script=script_file("check_case"),
        modules=[script_file("states"), script_file("reporting")],
    output:
        case_file("checks.json"),
    wildcard_constraints:
        kind=SPREAD_KIND,
    params:
        bounds=config["bounds"],
        stages=STAGES,
    log:
        case_file("check.log"),
    benchmark:
        case_file("check.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/check_case.py"


rule check_fill:
    """Refuse a packed bed whose run is implausible; no figure is drawn from it then."""
    message:
        "Checking the bed of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        AT_ONCE
    input:
        summary=case_file("summary.json", kind="fills"),
        states=[case_file("fill.vtkhdf", kind="fills")],
        metrics=[case_file("bed.json", kind="fills")],
        script=script_file("check_case"),
        modules=[script_file("states"), script_file("reporting")],
    output:
        case_file("checks.json", kind="fills"),
    params:
        bounds=config["bounds"],
        stages=["fill"],
    log:
        case_file("check.log", kind="fills"),
    benchmark:
        case_file("check.tsv", kind="fills")
    conda:
        ENVIRONMENT
    script:
        "../scripts/check_case.py"
