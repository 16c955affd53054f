//! The overhead of precision: the camera model in double-double against the textbook chain in plain `f64`, for the
//! numbers of a figure and for a frame of the default scene.

use std::cell::RefCell;
use std::hint::black_box;
use std::time::Duration;

use glam::{DMat4, DVec3, DVec4};
use serde::Serialize;

use super::measure::{Trial, Watch};
use super::studies::painter::Painter;
use super::{Effort, Lab};
use crate::camera::{Camera, Ndc, Parameters};
use crate::chain::{Given, Matrix, basis, pose, projection_matrix, view_matrix};
use crate::clock;
use crate::figure::Figure;
use crate::progress::Progress;
use crate::scene::{Preset, build, no_files};

/// Median times of one thing, in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// The program's own way, in double-double.
    pub camera_lab: f64,
    /// The textbook's formulas in plain `f64`.
    pub f64: f64,
}

/// The overhead of precision.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Price {
    /// Basis, window, matrices, their inverses, and the corners of the volume, from the parameters of a figure.
    pub numbers: Cost,
    /// A frame of the scene that the program begins with, at the size of its image, from the parameters to the pixels.
    /// The pipeline is the same in both. It has been in `f64` from the start.
    pub frame: Cost,
}

/// Measures for about the number of seconds of the effort. `None` if it was cancelled, or no such scene could be built.
pub fn measure(effort: &Effort, progress: &Progress) -> Option<Price> {
    let lab = Lab { effort: *effort, progress: progress.clone() };
    let watch = lab.watch(2, 1);
    let figure = Figure::of_preset(Preset::Primitives);
    let parameters = figure.camera;
    let camera = Camera::new(&parameters).ok()?;
    let scene = build(&figure.scene, &figure.style, &mut no_files).ok()?;
    let size = [figure.image.width, figure.image.height];
    let own = || black_box(own_numbers(black_box(&parameters)));
    let textbook = || black_box(textbook_numbers(black_box(&parameters)));
    let numbers = in_turns(
        &watch,
        &mut || {
            own();
        },
        &mut || {
            textbook();
        },
    );
    let painter = RefCell::new(Painter::default());
    let frame = |camera: &Camera| {
        black_box(painter.borrow_mut().paint(&scene, camera, size, &figure.style));
    };
    let frame = in_turns(
        &watch,
        &mut || {
            own();
            frame(&camera);
        },
        &mut || {
            textbook();
            frame(&camera);
        },
    );
    (!progress.is_cancelled()).then_some(Price { numbers, frame })
}

/// The median times of two ways, taken in turns, so that other load of the machine affects both.
fn in_turns(watch: &Watch, camera_lab: &mut dyn FnMut(), f64: &mut dyn FnMut()) -> Cost {
    let once = Watch { slice: Duration::ZERO, ..watch.clone() };
    let (mut own, mut plain) = (Trial::default(), Trial::default());
    // To warm up.
    camera_lab();
    f64();
    let end = clock::now() + watch.slice;
    for turn in 0..MOST_TURNS {
        if watch.progress.is_cancelled() || (turn >= LEAST_TURNS && clock::now() >= end) {
            break;
        }
        own.time_whole(&once, 1, &mut *camera_lab);
        plain.time_whole(&once, 1, &mut *f64);
    }
    watch.progress.advance(1);
    Cost { camera_lab: own.nanos().median, f64: plain.nanos().median }
}

const LEAST_TURNS: usize = 3;
const MOST_TURNS: usize = 20_000;

/// Four matrices and eight corners.
type Numbers = ([DMat4; 4], [DVec3; 8]);

fn own_numbers(p: &Parameters) -> Option<Numbers> {
    let camera = Camera::new(p).ok()?;
    let matrices =
        [camera.view_from_world(), camera.clip_from_view(), camera.clip_from_world(), camera.view_from_clip()];
    Some((matrices, camera.volume_corners()))
}

/// The same with the printed formulas and the inverses of a library.
fn textbook_numbers(p: &Parameters) -> Numbers {
    let given = Given::<f64>::of(p);
    let view = view_matrix(&basis(&pose(p)), &given.position);
    let projection = projection_matrix(&given, Ndc::default());
    let both = projection.product(&view);
    let glam = |m: &Matrix<f64>| DMat4::from_cols_array_2d(&m.0).transpose();
    let world_from_clip = glam(&both).inverse();
    let corners = std::array::from_fn(|i| {
        let side = |bit: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let p = world_from_clip * DVec4::new(side(0), side(1), side(2), 1.0);
        p.truncate() / p.w
    });
    ([glam(&view), glam(&projection), glam(&both), glam(&projection).inverse()], corners)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both compute the same things, so that their times can be compared.
    #[test]
    fn both_ways_give_the_same_numbers_to_f64s_own_digits() {
        let p = Figure::of_preset(Preset::Primitives).camera;
        let (own, own_corners) = own_numbers(&p).expect("a camera");
        let (textbook, corners) = textbook_numbers(&p);
        for (a, b) in own.iter().zip(&textbook) {
            assert!(a.abs_diff_eq(*b, 1e-12), "{a} {b}");
        }
        for corner in corners {
            assert!(own_corners.iter().any(|own| own.abs_diff_eq(corner, 1e-10)), "{corner}");
        }
        let effort = Effort { seed: 1, seconds: 0.0, thorough: false };
        let price = measure(&effort, &Progress::default()).expect("a price");
        assert!(price.numbers.f64 > 0.0 && price.frame.camera_lab > price.numbers.camera_lab);
    }
}
