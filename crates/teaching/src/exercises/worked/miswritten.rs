//! Worked steps with a mistake in them: the ways in which a formula is miswritten, and the numbers that follow.

use std::collections::BTreeSet;

use super::Worked;
use crate::explain::{Component, Formula, Function, Named, Symbol, Vector, over, plus, sum, times};

/// Formulas in the place of others, with the numbers of their lines. The lines of all steps count, from 0.
pub(in crate::exercises) type Miswritten = Vec<(usize, Formula)>;

/// The symbols that an operation gives new numbers.
fn parameters() -> impl Iterator<Item = Symbol> {
    let points = Component::THREE.map(|c| [Symbol::Position(c), Symbol::FocalPoint(c), Symbol::ViewUp(c)]);
    let window = [Symbol::Left, Symbol::Right, Symbol::Bottom, Symbol::Top, Symbol::Width, Symbol::Height];
    points.into_iter().flatten().chain(window).chain([Symbol::ViewAngle])
}

/// −a, and b − a for a − b.
fn negated(formula: &Formula) -> Formula {
    match formula {
        Formula::Sum(terms) => match &terms[..] {
            [a, b @ Formula::Negative(_)] => plus(-b.clone(), -a.clone()),
            _ => -formula.clone(),
        },
        Formula::Quotient(above, below) if matches!(**above, Formula::Sum(_)) => {
            over(negated(above), (**below).clone())
        }
        other => -other.clone(),
    }
}

/// The formulas that one change makes of another: a sign, a part left out, a ratio upside down. The place and the kind
/// of the change stand before each. The sign of the whole comes first.
fn changed(formula: &Formula) -> Vec<(String, Formula)> {
    let mut found = vec![("-".to_owned(), negated(formula))];
    let inside = |place: String, part: &Formula, whole: &dyn Fn(Formula) -> Formula| {
        let others = changed(part).into_iter().skip(1);
        others.map(|(change, wrong)| (format!("{place}{change}"), whole(wrong))).collect::<Vec<_>>()
    };
    let mut add = |change: &str, wrong| found.push((change.to_owned(), wrong));
    match formula {
        Formula::Negative(inner) => found.extend(inside(String::new(), inner, &|wrong| -wrong)),
        Formula::Sum(parts) | Formula::Product(parts) => {
            let is_sum = matches!(formula, Formula::Sum(_));
            for (k, part) in parts.iter().enumerate() {
                let with = |other: Option<Formula>| {
                    let parts = parts[..k].iter().cloned().chain(other).chain(parts[k + 1..].iter().cloned());
                    if is_sum { sum(parts) } else { times(parts) }
                };
                let turned = if is_sum { with(Some(negated(part))) } else { over(with(None), part.clone()) };
                found.extend([(format!("{k}"), with(None)), (format!("{k}-"), turned)]);
                found.extend(inside(format!("{k}."), part, &|wrong| with(Some(wrong))));
            }
        }
        Formula::Quotient(above, below) => {
            let [a, b] = [above, below].map(|part| (**part).clone());
            add("a", a.clone());
            add("b/a", over(b.clone(), a.clone()));
            add("ab", times([a.clone(), b.clone()]));
            found.extend(inside("a.".to_owned(), above, &|wrong| over(wrong, b.clone())));
            found.extend(inside("b.".to_owned(), below, &|wrong| over(a.clone(), wrong)));
        }
        Formula::Of(function, x) => {
            let of = |x| Formula::Of(*function, Box::new(x));
            if *function == Function::Floor {
                add("x", (**x).clone());
                add("+", of(plus((**x).clone(), 0.5)));
            }
            found.extend(inside("x.".to_owned(), x, &of));
        }
        Formula::Dot(Vector::Axis(axis), Vector::Position) => {
            add("c", Symbol::Position(Component::THREE[*axis as usize]).into());
        }
        _ => {}
    }
    found
}

/// The name of a row, such as `n_x` or `D`.
fn name(symbol: &Formula) -> Option<String> {
    match symbol {
        Formula::Symbol(symbol) => Some(symbol.text()),
        Formula::Named(named) => Some(named.text.to_owned()),
        _ => None,
    }
}

/// The names of the rows of all steps.
pub(in crate::exercises) fn names(steps: &[Worked]) -> impl Iterator<Item = Option<String>> + '_ {
    steps.iter().flat_map(|step| &step.rows).map(|row| name(&row.symbol))
}

/// True for a length, which a student wouldn't write with a minus.
fn is_length(symbol: &Formula) -> bool {
    name(symbol).is_some_and(|name| name == "D" || name.starts_with('‖'))
}

/// The ways in which steps are miswritten: one formula, or those of a vector alike, because a student who has one of
/// them wrong has the others wrong.
pub(in crate::exercises) fn all(steps: &[Worked]) -> Vec<Miswritten> {
    let (mut found, mut first) = (Vec::new(), 0);
    for step in steps {
        let rows: Vec<Vec<(String, Formula)>> = step.rows.iter().map(|row| changed(&row.formula)).collect();
        let is_of_vector = |k: usize| name(&step.rows[k].symbol).is_some_and(|name| name.contains('_'));
        let are_alike = |a: &usize, b: &usize| {
            let is_apart = a != b && !(is_of_vector(*a) && is_of_vector(*b));
            !is_apart && rows[*a].iter().map(|(c, _)| c).eq(rows[*b].iter().map(|(c, _)| c))
        };
        let lines: Vec<usize> = (0..rows.len()).collect();
        let runs: Vec<&[usize]> = lines.chunk_by(are_alike).collect();
        let apart = runs.iter().map(|run| lines.iter().copied().filter(|k| are_alike(k, &run[0])).collect());
        // v' and n' of a rotation are alike too.
        let groups = runs.iter().map(|run| run.to_vec()).chain(runs.windows(2).map(<[_]>::concat)).chain(apart);
        for group in groups.collect::<BTreeSet<Vec<usize>>>() {
            let is_length = is_length(&step.rows[group[0]].symbol);
            for (change, _) in rows[group[0]].iter().filter(|(change, _)| !(is_length && change == "-")) {
                let of = |k: &usize| rows[*k].iter().find(|(other, _)| other == change);
                found.extend(group.iter().map(|k| Some((first + k, of(k)?.1.clone()))).collect::<Option<Miswritten>>());
            }
        }
        first += rows.len();
    }
    found
}

/// The steps with other formulas in some lines, and all numbers that follow from them.
pub(in crate::exercises) fn following(steps: &[Worked], miswritten: &[(usize, Formula)]) -> Vec<Worked> {
    // By the names of the rows: the right number and the wrong one.
    let mut named: Vec<(String, f64, f64)> = Vec::new();
    let mut wrong: Vec<(Symbol, f64)> = Vec::new();
    let mut lines = 0..;
    let step = |step: &Worked| {
        let mut step = step.clone();
        let Ok(camera) = step.subject.camera() else { return step };
        if step.heading == "afterwards" {
            // C is the new C' here.
            let new = |(name, _, value): &(String, f64, f64)| {
                let name = name.replace('\'', "");
                Some((parameters().find(|of| of.text().eq_ignore_ascii_case(&name))?, *value))
            };
            wrong = named.iter().filter(|(name, ..)| name.contains('\'')).filter_map(new).collect();
            named.clear();
        }
        let setting = step.setting(&camera);
        for (row, line) in step.rows.iter_mut().zip(lines.by_ref()) {
            let other = miswritten.iter().find(|(at, _)| *at == line).map(|(_, formula)| formula);
            let with_wrong = |part: &Formula| {
                let Formula::Named(of) = part else { return None };
                let is_it = |(name, right, _): &&(String, f64, f64)| name == of.text && is_same(*right, of.value);
                named.iter().find(is_it).map(|(.., value)| Named { value: *value, ..*of }.into())
            };
            row.formula = other.unwrap_or(&row.formula).replaced(&with_wrong);
            let value = row.formula.value(&setting.clone().with_values(&wrong));
            // Of what cancels, only rounding errors are left.
            let value = if value.abs() < 1e-13 { 0.0 } else { value };
            if is_same(value, row.value) {
                continue;
            }
            if let Formula::Symbol(symbol) = row.symbol {
                wrong.push((symbol, value));
            }
            let Some(name) = name(&row.symbol) else { continue };
            named.push((name, row.value, value));
            row.value = value;
        }
        step.wrong.clone_from(&wrong);
        step
    };
    steps.iter().map(step).collect()
}

/// True for numbers that differ by the error of their computation at most.
pub(in crate::exercises) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * b.abs().max(1.0)
}

impl Worked {
    /// The values of its rows.
    pub(in crate::exercises) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().map(|row| row.value)
    }

    /// A step for each of its rows.
    pub fn by_rows(&self) -> impl Iterator<Item = Self> + '_ {
        self.rows.iter().map(|row| Self { rows: vec![row.clone()], ..self.clone() })
    }
}
