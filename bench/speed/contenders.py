"""What takes turns in a case: our programs in some configuration, those of the other commit, and the peers."""

from dataclasses import dataclass, field

from peers import STYLES, program
from recoat import Build


@dataclass(frozen=True)
class Case:
    """A scene at a Bond number, with threads (processes, where a program knows no threads)."""

    scene: str
    bond: float
    threads: int

    def __str__(self):
        return f"{self.scene}, Bo {self.bond:g}, {self.threads}"


@dataclass
class Ours:
    """A build of ours with settings that it must have, and those that are left out where it does not know them."""

    name: str
    build: Build
    files: dict
    steps: dict  # of each scene, see plan.yaml
    required: tuple = ()
    preferred: tuple = ()
    cases: object = field(default=lambda case: True)
    instruction_set: str | None = None  # None: the best that the machine has

    def key(self, case):
        plan = self.steps[case.scene]
        return f"{self.name} {self.build.fingerprint()} {' '.join(self.required)} | {case} | {plan['warm']} {plan['steps']}"

    def takes(self, case):
        return self.cases(case)

    def run(self, case):
        """A record, or None where the build does not know a required setting."""
        file, plan = self.files[case.scene], self.steps[case.scene]
        known = self.build.known(file, self.preferred)
        warm = plan["warm_cohesive" if case.bond > 0 else "warm"]
        return self.build.rate(file, case.bond, case.threads, warm, plan["steps"], self.required + known, self.instruction_set)


@dataclass
class Peer:
    """One style of another program; its neighbour skin is the fastest of some, tried once for every scene."""

    name: str
    peers: object
    steps: dict
    skins: tuple
    tuned_like: str  # the style whose skin it takes, its own name or that of one with the same lists
    journal: object
    cases: object = field(default=lambda case: True)

    def key(self, case):
        plan = self.steps[case.scene]["peers"]
        return f"{self.name} {program(self.name)} | {case} | {plan['warm']} {plan['steps']}"

    def takes(self, case):
        return case.bond <= STYLES[self.name][2] and self.cases(case)

    def run(self, case):
        if program(self.name) is None:
            return None
        plan = self.steps[case.scene]["peers"]
        return self.peers.rate(self.name, (case.scene, case.bond, case.threads), plan["warm"], plan["steps"], self.skin(case.scene))

    def skin(self, scene):
        """The fastest of the skins without cohesion on one core [m]."""
        plan = self.steps[scene]["peers"]

        def attempt(skin):
            return self.peers.rate(self.tuned_like, (scene, 0, 1), plan["warm"], plan["steps"], skin)

        same = f"{self.tuned_like} {scene} {plan['warm']} {plan['steps']}"
        tried = {skin: self.journal.once(f"skin {skin:g} {same}", lambda skin=skin: attempt(skin)) for skin in self.skins}
        good = {skin: record["rate"] for skin, record in tried.items() if record and "rate" in record}
        if not good:
            raise RuntimeError(f"{self.tuned_like} runs with none of the skins: {next(iter(tried.values()))}")
        return max(good, key=good.get)
