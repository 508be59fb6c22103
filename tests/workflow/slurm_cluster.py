"""A SLURM cluster of this machine alone: its own folder, ports and key, beside any other SLURM that runs here."""

import getpass
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

import psutil

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo")
SEARCHED = f"{os.environ['PATH']}:/usr/sbin:/sbin"  # the daemons are not in every user's PATH

# No cgroups and no service manager, so that it works in a container as well. The nodes are virtual: what they have is
# what is written here, not what this machine has, and a GPU is a file.
CONFIGURATION = """\
ClusterName=recoat
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=batch_sched_delay=0
GresTypes=gpu
ReturnToService=2
KillWait=2
SlurmctldPort={port}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
StateSaveLocation={folder}/state
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdSpoolDir={folder}/spool-%n
SlurmdParameters=config_overrides
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""
NODE = "NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs={cpus} RealMemory={memory} Gres=gpu:1\n"


def free_ports(count):
    """Ports that nothing listens on."""
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def wait_for(condition, seconds, what):
    """Wait until the condition holds and return its value; TimeoutError says what did not come about."""
    deadline = time.monotonic() + seconds
    while not (value := condition()):
        if time.monotonic() > deadline:
            raise TimeoutError(f"{what}: not within {seconds} s")
        time.sleep(0.1)
    return value


class Cluster:
    """Starts when it is entered; stops its jobs and services when it is left, however that comes about."""

    def __init__(self, nodes=2, cpus=2, memory_mb=32000):
        self.nodes = [f"node{i + 1}" for i in range(nodes)]
        self.cpus, self.memory = cpus, memory_mb
        self.folder, self.services = None, []

    def __enter__(self):
        missing = [name for name in PROGRAMS if not shutil.which(name, path=SEARCHED)]
        if missing:
            raise FileNotFoundError(f"SLURM is not here ({', '.join(missing)}); RECOAT_SLURM=1 ./setup.sh installs it")
        # Paths of sockets are short, so not in pytest's folder.
        self.folder = Path(tempfile.mkdtemp(prefix="recoat-slurm-"))
        self.environment = {**os.environ, "PATH": SEARCHED, "SLURM_CONF": str(self.folder / "slurm.conf")}
        try:
            self._configure()
            self._start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def _configure(self):
        host, ports = socket.gethostname().split(".")[0], free_ports(1 + len(self.nodes))
        text = CONFIGURATION.format(host=host, user=getpass.getuser(), folder=self.folder, port=ports[0])
        for name, port in zip(self.nodes, ports[1:]):
            text += NODE.format(name=name, host=host, port=port, cpus=self.cpus, memory=self.memory)
            (self.folder / f"spool-{name}").mkdir()
        (self.folder / "slurm.conf").write_text(text)
        (self.folder / "gres.conf").write_text("Name=gpu File=/dev/null\n")
        (self.folder / "cgroup.conf").write_text("CgroupAutomount=no\n")
        (self.folder / "state").mkdir()
        self._shadow_srun()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)

    def _shadow_srun(self):
        """The plugin for job steps calls srun without SLURM_CONF, since clusters have one configuration in /etc."""
        script = self.folder / "bin/srun"
        script.parent.mkdir()
        srun = shutil.which("srun", path=SEARCHED)
        script.write_text(f'#!/bin/sh\nSLURM_CONF={self.folder}/slurm.conf exec {srun} "$@"\n')
        script.chmod(0o755)
        self.environment["PATH"] = f"{script.parent}:{SEARCHED}"

    def _start(self):
        socket_file = self.folder / "munge.socket"
        files = {"key-file": "munge.key", "pid-file": "munge.pid", "seed-file": "munge.seed", "log-file": "munge.log"}
        options = [f"--{option}={self.folder / file}" for option, file in files.items()]
        # --force: the folder lies in one that everybody may write to.
        self._service("munged", "--foreground", "--force", f"--socket={socket_file}", *options)
        wait_for(socket_file.exists, 20, "the socket of munged")
        self._service("slurmctld", "-D", "-c")
        for name in self.nodes:
            self._service("slurmd", "-D", "-N", name)
        wait_for(self._all_idle, 60, f"idle nodes (logs in {self.folder})")

    def _service(self, *command):
        with open(self.folder / f"{command[0]}.out", "ab") as output:
            service = subprocess.Popen(
                command, env=self.environment, stdout=output, stderr=output, stdin=subprocess.DEVNULL, start_new_session=True
            )
        self.services.append(service)

    def ask(self, *command):
        """What a command of SLURM answers; empty where it fails."""
        return subprocess.run(
            command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        ).stdout.strip()

    def _all_idle(self):
        return self.ask("sinfo", "--noheader", "--Node", "--format=%T").split() == ["idle"] * len(self.nodes)

    def jobs(self, *states):
        """Number, node and comment (rule and case) of the jobs in these states."""
        answer = self.ask("squeue", "--noheader", f"--states={','.join(states)}", "--format=%i|%N|%k")
        return [line.split("|", 2) for line in answer.splitlines()]

    def processes(self):
        """Every process that was started in this cluster, services and jobs alike."""
        found = []
        for process in psutil.process_iter():
            try:
                belongs = process.environ().get("SLURM_CONF") == self.environment["SLURM_CONF"]
                # slurmstepd writes its title over its environment, but keeps its log open.
                belongs = belongs or any(file.path.startswith(str(self.folder)) for file in process.open_files())
            except psutil.Error:
                continue
            if belongs and process.pid != os.getpid():
                found.append(process)
        return found

    def stop(self):
        """End the jobs, then the services, then what is left; the folder goes when all are gone."""
        self.ask("scancel", "--user", getpass.getuser())
        try:
            wait_for(lambda: not self.ask("squeue", "--noheader"), 20, "the end of the jobs")
        except TimeoutError:
            pass  # they are killed below
        for kind in (signal.SIGTERM, signal.SIGKILL):
            for process in self.processes():
                try:
                    process.send_signal(kind)
                except psutil.NoSuchProcess:
                    continue
            psutil.wait_procs(self.processes(), timeout=5)
        for service in self.services:
            service.wait(timeout=10)
        wait_for(lambda: not self.processes(), 10, "the end of what the cluster started")
        shutil.rmtree(self.folder)
