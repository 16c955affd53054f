#!/usr/bin/env python3
"""Writes the closed meshes of the comparison as OBJ, with a figure file for each: meshes.py FOLDER

One bumpy sphere at five tessellations (about 100, 1k, 10k, 100k and 1M triangles), smooth normals, counter-clockwise from outside.
The camera is the same for all: the mesh fills most of the picture. The mesh of 100k triangles is there once more with texture
coordinates, with a picture of 1024 by 1024 texels that goes around it four times, or in the shadow of itself. Deterministic; standard
library only.
"""
import math
import os
import struct
import sys
import zlib

SIZES = {"100": 6, "1k": 16, "10k": 50, "100k": 158, "1M": 500}
FIGURE = """[camera]
position    = [0.8, 1.2, 2.6]
focal_point = [0.0, 0.0, 0.0]
view_up     = [0.0, 1.0, 0.0]
projection  = "perspective"
view_angle  = 45.0
aspect      = {aspect}
near        = 1.0
far         = 6.0

[image]
width  = {width}
height = {height}

[scene]
preset = "empty"

[[scene.objects]]
name  = "mesh"
shape = "mesh"
path  = "{name}.obj"
color = "#4477aa"

[[scene.lights]]
kind      = "directional"
direction = [-1.0, -2.0, -1.0]

[style]
shading   = "{shading}"
antialias = {samples}
"""


# Additions for the figures of textures and shadows: in their object, and behind it.
PICTURE = '''
texture = "picture.png"
texture_scale = [4.0, 4.0]
filter = "trilinear"
'''
SHADOWS = "shadows = true\nshadow_map = 1024\n"


def bumpy_sphere(stacks):
    """positions and triangles; 4·stacks·(stacks − 1) triangles"""
    slices = 2 * stacks
    radius = lambda lat, lon: 1.0 + 0.05 * math.sin(5 * lon) * math.sin(4 * lat) ** 2
    points = [(0.0, 1.0, 0.0)]
    for i in range(1, stacks):
        lat = math.pi * i / stacks
        for j in range(slices):
            lon = 2 * math.pi * j / slices
            r = radius(lat, lon)
            points.append((r * math.sin(lat) * math.sin(lon), r * math.cos(lat), r * math.sin(lat) * math.cos(lon)))
    points.append((0.0, -1.0, 0.0))
    ring = lambda i, j: 1 + (i - 1) * slices + j % slices
    last = len(points) - 1
    triangles = []
    for j in range(slices):
        triangles.append((0, ring(1, j), ring(1, j + 1)))
        for i in range(1, stacks - 1):
            a, b, c, d = ring(i, j), ring(i + 1, j), ring(i + 1, j + 1), ring(i, j + 1)
            triangles += [(a, b, c), (a, c, d)]
        triangles.append((last, ring(stacks - 1, j + 1), ring(stacks - 1, j)))
    return points, triangles


def normals(points, triangles):
    sums = [[0.0, 0.0, 0.0] for _ in points]
    for t in triangles:
        a, b, c = (points[i] for i in t)
        e, f = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
        n = (e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0])
        for i in t:
            for k in range(3):
                sums[i][k] += n[k]
    return [[x / math.sqrt(sum(y * y for y in n)) for x in n] for n in sums]


def with_coordinates(points, triangles, stacks):
    """texture coordinates, and triangles whose corners are (vertex, coordinates): around it, and from pole to pole"""
    slices = 2 * stacks
    row = lambda v: 0 if v == 0 else stacks if v == len(points) - 1 else 1 + (v - 1) // slices
    found, corners = {}, []
    for t in triangles:
        columns = [(v - 1) % slices for v in t if 0 < row(v) < stacks]
        # A triangle that closes the ring goes on behind its end.
        closes = max(columns) - min(columns) > 1
        corner = []
        for v in t:
            column = min(columns) + 0.5 if row(v) in (0, stacks) else (v - 1) % slices
            column += slices if closes and column < slices / 2 else 0
            corner.append((v, found.setdefault((column / slices, 1.0 - row(v) / stacks), len(found))))
        corners.append(corner)
    return list(found), corners


def write_picture(path, side=1024):
    """a picture of many colours, as PNG"""
    rows = b"".join(b"\0" + bytes(c for x in range(side) for c in (x & 255, y & 255, ((x ^ y) * 8) & 255)) for y in range(side))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    for name, stacks in SIZES.items():
        points, triangles = bumpy_sphere(stacks)
        with open(os.path.join(folder, name + ".obj"), "w") as f:
            f.writelines("v %.9g %.9g %.9g\n" % p for p in points)
            f.writelines("vn %.9g %.9g %.9g\n" % tuple(n) for n in normals(points, triangles))
            f.writelines("f %d//%d %d//%d %d//%d\n" % tuple(i + 1 for v in t for i in (v, v)) for t in triangles)
        for width, height in ((640, 640), (1920, 1080)):
            for shading in ("flat", "gouraud"):
                for samples in (1, 4):
                    path = os.path.join(folder, "%s-%dx%d-%s-%d.toml" % (name, width, height, shading, samples))
                    with open(path, "w") as f:
                        f.write(FIGURE.format(aspect=width / height, width=width, height=height, name=name, shading=shading,
                                              samples=samples))
        print(name, len(triangles), "triangles")
        if name == "100k":
            coordinates, corners = with_coordinates(points, triangles, stacks)
            with open(os.path.join(folder, name + "-uv.obj"), "w") as f:
                f.writelines("v %.9g %.9g %.9g\n" % p for p in points)
                f.writelines("vt %.9g %.9g\n" % c for c in coordinates)
                f.writelines("vn %.9g %.9g %.9g\n" % tuple(n) for n in normals(points, triangles))
                f.writelines("f %s\n" % " ".join("%d/%d/%d" % (v + 1, c + 1, v + 1) for v, c in t) for t in corners)
    write_picture(os.path.join(folder, "picture.png"))
    for shading in ("flat", "gouraud"):
        plain = FIGURE.format(aspect=1.0, width=640, height=640, name="100k-uv", shading=shading, samples=1)
        color = 'color = "#4477aa"\n'
        texts = {"plain": plain, "texture": plain.replace(color, 'color = "#ffffff"\n' + PICTURE),
                 "shadows": plain.replace("-1.0, -2.0, -1.0]\n", "-1.0, -2.0, -1.0]\n" + SHADOWS)}
        for kind, text in texts.items():
            with open(os.path.join(folder, "100k-%s-%s.toml" % (shading, kind)), "w") as f:
                f.write(text)


if __name__ == "__main__":
    main()
