"""Pairs the triangles of a mesh with Gmsh: python gmsh_recombine.py IN OUT [ALGORITHM]

IN is an OBJ file of triangles, OUT gets quads and what triangles are left, on the same vertices.
ALGORITHM is Gmsh's Mesh.RecombinationAlgorithm: 1 (Blossom-Quad, the default here) or 0 (greedy).
Prints the seconds of the pairing alone as JSON. Needs: pip install gmsh numpy
"""

import json
import sys
import time

import gmsh
import numpy as np

import obj

TRIANGLE, QUAD = 2, 3


def faces_of(kind, corners):
    _, nodes = gmsh.model.mesh.getElementsByType(kind)
    return (np.asarray(nodes, dtype=np.int64) - 1).reshape(-1, corners).tolist()


source, target = sys.argv[1:3]
positions, triangles = obj.read(source)
gmsh.initialize(["gmsh", "-nopopup"], readConfigFiles=False)
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("Mesh.RecombinationAlgorithm", float((sys.argv + ["1"])[3]))
# The vertices stay where they are, and the pairs as they were found.
gmsh.option.setNumber("Mesh.RecombineNodeRepositioning", 0)
gmsh.option.setNumber("Mesh.RecombineOptimizeTopology", 0)
# By default Gmsh takes its worst quads apart again.
gmsh.option.setNumber("Mesh.RecombineMinimumQuality", 0)
surface = gmsh.model.addDiscreteEntity(2)
gmsh.model.mesh.addNodes(2, surface, range(1, len(positions) + 1), np.ravel(positions))
gmsh.model.mesh.addElementsByType(surface, TRIANGLE, [], np.ravel(triangles) + 1)
start = time.perf_counter()
gmsh.model.mesh.recombine()
print(json.dumps({"total_seconds": time.perf_counter() - start}))
obj.write(target, positions, faces_of(QUAD, 4) + faces_of(TRIANGLE, 3))
