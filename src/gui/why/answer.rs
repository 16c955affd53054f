//! The explanation of an entry: its formula, its numbers, its value, and the definitions of its symbols, down to the
//! parameters.

use eframe::egui::{self, RichText, Role, Sense, Ui, WidgetInfo, vec2};

use super::measures;
use crate::explain::{Definition, Formula, Notation, Numbers, Setting, Symbol, Writer, definition};
use crate::gui::kit::{Both, Formula as Typeset, Links, chain, help_topic};
use camera_lab_words::why::explain::Texts;
use camera_lab_words::why::{explain as words, notes};

/// The type size of formulas, in points.
const SIZE: f32 = 14.0;

/// The number format of the explanations.
#[derive(Clone, Copy)]
pub(super) struct Writing<'a> {
    pub(super) setting: &'a Setting<'a>,
    pub(super) lang: camera_lab_words::Lang,
    pub(super) digits: usize,
}

impl Writing<'_> {
    fn writer(&self, notation: Notation, numbers: bool, exact: bool) -> Writer<'_> {
        let (setting, mark, digits) = (self.setting, self.lang.mark(), self.digits);
        Writer { notation, mark, numbers: numbers.then_some(Numbers { setting, digits, exact }) }
    }

    fn both(&self, numbers: bool, exact: bool, write: impl Fn(&Writer<'_>) -> String) -> Both {
        let of = |notation| write(&self.writer(notation, numbers, exact));
        Both { latex: of(Notation::Latex), text: of(Notation::Text) }
    }

    /// With symbols.
    pub(super) fn formula(&self, formula: &Formula) -> Both {
        self.both(false, false, |writer| writer.write(formula))
    }

    /// With numbers in place of symbols.
    pub(super) fn numbers(&self, formula: &Formula) -> Both {
        self.both(true, true, |writer| writer.write(formula))
    }

    /// A value. If it's a fraction or a root, in that form.
    pub(super) fn value(&self, value: f64) -> Both {
        self.both(true, true, |writer| writer.number(value))
    }

    /// A value. If it's a fraction or a root, that and its decimals.
    pub(super) fn whole_value(&self, value: f64) -> Both {
        let decimals = self.both(true, false, |writer| writer.number(value));
        if crate::numbers::exact_form(value).is_none() {
            return decimals;
        }
        let exact = self.value(value);
        Both {
            latex: format!(r"{} \approx {}", exact.latex, decimals.latex),
            text: format!("{} ≈ {}", exact.text, decimals.text),
        }
    }

    /// The value of a symbol, with a degree sign if it's an angle.
    fn symbol_value(&self, symbol: Symbol) -> Both {
        if self.setting.angle(symbol).is_some() {
            return self.both(true, true, |writer| writer.write(&symbol.into()));
        }
        self.whole_value(self.setting.value(symbol))
    }
}

/// Shows the explanation. Returns the measures to highlight in the world besides that of the entry itself.
pub(super) fn show(
    ui: &mut Ui,
    writing: Writing<'_>,
    name: &Both,
    (formula, value): (&Formula, f64),
    state: &mut camera_lab_desk::Matrices,
) -> Option<Symbol> {
    let said = [writing.formula(formula), writing.numbers(formula), writing.whole_value(value)];
    chain(ui, name, &said, Links::Below);
    let symbols = formula.symbols();
    if symbols.is_empty() {
        ui.label(RichText::new(words::texts(writing.lang).constant).weak());
        return None;
    }
    ui.add_space(4.0);
    let t = words::texts(writing.lang);
    ui.label(RichText::new(t.made_of).small().weak());
    let mut tree = AnswerTree { writing, t, open: &mut state.open, pointed: None };
    for symbol in symbols {
        tree.symbol(ui, &mut vec![symbol]);
    }
    tree.pointed
}

/// A term of a sum: formula = numbers = value.
pub(super) fn term(ui: &mut Ui, writing: Writing<'_>, term: &Formula, value: f64) {
    let (formula, numbers) = (writing.formula(term), writing.both(true, false, |writer| writer.write(term)));
    chain(ui, &formula, &[numbers, writing.whole_value(value)], Links::Below);
}

/// A symbol = its definition = numbers = value.
pub(super) fn of_symbol(ui: &mut Ui, writing: Writing<'_>, symbol: Symbol) {
    let name = Both { latex: symbol.latex(), text: symbol.text() };
    let value = writing.symbol_value(symbol);
    ui.push_id(symbol, |ui| match definition(symbol, writing.setting) {
        Some(Definition { formula, .. }) => {
            chain(ui, &name, &[writing.formula(&formula), writing.numbers(&formula), value], Links::Below);
        }
        None => chain(ui, &name, &[value], Links::Below),
    });
}

/// The definitions of symbols, each opened by a click.
struct AnswerTree<'a> {
    writing: Writing<'a>,
    t: &'static Texts,
    open: &'a mut std::collections::BTreeSet<Vec<Symbol>>,
    /// The one under the pointer, or with the keyboard.
    pointed: Option<Symbol>,
}

impl AnswerTree<'_> {
    /// The last symbol of a path, and its definition below it.
    fn symbol(&mut self, ui: &mut Ui, path: &mut Vec<Symbol>) {
        let Some(&symbol) = path.last() else { return };
        let definition = definition(symbol, self.writing.setting);
        let is_open = self.open.contains(path);
        if self.row(ui, symbol, definition.as_ref().map(|_| is_open)) && definition.is_some() && !self.open.remove(path)
        {
            self.open.insert(path.clone());
        }
        let Some(definition) = definition.filter(|_| is_open) else { return };
        ui.indent(("symbol", path.len(), symbol.text()), |ui| {
            self.definition(ui, symbol, &definition);
            for next in definition.formula.symbols() {
                // None leads to itself.
                if !path.contains(&next) {
                    path.push(next);
                    self.symbol(ui, path);
                    path.pop();
                }
            }
        });
    }

    fn definition(&self, ui: &mut Ui, symbol: Symbol, definition: &Definition) {
        of_symbol(ui, self.writing, symbol);
        if !definition.equation.is_empty() {
            let place = ui.label(RichText::new(format!("[0] {}", definition.equation)).small().weak());
            if let Some(note) = notes::of_equation(definition.equation) {
                help_topic(&place, note);
            }
        }
    }

    /// A symbol with its value and meaning. Returns true if it was clicked. `open` is true if its definition is open,
    /// if it has one.
    fn row(&mut self, ui: &mut Ui, symbol: Symbol, open: Option<bool>) -> bool {
        let value = self.writing.symbol_value(symbol);
        let (latex, text) =
            (format!("{} = {}", symbol.latex(), value.latex), format!("{} = {}", symbol.text(), value.text));
        let meaning = words::symbol(self.writing.lang, symbol);
        ui.horizontal_wrapped(|ui| {
            let formula = Typeset::new(ui, &latex, &text, SIZE - 1.0);
            let size = formula.size() + vec2(20.0, 4.0);
            let (place, response) = ui.allocate_exact_size(size, Sense::click());
            help_topic(&response, notes::of_symbol(symbol));
            if response.hovered() || response.has_focus() {
                ui.painter().rect_filled(place, 3.0, ui.visuals().widgets.hovered.bg_fill);
                self.pointed = Some(symbol);
            }
            let sign = match open {
                None => "•",
                Some(true) => "▾",
                Some(false) => "▸",
            };
            let font = egui::TextStyle::Body.resolve(ui.style());
            let color = ui.visuals().weak_text_color();
            ui.painter().text(place.left_center() + vec2(3.0, 0.0), egui::Align2::LEFT_CENTER, sign, font, color);
            formula.paint(ui.painter(), place.min + vec2(16.0, 2.0), ui.visuals().text_color());
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, open == Some(true), &text));
            let more = if open.is_some() { "" } else { self.t.parameter };
            ui.label(RichText::new(format!("{meaning} {more}")).small().weak());
            response.clicked()
        })
        .inner
    }
}

/// The measures to highlight in the world: that of a symbol, or of an entry.
pub(super) fn lights(formula: &Formula, pointed: Option<Symbol>) -> Vec<crate::figure::Measured> {
    pointed.map_or_else(|| measures::of_formula(formula), |symbol| measures::of_symbol(symbol).into_iter().collect())
}
