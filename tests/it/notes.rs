//! The notes: every symbol, operation, equation, step and stage has one, the same in both languages, and its links lead
//! somewhere.

use std::collections::BTreeSet;

use camera_lab::camera::{Freedom, OPERATIONS, Step};
use camera_lab::explain::{Axis, Component, Matrix, Symbol};
use camera_lab::pipeline::Stage;
use camera_lab_words::Lang;
use camera_lab_words::why::notes::{
    Note, Piece, note, notes, of_equation, of_matrix, of_operation, of_stage, of_step, of_symbol, plain,
};

const BOTH: [Lang; 2] = [Lang::En, Lang::PtBr];

fn said(note: &Note) -> String {
    let pieces = note.paragraphs.iter().chain(&note.errata).flatten();
    pieces
        .map(|piece| match piece {
            Piece::Words(words) => (*words).to_owned(),
            Piece::Mathematics(latex) => plain(latex),
        })
        .collect()
}

#[test]
fn both_languages_have_the_same_notes_in_words_of_their_own() {
    let [english, portuguese] = BOTH.map(notes);
    assert_eq!(english.len(), portuguese.len());
    let mut ids = BTreeSet::new();
    for (en, pt) in english.iter().zip(portuguese) {
        assert_eq!(en.id, pt.id);
        assert!(ids.insert(en.id), "{} stands twice", en.id);
        // Equations, places and links need no translation. Both have as many errata.
        assert_eq!((&en.equations, en.source, &en.links), (&pt.equations, pt.source, &pt.links), "{}", en.id);
        assert_eq!(en.errata.len(), pt.errata.len(), "{}", en.id);
        for note in [en, pt] {
            assert!(!note.title.is_empty() && !note.group.is_empty() && !note.paragraphs.is_empty(), "{}", note.id);
            let length = said(note).chars().count();
            assert!((20..620).contains(&length), "{}: {length} characters", note.id);
            assert!(!note.links.is_empty(), "{}", note.id);
        }
        assert_ne!(said(en), said(pt), "{}", en.id);
    }
}

#[test]
fn links_lead_to_other_notes_and_every_note_can_be_reached() {
    let linked: BTreeSet<&str> = notes(Lang::En).iter().flat_map(|note| note.links.clone()).collect();
    for here in notes(Lang::En) {
        for link in &here.links {
            assert!(note(Lang::En, link).is_some(), "{} → {link}", here.id);
            assert_ne!(*link, here.id);
        }
    }
    assert!(linked.len() > 90, "{}", linked.len());
}

fn symbols() -> Vec<Symbol> {
    let vectors: [fn(Component) -> Symbol; 12] = [
        |c| Symbol::Axis(Axis::U, c),
        |c| Symbol::Axis(Axis::V, c),
        |c| Symbol::Axis(Axis::N, c),
        Symbol::Position,
        Symbol::FocalPoint,
        Symbol::ViewUp,
        Symbol::Translate,
        Symbol::Rotate,
        Symbol::Scale,
        Symbol::Local,
        Symbol::World,
        Symbol::View,
    ];
    let with_w: [fn(Component) -> Symbol; 2] = [Symbol::Clip, Symbol::Homogeneous];
    let others: [fn(Component) -> Symbol; 4] = [Symbol::Ndc, Symbol::Window, Symbol::Pixel, Symbol::Viewport];
    let mut all: Vec<Symbol> = vectors.iter().chain(&others).flat_map(|of| Component::THREE.map(of)).collect();
    all.extend(with_w.iter().flat_map(|of| Component::FOUR.map(of)));
    all.extend([Symbol::Distance, Symbol::Near, Symbol::Far, Symbol::Left, Symbol::Right, Symbol::Bottom, Symbol::Top]);
    all.extend([Symbol::Width, Symbol::Height, Symbol::Aspect, Symbol::ViewAngle]);
    all.extend([Symbol::ImageWidth, Symbol::ImageHeight, Symbol::ViewportX, Symbol::ViewportY]);
    all.extend([Symbol::ViewportWidth, Symbol::ViewportHeight, Symbol::DepthNear, Symbol::DepthFar]);
    all.extend(Matrix::NAMED.iter().map(|(_, matrix)| Symbol::Entry(*matrix, 0, 0)));
    all
}

#[test]
fn every_symbol_operation_step_stage_and_equation_has_a_note_of_its_kind() {
    let has = |id: &str, group: &[&str]| {
        let found = note(Lang::En, id).unwrap_or_else(|| panic!("no note {id}"));
        assert!(group.contains(&found.group), "{id} is among {}", found.group);
    };
    let of_symbols = ["Camera", "Axes and spaces", "Points", "Image and viewport", "Objects", "Matrices"];
    for symbol in symbols() {
        has(of_symbol(symbol), &of_symbols);
    }
    for (_, matrix) in Matrix::NAMED {
        has(of_matrix(*matrix), &["Matrices"]);
    }
    let operations: BTreeSet<_> = OPERATIONS.iter().map(|operation| of_operation(operation.freedom)).collect();
    assert_eq!(operations.len(), 8);
    assert_eq!(of_operation(Freedom::PanU), of_operation(Freedom::PanV));
    for id in operations {
        has(id, &["Operations"]);
    }
    let stages: BTreeSet<_> = Stage::ALL.map(of_stage).into_iter().collect();
    assert_eq!(stages.len(), Stage::ALL.len());
    for stage in Stage::ALL {
        has(of_stage(stage), &["Stages of the pipeline"]);
        assert_eq!(of_stage(stage), format!("stage-{}", stage.name()));
    }
    for step in [Step::ToEye, Step::Turn, Step::TurnLeftHanded, Step::ClipRows, Step::Divide, Step::Box, Step::Centre]
        .into_iter()
        .chain([Step::Scale, Step::Pers, Step::XyScale, Step::UnitSlope, Step::UnitDepth, Step::CanonicalBox])
        .chain([Step::NearToOrigin, Step::ScaleOrt])
    {
        has(of_step(step), &["Steps to the canonical volume"]);
    }
    for number in 1..=25 {
        let id = format!("5.{number}");
        has(&id, &["Equations of [0]"]);
        let found = note(Lang::En, &id).unwrap_or_else(|| panic!("{id}"));
        assert!(found.title.starts_with(&format!("({id}) ")) && !found.equations.is_empty(), "{id}");
        assert_eq!(of_equation(&format!("({id}), p − C")), Some(found.id));
    }
    assert_eq!((of_equation("§5.3.1"), of_equation("")), (None, None));
}

#[test]
fn notes_have_their_errata_beside_them() {
    let told = |lang, id: &str, words: &[&str]| {
        let note = note(lang, id).unwrap_or_else(|| panic!("{id}"));
        let errata: String = note.errata.iter().flatten().map(|piece| format!("{piece:?}")).collect();
        for word in words {
            assert!(errata.contains(word), "{id}: {errata}");
        }
    };
    for lang in BOTH {
        told(lang, "5.11", &["2n/(r - l)", "2F/(r - l)"]);
        told(lang, "B", &["-F", "-B"]);
        told(lang, "5.15", &["0 0 0 0", "0 0 0 1"]);
        told(lang, "5.16", &["0 0 0 0", "0 0 0 1"]);
        told(lang, "yaw", &[r"\\mathbf{v}", r"\\mathbf{u}"]);
        told(lang, "pitch", &[r"\\mathbf{v}", r"\\mathbf{u}"]);
        let tuple = if lang == Lang::En { "(3/5, 4/5, 0)" } else { "(3/5; 4/5; 0)" };
        told(lang, "VUP", &[tuple, "VPN"]);
        told(lang, "elevation", &["[0]", "C"]);
        told(lang, "azimuth", &["[0]", "DOP"]);
        told(lang, "dolly", &["[0]"]);
        told(lang, "pan", &["[0]"]);
        told(lang, "step-scale-ort", &["1/(B - F)"]);
        told(lang, "5.8", &["z_{vp} - z"]);
        told(lang, "stage-hidden-surfaces", &["[2]", "1"]);
        told(lang, "theta", &["5.2"]);
        told(lang, "step-pers", &["[1]"]);
        told(lang, "u", &["[3]"]);
        told(lang, "n", &["[2]", "z_e"]);
    }
}

#[test]
fn notes_are_found_by_words_symbols_and_numbers_without_accents_and_capitals() {
    let found = |lang, words: &str| -> Vec<&str> {
        notes(lang).iter().filter(|note| note.says(words)).map(|note| note.id).collect()
    };
    assert_eq!(found(Lang::PtBr, "").len(), notes(Lang::PtBr).len());
    assert_eq!(found(Lang::PtBr, "rejeicao trivial"), ["stage-cull-objects"]);
    assert_eq!(found(Lang::PtBr, "REJEIÇÃO"), ["stage-cull-objects"]);
    assert_eq!(found(Lang::En, "(1-17)"), ["step-canonical-box"]);
    assert!(found(Lang::En, "x_n").contains(&"ndc"));
    assert!(found(Lang::En, "θ").contains(&"5.5"));
    assert!(found(Lang::En, "behind eye").contains(&"w"), "words need not stand together");
    assert!(found(Lang::En, "xyzzy").is_empty());
    assert_eq!(plain(r"\frac{2F}{r - l} x_c"), "2F/(r − l) x_c");
    assert_eq!(plain(r"\mathbf{DOP} = \frac{\mathrm{PF} - C}{D}"), "DOP = (PF − C)/D");
}
