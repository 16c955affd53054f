//! glTF files: their objects, and that broken ones are refused with the place of the fault.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use base64::Engine as _;
use camera_lab_engine::appearance::Rgba;
use camera_lab_engine::scene::{GlbFault, GltfFault, JsonFault, MeshError, Scene, primitives};
use glam::DVec3;

use super::meshes::{area, color, folder, load, only};

/// A glTF document with a sphere: the JSON, and the bytes of its buffer (positions, normals, 16-bit indices).
pub(super) fn gltf_sphere(buffer: &str) -> (String, Vec<u8>) {
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

pub(super) fn embedded() -> String {
    let (_, bytes) = gltf_sphere("");
    let data = base64::engine::general_purpose::STANDARD.encode(bytes);
    gltf_sphere(&format!(r#", "uri": "data:application/octet-stream;base64,{data}""#)).0
}

pub(super) fn glb(json: &str, bin: &[u8]) -> Vec<u8> {
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

/// A triangle at z = 0 whose accessor of positions is written as `accessor`, and the bytes behind it: two views, of
/// three points and of the contents of sparse accessors.
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
        assert_eq!(fault(&accessor, &bytes), GltfFault::OverBudget, "{count}");
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
    let mut first = whole.clone();
    first[4] = 1;
    let first = load("b.glb", &folder([("b.glb", &first)]));
    assert_eq!(first, Err(MeshError::Gltf { place: "asset".into(), fault: GltfFault::Version { found: "1".into() } }));
    assert_eq!(changed(16, b'X'), GlbFault::Parts);
    assert_eq!(changed(14, 0xff), GlbFault::End);
    for cut in ["glTF", "glTF\x02\0\0\0\x01\0\0\0", "glTF\x02\0\0\0\x0c\0\0\0"] {
        let broken = load("b.glb", &folder([("b.glb", cut.as_bytes())]));
        assert!(matches!(&broken, Err(MeshError::Gltf { fault: GltfFault::Container { .. }, .. })), "{broken:?}");
    }
}
