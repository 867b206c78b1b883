"""Pairs the triangles of a mesh with Blender: python blender_join.py IN OUT [DEGREES]

IN is an OBJ file of triangles, OUT gets quads and what triangles are left, on the same vertices.
Runs "Tris to Quads" with both its thresholds at DEGREES, by default 40 as in Blender's menu.
Prints the seconds of the pairing alone as JSON. Needs: pip install bpy
"""

import json
import math
import sys
import time

import bpy  # makes bmesh importable
import bmesh

import obj

source, target = sys.argv[1:3]
angle = math.radians(float((sys.argv + ["40"])[3]))
positions, triangles = obj.read(source)
mesh = bpy.data.meshes.new("mesh")
mesh.from_pydata(positions, [], triangles)
work = bmesh.new()
work.from_mesh(mesh)
start = time.perf_counter()
bmesh.ops.join_triangles(
    work, faces=work.faces[:], angle_face_threshold=angle, angle_shape_threshold=angle
)
print(json.dumps({"total_seconds": time.perf_counter() - start}))
faces = [[corner.index for corner in face.verts] for face in work.faces]
# Blender keeps positions in single precision, so those of the input are written.
obj.write(target, positions, faces)
work.free()
