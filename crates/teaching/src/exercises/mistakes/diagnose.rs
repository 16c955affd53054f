//! The known mistake that explains a wrong answer. We name it only if the answer equals the mistake's result, and
//! together with all others that give the same.

use std::sync::Arc;

use super::mistake::Mistake;
use super::nature::Nature;
use super::slip::{Cause, Slip, Slips};
use crate::exercises::acceptance::{in_order, is_right, rounded};
use crate::exercises::beside::{Beside, numbers};
use crate::exercises::exercise::{Ask, Expected};
use crate::exercises::own_texts::OwnMistake;
use crate::exercises::value::Table;
use crate::inspect::quantity::{BasisAxis, Quantity};

/// The known mistakes that give the numbers of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// One, or two that were made together. The first is the one that comes first on the way. Empty if `own` isn't a
    /// known mistake.
    pub causes: Vec<Cause>,
    /// Other mistakes that give the same numbers, the more likely first.
    pub others: Vec<Cause>,
    /// The row and column of a single faulty number, from 0.
    pub entry: Option<[usize; 2]>,
    /// The wrong answer that a lecturer expected, with its message.
    pub own: Option<Arc<OwnMistake>>,
}

impl Diagnosis {
    pub(in crate::exercises) fn of(cause: Cause) -> Self {
        Self::together(vec![cause])
    }

    pub(in crate::exercises) fn together(causes: Vec<Cause>) -> Self {
        Self { causes, others: Vec::new(), entry: None, own: None }
    }

    /// All possible mistakes, those of the causes before the others.
    pub fn mistakes(&self) -> impl Iterator<Item = Mistake> {
        self.causes.iter().chain(&self.others).map(|cause| cause.mistake)
    }
}

/// Numbers other than 0 that have to agree before we name two mistakes together, or one wrong number alone.
const ENOUGH: usize = 4;

/// The agreement of an answer with the result of a mistake. The closer first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Agreement {
    /// To more digits than rounding matches by chance.
    Exact,
    /// To the few digits that the student gave.
    AsWritten,
}

/// The known mistakes that give `given` if `right` is right: one of the slips, a matrix or a sign turned round, a slip
/// of the pen, or two together.
pub(in crate::exercises) fn diagnose(
    ask: &Ask,
    expected: &Expected,
    right: &Table,
    given: &[f64],
    beside: Option<Beside<'_>>,
) -> Option<Diagnosis> {
    // A slip that gives the right result isn't a mistake here.
    let differs = |table: &Table| table.shape() == right.shape() && !ask.accepts_all(&table.entries, right);
    let agreed = |table: &Table| {
        // Points in any order are in that of the table.
        let given = if ask.any_order {
            let all: Vec<Option<f64>> = given.iter().copied().map(Some).collect();
            &in_order(given, &ask.order(&all, table))
        } else {
            given
        };
        let agreement = agreement(ask, given, table).filter(|_| differs(table))?;
        is_evidence(ask, given, right, table).then_some(agreement)
    };
    let slipped = possible(ask, expected, right);
    let agreeing: Vec<(Slip, Agreement)> =
        slipped.iter().filter_map(|(slip, table)| Some((*slip, agreed(table)?))).collect();
    if let Some(best) = agreeing.iter().map(|(_, agreement)| *agreement).min() {
        let slips: Vec<Slip> = agreeing.iter().filter(|(_, agreement)| *agreement == best).map(|(s, _)| *s).collect();
        let slips = supported(&slips, ask, beside);
        if !slips.is_empty() {
            return one_of(&slips, is_lost_sign(ask, given, right));
        }
    }
    // Slips that the answers beside it exclude weren't made. A sign, or reversing the whole, may give the same.
    let are_excluded = !agreeing.is_empty();
    // Two digits change the length of a vector too.
    let multiple =
        if is_rounded_too_early(ask, given, right) { None } else { multiple_of_direction(ask, right, given, &slipped) };
    if let Some(diagnosis) = multiple.filter(|_| !are_excluded) {
        return Some(diagnosis);
    }
    let of_table = |table: &Table| turned_round(ask, table).into_iter().find(|(_, t)| agreed(t).is_some());
    if let Some((cause, _)) = of_table(right) {
        return Some(Diagnosis::of(cause));
    }
    if ask.nature.has_signs() && has_signs_of(ask, given, right) {
        let entry = only_wrong(ask, given, right);
        return Some(Diagnosis { entry, ..Diagnosis::of(Cause::of(Mistake::Sign)) });
    }
    if are_excluded {
        return None;
    }
    if is_rounded_too_early(ask, given, right) {
        return Some(Diagnosis::of(Cause::of(Mistake::RoundedTooEarly)));
    }
    if let Some(entry) = only_wrong(ask, given, right) {
        let others = right.entries.iter().enumerate().filter(|(k, of)| {
            let at = entry[0] * right.columns.max(1) + entry[1];
            *k != at && **of != 0.0
        });
        if ask.nature == Nature::Matrix && others.count() >= ENOUGH {
            return Some(Diagnosis { entry: Some(entry), ..Diagnosis::of(Cause::of(Mistake::ArithmeticSlip)) });
        }
    }
    let may_be = |slip: &Slip| !is_excluded(*slip, ask, beside);
    let slipped: Vec<(Slip, Table)> = slipped.into_iter().filter(|(slip, _)| may_be(slip)).collect();
    two_together(ask, (expected, right), given, &slipped, |table| agreed(table).is_some(), of_table)
}

/// The slips that change the answer to a question, in order of preference, with their results.
pub(in crate::exercises) fn possible(ask: &Ask, expected: &Expected, right: &Table) -> Vec<(Slip, Table)> {
    let differs = |table: &Table| table.shape() == right.shape() && !ask.accepts_all(&table.entries, right);
    let slipped = in_order_of_telling(expected)
        .into_iter()
        .filter(|slip| !(ask.not_asked)(*slip))
        .filter_map(|slip| Some((slip, expected.slipped(Slips::one(slip))?)))
        .filter(|(slip, table)| differs(table) && ask.nature.shows(slip.mistake()));
    without_idle_operations(ask, slipped.collect())
}

/// True if a known mistake gives these numbers in one of the readings, to more digits than rounding matches by chance.
pub(in crate::exercises) fn is_known_mistake(ask: &Ask, given: &[f64]) -> bool {
    ask.readings.iter().any(|reading| {
        let Some(right) = reading.expected.table() else { return false };
        let is_made = |slip: &Slip| {
            ask.nature.shows(slip.mistake())
                && reading.expected.slipped(Slips::one(*slip)).is_some_and(|wrong| {
                    wrong.shape() == right.shape()
                        && agreement(ask, given, &wrong) == Some(Agreement::Exact)
                        && !ask.accepts_all(&wrong.entries, &right)
                })
        };
        Slip::ALL.iter().any(is_made)
    })
}

/// Omits other operations that leave the quantity unchanged, as a roll leaves C, because they amount to doing nothing
/// to it.
fn without_idle_operations(ask: &Ask, mut slipped: Vec<(Slip, Table)>) -> Vec<(Slip, Table)> {
    let before = slipped.iter().find(|(slip, _)| *slip == Slip::NothingDone).map(|(_, table)| table.clone());
    let is_idle = |slip: Slip, table: &Table| {
        slip.mistake() == Mistake::OtherOperation
            && before.as_ref().is_some_and(|before| ask.accepts_all(&table.entries, before))
    };
    slipped.retain(|(slip, table)| !is_idle(*slip, table));
    slipped
}

/// The greatest number of possible causes worth reading. More of them say nothing.
const MOST: usize = 3;

/// The diagnosis of slips that give the same numbers. A reversed axis may also be a lost minus.
fn one_of(slips: &[Slip], is_lost_sign: bool) -> Option<Diagnosis> {
    let mut causes: Vec<Cause> = Vec::new();
    for slip in slips {
        if causes.iter().all(|cause| cause.mistake != slip.mistake()) {
            causes.push(slip.cause());
        }
    }
    let has = |mistakes: &[Mistake]| causes.iter().any(|cause| mistakes.contains(&cause.mistake));
    if is_lost_sign && causes.len() < MOST && has(&[Mistake::UReversed, Mistake::VReversed]) && !has(&[Mistake::Sign]) {
        causes.push(Cause::of(Mistake::Sign));
    }
    let others = causes.split_off(causes.len().min(1));
    (!causes.is_empty() && others.len() < MOST).then(|| Diagnosis { others, ..Diagnosis::together(causes) })
}

/// The slips that the answers beside this one allow. If some of them explain another wrong answer, only those.
fn supported(slips: &[Slip], ask: &Ask, beside: Option<Beside<'_>>) -> Vec<Slip> {
    let allowed: Vec<Slip> = slips.iter().copied().filter(|slip| !is_excluded(*slip, ask, beside)).collect();
    let explains_another = |slip: &Slip| {
        let mut others = beside.into_iter().flat_map(|beside| beside.answered(&ask.name));
        others.any(|(other, answer)| {
            let (wrong, given) = (other.expected().slipped(Slips::one(*slip)), numbers(answer, other));
            !is_right(other, answer)
                && wrong.zip(given).is_some_and(|(wrong, given)| {
                    wrong.shape() == given.shape() && agreement(other, &given.entries, &wrong).is_some()
                })
        })
    };
    let explaining: Vec<Slip> = allowed.iter().copied().filter(explains_another).collect();
    if explaining.is_empty() { allowed } else { explaining }
}

/// True if the slip would make a right answer beside this one wrong.
fn is_excluded(slip: Slip, ask: &Ask, beside: Option<Beside<'_>>) -> bool {
    let mut others = beside.into_iter().flat_map(|beside| beside.answered(&ask.name));
    others.any(|(other, answer)| {
        let tables = other.expected().table().zip(other.expected().slipped(Slips::one(slip)));
        tables.is_some_and(|(right, wrong)| {
            wrong.shape() == right.shape()
                && !other.accepts_all(&wrong.entries, &right)
                && is_right(other, answer)
                // In another reading the right one may equal the result of the slip.
                && numbers(answer, other).is_none_or(|given| agreement(other, &given.entries, &wrong).is_none())
        })
    })
}

/// The slips, in order of preference if several explain the same numbers. For a point and after an operation the last
/// step comes first, otherwise the axes.
fn in_order_of_telling(expected: &Expected) -> Vec<Slip> {
    let last_first = matches!(expected, Expected::Quantity(subject, path)
        if matches!(path.quantity, Quantity::Point(..)) || !subject.operations.is_empty());
    let (mut axes, others): (Vec<Slip>, Vec<Slip>) = Slip::ALL.iter().partition(|slip| slip.is_of_axes());
    // The last product on the way to v is n × u.
    if matches!(expected, Expected::Quantity(_, path) if path.quantity == Quantity::Axis(BasisAxis::V)) {
        axes.sort_by_key(|slip| *slip != Slip::VReversed);
    }
    if last_first { [others, axes].concat() } else { [axes, others].concat() }
}

/// A vector along the right one (or against it if **n** may be reversed) that has another length.
fn multiple_of_direction(ask: &Ask, right: &Table, given: &[f64], slipped: &[(Slip, Table)]) -> Option<Diagnosis> {
    let length = given.iter().map(|x| x * x).sum::<f64>().sqrt();
    if ask.nature != Nature::Direction || length == 0.0 || (length - 1.0).abs() < 0.01 {
        return None;
    }
    let unit: Vec<f64> = given.iter().map(|x| x / length).collect();
    let is_along = |table: &Table| {
        table.entries.len() == unit.len()
            && unit.iter().zip(&table.entries).all(|(given, of)| (given - of).abs() <= NOT_BY_CHANCE)
    };
    let not_normalised = Cause::of(Mistake::NotNormalised);
    if is_along(right) {
        return Some(Diagnosis::of(not_normalised));
    }
    let is_reversed = |(slip, table): &&(Slip, Table)| slip.mistake() == Mistake::NReversed && is_along(table);
    let (slip, _) = slipped.iter().find(is_reversed)?;
    Some(Diagnosis::together(vec![slip.cause(), not_normalised]))
}

/// The table with its rows and columns, its direction or all its signs turned round, as far as the nature of the
/// question allows.
fn turned_round(ask: &Ask, table: &Table) -> Vec<(Cause, Table)> {
    let mut found = Vec::new();
    let is_square = table.rows == table.columns && table.rows > 1;
    if ask.nature == Nature::Matrix && is_square {
        found.push((Cause { mistake: Mistake::Transposed, variant: "whole" }, table.transposed()));
        found.extend(table.inverse().map(|inverse| (Cause::of(Mistake::Inverse), inverse)));
    }
    if ask.nature.has_signs() {
        found.push((Cause::of(Mistake::Sign), table.map(|x| -x)));
    }
    found
}

/// Two slips, a slip in the wrong order, or a slip with one more number wrong.
fn two_together(
    ask: &Ask,
    (expected, right): (&Expected, &Table),
    given: &[f64],
    slipped: &[(Slip, Table)],
    explains: impl Fn(&Table) -> bool,
    of_table: impl Fn(&Table) -> Option<(Cause, Table)>,
) -> Option<Diagnosis> {
    // Some pair gives any order of a few things.
    if ask.nature == Nature::Order || given.iter().filter(|number| **number != 0.0).count() < ENOUGH {
        return None;
    }
    let mut found: Option<[Cause; 2]> = None;
    for (k, (first, _)) in slipped.iter().enumerate() {
        for (second, _) in &slipped[k + 1..] {
            let together = Slips::one(*first).and(*second);
            if first.mistake() == second.mistake() || !expected.slipped(together).is_some_and(|table| explains(&table))
            {
                continue;
            }
            let pair = [first.cause(), second.cause()];
            let is_other = |before: &[Cause; 2]| before.map(|cause| cause.mistake) != pair.map(|cause| cause.mistake);
            // Several pairs that give the same are no evidence for any of them.
            if found.as_ref().is_some_and(is_other) {
                return None;
            }
            found = found.or(Some(pair));
        }
    }
    if let Some(pair) = found {
        return Some(Diagnosis::together(pair.to_vec()));
    }
    for (slip, table) in slipped {
        if let Some((second, _)) = of_table(table).filter(|(second, _)| second.mistake != slip.mistake()) {
            return Some(Diagnosis::together(vec![slip.cause(), second]));
        }
    }
    // With few numbers, one more wrong number would explain anything.
    const MANY: usize = 9;
    let mut beside = slipped.iter().filter(|(_, table)| given.len() >= MANY && table.entries.len() == given.len());
    beside.find_map(|(slip, table)| {
        let entry = only_wrong(ask, given, table)?;
        let at = entry[0] * table.columns.max(1) + entry[1];
        // Numbers that are right without the slip are no evidence for it.
        let told = (0..given.len()).filter(|k| *k != at && !ask.accepts(Some(given[*k]), right.entries[*k]));
        if told.count() < ENOUGH {
            return None;
        }
        let causes = vec![slip.cause(), Cause::of(Mistake::ArithmeticSlip)];
        Some(Diagnosis { entry: Some(entry), ..Diagnosis::together(causes) })
    })
}

/// The relative distance within which two numbers don't agree by chance.
const NOT_BY_CHANCE: f64 = 1e-4;

/// The agreement of all numbers with those of a table.
fn agreement(ask: &Ask, given: &[f64], table: &Table) -> Option<Agreement> {
    if given.len() != table.entries.len() {
        return None;
    }
    let (size, several) = (table.size(), given.len() > 1);
    let each = |(given, of): (&f64, &f64)| {
        // For whole numbers, the next one is a different one.
        let is_whole = ask.whole && of.fract() == 0.0;
        let exact = if is_whole { 1e-9 } else { NOT_BY_CHANCE };
        let nothing = of.abs() <= 1e-9 * size;
        if (given - of).abs() <= exact * if nothing { size } else { of.abs() } {
            return Some(Agreement::Exact);
        }
        (!is_whole && !nothing && is_as_written(*given, *of, several)).then_some(Agreement::AsWritten)
    };
    let worst = given.iter().zip(&table.entries).map(each).collect::<Option<Vec<_>>>()?;
    worst.into_iter().max()
}

/// True if one of the wrong numbers is evidence of a mistake, because it has two digits or more, or equals the result
/// of the mistake without any rounding.
fn is_evidence(ask: &Ask, given: &[f64], right: &Table, table: &Table) -> bool {
    let size = table.size();
    given.iter().zip(&right.entries).zip(&table.entries).any(|((given, right), of)| {
        !ask.accepts(Some(*given), *right) && (digits(*given).0 > 1 || (given - of).abs() <= 1e-9 * size)
    })
}

/// The significant digits and the decimals of a number in its shortest form.
pub(in crate::exercises) fn digits(number: f64) -> (usize, usize) {
    let text = format!("{}", number.abs());
    let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let significant = text.replace('.', "").trim_start_matches('0').len();
    (significant, decimals)
}

/// True if `of`, rounded to the digits of `given`, is `given`. At least two digits have to be equal, or three if it's
/// the only number.
fn is_as_written(given: f64, of: f64, several: bool) -> bool {
    const LEAST: usize = 2;
    let (significant, decimals) = digits(given);
    let unit = |decimals: usize| 10.0_f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX));
    // The last digit of a long number may come from numbers rounded on the way.
    let units = if significant > LEAST + 1 { 1.5 } else { 0.5 };
    let least = if several { LEAST } else { LEAST + 1 };
    decimals > 0 && significant >= least && (given - of).abs() <= units * unit(decimals) * (1.0 + 1e-9)
}

/// The row and column of the only wrong entry.
fn only_wrong(ask: &Ask, given: &[f64], right: &Table) -> Option<[usize; 2]> {
    let mut wrong = (0..given.len()).filter(|k| !ask.accepts(Some(given[*k]), right.entries[*k]));
    let first = wrong.next()?;
    wrong.next().is_none().then(|| [first / right.columns.max(1), first % right.columns.max(1)])
}

/// True if only signs are wrong.
fn has_signs_of(ask: &Ask, given: &[f64], right: &Table) -> bool {
    given.iter().zip(&right.entries).all(|(given, right)| ask.accepts(Some(given.abs()), right.abs()))
}

/// True if only the sign of one number is wrong, and not the direction of a vector.
fn is_lost_sign(ask: &Ask, given: &[f64], right: &Table) -> bool {
    let may_be = ask.nature.has_signs() && ask.nature != Nature::Direction;
    may_be && has_signs_of(ask, given, right) && only_wrong(ask, given, right).is_some()
}

/// True if every wrong number is the right one with fewer than three digits or decimals, at least one of them with two.
/// Rounding 0.23 to 0 is implausible, and whole numbers need no rounding.
fn is_rounded_too_early(ask: &Ask, given: &[f64], right: &Table) -> bool {
    if ask.whole {
        return false;
    }
    let wrong = || given.iter().zip(&right.entries).filter(|(given, right)| !ask.accepts(Some(**given), **right));
    let several = wrong().count() > 1;
    let is = |given: f64, right: f64| (given - right).abs() <= 1e-9 * right.abs().max(1.0);
    let cut = |given: f64, right: f64| {
        if right.fract() == 0.0 {
            return false;
        }
        let to_decimals = [10.0, 100.0].iter().any(|unit| is(given, (right * unit).round() / unit));
        is(given, rounded(right, 2)) || (several && (is(given, rounded(right, 1)) || to_decimals))
    };
    wrong().all(|(given, right)| cut(*given, *right))
        && wrong().any(|(given, right)| digits(*given).0 > 1 && is(*given, rounded(*right, 2)))
}
