# Everything here needs a Rust toolchain and nothing else.
CARGO ?= cargo

.PHONY: help build test check demo bench clean toolchain

help:
	@echo "make build   the tool, target/release/triquad"
	@echo "make demo    convert small meshes with every algorithm and print the table"
	@echo "make test    format, lints, documentation, all tests"
	@echo "make bench   times and memory; MESHES='a.obj b.ply' for your own, LEMON=program for a yardstick"
	@echo "make clean   remove what was built"

toolchain:
	@command -v $(CARGO) >/dev/null 2>&1 || { \
	  echo "cargo was not found: install Rust $$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml) or newer from https://rustup.rs" >&2; \
	  exit 2; }

build: toolchain
	$(CARGO) build --release

demo: toolchain
	$(CARGO) run --release --example demo

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
