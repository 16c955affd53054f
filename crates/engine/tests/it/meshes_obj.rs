//! OBJ files: their objects, and that broken ones are refused with the line.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::appearance::Rgba;
use camera_lab_engine::limits::MAX_OBJECTS;
use camera_lab_engine::scene::{MeshError, MeshFault, MeshNotice, ObjectSpec, SceneError, Shape, Wanted, no_files};
use glam::DVec3;

use super::meshes::{CUBE, area, color, folder, load, load_spec, obj, only, spec};

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
fn materials_that_alternate_make_one_part_each_in_the_order_of_the_file() {
    let mut text = "mtllib a.mtl\no a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n".to_owned();
    for _ in 0..100 {
        text.push_str("usemtl red\nf 1 2 3\nusemtl glass\nf 1 2 4\nf 2 3 4\n");
    }
    text.push_str("o b\nusemtl red\nf 1 2 3\no a\nf 1 3 4\n");
    let mtl = b"newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 0 1\n";
    let scene = load("m.obj", &folder([("m.obj", text.as_bytes()), ("a.mtl", mtl)])).unwrap();
    let found: Vec<_> = scene.objects.iter().map(|o| (o.name.as_str(), o.mesh.triangles.len())).collect();
    assert_eq!(found, [("m/a", 101), ("m/a", 200), ("m/b", 1)]);
    // Inside a part, the faces stand as they do in the file.
    let last = scene.objects[0].mesh.triangles[100].map(|i| scene.objects[0].mesh.positions[i as usize]);
    assert_eq!(last, [DVec3::ZERO, DVec3::Y, DVec3::Z]);
}

/// Names may hold a slash, so the name does not decide which object a part belongs to.
#[test]
fn a_part_keeps_its_object_even_if_another_object_has_its_name() {
    let text = b"o block\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no lid\nf 1 3 2\n";
    let mut both = spec("m.obj");
    both.objects[0].name = "engine".to_owned();
    both.objects.push(ObjectSpec::new("engine/block", Shape::Box));
    let scene = load_spec(&both, &folder([("m.obj", text)])).unwrap();
    let found: Vec<_> = scene.objects.iter().map(|object| (object.name.as_str(), object.owner())).collect();
    assert_eq!(
        found,
        [("engine/block", "engine"), ("engine/lid", "engine"), ("engine/block", "engine/block")],
        "a part, a part, and an object of its own"
    );
    // A mesh of one part is its object.
    let scene = load("m.obj", &folder([("m.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")])).unwrap();
    assert_eq!(only(&scene).owner(), only(&scene).name);
}

#[test]
fn a_file_that_begins_an_object_with_each_face_is_refused() {
    let file = |count: usize| {
        let faces: String = (0..count).map(|k| format!("o {k}\nf 1 2 3\n")).collect();
        obj(&format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{faces}"))
    };
    assert_eq!(file(1000).unwrap().objects.len(), 1000);
    assert_eq!(file(MAX_OBJECTS + 2), Err(MeshError::TooManyObjects));
    // Many objects of one mesh add up.
    let faces: String = (0..1000).map(|k| format!("o {k}\nf 1 2 3\n")).collect();
    let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{faces}");
    let mut many = spec("m.obj");
    many.objects =
        (0..=MAX_OBJECTS / 1000).map(|k| ObjectSpec { name: format!("n{k}"), ..many.objects[0].clone() }).collect();
    assert_eq!(load_spec(&many, &folder([("m.obj", text.as_bytes())])).err(), Some(SceneError::TooManyObjects));
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

    // Without the library the shape is there all the same. A colour of the figure wins.
    assert_eq!(load("m.obj", &folder([("m.obj", text.as_bytes())])).unwrap().objects.len(), 3);
    let mut own = spec("d/m.obj");
    own.objects[0].color = Some(Rgba::rgb(1, 2, 3));
    let scene = load_spec(&own, &folder([("d/m.obj", text.as_bytes()), ("d/a.mtl", mtl.as_bytes())])).unwrap();
    assert!(scene.objects.iter().all(|o| color(o) == Rgba::rgb(1, 2, 3)));
}

#[test]
fn oddities_of_real_files_are_read() {
    // Windows ends, tabs, a continued line, a comment behind values, Latin-1, vertex colours, a weight, lines and
    // points.
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
        Err(MeshError::Line { line, fault }) => (line, fault),
        other => panic!("{other:?}"),
    };
    let points = "v 0 0 0\nv 1 0 0\n\nv 0 1 0\n";
    let number = |s: &str| MeshFault::Number { found: s.to_owned() };
    assert_eq!(fault("v 0 0 0\nv 1 x 0\n"), (2, number("x")));
    assert_eq!(fault("v 0 0 0\n\n# c\nv 1 nan 0\n"), (4, number("nan")));
    assert_eq!(fault("v 0 0 1e999\n"), (1, number("1e999")));
    assert_eq!(fault("v 0 0 0 0\n"), (1, number("0")));
    assert_eq!(fault("v 1 0 0 1e-320\n"), (1, number("1e-320")), "divided by it, the point is nowhere");
    assert_eq!(fault("v 0 0\n"), (1, MeshFault::Coordinates { found: 2 }));
    assert_eq!(fault(&format!("{points}f 1 2 3.5\n")), (5, MeshFault::Corner { found: "3.5".into() }));
    assert_eq!(fault(&format!("{points}f 1 2 3/1/1/1\n")), (5, MeshFault::Corner { found: "3/1/1/1".into() }));
    assert_eq!(fault(&format!("{points}f 1 2 3/x\n")), (5, MeshFault::Corner { found: "3/x".into() }));
    assert_eq!(fault(&format!("{points}f 1 2 //3\n")), (5, MeshFault::Corner { found: "//3".into() }));
    let index = |found: &str| MeshFault::Index { found: found.to_owned(), points: 3 };
    assert_eq!(fault(&format!("{points}f 1 2 0\n")), (5, index("0")));
    assert_eq!(fault(&format!("{points}f 1 2 -4\nv 1 1 1\n")), (5, MeshFault::Index { found: "-4".into(), points: 3 }));
    assert_eq!(fault(&format!("{points}f 1 2 9\nf 1 2 3\no x\n")), (5, index("9")));
    assert_eq!(fault(&format!("{points}f 1 2 99999999999999999999\n")).0, 5);

    assert_eq!(obj(points), Err(MeshError::Empty));
    assert_eq!(obj(""), Err(MeshError::Empty));
    assert_eq!(load("m.dxf", &folder([("m.dxf", b"solid")])), Err(MeshError::Format));
    assert_eq!(
        load("gone.obj", &folder([])),
        Err(MeshError::Unreadable(Box::new(no_files(Wanted { path: "gone.obj", named_by: None }).unwrap_err())))
    );
}

/// Lines of exporters that readers take: the surface is read, and a notice names the rest.
#[test]
fn files_of_other_programs_are_read_with_a_notice() {
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
        // Those of its triangle, if the file does not give all.
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
fn a_fully_transparent_material_becomes_opaque_and_others_stay() {
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
    // Also if another object lies between.
    assert_eq!(obj("o a\nf 1 2 3\no b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\n").unwrap().objects.len(), 2);
}
