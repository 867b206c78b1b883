"""Converts a mesh to quads, measures them and draws both: ``python quads.py [MESH [PICTURE]]``."""

# %% The mesh: a file, or a torus that is simplified first.
from __future__ import annotations

import sys

import matplotlib.pyplot as plt
import numpy as np
import triquad
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from numpy.typing import NDArray


def torus(rows: int, columns: int) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return vertices and triangles of a torus."""
    i, j = (x.ravel() for x in np.mgrid[:rows, :columns])
    u, v = 2 * np.pi * i / rows, 2 * np.pi * j / columns
    radius = 2 + np.cos(v)
    vertices = np.column_stack((radius * np.cos(u), radius * np.sin(u), np.sin(v)))

    def vertex(down: int, right: int) -> NDArray[np.int64]:
        return np.asarray((i + down) % rows * columns + (j + right) % columns)

    a, b, c, d = vertex(0, 0), vertex(1, 0), vertex(1, 1), vertex(0, 1)
    up = np.random.default_rng(1).random(len(a)) < 0.5
    cells = np.where(up[:, None], np.array([a, b, c, a, c, d]).T, np.array([a, b, d, b, c, d]).T)
    return vertices, cells.reshape(-1, 3)


if len(sys.argv) > 1:
    vertices, triangles = triquad.read(sys.argv[1], triangulate=True)
else:
    vertices, triangles = triquad.simplify(*torus(80, 40), 700)

# %% The conversion: `quads` indexes the same vertices.
quads, report = triquad.convert(vertices, triangles)
print(report)
print(f"checked again: {triquad.check(quads, triangles)}")

# %% The quality: the scaled Jacobian is the least sine of the angles at the corners.


def scaled_jacobian(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the scaled Jacobian of quads, given as (k, 4, 3) coordinates of corners."""
    after = np.roll(corners, -1, axis=1) - corners
    before = np.roll(after, 1, axis=1)
    normal = np.cross(after[:, 0] - after[:, 2], after[:, 1] - after[:, 3])[:, None]
    length = np.linalg.norm(normal, axis=2) * np.linalg.norm(after, axis=2)
    length *= np.linalg.norm(before, axis=2)
    sine = (np.cross(before, after) * normal).sum(axis=2) / np.where(length > 0, length, 1)
    return np.asarray(sine.min(axis=1))


quality = scaled_jacobian(vertices[quads])
print(f"quality {quality.mean():.3f} in the mean, {quality.min():.3f} at worst")

# %% The picture: triangles, quads by quality, and how many quads are how good.
figure = plt.figure(figsize=(12, 4.2), layout="constrained")
colours = plt.get_cmap("viridis")
for place, faces, fill, title in (
    (1, triangles, "#dae1ea", f"{len(triangles)} triangles"),
    (2, quads, colours((quality + 1) / 2), f"{len(quads)} quads"),
):
    axes = figure.add_subplot(1, 3, place, projection="3d")
    axes.add_collection3d(
        Poly3DCollection(vertices[faces], facecolors=fill, edgecolors="#262e3e", linewidths=0.3)
    )
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]), title=title)
    axes.set_box_aspect(high - low, zoom=1.3)
    axes.view_init(elev=38)
    axes.set_axis_off()
axes = figure.add_subplot(1, 3, 3)
counts, edges = np.histogram(quality, bins=20, range=(-1, 1))
axes.bar(edges[:-1], counts, width=0.1, align="edge", color=colours((edges[:-1] + 1.05) / 2))
axes.set(xlabel="scaled Jacobian", ylabel="quads")
axes.spines[["top", "right"]].set_visible(False)
figure.savefig(sys.argv[2] if len(sys.argv) > 2 else "quads.png", dpi=100)
