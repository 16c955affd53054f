//! The measures of symbols in the world.

use crate::explain::{Axis, Formula, Symbol, Vector};
use crate::figure::{Measure, Measured, WindowSide};

/// The length, angle or axis that a symbol measures. `None` for symbols of neither the camera nor the object.
pub(super) fn of_symbol(symbol: Symbol) -> Option<Measured> {
    match symbol {
        Symbol::Axis(axis, c) => Some(Measured::Axis(number(axis), c.index())),
        Symbol::Position(c) => Some(Measured::Position(c.index())),
        Symbol::FocalPoint(c) => Some(Measured::FocalPoint(c.index())),
        Symbol::ViewUp(c) => Some(Measured::ViewUp(c.index())),
        Symbol::Distance => Some(Measured::Dimension(Measure::Distance)),
        Symbol::Near => Some(Measured::Dimension(Measure::Near)),
        Symbol::Far => Some(Measured::Dimension(Measure::Far)),
        Symbol::Left => Some(Measured::Side(WindowSide::Left)),
        Symbol::Right => Some(Measured::Side(WindowSide::Right)),
        Symbol::Bottom => Some(Measured::Side(WindowSide::Bottom)),
        Symbol::Top => Some(Measured::Side(WindowSide::Top)),
        Symbol::Width => Some(Measured::Dimension(Measure::Width)),
        Symbol::Height => Some(Measured::Dimension(Measure::Height)),
        Symbol::ViewAngle => Some(Measured::Dimension(Measure::HalfAngle)),
        Symbol::Translate(c) => Some(Measured::Translate(c.index())),
        Symbol::Rotate(c) => Some(Measured::Rotate(c.index())),
        Symbol::Scale(c) => Some(Measured::Scale(c.index())),
        Symbol::Aspect
        | Symbol::ImageWidth
        | Symbol::ImageHeight
        | Symbol::ViewportX
        | Symbol::ViewportY
        | Symbol::ViewportWidth
        | Symbol::ViewportHeight
        | Symbol::DepthNear
        | Symbol::DepthFar
        | Symbol::Entry(..)
        | Symbol::Local(_)
        | Symbol::World(_)
        | Symbol::View(_)
        | Symbol::Clip(_)
        | Symbol::Homogeneous(_)
        | Symbol::Ndc(_)
        | Symbol::Window(_)
        | Symbol::Pixel(_)
        | Symbol::Viewport(_) => None,
    }
}

const fn number(axis: Axis) -> usize {
    axis as usize
}

/// The measures of a formula: of **u** · **c** the coordinate along **u**, of all else those of its symbols.
pub(super) fn of_formula(formula: &Formula) -> Vec<Measured> {
    let mut found = Vec::new();
    collect(formula, &mut found);
    found
}

fn collect(formula: &Formula, found: &mut Vec<Measured>) {
    let mut add = |measure: Option<Measured>| found.extend(measure.filter(|m| !found.contains(m)));
    match formula {
        Formula::Number(_) | Formula::Named(_) => {}
        Formula::Symbol(symbol) => add(of_symbol(*symbol)),
        Formula::Dot(Vector::Axis(axis), Vector::Position) => add(Some(Measured::OriginAlong(number(*axis)))),
        Formula::Dot(..) | Formula::Norm(_) => formula.symbols().into_iter().for_each(|s| add(of_symbol(s))),
        Formula::Negative(inner) | Formula::Of(_, inner) => collect(inner, found),
        Formula::Sum(parts) | Formula::Product(parts) => parts.iter().for_each(|part| collect(part, found)),
        Formula::Quotient(above, below) => {
            collect(above, found);
            collect(below, found);
        }
    }
}
