"""A small grid on a real SLURM cluster of this machine, through the profile: make test-slurm."""

import os
import re
import signal
from pathlib import Path

import psutil
import pytest
import yaml
from slurm_cluster import Cluster, wait_for
from test_dag import change

pytestmark = pytest.mark.slow

CONFIGURATION = ("--configfile", "config/smoke.yaml")
# The cluster keeps no accounts, and a test does not wait for what a file server of a real one may need.
QUICK = (
    *("--slurm-no-account", "--slurm-status-command", "squeue", "--slurm-init-seconds-before-status-checks", "1"),
    *("--seconds-between-status-checks", "1", "--latency-wait", "10"),
)
PROFILE = ("--profile", "workflow/profiles/slurm", *QUICK)
BOND_NUMBERS = (5, 50, 200)
CASES = [f"results/smoke/layers/bond-{bond}_ratio-0.01_seed-1" for bond in BOND_NUMBERS]
LAYERS = [f"{case}/spread.vtkhdf" for case in CASES]
METRICS = f"{CASES[0]}/layer.json"
STAGES = ("fill", "heap", "spread")


@pytest.fixture(scope="module")
def cluster():
    # So that what was started is also stopped when the test is told to end.
    former = signal.signal(signal.SIGTERM, signal.default_int_handler)
    with Cluster() as cluster:
        yield cluster
    signal.signal(signal.SIGTERM, former)


@pytest.fixture(scope="module")
def new_grid(new_workflow, root):
    """Makes a copy of the workflow with the programs where the profile looks for them, and a grid of three cases."""
    programs = Path(os.environ.get("RECOAT_PROGRAMS", root / "build/portable/programs")).absolute()
    assert (programs / "solver/recoat-solve").exists(), f"there are no programs in {programs}; run 'make portable' first"

    def make(**keys):
        workflow = new_workflow()
        (workflow.folder / "build/portable").mkdir(parents=True)
        (workflow.folder / "build/portable/programs").symlink_to(programs)
        scene = yaml.safe_load((workflow.folder / "config/smoke.yaml").read_text())["scene_overrides"]
        scene |= {"output.checkpoint_interval": "0.2 s", "stages.spread.length": "10 dp", "stages.spread.settle_time": "5 ms"}
        layers = [{"bond_numbers": list(BOND_NUMBERS), "stiffness_ratios": [0.01]}]
        change(workflow, "smoke", layers=layers, scene_overrides=scene, **keys)
        return workflow

    return make


@pytest.fixture(scope="module")
def uninterrupted(new_grid):
    """The states of each case as this machine makes them without SLURM."""
    grid = new_grid()
    code, output = grid(*LAYERS, *CONFIGURATION, build="build/portable/programs")
    assert code == 0, output
    return [states(grid.folder, case) for case in CASES]


class Run:
    """Snakemake on the cluster, with what it says in a file; stopped when it is left."""

    def __init__(self, grid, cluster, *targets):
        self.file = grid.folder / "snakemake.txt"
        with open(self.file, "w") as output:
            self.process = grid.start(
                *targets, *PROFILE, *CONFIGURATION, environment=cluster.environment, output=output
            )

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait()

    def until(self, find, what, is_it):
        """What is found as soon as it is as wanted; a failure with the text of Snakemake where that does not come about."""

        def wanted():
            assert self.process.poll() is None, f"the grid ended before {what}\n{self.file.read_text()}"
            found = find()
            return found if is_it(found) else None

        return wait_for(wanted, 120, what)

    def finish(self):
        assert self.process.wait(300) == 0, self.file.read_text()


def solver_of(folder, case):
    """The process that simulates a case, once it has left a checkpoint; None before."""
    if not list((folder / case / "run").glob("checkpoint*.h5")):
        return None
    for process in psutil.process_iter():
        try:
            command = process.cmdline()
            if command[:1] and command[0].endswith("recoat-solve") and f"{case}/run" in command:
                return process if process.cwd() == str(folder) else None
        except psutil.Error:
            continue
    return None


def simulations(cluster, rule):
    """Number and node of the jobs of a rule that run now, by the Bond number or sweep."""
    start = f"rule_{rule}_wildcards_"
    jobs = [job for job in cluster.jobs("RUNNING") if job[2].startswith(start)]
    return {comment.removeprefix(start).split("_")[0]: (number, node) for number, node, comment in jobs}


def states(folder, case):
    """The bytes of the states after each stage."""
    return [(folder / case / f"{stage}.vtkhdf").read_bytes() for stage in ("fill", "heap", "spread")]


def log(grid, case):
    return (grid.folder / case / "solve.log").read_text()


def test_killed_jobs_go_on_from_their_checkpoints_to_the_same_bits(cluster, new_grid, uninterrupted):
    grid = new_grid()
    with Run(grid, cluster, *LAYERS, METRICS) as run:
        solvers = run.until(lambda: [solver_of(grid.folder, case) for case in CASES[:2]], "two simulations side by side", all)
        jobs = simulations(cluster, "simulate_layer")
        solvers[0].kill()
        assert cluster.ask("scancel", jobs[str(BOND_NUMBERS[1])][0]) == ""
        run.finish()
        said = run.file.read_text()
    assert all("Continuing at step" in log(grid, case) for case in CASES[:2]), said
    assert "Continuing" not in log(grid, CASES[2]), said
    assert [states(grid.folder, case) for case in CASES] == uninterrupted
    assert (grid.folder / METRICS).exists()


def test_each_sweep_has_a_gpu_to_itself(cluster, new_grid, uninterrupted):
    grid = new_grid(gpus=1, cases_per_gpu=1, backend="cpu")  # the GPUs of this cluster are for show
    with Run(grid, cluster, *LAYERS) as run:
        jobs = run.until(lambda: simulations(cluster, "sweep"), "two sweeps at the same time", lambda jobs: len(jobs) == 2)
        # A node has cores for both, but one GPU.
        assert {node for _, node in jobs.values()} == set(cluster.nodes)
        for number, _ in jobs.values():
            assert re.search(r"TresPerJob=gres[:/]gpu[:=]1\b", cluster.ask("scontrol", "show", "job", number))
        run.until(lambda: cluster.jobs("PENDING"), "a job that waits for a GPU", any)
        run.finish()
    assert [states(grid.folder, case) for case in CASES] == uninterrupted


def test_nothing_is_left_behind():
    with pytest.raises(KeyboardInterrupt):
        with Cluster(nodes=1) as cluster:
            folder = cluster.folder
            cluster.ask("sbatch", "--mem=1", "--output=/dev/null", "--wrap=srun -n1 sleep 1000")
            wait_for(lambda: cluster.jobs("RUNNING"), 20, "a job")
            assert {process.name() for process in cluster.processes()} >= {"munged", "slurmctld", "slurmd", "slurmstepd"}
            raise KeyboardInterrupt
    assert not cluster.processes() and not folder.exists()
