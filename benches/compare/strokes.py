#!/usr/bin/env python3
"""Skia or Cairo drawing the edges of a mesh as smooth strokes 1.25 pixels wide, on one thread: strokes.py RENDERER FIGURE.toml CAMERA_LAB [FRAMES]

RENDERER is `skia`, `skia-one`, `cairo` or `cairo-one`; with `-one` all edges are one path. Needs numpy, moderngl and skia-python, or cairocffi with libcairo2.
The ends of the strokes are computed beforehand: they draw finished segments, Camera Lab transforms too. Prints one JSON object in the form of `camera-lab bench`.
"""
import json
import os
import subprocess
import sys
import time
import tomllib

import numpy as np

from llvmpipe import read_obj

COLOR = (0x44 / 255, 0x77 / 255, 0xAA / 255)


def segments(path, binary):
    """the size of the image, and the two ends of each edge in pixels"""
    with open(path, "rb") as f:
        figure = tomllib.load(f)
    width, height = figure["image"]["width"], figure["image"]["height"]
    vertices, triangles = read_obj(os.path.join(os.path.dirname(path), figure["scene"]["objects"][0]["path"]))
    report = json.loads(subprocess.check_output([binary, "inspect", path, "--format", "json"]))
    clip = np.c_[vertices[:, :3], np.ones(len(vertices))] @ np.array(report["view_projection_matrix"]).T
    places = (clip[:, :2] / clip[:, 3:] * [1, -1] + 1) / 2 * [width, height]
    edges = np.unique(np.sort(np.r_[triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]], axis=1), axis=0)
    return width, height, places[edges].reshape(-1, 4).tolist()


def skia_frame(width, height, edges, one):
    import skia
    surface = skia.Surface(width, height)
    canvas = surface.getCanvas()
    paint = skia.Paint(AntiAlias=True, Style=skia.Paint.kStroke_Style, StrokeWidth=1.25, Color4f=skia.Color4f(*COLOR, 1.0))

    def path_of(segments):
        path = skia.Path()
        for x, y, to_x, to_y in segments:
            path.moveTo(x, y)
            path.lineTo(to_x, to_y)
        return path

    def frame():
        canvas.clear(skia.ColorWHITE)
        if one:
            canvas.drawPath(path_of(edges), paint)
        else:
            for edge in edges:
                canvas.drawLine(*edge, paint)
    return frame, lambda: surface.toarray()


def cairo_frame(width, height, edges, one):
    import cairocffi
    surface = cairocffi.ImageSurface(cairocffi.FORMAT_ARGB32, width, height)
    context = cairocffi.Context(surface)
    context.set_line_width(1.25)

    def frame():
        context.set_source_rgb(1, 1, 1)
        context.paint()
        context.set_source_rgb(*COLOR)
        for x, y, to_x, to_y in edges:
            context.move_to(x, y)
            context.line_to(to_x, to_y)
            if not one:
                context.stroke()
        if one:
            context.stroke()
        surface.flush()
    return frame, lambda: np.frombuffer(surface.get_data(), "u1").reshape(height, width, 4)


def main():
    renderer, path, binary = sys.argv[1:4]
    frames = int(sys.argv[4]) if len(sys.argv) > 4 else 20
    width, height, edges = segments(path, binary)
    make = skia_frame if renderer.startswith("skia") else cairo_frame
    frame, pixels = make(width, height, edges, renderer.endswith("-one"))
    times = []
    for i in range(frames + 2):
        start = time.perf_counter()
        frame()
        if i >= 2:
            times.append(1e3 * (time.perf_counter() - start))
    times.sort()
    print(json.dumps({"renderer": renderer, "width": width, "height": height, "strokes": len(edges), "frames": frames,
                      "median_ms": times[len(times) // 2], "min_ms": times[0], "p95_ms": times[int(0.95 * (len(times) - 1))],
                      "covered_pixels": int((pixels()[:, :, :3].min(axis=2) != 255).sum())}))


if __name__ == "__main__":
    main()
