# Running recoat-analyze.


rule layer_region:
    """The part of the layer that is analysed, from the blade's path stored in the state."""
    message:
        "Region of the layer of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        AT_ONCE
    input:
        state=spread_state,
        script=script_file("layer_region"),
        modules=[script_file("states"), script_file("reporting")],
    output:
        case_file("layer_region.json"),
    wildcard_constraints:
        kind=SPREAD_KIND,
    params:
        skip_start_dp=lambda wildcards: region_of(wildcards.kind, "skip_start_dp"),
        skip_end_dp=lambda wildcards: region_of(wildcards.kind, "skip_end_dp"),
        settings={
            "voxels_per_dp": config["voxels_per_dp"],
            "chamber_min_diameter": config["chamber_min_diameter_dp"],
            "bootstrap_block": config["bootstrap"]["block_dp"],
            "bootstrap_resamples": config["bootstrap"]["resamples"],
        },
    log:
        case_file("layer_region.log"),
    benchmark:
        case_file("layer_region.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/layer_region.py"


rule bed_region:
    """The fill box and the height of the packed bed in it, for the global packing density of eq. 14."""
    message:
        "Region of the bed of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        AT_ONCE
    input:
        state=case_file("fill.vtkhdf"),
        script=script_file("bed_region"),
        modules=[script_file("states"), script_file("reporting")],
    output:
        case_file("bed_region.json"),
    params:
        voxels_per_dp=config["voxels_per_dp"],
    log:
        case_file("bed_region.log"),
    benchmark:
        case_file("bed_region.tsv")
    conda:
        ENVIRONMENT
    script:
        "../scripts/bed_region.py"


rule analyze_layer:
    """All metrics of one spread layer."""
    message:
        "Analysing the layer of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        AT_ONCE
    input:
        analyzer=ANALYZER,
        state=spread_state,
        region=case_file("layer_region.json"),
    output:
        json=case_file("layer.json"),
        tables=case_file("layer.h5"),
    wildcard_constraints:
        kind=SPREAD_KIND,
    log:
        case_file("analyze_layer.log"),
    benchmark:
        case_file("analyze_layer.tsv")
    conda:
        ENVIRONMENT
    shell:
        "{input.analyzer} metrics {input.state} --config {input.region}"
        " --json {output.json} --out {output.tables} > {log} 2>&1"


rule analyze_bed:
    """Global packing density of one packed bed [paper, eq. 14]."""
    message:
        "Analysing the bed of Bo = {wildcards.bond}, stiffness ratio {wildcards.ratio}, seed {wildcards.seed}"
    priority:
        AT_ONCE
    input:
        analyzer=ANALYZER,
        state=case_file("fill.vtkhdf"),
        region=case_file("bed_region.json"),
    output:
        json=case_file("bed.json"),
        tables=case_file("bed.h5"),
    log:
        case_file("analyze_bed.log"),
    benchmark:
        case_file("analyze_bed.tsv")
    conda:
        ENVIRONMENT
    shell:
        "{input.analyzer} metrics {input.state} --config {input.region}"
        " --json {output.json} --out {output.tables} > {log} 2>&1"
