"""Pairs the triangles of a mesh with MeshLab: python meshlab_pairing.py IN OUT [dominant]

IN is an OBJ file of triangles, OUT gets the faces, on the same vertices. The default is the filter
"Turn into Pure-Quad mesh by smart triangle pairing", which flips edges; `dominant` is "Turn into
Quad-Dominant mesh", level "Better quad shape". Prints the seconds of the filter
alone as JSON. Needs: pip install pymeshlab numpy
"""

import json
import sys
import time

import numpy as np
import pymeshlab

import obj

source, target = sys.argv[1:3]
positions, triangles = obj.read(source)
meshes = pymeshlab.MeshSet()
meshes.add_mesh(pymeshlab.Mesh(np.array(positions), np.array(triangles, dtype=np.int32)))
start = time.perf_counter()
if sys.argv[3:] == ["dominant"]:
    meshes.meshing_tri_to_quad_dominant(level="Better quad shape")
else:
    meshes.meshing_tri_to_quad_by_smart_triangle_pairing()
print(json.dumps({"total_seconds": time.perf_counter() - start}))
assert meshes.current_mesh().vertex_number() == len(positions), "MeshLab changed the vertices"
obj.write(target, positions, meshes.current_mesh().polygonal_face_list())
