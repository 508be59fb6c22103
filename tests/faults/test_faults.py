"""A sample of what `make faults` does at length: nothing is lost, and nothing wrong is taken for right."""

import random
import shutil

import pytest

import broken_runs
import damage
import full_disk


@pytest.fixture(scope="module")
def runs(build, tmp_path_factory):
    return broken_runs.Runs(build / "solver/recoat-solve", tmp_path_factory.mktemp("faults"), broken_runs.SPREAD)


def test_killed_at_random_instants_it_ends_with_the_same_bits(runs):
    kills, ended = broken_runs.kill_rounds(runs, 8, seed=1)
    assert kills >= 8 and ended >= 1


@pytest.mark.slow
def test_killed_with_two_threads_at_work_it_ends_with_the_same_bits(build, tmp_path):
    block = broken_runs.Runs(build / "solver/recoat-solve", tmp_path, broken_runs.BLOCK, broken_runs.block_table())
    kills, _ = broken_runs.kill_rounds(block, 10, seed=1)
    assert kills >= 10


def test_damaged_checkpoints_are_never_taken(runs):
    draw = random.Random(2)
    found = damage.damaged_checkpoints(runs, draw, flips=15, cuts=5, finished=2)
    assert found == {"refused": 18, "continued from the earlier one to the same bits": 2}


def test_a_frame_that_is_damaged_is_refused(runs):
    assert damage.damaged_frames(runs, random.Random(3), flips=5) == {"refused": 5}


def test_a_run_that_was_killed_while_it_removed_its_frames_is_whole(runs):
    out = runs.new_folder("frames")
    shutil.copytree(runs.folder / "whole", out)
    (out / "summary.json").unlink()
    (out / "trajectory.frames").mkdir()
    done = runs.run(out, resume=True)
    assert done.returncode == 0, done.stderr
    assert runs.same_as_undisturbed(out)


def test_a_run_is_not_disturbed_by_another_in_its_folder(runs):
    assert damage.second_process(runs) == "refused"


def test_files_that_cannot_grow_stop_it_and_it_goes_on(runs):
    found = full_disk.limited_files(runs, random.Random(4), tries=2)
    assert found == {"stopped with a sentence, then the same bits": 2}


def test_a_full_disk_stops_it_and_it_goes_on(runs):
    if not full_disk.can_mount():
        pytest.skip("no small file system can be mounted here")
    found = full_disk.full_file_system(runs, random.Random(5), tries=2)
    assert found == {"stopped with a sentence, then the same bits": 2}


def test_a_folder_that_cannot_be_written_is_refused_and_later_goes_on(runs):
    assert full_disk.read_only_folder(runs) == "refused, then the same bits"
