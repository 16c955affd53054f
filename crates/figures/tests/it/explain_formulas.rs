//! Every entry of every matrix has a formula whose numbers give the entry. Every symbol has a definition that gives the
//! symbol, and a point's trace adds up, forward and back.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{
    Camera, Decomposition, ImageSize, Ndc, NotProjectable, Parameters, Projection, ViewWindow, Viewport,
};
use camera_lab_engine::expression::{self, Dimension};
use camera_lab_engine::numbers::{DecimalMark, EXACT_DIGITS};
use camera_lab_figures::explain::{
    Axis, Component, EntryFormula, Formula, Matrix, MatrixFormula, Notation, Numbers, Placement, Setting, Step, Style,
    Symbol, Writer, back, definition, entry_product, factor_entries, forward, leaves, written,
};
use glam::{DMat4, DVec3, DVec4};
use proptest::prelude::*;

use crate::common::any_camera::{any_camera, plain_camera};
use crate::common::camera::camera;

const IMAGE: ImageSize = ImageSize { width: 1024, height: 768 };

fn turned() -> Placement {
    let (translate, rotate, scale) =
        (DVec3::new(1.0, -2.0, 0.5), DVec3::new(30.0, -45.0, 70.0), DVec3::new(2.0, 0.5, -1.5));
    let parent = DMat4::from_translation(DVec3::new(0.0, 3.0, 1.0)) * DMat4::from_rotation_y(0.4);
    let [x, y, z] = rotate.to_array().map(f64::to_radians);
    let turn = DMat4::from_rotation_z(z) * DMat4::from_rotation_y(y) * DMat4::from_rotation_x(x);
    let own = DMat4::from_translation(translate) * turn * DMat4::from_scale(scale);
    Placement { translate, rotate, scale, parent: Some(parent), world_from_object: parent * own }
}

fn viewport() -> Viewport {
    Viewport { x: 10, y: -20, width: 640, height: 480, depth_near: 0.25, depth_far: 0.875 }
}

/// A number read by the program's own reader from the formula with its numbers put in.
fn evaluated(text: &str) -> f64 {
    let typed = text.replace('·', "*").replace('−', "-").replace('²', "^2");
    expression::evaluate(&typed, Dimension::Number).unwrap_or_else(|error| panic!("{typed}: {error}"))
}

fn assert_every_entry(setting: &Setting<'_>, read_back: bool) {
    // No setting here has a parent.
    let matrices = Matrix::NAMED.iter().map(|(_, matrix)| *matrix);
    for matrix in matrices.filter(|matrix| !matches!(matrix, Matrix::Parent | Matrix::InverseParent)) {
        let formulas = MatrixFormula::new(matrix, setting);
        let numbers = setting.matrix(matrix);
        for row in 0..4 {
            for column in 0..4 {
                let formula = formulas.entry(row, column);
                let (expected, value) = (numbers.row(row)[column], formula.value(setting));
                let slack = 1e-12 * formula.magnitude(setting).max(expected.abs());
                let what = || format!("{} [{row}][{column}] {formula:?}", matrix.text());
                assert!((value - expected).abs() <= slack, "{}: {value} is not {expected}", what());
                if read_back {
                    let numbers = Numbers { setting, digits: EXACT_DIGITS, exact: false };
                    let mark = DecimalMark::Point;
                    let text = Writer { notation: Notation::Text, mark, numbers: Some(numbers) }.write(formula);
                    let again = evaluated(&text);
                    assert!((again - expected).abs() <= slack, "{}: {text} = {again}, not {expected}", what());
                }
            }
        }
    }
}

/// The entry as its symbols and as its numbers.
fn said(camera: &Camera, matrix: Matrix, row: usize, column: usize) -> [String; 3] {
    let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
    let formula = MatrixFormula::new(matrix, &setting).entry(row, column).clone();
    let numbers = Numbers { setting: &setting, digits: 5, exact: true };
    let write = |notation, numbers| Writer { notation, mark: DecimalMark::Point, numbers }.write(&formula);
    [write(Notation::Text, None), write(Notation::Text, Some(numbers)), write(Notation::Latex, None)]
}

#[test]
fn entries_are_written_as_the_notes_write_them() {
    let camera = camera(|p| {
        p.position = DVec3::new(3.0, 4.0, 0.0);
        p.view_angle = 90.0;
        (p.near, p.far, p.aspect) = (1.0, 4.0, 2.0);
    });
    let n_c = said(&camera, Matrix::View, 2, 3);
    assert_eq!(n_c, ["−n · c", "−(0.6·3 + 0.8·4 + 0·0)", r"-\mathbf{n} \cdot \mathbf{c}"].map(str::to_owned));
    let z = said(&camera, Matrix::Projection, 2, 2);
    assert_eq!(z, ["−(B + F)/(B − F)", "−(4 + 1)/(4 − 1)", r"-\frac{B + F}{B - F}"].map(str::to_owned));
    let x = said(&camera, Matrix::Projection, 0, 0);
    assert_eq!(x, ["2F/W", "2·1/4", r"\frac{2 F}{W}"].map(str::to_owned));
    let product = said(&camera, Matrix::ViewProjection, 2, 3);
    assert_eq!(product[0], "((B + F)/(B − F)) (n · c) − 2BF/(B − F)");
}

#[test]
fn the_equation_in_force_is_named() {
    let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    for (projection, window, equation) in [
        (Projection::Perspective, window, "(5.13)"),
        (Projection::Perspective, None, "(5.14)"),
        (Projection::Parallel, window, "(5.15)"),
        (Projection::Parallel, None, "(5.16)"),
    ] {
        let camera = Camera::new(&Parameters { projection, window, ..Parameters::default() }).unwrap();
        let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
        let formula = MatrixFormula::new(Matrix::Projection, &setting);
        assert_eq!((formula.equation, formula.section), (equation, "§5.3.2"));
        let direct3d = Ndc::ALL.into_iter().find(|ndc| ndc.name() == "direct3d").unwrap();
        let other = Setting::new(camera.clip_space(direct3d).unwrap(), IMAGE, None);
        assert_eq!(MatrixFormula::new(Matrix::Projection, &other).equation, "", "the notes have no equation for it");
    }
}

#[test]
fn an_entry_depends_on_the_parameters_that_move_it() {
    let camera = camera(|p| p.position = DVec3::new(3.0, 4.0, 5.0));
    let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
    let on = |matrix, row, column| leaves(MatrixFormula::new(matrix, &setting).entry(row, column), &setting);
    assert_eq!(on(Matrix::Projection, 1, 1), [Symbol::Near, Symbol::ViewAngle]);
    assert_eq!(on(Matrix::Projection, 0, 0), [Symbol::Near, Symbol::Aspect, Symbol::ViewAngle]);
    assert_eq!(on(Matrix::Projection, 2, 3), [Symbol::Near, Symbol::Far]);
    let view = on(Matrix::View, 0, 3);
    assert!(view.contains(&Symbol::ViewUp(Component::Y)) && view.contains(&Symbol::FocalPoint(Component::X)));
    assert!(on(Matrix::View, 2, 0).iter().all(|symbol| !matches!(symbol, Symbol::ViewUp(_))), "n does not know VUP");
    assert_eq!(on(Matrix::View, 3, 3), []);
}

#[test]
fn depths_lead_back() {
    let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    for projection in [Projection::Perspective, Projection::Parallel] {
        let camera = Camera::new(&Parameters { projection, window, ..Parameters::default() }).unwrap();
        let space = camera.notes_clip_space();
        for depth in [0.25, 0.5, 0.8, 0.875] {
            let way = space.way_back(IMAGE, &viewport(), [300, 200], depth).unwrap();
            let forth = space.stations(way.world, IMAGE, &viewport()).projected.unwrap();
            assert_eq!(forth.pixel.to_array(), [300.0, 200.0]);
            assert!((forth.viewport.z - depth).abs() < 1e-14, "{} is not {depth}", forth.viewport.z);
            let setting = Setting::new(camera.notes_clip_space(), IMAGE, Some(viewport()));
            let steps = back(&setting, &way);
            assert_eq!(steps.first().unwrap().from, "pixel");
            assert_eq!(steps.last().unwrap().output, way.world.to_array());
            for step in steps {
                let size = step.terms.iter().flatten().fold(1e-300_f64, |size, x| size.max(x.abs()));
                assert!(step.rests().iter().all(|rest| rest.abs() <= 1e-12 * size), "{step:?}");
            }
        }
    }
    let camera = camera(|p| (p.near, p.far) = (1.0, 3.0));
    let way = |viewport: &Viewport, depth| camera.notes_clip_space().way_back(IMAGE, viewport, [0, 0], depth);
    let infinity = NotProjectable::BeyondInfinity { depth: 1.5, near: 0.0, infinity: 1.5 };
    assert_eq!(way(&Viewport::whole(IMAGE), 1.5), Err(infinity));
    assert!(way(&Viewport::whole(IMAGE), 1.4).is_ok(), "behind the far plane, before infinity");
    let empty = Viewport { depth_near: 0.5, depth_far: 0.5, ..viewport() };
    assert_eq!(way(&empty, 0.5), Err(NotProjectable::EmptyDepthRange { depth: 0.5 }));
}

/// Each row's formula gives the row's number, and its text with the numbers put in is read back as it.
fn assert_formulas(steps: &[Step], setting: &Setting<'_>) {
    let style = Style { notation: Notation::Text, mark: DecimalMark::Point, digits: EXACT_DIGITS };
    for step in steps {
        assert_eq!(step.formulas.len(), step.output.len(), "{step:?}");
        let with = step.setting(setting);
        for ((formula, line), output) in step.formulas.iter().zip(step.lines(setting, style)).zip(&step.output) {
            let (value, size) = (formula.value(&with), formula.magnitude(&with).max(output.abs()));
            assert!((value - output).abs() <= 1e-11 * size, "{step:?}: {value} is not {output}");
            if !line.numbers.contains('⌊') {
                let again = evaluated(&line.numbers);
                assert!((again - output).abs() <= 1e-11 * size, "{line:?}: {again}");
            }
            assert_eq!(evaluated(&line.value), *output);
        }
    }
}

#[test]
fn ways_are_written_with_symbols_and_with_numbers() {
    let camera = camera(|p| (p.position, p.focal_point) = (DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO));
    let setting = Setting::new(camera.notes_clip_space(), IMAGE, None).with_point(DVec3::new(1.0, 2.0, 0.5));
    let steps = forward(&setting);
    let style = |notation| Style { notation, mark: DecimalMark::Comma, digits: 4 };
    let text = written(&steps[..1], &setting, style(Notation::Text), |space| space.to_uppercase());
    let expected =
        "WORLD → VIEW  (5.7)\n  x_c = v_11 x + v_12 y + v_13 z + v_14·1\n    = 1·1 + 0·2 + 0·0,5 + 0·1 = 1\n";
    assert!(text.starts_with(expected), "{text}");
    let latex = written(&steps, &setting, style(Notation::Latex), str::to_owned);
    assert_eq!(latex.matches("\\begin{aligned}").count(), steps.len());
    assert_eq!(latex.matches('{').count(), latex.matches('}').count());
    assert!(latex.contains(r"x_{c} &= v_{11}") && latex.contains("{,}"), "{latex}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_numbers_of_every_formula_give_the_entry(camera in plain_camera()) {
        for ndc in Ndc::ALL {
            let Ok(space) = camera.clip_space(ndc) else { continue };
            let setting = Setting::new(space, IMAGE, Some(viewport())).with_placement(turned());
            assert_every_entry(&setting, ndc == Ndc::default());
        }
    }

    #[test]
    fn formulas_hold_for_extreme_cameras(camera in any_camera()) {
        let setting = Setting::new(camera.notes_clip_space(), IMAGE, Some(viewport()));
        for matrix in [Matrix::Projection, Matrix::InverseProjection, Matrix::InverseView] {
            let formulas = MatrixFormula::new(matrix, &setting);
            for (row, column) in (0..16).map(|k| (k / 4, k % 4)) {
                let (formula, expected) = (formulas.entry(row, column), setting.matrix(matrix).row(row)[column]);
                let (value, size) = (formula.value(&setting), formula.magnitude(&setting));
                // Products of far and near may leave the range of numbers although the entry does not.
                if value.is_finite() && size.is_finite() && size > 1e-290 && expected.abs() > 1e-290 {
                    let slack = 1e-12 * size.max(expected.abs());
                    prop_assert!((value - expected).abs() <= slack, "{formula:?}: {value}, not {expected}");
                }
            }
        }
    }

    #[test]
    fn both_ways_have_formulas_that_give_their_numbers(camera in plain_camera(), depth in 0.3..0.8, pixel in [0_i64..1024, 0_i64..768]) {
        for ndc in Ndc::ALL {
            let Ok(space) = camera.clip_space(ndc) else { continue };
            let setting = Setting::new(space, IMAGE, Some(viewport()));
            let way = space.way_back(IMAGE, &viewport(), pixel, depth).unwrap();
            let steps = back(&setting, &way);
            prop_assert_eq!(steps.len(), 5);
            let with_way = setting.clone().with_way_back(&way);
            assert_formulas(&steps, &with_way);
            for step in &steps {
                let sizes = step.terms.iter().map(|terms| terms.iter().fold(1e-300_f64, |size, x| size.max(x.abs())));
                for (rest, size) in step.rests().into_iter().zip(sizes) {
                    prop_assert!(rest.abs() <= 1e-11 * size, "{:?}: {:?}", ndc, step);
                }
            }
            prop_assert!(DVec3::from_slice(&steps[4].output).abs_diff_eq(way.world, 1e-9 * way.world.length()));
            let setting = setting.with_point(way.world);
            assert_formulas(&forward(&setting), &setting);
        }
    }

    #[test]
    fn every_definition_gives_its_symbol(camera in plain_camera()) {
        let setting = Setting::new(camera.notes_clip_space(), IMAGE, None);
        let axes = Axis::ALL.into_iter().flat_map(|axis| Component::THREE.map(|c| Symbol::Axis(axis, c)));
        let sizes = [Symbol::Width, Symbol::Height, Symbol::Aspect, Symbol::Distance];
        let sides = [Symbol::Left, Symbol::Right, Symbol::Bottom, Symbol::Top];
        for symbol in axes.chain(sizes).chain(sides) {
            let Some(definition) = definition(symbol, &setting) else { continue };
            let (value, expected) = (definition.formula.value(&setting), setting.value(symbol));
            let slack = 1e-11 * definition.formula.magnitude(&setting).max(expected.abs());
            prop_assert!((value - expected).abs() <= slack, "{symbol:?}: {value}, not {expected}");
        }
    }

    #[test]
    fn a_trace_adds_up_and_ends_where_the_numbers_of_inspect_do(camera in any_camera(), p in [-5.0..5.0, -5.0..5.0, -5.0..5.0]) {
        let p = camera.focal_point() + DVec3::from_array(p) * camera.distance();
        prop_assume!(p.is_finite());
        for ndc in Ndc::ALL {
            let Ok(space) = camera.clip_space(ndc) else { continue };
            let stations = space.stations(p, IMAGE, &viewport());
            prop_assume!(stations.view.is_finite() && stations.clip.is_finite());
            prop_assume!(stations.projected.is_none_or(|p| p.ndc.is_finite() && p.window.is_finite()));
            let setting = Setting::new(space, IMAGE, Some(viewport())).with_point(p);
            let steps = forward(&setting);
            prop_assert_eq!(steps.len(), if stations.projected.is_some() { 6 } else { 2 });
            for step in &steps {
                let sizes = step.terms.iter().map(|terms| terms.iter().fold(1e-300_f64, |size, x| size.max(x.abs())));
                for (rest, size) in step.rests().into_iter().zip(sizes) {
                    // (Beyond whole numbers of 53 bits, pixels are not exact.)
                    prop_assert!(rest.abs() <= 1e-11 * size || size > 1e15, "{:?}", step);
                }
            }
            let outputs: Vec<Vec<f64>> = steps.into_iter().map(|step| step.output).collect();
            prop_assert_eq!(&outputs[0], &stations.view.to_array().map(|x| x + 0.0).to_vec());
            prop_assert_eq!(&outputs[1], &stations.clip.to_array().map(|x| x + 0.0).to_vec());
        }
    }
}

#[test]
fn far_from_the_origin_the_way_to_view_space_still_adds_up() {
    let far = DVec3::splat(1e12);
    let camera = camera(|p| (p.position, p.focal_point) = (far + DVec3::new(3.0, 4.0, 5.0), far));
    let setting = Setting::new(camera.notes_clip_space(), IMAGE, None).with_point(far + DVec3::X);
    let step = forward(&setting).remove(0);
    assert_eq!(step.matrix, None, "the rows of M_v lose what is asked for");
    assert_eq!(step.input, [-2.0, -4.0, -5.0]);
    assert!(step.rests().iter().all(|rest| rest.abs() < 1e-14), "{step:?}");
}

#[test]
fn a_point_in_the_plane_of_the_eye_is_followed_as_far_as_it_goes() {
    let camera = camera(|p| p.position = DVec3::new(0.0, 0.0, 5.0));
    let setting = Setting::new(camera.notes_clip_space(), IMAGE, None).with_point(DVec3::new(1.0, 1.0, 5.0));
    let steps = forward(&setting);
    assert_eq!(steps.last().unwrap().to, "clip");
    assert_eq!(steps.last().unwrap().output[3], 0.0);
    let local = Setting::new(camera.notes_clip_space(), IMAGE, None).with_placement(turned());
    let steps = forward(&local.with_local_point(DVec3::new(1.0, 2.0, 3.0)));
    assert_eq!((steps[0].from, steps[0].to), ("local", "world"));
    let expected = turned().world_from_object * DVec4::new(1.0, 2.0, 3.0, 1.0);
    assert!(DVec3::from_slice(&steps[0].output).abs_diff_eq(expected.truncate(), 1e-14));
    assert_eq!(Formula::Number(2.0).value(&Setting::new(camera.notes_clip_space(), IMAGE, None)), 2.0);
}

/// Every entry of every step to the canonical volume, and of their product, has a formula that gives it.
fn assert_every_step(camera: &Camera) {
    for way in Decomposition::ALL {
        let Some(factors) = camera.decomposed(way) else { continue };
        let setting = Setting::new(camera.possible_clip_space(way.ndc()), IMAGE, None);
        let mut product: Option<(EntryFormula, DMat4)> = None;
        for factor in factors {
            let formulas = factor_entries(factor.step, &setting);
            let so_far = match product {
                None => (formulas.clone(), factor.matrix),
                Some((before, matrix)) => (entry_product(&formulas, &before), factor.matrix * matrix),
            };
            for (formulas, matrix) in [(&formulas, factor.matrix), (&so_far.0, so_far.1)] {
                for (row, entries) in formulas.iter().enumerate() {
                    for (column, formula) in entries.iter().enumerate() {
                        let (expected, value) = (matrix.row(row)[column], formula.value(&setting));
                        let slack = 1e-11 * formula.magnitude(&setting).max(expected.abs());
                        let what = format!("{way:?} {:?} [{row}][{column}] {formula:?}", factor.step);
                        assert!((value - expected).abs() <= slack, "{what}: {value} is not {expected}");
                    }
                }
            }
            product = Some(so_far);
        }
    }
}

proptest! {
    #[test]
    fn every_step_to_the_cube_has_formulas(camera in plain_camera()) {
        assert_every_step(&camera);
    }
}

#[test]
fn the_first_step_moves_the_eye_to_the_origin() {
    let camera = camera(|_| ());
    let setting = Setting::new(camera.possible_clip_space(Ndc::default()), IMAGE, None);
    let [x, ..] = factor_entries(camera_lab_engine::camera::Step::ToEye, &setting);
    assert_eq!(x[3], -Formula::Symbol(Symbol::Position(Component::X)));
}

#[test]
fn every_call_of_a_list_has_formulas() {
    use camera_lab_figures::explain::order::Call;
    let camera = camera(|_| ());
    let setting = Setting::new(camera.possible_clip_space(Ndc::default()), IMAGE, None);
    let (t, s) = (DVec3::new(1.0, -2.0, 0.5), DVec3::new(2.0, 0.5, -1.5));
    let calls = [Call::Translate(t), Call::RotateX(30.0), Call::RotateY(-45.0), Call::RotateZ(70.0), Call::Scale(s)];
    for call in calls {
        let (matrix, entries) = (call.matrix().unwrap(), call.entries().unwrap());
        for (i, row) in entries.iter().enumerate() {
            for (j, formula) in row.iter().enumerate() {
                let (value, expected) = (formula.value(&setting), matrix.row(i)[j]);
                assert!((value - expected).abs() < 1e-15, "{call:?} [{i}][{j}]: {value}, not {expected}");
            }
        }
    }
    assert!(Call::Push.entries().is_none() && Call::Pop.entries().is_none());
}
