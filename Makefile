# `make run` and `make test` are all a fresh Debian machine needs.
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:

# what does not wait for another step runs beside it
MAKEFLAGS += -j2

VENV := .venv
PY := $(VENV)/bin/python
STAMPS := $(VENV)/stamps

.PHONY: help
help:  ## say what there is
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 12

.PHONY: run
run: setup  ## set up, start the studio, print its address (Ctrl-C stops it)
	@exec $(VENV)/bin/pneustudio serve $(ARGS)

.PHONY: setup
setup: $(STAMPS)/python $(STAMPS)/page $(STAMPS)/kernels  ## install everything into .venv, build the page

$(STAMPS)/venv:
	@command -v python3 >/dev/null || { echo "python3 (3.11 or newer) is needed: apt-get install python3 python3-venv"; exit 1; }
	@python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "Python 3.11 or newer is needed, this is $$(python3 --version)"; exit 1; }
	@python3 -c 'import ensurepip' 2>/dev/null || ./tools/apt_install.sh python3-venv
	python3 -m venv $(VENV)
	@mkdir -p $(STAMPS) && touch $@

$(STAMPS)/python: requirements.lock pyproject.toml $(STAMPS)/venv
	$(PY) -m pip install --quiet --disable-pip-version-check -r requirements.lock
	$(PY) -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
	@touch $@

$(STAMPS)/node-modules: frontend/package-lock.json frontend/package.json $(STAMPS)/python
	cd frontend && PATH="$$(../tools/node_path.sh ../$(VENV)):$$PATH" npm ci --no-audit --no-fund --loglevel=error
	@touch $@

PAGE_SOURCES := $(shell find frontend -path frontend/node_modules -prune -o -path frontend/dist -prune -o -type f -print)
$(STAMPS)/page: $(STAMPS)/node-modules openapi.json $(PAGE_SOURCES)
	cd frontend && PATH="$$(../tools/node_path.sh ../$(VENV)):$$PATH" npm run --silent build
	@touch $@

KERNEL_SOURCES := $(shell find actuators -name '*.py')
$(STAMPS)/kernels: $(STAMPS)/rod-kernels $(STAMPS)/element-kernels
	@touch $@

$(STAMPS)/rod-kernels: $(STAMPS)/python $(KERNEL_SOURCES)
	@echo "Compiling the rod kernels (once)"
	$(PY) -m actuators.mechanics.rod.warm
	@touch $@

$(STAMPS)/element-kernels: $(STAMPS)/python $(KERNEL_SOURCES)
	@echo "Compiling the finite-element kernels (once)"
	$(PY) -m actuators.mechanics.continuum.warm
	@touch $@

.PHONY: chromium
chromium:
	@command -v chromium >/dev/null || ./tools/apt_install.sh chromium

# after chromium: only one apt at a time
.PHONY: calculix
calculix: chromium
	@command -v ccx >/dev/null || ./tools/apt_install.sh calculix-ccx

.PHONY: check
check: check-python check-page  ## lint, types, import rules, page checks

.PHONY: check-python
check-python: setup
	$(VENV)/bin/ruff check .
	$(VENV)/bin/ruff format --check .
	$(VENV)/bin/pyright
	$(VENV)/bin/lint-imports --no-logo

.PHONY: check-page
check-page: setup
	cd frontend && PATH="$$(../tools/node_path.sh ../$(VENV)):$$PATH" npm run --silent check

.PHONY: test
test: setup chromium calculix check  ## set up and run all tests but the slow studies
	$(VENV)/bin/pytest -n 2 --dist loadscope

.PHONY: test-all
test-all: setup chromium calculix check  ## the slow studies too
	$(VENV)/bin/pytest -m '' -n 2 --dist loadscope

.PHONY: lock
lock: $(STAMPS)/python  ## renew requirements.lock (needs uv)
	$(PY) -m uv pip compile --universal --python-version 3.11 --no-annotate --no-header --quiet \
	  pyproject.toml --group dev --output-file requirements.lock

.PHONY: clean
clean:  ## remove what setup made
	rm -rf $(VENV) frontend/node_modules frontend/dist build *.egg-info
