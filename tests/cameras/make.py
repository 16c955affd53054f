#!/usr/bin/env python3
"""Makes cases.json: cameras as other programs write them, from the conventions that the programs publish.

    python3 tests/cameras/make.py > tests/cameras/cases.json

Nothing here comes from the program: matrices are built from the definitions of each library, in its own world. `tests/it/foreign.rs`
runs the cases. Standard library only."""
import json
from math import atan, cos, degrees, pi, radians, sin, sqrt, tan

# Vectors and matrices, for column vectors unless a case says otherwise.


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    return [x / sqrt(dot(v, v)) for x in v]


def minus(v):
    return [-x for x in v]


def transposed(m):
    return [list(row) for row in zip(*m)]


def times(a, b):
    return [[dot(row, column) for column in zip(*b)] for row in a]


def frame(eye, target, up, left_handed=False):
    """Right, up and ahead of a camera. In a left-handed world the cross product of a left hand is the same formula."""
    ahead = unit(sub(target, eye))
    right = unit(cross(up, ahead) if left_handed else cross(ahead, up))
    true_up = cross(ahead, right) if left_handed else cross(right, ahead)
    return right, true_up, ahead


def view(axes, eye):
    """World to camera, the rows are the axes of the camera."""
    return [[*axis, -dot(axis, eye)] for axis in axes] + [[0, 0, 0, 1]]


def pose(axes, eye):
    """Camera to world, the columns are the axes of the camera and its place."""
    return transposed([[*axis, 0] for axis in axes] + [[*eye, 1]])


def quaternion(m):
    """w x y z of a rotation with a positive trace, or the general case by the largest."""
    r = [row[:3] for row in m[:3]]
    trace = r[0][0] + r[1][1] + r[2][2]
    if trace > 0:
        s = 2 * sqrt(trace + 1)
        return [s / 4, (r[2][1] - r[1][2]) / s, (r[0][2] - r[2][0]) / s, (r[1][0] - r[0][1]) / s]
    i = max(range(3), key=lambda k: r[k][k])
    j, k = (i + 1) % 3, (i + 2) % 3
    s = 2 * sqrt(1 + r[i][i] - r[j][j] - r[k][k])
    q = [(r[k][j] - r[j][k]) / s, 0, 0, 0]
    q[1 + i], q[1 + j], q[1 + k] = s / 4, (r[j][i] + r[i][j]) / s, (r[k][i] + r[i][k]) / s
    return q


def perspective(theta, aspect, a, b, sign, down=False):
    """z' = a z + b, w' = sign z; the library says a and b."""
    y = 1 / tan(radians(theta) / 2)
    return [[y / aspect, 0, 0, 0], [0, -y if down else y, 0, 0], [0, 0, a, b], [0, 0, sign, 0]]


# Text, as programs print it.


def lines(m, form="{!r}", between=" "):
    return "\n".join(between.join(form.format(float(x)) for x in row) for row in m)


def flat(m):
    return [float(x) for row in m for x in row]


def numpy(m):
    rows = ",\n       ".join("[" + ", ".join(f"{float(x): .8f}" for x in row) + "]" for row in m)
    return f"array([{rows}])"


CASES = []


def case(name, kind, source, arguments, text, *expect, file=None):
    """A text that is pasted, or a file that is read."""
    given = ["--from", file] if file else ["--numbers", text]
    args = ["matrix", "empty.toml", "--format", "json", *arguments, *given]
    files = {file: text} if file else {}
    CASES.append({"id": name, "kind": kind, "source": source, "args": args, "files": files, "expect": list(expect)})


OK = {"rc": 0}
REFUSED = {"rc": 2}


def is_at(eye, axes, tolerance=1e-6, worlds=("as-is",)):
    right, up, ahead = axes
    return {"pose": {"C": eye, "dop": ahead, "up": up}, "a": tolerance, "worlds": list(worlds)}


def value(path, number, relative=1e-6):
    return {"path": path, "v": number, "r": relative}


def lens(theta, aspect, near, far=None, relative=1e-5):
    found = [value("camera.view_angle", theta, relative), value("camera.aspect", aspect, relative), value("camera.near", near, relative)]
    return found + ([value("camera.far", far, relative)] if far else [])


def projections():
    microsoft = "https://learn.microsoft.com/en-us/windows/win32/direct3d9/d3dxmatrixperspectivefovlh"
    f, b = 0.5, 100.0
    m = perspective(50, 1.6, b / (b - f), -f * b / (b - f), 1)
    case("a01", "projection", microsoft, [], lines(transposed(m)), OK, *lens(50, 1.6, f, b))
    m = perspective(50, 1.6, b / (f - b), f * b / (f - b), -1)
    case("a02", "projection", microsoft.replace("lh", "rh"), [], lines(transposed(m)), OK, *lens(50, 1.6, f, b))
    f, b = 0.1, 50.0
    m = perspective(70, 1.5, b / (f - b), -f * b / (b - f), -1, down=True)
    case("a03", "projection", "https://johannesugb.github.io/gpu-programming/setting-up-a-proper-vulkan-projection-matrix/", [],
         json.dumps(flat(transposed(m))), OK, *lens(70, 1.5, f, b))
    m = perspective(60, 1.25, b / (f - b), f * b / (f - b), -1)
    case("a04", "projection", "https://glmatrix.net/docs/module-mat4.html, perspectiveZO", [],
         "Float32Array(16) " + json.dumps(flat(transposed(m))), OK, *lens(60, 1.25, f, b))
    # FReversedZPerspectiveMatrix: row vectors, no back plane.
    m = perspective(45, 16 / 9, 0, 10, 1)
    case("a05", "projection", "https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Core/FReversedZPerspectiveMatrix", [],
         lines(transposed(m)), OK, *lens(45, 16 / 9, 10))
    # glam: Mat4::perspective_infinite_reverse_rh, as Debug prints it.
    m = transposed(perspective(45, 1.5, 0, 0.1, -1))
    columns = ", ".join(f"{axis}_axis: Vec4({', '.join(f'{float(x)}' for x in column)})" for axis, column in zip("xyzw", m))
    case("a06", "projection", "https://docs.rs/glam/latest/glam/f32/struct.Mat4.html", [], f"Mat4 {{ {columns} }}", OK, *lens(45, 1.5, 0.1))
    # glOrtho(-4, 4, -3, 3, 1, 20)
    m = [[0.25, 0, 0, 0], [0, 1 / 3, 0, 0], [0, 0, -2 / 19, -21 / 19], [0, 0, 0, 1]]
    case("a07", "projection", "https://registry.khronos.org/OpenGL-Refpages/gl2.1/xhtml/glOrtho.xml", ["--as", "projection"], lines(m), OK,
         value("camera.height", 6), value("camera.aspect", 4 / 3), value("camera.near", 1), value("camera.far", 20))
    # glFrustum(-1, 3, -2, 1, 2, 30)
    m = [[1, 0, 0.5, 0], [0, 4 / 3, -1 / 3, 0], [0, 0, -32 / 28, -120 / 28], [0, 0, -1, 0]]
    case("a08", "projection", "https://registry.khronos.org/OpenGL-Refpages/gl2.1/xhtml/glFrustum.xml", [], numpy(m), OK,
         value("camera.near", 2, 1e-5), value("camera.far", 30, 1e-5), value("camera.window.left", -1, 1e-5),
         value("camera.window.right", 3, 1e-5), value("camera.window.bottom", -2, 1e-5), value("camera.window.top", 1, 1e-5))
    m = perspective(40, 1.2, -1, -2 * 0.25, -1)
    case("a09", "projection", "https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html#infinite-perspective-projection", [],
         json.dumps({"projectionMatrix": flat(transposed(m))}), OK, *lens(40, 1.2, 0.25))
    f, b = 0.3, 1000.0
    m = perspective(60, 16 / 9, -(b + f) / (b - f), -2 * b * f / (b - f), -1)
    case("a10", "projection", "https://docs.unity3d.com/ScriptReference/Camera-projectionMatrix.html", [],
         "projectionMatrix\n" + lines(m, "{:.5f}", "\t"), OK, *lens(60, 16 / 9, f, relative=1e-3))
    # Projection of Godot prints its columns.
    f, b = 0.05, 100.0
    m = transposed(perspective(75, 1.0, -(b + f) / (b - f), -2 * b * f / (b - f), -1))
    text = "\n".join(f"{axis}: ({', '.join(f'{float(x)}' for x in column)})" for axis, column in zip("XYZW", m))
    case("a11", "projection", "https://docs.godotengine.org/en/stable/classes/class_projection.html", [], text, OK, *lens(75, 1.0, f, b))
    # Depth is reversed and the far plane is there: glam's perspective_rh with near and far exchanged.
    f, b = 0.2, 400.0
    m = perspective(55, 1.4, f / (b - f), f * b / (b - f), -1)
    case("a12", "projection", "https://developer.nvidia.com/blog/visualizing-depth-precision/", [], lines(m), OK, *lens(55, 1.4, f, b))


EYE, TARGET = [3.0, 2.0, 6.0], [0.5, 0.25, -1.0]
Y, Z = [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]


def poses():
    right, up, ahead = axes = frame(EYE, TARGET, Y)
    gl, cv = [right, up, minus(ahead)], [right, minus(up), ahead]
    three = "https://threejs.org/docs/#api/en/math/Matrix4"
    case("b01", "pose", three, [], "matrixWorldInverse " + json.dumps(flat(transposed(view(gl, EYE)))), OK, is_at(EYE, axes))
    case("b02", "pose", three, [], '{"elements": ' + json.dumps(flat(transposed(pose(gl, EYE)))) + ', "name": "matrixWorld"}', OK, is_at(EYE, axes))
    case("b03", "pose", "https://docs.nerf.studio/quickstart/data_conventions.html", ["--axes", "opengl"], "c2w = " + numpy(pose(gl, EYE)), OK,
         is_at(EYE, axes, 1e-5))
    eye, target = [5.0, -7.0, 3.5], [0.5, 0.0, 1.0]
    right, up, ahead = z_axes = frame(eye, target, Z)
    rows = ",\n            ".join("(" + ", ".join(f"{x:.4f}" for x in row) + ")" for row in pose([right, up, minus(ahead)], eye))
    case("b04", "pose", "https://docs.blender.org/api/current/bpy.types.Object.html#bpy.types.Object.matrix_world", [], f"<Matrix 4x4 ({rows})>", OK,
         is_at(eye, z_axes, 2e-3, ["turned"]))
    case("b05", "pose", "https://docs.opencv.org/4.x/d9/d0c/group__calib3d.html", ["--axes", "opencv", "--as", "view"], lines(view(cv, EYE)[:3]), OK,
         is_at(EYE, axes))
    # A left-handed world with y up: x right, z ahead.
    right, up, ahead = left = frame(EYE, TARGET, Y, left_handed=True)
    case("b06", "left-handed", "https://docs.unity3d.com/ScriptReference/Camera-worldToCameraMatrix.html", [],
         "worldToCameraMatrix = " + lines(view([right, up, minus(ahead)], EYE), "{:.5f}", "\t"), OK, is_at(EYE, left, 1e-3, ["z-reversed"]))
    case("b07", "left-handed", "https://docs.unity3d.com/ScriptReference/Transform-localToWorldMatrix.html", [],
         "localToWorldMatrix\n" + lines(pose([right, up, ahead], EYE), "{:.5f}", "\t"), OK, is_at(EYE, left, 1e-3, ["z-reversed"]))
    case("b08", "left-handed", "https://learn.microsoft.com/en-us/windows/win32/direct3d9/d3dxmatrixlookatlh",
         ["--as", "view", "--columns", "--axes", "direct3d"], lines(transposed(view([right, up, ahead], EYE))), OK, is_at(EYE, left, 1e-6, ["z-reversed"]))
    case("b09", "left-handed", "https://doc.babylonjs.com/features/featuresDeepDive/cameras", ["--axes", "direct3d"],
         "viewMatrix: " + json.dumps(flat(transposed(view([right, up, ahead], EYE)))), OK, is_at(EYE, left, 1e-6, ["z-reversed"]))
    # Unreal: left-handed, z up, x ahead, y right. Its exporter of glTF writes (x, z, y).
    eye, target = [-6.0, 2.0, 3.0], [0.0, 0.5, 1.0]
    right, up, ahead = frame(eye, target, Z, left_handed=True)
    exchanged = [[v[0], v[2], v[1]] for v in (right, up, ahead)]
    case("b10", "left-handed", "https://dev.epicgames.com/documentation/en-us/unreal-engine/coordinate-system-and-spaces-in-unreal-engine",
         ["--axes", "unreal", "--as", "camera-to-world", "--columns"], lines(transposed(pose([ahead, right, up], eye))), OK,
         is_at([eye[0], eye[2], eye[1]], exchanged))
    # PyTorch3D: x left, y up, z ahead, row vectors.
    right, up, ahead = axes
    case("b11", "pose", "https://pytorch3d.org/docs/cameras", ["--axes", "pytorch3d", "--as", "view", "--columns"],
         lines(transposed(view([minus(right), up, ahead], EYE))), OK, is_at(EYE, axes))
    # ROS: x ahead, y left, z up.
    eye, target = [1.0, -4.0, 1.5], [0.0, 3.0, 1.0]
    right, up, ahead = ros = frame(eye, target, Z)
    m = pose([ahead, minus(right), up], eye)
    w, x, y, z = quaternion(m)
    case("b12", "pose", "https://www.ros.org/reps/rep-0103.html", ["--axes", "ros", "--as", "camera-to-world"],
         " ".join(repr(n) for n in [*eye, x, y, z, w]), OK, is_at(eye, ros, 1e-6, ["turned"]))
    # TUM: a time, t, and a quaternion x y z w from the camera of OpenCV to the world.
    m = pose(cv, EYE)
    w, x, y, z = quaternion(m)
    case("b13", "pose", "https://cvg.cit.tum.de/data/datasets/rgbd-dataset/file_formats", ["--axes", "opencv", "--as", "camera-to-world"],
         " ".join(repr(n) for n in [1305031102.1758, *EYE, x, y, z, w]), OK, is_at(EYE, axes))
    # KITTI odometry: twelve numbers of the pose of a camera of OpenCV.
    case("b14", "pose", "https://www.cvlibs.net/datasets/kitti/eval_odometry.php", ["--axes", "opencv", "--as", "camera-to-world"],
         " ".join(repr(n) for n in flat(m[:3])), OK, is_at(EYE, axes))
    case("b15", "pose", "https://docs.pyvista.org/api/plotting/_autosummary/pyvista.plotter.camera_position", [],
         f"[{tuple(EYE)},\n {tuple(TARGET)},\n (0.0, 1.0, 0.0)]", OK, is_at(EYE, axes), value("camera.focal_point", TARGET))
    tensor = "tensor([[" + "],\n        [".join(", ".join(f"{x: .6f}" for x in row) for row in view(cv, EYE)) + "]])"
    case("b16", "pose", "https://pytorch.org/docs/stable/tensors.html", ["--axes", "opencv"], "w2c = " + tensor, OK, is_at(EYE, axes, 1e-4))


def files():
    right, up, ahead = axes = frame(EYE, TARGET, Y)
    gl, cv = [right, up, minus(ahead)], [right, minus(up), ahead]
    m = view(cv, EYE)
    w, x, y, z = quaternion(m)
    t = [row[3] for row in m[:3]]
    numbers = " ".join(repr(n) for n in [w, x, y, z, *t])
    case("f01", "file", "https://colmap.github.io/format.html", ["--camera", "b.png"],
         f"# Camera list\n7 PINHOLE 800 600 700 700 400 300\n# Image list\n1 1 0 0 0 0 0 4 7 a.png\n\n2 {numbers} 7 b.png\n\n", OK, is_at(EYE, axes),
         value("camera.view_angle", 2 * degrees(atan(300 / 700))), file="images.txt")
    eye, target = [4.0, -6.0, 2.0], [0.0, 1.0, 0.5]
    r, u, a = z_axes = frame(eye, target, Z)
    frames = [{"file_path": name, "transform_matrix": m} for name, m in
              [("one.png", pose([[1, 0, 0], [0, 0, 1], [0, -1, 0]], [0, 0, 5])), ("two.png", pose([r, u, minus(a)], eye))]]
    case("f02", "file", "https://docs.nerf.studio/quickstart/data_conventions.html", ["--camera", "2"],
         json.dumps({"camera_angle_x": 0.8, "w": 800, "h": 400, "frames": frames}), OK, is_at(eye, z_axes, 1e-6, ["turned"]),
         value("camera.view_angle", 2 * degrees(atan(tan(0.4) / 2))), file="transforms.json")
    intrinsic = {"width": 640, "height": 480, "intrinsic_matrix": [520.0, 0, 0, 0, 520.0, 0, 320.0, 240.0, 1]}
    parameters = [{"class_name": "PinholeCameraParameters", "intrinsic": intrinsic, "extrinsic": flat(transposed(m))}
                  for m in (view([[1, 0, 0], [0, -1, 0], [0, 0, -1]], [0, 0, 3]), view(cv, EYE))]
    case("f03", "file", "https://www.open3d.org/docs/release/python_api/open3d.camera.PinholeCameraTrajectory.html", ["--camera", "2"],
         json.dumps({"class_name": "PinholeCameraTrajectory", "parameters": parameters}), OK, is_at(EYE, axes),
         value("camera.view_angle", 2 * degrees(atan(240 / 520))), file="trajectory.json")
    poses = [pose([[1, 0, 0], [0, -1, 0], [0, 0, -1]], [0, 0, 3]), pose(cv, EYE)]
    log = "".join(f"{k} {k} {k + 1}\n{lines(m, '{:.8f}')}\n" for k, m in enumerate(poses))
    case("f04", "file", "https://www.open3d.org/docs/release/python_api/open3d.io.read_pinhole_camera_trajectory.html", ["--camera", "2"], log, OK,
         is_at(EYE, axes, 1e-5), {"path": "readings.0.certainty", "m": "only"}, file="trajectory.log")
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"camera": 0, "matrix": flat(transposed(pose([[2 * c for c in axis] for axis in gl], EYE)))}],
            "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "aspectRatio": 1.6, "znear": 0.2, "zfar": 80}}]}
    case("f05", "file", "https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html#cameras", [], json.dumps(gltf), OK, is_at(EYE, axes),
         *lens(degrees(0.9), 1.6, 0.2, 80), file="camera.gltf")
    element = lambda values: "".join(f'<Element index="{k}" value="{v}"/>' for k, v in enumerate(values))
    rows = {"CameraPosition": EYE, "CameraFocalPoint": TARGET, "CameraViewUp": Y, "CameraViewAngle": [33.5], "CameraParallelProjection": [0]}
    rows = "".join(f'<Property name="{k}" id="9.{k}" number_of_elements="{len(v)}">{element(v)}</Property>\n' for k, v in rows.items())
    pvcc = f'<?xml version="1.0"?>\n<PVCameraConfiguration description="ParaView camera configuration" version="1.0">\n<Proxy>{rows}</Proxy>\n</PVCameraConfiguration>'
    paraview = "https://docs.paraview.org/en/latest/UsersGuide/displayingData.html#adjust-camera"
    case("f06", "file", paraview, [], pvcc, OK, is_at(EYE, axes), value("camera.view_angle", 33.5), value("camera.focal_point", TARGET), file="view.pvcc")
    case("f07", "file", paraview, [], "view.CameraPosition = [0.0, 0.0, 8.0]\nview.CameraParallelScale = 1.75\nview.CameraParallelProjection = 1\n", OK,
         is_at([0, 0, 8.0], ([1, 0, 0], Y, [0, 0, -1])), value("camera.height", 3.5), {"path": "camera.projection", "m": "parallel"})
    three = {"metadata": {"type": "Object"}, "object": {"type": "PerspectiveCamera", "fov": 50, "zoom": 1, "near": 0.1, "far": 2000, "aspect": 1.75,
                                                        "matrix": flat(transposed(pose(gl, EYE)))}}
    case("f08", "file", "https://github.com/mrdoob/three.js/wiki/JSON-Object-Scene-format-4", [], json.dumps(three), OK, is_at(EYE, axes),
         *lens(50, 1.75, 0.1, 2000), file="camera.json")


def pixels():
    opencv = "https://docs.opencv.org/4.x/d9/d0c/group__calib3d.html"
    right, up, ahead = axes = frame(EYE, TARGET, Y)
    rotation = view([right, minus(up), ahead], EYE)
    k = [[1100.0, 0, 960.0], [0, 1100.0, 540.0], [0, 0, 1]]
    full_hd = ["--size", "1920x1080"]
    theta = 2 * degrees(atan(540 / 1100))
    case("k01", "K", opencv, full_hd, numpy(k), OK, value("camera.view_angle", theta), value("camera.aspect", 16 / 9))
    p = times(k, rotation[:3])
    case("k02", "K", opencv, full_hd, lines([[-0.125 * x for x in row] for row in p]), OK, is_at(EYE, axes, 1e-6), value("camera.view_angle", theta))
    case("k03", "K", opencv, full_hd, f"K = {numpy(k)}\nR = {numpy([row[:3] for row in rotation[:3]])}\nt = {[row[3] for row in rotation[:3]]}", OK,
         is_at(EYE, axes, 1e-5), value("camera.view_angle", theta))
    # Fusiello's example is one of many with the principal point off the middle: here (330, 250) of 640 × 480.
    k = [[600.0, 0, 330.0], [0, 610.0, 250.0], [0, 0, 1]]
    near = 0.1
    sides = {"left": -330 / 600, "right": 310 / 600, "bottom": -230 / 610, "top": 250 / 610}
    case("k04", "K", opencv, ["--size", "640x480"], lines(k), OK, *[value(f"camera.window.{side}", near * s) for side, s in sides.items()])
    yaml = ("%YAML:1.0\n---\nimage_width: 1280\nimage_height: 720\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
            "   data: [ 900., 0., 640., 0., 900., 360., 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n"
            "   data: [ 0.01, 0., 0., 0., 0. ]\n")
    case("k05", "K", "https://docs.opencv.org/4.x/dd/d74/tutorial_file_input_output_with_xml_yml.html", [], yaml, OK,
         value("camera.view_angle", 2 * degrees(atan(360 / 900))), {"path": "image", "v": [1280, 720]}, file="calibration.yml")
    case("k06", "implausible", opencv, ["--size", "1920x1080"], "1000 0 60\n0 1000 40\n0 0 1", OK, {"path": "unknown", "m": "principal-point"})
    case("k07", "implausible", opencv, ["--size", "1080x1920"], "1400 0 960\n0 1400 540\n0 0 1", OK, {"path": "unknown", "m": "image-turned"})
    case("k08", "implausible", opencv, ["--size", "640x480"], "12 0 320\n0 12 240\n0 0 1", OK, {"path": "unknown", "m": "wide-angle"})


def refusals():
    case("r01", "refused", "https://en.cppreference.com/w/cpp/numeric/math/nan", [], "-nan(ind) 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1", REFUSED, {"says": "row 1|NaN"})
    case("r02", "refused", "https://numpy.org/doc/stable/user/misc.html", [], "1 0 0 0\n0 1 0 inf\n0 0 1 0\n0 0 0 1", REFUSED, {"says": "2,4"})
    case("r03", "refused", "https://stackoverflow.com/q/349050", [], "1 0 0 0\n0 0 0 0\n0 0 1 -5\n0 0 0 1", REFUSED, {"says": "row|singular|length"})
    case("r04", "refused", "https://registry.khronos.org/OpenGL-Refpages/gl2.1/xhtml/gluPerspective.xml", [],
         "1.5 0 0 0\n0 2 0 0\n0 0 -1.02 -0.2\n0 0 0 0", REFUSED, {"says": "row 4|row|singular"})
    case("r05", "refused", "https://learn.microsoft.com/en-us/windows/win32/direct3d9/d3dxmatrixlookatlh", ["--as", "view"],
         "0 0 0 0\n0 0 0 0\n0 1 0 -3\n0 0 0 1", REFUSED, {"says": "VUP|along|length"})
    case("r06", "refused", "https://numpy.org/doc/stable/reference/generated/numpy.array2string.html", [],
         "[[0.5 0.1 ... 2.0]\n [0.3 0.9 ... 1.0]\n [0.0 0.0 ... 1.0]]", REFUSED, {"says": "left out"})


def lenses():
    """inspect: the lens in other words."""
    blender = "https://docs.blender.org/manual/en/latest/render/cameras.html"
    wide = 'aspect = "16/9"\n'

    def figure(name, text, *expect):
        CASES.append({"id": name, "kind": "lens", "source": blender, "args": ["inspect", "f.toml", "--format", "json"],
                      "files": {"f.toml": "[camera]\n" + text}, "expect": list(expect)})

    angle = 2 * degrees(atan(18 / 50 * 9 / 16))
    figure("l01", wide + 'lens = { focal_length = 50, sensor = [36, 24], fit = "horizontal" }\n', OK, value("camera.view_angle", angle, 1e-14),
           value("lens.horizontal_angle", 39.59775270904986, 1e-12))
    figure("l02", 'aspect = "9/16"\nlens = { focal_length = 50, sensor = [36, 24], fit = "larger" }\n', OK,
           value("camera.view_angle", 39.59775270904986, 1e-12))
    figure("l03", wide + "horizontal_angle = 90\n", OK, value("camera.view_angle", 2 * degrees(atan(9 / 16)), 1e-14))
    figure("l04", "horizontal_angle = 90\nview_angle = 40\n", REFUSED, {"says": "line 2.*view_angle"})
    figure("l05", "lens = { focal_length = -5 }\n", REFUSED, {"says": r"line 2.*focal_length.*greater than 0"})


projections()
poses()
files()
pixels()
refusals()
lenses()
print("{\"cases\": [")
print(",\n".join(json.dumps(one, ensure_ascii=False) for one in CASES))
print("]}")
