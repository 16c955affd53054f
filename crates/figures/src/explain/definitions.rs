//! Definitions of each symbol in the notes, down to the parameters.

use super::formula::{components, cross, minus, over, times};
use super::{Axis, Formula, Function, Setting, Symbol, Vector};
use crate::camera::Projection;

/// The definition of a symbol, with its place in the notes.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// The right side of the equation, in symbols.
    pub formula: Formula,
    /// Its equation in `[0]`. Empty if it has no number.
    pub equation: &'static str,
}

/// The definition of a symbol of the camera; `None` for a parameter, which the user chooses, and for the coordinates of
/// a point.
pub fn definition(symbol: Symbol, setting: &Setting<'_>) -> Option<Definition> {
    let camera = setting.space().camera();
    let given = camera.parameters();
    let perspective = camera.projection() == Projection::Perspective;
    let defined = |formula, equation| Some(Definition { formula, equation });
    let half = |symbol: Symbol| over(symbol, 2.0);
    match symbol {
        Symbol::Axis(Axis::N, c) => {
            defined(over(minus(Symbol::Position(c), Symbol::FocalPoint(c)), Symbol::Distance), "(5.2), (5.3)")
        }
        Symbol::Axis(Axis::U, c) => {
            let [x, y, z] = components(Vector::UpCrossNormal);
            let component = [x, y, z][c.index().min(2)].clone();
            defined(over(component, Formula::Norm(Vector::UpCrossNormal)), "(5.3)")
        }
        Symbol::Axis(Axis::V, c) => {
            let axis = |axis| move |c| Symbol::Axis(axis, c).into();
            defined(cross(axis(Axis::N), axis(Axis::U), c), "(5.3)")
        }
        Symbol::Distance => defined(Formula::Norm(Vector::ToFocalPoint), "(5.2)"),
        Symbol::Width if given.window.is_some() => defined(minus(Symbol::Right, Symbol::Left), "(5.13)"),
        Symbol::Height if given.window.is_some() => defined(minus(Symbol::Top, Symbol::Bottom), "(5.13)"),
        Symbol::Aspect if given.window.is_some() => defined(over(Symbol::Width, Symbol::Height), "(5.1)"),
        Symbol::Width => defined(times([Symbol::Aspect.into(), Symbol::Height.into()]), "(5.1)"),
        Symbol::Height if perspective => {
            let tangent = Formula::Of(Function::Tangent, Box::new(half(Symbol::ViewAngle)));
            defined(times([2.0.into(), Symbol::Near.into(), tangent]), "(5.5)")
        }
        Symbol::Left | Symbol::Right | Symbol::Bottom | Symbol::Top if given.window.is_none() => {
            let formula = match symbol {
                Symbol::Left => -half(Symbol::Width),
                Symbol::Right => half(Symbol::Width),
                Symbol::Bottom => -half(Symbol::Height),
                _ => half(Symbol::Height),
            };
            defined(formula, "§5.3.2")
        }
        _ => None,
    }
}

/// The parameters on which a formula depends, through all definitions, each once.
pub fn leaves(formula: &Formula, setting: &Setting<'_>) -> Vec<Symbol> {
    let mut open = formula.symbols();
    let (mut seen, mut leaves) = (Vec::new(), Vec::new());
    while let Some(symbol) = open.pop() {
        if seen.contains(&symbol) {
            continue;
        }
        seen.push(symbol);
        match definition(symbol, setting) {
            Some(definition) => open.extend(definition.formula.symbols()),
            None => leaves.push(symbol),
        }
    }
    leaves.sort();
    leaves
}
