# Everything here needs a Rust toolchain and nothing else.
CARGO ?= cargo
TRIQUAD := $(or $(CARGO_TARGET_DIR),target)/release/triquad
EXPERIMENTS := experiments/comparison.toml experiments/irreducible.toml
# Where results go; the small ones of `make demo` beside them.
OUT ?= results/local
# A folder with meshes of your own: scans of the papers are taken from there, others run too.
DATA ?=

.PHONY: help build reproduce demo compare report test check bench clean toolchain

help:
	@echo "make reproduce  the papers' experiments: small ones first, a page after a minute; then all of"
	@echo "                them, about an hour; goes on where it was. DATA=folder adds meshes of your own"
	@echo "make demo       the small ones alone"
	@echo "make compare    what the papers claim, and what came of it here"
	@echo "make report     tables, plots and the page of OUT, made anew from its records"
	@echo "make build      the tool, target/release/triquad"
	@echo "make test       format, lints, documentation, all tests"
	@echo "make bench      times and memory; MESHES='a.obj b.ply' for your own, LEMON=program for a yardstick"
	@echo "make clean      remove what was built; results stay"

toolchain:
	@command -v $(CARGO) >/dev/null 2>&1 || { \
	  echo "cargo was not found: install Rust $$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml) or newer from https://rustup.rs" >&2; \
	  exit 2; }

build: toolchain
	$(CARGO) build --release

demo: build
	$(TRIQUAD) run $(EXPERIMENTS) --scale demo --out $(OUT)-demo

reproduce: demo
	$(TRIQUAD) run $(EXPERIMENTS) --out $(OUT) $(if $(DATA),--data "$(DATA)")

compare: build
	$(TRIQUAD) compare $(OUT)

report: build
	$(TRIQUAD) report $(OUT)

check: toolchain
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --all-targets -- -D warnings
	$(CARGO) clippy --package triquad --lib --no-default-features -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --no-deps --quiet

test: check
	$(CARGO) test --workspace -- --include-ignored

bench: toolchain
	$(CARGO) bench --bench speed

clean:
	$(CARGO) clean
