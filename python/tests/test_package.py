"""The package itself: imports, types, errors that travel."""

from __future__ import annotations

import doctest
import importlib
import os
import pickle
import pkgutil
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest
import triquad


def test_the_package_brings_numpy_alone() -> None:
    program = """
import sys
import triquad
print(*sorted({name.split(".")[0] for name in sys.modules} & {"trimesh", "pyvista", "meshio"}))
"""
    words = [sys.executable, "-c", program]
    run = subprocess.run(words, check=True, capture_output=True, text=True)
    assert run.stdout.strip() == ""
    required = [r for r in metadata.requires("triquad") or [] if "extra" not in r]
    assert [r.split(">")[0] for r in required] == ["numpy"]


def test_everything_public_is_documented_with_an_example() -> None:
    for name in triquad.__all__:
        text = getattr(triquad, name).__doc__
        assert text and ">>> import triquad" in text, name


@pytest.mark.parametrize("module", [m.name for m in pkgutil.iter_modules(triquad.__path__)])
def test_examples_show_what_happens(module: str) -> None:
    if module == "_adapters":
        for name in ("trimesh", "pyvista", "meshio"):
            pytest.importorskip(name)
    results = doctest.testmod(importlib.import_module(f"triquad.{module}"))
    assert results.failed == 0


def test_errors_can_be_pickled() -> None:
    with pytest.raises(triquad.MeshError) as refused:
        triquad.pair([[0, 1, 2]])
    error = pickle.loads(pickle.dumps(refused.value))
    assert (error.law, error.count, str(error)) == ("boundary-edge", 3, str(refused.value))
    with pytest.raises(triquad.InfeasibleError) as infeasible:
        triquad.match([[0, 1]], [1], nodes=3)
    copied = pickle.loads(pickle.dumps(infeasible.value))
    assert copied.barrier.tolist() == infeasible.value.barrier.tolist()


def test_types_are_those_of_the_stubs(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    sources = Path(__file__).resolve().parents[1]
    settings = str(sources / "pyproject.toml")
    allowed = str(sources / "tests" / "stubtest.txt")
    stubtest = ["mypy.stubtest", "triquad", "--mypy-config-file", settings]
    stubtest += ["--allowlist", allowed]
    for words, folder in ((["mypy"], sources), (stubtest, tmp_path)):
        words = [sys.executable, "-m", *words]
        run = subprocess.run(words, cwd=folder, capture_output=True, text=True)
        assert run.returncode == 0, run.stdout + run.stderr


def test_the_example_draws_its_picture(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    example = Path(__file__).resolve().parents[1] / "examples" / "quads.py"
    run = subprocess.run(
        [sys.executable, str(example)],
        cwd=tmp_path,
        env={**os.environ, "MPLBACKEND": "agg"},
        check=True,
        capture_output=True,
        text=True,
    )
    assert run.stdout.startswith("1400 triangles (genus 1) -> 700 quads")
    assert (tmp_path / "quads.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("document", ["README.md", "docs/python.md"])
def test_the_snippets_of_the_documents_run(document: str, monkeypatch: pytest.MonkeyPatch) -> None:
    root = Path(__file__).parents[2]
    monkeypatch.chdir(root)
    fence = "```"
    parts = (root / document).read_text(encoding="utf-8").split(fence + "python\n")[1:]
    assert parts
    names: dict[str, object] = {}
    for part in parts:
        exec(part.split(fence)[0], names)
