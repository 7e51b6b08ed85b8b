# Every target does its own set-up and redoes nothing that is up to date.
#   make serve [PORT=8000]   build the site and serve it on this machine
#   make test                everything: core, site, viewer, browser
#   make lint  make build  make wheel  make bench  make nightly

PYTHON ?= python3
BIN := .venv/bin
PORT ?= 0
SITE := build/site
BUILD := $(BIN)/hexalab build --repository repository --out $(SITE)
export OMP_NUM_THREADS ?= 2
# What does not wait for each other goes side by side: setting up Python and Node, checking and building.
MAKEFLAGS += -j2

# A screen for Firefox, where there is none.
SCREEN = $(if $(DISPLAY),,$(if $(shell command -v xvfb-run),xvfb-run -a))

.PHONY: serve pages build wheel test test-core test-viewer test-firefox test-browser bench nightly clean
.PHONY: lint lint-python lint-viewer format
.DELETE_ON_ERROR:

# The pages stand at once; pictures that are missing are taken while they are served, and appear on a reload.
serve: pages
	@$(BUILD) >build/pictures.log 2>&1 & $(BIN)/hexalab serve --out $(SITE) --port $(PORT)

pages: .venv/.ready node_modules/.ready build/pyodide-build/.ready
	$(BUILD) --no-pictures

build: .venv/.ready node_modules/.ready build/pyodide-build/.ready
	$(BUILD)

# The core is tested while the site's pictures are taken: both take minutes.
test: build/.prepared pages
	$(MAKE) -j3 --output-sync=target test-core test-viewer build
	$(MAKE) -j2 --output-sync=line test-firefox test-browser

# Wheel and sdist, with the built viewer inside: what `pip install hexalab` brings.
wheel: .venv/.ready node_modules/.ready
	$(BIN)/python -m site_builder.cli.wheel dist

test-core: .venv/.ready
	$(BIN)/pytest -n 2 tests/core

test-firefox: node_modules/.ready
	$(SCREEN) node --test tests/firefox/*.test.js

# Files go out in the order of their names: those of the browser, which take longest, first.
test-browser: .venv/.ready
	$(BIN)/pytest --ignore=tests/core -n 2 --dist loadfile --no-loadscope-reorder

test-viewer: node_modules/.ready
	node --test $$(find tests/viewer -name "*.test.js")

# Long fuzzing, and examples that hypothesis has not drawn before.
nightly: .venv/.ready
	$(BIN)/pytest -m "nightly or hypothesis" --hypothesis-profile=nightly

lint: lint-python lint-viewer

lint-python: .venv/.ready
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

lint-viewer: node_modules/.ready
	node_modules/.bin/prettier --check --log-level warn .
	node_modules/.bin/biome lint
	node_modules/.bin/tsc --project tsconfig.json

format: .venv/.ready node_modules/.ready
	$(BIN)/ruff check --fix-only .
	$(BIN)/ruff format .
	node_modules/.bin/prettier --write --log-level warn .

bench: build/.prepared pages
	$(BIN)/python -m benchmarks

clean:
	rm -rf build .venv node_modules

.venv/.ready: requirements.txt requirements-notebook.txt pyproject.toml
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements.txt -r requirements-notebook.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
	touch $@

node_modules/.ready: package.json package-lock.json
	npm ci --no-audit --no-fund --loglevel=error
	touch $@

# Wheels for Pyodide's Python, which is another than this machine's: downloaded, never installed.
build/pyodide-build/.ready: requirements-pyodide.txt | .venv/.ready
	rm -rf $(@D)
	$(BIN)/python -m pip download --quiet --disable-pip-version-check --no-deps --require-hashes \
		--only-binary=:all: --python-version 3.13 --dest $(@D) --requirement $<
	touch $@

build/.prepared: .venv/.ready tests/prepare core/hexalab/hosts/browser.py
	mkdir -p build
	tests/prepare $(BIN)/python
	touch $@
