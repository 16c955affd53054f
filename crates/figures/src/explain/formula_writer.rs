//! Formulas as text and as LaTeX, with the notes' symbols or with numbers in their place.

use super::formula::components;
use super::{Formula, Function, Named, Setting, Symbol};
use crate::numbers::{DecimalMark, exact_form};

/// A notation for mathematics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// One line of Unicode: `2F/(r − l)`.
    Text,
    /// LaTeX: `\frac{2F}{r - l}`.
    Latex,
}

/// The numbers that replace symbols, and their notation.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'a> {
    /// The numbers of the symbols.
    pub setting: &'a Setting<'a>,
    /// Significant digits.
    pub digits: usize,
    /// Writes 1/√3 for 0.57735 if a number is a fraction or a root.
    pub exact: bool,
}

/// Writes formulas.
#[derive(Clone, Copy, Debug)]
pub struct Writer<'a> {
    /// As text or LaTeX.
    pub notation: Notation,
    /// The decimal mark, also for numbers among symbols, such as the 0.5 of i + 0.5.
    pub mark: DecimalMark,
    /// Numbers instead of symbols.
    pub numbers: Option<Numbers<'a>>,
}

/// Binding strength of a formula. If it binds less tightly than its place requires, it gets parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    Sum,
    Negative,
    Product,
    Atom,
}

impl Writer<'_> {
    /// The formula as text.
    pub fn write(&self, formula: &Formula) -> String {
        self.at(formula, Strength::Sum)
    }

    /// A number in this writer's notation. The minus in text is a true minus sign.
    pub fn number(&self, value: f64) -> String {
        let mark = self.mark;
        let (digits, exact) = self.numbers.map_or((6, false), |numbers| (numbers.digits, numbers.exact));
        let form = exact.then(|| exact_form(value)).flatten();
        match (self.notation, form) {
            (Notation::Text, Some(form)) => form.text(),
            (Notation::Latex, Some(form)) => form.latex(),
            (Notation::Text, None) => mark.number(value, digits),
            (Notation::Latex, None) => latex_number(&mark.number(value, digits)),
        }
    }

    fn is_latex(&self) -> bool {
        self.notation == Notation::Latex
    }

    fn at(&self, formula: &Formula, place: Strength) -> String {
        let (text, strength) = self.bare(formula);
        if strength >= place {
            text
        } else if self.is_latex() {
            format!(r"\left({text}\right)")
        } else {
            format!("({text})")
        }
    }

    fn bare(&self, formula: &Formula) -> (String, Strength) {
        match formula {
            Formula::Number(number) => self.valued(*number),
            Formula::Symbol(symbol) => self.symbol(*symbol),
            Formula::Named(named) => self.named(*named),
            Formula::Negative(inner) => {
                let minus = if self.is_latex() { "-" } else { "−" };
                (format!("{minus}{}", self.at(inner, Strength::Product)), Strength::Negative)
            }
            Formula::Sum(terms) => (self.sum(terms), Strength::Sum),
            Formula::Product(factors) => (self.product(factors), Strength::Product),
            Formula::Quotient(above, below) if self.is_latex() => {
                let fraction = format!(r"\frac{{{}}}{{{}}}", self.write(above), self.write(below));
                (fraction, Strength::Product)
            }
            Formula::Quotient(above, below) => {
                let mut above_text = self.at(above, Strength::Product);
                // The number of a symbol may be a fraction itself.
                if !matches!(**above, Formula::Product(_))
                    && self.bare(above).0.contains('/')
                    && !above_text.starts_with('(')
                {
                    above_text = format!("({above_text})");
                }
                (format!("{above_text}/{}", self.at(below, Strength::Atom)), Strength::Product)
            }
            Formula::Dot(a, b) if self.numbers.is_none() => {
                let dot = if self.is_latex() {
                    format!(r"{} \cdot {}", a.latex(), b.latex())
                } else {
                    format!("{} · {}", a.text(), b.text())
                };
                (dot, Strength::Product)
            }
            Formula::Dot(..) => (self.sum(&formula.terms()), Strength::Sum),
            Formula::Norm(vector) if self.numbers.is_none() => {
                let norm = if self.is_latex() {
                    format!(r"\left\|{}\right\|", vector.latex())
                } else {
                    format!("‖{}‖", vector.text())
                };
                (norm, Strength::Atom)
            }
            Formula::Norm(vector) => (self.root_of_squares(&components(*vector)), Strength::Atom),
            Formula::Of(function, argument) => (self.of(*function, argument), Strength::Atom),
        }
    }

    /// Negative numbers need parentheses, as a minus does.
    fn valued(&self, value: f64) -> (String, Strength) {
        let text = self.number(value);
        let negative = text.starts_with(['−', '-']);
        let compound = text.contains(['/', '√']) || text.contains('\\') || text.contains(['e', '×']);
        let strength = match (negative, compound) {
            (true, _) => Strength::Negative,
            (false, true) => Strength::Product,
            (false, false) => Strength::Atom,
        };
        (text, strength)
    }

    fn symbol(&self, symbol: Symbol) -> (String, Strength) {
        let Some(numbers) = self.numbers else {
            let name = if self.is_latex() { symbol.latex() } else { symbol.text() };
            return (name, Strength::Atom);
        };
        self.measured(numbers, numbers.setting.value(symbol), numbers.setting.angle(symbol).is_some())
    }

    fn named(&self, named: Named) -> (String, Strength) {
        match self.numbers {
            Some(numbers) => self.measured(numbers, named.value, named.is_angle),
            None => ((if self.is_latex() { named.latex } else { named.text }).to_owned(), Strength::Atom),
        }
    }

    /// A number, with the degree sign if it's an angle.
    fn measured(&self, numbers: Numbers<'_>, value: f64, is_angle: bool) -> (String, Strength) {
        let (text, strength) = self.valued(value);
        if !is_angle {
            return (text, strength);
        }
        let degrees = self.mark.number(value, numbers.digits);
        let text =
            if self.is_latex() { format!(r"{}^{{\circ}}", latex_number(&degrees)) } else { format!("{degrees}°") };
        (text, strength)
    }

    fn sum(&self, terms: &[Formula]) -> String {
        let minus = if self.is_latex() { " - " } else { " − " };
        let mut text = String::new();
        for (i, term) in terms.iter().enumerate() {
            match term {
                Formula::Negative(inner) if i > 0 => {
                    text.push_str(minus);
                    text.push_str(&self.at(inner, Strength::Product));
                }
                term if i > 0 => {
                    text.push_str(" + ");
                    text.push_str(&self.at(term, Strength::Product));
                }
                term => text.push_str(&self.at(term, Strength::Negative)),
            }
        }
        text
    }

    /// Numbers are separated by a dot, and so is anything before one. Symbols of one letter stand side by side.
    fn product(&self, factors: &[Formula]) -> String {
        let single = |formula: &Formula| match formula {
            Formula::Number(_) => true,
            Formula::Symbol(symbol) => symbol.text().chars().count() == 1,
            Formula::Named(named) => named.text.chars().count() == 1,
            _ => false,
        };
        // A number behind a symbol would read as an index.
        let apart = self.numbers.is_some() || factors.iter().skip(1).any(|f| matches!(f, Formula::Number(_)));
        let between = match (apart, self.is_latex()) {
            (true, true) => r" \cdot ",
            (true, false) => "·",
            (false, _) if factors.iter().all(single) && !self.is_latex() => "",
            (false, _) => " ",
        };
        let written = factors.iter().enumerate().map(|(i, factor)| {
            let place = match factor {
                // a/b c would read as a/(b c).
                Formula::Quotient(..) if self.is_latex() => Strength::Product,
                Formula::Quotient(..) | Formula::Number(_) if i == 0 && factors.len() == 1 => Strength::Product,
                _ => Strength::Atom,
            };
            self.at(factor, place)
        });
        written.collect::<Vec<_>>().join(between)
    }

    fn root_of_squares(&self, components: &[Formula; 3]) -> String {
        let square = if self.is_latex() { "^2" } else { "²" };
        let squares = components.iter().map(|c| format!("{}{square}", self.at(c, Strength::Atom)));
        let sum = squares.collect::<Vec<_>>().join(" + ");
        if self.is_latex() { format!(r"\sqrt{{{sum}}}") } else { format!("√({sum})") }
    }

    fn of(&self, function: Function, argument: &Formula) -> String {
        let inner = self.write(argument);
        let (text, latex) = match function {
            Function::Sine => ("sin", r"\sin"),
            Function::Cosine => ("cos", r"\cos"),
            Function::Tangent => ("tan", r"\tan"),
            Function::Floor if self.is_latex() => return format!(r"\left\lfloor {inner} \right\rfloor"),
            Function::Floor => return format!("⌊{inner}⌋"),
            Function::Root if self.is_latex() => return format!(r"\sqrt{{{inner}}}"),
            Function::Root => ("√", r"\sqrt"),
            Function::ArcTangent => ("atan", r"\arctan"),
        };
        if self.is_latex() { format!(r"{latex}\left({inner}\right)") } else { format!("{text}({inner})") }
    }
}

/// A printed number in LaTeX. A decimal comma keeps no space behind it, and a power of ten is one.
fn latex_number(printed: &str) -> String {
    let plain = printed.replace('−', "-").replace(',', "{,}");
    match plain.split_once('e') {
        Some((mantissa, exponent)) => format!(r"{mantissa} \cdot 10^{{{exponent}}}"),
        None => plain,
    }
}
