"""A sweep file for recoat-solve."""

import yaml

from reporting import logged, write_text

if __name__ == "__main__":
    with logged(snakemake):
        write_text(
            snakemake.output[0], yaml.safe_dump(dict(snakemake.params.content), sort_keys=False, width=float("inf"))
        )
