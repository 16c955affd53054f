//! The side of explanations.

use crate::camera::Decomposition;
use crate::explain::{Axis, Component, Matrix, MatrixFormula, Symbol};
use crate::numbers::significant;
use crate::why::conventions;

texts!("why/explain");

texts_with_values! {
    /// The place of an entry. Rows and columns from 0.
    entry(lang, matrix: &str, row: usize, column: usize): (matrix, row = row + 1, column = column + 1);

    /// The sum in which an entry occurs, for a point.
    used_in(lang, point: &str, symbol: &str);

    /// The matrix of a step. The first is 1.
    factor(lang, step: usize);

    /// The handedness of the axes from here on.
    handedness(lang, hand: &str);
}

/// The effect of a matrix.
pub const fn matrix(lang: Lang, matrix: Matrix) -> &'static str {
    match matrix {
        Matrix::Model => text!(lang, matrix_model),
        Matrix::InverseModel => text!(lang, matrix_inverse_model),
        Matrix::Parent => text!(lang, matrix_parent),
        Matrix::InverseParent => text!(lang, matrix_inverse_parent),
        Matrix::View => text!(lang, matrix_view),
        Matrix::InverseView => text!(lang, matrix_inverse_view),
        Matrix::Projection => text!(lang, matrix_projection),
        Matrix::InverseProjection => text!(lang, matrix_inverse_projection),
        Matrix::ViewProjection => text!(lang, matrix_view_projection),
        Matrix::InverseViewProjection => text!(lang, matrix_inverse_view_projection),
        Matrix::Viewport => text!(lang, matrix_viewport),
        Matrix::InverseViewport => text!(lang, matrix_inverse_viewport),
    }
}

/// The reason why this equation is in force.
pub fn in_force(lang: Lang, formulas: &MatrixFormula) -> String {
    let kind = match formulas.equation {
        "(5.13)" => text!(lang, in_force_5_13),
        "(5.14)" => text!(lang, in_force_5_14),
        "(5.15)" => text!(lang, in_force_5_15),
        "(5.16)" => text!(lang, in_force_5_16),
        "" => text!(lang, in_force_none),
        _ => text!(lang, in_force_other),
    };
    format!("{} {kind}", formulas.equation).trim().to_owned()
}

/// A symbol, in a few words.
pub fn symbol(lang: Lang, symbol: Symbol) -> String {
    let of = |component: Component, whole: &str| text!(lang, symbol_of, letter = component.letter(), whole);
    match symbol {
        Symbol::Axis(Axis::U, c) => of(c, text!(lang, symbol_u)),
        Symbol::Axis(Axis::V, c) => of(c, text!(lang, symbol_v)),
        Symbol::Axis(Axis::N, c) => of(c, text!(lang, symbol_n)),
        Symbol::Position(c) => of(c, text!(lang, symbol_position)),
        Symbol::FocalPoint(c) => of(c, text!(lang, symbol_focal_point)),
        Symbol::ViewUp(c) => of(c, text!(lang, symbol_view_up)),
        Symbol::Distance => text!(lang, symbol_distance).to_owned(),
        Symbol::Near => text!(lang, symbol_near).to_owned(),
        Symbol::Far => text!(lang, symbol_far).to_owned(),
        Symbol::Left => text!(lang, symbol_left).to_owned(),
        Symbol::Right => text!(lang, symbol_right).to_owned(),
        Symbol::Bottom => text!(lang, symbol_bottom).to_owned(),
        Symbol::Top => text!(lang, symbol_top).to_owned(),
        Symbol::Width => text!(lang, symbol_width).to_owned(),
        Symbol::Height => text!(lang, symbol_height).to_owned(),
        Symbol::Aspect => text!(lang, symbol_aspect).to_owned(),
        Symbol::ViewAngle => text!(lang, symbol_view_angle).to_owned(),
        Symbol::ImageWidth => text!(lang, symbol_image_width).to_owned(),
        Symbol::ImageHeight => text!(lang, symbol_image_height).to_owned(),
        Symbol::ViewportX => text!(lang, symbol_viewport_x).to_owned(),
        Symbol::ViewportY => text!(lang, symbol_viewport_y).to_owned(),
        Symbol::ViewportWidth => text!(lang, symbol_viewport_width).to_owned(),
        Symbol::ViewportHeight => text!(lang, symbol_viewport_height).to_owned(),
        Symbol::DepthNear => text!(lang, symbol_depth_near).to_owned(),
        Symbol::DepthFar => text!(lang, symbol_depth_far).to_owned(),
        Symbol::Translate(c) => of(c, text!(lang, symbol_translate)),
        Symbol::Rotate(c) => text!(lang, symbol_rotate, letter = c.letter()),
        Symbol::Scale(c) => of(c, text!(lang, symbol_scale)),
        Symbol::Entry(matrix, row, column) => entry(lang, matrix.text(), row.into(), column.into()),
        Symbol::Local(c) => of(c, text!(lang, symbol_local)),
        Symbol::World(c) => of(c, text!(lang, symbol_world)),
        Symbol::View(c) => of(c, text!(lang, symbol_view)),
        Symbol::Clip(c) => of(c, text!(lang, symbol_clip)),
        Symbol::Homogeneous(c) => of(c, text!(lang, symbol_homogeneous)),
        Symbol::Ndc(c) => of(c, text!(lang, symbol_ndc)),
        Symbol::Window(c) => of(c, text!(lang, symbol_window)),
        Symbol::Pixel(c) => of(c, text!(lang, symbol_pixel)),
        Symbol::Viewport(c) => of(c, text!(lang, symbol_viewport)),
    }
}

/// The matrices of a way to the canonical volume.
pub const fn decomposition(lang: Lang, decomposition: Decomposition) -> &'static str {
    match decomposition {
        Decomposition::Notes => text!(lang, decomposition),
        Decomposition::Box => "S T P",
        Decomposition::Scale => "M_{xyscale} M_{pers}",
        Decomposition::Normalised => "M_P N",
    }
}

/// The product of the first steps.
pub fn product(lang: Lang, steps: usize) -> String {
    match steps {
        1 => text!(lang, product_one).to_owned(),
        _ => text!(lang, product_many, steps),
    }
}

/// The product of all steps compared with M_p M_v in the convention in which they end: `ratio` times it, but for
/// `rest`, relative to the greatest entry.
pub fn comparison(lang: Lang, decomposition: Decomposition, ratio: f64, rest: f64) -> String {
    const ROUNDING: f64 = 1e-9;
    let number = |value: f64, digits| lang.mark().printed(&significant(value, digits));
    let ndc = decomposition.ndc();
    let (from, to) = (number(ndc.depths()[0], 2), number(ndc.depths()[1], 2));
    let convention = conventions::name(lang, ndc);
    if rest.is_nan() || rest > ROUNDING {
        let rest = number(rest, 2);
        return text!(lang, comparison_rest, convention, rest);
    }
    let (k, same) = (number(ratio, 5), (ratio - 1.0).abs() <= ROUNDING);
    match same {
        true => text!(lang, comparison_equal, convention, from, to),
        false => text!(lang, comparison_multiple, k, convention, from, to),
    }
}
