//! Wrong answers made by hand from the statements, whose reason used to be false or missing.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::exercises::Fact;
use camera_lab_words::Lang;
use glam::DVec3;

use super::exercise_verdicts::{exercise, right, square, text, verdict};

fn vector(v: DVec3) -> String {
    format!("[{:.9}, {:.9}, {:.9}]", v.x, v.y, v.z)
}

/// In `[3]` **n** goes into the scene and **u** = **n** × **v**: the reasons must not send anybody to the notes'
/// right-handed convention.
#[test]
fn the_left_handed_system_has_its_own_reasons() {
    for seed in 0..20 {
        let n = DVec3::from_slice(&right("left-handed", seed, "n"));
        let u = DVec3::from_slice(&right("left-handed", seed, "u"));
        assert_eq!(verdict("left-handed", seed, "n", vector(-n)), "n-reversed");
        assert!(verdict("left-handed", seed, "u", vector(-u)).contains("u-reversed"));
        for (name, wrong) in [("n", -n), ("u", -u)] {
            let told = text("left-handed", seed, name, &vector(wrong), Lang::En);
            assert!(!told.contains("from PF to C") && !told.contains("VUP"), "{told}");
        }
    }
}

/// The zoom's value under the dolly is a zoom, and the other way round.
#[test]
fn a_zoom_for_a_dolly_is_called_a_zoom() {
    for seed in 0..20 {
        let [zoomed, dollied] =
            ["zoomed_behind", "dollied_behind"].map(|name| format!("{:.9}", right("zoom-or-dolly", seed, name)[0]));
        for (lang, zoom, dolly) in [(Lang::En, "a zoom", "a dolly"), (Lang::PtBr, "um zoom", "um travelling")] {
            let said = text("zoom-or-dolly", seed, "dollied_behind", &zoomed, lang);
            // The zoom divides all distances, as if the dolly did.
            assert!(said.contains(zoom) && said.contains("D + e"), "{seed}: {said}");
            let said = text("zoom-or-dolly", seed, "zoomed_behind", &dollied, lang);
            assert!(said.contains(dolly) && !said.contains(zoom), "{seed}: {said}");
        }
    }
}

#[test]
fn the_formula_of_the_lesson_is_named_as_an_approximation() {
    for seed in 0..20 {
        let exercise = exercise("depth-resolution", seed);
        let fact = |name: &str| {
            let fact = exercise.facts.iter().find(|(known, _)| *known == name);
            let Fact::Number(value) = fact.unwrap().1 else { panic!("{name}") };
            value
        };
        let [f, b, d, bits] = ["F", "B", "d", "bits"].map(fact);
        let exact = d * d * (b - f) / (b * f * (bits.exp2() - 1.0));
        assert!((right("depth-resolution", seed, "step")[0] / exact - 1.0).abs() < 1e-9);
        let told = verdict("depth-resolution", seed, "step", format!("{:.9}", d * d / (f * bits.exp2())));
        assert_eq!(told, "approximation", "{seed}");
    }
}

#[test]
fn mistakes_in_projection_matrices_are_kept_apart() {
    for seed in 0..20 {
        let m = right("parallel-matrix", seed, "Mp");
        let camera = exercise("parallel-matrix", seed).subject.figure.camera;
        let (near, far) = (camera.near, camera.far);
        let mut scaled = m.clone();
        (scaled[0], scaled[5]) = (m[0] * near, m[5] * near);
        assert_eq!(verdict("parallel-matrix", seed, "Mp", square(scaled)), "projections-exchanged");
        let mut exchanged = m.clone();
        (exchanged[10], exchanged[11]) = (-2.0 / (near - far), -(near + far) / (near - far));
        let told = verdict("parallel-matrix", seed, "Mp", square(exchanged));
        assert!(told.contains("near-far-as-coordinates") && told.contains("z-sign"), "{told}");

        let m = right("perspective-matrix", seed, "Mp");
        let camera = exercise("perspective-matrix", seed).subject.figure.camera;
        let tangent = (camera.view_angle.to_radians() / 2.0).tan();
        for x in [tangent / camera.aspect, tangent * camera.aspect] {
            let mut inverted = m.clone();
            (inverted[0], inverted[5]) = (x, tangent);
            assert_eq!(verdict("perspective-matrix", seed, "Mp", square(inverted)), "inverse", "{seed}");
        }
    }
}

#[test]
fn other_reasons_that_were_false() {
    // 0 and 1 exchanged.
    for seed in 0..20 {
        for name in ["A", "B"] {
            let bits: Vec<String> = right("outcodes", seed, name).iter().map(|bit| format!("{}", 1.0 - bit)).collect();
            let told = verdict("outcodes", seed, name, format!("[{}]", bits.join(", ")));
            assert!(told.split('|').any(|code| code == "inverse"), "{seed} {name}: {told}");
        }
    }
    // Another corner of the window of 5.2.
    let basis = exercise("0-5.2", 0).subject.camera().unwrap().basis();
    let (u, v, n) = (basis.u, basis.v, basis.n);
    let c = DVec3::new(7.0, 0.0, 0.0);
    let corner = DVec3::from_slice(&right("0-5.2", 0, "corner"));
    let [x, y] = [u, v].map(|axis| (corner - c).dot(axis));
    assert!(((corner - c).dot(n) + 5.0).abs() < 1e-9);
    for (x, y) in [(x, -y), (-x, y), (-x, -y)] {
        let said = text("0-5.2", 0, "corner", &vector(c + u * x + v * y - n * 5.0), Lang::En);
        assert!(said.contains("another corner"), "{said}");
    }
    // Too few digits change the length of a direction.
    let direction = right("ray", 5, "direction");
    let short: Vec<String> = direction.iter().map(|x| format!("{x:.2}")).collect();
    let told = verdict("ray", 5, "direction", format!("[{}]", short.join(", ")));
    assert!(!told.contains("not-normalised"), "{told}");
}
