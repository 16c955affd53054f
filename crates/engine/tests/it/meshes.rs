//! Mesh files of all kinds: their common rules. The results of OBJ and glTF files, and the refusal of broken ones, are
//! beside this.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeMap;
use std::fmt::Write as _;

use camera_lab_engine::appearance::{Rgba, Style, Theme};
use camera_lab_engine::scene::{
    Mesh, MeshError, MeshFiles, Object, ObjectPaint, ObjectSpec, Preset, Scene, SceneError, SceneSpec, Shape,
    TextureSource, Wanted, build_with, no_files, primitives,
};
use glam::DVec3;
use proptest::prelude::*;

use super::meshes_gltf::{embedded, glb, gltf_sphere};

pub(super) type Folder = BTreeMap<&'static str, Vec<u8>>;

pub(super) fn folder<const N: usize>(files: [(&'static str, &[u8]); N]) -> Folder {
    files.into_iter().map(|(name, bytes)| (name, bytes.to_vec())).collect()
}

pub(super) fn spec(path: &str) -> SceneSpec {
    let mesh = ObjectSpec::new("m", Shape::Mesh { path: path.to_owned() });
    SceneSpec { preset: Preset::Empty, objects: vec![mesh], lights: vec![] }
}

pub(super) fn load_spec(spec: &SceneSpec, files: &Folder) -> Result<Scene, SceneError> {
    let mut read = |wanted: Wanted<'_>| files.get(wanted.path).cloned().map_or_else(|| no_files(wanted), Ok);
    build_with(spec, &Style::default(), &mut read, &mut MeshFiles::default())
}

pub(super) fn load(path: &str, files: &Folder) -> Result<Scene, MeshError> {
    load_spec(&spec(path), files).map_err(|error| match error {
        SceneError::Mesh { name, error, .. } => {
            assert_eq!(name, "m");
            error
        }
        other => panic!("{other}"),
    })
}

pub(super) fn obj(text: &str) -> Result<Scene, MeshError> {
    load("m.obj", &folder([("m.obj", text.as_bytes())]))
}

pub(super) fn only(scene: &Scene) -> &Object {
    assert_eq!(scene.objects.len(), 1);
    &scene.objects[0]
}

pub(super) fn color(object: &Object) -> Rgba {
    match object.paint {
        ObjectPaint::Solid(color) => color,
        _ => panic!("no solid paint"),
    }
}

/// The sum of the areas of the triangles, and of the parts of it that look along each axis.
pub(super) fn area(mesh: &Mesh) -> (f64, DVec3) {
    let doubled = mesh.triangles.iter().map(|t| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        (b - a).cross(c - a)
    });
    doubled.fold((0.0, DVec3::ZERO), |(sum, total), d| (sum + d.length() / 2.0, total + d / 2.0))
}

pub(super) const CUBE: &str = "\
# a cube
v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1
f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\nf 5 6 8 7
";

const STL: &str = "solid a b
facet normal 0 0 1 outer loop
vertex 0 0 0\nvertex 1 0 0\nVERTEX 0 1 0
endloop endfacet endsolid a b\n";

const PLY: &str = "ply
format FORM 1.0
comment x
element vertex 3
property float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue
element face 2
property list uchar int vertex_indices
element tristrips 1
property list int int vertex_indices
end_header
0 0 0 255 0 0
1 0 0 0 255 0
0 1 0 0 0 255
3 0 1 2
3 2 1 0
4 0 1 2 -1
";

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
        which in 0..7_usize,
        cut_it in any::<bool>(),
    ) {
        let (json, bytes) = gltf_sphere("");
        let obj = format!("mtllib m.mtl\nvn 0 0 1\nvt 0 0\nusemtl a\n{CUBE}f 1/1/1 2/1/1 3/1/1\nf -1 -2 -3\nl 1 2 3\n");
        let (name, mut damaged) = match which {
            0 => ("m.obj", obj.into_bytes()),
            1 => ("m.gltf", embedded().into_bytes()),
            2 => ("m.glb", glb(&json, &bytes)),
            3 => ("m.stl", STL.as_bytes().to_vec()),
            4 => ("m.ply", PLY.replace("FORM", "ascii").into_bytes()),
            5 => ("m.ply", [PLY.replace("FORM", "binary_little_endian").as_bytes(), &[1; 80]].concat()),
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

/// Counts, areas and bounds as in trimesh 5.2.0, but for two: it cuts a polygon with a hole as a fan, and counts
/// negative indices back from the last point of the file.
#[test]
fn polygons_have_the_counts_areas_and_bounds_of_another_reader() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement face 3\n\
        property list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 3\n4 0 1 2 3\n3 0 1 4\n3 1 2 4\n";
    let facet = |corners: &str| format!("facet normal 0 0 1\nouter loop\n{corners}\nendloop\nendfacet\n");
    let stl = [
        "solid a\n",
        &facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0"),
        "endsolid a\nsolid b\n",
        &facet("vertex 0 0 1\nvertex 2 0 1\nvertex 0 2 1"),
        "endsolid b\n",
    ]
    .concat();
    let cases = [
        (
            "m.obj",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\nv 0 0 2\nv 1 0 2\nv 1 1 2\nf -3 -2 -1\n",
            3,
            1.5,
            [1.0, 1.0, 2.0],
        ),
        ("m.obj", "v 0 0 0\nv 2 0 \\\n0\nv 2 2 0\nv 0 2 0\nf 1 2 \\\n 3 4\n", 2, 4.0, [2.0, 2.0, 0.0]),
        ("m.obj", "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6\n", 4, 5.0, [3.0, 3.0, 0.0]),
        (
            "m.obj",
            "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n",
            8,
            12.0,
            [4.0, 4.0, 0.0],
        ),
        ("m.ply", ply, 4, 10.324_555_320_336_76, [2.0, 2.0, 3.0]),
        ("m.stl", stl.as_str(), 2, 2.5, [2.0, 2.0, 1.0]),
    ];
    for (name, text, triangles, area, most) in cases {
        let scene = load(name, &folder([(name, text.as_bytes())])).unwrap();
        let meshes = || scene.objects.iter().map(|object| &object.mesh);
        let faces = || meshes().flat_map(|mesh| mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize])));
        let found: f64 = faces().map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum();
        let bounds = faces().flatten().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[a, b], p| [a.min(p), b.max(p)]);
        assert_eq!(faces().count(), triangles, "{text}");
        assert!((found - area).abs() < 1e-12, "{found} is not {area}\n{text}");
        assert_eq!(bounds, [DVec3::ZERO, DVec3::from_array(most)], "{text}");
    }
}

/// A box of triangles, as every program writes it: its diagonals aren't drawn, nor are the borders of its texture.
#[test]
fn an_outline_has_the_creases_of_a_solid_and_nothing_else() {
    let faces = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"];
    let corners = (0..8).map(|i| format!("v {} {} {}\nvt {} 0\n", i >> 2, i >> 1 & 1, i & 1, i % 3));
    let mut text: String = corners.collect();
    for (k, face) in faces.iter().enumerate() {
        let [a, b, c, d] = std::array::from_fn(|i| face.split(' ').nth(i).unwrap());
        let t = k + 1;
        let _ = write!(text, "f {a}/{t} {b}/{t} {c}/{t}\nf {a}/8 {c}/7 {d}/8\n");
    }
    for texture in [None, Some(TextureSource::Chequer)] {
        let mut spec = spec("m.obj");
        let files = folder([("m.obj", text.as_bytes())]);
        spec.objects[0].texture = texture;
        assert!(only(&load_spec(&spec, &files).unwrap()).outline.is_none());
        spec.objects[0].outline = true;
        spec.objects.push(ObjectSpec::new("ours", Shape::Cylinder));
        let scene = load_spec(&spec, &files).unwrap();
        let solid = &scene.objects[0];
        assert_eq!(solid.outline, scene.objects[1].outline);
        assert_eq!(solid.mesh.adjacency.edges.iter().filter(|edge| edge.crease).count(), 12);
    }
}
