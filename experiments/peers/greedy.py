"""Pairs triangles greedily: python3 greedy.py IN.obj OUT.obj SEED. Needs nothing but Python."""
import random
import sys

source, target, seed = sys.argv[1:4]
lines = open(source).read().split("\n")
faces = [[int(w.split("/")[0]) for w in line.split()[1:]] for line in lines if line[:2] == "f "]
sides = {}  # a directed edge: its triangle, and the corner opposite to it
for place, (a, b, c) in enumerate(faces):
    sides.update({(a, b): (place, c), (b, c): (place, a), (c, a): (place, b)})
edges = sorted(edge for edge in sides if edge[0] < edge[1])
random.Random(int(seed)).shuffle(edges)
free, quads = set(range(len(faces))), []
for u, v in edges:
    (left, apex), (right, other) = sides[u, v], sides[v, u]
    if left in free and right in free:
        free -= {left, right}
        quads.append((u, other, v, apex))
rest = [faces[place] for place in sorted(free)]
with open(target, "w") as out:
    out.writelines(line + "\n" for line in lines if line[:2] == "v ")
    out.writelines("f " + " ".join(map(str, face)) + "\n" for face in quads + rest)
