# Everything here needs a Rust toolchain and nothing else, but for the two targets of Python.
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
CARGO ?= cargo
# Builds from nothing are a third shorter without; `cargo test` by hand keeps it.
export CARGO_INCREMENTAL := 0
TARGET := $(or $(CARGO_TARGET_DIR),target)
TRIQUAD := $(TARGET)/release/triquad
EXPERIMENTS := $(addprefix experiments/,comparison.toml irreducible.toml velho.toml walls.toml \
  figure_6.toml)
# Experiment files whose pictures the page shows.
PICTURES := experiments/comparison.toml
# Where results go; the small ones of `make demo` beside them.
OUT ?= results/local
# A folder with meshes of your own: scans of the papers are taken from there, others run too.
DATA ?=
# Feature sets of the library that must compile, separated by commas; `none` is none of them.
FEATURES := none files serde,threads
# Crates in the order in which they are published, and the most bytes that one may have.
PACKAGES := triquad-generators triquad triquad-render triquad-lab triquad-cli
PACKAGE_BYTES := 1000000
# Records that the tables of README and docs are made of: the newest in the repository.
RESULTS ?= $(lastword $(sort $(wildcard results/20*)))
# Records of our algorithms beside programs of others, made by `make quality`: the newest too.
QUALITY ?= $(lastword $(sort $(wildcard results/quality-20*)))
# Seconds that each fuzz target runs.
FUZZ_SECONDS ?= 60
# Where readers of files find them: in memory if possible, as a disk makes a run 60 times as long.
FUZZ_FOLDER := $(firstword $(wildcard /dev/shm) $(TMPDIR) /tmp)

.PHONY: help build reproduce demo quality compare report test check prose features dependencies
.PHONY: bench fuzz package documents release-results clean toolchain python test-python
.PHONY: bench-python

help:
	@echo "make build      builds the tool, target/release/triquad"
	@echo "make demo       runs the papers' experiments on small meshes: a minute after the build"
	@echo "make reproduce  runs the demo, then all experiments: about an hour. Resumes if"
	@echo "                interrupted. DATA=folder adds meshes of your own"
	@echo "make quality    our algorithms beside Gmsh, MeshLab and Blender where these are installed;"
	@echo "                DATA=folder for meshes of your own"
	@echo "make compare    prints every claim of the papers with its verdict, from OUT"
	@echo "make report     rebuilds tables, plots, pictures and the page of OUT from its records"
	@echo "make test       format, lints, documentation, all tests; ends with the tests that skipped"
	@echo "make documents  fills the tables of README and docs from RESULTS and QUALITY"
	@echo "make python     builds the wheel of the Python package, target/wheels; needs Python 3.10"
	@echo "make test-python  tests the wheel in a virtual environment"
	@echo "make bench-python  a million triangles from numpy against Rust: time and memory"
	@echo "make bench      times and memory; MESHES='a.obj b.ply' for your own, LEMON=program for"
	@echo "                ratios to LEMON"
	@echo "make fuzz       every reader on arbitrary bytes, FUZZ_SECONDS each; needs cargo-fuzz"
	@echo "make package    builds the packages of the crates, checks their size, prints the order"
	@echo "make clean      removes what was built; results stay"

toolchain:
	@command -v $(CARGO) >/dev/null 2>&1 || { \
	  version=$$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml); \
	  echo "cargo was not found: install Rust $$version or newer from https://rustup.rs" >&2; \
	  exit 2; }

build: toolchain
	$(CARGO) build --release

demo: build
	"$(TRIQUAD)" run $(EXPERIMENTS) --scale demo --out "$(OUT)-demo"

reproduce: demo
	"$(TRIQUAD)" run $(EXPERIMENTS) --out "$(OUT)" $(if $(DATA),--data "$(DATA)")

# Programs of others are found through PATH; what is not installed is skipped.
quality: build
	"$(TRIQUAD)" run experiments/quality.toml --out "$(OUT)-quality" $(if $(DATA),--data "$(DATA)")

compare: build
	"$(TRIQUAD)" compare "$(OUT)"

report: build
	"$(TRIQUAD)" report "$(OUT)" --pictures $(PICTURES)

documents: build
	"$(TRIQUAD)" report "$(RESULTS)" --pictures $(PICTURES) --docs README.md docs/*.md
	cp "$(RESULTS)"/plots/lrs_against_ps.svg docs/
	"$(TRIQUAD)" report "$(QUALITY)" --docs docs/quality.md
	cp "$(QUALITY)"/plots/side_by_side_mean.svg docs/

# What is attached to a release: the newest results with page, plots and pictures.
release-results: build
	"$(TRIQUAD)" report "$(RESULTS)" --pictures $(PICTURES)
	cd "$(RESULTS)" && sha256sum --check --quiet SHA256SUMS
	git diff --exit-code --stat -- "$(RESULTS)"
	tar -czf "$(TARGET)/results.tar.gz" "$(RESULTS)"

# Columns, and words in documents.
prose:
	@.ci/prose

check: toolchain dependencies prose
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --exclude triquad-python --all-targets -- -D warnings
	$(MAKE) --no-print-directory features
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --exclude triquad-python --no-deps --quiet

# The default features are checked with the workspace.
features: toolchain
	@for features in $(FEATURES); do \
	  echo "features: $$features"; \
	  $(CARGO) clippy --quiet --package triquad --lib --tests --no-default-features \
	    --features "$${features/none/}" -- -D warnings; \
	done

# What `cargo add triquad` brings: at most 15 crates without default features, 42 with them.
dependencies: toolchain
	@crates() { $(CARGO) tree --package triquad --edges normal,build --target all --prefix none \
	  --no-dedupe "$$@" | grep -v '^triquad v' | sort -u | wc -l; }; \
	bare=$$(crates --no-default-features); default=$$(crates); \
	echo "dependencies of triquad: $$bare without default features, $$default with them"; \
	[ "$$bare" -le 15 ] && [ "$$default" -le 42 ] || { \
	  echo "at most 15 and 42 are allowed" >&2; exit 1; }

test: check
	$(CARGO) test --workspace --exclude triquad-python -- --include-ignored --show-output 2>&1 | \
	  tee "$(TARGET)/tests.log"
	@.ci/skipped "$(TARGET)/tests.log"

python: toolchain
	@.ci/python build

test-python: toolchain
	@.ci/python test

bench-python: toolchain
	@.ci/python bench

bench: toolchain
	$(CARGO) bench --bench speed

# Without sanitizer, which the stable compiler does not offer.
fuzz: toolchain
	@$(CARGO) fuzz --version >/dev/null 2>&1 || { \
	  echo "cargo-fuzz was not found: cargo install cargo-fuzz" >&2; exit 2; }
	@for reader in $$($(CARGO) fuzz list); do \
	  case "$$reader" in \
	    experiment) seeds=experiments;; \
	    records) seeds=lab/tests/golden;; \
	    *) seeds="fuzz/seeds/$$reader";; \
	  esac; \
	  mkdir -p "fuzz/corpus/$$reader"; \
	  TMPDIR=$(FUZZ_FOLDER) $(CARGO) fuzz run --sanitizer none "$$reader" \
	    "fuzz/corpus/$$reader" "$$seeds" -- -max_total_time=$(FUZZ_SECONDS); \
	done

package: toolchain
	$(CARGO) package --workspace --exclude triquad-python
	@version=$$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1); \
	for name in $(PACKAGES); do \
	  bytes=$$(wc -c <"$(TARGET)/package/$$name-$$version.crate"); \
	  echo "$$name: $$bytes bytes"; \
	  [ "$$bytes" -lt $(PACKAGE_BYTES) ] || { \
	    echo "at most $(PACKAGE_BYTES) are allowed" >&2; exit 1; }; \
	done
	@echo "publish in this order:"
	@for name in $(PACKAGES); do echo "  cargo publish -p $$name"; done

clean:
	$(CARGO) clean
