# make lab    the course in JupyterLab, on your own copy of the lessons (my-course)
# make test   everything that is tested, as CI does
# make site   the static pages, in docs/_build/html
# make lessons, make bench: for developers

PYTHON ?= python3
BIN := .venv/bin
SPREAD := --numprocesses logical --dist loadfile  # a file at a time to every core
PIP := $(BIN)/python -m pip --disable-pip-version-check install --quiet --constraint constraints.txt

.PHONY: lab test test-deps site lessons bench
.DELETE_ON_ERROR:

lab: .venv/lab
	$(BIN)/dhlab lab my-course

test: .venv/test
	@$(MAKE) --no-print-directory test-deps
	$(BIN)/python -m dhlab.course.building.contract
	$(BIN)/python -m dhlab.course.building.build --check
	$(BIN)/python -m pytest $(SPREAD)
	$(BIN)/python -m pytest $(SPREAD) -q -o addopts= --nbval --nbval-sanitize-with tests/nbval.cfg solutions
	$(BIN)/python -m pytest $(SPREAD) -q -o addopts= --nbval-lax lessons

# Chromium and bubblewrap come from apt where this user may install; otherwise the tests that need them are skipped by name.
test-deps:
	@$(PYTHON) tests/system_packages.py

site: .venv/test
	$(BIN)/python docs/build.py

lessons: .venv/test
	$(BIN)/python -m dhlab.course.building.build

bench: .venv/test
	$(BIN)/python benchmarks/accuracy.py

.venv/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "dhlab needs Python 3.11 or newer; found: $$($(PYTHON) --version 2>&1). Say which to use: make lab PYTHON=python3.12"; exit 1; }
	@$(PYTHON) -m venv .venv || { rm -rf .venv; echo "Python could not make a virtual environment; on Debian and Ubuntu: apt install python3-venv"; exit 1; }

# --no-compile: Python compiles a module when it is first used, and most never are
.venv/lab: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) --no-compile --editable '.[lab]'
	@touch $@

.venv/test: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) --editable '.[test,oracles]'
	@touch $@ .venv/lab
