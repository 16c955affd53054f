//! Each entry of each step to the canonical volume as a formula, in the notes' symbols.

use super::formula::{minus, over, plus, times};
use super::matrices::{last_row, one, projection, symbol, view, zero};
use super::{Component, EntryFormula, Formula, Setting, Symbol};
use crate::camera::Step;

/// The formulas of a step of the setting's camera, by rows.
///
/// *Guarantees*: each entry's [`Formula::value`] is that of the step's matrix
/// ([`decomposed`](crate::camera::Camera::decomposed)) up to the rounding of plain `f64`. The setting is in the
/// convention of NDC in which the steps end.
pub fn factor_entries(step: Step, setting: &Setting<'_>) -> EntryFormula {
    let (near, far) = (|| symbol(Symbol::Near), || symbol(Symbol::Far));
    let sizes = || [Symbol::Width, Symbol::Height].map(|size| over(2.0, size));
    match step {
        Step::ToEye => translation(Component::THREE.map(|c| -symbol(Symbol::Position(c)))),
        Step::Turn => turn(),
        Step::TurnLeftHanded => {
            let [u, v, n, last] = turn();
            [u, v, n.map(|entry| times([-one(), entry])), last]
        }
        Step::ClipRows => {
            let [x, y, z, _] = projection(setting);
            [x, y, z, last_row()]
        }
        Step::Divide => {
            // w_r = −z_c, and z_r = −(B + F)/(B − F) z_c − 2BF/(B − F).
            let both = times([2.0.into(), far(), near()]);
            let (difference, total) = (minus(Symbol::Far, Symbol::Near), plus(Symbol::Far, Symbol::Near));
            let w = [zero(), zero(), over(difference, total.clone()), over(both, total)];
            [axis(0), axis(1), axis(2), w]
        }
        Step::Box => {
            let z = [zero(), zero(), plus(1.0, over(far(), near())), far()];
            [axis(0), axis(1), z, [zero(), zero(), -over(1.0, near()), zero()]]
        }
        Step::Centre => {
            let middle = |a, b| over(plus(a, b), 2.0);
            let symmetric = setting.space().camera().has_symmetric_window();
            let across = |a, b| if symmetric { zero() } else { -middle(a, b) };
            translation([
                across(Symbol::Left, Symbol::Right),
                across(Symbol::Bottom, Symbol::Top),
                middle(Symbol::Far, Symbol::Near),
            ])
        }
        Step::Scale => {
            let [x, y] = sizes();
            scale([x, y, -over(2.0, minus(Symbol::Far, Symbol::Near))])
        }
        Step::Pers => {
            let [_, _, z, w] = projection(setting);
            [[near(), zero(), zero(), zero()], [zero(), near(), zero(), zero()], z, w]
        }
        Step::XyScale => {
            let [x, y] = sizes();
            scale([x, y, one()])
        }
        Step::UnitSlope => {
            let slope = |size| over(times([2.0.into(), near()]), size);
            scale([slope(Symbol::Width), slope(Symbol::Height), one()])
        }
        Step::UnitDepth => scale(std::array::from_fn(|_| over(1.0, far()))),
        Step::CanonicalBox => {
            let difference = || minus(Symbol::Far, Symbol::Near);
            let z = [zero(), zero(), over(far(), difference()), -over(near(), difference())];
            [axis(0), axis(1), z, [zero(), zero(), one(), zero()]]
        }
        Step::NearToOrigin => translation([zero(), zero(), -near()]),
        Step::ScaleOrt => {
            let [x, y] = sizes();
            scale([x, y, over(1.0, minus(Symbol::Far, Symbol::Near))])
        }
    }
}

/// The row of the identity matrix.
fn axis(row: usize) -> [Formula; 4] {
    std::array::from_fn(|column| if column == row { one() } else { zero() })
}

/// M_v without its translation.
fn turn() -> EntryFormula {
    view().map(|[x, y, z, w]| [x, y, z, if w == one() { w } else { zero() }])
}

fn translation(by: [Formula; 3]) -> EntryFormula {
    let [x, y, z] = by;
    [[one(), zero(), zero(), x], [zero(), one(), zero(), y], [zero(), zero(), one(), z], last_row()]
}

fn scale([x, y, z]: [Formula; 3]) -> EntryFormula {
    [[x, zero(), zero(), zero()], [zero(), y, zero(), zero()], [zero(), zero(), z, zero()], last_row()]
}
