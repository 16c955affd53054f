//! Mesh files: what OBJ and glTF files of all kinds become, and that broken ones are refused with the place of the fault.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeMap;
use std::fmt::Write as _;

use base64::Engine as _;
use camera_lab::appearance::{Rgba, Style, Theme};
use camera_lab::scene::{
    GlbFault, GltfFault, JsonFault, Mesh, MeshError, MeshFiles, MeshNotice, ObjFault, Object, ObjectPaint, ObjectSpec,
    Preset, Scene, SceneError, SceneSpec, Shape, Wanted, build_with, no_files, primitives,
};
use glam::DVec3;
use proptest::prelude::*;

type Folder = BTreeMap<&'static str, Vec<u8>>;

fn folder<const N: usize>(files: [(&'static str, &[u8]); N]) -> Folder {
    files.into_iter().map(|(name, bytes)| (name, bytes.to_vec())).collect()
}

fn spec(path: &str) -> SceneSpec {
    let mesh = ObjectSpec::new("m", Shape::Mesh { path: path.to_owned() });
    SceneSpec { preset: Preset::Empty, objects: vec![mesh], lights: vec![] }
}

fn load_spec(spec: &SceneSpec, files: &Folder) -> Result<Scene, SceneError> {
    let mut read = |wanted: Wanted<'_>| files.get(wanted.path).cloned().map_or_else(|| no_files(wanted), Ok);
    build_with(spec, &Style::default(), &mut read, &mut MeshFiles::default())
}

fn load(path: &str, files: &Folder) -> Result<Scene, MeshError> {
    load_spec(&spec(path), files).map_err(|error| match error {
        SceneError::Mesh { name, error, .. } => {
            assert_eq!(name, "m");
            error
        }
        other => panic!("{other}"),
    })
}

fn obj(text: &str) -> Result<Scene, MeshError> {
    load("m.obj", &folder([("m.obj", text.as_bytes())]))
}

fn only(scene: &Scene) -> &Object {
    assert_eq!(scene.objects.len(), 1);
    &scene.objects[0]
}

fn color(object: &Object) -> Rgba {
    match object.paint {
        ObjectPaint::Solid(color) => color,
        _ => panic!("no solid paint"),
    }
}

/// The sum of the areas of the triangles, and of the parts of it that look along each axis.
fn area(mesh: &Mesh) -> (f64, DVec3) {
    let doubled = mesh.triangles.iter().map(|t| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        (b - a).cross(c - a)
    });
    doubled.fold((0.0, DVec3::ZERO), |(sum, total), d| (sum + d.length() / 2.0, total + d / 2.0))
}

// ---- OBJ ----------------------------------------------------------------------------------------------------------

const CUBE: &str = "\
# a cube
v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1
f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\nf 5 6 8 7
";

#[test]
fn quads_keep_their_sides_as_edges_and_get_flat_normals_at_creases() {
    let scene = obj(CUBE).unwrap();
    let cube = only(&scene);
    assert_eq!(cube.name, "m");
    assert_eq!((cube.mesh.triangles.len(), cube.mesh.edges.len(), cube.mesh.positions.len()), (12, 12, 24));
    assert!(cube.mesh.closed && !cube.two_sided);
    assert_eq!(area(&cube.mesh).0, 6.0);
    for t in &cube.mesh.triangles {
        let [a, b, c] = t.map(|i| cube.mesh.positions[i as usize]);
        assert!(t.iter().all(|&i| cube.mesh.normals[i as usize] == (b - a).cross(c - a).normalize()));
    }
}

#[test]
fn a_concave_polygon_is_covered_once() {
    // An L of area 3 in the plane z = 2, facing +z.
    let scene = obj("v 0 0 2\nv 2 0 2\nv 2 1 2\nv 1 1 2\nv 1 2 2\nv 0 2 2\nf 5 6 1 2 3 4\n").unwrap();
    let l = only(&scene);
    assert_eq!((l.mesh.triangles.len(), l.mesh.edges.len()), (4, 6));
    let (absolute, directed) = area(&l.mesh);
    assert!((absolute - 3.0).abs() < 1e-12 && (directed - DVec3::Z * 3.0).length() < 1e-12);
    assert!(!l.mesh.closed && l.two_sided, "an open surface is seen from both sides");
}

#[test]
fn all_ways_to_write_a_corner_mean_the_same() {
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 2\n";
    for face in [
        "f 1 2 3",
        "f -3 -2 -1",
        "f 1/1 2/1 3/1",
        "f 1//1 2//1 3//1",
        "f 1/1/1 2/1/1 3/1/1",
        "f -3/-1/-1 -2/-1/-1 -1/-1/-1",
    ] {
        let scene = obj(&format!("{points}{face}\n")).unwrap();
        let mesh = &only(&scene).mesh;
        assert_eq!(mesh.positions, [DVec3::ZERO, DVec3::X, DVec3::Y], "{face}");
        assert_eq!(mesh.normals, [DVec3::Z; 3], "{face}");
    }
}

#[test]
fn normals_of_the_file_are_kept_and_split_vertices() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\nf 2//2 4//2 3//2\n";
    let scene = obj(text).unwrap();
    let mesh = &only(&scene).mesh;
    assert_eq!(mesh.positions.len(), 6);
    assert!(mesh.normals.iter().filter(|n| (**n - DVec3::new(0.6, 0.0, 0.8)).length() < 1e-15).count() == 3);
    // The side between the two is still one edge.
    assert_eq!(mesh.edges.len(), 5);
    // One corner without a normal: all are computed.
    let scene = obj(&text.replace("4//2", "4")).unwrap();
    assert_eq!(only(&scene).mesh.normals, [DVec3::Z; 4]);
}

#[test]
fn several_objects_and_materials_become_several_parts() {
    let text = "mtllib a.mtl\no first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 2 3\nusemtl glass\nf 1 2 4\n\
                o second part\nusemtl unknown\nf 2 3 4\ng\n";
    let mtl = "newmtl red\nKa 1 2\nKd 1 0 0.2\nillum 2\nnewmtl glass\nKd 0 0 1\nTr 0.75\nmap_Kd\n";
    let scene = load("d/m.obj", &folder([("d/m.obj", text.as_bytes()), ("d/a.mtl", mtl.as_bytes())])).unwrap();
    let found: Vec<_> = scene.objects.iter().map(|o| (o.name.as_str(), color(o))).collect();
    assert_eq!(found[0], ("m/first", Rgba::rgb(255, 0, 51)));
    assert_eq!(found[1], ("m/first", Rgba::rgba(0, 0, 255, 64)));
    assert_eq!(found[2].0, "m/second part");
    assert_eq!(found.len(), 3);

    // Without the library the shape is there all the same; a colour of the figure wins.
    assert_eq!(load("m.obj", &folder([("m.obj", text.as_bytes())])).unwrap().objects.len(), 2);
    let mut own = spec("d/m.obj");
    own.objects[0].color = Some(Rgba::rgb(1, 2, 3));
    let scene = load_spec(&own, &folder([("d/m.obj", text.as_bytes()), ("d/a.mtl", mtl.as_bytes())])).unwrap();
    assert!(scene.objects.iter().all(|o| color(o) == Rgba::rgb(1, 2, 3)));
}

#[test]
fn oddities_of_real_files_are_read() {
    // Windows ends, tabs, a continued line, a comment behind values, Latin-1, vertex colours, a weight, lines and points.
    let mut bytes =
        b"# caf\xe9\r\nv\t0 0 0 0.5 0.5 0.5\r\nv 2 0 0 2 # halved\r\nv 0 1 \\\r\n0\r\nl 1 2 3\r\np 1\r\ns off\r\n"
            .to_vec();
    bytes.extend(b"cstype bezier\r\no caf\xe9\r\nf 1 2 \\\r\n3 # last\r\n");
    let scene = load("M.OBJ", &folder([("M.OBJ", &bytes)])).unwrap();
    assert_eq!(only(&scene).mesh.positions, [DVec3::ZERO, DVec3::X, DVec3::Y]);
    assert_eq!(only(&scene).mesh.triangles.len(), 1);
}

#[test]
fn broken_obj_files_are_refused_with_the_line() {
    let fault = |text: &str| match obj(text) {
        Err(MeshError::Obj { line, fault }) => (line, fault),
        other => panic!("{other:?}"),
    };
    let points = "v 0 0 0\nv 1 0 0\n\nv 0 1 0\n";
    let number = |s: &str| ObjFault::Number { found: s.to_owned() };
    assert_eq!(fault("v 0 0 0\nv 1 x 0\n"), (2, number("x")));
    assert_eq!(fault("v 0 0 0\n\n# c\nv 1 nan 0\n"), (4, number("nan")));
    assert_eq!(fault("v 0 0 1e999\n"), (1, number("1e999")));
    assert_eq!(fault("v 0 0 0 0\n"), (1, number("0")));
    assert_eq!(fault("v 1 0 0 1e-320\n"), (1, number("1e-320")), "divided by it, the point is nowhere");
    assert_eq!(fault("v 0 0\n"), (1, ObjFault::Coordinates { found: 2 }));
    assert_eq!(fault(&format!("{points}f 1 2 3.5\n")), (5, ObjFault::Corner { found: "3.5".into() }));
    assert_eq!(fault(&format!("{points}f 1 2 3/1/1/1\n")), (5, ObjFault::Corner { found: "3/1/1/1".into() }));
    assert_eq!(fault(&format!("{points}f 1 2 3/x\n")), (5, ObjFault::Corner { found: "3/x".into() }));
    assert_eq!(fault(&format!("{points}f 1 2 //3\n")), (5, ObjFault::Corner { found: "//3".into() }));
    let index = |found: &str| ObjFault::Index { found: found.to_owned(), points: 3 };
    assert_eq!(fault(&format!("{points}f 1 2 0\n")), (5, index("0")));
    assert_eq!(fault(&format!("{points}f 1 2 -4\nv 1 1 1\n")), (5, ObjFault::Index { found: "-4".into(), points: 3 }));
    assert_eq!(fault(&format!("{points}f 1 2 9\nf 1 2 3\no x\n")), (5, index("9")));
    assert_eq!(fault(&format!("{points}f 1 2 99999999999999999999\n")).0, 5);

    assert_eq!(obj(points), Err(MeshError::Empty));
    assert_eq!(obj(""), Err(MeshError::Empty));
    assert_eq!(load("m.stl", &folder([("m.stl", b"solid")])), Err(MeshError::Format));
    assert_eq!(
        load("gone.obj", &folder([])),
        Err(MeshError::Unreadable(Box::new(no_files(Wanted { path: "gone.obj", named_by: None }).unwrap_err())))
    );
}

/// What exporters write and readers take: the surface is read, and what was left out is said.
#[test]
fn what_other_programs_write_is_read_with_a_notice() {
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let read = |rest: &str| {
        let scene = obj(&format!("{triangle}{rest}")).unwrap();
        let notices: Vec<MeshNotice> = scene
            .notices
            .iter()
            .map(|(object, notice)| {
                assert_eq!(object, "m");
                notice.clone()
            })
            .collect();
        (scene, notices)
    };
    for corners in ["f 1/ 2/ 3/", "f 1// 2// 3//", "vt 0 0\nf 1/1/ 2/1/ 3/1/", "vn 0 1 0\nf 1//1 2//1 3//1"] {
        let (scene, notices) = read(corners);
        assert_eq!((only(&scene).mesh.triangles.len(), notices), (1, vec![]), "{corners}");
    }
    assert_eq!(only(&read("vn 0 3 4\nf 1//1 2//1 3//1").0).mesh.normals, [DVec3::new(0.0, 0.6, 0.8); 3]);

    let ignored = |line, found: &str| vec![MeshNotice::IndexIgnored { line, found: found.to_owned() }];
    for (face, found) in [
        ("f 1//1 2//1 3//7\nvn 0 3 4", "3//7"),
        ("f 1//1 2//0 3//1\nvn 0 3 4", "2//0"),
        ("f 1//-1 2//1 3//1\nvn 0 3 4", "1//-1"),
        ("f 1/1 2/1 3/2\nvt 0 0", "3/2"),
        ("f 1/0 2 3", "1/0"),
    ] {
        let (scene, notices) = read(face);
        assert_eq!(notices, ignored(4, found), "{face}");
        // Those of its triangle, where the file does not give all.
        assert_eq!(only(&scene).mesh.normals, [DVec3::Z; 3], "{face}");
    }
    let (_, notices) = read("f 1//1 2//1 3//1\nvn 0 3 4");
    assert_eq!(notices, [], "a face may come before its normals");

    let (scene, notices) = read("f 1 2 3\nf 1 2\nf 3\nf");
    assert_eq!(only(&scene).mesh.triangles.len(), 1);
    assert_eq!(notices, [MeshNotice::FacesSkipped { line: 5, found: 2, count: 3 }]);
    assert_eq!(obj(&format!("{triangle}f 1 2\n")), Err(MeshError::Empty));
}

#[test]
fn a_material_that_hides_its_object_altogether_is_opaque_and_one_that_does_not_stays() {
    let text = b"mtllib m.mtl\nusemtl glass\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let read = |opacity: &str| {
        let library = format!("newmtl glass\nKd 1 0 0\n{opacity}\nnewmtl unused\nTr 1.0\n");
        let scene = load("m.obj", &folder([("m.obj", &text[..]), ("m.mtl", library.as_bytes())])).unwrap();
        (color(only(&scene)), scene.notices)
    };
    let invisible = vec![("m".to_owned(), MeshNotice::Invisible { material: "glass".to_owned() })];
    assert_eq!(read("Tr 1.0"), (Rgba::rgb(255, 0, 0), invisible.clone()));
    assert_eq!(read("d 0"), (Rgba::rgb(255, 0, 0), invisible));
    assert_eq!(read("Tr 0.8"), (Rgba::rgba(255, 0, 0, 51), vec![]));
    assert_eq!(read("d 1"), (Rgba::rgb(255, 0, 0), vec![]));
}

#[test]
fn a_face_may_come_before_its_points() {
    assert_eq!(obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").unwrap().objects.len(), 1);
    // Also where another object lies between.
    assert_eq!(obj("o a\nf 1 2 3\no b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\n").unwrap().objects.len(), 2);
}

// ---- glTF ---------------------------------------------------------------------------------------------------------

/// A glTF document with a sphere: the JSON, and the bytes of its buffer (positions, normals, 16-bit indices).
fn gltf_sphere(buffer: &str) -> (String, Vec<u8>) {
    let sphere = primitives::sphere(8);
    let mut bytes = Vec::new();
    for v in sphere.positions.iter().chain(&sphere.normals) {
        bytes.extend(v.as_vec3().to_array().into_iter().flat_map(f32::to_le_bytes));
    }
    let at = bytes.len();
    for i in sphere.triangles.as_flattened() {
        bytes.extend(u16::try_from(*i).unwrap().to_le_bytes());
    }
    let (n, m) = (sphere.positions.len(), 3 * sphere.triangles.len());
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
"nodes": [{{"name": "ball", "translation": [1, 2, 3], "children": [1]}},
          {{"name": "small", "scale": [0.5, 0.5, 0.5], "rotation": [0, 0, 0.70710678, 0.70710678], "translation": [4, 0, 0], "mesh": 0}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "NORMAL": 1}}, "indices": 2, "material": 0}}]}}],
"materials": [{{"pbrMetallicRoughness": {{"baseColorFactor": [1, 0.214041, 0, 0.5]}}, "alphaMode": "BLEND"}}],
"accessors": [
  {{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": {n}, "min": [-1, -1, -1], "max": [1, 1, 1]}},
  {{"bufferView": 0, "byteOffset": {}, "componentType": 5126, "type": "VEC3", "count": {n}}},
  {{"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": {m}}}],
"bufferViews": [{{"buffer": 0, "byteLength": {at}, "byteStride": 12}}, {{"buffer": 0, "byteOffset": {at}, "byteLength": {}}}],
"buffers": [{{"byteLength": {}{buffer}}}]}}"#,
        12 * n,
        2 * m,
        bytes.len()
    );
    (json, bytes)
}

fn embedded() -> String {
    let (_, bytes) = gltf_sphere("");
    let data = base64::engine::general_purpose::STANDARD.encode(bytes);
    gltf_sphere(&format!(r#", "uri": "data:application/octet-stream;base64,{data}""#)).0
}

fn glb(json: &str, bin: &[u8]) -> Vec<u8> {
    let pad = |bytes: &[u8], with: u8| {
        let mut padded = bytes.to_vec();
        padded.resize(bytes.len().next_multiple_of(4), with);
        padded
    };
    let (json, bin) = (pad(json.as_bytes(), b' '), pad(bin, 0));
    let len = |n: usize| u32::try_from(n).unwrap().to_le_bytes();
    let mut out = b"glTF\x02\0\0\0".to_vec();
    out.extend(len(12 + 8 + json.len() + 8 + bin.len()));
    out.extend(len(json.len()));
    out.extend(b"JSON");
    out.extend(json);
    out.extend(len(bin.len()));
    out.extend(b"BIN\0");
    out.extend(bin);
    out
}

fn assert_is_the_sphere(scene: &Scene) {
    let ball = only(scene);
    let expected = primitives::sphere(8);
    assert_eq!(ball.mesh.triangles.len(), expected.triangles.len());
    assert_eq!(ball.mesh.positions.len(), expected.positions.len());
    assert!(ball.mesh.closed && !ball.two_sided);
    assert_eq!(color(ball), Rgba::rgba(255, 127, 0, 128), "linear light becomes sRGB");
    // The node's own transform, then its parent's: x → y by the turn, halved, moved.
    let p = ball.world_from_object.transform_point3(DVec3::X);
    assert!((p - DVec3::new(5.0, 2.5, 3.0)).length() < 1e-6, "{p}");
    for (p, n) in ball.mesh.positions.iter().zip(&ball.mesh.normals) {
        assert!(p.dot(*n) > 1.0 - 1e-6);
    }
}

#[test]
fn gltf_is_read_from_embedded_external_and_binary_buffers() {
    let embedded = embedded();
    assert_is_the_sphere(&load("b.gltf", &folder([("b.gltf", embedded.as_bytes())])).unwrap());
    let (json, bytes) = gltf_sphere(r#", "uri": "the%20ball.bin""#);
    let files = folder([("x/b.gltf", json.as_bytes()), ("x/the ball.bin", &bytes)]);
    assert_is_the_sphere(&load("x/b.gltf", &files).unwrap());
    let (json, bytes) = gltf_sphere("");
    assert_is_the_sphere(&load("b.glb", &folder([("b.glb", &glb(&json, &bytes))])).unwrap());
}

#[test]
fn missing_normals_are_computed_and_strips_and_fans_turn_one_way() {
    let with = |what: &str, by: &str| {
        let json = embedded();
        assert!(json.contains(what));
        load("b.gltf", &folder([("b.gltf", json.replace(what, by).as_bytes())]))
    };
    let scene = with(r#", "NORMAL": 1"#, "").unwrap();
    let mesh = &only(&scene).mesh;
    assert!(mesh.positions.iter().zip(&mesh.normals).all(|(p, n)| p.dot(*n) > 0.8));

    // The corners of a strip and of a fan in the plane z = 0, all facing +z.
    for (mode, order) in [(5, [0, 1, 2, 3]), (6, [0, 1, 3, 2])] {
        let mut bytes = Vec::new();
        for p in [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]] {
            bytes.extend(p.into_iter().flat_map(f32::to_le_bytes));
        }
        bytes.extend(order);
        let json = format!(
            r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "mode": {mode}}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4, "min": [0,0,0], "max": [1,1,0]}},
{{"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": 4}}],
"bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 4}}],
"buffers": [{{"byteLength": 52}}]}}"#
        );
        let scene = load("s.glb", &folder([("s.glb", &glb(&json, &bytes))])).unwrap();
        assert_eq!(area(&only(&scene).mesh), (1.0, DVec3::Z), "mode {mode}");
    }
}

/// A triangle at z = 0 whose accessor of positions is written as `accessor`, and the bytes behind it: two views, of three points
/// and of what sparse accessors hold.
fn sparse_triangle(accessor: &str, sparse: &[u8]) -> Result<Scene, MeshError> {
    let points = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mut bytes: Vec<u8> = points.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend(sparse);
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
"accessors": [{{"componentType": 5126, "type": "VEC3", "min": [0,0,0], "max": [1,1,1], {accessor}}}],
"bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": 36, "byteLength": {}}}],
"buffers": [{{"byteLength": {}}}]}}"#,
        sparse.len(),
        bytes.len()
    );
    load("s.glb", &folder([("s.glb", &glb(&json, &bytes))]))
}

#[test]
fn sparse_accessors_replace_some_of_their_items() {
    let floats = |values: &[f32]| values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>();
    let sparse = |width: u32, at: usize, count: usize| {
        format!(
            r#""sparse": {{"count": {count}, "indices": {{"bufferView": 1, "componentType": {width}}},
"values": {{"bufferView": 1, "byteOffset": {at}}}}}"#
        )
    };
    // The last two of three points, with indices of each width.
    let values = floats(&[2.0, 0.0, 1.0, 0.0, 3.0, 1.0]);
    for (width, indices) in [(5121, vec![1, 2, 0, 0]), (5123, vec![1, 0, 2, 0]), (5125, vec![1, 0, 0, 0, 2, 0, 0, 0])] {
        let at = indices.len();
        let bytes = [indices, values.clone()].concat();
        let scene =
            sparse_triangle(&format!(r#""bufferView": 0, "count": 3, {}"#, sparse(width, at, 2)), &bytes).unwrap();
        assert_eq!(only(&scene).mesh.positions, [DVec3::ZERO, DVec3::new(2.0, 0.0, 1.0), DVec3::new(0.0, 3.0, 1.0)]);
        // Without a view, the others are 0.
        let scene = sparse_triangle(&format!(r#""count": 3, {}"#, sparse(width, at, 2)), &bytes).unwrap();
        assert_eq!(only(&scene).mesh.positions[0], DVec3::ZERO);
    }
    let fault = |accessor: &str, bytes: &[u8]| match sparse_triangle(accessor, bytes) {
        Err(MeshError::Gltf { place, fault }) => {
            assert_eq!(place, "accessors[0]");
            fault
        }
        other => panic!("{other:?}"),
    };
    for (indices, found) in [([1, 3, 0, 0], 3), ([1, 1, 0, 0], 1), ([2, 0, 0, 0], 0)] {
        let bytes = [&indices[..], &values].concat();
        let accessor = format!(r#""bufferView": 0, "count": 3, {}"#, sparse(5121, 4, 2));
        assert_eq!(fault(&accessor, &bytes), GltfFault::SparseIndex { found, count: 3 });
    }
    let short = [&[1, 2, 0, 0][..], &values[..20]].concat();
    assert_eq!(
        fault(&format!(r#""bufferView": 0, "count": 3, {}"#, sparse(5121, 4, 2)), &short),
        GltfFault::OutOfBuffer
    );
    // A line that asks for gigabytes of zeros.
    let bytes = [&[1, 2, 0, 0][..], &values].concat();
    for count in [2_000_000_usize, 4_000_000_000, usize::MAX / 16] {
        let accessor = format!(r#""count": {count}, {}"#, sparse(5121, 4, 2));
        assert_eq!(fault(&accessor, &bytes), GltfFault::TooMuch, "{count}");
    }
}

#[test]
fn a_chain_of_nodes_without_a_scene_takes_time_by_its_length() {
    let count = 100_000;
    let chain: Vec<String> = (1..count).map(|i| format!(r#"{{"children": [{i}]}}"#)).collect();
    let json = embedded();
    let start = json.find(r#""nodes": [{"name""#).unwrap();
    let end = json.find(r#""meshes""#).unwrap();
    let long = format!("{}\"nodes\": [{}, {{\"mesh\": 0}}],\n{}", &json[..start], chain.join(", "), &json[end..])
        .replace(r#""scene": 0, "scenes": [{"nodes": [0]}],"#, "");
    let begin = std::time::Instant::now();
    assert_eq!(load("b.gltf", &folder([("b.gltf", long.as_bytes())])).unwrap().objects.len(), 1);
    // All children against all nodes: half a minute and more in a build like this.
    assert!(begin.elapsed().as_secs() < 15, "{:?}", begin.elapsed());
}

#[test]
fn broken_gltf_files_are_refused_with_the_place() {
    let edited = |what: &str, by: &str| {
        let json = embedded();
        assert!(json.contains(what), "{what}");
        match load("b.gltf", &folder([("b.gltf", json.replacen(what, by, 1).as_bytes())])) {
            Err(MeshError::Gltf { place, fault }) => (place, fault),
            other => panic!("{other:?}"),
        }
    };
    let at = |place: &str, fault| (place.to_owned(), fault);
    assert_eq!(edited(r#""mesh": 0"#, r#""mesh": 7"#), at("nodes[1].mesh", GltfFault::Reference));
    let place = r#"meshes[0].primitives[0].attributes["POSITION"]"#;
    assert_eq!(edited(r#""POSITION": 0"#, r#""POSITION": 99"#), at(place, GltfFault::Reference));
    assert_eq!(edited(r#""byteOffset": 312"#, r#""byteOffset": 900"#), at("accessors[1]", GltfFault::OutOfBuffer));
    assert_eq!(edited("5126", "5123"), at("accessors[0]", GltfFault::Unsupported { what: "Vec3 U16".into() }));
    assert_eq!(edited("base64,", "base64,*"), at("buffers[0]", GltfFault::DataUri));
    assert_eq!(edited(r#""buffers": [{"byteLength": "#, r#""buffers": [{"byteLength": 9"#).1, GltfFault::NoBytes);
    assert_eq!(edited(r#""children": [1]"#, r#""children": [1, 1]"#), at("nodes[1]", GltfFault::Tree));
    assert_eq!(edited(r#""children": [1]"#, r#""children": [0]"#), at("nodes[0]", GltfFault::Tree));
    for version in ["1.0", "3.0", "20", "", "2\\u001b"] {
        let found = version.replace("\\u001b", "\\u{1b}");
        let edited = edited(r#""version": "2.0""#, &format!(r#""version": "{version}""#));
        assert_eq!(edited, at("asset", GltfFault::Version { found }));
    }
    let later = edited(r#""version": "2.0""#, r#""version": "2.0", "minVersion": "3.0""#);
    assert_eq!(later, at("asset", GltfFault::Version { found: "3.0".into() }));

    let (json, mut bytes) = gltf_sphere("");
    let last = bytes.len() - 1;
    bytes[last] = 0xff;
    let index = load("b.glb", &folder([("b.glb", &glb(&json, &bytes))]));
    assert!(matches!(&index, Err(MeshError::Gltf { fault: GltfFault::Index { vertices: 26, .. }, .. })), "{index:?}");
    bytes[..4].copy_from_slice(&f32::NAN.to_le_bytes());
    let nan = load("b.glb", &folder([("b.glb", &glb(&json, &bytes))]));
    assert_eq!(nan, Err(MeshError::Gltf { place: "accessors[0]".into(), fault: GltfFault::NotFinite }));

    let json = |text: &str| match load("b.gltf", &folder([("b.gltf", text.as_bytes())])) {
        Err(MeshError::Json { line, fault, .. }) => (line, fault),
        other => panic!("{other:?}"),
    };
    assert_eq!(json("{\n  \"asset\": nonsense\n}"), (2, JsonFault::Syntax));
    assert_eq!(json("{\n  \"asset\": {\"version\":"), (2, JsonFault::End));
    assert_eq!(json("{\n\"asset\": {}}"), (2, JsonFault::MissingKey { key: "version".into() }));
    assert_eq!(json("{\"asset\": {\"version\": \"2.0\"},\n\"nodes\": \"none\"}"), (2, JsonFault::Value));
    let (json, bytes) = gltf_sphere("");
    let whole = glb(&json, &bytes);
    let changed = |at: usize, by: u8| {
        let mut bytes = whole.clone();
        bytes[at] = by;
        match load("b.glb", &folder([("b.glb", &bytes)])) {
            Err(MeshError::Gltf { fault: GltfFault::Container { fault }, .. }) => fault,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(changed(4, 1), GlbFault::Version);
    assert_eq!(changed(16, b'X'), GlbFault::Parts);
    assert_eq!(changed(14, 0xff), GlbFault::End);
    for cut in ["glTF", "glTF\x02\0\0\0\x01\0\0\0", "glTF\x02\0\0\0\x0c\0\0\0"] {
        let broken = load("b.glb", &folder([("b.glb", cut.as_bytes())]));
        assert!(matches!(&broken, Err(MeshError::Gltf { fault: GltfFault::Container { .. }, .. })), "{broken:?}");
    }
}

// ---- all of them --------------------------------------------------------------------------------------------------

#[test]
fn a_file_that_many_objects_use_is_read_once_and_kept_between_builds() {
    let mut two = spec("m.obj");
    two.objects.push(ObjectSpec::new("n", Shape::Mesh { path: "m.obj".into() }).at(5.0, 0.0, 0.0));
    let mut reads = 0;
    let mut read = |_: Wanted<'_>| {
        reads += 1;
        Ok(CUBE.as_bytes().to_vec())
    };
    let dark = Style { theme: Theme::Dark, ..Style::default() };
    let mut files = MeshFiles::default();
    let first = build_with(&two, &Style::default(), &mut read, &mut files).unwrap();
    let second = build_with(&two, &dark, &mut read, &mut files).unwrap();
    assert!(std::sync::Arc::ptr_eq(&first.objects[0].mesh, &second.objects[1].mesh));
    // Once the scene does without it, it is forgotten.
    build_with(&SceneSpec::default(), &dark, &mut read, &mut files).unwrap();
    build_with(&two, &dark, &mut read, &mut files).unwrap();
    assert_eq!(reads, 2);
}

#[test]
fn a_hundred_thousand_triangles_come_through_whole() {
    let sphere = primitives::sphere(320);
    let mut text = String::new();
    for p in &sphere.positions {
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).unwrap();
    }
    for t in &sphere.triangles {
        writeln!(text, "f {} {} {}", t[0] + 1, t[1] + 1, t[2] + 1).unwrap();
    }
    let scene = obj(&text).unwrap();
    let mesh = &only(&scene).mesh;
    assert_eq!((mesh.triangles.len(), mesh.positions.len()), (sphere.triangles.len(), sphere.positions.len()));
    assert!(mesh.closed && mesh.triangles.len() > 100_000);
    assert_eq!(mesh.edges.len(), sphere.triangles.len() * 3 / 2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Whatever the bytes: a scene or an error, no panic, and only finite numbers and indices in range.
    #[test]
    fn damaged_files_do_no_harm(
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in any::<prop::sample::Index>(),
        which in 0..4_usize,
        cut_it in any::<bool>(),
    ) {
        let (json, bytes) = gltf_sphere("");
        let obj = format!("mtllib m.mtl\nvn 0 0 1\nvt 0 0\nusemtl a\n{CUBE}f 1/1/1 2/1/1 3/1/1\nf -1 -2 -3\nl 1 2 3\n");
        let (name, mut damaged) = match which {
            0 => ("m.obj", obj.into_bytes()),
            1 => ("m.gltf", embedded().into_bytes()),
            2 => ("m.glb", glb(&json, &bytes)),
            _ => ("m.mtl", b"newmtl a\nKd 1 0 0\nd 0.5\nKa 1 1 1\nNs 5\nillum 2\nmap_Kd x.png\n".to_vec()),
        };
        for (at, byte) in edits {
            let at = at.index(damaged.len());
            damaged[at] = byte;
        }
        if cut_it {
            damaged.truncate(cut.index(damaged.len()));
        }
        let mut files = folder([("m.obj", b"mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")]);
        files.insert(name, damaged);
        let path = if name == "m.mtl" { "m.obj" } else { name };
        if let Ok(scene) = load_spec(&spec(path), &files) {
            for o in &scene.objects {
                prop_assert!(o.world_from_object.is_finite());
                prop_assert_eq!(o.mesh.normals.len(), o.mesh.positions.len());
                prop_assert!(o.mesh.positions.iter().all(|p| p.is_finite()));
                prop_assert!(o.mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-9));
                prop_assert!(o.mesh.triangles.iter().flatten().all(|&i| (i as usize) < o.mesh.positions.len()));
                prop_assert!(o.mesh.edges.iter().flatten().all(|&i| (i as usize) < o.mesh.positions.len()));
            }
        }
    }
}
