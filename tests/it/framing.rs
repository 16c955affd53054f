//! `--op aim=OBJECT` and `--op fit=OBJECT`.

use serde_json::{Value, json};

use crate::common::program::Bench;

const FIGURE: &str = r#"[camera]
position = [1, 2, 9]
focal_point = [1, 2, 0]
view_angle = "40°"
near = 0.5
far = 30

[[scene.objects]]
name = "box"
shape = "box"
translate = [4, 0, -3]
rotate = [0, 30, 0]

[[scene.objects]]
name = "post"
shape = "cylinder"
parent = "box"
translate = [0, 3, 0]

[[scene.objects]]
name = "behind"
shape = "sphere"
translate = [0, 0, 40]
"#;

fn inspected(bench: &Bench, ops: &[&str], points: &[[f64; 3]]) -> Value {
    let mut typed = vec!["inspect".to_owned(), "f.toml".to_owned()];
    typed.extend(ops.iter().map(|op| format!("--op={op}")));
    typed.extend(points.iter().map(|[x, y, z]| format!("--point={x},{y},{z}")));
    let arguments: Vec<&str> = typed.iter().map(String::as_str).collect();
    bench.run(&arguments).json()
}

#[test]
fn aim_moves_the_focal_point_to_the_middle_and_keeps_the_distance() {
    let bench = Bench::new("aim");
    bench.write("f.toml", FIGURE);
    let plain = inspected(&bench, &[], &[]);
    let aimed = inspected(&bench, &["aim=behind"], &[]);
    assert_eq!(aimed["camera"]["focal_point"], json!([0.0, 0.0, 40.0]));
    assert_eq!((&aimed["distance"], &aimed["basis"]), (&plain["distance"], &plain["basis"]));
    // In the order given, also between other operations.
    let after = inspected(&bench, &["azimuth=30", "aim=behind", "zoom=2"], &[]);
    assert_eq!(after["camera"]["focal_point"], json!([0.0, 0.0, 40.0]));
    assert_ne!(after["basis"], plain["basis"]);
}

#[test]
fn fit_shows_objects_whole_with_what_is_below_them() {
    let bench = Bench::new("fit");
    bench.write("f.toml", FIGURE);
    // The top of the post, which is a child of the box; the sphere behind the camera.
    let top = [4.0, 4.0, -3.0];
    for (op, points, stays) in [
        ("fit=box", vec![top], true),
        ("fit=behind", vec![[0.0, 1.0, 40.0]], false),
        ("fit=all", vec![top, [0.0, 1.0, 40.0]], false),
    ] {
        let fitted = inspected(&bench, &[op], &points);
        for point in fitted["points"].as_array().expect("points") {
            let ndc = point["ndc"].as_array().expect("in front of the eye");
            assert!(ndc.iter().all(|x| x.as_f64().is_some_and(|x| x.abs() <= 1.0)), "{op}: {ndc:?}");
        }
        assert_eq!(fitted["camera"]["position"] == json!([1.0, 2.0, 9.0]), stays, "{op}");
    }
    let image = bench.run(&["render", "f.toml", "--op", "fit=all", "-o", "o.png"]);
    image.done();
    let why = bench.run(&["inspect", "f.toml", "--op", "fit=roof"]);
    let why = why.refused(2);
    assert!(why.contains("roof") && why.contains("post") && why.contains("fit"), "{why}");
}
