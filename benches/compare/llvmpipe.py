#!/usr/bin/env python3
"""Mesa's llvmpipe drawing the same mesh with the same camera, pixels read back: llvmpipe.py FIGURE.toml CAMERA_LAB [FRAMES]

Needs moderngl and numpy (PyPI) and Mesa's EGL. The matrices come from `camera-lab inspect`; a frame is: clear, draw, read all
pixels (RGBA, 8 bits) into one reused buffer. Prints one JSON object in the form of `camera-lab bench`.
"""
import json
import os
import subprocess
import sys
import time
import tomllib

import moderngl
import numpy as np

VERTEX = """#version 330
uniform mat4 clip_from_world; uniform vec3 to_light; uniform vec3 color;
in vec3 position; in vec3 normal; %s out vec3 shade;
void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
    shade = color * (0.3 + 0.7 * max(dot(normal, to_light), 0.0));
}"""
FRAGMENT = """#version 330
%s in vec3 shade; out vec4 pixel;
void main() { pixel = vec4(shade, 1.0); }"""


def read_obj(path):
    points, normals, corners = [], [], []
    with open(path) as f:
        for line in f:
            words = line.split()
            if words[0] == "v":
                points.append([float(x) for x in words[1:]])
            elif words[0] == "vn":
                normals.append([float(x) for x in words[1:]])
            else:
                corners.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    return (np.hstack([np.array(points), np.array(normals)]).astype("f4"), np.array(corners, dtype="i4"))


def main():
    path, binary = sys.argv[1:3]
    with open(path, "rb") as f:
        figure = tomllib.load(f)
    vertices, triangles = read_obj(os.path.join(os.path.dirname(path), figure["scene"]["objects"][0]["path"]))
    frames = int(sys.argv[3]) if len(sys.argv) > 3 else 60
    report = json.loads(subprocess.check_output([binary, "inspect", path, "--format", "json"]))
    width, height = figure["image"]["width"], figure["image"]["height"]
    samples, flat = figure["style"]["antialias"], "flat" if figure["style"]["shading"] == "flat" else ""
    ctx = moderngl.create_standalone_context(backend="egl")
    ctx.enable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
    program = ctx.program(vertex_shader=VERTEX % flat, fragment_shader=FRAGMENT % flat)
    program["clip_from_world"].write(np.array(report["view_projection_matrix"]).T.astype("f4").tobytes())
    light = -np.array(figure["scene"]["lights"][0]["direction"])
    program["to_light"].value = tuple(light / np.linalg.norm(light))
    program["color"].value = (0x44 / 255, 0x77 / 255, 0xAA / 255)
    mesh = ctx.vertex_array(program, [(ctx.buffer(vertices.tobytes()), "3f 3f", "position", "normal")],
                            ctx.buffer(triangles.tobytes()))
    target = ctx.simple_framebuffer((width, height))
    draw_to = target
    if samples > 1:
        draw_to = ctx.framebuffer([ctx.renderbuffer((width, height), samples=samples)],
                                  ctx.depth_renderbuffer((width, height), samples=samples))
    pixels = bytearray(width * height * 4)
    times = []
    for i in range(frames + 5):
        start = time.perf_counter()
        draw_to.use()
        draw_to.clear(1.0, 1.0, 1.0, 1.0)
        mesh.render(moderngl.TRIANGLES)
        if draw_to is not target:
            ctx.copy_framebuffer(target, draw_to)
        target.read_into(pixels, components=4)
        if i >= 5:
            times.append(1e3 * (time.perf_counter() - start))
    times.sort()
    covered = int((np.frombuffer(pixels, "u1").reshape(-1, 4)[:, 0] != 255).sum())
    print(json.dumps({"renderer": ctx.info["GL_RENDERER"], "width": width, "height": height, "triangles": len(triangles),
                      "frames": frames, "median_ms": times[len(times) // 2], "min_ms": times[0],
                      "p95_ms": times[int(0.95 * (len(times) - 1))], "covered_pixels": covered}))


if __name__ == "__main__":
    main()
