#!/usr/bin/env python3
"""A Vulkan driver in software drawing the same mesh with the same camera, pixels read back:
vulkan.py DRIVER FIGURE.toml CAMERA_LAB [FRAMES]

DRIVER is `swiftshader` (it comes with Debian's chromium) or `lavapipe` (mesa-vulkan-drivers). Needs wgpu, moderngl and numpy (PyPI). A frame is: clear, draw,
copy all pixels (RGBA, 8 bits) into a buffer, read it. Prints one JSON object in the form of `camera-lab bench`.
"""
import json
import os
import subprocess
import sys
import time
import tomllib

ICDS = {
    "swiftshader": "/usr/lib/chromium/vk_swiftshader_icd.json",
    "lavapipe": "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json",
}

SHADER = """
struct Uniforms { clip_from_world: mat4x4f, to_light: vec4f, color: vec4f }
@group(0) @binding(0) var<uniform> u: Uniforms;
struct Varyings { @builtin(position) clip: vec4f, @location(0) INTERPOLATION shade: vec3f }
@vertex fn vertex(@location(0) position: vec3f, @location(1) normal: vec3f) -> Varyings {
    return Varyings(u.clip_from_world * vec4f(position, 1.0), u.color.rgb * (0.3 + 0.7 * max(dot(normal, u.to_light.xyz), 0.0)));
}
@fragment fn fragment(in: Varyings) -> @location(0) vec4f { return vec4f(in.shade, 1.0); }
"""


def main():
    driver, path, binary = sys.argv[1:4]
    # The loader reads the variables when the library is loaded.
    os.environ["VK_ICD_FILENAMES"] = os.environ["VK_DRIVER_FILES"] = ICDS[driver]
    import numpy as np
    import wgpu
    from llvmpipe import read_obj

    with open(path, "rb") as f:
        figure = tomllib.load(f)
    vertices, triangles = read_obj(os.path.join(os.path.dirname(path), figure["scene"]["objects"][0]["path"]))
    frames = int(sys.argv[4]) if len(sys.argv) > 4 else 60
    report = json.loads(subprocess.check_output([binary, "inspect", path, "--format", "json", "--ndc", "vulkan"]))
    width, height = figure["image"]["width"], figure["image"]["height"]
    samples, flat = figure["style"]["antialias"], figure["style"]["shading"] == "flat"
    light = -np.array(figure["scene"]["lights"][0]["direction"])
    light /= np.linalg.norm(light)
    # Depths from 0 to 1 as Vulkan's, but y up: wgpu turns it.
    clip_from_world = np.diag([1.0, -1.0, 1.0, 1.0]) @ np.array(report["projection_matrix"]) @ np.array(report["view_matrix"])
    uniforms = np.concatenate([clip_from_world.T.ravel(), light, [0.0], [0x44 / 255, 0x77 / 255, 0xAA / 255, 1.0]]).astype("f4")

    adapter = next(a for a in wgpu.gpu.enumerate_adapters_sync() if a.info["backend_type"] == "Vulkan")
    device = adapter.request_device_sync()
    shader = device.create_shader_module(code=SHADER.replace("INTERPOLATION", "@interpolate(flat)" if flat else ""))
    buffer = lambda data, usage: device.create_buffer_with_data(data=data, usage=usage)
    mesh, indices = buffer(vertices, wgpu.BufferUsage.VERTEX), buffer(triangles, wgpu.BufferUsage.INDEX)
    uniform_buffer = buffer(uniforms, wgpu.BufferUsage.UNIFORM)
    attribute = lambda place: {"format": "float32x3", "offset": 12 * place, "shader_location": place}
    pipeline = device.create_render_pipeline(
        layout="auto",
        vertex={"module": shader, "entry_point": "vertex", "buffers": [
            {"array_stride": 32, "step_mode": "vertex", "attributes": [attribute(0), attribute(1)]}]},
        primitive={"topology": "triangle-list", "front_face": "ccw", "cull_mode": "back"},
        depth_stencil={"format": "depth32float", "depth_write_enabled": True, "depth_compare": "less"},
        multisample={"count": samples},
        fragment={"module": shader, "entry_point": "fragment", "targets": [{"format": "rgba8unorm"}]},
    )
    group = device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=[
        {"binding": 0, "resource": {"buffer": uniform_buffer, "offset": 0, "size": uniforms.nbytes}}])

    def texture(form, count, usage):
        return device.create_texture(size=(width, height, 1), format=form, sample_count=count, usage=usage)

    attachment = wgpu.TextureUsage.RENDER_ATTACHMENT
    target = texture("rgba8unorm", 1, attachment | wgpu.TextureUsage.COPY_SRC)
    color = {"view": target.create_view(), "load_op": "clear", "store_op": "store", "clear_value": (1, 1, 1, 1)}
    if samples > 1:
        many = texture("rgba8unorm", samples, attachment)
        color |= {"view": many.create_view(), "resolve_target": target.create_view(), "store_op": "discard"}
    depth = {"view": texture("depth32float", samples, attachment).create_view(), "depth_load_op": "clear", "depth_store_op": "discard",
             "depth_clear_value": 1.0}
    # A row of a copy begins at a multiple of 256 bytes.
    row = (width * 4 + 255) // 256 * 256
    pixels = device.create_buffer(size=row * height, usage=wgpu.BufferUsage.COPY_DST | wgpu.BufferUsage.MAP_READ)
    times = []
    for i in range(frames + 5):
        start = time.perf_counter()
        encoder = device.create_command_encoder()
        drawing = encoder.begin_render_pass(color_attachments=[color], depth_stencil_attachment=depth)
        drawing.set_pipeline(pipeline)
        drawing.set_bind_group(0, group)
        drawing.set_vertex_buffer(0, mesh)
        drawing.set_index_buffer(indices, "uint32")
        drawing.draw_indexed(triangles.size)
        drawing.end()
        encoder.copy_texture_to_buffer({"texture": target}, {"buffer": pixels, "bytes_per_row": row}, (width, height, 1))
        device.queue.submit([encoder.finish()])
        pixels.map_sync(wgpu.MapMode.READ)
        image = bytearray(pixels.read_mapped(copy=False))
        pixels.unmap()
        if i >= 5:
            times.append(1e3 * (time.perf_counter() - start))
    times.sort()
    covered = int((np.frombuffer(image, "u1").reshape(height, row)[:, : width * 4 : 4] != 255).sum())
    print(json.dumps({"renderer": driver, "width": width, "height": height, "triangles": len(triangles), "frames": frames,
                      "median_ms": times[len(times) // 2], "min_ms": times[0], "p95_ms": times[int(0.95 * (len(times) - 1))],
                      "covered_pixels": covered}))


if __name__ == "__main__":
    main()
