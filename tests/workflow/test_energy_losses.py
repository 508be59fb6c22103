"""What was lost while a layer was spread, from sums over the whole run."""

import pandas
import pytest
import synthetic
from energy_losses import first_step, losses, shares, table
from reporting import Implausible


def run(spread=100.0):
    """A run of stages of 100, 50 and 200 steps that loses 1, 2 and 4 J per step before, `spread` times as much at last."""
    summary = synthetic.summary(["fill", "heap", "spread"])
    for stage, steps in zip(summary["stages"], (100, 50, 200)):
        stage["steps"] = steps
    rates = {"normal": 1.0, "tangential": 2.0, "rolling": 4.0}
    energy = {f"dissipated_{name}": rate * 150 + spread * 200 for name, rate in rates.items()}
    summary["energy"] |= energy
    # A row every 40 steps: the stage begins between two of them.
    steps = [0, 40, 80, 120, 150, 350]
    lost = {f"dissipated_{name}_J": [rate * min(k, 150) + spread * max(k - 150, 0) for k in steps] for name, rate in rates.items()}
    return pandas.DataFrame({"step": steps, **lost}), summary


def test_only_the_stage_counts():
    found = losses(*run())
    assert list(found.values()) == pytest.approx([20000, 20000, 20000])
    assert list(shares(*run()).values()) == pytest.approx([1 / 3] * 3)


def test_a_run_without_spreading_is_refused():
    _, summary = run()
    assert first_step(summary, "heap") == 100
    with pytest.raises(Implausible, match="no stage sweep"):
        first_step(summary, "sweep")


def test_table_has_a_row_per_layer():
    energy, summary = run()
    case = {"bond": 5.0, "ratio": 0.001, "seed": 2}
    found = table([case], [energy], [summary])
    assert found.loc[0, ["bond_number", "stiffness_ratio", "seed"]].tolist() == [5.0, 0.001, 2]
    assert found.loc[0, ["loss_collisions", "loss_sliding", "loss_rolling"]].sum() == pytest.approx(1)
