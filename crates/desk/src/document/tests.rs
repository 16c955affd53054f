#![expect(clippy::unwrap_used, reason = "tests")]

use super::*;
use crate::geometry::Angle;
use crate::scene::Preset;

fn azimuth(degrees: f64) -> Operation {
    Operation::Azimuth(Angle::from_degrees(degrees))
}

#[test]
fn undo_covers_chosen_options_and_not_hover_or_playback() {
    use glam::DVec3;

    use crate::figure::{ShownProbe, ShownStep};
    use crate::stage::Stage;

    let mut document = Document::new(Figure::default(), None).unwrap();
    document.show_mut().stage = Some(Stage::Clip);
    document.commit();
    assert!(document.can_undo(true) && !document.is_changed(), "a step, but nothing to save");
    document.show_mut().probe = Some(ShownProbe::World(DVec3::ONE));
    let step = ShownStep { way: crate::camera::Decomposition::Notes, at: Some(1.5) };
    document.show_mut().step = Some(step);
    document.commit();
    document.undo(true);
    let show = &document.figure().show;
    assert_eq!((show.stage, show.probe, show.step), (None, Some(ShownProbe::World(DVec3::ONE)), Some(step)));
    assert!(!document.can_undo(true), "pointing and playing are no steps");
    document.undo(false);
    assert_eq!(document.figure().show.stage, Some(Stage::Clip));
}

#[test]
fn the_figure_that_another_one_has_replaced_comes_back_with_all_that_it_explained() {
    let mut document = Document::new(Figure::default(), None).unwrap();
    document.show_mut().painted = Some(0.25);
    let mut other = Figure::of_preset(Preset::Cube);
    other.show.measure = vec![crate::figure::Measured::Dimension(crate::figure::Measure::Near)];
    document.replace(other.clone()).unwrap();
    assert_eq!(document.figure().show, other.show);
    document.undo(true);
    assert_eq!(document.figure().show.painted, Some(0.25));
    document.undo(false);
    assert_eq!(document.figure().show, other.show);
}

#[test]
fn steps_all_the_way_round_give_the_camera_back_bit_for_bit() {
    for (steps, degrees) in [(12, 30.0), (24, 15.0)] {
        for convention in [Convention::RightHand, Convention::Vtk] {
            let mut document = Document::new(Figure::default(), None).unwrap();
            let before = *document.camera().parameters();
            for operation in [azimuth(degrees), Operation::Elevation(Angle::from_degrees(degrees))] {
                for _ in 0..steps {
                    document.operate(operation, convention).unwrap();
                }
                assert_eq!(*document.camera().parameters(), before, "{steps} × {operation:?}");
                assert_eq!(*document.draft(), before);
            }
        }
    }
}

#[test]
fn a_scene_is_changed_until_it_is_the_saved_one_again_however_that_came() {
    let mut document = Document::new(Figure::default(), None).unwrap();
    let (first, saved) = (document.revision(), document.figure().scene.clone());
    let light = crate::scene::Light::point(DVec3::ONE);
    document.edit(|figure| figure.scene.lights.push(light));
    document.commit();
    assert!(document.is_changed() && document.revision() != first);
    document.edit(|figure| figure.scene = saved);
    assert!(!document.is_changed());
    document.undo(true);
    assert!(document.is_changed(), "the light is back");
    document.undo(true);
    assert!(!document.is_changed() && document.revision() == first);
    document.undo(false);
    assert!(document.is_changed());
    let saved = document.figure().clone();
    document.mark_saved(PathBuf::from("/a.toml"), String::new(), saved, &Renamed::new());
    assert!(!document.is_changed());
    document.replace(Figure::default()).unwrap();
    assert!(document.is_changed());
}

#[test]
fn every_change_makes_another_document_and_how_it_is_seen_does_not() {
    let mut document = Document::new(Figure::default(), None).unwrap();
    let other = Figure::of_preset(Preset::Empty);
    let changes: [&dyn Fn(&mut Document); 9] = [
        &|document| document.set_parameters(Parameters { aspect: 2.0, ..*document.draft() }),
        &|document| document.set_parameters(Parameters { near: 1e9, ..*document.draft() }),
        &|document| document.edit(|figure| figure.image.width = 7),
        &|document| document.undo(true),
        &|document| document.undo(false),
        &|document| document.replace(other.clone()).unwrap(),
        &|document| {
            let saved = document.figure().clone();
            document.mark_saved(PathBuf::from("/a.toml"), "a".to_owned(), saved, &Renamed::new());
        },
        &|document| document.operate(azimuth(1.0), Convention::RightHand).unwrap(),
        &|document| document.allow_files(),
    ];
    for (i, change) in changes.into_iter().enumerate() {
        let before = document.version();
        change(&mut document);
        assert_ne!(document.version(), before, "change {i}");
        document.commit();
    }
    let version = document.version();
    *document.observers_mut() = Observers::default();
    document.show_mut().painted = Some(0.5);
    assert_eq!(document.version(), version);
}

#[test]
fn undo_and_redo_keep_the_cameras_rounding_errors() {
    let mut document = Document::new(Figure::default(), None).unwrap();
    let before = document.camera().clone();
    let mut cameras = vec![before.clone()];
    for _ in 0..5 {
        document.operate(azimuth(30.0), Convention::RightHand).unwrap();
        document.commit();
        cameras.push(document.camera().clone());
    }
    for camera in cameras.iter().rev().skip(1) {
        document.undo(true);
        assert_eq!(document.camera(), camera);
    }
    for camera in cameras.iter().skip(1) {
        document.undo(false);
        assert_eq!(document.camera(), camera);
    }
    for _ in 5..12 {
        document.operate(azimuth(30.0), Convention::RightHand).unwrap();
    }
    assert_eq!(document.camera().parameters(), before.parameters());
}

#[test]
fn an_impossible_camera_stays_as_typed_and_takes_no_operation() {
    let mut document = Document::new(Figure::default(), None).unwrap();
    document.set_parameters(Parameters { near: 1e9, ..*document.draft() });
    let typed = *document.draft();
    assert_eq!(document.operate(azimuth(5.0), Convention::RightHand).as_ref().err(), document.problem());
    assert_eq!(*document.draft(), typed);
    document.reset();
    assert!(document.operate(Operation::Dolly(0.0), Convention::RightHand).is_err());
}

#[test]
fn kept_operations_go_when_the_camera_changes_otherwise() {
    let mut document = Document::new(Figure::default(), None).unwrap();
    let turned =
        |document: &Document, degrees| azimuth(degrees).apply(document.camera(), Convention::default()).unwrap();
    document.set_camera(turned(&document, 30.0));
    document.commit();
    document.show_mut().operations = vec![azimuth(30.0)];
    document.commit();
    document.edit(|figure| figure.style.antialias = camera_lab_engine::appearance::Samples::Sixteen);
    document.commit();
    assert_eq!(document.figure().show.operations.len(), 1, "it still leads to the camera");
    document.set_camera(turned(&document, 5.0));
    document.commit();
    assert!(document.figure().show.operations.is_empty());
}
