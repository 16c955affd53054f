#!/usr/bin/env python3
"""Measures everything in docs/performance.md and prints its tables: tables.py FOLDER CAMERA_LAB [SECTION]...

FOLDER holds the files of `meshes.py`. Sections: rivals, strokes, surfaces, triangles, pixels, threads, wireframes, one_thread, plan, three, memory.
Without any, it measures all of them. Rivals that aren't installed are left out: `llvmpipe.py` needs moderngl, `vulkan.py` also wgpu with Chromium and Mesa's
Vulkan drivers, the crates a build (`cargo build --release` in `crates/`), three.js `npm install` in `three/` and Chromium, `strokes.py` skia-python
and cairocffi. Each cell is the least median of several runs, taken in turns.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

import meshes

HERE = os.path.dirname(os.path.abspath(__file__))
CRATES = os.path.join(os.environ.get("CARGO_TARGET_DIR", os.path.join(HERE, "crates", "target")), "release", "compare")
NAMES = ["1k", "10k", "100k", "1M"]
FRAMES = {"100": 400, "1k": 300, "10k": 150, "100k": 60, "1M": 20}
TURNS = 2


def run(command, threads=None):
    environment = dict(os.environ)
    if threads:
        environment["RAYON_NUM_THREADS"] = str(threads)
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        print(" ".join(command), done.stderr.strip()[-300:], file=sys.stderr)
        return None
    return json.loads(done.stdout.strip().splitlines()[-1] if done.stdout.count("}") > 1 else done.stdout)


def ours(binary, figure, frames, *options, threads=None):
    command = [binary, "bench", figure, "--frames", str(frames), "--format", "json", *options]
    result = run(command, threads)
    return result and result["median_ms"]


def median(command):
    result = run(command)
    return result and result["median_ms"]


def least(measurements, turns=TURNS, once=()):
    """Each of the functions in turn, several times (those of `once` one time only); the least of what each gave."""
    found = [[] for _ in measurements]
    for turn in range(turns):
        for results, measure in zip(found, measurements):
            if turn and measure in once:
                continue
            value = measure()
            if value is not None:
                results.append(value)
    return [min(results) if results else None for results in found]


def ms(value):
    return "–" if value is None else "%.2f" % value if value < 10 else "%.1f" % value


def ratio(rival, own):
    return "–" if rival is None or own is None else "%s (%.1f×)" % (ms(rival), rival / own)


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + " ---: |" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)
    print()


# Samples, size and shading of the images that others draw too.
DRAWN = [(1, "640x640", "flat"), (1, "640x640", "gouraud"), (1, "1920x1080", "gouraud"), (4, "1920x1080", "gouraud")]


def rivals(folder, binary):
    for samples, size, shading in DRAWN:
        print("**%s, %s, %d sample%s**\n" % (size.replace("x", " × "), shading, samples, "s" * (samples > 1)))
        head = ["triangles", "camera-lab", "llvmpipe", "lavapipe", "SwiftShader"] + ["euc", "retrofire", "three.js"] * (samples == 1)
        rows = []
        for name in NAMES:
            figure = os.path.join(folder, "%s-%s-%s-%d.toml" % (name, size, shading, samples))
            few = str(max(10, FRAMES[name] // 4))
            python = lambda script, *words: median([sys.executable, os.path.join(HERE, script), *words, figure, binary, few])
            measurements = [lambda: ours(binary, figure, FRAMES[name]), lambda: python("llvmpipe.py")]
            measurements += [lambda d=d: python("vulkan.py", d) for d in ("lavapipe", "swiftshader")]
            if samples == 1:
                measurements += [lambda c=c: median([CRATES, figure, binary, c, few]) if os.path.exists(CRATES) else None
                                 for c in ("euc", "retrofire")]
                measurements.append(lambda: median(["node", os.path.join(HERE, "three", "measure.mjs"), figure, binary, few]
                                                   ) if os.path.exists(os.path.join(HERE, "three", "node_modules")) else None)
            # A browser takes longest to start.
            own, *others = least(measurements, once=measurements[6:])
            rows.append([name, ms(own)] + [ratio(other, own) for other in others])
        table(head, rows)


def strokes(folder, binary):
    rows = []
    for name in ("10k", "100k"):
        wireframe = figure_of(name, 640, 640, "wireframe", 1, folder)
        # Meshes and segments are read beside the figure.
        figure = os.path.join(folder, "%s-640x640-flat-1.toml" % name)
        crate = lambda kind: median([CRATES, figure, binary, kind, "20"]) if os.path.exists(CRATES) else None
        python = lambda kind: median([sys.executable, os.path.join(HERE, "strokes.py"), kind, figure, binary, "5"])
        own, *others = least([lambda: ours(binary, wireframe, 60, threads=1)] +
                             [lambda k=k: crate(k) for k in ("vello_cpu-one", "vello_cpu", "tiny-skia-one", "tiny-skia")] +
                             [lambda k=k: python(k) for k in ("skia-one", "skia", "cairo-one", "cairo")])
        pairs = [" / ".join(ms(x) for x in others[i:i + 2]) for i in range(0, 8, 2)]
        # A closed mesh has three edges for two triangles.
        stacks = meshes.SIZES[name]
        rows.append([str(6 * stacks * (stacks - 1)), ms(own)] + pairs)
    table(["edges", "camera-lab"] + [n + ", as one path / singly" for n in ("vello_cpu", "tiny-skia", "Skia", "Cairo")], rows)


def surfaces(folder, binary):
    rows = []
    for shading in ("flat", "gouraud"):
        figures = [os.path.join(folder, "100k-%s-%s.toml" % (shading, kind)) for kind in ("plain", "texture", "shadows")]
        measurements = [lambda f=f: ours(binary, f, FRAMES["100k"]) for f in figures]
        measurements += [lambda f=f: median([sys.executable, os.path.join(HERE, "llvmpipe.py"), f, binary, "30"]) for f in figures]
        found = least(measurements)
        for kind, own, other in zip(("plain", "texture", "shadows"), found[:3], found[3:]):
            rows.append([shading, kind, ms(own), "%.2f×" % (own / found[0]), ratio(other, own)])
    table(["shading", "surface", "camera-lab", "of plain", "llvmpipe"], rows)


def figure_of(name, width, height, shading="gouraud", samples=1, folder=".", more=""):
    text = meshes.FIGURE.format(aspect=width / height, width=width, height=height, name=os.path.abspath(os.path.join(folder, name)),
                                shading=shading, samples=samples)
    return written(text + more)


def written(text):
    handle, path = tempfile.mkstemp(suffix=".toml")
    with os.fdopen(handle, "w") as f:
        f.write(text)
    return path


def triangles(folder, binary):
    rows = []
    for name in ["100"] + NAMES:
        cells = [name]
        for size in ("640x640", "1920x1080"):
            for shading in ("flat", "gouraud", "phong"):
                figure = figure_of(name, *map(int, size.split("x")), shading, 1, folder)
                cells.append(ms(least([lambda: ours(binary, figure, FRAMES[name])])[0]))
        rows.append(cells)
    kinds = ["flat", "Gouraud", "Phong"]
    table(["triangles"] + ["640² " + k for k in kinds] + ["1080p " + k for k in kinds], rows)


def pixels(folder, binary):
    rows = []
    for width, height in ((320, 240), (640, 480), (1280, 720), (1920, 1080), (2560, 1440), (3840, 2160)):
        cells = ["%d × %d" % (width, height)]
        for name in ("1k", "100k"):
            for samples in (1, 4, 16):
                figure = figure_of(name, width, height, "gouraud", samples, folder)
                cells.append(ms(least([lambda: ours(binary, figure, 40)], 2)[0]))
        rows.append(cells)
    table(["pixels"] + ["%s, %d sample%s" % (n, s, "s" * (s > 1)) for n in ("1k", "100k") for s in (1, 4, 16)], rows)


def threads(folder, binary):
    rows = []
    for name in NAMES:
        for size in ("640x640", "1920x1080"):
            figure = figure_of(name, *map(int, size.split("x")), "gouraud", 1, folder)
            one, two = least([lambda t=t: ours(binary, figure, FRAMES[name], threads=t) for t in (1, 2)])
            rows.append([name, size.replace("x", " × "), ms(one), ms(two), "%.2f×" % (one / two)])
    table(["triangles", "pixels", "1 thread", "2 threads", "gain"], rows)


def wireframes(folder, binary):
    rows = []
    for name in NAMES:
        figures = [figure_of(name, 640, 640, shading, 1, folder) for shading in ("flat", "wireframe")]
        flat, wireframe = least([lambda f=f: ours(binary, f, FRAMES[name] // 2, threads=1) for f in figures])
        rows.append([name, ms(flat), ms(wireframe), "%.1f×" % (wireframe / flat)])
    table(["triangles", "flat", "wireframe", "ratio"], rows)


def one_thread(folder, binary):
    """Textures and shadows on one thread."""
    rows = []
    for shading in ("flat", "gouraud", "phong"):
        figures = []
        for kind in ("plain", "texture", "shadows"):
            with open(os.path.join(folder, "100k-flat-%s.toml" % kind)) as f:
                text = f.read().replace('"flat"', '"%s"' % shading)
            # The mesh and its texture are named beside the figure.
            for file in ("100k-uv.obj", "picture.png"):
                text = text.replace('"%s"' % file, '"%s"' % os.path.abspath(os.path.join(folder, file)))
            figures.append(written(text))
        plain, texture, shadow = least([lambda f=f: ours(binary, f, FRAMES["100k"], threads=1) for f in figures])
        rows.append([shading, ms(plain), ms(texture), "%.1f×" % (texture / plain), ms(shadow), "%.1f×" % (shadow / plain)])
    table(["shading", "plain", "texture", "ratio", "shadows", "ratio"], rows)


MANY = "".join('[[scene.objects]]\nname = "b%d"\nshape = "sphere"\ntranslate = [%d.0, 0.0, %d.0]\n' % (i, 3 * (i % 40) - 60, -3 * (i // 40))
               for i in range(1600))
PLAN = [
    ("cube alone, flat", '[scene]\npreset = "cube"\n[style]\nhidden_lines = "shown"\n'),
    ("primitives, wireframe", '[style]\nshading = "wireframe"\n'),
    ("primitives, flat", '[style]\nshading = "flat"\n'),
    ("primitives, Phong", '[style]\nshading = "phong"\n'),
    ("corridor, parallel", '[camera]\nprojection = "parallel"\nheight = 4.0\n[scene]\npreset = "corridor"\n'),
    ("1600 spheres, most outside", '[camera]\nposition = [0, 2, 6]\nfar = 30\n' + MANY),
]


def plan(_folder, binary):
    rows = []
    for name, text in PLAN:
        figure = written(text)
        planned, forced = least([lambda o=o: ours(binary, figure, 40, "--size", "640x480", *o) for o in ([], ["--force-all-stages"])])
        rows.append([name, ms(planned), ms(forced), "%.2f×" % (forced / planned)])
    table(["scene", "planned", "all stages", "ratio"], rows)


def three(_folder, binary):
    import numpy as np
    source, target = np.empty(1920 * 1080, "u4"), np.empty(1920 * 1080, "u4")
    def clear_and_copy():
        times = []
        for _ in range(60):
            start = time.perf_counter()
            source.fill(0xFFFFFFFF)
            target[:] = source
            times.append(1e3 * (time.perf_counter() - start))
        return sorted(times)[30]
    figure = written("")
    names = ["all", "world", "canonical", "image"]
    sizes = ["1920x1080", "640x1080", "640x1080", "640x1080"]
    base, *times = least([clear_and_copy] + [lambda v=v, s=s: ours(binary, figure, 40, "--view", v, "--size", s)
                                             for v, s in zip(names, sizes)])
    table(["what", "ms", "of clear and copy"], [["clear and copy 1920 × 1080", ms(base), "1×"]] +
          [["%s, %s" % (v, s.replace("x", " × ")), ms(t), "%.0f×" % (t / base)] for v, s, t in zip(names, sizes, times)])


def high_water(child):
    """The most memory that a process ever held, kB."""
    most = 0
    while child.poll() is None:
        with open("/proc/%d/status" % child.pid) as f:
            most = max([most] + [int(line.split()[1]) for line in f if line.startswith("VmHWM")])
        time.sleep(0.002)
    return most


def memory(folder, binary):
    rows = []
    for name in ["100"] + NAMES:
        cells = [name, "%.1f" % (os.path.getsize(os.path.join(folder, name + ".obj")) / 2**20)]
        for size in ("640x640", "1920x1080"):
            figure = figure_of(name, *map(int, size.split("x")), "gouraud", 4, folder)
            child = subprocess.Popen([binary, "bench", figure, "--frames", "5"], stdout=subprocess.DEVNULL)
            cells.append("%.0f" % (high_water(child) / 1024))
        rows.append(cells)
    table(["triangles", "OBJ file, MB", "640 × 640, MB", "1920 × 1080, MB"], rows)


def main():
    folder, binary, *wanted = sys.argv[1:]
    for section in (rivals, strokes, surfaces, triangles, pixels, threads, wireframes, one_thread, plan, three, memory):
        if not wanted or section.__name__ in wanted:
            print("### %s\n" % section.__name__)
            section(folder, binary)


if __name__ == "__main__":
    main()
