"""The campaign of `make faults` sees an outcome that is wrong, and says so with its exit status."""

import argparse
import sys

import pytest

import broken_runs
import campaign
import damage
import full_disk

CHECKPOINTS = {damage.REFUSED: 550, damage.CONTINUED: 50}


def test_the_expected_outcomes_are_right():
    assert campaign.is_right(dict(CHECKPOINTS), CHECKPOINTS)
    assert campaign.is_right(damage.REFUSED, damage.REFUSED)
    assert campaign.is_right({f"kills in 5 runs, {campaign.SAME_BITS}": 62}, 60)


@pytest.mark.parametrize(
    "happened",
    [
        CHECKPOINTS | {"wrong result": 1},
        {damage.REFUSED: 549, damage.CONTINUED: 50, "wrong result": 1},
        {damage.REFUSED: 549, damage.CONTINUED: 51},
        {damage.REFUSED: 550, damage.CONTINUED: 50, "exit 139: ": 1},
        {damage.REFUSED: 550},
        {},
        "wrong result",
        damage.REFUSED,
    ],
)
def test_a_wrong_outcome_of_many_is_seen(happened):
    assert not campaign.is_right(happened, CHECKPOINTS)


@pytest.mark.parametrize("happened", ["wrong result", "exit 1: ", "exit 0: ", "", {damage.REFUSED: 1}])
def test_a_wrong_outcome_of_one_is_seen(happened):
    assert not campaign.is_right(happened, damage.REFUSED)


@pytest.mark.parametrize(
    "happened", ["wrong result: run 3 differs", {f"kills in 5 runs, {campaign.SAME_BITS}": 59}, {}, {"kills": 60}]
)
def test_kills_that_are_too_few_or_end_otherwise_are_seen(happened):
    assert not campaign.is_right(happened, 60)


def test_a_run_that_ends_otherwise_after_kills_is_an_outcome(monkeypatch):
    def differs(*_):
        raise AssertionError("run 3 after 7 kills differs")

    monkeypatch.setattr(broken_runs, "kill_rounds", differs)
    assert campaign.kills(None, 60, 1) == "wrong result: run 3 after 7 kills differs"


def test_the_closing_sentence_names_what_is_wrong(capsys):
    table = [
        ("first", lambda: damage.REFUSED, damage.REFUSED),
        ("second", lambda: {full_disk.GOOD: 19, "wrong result": 1}, {full_disk.GOOD: 20}),
        ("third", lambda: campaign.SKIPPED, {full_disk.GOOD: 20}),
    ]
    outcomes, sentence = campaign.campaign(table)
    assert list(outcomes) == ["first", "second", "third"]
    assert sentence == "1 of 3 kinds of faults came out wrong: second."
    printed = capsys.readouterr().out
    assert "Not tried: third." in printed and f"expected {{'{full_disk.GOOD}': 20}}" in printed
    assert campaign.campaign(table[:1])[1] is None


@pytest.mark.parametrize("happened, code", [("wrong result", "1 of 1 kinds of faults came out wrong: it."), ("refused", None)])
def test_the_exit_status_is_that_of_the_outcomes(monkeypatch, tmp_path, happened, code):
    monkeypatch.setattr(broken_runs, "Runs", lambda *_: None)
    monkeypatch.setattr(campaign, "kinds", lambda *_: [("it", lambda: happened, damage.REFUSED)])
    monkeypatch.setattr(sys, "argv", ["campaign.py", "program", "--out", str(tmp_path)])
    with pytest.raises(SystemExit) as ending:
        campaign.main()
    assert ending.value.code == code
    assert (tmp_path / "faults.json").exists()


def test_every_kind_has_an_outcome_to_be_held_to():
    arguments = argparse.Namespace(rounds=300, flips=500, seed=1)
    expected = [expected for _, _, expected in campaign.kinds(None, None, arguments)]
    assert expected == [240, 60, CHECKPOINTS, {damage.REFUSED: 100}, damage.REFUSED, {full_disk.GOOD: 20},
                        {full_disk.GOOD: 20}, full_disk.LATER]
