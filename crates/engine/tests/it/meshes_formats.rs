//! One mesh written in every format and every way comes back as the same triangles with the same colours, and what a
//! file holds beyond them is named.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::appearance::Rgba;
use camera_lab_engine::scene::{GltfFault, MeshError, MeshFault, MeshNotice, Object, ObjectPaint, Scene};
use glam::DVec3;
use proptest::prelude::*;

use super::meshes::{area, folder, load, load_spec, obj, only, spec};
use super::meshes_gltf::glb;

/// Points with colours, and triangles of them.
#[derive(Clone, Debug)]
struct Written {
    points: Vec<[f32; 3]>,
    colors: Vec<[u8; 3]>,
    triangles: Vec<[u32; 3]>,
}

/// The corners of a triangle with their colours, from the least one on.
type Corners = [([u64; 3], Rgba); 3];

fn from_least(mut corners: Corners) -> Corners {
    let least = (0..3).min_by_key(|&k| corners[k].0).unwrap();
    corners.rotate_left(least);
    corners
}

impl Written {
    fn triangles(&self, color: impl Fn([u8; 3]) -> Rgba) -> Vec<Corners> {
        let corner = |i: u32| {
            let i = i as usize;
            (self.points[i].map(|c| (f64::from(c) + 0.0).to_bits()), color(self.colors[i]))
        };
        self.triangles.iter().map(|t| from_least(t.map(corner))).collect()
    }
}

fn read(scene: &Scene) -> Vec<Corners> {
    let of = |object: &Object| -> Vec<Corners> {
        let color = |i: u32| match &object.paint {
            ObjectPaint::Solid(color) => *color,
            ObjectPaint::Vertices(colors) => colors[i as usize],
            other => panic!("{other:?}"),
        };
        let point = |i: u32| (object.mesh.positions[i as usize] + DVec3::ZERO).to_array().map(f64::to_bits);
        object.mesh.triangles.iter().map(|t| from_least(t.map(|i| (point(i), color(i))))).collect()
    };
    scene.objects.iter().flat_map(of).collect()
}

/// Without colours.
fn shape(triangles: Vec<Corners>) -> Vec<[[u64; 3]; 3]> {
    triangles.iter().map(|corners| corners.map(|(point, _)| point)).collect()
}

fn plain([r, g, b]: [u8; 3]) -> Rgba {
    Rgba::rgb(r, g, b)
}

fn linear([r, g, b]: [u8; 3]) -> Rgba {
    let channel = |c: u8| {
        let c = f64::from(c) / 255.0;
        let c = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
        #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
        let c = (c * 255.0).round() as u8;
        c
    };
    Rgba::rgb(channel(r), channel(g), channel(b))
}

fn written() -> impl Strategy<Value = Written> {
    let point = prop::array::uniform3(-8_i8..8);
    let color = prop_oneof![Just([200, 100, 0]), any::<[u8; 3]>()];
    (prop::collection::vec((point, color), 3..9)).prop_flat_map(|points| {
        let n = u32::try_from(points.len()).unwrap();
        let triangle = (0..n, 1..n, 1..n - 1).prop_map(move |(a, b, c)| {
            let b = (a + b) % n;
            // A third one that is neither.
            [
                a,
                b,
                (0..n)
                    .filter(|i| *i != a && *i != b)
                    .nth(c as usize - 1)
                    .unwrap_or((0..n).find(|i| *i != a && *i != b).unwrap()),
            ]
        });
        prop::collection::vec(triangle, 1..9).prop_map(move |triangles| Written {
            // No two points are one.
            points: points
                .iter()
                .zip(0_u8..)
                .map(|(([x, y, z], _), k)| [f32::from(*x) + f32::from(k) / 16.0, f32::from(*y) / 4.0, f32::from(*z)])
                .collect(),
            colors: points.iter().map(|(_, color)| *color).collect(),
            triangles,
        })
    })
}

/// OBJ, with one way out of two in each of eight respects.
fn as_obj(mesh: &Written, ways: u8) -> Vec<u8> {
    let way = |k: u8| ways >> k & 1 == 1;
    let blank = if way(0) { "\t" } else { " " };
    let most = if way(1) { 1.0 } else { 255.0 };
    let mut lines = Vec::new();
    for (p, c) in mesh.points.iter().zip(&mesh.colors) {
        let mut words = vec!["v".to_owned()];
        words.extend(p.iter().map(f32::to_string));
        words.extend(c.iter().map(|c| if most > 1.0 { c.to_string() } else { (f64::from(*c) / 255.0).to_string() }));
        lines.push(words.join(blank));
    }
    for t in &mesh.triangles {
        let n = mesh.points.len();
        let corner = |i: u32| if way(2) { format!("-{}", n - i as usize) } else { (i + 1).to_string() };
        let between = if way(3) { " \\\n" } else { blank };
        lines.push(format!("{} {}", if way(4) { "fo" } else { "f" }, t.map(corner).join(between)));
    }
    let end = if way(5) {
        "\r\n"
    } else if way(6) {
        "\r"
    } else {
        "\n"
    };
    let text = lines.join("\n").replace('\n', end);
    [if way(7) { "\u{feff}" } else { "" }.as_bytes(), text.as_bytes()].concat()
}

fn as_stl(mesh: &Written, ways: u8) -> Vec<u8> {
    let corners = || mesh.triangles.iter().map(|t| t.map(|i| mesh.points[i as usize]));
    if ways & 1 == 0 {
        let mut bytes = if ways & 2 == 0 { b"solid it isn't text".to_vec() } else { vec![0; 10] };
        bytes.resize(80, b' ');
        bytes.extend(u32::try_from(mesh.triangles.len()).unwrap().to_le_bytes());
        for t in corners() {
            bytes.extend([0; 12]);
            bytes.extend(t.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        return bytes;
    }
    let mut text = "solid a\n".to_owned();
    for t in corners() {
        text += "facet normal 0 0 0\n outer loop\n";
        t.iter().for_each(|[x, y, z]| text += &format!("  vertex {x} {y} {z:e}\n"));
        text += " endloop\nendfacet\n";
    }
    text += "endsolid\n";
    let text = if ways & 2 == 0 { text } else { text.to_uppercase() };
    if ways & 4 == 0 { text } else { text.replace('\n', "\r\n") }.into_bytes()
}

fn as_ply(mesh: &Written, ways: u8) -> Vec<u8> {
    let way = |k: u8| ways >> k & 1 == 1;
    let form = ["ascii", "binary_little_endian", "binary_big_endian", "ascii"][usize::from(ways & 3)];
    let (real, byte, whole) = if way(2) { ("float32", "uint8", "int32") } else { ("float", "uchar", "int") };
    let color = if way(3) { real } else { byte };
    let list = if way(4) { "vertex_indices" } else { "vertex_index" };
    let number = if way(5) { "ushort" } else { byte };
    let mut head = format!("ply\nformat {form} 1.0\ncomment any\\\nelement vertex {}\n", mesh.points.len());
    ["x", "y", "z"].iter().for_each(|name| head += &format!("property {real} {name}\n"));
    ["red", "green", "blue"].iter().for_each(|name| head += &format!("property {color} {name}\n"));
    head += &format!("element face {}\nproperty list {number} {whole} {list}\nend_header\n", mesh.triangles.len());
    let mut bytes = if way(6) { head.replace('\n', "\r\n") } else { head }.into_bytes();
    let text = form == "ascii";
    let mut put = |text_of: String, little: &[u8], ends: bool| {
        if text {
            bytes.extend(text_of.as_bytes());
            bytes.push(if ends { b'\n' } else { b' ' });
        } else if form == "binary_big_endian" {
            bytes.extend(little.iter().rev());
        } else {
            bytes.extend(little);
        }
    };
    for (p, c) in mesh.points.iter().zip(&mesh.colors) {
        p.iter().for_each(|x| put(x.to_string(), &x.to_le_bytes(), false));
        for (k, &c) in c.iter().enumerate() {
            let share = f32::from(c) / 255.0;
            if way(3) { put(share.to_string(), &share.to_le_bytes(), k == 2) } else { put(c.to_string(), &[c], k == 2) }
        }
    }
    for t in &mesh.triangles {
        if way(5) {
            put("3".to_owned(), &3_u16.to_le_bytes(), false);
        } else {
            put("3".to_owned(), &[3], false);
        }
        t.iter().enumerate().for_each(|(k, i)| put(i.to_string(), &i.to_le_bytes(), k == 2));
    }
    bytes
}

fn as_glb(mesh: &Written, ways: u8) -> Vec<u8> {
    let mut bytes: Vec<u8> = mesh.points.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    let (n, at) = (mesh.points.len(), bytes.len());
    let (kind, width, alpha) =
        ([5121, 5123, 5126, 5121][usize::from(ways & 3)], [1, 2, 4, 1][usize::from(ways & 3)], ways & 4);
    for c in &mesh.colors {
        for c in c.iter().copied().chain((alpha > 0).then_some(255)) {
            match width {
                1 => bytes.push(c),
                2 => bytes.extend((u16::from(c) * 257).to_le_bytes()),
                _ => bytes.extend((f32::from(c) / 255.0).to_le_bytes()),
            }
        }
        bytes.resize(bytes.len().next_multiple_of(4), 0);
    }
    let (stride, indices) = ((bytes.len() - at) / n, bytes.len());
    bytes.extend(mesh.triangles.as_flattened().iter().flat_map(|i| i.to_le_bytes()));
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "COLOR_0": 1}}, "indices": 2}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": {n}, "min": [-99,-99,-99], "max": [99,99,99]}},
{{"bufferView": 1, "componentType": {kind}, "normalized": {}, "type": "VEC{}", "count": {n}}},
{{"bufferView": 2, "componentType": 5125, "type": "SCALAR", "count": {}}}],
"bufferViews": [{{"buffer": 0, "byteLength": {at}}},
{{"buffer": 0, "byteOffset": {at}, "byteLength": {}, "byteStride": {stride}}},
{{"buffer": 0, "byteOffset": {indices}, "byteLength": {}}}],
"buffers": [{{"byteLength": {}}}]}}"#,
        kind != 5126,
        if alpha > 0 { 4 } else { 3 },
        3 * mesh.triangles.len(),
        indices - at,
        bytes.len() - indices,
        bytes.len(),
    );
    glb(&json, &bytes)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_mesh_is_the_same_in_every_format(mesh in written(), ways in any::<u8>()) {
        let read_as = |path: &'static str, bytes: &[u8]| load(path, &folder([(path, bytes)]));
        let scene = read_as("m.obj", &as_obj(&mesh, ways)).unwrap();
        prop_assert_eq!((read(&scene), scene.notices), (mesh.triangles(plain), vec![]));
        let scene = read_as("m.ply", &as_ply(&mesh, ways)).unwrap();
        prop_assert_eq!((read(&scene), scene.notices), (mesh.triangles(plain), vec![]));
        let scene = read_as("m.glb", &as_glb(&mesh, ways)).unwrap();
        prop_assert_eq!((read(&scene), scene.notices), (mesh.triangles(linear), vec![]));
        let scene = read_as("m.stl", &as_stl(&mesh, ways)).unwrap();
        prop_assert_eq!(shape(read(&scene)), shape(mesh.triangles(plain)));
        prop_assert_eq!(scene.notices, vec![]);
    }

    /// Every cut of a file is refused at a place in it, or its faces are those of the whole.
    #[test]
    fn a_cut_file_is_refused(mesh in written(), ways in any::<u8>(), cut in any::<prop::sample::Index>()) {
        for (path, bytes) in [("m.ply", as_ply(&mesh, ways)), ("m.stl", as_stl(&mesh, ways))] {
            let cut = &bytes[..cut.index(bytes.len())];
            match load(path, &folder([(path, cut)])) {
                Ok(scene) if path == "m.ply" => prop_assert_eq!(shape(read(&scene)).len(), mesh.triangles.len()),
                Ok(scene) => prop_assert!(mesh.triangles.len() >= read(&scene).len()),
                Err(MeshError::Line { line, .. }) => prop_assert!(line <= 1 + cut.len()),
                Err(MeshError::Byte { byte, .. }) => prop_assert!(byte <= cut.len().max(80)),
                Err(error) => prop_assert_eq!(error, MeshError::Empty),
            }
        }
    }

    /// A polygon with a hole goes along a bridge to the hole and back.
    #[test]
    fn a_hole_stays_open(
        outer in 3..9_u32, inner in 3..9_u32, turn in 0.0..6.0_f64, first in 0..20_usize, tilt in -1.0..1.0_f64,
    ) {
        let ring = |n: u32, radius: f64, turn: f64| (0..n).map(move |k| {
            let angle = turn + std::f64::consts::TAU * f64::from(k) / f64::from(n);
            DVec3::new(radius * angle.cos(), radius * angle.sin(), tilt * radius * angle.cos())
        });
        let points: Vec<DVec3> = ring(outer, 4.0, 0.0).chain(ring(inner, 1.0, turn)).collect();
        let near = (0..inner).min_by(|a, b| {
            let far = |k: &u32| points[(outer + k) as usize].distance(points[0]);
            far(a).total_cmp(&far(b))
        }).unwrap();
        // Round, in at the first corner, round the hole the other way, and out again.
        let mut corners: Vec<u32> = (0..outer).chain([0]).collect();
        corners.extend((0..=inner).map(|k| outer + (near + inner - k) % inner));
        let at = first % corners.len();
        corners.rotate_left(at);
        let mut text: String = points.iter().map(|p| format!("v {} {} {}\n", p.x, p.y, p.z)).collect();
        text += &format!("f {}\n", corners.iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>().join(" "));
        let (absolute, directed) = area(&only(&obj(&text).unwrap()).mesh);
        prop_assert!((absolute - directed.length()).abs() < 1e-9, "{absolute} {directed}");
    }
}

fn notices(scene: &Scene) -> Vec<&MeshNotice> {
    scene.notices.iter().map(|(_, notice)| notice).collect()
}

fn left_out(entries: &str) -> MeshNotice {
    MeshNotice::LeftOut { entries: entries.to_owned() }
}

const STL_WORDS: &str = "solid, facet normal, outer loop, 3 × vertex, endloop, endfacet, endsolid";

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn what_an_obj_file_has_beyond_faces_is_named_with_its_count() {
    let scene = obj(&format!("{TRIANGLE}f 1 2 3\nl 1 2\nl 2 3\np 1\ncstype bezier\nv 1 2 3 4 5\n# l\n\n")).unwrap();
    assert_eq!(notices(&scene), [&left_out("l (2), p (1), cstype (1), v x y z … (1)")]);
    // Without normals, smoothing groups count; with some, they're found from the faces.
    assert_eq!(notices(&obj(&format!("{TRIANGLE}s off\nf 1 2 3\n")).unwrap()), [&left_out("s (1)")]);
    let with_normals = format!("{TRIANGLE}vn 0 0 1\ns 1\nf 1//1 2//1 3//1\n");
    assert_eq!(obj(&with_normals).unwrap().notices, []);
    let some = obj(&format!("{with_normals}f 1 2 3\n")).unwrap();
    assert_eq!(notices(&some), [&left_out("s (1), vn (1)")]);
    // A file of another kind doesn't fill the screen.
    let junk: String = (0..100).map(|k| format!("word{k} x\n")).collect();
    let Some(MeshNotice::LeftOut { entries }) =
        notices(&obj(&format!("{TRIANGLE}f 1 2 3\n{junk}")).unwrap()).first().copied().cloned()
    else {
        panic!("no notice")
    };
    assert_eq!(entries, "word0 (1), word1 (1), word2 (1), word3 (1), word4 (1), word5 (1), word6 (1), … (93)");
}

#[test]
fn materials_are_found_in_all_libraries_wherever_they_stand() {
    let files = |obj: &'static str| {
        folder([
            ("m.obj", obj.as_bytes()),
            ("a.mtl", b"\xEF\xBB\xBFnewmtl x\rKd 0 0 1\r"),
            ("b c.MTL", b"newmtl red\nKd 1 0 0\nmap_Bump b.png\n"),
        ])
    };
    for obj in [
        "mtllib a.mtl b c.MTL\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl x\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl x\nf 1 2 3\nmtllib b c.MTL\nmtllib a.mtl\n",
    ] {
        let scene = load("m.obj", &files(obj)).unwrap();
        let colors: Vec<&ObjectPaint> = scene.objects.iter().map(|object| &object.paint).collect();
        assert_eq!(colors, [&ObjectPaint::Solid(Rgba::rgb(255, 0, 0)), &ObjectPaint::Solid(Rgba::rgb(0, 0, 255))]);
        assert_eq!(notices(&scene), [&left_out("map_Bump (1)")]);
    }
    let unknown = "mtllib a.mtl\nusemtl gone\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl lost\nusemtl gone\n";
    let scene = load("m.obj", &files(unknown)).unwrap();
    assert_eq!(notices(&scene), [&MeshNotice::NoMaterial { material: "gone".into(), count: 2 }]);
    // If a library can't be read, its own message says so.
    let scene = load("m.obj", &folder([("m.obj", unknown.as_bytes())])).unwrap();
    assert_eq!(scene.notices, []);
}

#[test]
fn colours_of_obj_vertices_stand_in_place_of_the_material_and_keep_its_opacity() {
    let text = "mtllib m.mtl\nusemtl glass\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3\n";
    let files = folder([("m.obj", text.as_bytes()), ("m.mtl", b"newmtl glass\nKd 0 0 1\nd 0.2\n")]);
    let scene = load("m.obj", &files).unwrap();
    let colors = [Rgba::rgba(255, 0, 0, 51), Rgba::rgba(0, 255, 0, 51), Rgba::rgba(0, 0, 255, 51)];
    assert_eq!(only(&scene).paint, ObjectPaint::Vertices(colors.to_vec().into()));
    // A colour of the figure wins.
    let mut own = spec("m.obj");
    own.objects[0].color = Some(Rgba::rgb(1, 2, 3));
    assert_eq!(only(&load_spec(&own, &files).unwrap()).paint, ObjectPaint::Solid(Rgba::rgb(1, 2, 3)));
}

#[test]
fn a_corner_of_two_colours_keeps_one_normal() {
    let text = "v 0 0 0 1 0 0\nv 1 0 0.1 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0.1 1 0 0\nv 0 0 0 0 1 0\nf 1 2 3\nf 1 3 4\n";
    let smooth = obj(text).unwrap();
    assert_eq!(only(&smooth).mesh.positions.len(), 4, "one colour is no reason for more vertices");
    assert_eq!(only(&smooth).paint, ObjectPaint::Solid(Rgba::rgb(255, 0, 0)));
    let varied = obj(&text.replace("v 1 1 0 1", "v 1 1 0 0")).unwrap();
    assert_eq!(only(&smooth).mesh.normals, only(&varied).mesh.normals);
}

#[test]
fn what_a_ply_file_has_beyond_its_mesh_is_named_with_its_count() {
    let ply = "ply\r\nformat ascii 1.0\r\nobj_info any\r\ncomment TextureFile a.png\r\nelement vertex 3\r\n\
               property double quality\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\nelement face 2\r\n\
               property list uchar float texcoord\r\nproperty list uchar int vertex_indices\r\nelement edge 1\r\n\
               property int vertex1\r\nend_header\r\n7 0 0 0\r\n7 1 0 0\r\n7 0 1 0\r\n2 1 2 3 0 1 2\r\n0 2 0 1\r\n5\r\nmore\r\n";
    let scene = load("m.ply", &folder([("m.ply", ply.as_bytes())])).unwrap();
    assert_eq!(
        notices(&scene),
        [&left_out("vertex.quality (3), face.texcoord (2), face[2] (1), edge.vertex1 (1), bytes (4)")]
    );
}

#[test]
fn broken_ply_and_stl_files_are_refused_with_the_place() {
    let head = |form: &str| {
        format!(
            "ply\nformat {form} 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    let line = |path: &'static str, text: &str| match load(path, &folder([(path, text.as_bytes())])) {
        Err(MeshError::Line { line, fault }) => (line, fault),
        other => panic!("{other:?}"),
    };
    let word = |found: &str, allowed: &str| MeshFault::Word { found: found.into(), allowed: allowed.into() };
    let index = |found: &str| MeshFault::Index { found: found.into(), points: 3 };
    let ply = |rows: &str| line("m.ply", &format!("{}{rows}", head("ascii")));
    assert_eq!(ply("0 0 0\n1 0 x\n"), (11, MeshFault::Number { found: "x".into() }));
    assert_eq!(ply("0 0 0\n1 0 nan\n"), (11, MeshFault::Number { found: "NaN".into() }));
    assert_eq!(ply("0 0 0\n1 0 0 1\n0 1 0\n"), (11, word("1", "x, y, z")));
    let points = "0 0 0\n1 0 0\n0 1 0\n";
    assert_eq!(ply(&format!("{points}3 0 1 3\n")), (13, index("3")));
    assert_eq!(ply(&format!("{points}3 0 1 -1\n")), (13, index("-1")));
    assert_eq!(ply(&format!("{points}3 0 1 1.5\n")), (13, index("1.5")));
    assert_eq!(ply(&format!("{points}-3 0 1 2\n")), (13, word("-3", "0, 1, 2, …")));
    assert_eq!(ply(&format!("{points}4 0 1 2\n")).1, MeshFault::End);
    let header = |text: &str| line("m.ply", text);
    assert_eq!(header("playing\n"), (1, word("playing", "ply")));
    assert_eq!(header("ply\nformat ascii 1.0\nelement vertex many\n"), (3, MeshFault::Number { found: "many".into() }));
    assert_eq!(header("ply\nformat text 1.0\n").0, 2);
    assert_eq!(header(&head("ascii").replace("float y", "real y")).0, 5);
    let lacks = head("ascii").replace("float y", "float w");
    assert_eq!(header(&lacks), (9, MeshFault::Missing { word: "element vertex: x, y, z".into() }));
    assert_eq!(header("ply\nformat ascii 1.0\n"), (2, MeshFault::End));
    let little = head("binary_little_endian");
    let cut = [little.as_bytes(), &[0; 20]].concat();
    let byte = little.len() + 20;
    let expected = Err(MeshError::Byte { byte, fault: MeshFault::End });
    assert_eq!(load("m.ply", &folder([("m.ply", &cut)])), expected);

    assert_eq!(line("m.stl", "solid\nfacet\nvertex 0 0\n"), (3, MeshFault::Coordinates { found: 2 }));
    assert_eq!(line("m.stl", "solid\nvertex 0 0 0\nendloop\n"), (3, word("endloop", STL_WORDS)));
    assert_eq!(line("m.stl", "solid\nvertex 0 0 0\n"), (2, MeshFault::End));
    assert_eq!(line("m.stl", "solid\nfacet\ncircle\n").0, 3);
    let mut binary = vec![0; 80];
    binary.extend([2, 0, 0, 0]);
    binary.extend([0; 50]);
    let fault = MeshFault::Length { triangles: 2, needed: 184, found: 134 };
    assert_eq!(load("m.stl", &folder([("m.stl", &binary)])), Err(MeshError::Byte { byte: 80, fault }));
}

#[test]
fn bytes_beside_and_behind_the_triangles_of_an_stl_file_are_named() {
    let triangle = Written {
        points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        colors: vec![[0; 3]; 3],
        triangles: vec![[0, 1, 2]],
    };
    let mut bytes = as_stl(&triangle, 2);
    bytes[132] = 5;
    bytes.push(7);
    let scene = load("m.stl", &folder([("m.stl", &bytes)])).unwrap();
    assert_eq!(notices(&scene), [&left_out("bytes (1), attribute byte count (1)")]);
}

#[test]
fn files_that_need_what_is_not_read_are_refused_with_its_name() {
    let read = |json: &str| load("m.gltf", &folder([("m.gltf", json.as_bytes())]));
    let refused = |place: &str, fault| Err(MeshError::Gltf { place: place.into(), fault });
    for name in ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "VENDOR_any"] {
        let json = format!(
            r#"{{"asset": {{"version": "2.0"}}, "extensionsRequired": ["KHR_texture_transform", "{name}"],
"accessors": [{{"componentType": 5126, "type": "VEC3", "count": 3}}]}}"#
        );
        assert_eq!(read(&json), refused("extensionsRequired", GltfFault::Extension { found: name.into() }));
    }
    // Version 1 has objects in place of lists, and the first of all had numbers.
    for (version, found) in [(r#""1.0""#, "1.0"), ("0.8", "0.8")] {
        let json = format!(r#"{{"meshes": {{"a": {{}}}}, "asset": {{"version": {version}}}}}"#);
        assert_eq!(read(&json), refused("asset", GltfFault::Version { found: found.into() }));
    }
}

#[test]
fn quantized_meshes_are_read_and_what_else_a_gltf_file_has_is_named() {
    let points: Vec<u8> =
        [[0_i16, 0, 0, 0], [4, 0, 0, 0], [0, 4, 0, 0]].as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}, {{"nodes": []}}],
"extensionsUsed": ["KHR_mesh_quantization", "KHR_lights_punctual"], "extensionsRequired": ["KHR_mesh_quantization"],
"nodes": [{{"mesh": 0, "scale": [0.25, 0.25, 0.25]}}], "cameras": [{{"type": "orthographic", "orthographic": {{"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}}}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "TANGENT": 0}}}}, {{"attributes": {{"POSITION": 0}}, "mode": 1}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5122, "type": "VEC3", "count": 3, "min": [0,0,0], "max": [4,4,0]}}],
"bufferViews": [{{"buffer": 0, "byteLength": {0}, "byteStride": 8}}], "buffers": [{{"byteLength": {0}}}]}}"#,
        points.len()
    );
    let scene = load("m.glb", &folder([("m.glb", &glb(&json, &points))])).unwrap();
    assert_eq!(scene.bounds().unwrap().max, DVec3::new(1.0, 1.0, 0.0));
    assert_eq!(
        notices(&scene),
        [&left_out("cameras (1), scenes (1), KHR_lights_punctual (1), TANGENT (1), Lines (1)")]
    );
    // Without the extension, whole numbers are no points.
    let plain = json.replace("KHR_mesh_quantization", "KHR_texture_transform");
    let error = load("m.glb", &folder([("m.glb", &glb(&plain, &points))]));
    assert!(matches!(error, Err(MeshError::Gltf { fault: GltfFault::Unsupported { .. }, .. })), "{error:?}");
}
