//! Formulas as trees. The same tree is evaluated, written with symbols, and written with numbers.

use super::{Axis, Component, Setting, Symbol, Vector};
use crate::geometry::Angle;

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// Of an angle in degrees.
    Sine,
    /// Of an angle in degrees.
    Cosine,
    /// Of an angle in degrees.
    Tangent,
    /// ⌊x⌋
    Floor,
    /// √x
    Root,
    /// The angle in degrees with this tangent.
    ArcTangent,
}

/// A number without a symbol in the notes, with a name for its use here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Named {
    /// As text: `t_0`.
    pub text: &'static str,
    /// In LaTeX: `t_0`, `\alpha`.
    pub latex: &'static str,
    /// The value of the symbol in the figure.
    pub value: f64,
    /// An angle in degrees, written with the degree sign.
    pub is_angle: bool,
}

/// A formula in the notes' symbols.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// A number in the notes: 0, 1, 2.
    Number(f64),
    /// A letter of the notes.
    Symbol(Symbol),
    /// A number with its own name.
    Named(Named),
    /// −a
    Negative(Box<Self>),
    /// a + b + …
    Sum(Vec<Self>),
    /// a b …
    Product(Vec<Self>),
    /// a / b
    Quotient(Box<Self>, Box<Self>),
    /// **a** · **b**
    Dot(Vector, Vector),
    /// ‖**a**‖
    Norm(Vector),
    /// f(a)
    Of(Function, Box<Self>),
}

impl From<Symbol> for Formula {
    fn from(symbol: Symbol) -> Self {
        Self::Symbol(symbol)
    }
}

impl From<Named> for Formula {
    fn from(named: Named) -> Self {
        Self::Named(named)
    }
}

impl From<f64> for Formula {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

/// a / b.
pub fn over(a: impl Into<Formula>, b: impl Into<Formula>) -> Formula {
    Formula::Quotient(Box::new(a.into()), Box::new(b.into()))
}

/// a − b.
pub fn minus(a: impl Into<Formula>, b: impl Into<Formula>) -> Formula {
    Formula::Sum(vec![a.into(), -b.into()])
}

/// a + b.
pub fn plus(a: impl Into<Formula>, b: impl Into<Formula>) -> Formula {
    Formula::Sum(vec![a.into(), b.into()])
}

/// A product. It's 0 if a factor is 0. Factors that are 1 are left out.
pub fn times(factors: impl IntoIterator<Item = Formula>) -> Formula {
    let mut negative = false;
    let mut kept = Vec::new();
    for factor in factors {
        let factor = match factor {
            Formula::Negative(inner) => {
                negative = !negative;
                *inner
            }
            factor => factor,
        };
        match factor {
            Formula::Number(0.0) => return Formula::Number(0.0),
            Formula::Number(1.0) => {}
            Formula::Product(inner) => kept.extend(inner),
            factor => kept.push(factor),
        }
    }
    let product = match kept.len() {
        0 => Formula::Number(1.0),
        1 => kept.swap_remove(0),
        _ => Formula::Product(kept),
    };
    if negative { -product } else { product }
}

/// A sum. Zeros are left out.
pub fn sum(terms: impl IntoIterator<Item = Formula>) -> Formula {
    let mut kept: Vec<Formula> = Vec::new();
    for term in terms {
        match term {
            Formula::Number(0.0) => {}
            Formula::Sum(inner) => kept.extend(inner),
            term => kept.push(term),
        }
    }
    match kept.len() {
        0 => Formula::Number(0.0),
        1 => kept.swap_remove(0),
        _ => Formula::Sum(kept),
    }
}

/// The components of a vector.
pub(super) fn components(vector: Vector) -> [Formula; 3] {
    Component::THREE.map(|c| match vector {
        Vector::Axis(axis) => Symbol::Axis(axis, c).into(),
        Vector::Position => Symbol::Position(c).into(),
        Vector::ToFocalPoint => minus(Symbol::FocalPoint(c), Symbol::Position(c)),
        Vector::UpCrossNormal => {
            let (up, n) = (Symbol::ViewUp, |c| Symbol::Axis(Axis::N, c));
            cross(|c| up(c).into(), |c| n(c).into(), c)
        }
    })
}

/// A component of a cross product.
pub(super) fn cross(
    a: impl Fn(Component) -> Formula,
    b: impl Fn(Component) -> Formula,
    component: Component,
) -> Formula {
    let (next, last) = match component {
        Component::X => (Component::Y, Component::Z),
        Component::Y => (Component::Z, Component::X),
        Component::Z | Component::W => (Component::X, Component::Y),
    };
    sum([times([a(next), b(last)]), -times([a(last), b(next)])])
}

impl std::ops::Neg for Formula {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Negative(inner) => *inner,
            Self::Number(0.0) => Self::Number(0.0),
            other => Self::Negative(Box::new(other)),
        }
    }
}

impl Formula {
    /// Its number in a setting, in plain `f64`; NaN if the setting lacks a symbol (a point that wasn't given).
    pub fn value(&self, setting: &Setting<'_>) -> f64 {
        match self {
            Self::Number(number) => *number,
            Self::Symbol(symbol) => setting.value(*symbol),
            Self::Named(named) => named.value,
            Self::Negative(inner) => 0.0 - inner.value(setting),
            Self::Sum(terms) => terms.iter().map(|term| term.value(setting)).sum::<f64>() + 0.0,
            Self::Product(factors) => factors.iter().map(|factor| factor.value(setting)).product(),
            Self::Quotient(above, below) => above.value(setting) / below.value(setting),
            Self::Dot(a, b) => {
                let products = components(*a).into_iter().zip(components(*b));
                products.map(|(a, b)| a.value(setting) * b.value(setting)).sum::<f64>() + 0.0
            }
            Self::Norm(vector) => {
                // The greatest component is factored out, because squares of 1e-200 would be 0.
                let components = components(*vector).map(|c| c.value(setting).abs());
                let greatest = components.iter().fold(0.0_f64, |greatest, c| greatest.max(*c));
                if greatest == 0.0 {
                    return 0.0;
                }
                greatest * components.iter().map(|c| (c / greatest) * (c / greatest)).sum::<f64>().sqrt()
            }
            Self::Of(function, argument) => {
                let x = argument.value(setting);
                let angle = || Angle::from_degrees(x).sin_cos();
                match function {
                    Function::Sine => angle().0,
                    Function::Cosine => angle().1,
                    Function::Tangent => angle().0 / angle().1,
                    Function::Floor => x.floor(),
                    Function::Root => x.sqrt(),
                    Function::ArcTangent => x.atan().to_degrees(),
                }
            }
        }
    }

    /// The greatest number added or subtracted in computing its value. It's the scale for rounding errors of the value.
    pub fn magnitude(&self, setting: &Setting<'_>) -> f64 {
        match self {
            Self::Number(_) | Self::Symbol(_) | Self::Named(_) | Self::Norm(_) => self.value(setting).abs(),
            Self::Negative(inner) => inner.magnitude(setting),
            Self::Sum(terms) => terms.iter().map(|term| term.magnitude(setting)).fold(0.0, f64::max),
            Self::Product(factors) => factors.iter().map(|factor| factor.magnitude(setting)).product(),
            Self::Quotient(above, below) => {
                let quotient = below.value(setting).abs();
                above.magnitude(setting) / quotient * (below.magnitude(setting) / quotient).max(1.0)
            }
            Self::Dot(a, b) => {
                let products = components(*a).into_iter().zip(components(*b));
                products.map(|(a, b)| a.magnitude(setting) * b.magnitude(setting)).fold(0.0, f64::max)
            }
            Self::Of(_, argument) => self.value(setting).abs().max(argument.magnitude(setting)),
        }
    }

    /// The formula with some parts replaced: `replace` gives what stands in the place of a part, or `None` to look
    /// inside it.
    #[must_use]
    pub fn replaced(&self, replace: &impl Fn(&Self) -> Option<Self>) -> Self {
        let inside = |part: &Self| part.replaced(replace);
        replace(self).unwrap_or_else(|| match self {
            Self::Number(_) | Self::Symbol(_) | Self::Named(_) | Self::Dot(..) | Self::Norm(_) => self.clone(),
            Self::Negative(inner) => -inside(inner),
            Self::Sum(terms) => Self::Sum(terms.iter().map(inside).collect()),
            Self::Product(factors) => Self::Product(factors.iter().map(inside).collect()),
            Self::Quotient(above, below) => over(inside(above), inside(below)),
            Self::Of(function, argument) => Self::Of(*function, Box::new(inside(argument))),
        })
    }

    /// The summands: the terms of a sum or of a dot product, else the formula itself.
    #[must_use]
    pub fn terms(&self) -> Vec<Self> {
        match self {
            Self::Sum(terms) => terms.iter().flat_map(Self::terms).collect(),
            Self::Dot(a, b) => {
                let pairs = components(*a).into_iter().zip(components(*b));
                pairs.map(|(a, b)| Self::Product(vec![a, b])).collect()
            }
            Self::Negative(inner) => inner.terms().into_iter().map(|term| -term).collect(),
            other => vec![other.clone()],
        }
    }

    /// Its symbols, each once, in reading order. Vectors are given as their components.
    pub fn symbols(&self) -> Vec<Symbol> {
        let mut found = Vec::new();
        self.collect(&mut found);
        found
    }

    fn collect(&self, found: &mut Vec<Symbol>) {
        match self {
            Self::Number(_) | Self::Named(_) => {}
            Self::Symbol(symbol) => {
                if !found.contains(symbol) {
                    found.push(*symbol);
                }
            }
            Self::Negative(inner) | Self::Of(_, inner) => inner.collect(found),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().for_each(|part| part.collect(found)),
            Self::Quotient(above, below) => {
                above.collect(found);
                below.collect(found);
            }
            Self::Dot(a, b) => {
                for vector in [a, b] {
                    components(*vector).iter().for_each(|component| component.collect(found));
                }
            }
            Self::Norm(vector) => components(*vector).iter().for_each(|component| component.collect(found)),
        }
    }
}
