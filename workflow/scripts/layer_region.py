"""Analysis configuration of a spread layer: the blade's path less what the grid leaves out at its ends."""

from reporting import Implausible, logged, write_json
from states import read_state


def layer_region(state, skip_start_dp, skip_end_dp, settings):
    """Configuration of recoat-analyze for the layer behind the blade; lengths in metres [paper, section 3].

    `settings` are further keys of that configuration.
    """
    diameter = state.diameter
    start = float(state.info["blade_start"])
    spread_dp = float(state.info["spread_length"]) / diameter
    cells = int(spread_dp - skip_start_dp - skip_end_dp + 1e-6)
    if cells < 3:
        raise Implausible(
            f"{state.path}: the blade spread {spread_dp:g} particle diameters, of which {skip_start_dp:g} at the start "
            f"and {skip_end_dp:g} behind the blade are left out; give a longer spread or a smaller layer_region"
        )
    lower = start + skip_start_dp * diameter
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
