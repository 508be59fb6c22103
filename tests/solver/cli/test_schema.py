"""The JSON Schema of scenes and the solver's own reader agree."""

import pytest
import yaml

EXAMPLES = ["config/scene.yaml"] + [
    f"config/examples/{name}.yaml" for name in ("small_spread", "unequal_spread", "collision", "wall_impact", "sliding", "pull_off")
]


def test_every_example_is_listed_here(root):
    assert sorted(EXAMPLES[1:]) == sorted(str(f.relative_to(root)) for f in (root / "config/examples").glob("*.yaml"))


@pytest.mark.parametrize("example", EXAMPLES)
def test_examples_satisfy_both(solver, validator, root, example):
    validator.validate(yaml.safe_load((root / example).read_text()))
    resolved = solver.good("run", root / example, "--print-config")
    validator.validate(yaml.safe_load(resolved))


# What replaces the value at a path; None removes the key.
BAD_SPREAD = [
    (["scene"], "spraed"),
    (["scene"], None),
    (["time_step"], "1e-7"),
    (["time_step"], "automatic"),
    (["pair_lists"], {"skin": "0 dp"}),
    (["pair_lists"], {"close_steps": 0}),
    (["pair_lists"], {"far": "1 dp"}),
    (["sleep"], "perhaps"),
    (["time_step"], "0 s"),
    (["time_step"], "1e-7 m"),
    (["gravity"], "-9.81 m/s2"),
    (["stiffness_ratio"], 0),
    (["stiffness_ratio"], 2),
    (["material", "diameter"], 50),
    (["material", "diameter"], "1 dp"),
    (["material", "colour"], "blue"),
    (["material", "poisson_ratio"], 0.7),
    (["contact", "restitution"], 0),
    (["contact", "sliding_friction"], -1),
    (["contact", "lever_arm"], "long"),
    (["contact", "dashpot_cap"], "perhaps"),
    (["cohesion", "hamaker"], "1e-20 J"),
    (["cohesion", "bond_number"], None),
    (["powder", "particles"], 0),
    (["powder", "particles"], 1.5),
    (["powder"], None),
    (["blade", "speed"], "fast"),
    (["blade", "clearance"], None),
    (["box", "depth"], "3 dp"),
    (["stages"], []),
    (["stages", 0], {"bake": {}}),
    (["stages", 2, "spread", "stragglers"], -1),
    (["stages", 2, "spread", "stragglers"], "few"),
    (["stages", 2, "spread", "length"], "0 dp"),
    (["output", "trajectory"], "1 ms"),
    (["walls"], []),
]
BAD_PARTICLES = [
    (["particles"], None),
    (["duration"], None),
    (["duration"], 1),
    (["stages"], ["settle"]),
    (["walls", 0, "plane", "name"], None),
    (["walls", 0, "plane", "normal"], [0, 1]),
    (["walls", 0], {"sphere": {"name": "ball"}}),
    (["walls", 0, "plane", "velocity"], [0, 0, 1]),
    (["blade"], {"clearance": "1 dp"}),
]


def changed(config, path, value):
    place = config
    for key in path[:-1]:
        place = place[key]
    if value is None:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return config


@pytest.mark.parametrize(
    "file, path, value",
    [("spread.yaml", *case) for case in BAD_SPREAD] + [("particles.yaml", *case) for case in BAD_PARTICLES],
)
def test_both_refuse(solver, validator, file, path, value):
    config = yaml.safe_load((solver.folder / file).read_text())
    assert validator.is_valid(config)
    config = changed(config, path, value)
    assert not validator.is_valid(config)
    solver.write("bad.yaml", yaml.safe_dump(config, sort_keys=False))
    assert "bad.yaml" in solver.refusal("run", "bad.yaml", "--print-config")


@pytest.mark.parametrize(
    "path, value",
    [
        (["stiffness_ratio"], "1e-3"),
        (["gravity"], "9810 mm/s2"),
        (["material", "diameter"], "5e-5m"),
        (["blade", "position"], "-1 dp"),
        (["blade", "height"], 0),
        (["stages", 1], "heap"),
        (["stages", 2, "spread", "stragglers"], "auto"),
        (["stages", 2, "spread", "stragglers"], 12),
        (["output"], {}),
    ],
)
def test_both_agree_on_unusual_values(solver, validator, path, value):
    config = changed(yaml.safe_load((solver.folder / "spread.yaml").read_text()), path, value)
    solver.write("odd.yaml", yaml.safe_dump(config, sort_keys=False))
    accepted = solver("run", "odd.yaml", "--print-config").returncode == 0
    assert validator.is_valid(config) == accepted
