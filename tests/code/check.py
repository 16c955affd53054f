#!/usr/bin/env python3
"""Runs the code that `camera-lab code` writes in the libraries that it is for, and compares their matrices with `camera-lab inspect`.

    pip install numpy vtk opencv-python-headless trimesh; npm install three; apt install libglm-dev g++
    python3 tests/code/check.py [CAMERA_LAB] [NODE_MODULES_FOLDER]

A library that is not installed is skipped, and that is said. Exits 1 where a matrix differs.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "target/release/camera-lab"))
NODE_MODULES = os.path.abspath(sys.argv[2] if len(sys.argv) > 2 else ".")

CAMERA = "position = [3, 4, 5]\nfocal_point = [0.5, -1, 0.25]\nview_up = [0.1, 1, -0.2]\nnear = 0.75\nfar = 40\n"
FIGURES = {
    "perspective": "[camera]\n" + CAMERA + "view_angle = 50\naspect = 1.6\n",
    "asymmetric": "[camera]\n" + CAMERA + "window = { left = -0.5, right = 0.75, bottom = -0.25, top = 0.5 }\n",
    "parallel": "[camera]\n" + CAMERA + 'projection = "parallel"\nheight = 5\naspect = 1.25\n',
    "parallel asymmetric": "[camera]\n" + CAMERA
    + 'projection = "parallel"\nwindow = { left = -2, right = 3, bottom = -1, top = 4 }\n',
}


def program(*arguments):
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout


def python(code):
    names = {}
    exec("import vtk\n" * ("vtk." in code) + code, names)
    def rows(m):
        return [[m.GetElement(i, j) for j in range(4)] for i in range(4)] if hasattr(m, "GetElement") else m.tolist()
    return rows(names["view"]), rows(names["projection"])


def three(code, folder):
    path = os.path.join(folder, "check.mjs")
    with open(path, "w") as file:
        file.write("import * as THREE from '" + os.path.join(NODE_MODULES, "node_modules/three/build/three.module.js") + "';\n")
        file.write(code)
        file.write("const rows = m => [0, 1, 2, 3].map(i => [0, 1, 2, 3].map(j => m.elements[4 * j + i]));\n")
        file.write("console.log(JSON.stringify([rows(camera.matrixWorldInverse), rows(camera.projectionMatrix)]));\n")
    return json.loads(subprocess.run(["node", path], check=True, capture_output=True, text=True).stdout)


def glm(code, folder):
    path = os.path.join(folder, "check.cpp")
    with open(path, "w") as file:
        file.write("#include <cstdio>\n#include <initializer_list>\n#include <glm/glm.hpp>\n#include <glm/gtc/matrix_transform.hpp>\nint main() {\n" + code)
        file.write("for (auto m : {view, projection}) for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) printf(\"%.17g\\n\", m[j][i]);\n}\n")
    binary = os.path.join(folder, "check")
    subprocess.run(["g++", "-o", binary, path], check=True, capture_output=True, text=True)
    numbers = [float(x) for x in subprocess.run([binary], check=True, capture_output=True, text=True).stdout.split()]
    rows = [numbers[4 * i : 4 * i + 4] for i in range(8)]
    return rows[:4], rows[4:]


POINTS = [(0.5, -1, 0.25), (1, 0.5, 1.5), (-1, 0, -2), (0, -2, 0)]


def opencv(code, figure):
    """The largest distance in pixels between the images of points by OpenCV's own projection and by `inspect`."""
    import cv2
    import numpy as np

    names = {}
    exec(code, names)
    rotation, _ = cv2.Rodrigues(names["R"])
    found, _ = cv2.projectPoints(np.array(POINTS, float), rotation, names["t"], names["K"], None)
    points = json.loads(program("inspect", figure, *(x for p in POINTS for x in ("--point", ",".join(map(str, p))))))["points"]
    m, n = names["size"]
    # (5.22) without the floor.
    expected = [(m * (1 + p["ndc"][0]) / 2, n * (1 - p["ndc"][1]) / 2) for p in points]
    return max(abs(a - b) for p, q in zip(found[:, 0], expected) for a, b in zip(p, q))


def gltf(code, folder, truth):
    """The largest difference between the pose and θ that trimesh reads and those of `inspect`."""
    import trimesh

    if truth["camera"]["projection"] == "parallel":
        raise ImportError("trimesh reads no orthographic camera")
    path = os.path.join(folder, "camera.gltf")
    with open(path, "w") as file:
        file.write(code)
    scene = trimesh.load(path)
    pose = (scene.camera_transform - truth["inverse_view_matrix"]).ravel()
    return max(*map(abs, pose), abs(scene.camera.fov[1] - truth["camera"]["view_angle"]))


def numbers(name, folder, figure, truth):
    """The programs whose numbers aren't matrices of OpenGL; a camera that one of them can't have is skipped."""
    for target, worst_of in {
        "opencv": lambda code: opencv(code, figure),
        "gltf": lambda code: gltf(code, folder, truth),
    }.items():
        try:
            worst = worst_of(program("code", figure, "--for", target))
        except (ImportError, subprocess.CalledProcessError) as error:
            print(f"{name}, {target}: skipped ({str(error).splitlines()[0]})")
            continue
        # Numbers of a hundred pixels, and trimesh's arithmetic of angles.
        yield worst < 1e-9
        print(f"{name}, {target}: {'the same' if worst < 1e-9 else 'DIFFERENT'} (largest difference {worst:.1e})")


def main():
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        for name, text in FIGURES.items():
            figure = os.path.join(folder, "figure.toml")
            with open(figure, "w") as file:
                file.write(text)
            truth = json.loads(program("inspect", figure))
            expected = truth["view_matrix"], truth["projection_matrix"]
            failed |= not all(list(numbers(name, folder, figure, truth)))
            for target, run in {
                "numpy": python,
                "vtk": python,
                "threejs": lambda code: three(code, folder),
                "glm": lambda code: glm(code, folder),
            }.items():
                code = program("code", figure, "--for", target)
                try:
                    found = run(code)
                except (ImportError, FileNotFoundError, subprocess.CalledProcessError) as error:
                    print(f"{name}, {target}: skipped ({str(error).splitlines()[0]})")
                    continue
                worst = max(
                    abs(a - b) / max(1.0, abs(b))
                    for m, n in zip(found, expected) for r, s in zip(m, n) for a, b in zip(r, s)
                )
                verdict = "the same" if worst < 1e-12 else "DIFFERENT"
                failed |= worst >= 1e-12
                print(f"{name}, {target}: {verdict} (largest difference {worst:.1e})")
    sys.exit(failed)


main()
