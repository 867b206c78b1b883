"""What the tests share."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def _command() -> str | None:
    built = [ROOT / "target" / profile / "triquad" for profile in ("release", "debug")]
    named = os.environ.get("TRIQUAD")
    return named or next((str(path) for path in built if path.is_file()), shutil.which("triquad"))


@pytest.fixture
def command() -> Callable[..., str]:
    """Run the command-line tool and return its standard output."""
    path = _command()
    if path is None:
        pytest.skip("the command triquad is not built; name it in TRIQUAD")

    def run(*arguments: object) -> str:
        words = [path, *map(str, arguments)]
        return subprocess.run(words, check=True, capture_output=True, text=True).stdout

    return run

