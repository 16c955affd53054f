#!/usr/bin/env python3
"""Mesa's llvmpipe drawing the same mesh with the same camera, pixels read back: llvmpipe.py FIGURE.toml CAMERA_LAB [FRAMES [PICTURE.png]]

Needs moderngl and numpy (PyPI), Pillow where the object has a texture, and Mesa's EGL. The matrices come from `camera-lab inspect`;
a frame is: draw the shadow map, if there is one, as `bench` does; clear, draw, read all pixels (RGBA, 8 bits) into one reused buffer.
Prints one JSON object in the form of `camera-lab bench`.
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
uniform mat4 clip_from_world; uniform mat4 map_from_world; uniform vec3 to_light; uniform vec3 color; uniform vec2 scale;
in vec3 position; in vec3 normal; in vec2 uv; {flat} out vec3 ambient; {flat} out vec3 diffuse; out vec2 at; out vec3 on_map;
void main() {{
    gl_Position = clip_from_world * vec4(position, 1.0);
    ambient = color * 0.3;
    diffuse = color * 0.7 * max(dot(normal, to_light), 0.0);
    at = uv * scale;
    on_map = (map_from_world * vec4(position, 1.0)).xyz * 0.5 + 0.5;
}}"""
# Gouraud without texture and shadow needs one colour for each vertex, and gets no more.
PLAIN_VERTEX = """#version 330
uniform mat4 clip_from_world; uniform vec3 to_light; uniform vec3 color;
in vec3 position; in vec3 normal; {flat} out vec3 shade;
void main() {{
    gl_Position = clip_from_world * vec4(position, 1.0);
    shade = color * (0.3 + 0.7 * max(dot(normal, to_light), 0.0));
}}"""
FRAGMENTS = {
    "plain": """#version 330
{flat} in vec3 shade; out vec4 pixel;
void main() {{ pixel = vec4(shade, 1.0); }}""",
    "texture": """#version 330
uniform sampler2D picture; {flat} in vec3 ambient; {flat} in vec3 diffuse; in vec2 at; out vec4 pixel;
void main() {{ pixel = vec4((ambient + diffuse) * texture(picture, at).rgb, 1.0); }}""",
    "shadows": """#version 330
uniform sampler2DShadow map; {flat} in vec3 ambient; {flat} in vec3 diffuse; in vec3 on_map; out vec4 pixel;
void main() {{ pixel = vec4(ambient + diffuse * texture(map, on_map - vec3(0.0, 0.0, 0.002)), 1.0); }}""",
}
DEPTHS = ("""#version 330
uniform mat4 map_from_world; in vec3 position;
void main() { gl_Position = map_from_world * vec4(position, 1.0); }""", """#version 330
void main() {}""")


def read_obj(path):
    """vertices (place, normal, texture coordinates) and triangles"""
    points, normals, coordinates, found, corners = [], [], [(0.0, 0.0)], {}, []
    with open(path) as f:
        for line in f:
            words = line.split()
            if words[0] == "v":
                points.append([float(x) for x in words[1:]])
            elif words[0] == "vn":
                normals.append([float(x) for x in words[1:]])
            elif words[0] == "vt":
                coordinates.append([float(x) for x in words[1:]])
            else:
                keys = [tuple(int(x or 0) for x in w.split("/")[:2]) for w in words[1:]]
                corners.append([found.setdefault(key, len(found)) for key in keys])
    vertices = [points[v - 1] + normals[v - 1] + list(coordinates[c]) for v, c in found]
    return np.array(vertices, dtype="f4"), np.array(corners, dtype="i4")


def light_view(vertices, to_light):
    """parallel projection along the light over all of the mesh"""
    middle = vertices[:, :3].mean(axis=0)
    right = np.cross([0.0, 1.0, 0.0], to_light)
    right /= np.linalg.norm(right)
    axes = np.array([right, np.cross(to_light, right), -to_light])
    reach = np.abs((vertices[:, :3] - middle) @ axes.T).max() * 1.01
    matrix = np.eye(4)
    matrix[:3, :3] = axes / reach
    matrix[:3, 3] = -matrix[:3, :3] @ middle
    return matrix.T.astype("f4").tobytes()


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
    thing, lamp = figure["scene"]["objects"][0], figure["scene"]["lights"][0]
    kind = "texture" if "texture" in thing else "shadows" if lamp.get("shadows") else "plain"
    vertex = PLAIN_VERTEX if kind == "plain" else VERTEX
    program = ctx.program(vertex_shader=vertex.format(flat=flat), fragment_shader=FRAGMENTS[kind].format(flat=flat))
    program["clip_from_world"].write(np.array(report["view_projection_matrix"]).T.astype("f4").tobytes())
    light = -np.array(lamp["direction"])
    light /= np.linalg.norm(light)
    program["to_light"].value = tuple(light)
    program["color"].value = (1.0, 1.0, 1.0) if kind == "texture" else (0x44 / 255, 0x77 / 255, 0xAA / 255)
    data, indices = ctx.buffer(vertices.tobytes()), ctx.buffer(triangles.tobytes())
    if kind == "texture":
        from PIL import Image
        image = Image.open(os.path.join(os.path.dirname(path), thing["texture"])).convert("RGB")
        picture = ctx.texture(image.size, 3, image.transpose(Image.FLIP_TOP_BOTTOM).tobytes())
        picture.build_mipmaps()
        picture.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
        picture.use(0)
        program["scale"].value = tuple(thing["texture_scale"])
    if kind == "shadows":
        side = lamp["shadow_map"]
        view, depths = light_view(vertices, light), ctx.depth_texture((side, side))
        depths.compare_func = "<="
        depths.filter = (moderngl.LINEAR, moderngl.LINEAR)
        program["map_from_world"].write(view)
        into_map = ctx.program(vertex_shader=DEPTHS[0], fragment_shader=DEPTHS[1])
        into_map["map_from_world"].write(view)
        map_target = ctx.framebuffer(depth_attachment=depths)
        casters = ctx.vertex_array(into_map, [(data, "3f 5x4", "position")], indices)
        depths.use(0)
    inputs = (data, "3f 3f 2f", "position", "normal", "uv") if kind == "texture" else (data, "3f 3f 2x4", "position", "normal")
    mesh = ctx.vertex_array(program, [inputs], indices)
    target = ctx.simple_framebuffer((width, height))
    draw_to = target
    if samples > 1:
        draw_to = ctx.framebuffer([ctx.renderbuffer((width, height), samples=samples)],
                                  ctx.depth_renderbuffer((width, height), samples=samples))
    pixels = bytearray(width * height * 4)
    times = []
    for i in range(frames + 5):
        start = time.perf_counter()
        if kind == "shadows":
            map_target.use()
            map_target.clear(depth=1.0)
            casters.render(moderngl.TRIANGLES)
        draw_to.use()
        draw_to.clear(1.0, 1.0, 1.0, 1.0)
        mesh.render(moderngl.TRIANGLES)
        if draw_to is not target:
            ctx.copy_framebuffer(target, draw_to)
        target.read_into(pixels, components=4)
        if i >= 5:
            times.append(1e3 * (time.perf_counter() - start))
    if len(sys.argv) > 4:
        from PIL import Image
        Image.frombytes("RGBA", (width, height), bytes(pixels)).transpose(Image.FLIP_TOP_BOTTOM).save(sys.argv[4])
    times.sort()
    covered = int((np.frombuffer(pixels, "u1").reshape(-1, 4)[:, 0] != 255).sum())
    print(json.dumps({"renderer": ctx.info["GL_RENDERER"], "width": width, "height": height, "triangles": len(triangles),
                      "frames": frames, "median_ms": times[len(times) // 2], "min_ms": times[0],
                      "p95_ms": times[int(0.95 * (len(times) - 1))], "covered_pixels": covered}))


if __name__ == "__main__":
    main()
