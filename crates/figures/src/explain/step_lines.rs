//! The steps of a point's way as text: each row with its symbols, with its numbers, and its value.

use super::{Formula, Notation, Numbers, Setting, Step, Writer};
use crate::numbers::DecimalMark;

/// The style of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// As text or LaTeX.
    pub notation: Notation,
    /// The decimal mark.
    pub mark: DecimalMark,
    /// Significant digits.
    pub digits: usize,
}

/// A row of a step: `symbol` = `formula` = `numbers` = `value`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The computed symbol.
    pub symbol: String,
    /// The formula in symbols.
    pub formula: String,
    /// The formula with numbers.
    pub numbers: String,
    /// The right side, with the digits of the window.
    pub value: String,
}

impl Step {
    /// The rows of the step. `setting` is the one of the trace.
    pub fn lines(&self, setting: &Setting<'_>, style: Style) -> Vec<Line> {
        let setting = &self.setting(setting);
        let Style { notation, mark, digits } = style;
        let symbols = Writer { notation, mark, numbers: None };
        let numbers = Writer { notation, mark, numbers: Some(Numbers { setting, digits, exact: false }) };
        let rows = self.symbols.iter().zip(&self.formulas).zip(&self.output);
        rows.map(|((symbol, formula), value)| Line {
            symbol: symbols.write(&Formula::Symbol(*symbol)),
            formula: symbols.write(formula),
            numbers: numbers.write(formula),
            value: numbers.number(*value),
        })
        .collect()
    }
}

/// A way as text or as LaTeX (`aligned`), a block for each step. `name` names the spaces.
pub fn written(steps: &[Step], setting: &Setting<'_>, style: Style, name: impl Fn(&str) -> String) -> String {
    let blocks = steps.iter().map(|step| {
        let (from, to, equation) = (name(step.from), name(step.to), &step.equation);
        let heading = format!("{from} → {to}  {equation}");
        let lines = step.lines(setting, style);
        match style.notation {
            Notation::Text => {
                let rows = lines.into_iter().map(|line| {
                    let Line { symbol, formula, numbers, value } = line;
                    let last = if numbers == value { String::new() } else { format!(" = {value}") };
                    format!("  {symbol} = {formula}\n    = {numbers}{last}\n")
                });
                format!("{heading}\n{}", rows.collect::<String>())
            }
            Notation::Latex => format!("% {heading}\n\\[{}\\]\n", aligned(&lines)),
        }
    });
    blocks.collect::<Vec<_>>().join("\n")
}

/// Rows in LaTeX, with their equals signs below one another.
pub fn aligned(lines: &[Line]) -> String {
    let rows: Vec<String> = lines
        .iter()
        .map(|Line { symbol, formula, numbers, value }| {
            let last = if numbers == value { String::new() } else { format!(" = {value}") };
            format!("{symbol} &= {formula} \\\\\n &= {numbers}{last}")
        })
        .collect();
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", rows.join(" \\\\\n"))
}
