"""Positions and faces of an OBJ file, gzipped or not, and back."""

import gzip


def _open(path, mode):
    return gzip.open(path, mode) if str(path).endswith(".gz") else open(path, mode)


def read(path):
    """Returns the positions and the faces, each a list of vertex indices from 0."""
    positions, faces = [], []
    with _open(path, "rt") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                corners = [int(word.split("/")[0]) for word in words[1:]]
                faces.append([v - 1 if v > 0 else len(positions) + v for v in corners])
    return positions, faces


def write(path, positions, faces):
    """Writes positions so that they read back to the same numbers."""
    with _open(path, "wt") as out:
        out.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in positions)
        out.writelines("f " + " ".join(str(int(v) + 1) for v in face) + "\n" for face in faces)
