"""The standard figures of one layer: plot_layer.py REPORT STATE FOLDER REASON, as recoat-analyze --plots calls it.

What goes wrong is written to the file REASON as one sentence.
"""

import importlib
import os
import sys
from pathlib import Path

# What a figure shows, and the script that draws it.
FIGURES = {
    "layer_from_above": "fig05_layer_maps",
    "height_map": "height_map",
    "coordination_number": "fig06_coordination_number",
    "vertical_distribution": "fig07_vertical_distribution",
    "clusters_from_above": "fig09_clusters",
    "cluster_size": "fig10_cluster_size",
    "cluster_orientation": "fig11_cluster_orientation",
    "surface_height": "fig12_surface_height",
    "pores_from_above": "fig14_pore_maps",
    "pore_size_distribution": "fig15_pore_size_distribution",
    "pore_size_groups": "fig16_pore_size_groups",
}


def save(figure, pyplot, folder, name):
    """PDF and PNG, each whole or not at all."""
    for ending, metadata in (("pdf", {"CreationDate": None}), ("png", {"Software": None})):
        part = folder / f".{name}.part.{ending}"
        figure.savefig(part, metadata=metadata)
        os.replace(part, folder / f"{name}.{ending}")
    pyplot.close(figure)


def draw(report, state, folder):
    """Every figure of a layer on its own; without a Bond number, since the report does not know it."""
    from layers import Layer
    from style import pyplot

    layer = Layer(None, None, None, str(report), str(state), {})
    folder.mkdir(parents=True, exist_ok=True)
    for name, script in FIGURES.items():
        save(importlib.import_module(script).draw([layer]), pyplot, folder, name)


def main(report, state, folder, reason):
    try:
        draw(Path(report), Path(state), Path(folder))
    except ImportError as error:
        Path(reason).write_text(
            f"the Python {sys.executable} has no package {error.name}; run ./setup.sh, or set RECOAT_PYTHON to one that has it"
        )
        return 1
    except Exception as error:
        Path(reason).write_text(f"{type(error).__name__}: {' '.join(str(error).split())}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
