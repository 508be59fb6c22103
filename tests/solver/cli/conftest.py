"""The solver as a user calls it."""

import json
import subprocess

import jsonschema
import pytest

MODEL = """
stiffness_ratio: 0.001
time_step: 1e-7 s
gravity: 9.81 m/s2
material: {diameter: 50 um, density: 4430 kg/m3, young_modulus: 110 GPa, poisson_ratio: 0.3}
contact: {restitution: 0.4, sliding_friction: 0.3, rolling_friction: 0.01}
"""

SPREAD = (
    "scene: spread\n"
    + MODEL
    + """
seed: 3
powder: {particles: 40}
cohesion: {bond_number: 5}
box: {length: 30 dp, width: 4 dp, fill_length: 4 dp}
blade: {clearance: 1.5 dp, speed: 100 mm/s}
stages:
  - fill: {settle_time: 2 ms}
  - heap: {settle_time: 1 ms}
  - spread: {length: 6 dp, settle_time: 0.3 ms}
output: {trajectory_interval: 2 ms, energy_interval: 0.5 ms}
"""
)

PARTICLES = (
    "scene: particles\n"
    + MODEL
    + """
particles: table.csv
walls:
  - plane: {name: floor, normal: [0, 0, 1]}
duration: 20 us
"""
)

TABLE = "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,26e-6,25e-6,0,0,-0.05,0,0,0\n"


class Solver:
    """Runs recoat-solve in a folder of its own."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def __call__(self, *arguments, timeout=120):
        return subprocess.run(
            [self.program, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=timeout
        )

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def good(self, *arguments):
        result = self(*arguments)
        assert result.returncode == 0, result.stderr
        return result.stdout

    def refusal(self, *arguments):
        """The sentence on standard error of a call that must be refused."""
        result = self(*arguments)
        assert result.returncode == 2, (result.returncode, result.stderr)
        assert "bug" not in result.stderr
        assert len(result.stderr.strip().splitlines()) == 1, result.stderr
        return result.stderr

    def summary(self, run):
        return json.loads((self.folder / run / "summary.json").read_text())


@pytest.fixture(scope="session")
def validator(root):
    """Of scenes, by the JSON Schema."""
    schema = json.loads((root / "config/schema/scene.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.fixture(scope="session")
def model():
    """The sections of a scene that say how particles behave, for scenes of a test's own."""
    return MODEL


@pytest.fixture
def solver(build, tmp_path):
    program = build / "solver/recoat-solve"
    if not program.exists():
        pytest.fail(f"{program} is not built")
    tool = Solver(program, tmp_path)
    tool.write("spread.yaml", SPREAD)
    tool.write("particles.yaml", PARTICLES)
    tool.write("table.csv", TABLE)
    return tool
