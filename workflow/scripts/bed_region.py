"""Analysis configuration of a packed bed: the box between blade and gate, up to 0.9 of the highest point."""

from reporting import Implausible, logged, write_json
from states import fill_box, read_state

TOP_SHARE = 0.9  # of the bed's height; what lies above is free surface [paper, eq. 14]


def bed_region(state, voxels_per_dp):
    """Configuration of recoat-analyze for the bed; lengths in metres.

    h_b is 0.9 z_max, so that the packing density map holds the columns whose mean is the global density of eq. 14.
    """
    lower, upper = fill_box(state)
    if len(state.points) == 0:
        raise Implausible(f"{state.path}: the packed bed has no particles")
    return {
        "d_p": state.diameter,
        "density": float(state.info["density"]),
        "h_b": TOP_SHARE * float((state.points[:, 2] + state.radius).max()),
        "x_range": [lower, upper],
        "y_min": float(state.info["y_min"]),
        "y_period": float(state.info["y_period"]),
        "phi_x_edge": "interior",
        "voxels_per_dp": voxels_per_dp,
        "bootstrap_resamples": 0,  # the walls make x inhomogeneous; beds are resampled along the period
    }


if __name__ == "__main__":
    with logged(snakemake):
        write_json(snakemake.output[0], bed_region(read_state(snakemake.input.state), snakemake.params.voxels_per_dp))
