"""All-quad meshes from triangulations of closed surfaces, on the same vertices.

Arrays go in and come out: vertices ``(n, 3)`` of ``float64``, triangles ``(m, 3)`` of any integer
dtype, quads ``(m/2, 4)`` of ``uint32``. Indices count from 0. No vertex is added or moved, so the
result indexes the array that went in.

>>> import triquad
>>> vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
>>> triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
>>> quads, report = triquad.convert(vertices, triangles)
>>> quads.shape, report.genus
((2, 4), 0)

Arrays may be read-only and have any strides. Each is copied once on its way in, and nothing is
copied on its way out. Other numbers than ``float64`` or ``float32`` for vertices, byte orders that
are not the machine's, and misaligned arrays cost a second copy. The interpreter lock is released
while a function works. Ctrl-C ends a call at once; what the call had begun ends soon after, or
when it is done where nothing can stop it.
"""

from triquad._adapters import (
    from_meshio,
    from_pyvista,
    from_trimesh,
    to_meshio,
    to_pyvista,
    to_trimesh,
)
from triquad._convert import Report, convert, pair
from triquad._errors import Element, InfeasibleError, MeshError
from triquad._files import read, write
from triquad._inspect import CheckReport, Survey, Violation, check, survey
from triquad._matching import Certificate, Matching, match
from triquad._reduce import IrreducibleReport, irreducible, simplify
from triquad._repair import clean, weld

__all__ = [
    "Certificate",
    "CheckReport",
    "Element",
    "InfeasibleError",
    "IrreducibleReport",
    "Matching",
    "MeshError",
    "Report",
    "Survey",
    "Violation",
    "check",
    "clean",
    "convert",
    "from_meshio",
    "from_pyvista",
    "from_trimesh",
    "irreducible",
    "match",
    "pair",
    "read",
    "simplify",
    "survey",
    "to_meshio",
    "to_pyvista",
    "to_trimesh",
    "weld",
    "write",
]
