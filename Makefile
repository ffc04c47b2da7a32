# `make fly` and `make test` make their own environment, .venv, the first time.
# Another Python than the one found: make PYTHON=/usr/bin/python3.12 fly

BIN := .venv/bin

.PHONY: help fly test manual lock wheel clean

help: ## what make can do here
	@sed -n 's/^\([a-z]*\):.*## /  make \1  /p' Makefile

fly: .venv/ready ## fly; options of the program: make fly ARGS="--help"
	@$(BIN)/kitemj fly $(ARGS)

test: .venv/ready ## style, types and tests
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/pytest -q -n 2 --dist loadfile -m "not alone"
	$(BIN)/pytest -q -m alone

manual: .venv/ready ## the manual, build/manual/index.html
	$(BIN)/python -m sphinx -q -n -W docs build/manual

lock: .venv/ready ## renew requirements.lock: the newest versions that pyproject.toml allows
	$(BIN)/uv pip compile --quiet --upgrade --universal --fork-strategy fewest --group dev \
		--no-emit-index-url --custom-compile-command "make lock" \
		--output-file requirements.lock pyproject.toml

wheel: .venv/ready ## dist/: the wheel and the sdist
	$(BIN)/python -m hatchling build

clean: ## remove .venv, build and dist
	rm -rf .venv build dist

# Made anew when one of these files is newer than the last time.
.venv/ready: requirements.lock pyproject.toml scripts/setup.sh
	@sh scripts/setup.sh
	@touch $@
