//! The table of conventions: each row is reached by reading, writing, the window, `--axes`, `--ndc` and the guides.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Axes, Camera, MatrixKind, Ndc, Order, Parameters, Program, Stated, read_cameras, recognise};
use camera_lab::explain::code::CodeTarget;
use camera_lab_words::Lang;
use camera_lab_words::why::conventions::{axes_row, axes_table};
use glam::{DMat4, DVec3};

use crate::common::program::Bench;

fn camera() -> Camera {
    Camera::new(&Parameters { position: DVec3::new(3.0, 4.0, 5.0), ..Parameters::default() }).unwrap()
}

/// The pose as the program writes its numbers.
fn written(program: &Program, m: DMat4) -> String {
    let numbers = match program.order {
        Order::Rows => m.transpose().to_cols_array().to_vec(),
        Order::Columns => m.to_cols_array().to_vec(),
        Order::WxyzThenT => {
            let (_, q, t) = m.to_scale_rotation_translation();
            vec![q.w, q.x, q.y, q.z, t.x, t.y, t.z]
        }
        other => panic!("{other:?} isn't written yet"),
    };
    format!("{numbers:?}")
}

#[test]
fn each_program_is_read_in_its_axes_and_its_order() {
    let camera = camera();
    for program in &Program::ALL {
        let text = written(program, program.axes.view_from_world(&camera));
        let pasted = &read_cameras(text.as_bytes()).unwrap()[0];
        // Nothing is stated, so the row is found among those that are tried.
        let found = recognise(pasted, &Stated::default(), camera.parameters()).unwrap();
        let is_it = |c: &camera_lab::camera::Candidate| {
            c.reading.kind == MatrixKind::View
                && c.order == program.order
                && c.found.parameters.position.abs_diff_eq(camera.position(), 1e-9)
        };
        assert!(found.readings.iter().any(is_it), "{}: {:#?}", program.name, found.readings);
    }
}

#[test]
fn each_program_is_written_and_listed() {
    let bench = Bench::new("programs");
    bench.write("figure.toml", "");
    for (program, target) in Program::ALL.iter().zip(CodeTarget::ALL) {
        assert_eq!(target.program(), program, "the targets have the order of the table");
        assert!(Axes::ALL.contains(&program.axes), "{}: no row of axes", program.name);
        let code = bench.run(&["code", "figure.toml", "--for", program.word]);
        assert_eq!(code.status, Some(0), "{}: {}", program.word, code.err);
        if let Some(ndc) = program.ndc {
            assert!(Ndc::ALL.contains(&ndc));
            let numbers = bench.run(&["inspect", "figure.toml", "--ndc", ndc.name()]);
            assert_eq!(numbers.status, Some(0), "{}: {}", ndc.name(), numbers.err);
        }
    }
}

#[test]
fn each_row_of_axes_is_in_the_window_the_help_and_the_guides() {
    let help = String::from_utf8(Bench::new("axes").run(&["matrix", "--help"]).out).unwrap();
    for (lang, guide) in [
        (Lang::En, include_str!("../../docs/cameras.en.md")),
        (Lang::PtBr, include_str!("../../docs/cameras.pt-BR.md")),
    ] {
        let hint = axes_table(lang, |axes| axes.title);
        for axes in Axes::ALL {
            let row = axes_row(lang, axes);
            assert!(hint.contains(&format!("{}: {row}", axes.title)), "{lang:?} {}", axes.name);
            assert!(guide.contains(&format!("| `{}`", axes.name)), "{lang:?}: no row of {}", axes.name);
        }
    }
    for axes in Axes::ALL {
        assert!(help.contains(axes.name), "--axes {}", axes.name);
    }
}
