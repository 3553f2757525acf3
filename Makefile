# make lab      the course in JupyterLab, on your own copy of the lessons (my-course)
# make check    lint, imports, types and the quick tests: for the one who is writing
# make test     everything that is tested, as CI does
# make thorough make test with every case that a test names, none drawn: before a release
# make fuzz     the quick tests on other numbers in every run
# make site     the static pages, in docs/_build/html; make site LIVE=1: lessons run in their page
#               make site CLASS=1: the class edition, without the worked answers
# make lessons  the notebooks from their sources; make lessons LESSON=05 does one
# make bench    exactness and speed; make bench QUICK=yes draws less

PYTHON ?= python3
BIN := .venv/bin
# one test after another to every core, but together what tests/conftest.py groups, in its order;
# nbval, half a second to load, for the notebooks alone
PYTEST := $(BIN)/python -m pytest --numprocesses logical --dist loadgroup --no-loadscope-reorder -p no:nbval
# bytecode is kept, whatever a shell says: some hundred tests start Python anew
export PYTHONDONTWRITEBYTECODE :=
# what Jupyter asks for and runs without, 70 MB: completion that reads code (there is the one that
# looks at objects, and it is quicker), the debugger, widgets in the classic notebook; and what venv
# brings before Python 3.12
SPARED := jedi parso debugpy widgetsnbextension setuptools
COSTLY := browser or cage or notebook or slow
PIP := $(BIN)/python -m pip --disable-pip-version-check install --quiet --constraint constraints.txt

.PHONY: lab check lint quick test thorough notebooks whole test-deps fuzz site lessons bench
.DELETE_ON_ERROR:

lab: .venv/lab
	$(BIN)/dhlab lab my-course

# both at once: lint keeps one core busy for a fifth of the time
check: .venv/test
	@$(MAKE) --no-print-directory --jobs=2 lint quick

quick: .venv/test
	$(PYTEST) -m "not ($(COSTLY))"

lint: .venv/test
	$(BIN)/ruff check --quiet
	$(BIN)/ruff format --check --quiet
	$(BIN)/lint-imports
	$(BIN)/mypy

# all at once: lint and the notebooks have ended long before the costly tests, which come first, and
# the quick ones at the end leave no core without work
test: .venv/test test-deps
	@$(MAKE) --no-print-directory --jobs=3 lint notebooks whole

thorough: export DHLAB_THOROUGH := yes
thorough: test

notebooks: .venv/test
	$(BIN)/python -m pytest -q -o addopts= --nbval --nbval-sanitize-with tests/nbval.cfg solutions

whole: .venv/test
	$(PYTEST)

# A seed that is given shows again what was found with it: make fuzz DHLAB_SEED=20261122
fuzz: export DHLAB_SEED := $(or $(DHLAB_SEED),$(shell date +%s))
fuzz: .venv/test
	$(PYTEST) -m "not ($(COSTLY))" --hypothesis-seed=$(DHLAB_SEED) tests

# Chromium and bubblewrap come from apt where this user may install; otherwise the tests that need them are skipped by name.
test-deps:
	@$(PYTHON) tests/system_packages.py

site: .venv/test
	$(BIN)/python docs/build.py $(if $(LIVE),--live) $(if $(CLASS),--class)

lessons: .venv/test
	$(BIN)/python -m dhlab.course.building.build $(LESSON)

bench: .venv/test
	$(BIN)/python benchmarks/accuracy.py
	$(BIN)/python benchmarks/inverse.py $(if $(QUICK),--quick)
	$(BIN)/python benchmarks/kinematics.py $(if $(QUICK),--quick)

.venv/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "dhlab needs Python 3.11 or newer; found: $$($(PYTHON) --version 2>&1). Say which to use: make lab PYTHON=python3.12"; exit 1; }
	@$(PYTHON) -m venv .venv || { rm -rf .venv; echo "Python could not make a virtual environment; on Debian and Ubuntu: apt install python3-venv"; exit 1; }

# --no-compile: Python compiles a module when it is first used, and most never are
.venv/lab: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) --no-compile --editable '.[lab]'
	$(BIN)/python -m pip uninstall --yes -qq $(SPARED)
	@touch $@

.venv/test: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) --no-compile --editable '.[test,oracles]'
	@touch $@ .venv/lab
