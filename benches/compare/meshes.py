#!/usr/bin/env python3
"""Writes the closed meshes of the comparison as OBJ, with a figure file for each: meshes.py FOLDER

One bumpy sphere at five tessellations (about 100, 1k, 10k, 100k and 1M triangles), smooth normals, counter-clockwise from outside.
The camera is the same for all: the mesh fills most of the picture. Deterministic; standard library only.
"""
import math
import os
import sys

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


if __name__ == "__main__":
    main()
