"""Analysis configuration of a spread layer: the blade's path less what the grid leaves out at its ends."""

from reporting import Implausible, logged, write_json
from states import read_state

OVERHANG = 1.0  # d_p by which the windows of the packing density reach out of the region


def undisturbed_end(state):
    """x up to which the layer is as the blade left it [m]; nothing has come back through the gap before it."""
    if "layer_end" not in state.info:
        raise Implausible(
            f"{state.path}: the file does not say where the layer ends that the blade left (layer_end), since an older "
            "recoat-solve wrote it; make it again with --forcerun simulate_layer"
        )
    return float(state.info["layer_end"])


def layer_region(state, skip_start_dp, skip_end_dp, settings):
    """Configuration of recoat-analyze for the layer behind the blade; lengths in metres [paper, section 3].

    The region ends skip_end_dp behind the blade, or where powder that flowed back under the stopped blade has been, if
    that is further behind. `settings` are further keys of that configuration.
    """
    diameter = state.diameter
    start = float(state.info["blade_start"])
    lower = start + skip_start_dp * diameter
    spread_dp = float(state.info["spread_length"]) / diameter
    undisturbed_dp = (undisturbed_end(state) - start) / diameter
    cells = int(min(spread_dp - skip_end_dp, undisturbed_dp - OVERHANG) - skip_start_dp + 1e-6)
    if cells < 3:
        raise Implausible(
            f"{state.path}: the blade spread {spread_dp:g} particle diameters, of which {skip_start_dp:g} at the start "
            f"and {skip_end_dp:g} behind the blade are left out, and powder flowed back over the last "
            f"{max(spread_dp - undisturbed_dp, 0):.3g}; give a longer spread or a smaller layer_region"
        )
    return {
        "d_p": diameter,
        "density": float(state.info["density"]),
        "h_b": float(state.info["clearance"]),
        "x_range": [lower, lower + cells * diameter],
        "y_min": float(state.info["y_min"]),
        "y_period": float(state.info["y_period"]),
        **settings,
    }


if __name__ == "__main__":
    with logged(snakemake):
        params = snakemake.params
        state = read_state(snakemake.input.state)
        write_json(
            snakemake.output[0],
            layer_region(state, params.skip_start_dp, params.skip_end_dp, dict(params.settings)),
        )
