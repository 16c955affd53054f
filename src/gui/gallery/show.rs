//! The gallery on the screen.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Align2, Color32, EventFilter, FontSelection, Id, Key, Layout, Modifiers, Rect, Response, RichText,
    ScrollArea, Sense, Stroke, StrokeKind, TextWrapMode, Ui, Vec2, WidgetInfo, WidgetText, pos2, vec2,
};

use super::card::SIZE;
use super::{Gallery, Part, Source};
use crate::appearance::Theme;
use crate::gui::tooltip::Explained;
use crate::i18n::Lang;
use crate::i18n::gallery::{self as words, Texts};
use crate::sanitize;

/// An action after a frame.
pub(in crate::gui) enum Chosen {
    /// Go on with this figure.
    Open(Source),
    /// Close it.
    Nothing,
    /// Ask for a folder.
    Folder,
}

/// Around the picture of a card, in points.
const MARGIN: f32 = 6.0;
/// Under the picture of a card: its name, and a few lines.
const TEXT: f32 = 66.0;
/// Between cards.
const GAP: f32 = 8.0;

fn picture_size() -> Vec2 {
    #[expect(clippy::cast_precision_loss, reason = "some hundred")]
    let size = vec2(SIZE.width as f32, SIZE.height as f32);
    size
}

fn card_size() -> Vec2 {
    picture_size() + vec2(2.0 * MARGIN, 2.0 * MARGIN + TEXT)
}

/// Shows the gallery in a theme and a language; `first`: it has just been opened.
pub(in crate::gui) fn show(ui: &mut Ui, gallery: &mut Gallery, style: (Theme, Lang), first: bool) -> Option<Chosen> {
    let t = words::texts(style.1);
    let mut asked = None;
    let before = gallery.part;
    ui.horizontal(|ui| {
        ui.heading(t.gallery);
        ui.add_space(12.0);
        // A page in a browser has no folders.
        if !gallery.examples_alone {
            parts(ui, t, &mut gallery.part);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if gallery.part == Part::Folder && ui.button(t.choose).clicked() {
                asked = Some(Chosen::Folder);
            }
            if let (Part::Folder, Some(folder)) = (gallery.part, &gallery.folder) {
                ui.add(eframe::egui::Label::new(RichText::new(sanitize::path(folder)).weak()).truncate());
            }
        });
    });
    let (sources, more) = gallery.sources();
    gallery.go_on(ui.ctx(), style, &sources);
    ui.add_space(6.0);
    let height = (ui.ctx().content_rect().height() - 130.0).max(120.0);
    let area = ScrollArea::vertical().id_salt(gallery.part).max_height(height).min_scrolled_height(height);
    gallery.wants_focus |= first || before != gallery.part;
    area.auto_shrink(false).show(ui, |ui| {
        if let Some(source) = cards(ui, t, gallery, &sources, style.1) {
            asked = Some(Chosen::Open(source));
        }
        if more > 0 {
            ui.label(format!("{} {more}", t.more));
        }
    });
    ui.horizontal(|ui| {
        // A finger has no Esc.
        if ui.button(t.close).clicked() {
            asked = Some(Chosen::Nothing);
        }
        let keys = if gallery.examples_alone { t.keys_of_one } else { t.keys };
        ui.label(RichText::new(keys).small().weak());
    });
    asked
}

/// The names of the parts; Ctrl+Tab goes to the next one.
fn parts(ui: &mut Ui, t: &Texts, part: &mut Part) {
    for of in Part::ALL {
        let name = match of {
            Part::Examples => t.examples,
            Part::Recent => t.recent,
            Part::Folder => t.folder,
        };
        ui.selectable_value(part, of, name);
    }
    if ui.input_mut(|input| input.consume_key(Modifiers::CTRL, Key::Tab)) {
        *part = Part::ALL[(*part as usize + 1) % Part::ALL.len()];
    }
}

/// The cards in rows; the figure of the one that was pressed.
fn cards(ui: &mut Ui, t: &Texts, gallery: &mut Gallery, sources: &[Source], lang: Lang) -> Option<Source> {
    if sources.is_empty() {
        let text = match (gallery.part, &gallery.files) {
            (Part::Folder, Err(why)) => why.as_str(),
            (Part::Folder, Ok(_)) if gallery.folder.is_some() => t.empty_folder,
            (Part::Folder, Ok(_)) => t.no_folder,
            (Part::Recent | Part::Examples, _) => t.no_recent,
        };
        ui.label(text);
        return None;
    }
    let mut focus = std::mem::take(&mut gallery.wants_focus);
    let card = card_size();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful of columns")]
    let columns = (((ui.available_width() + GAP) / (card.x + GAP)) as usize).max(1);
    let part = gallery.part;
    let chosen = gallery.chosen[part as usize].min(sources.len() - 1);
    let id = |index: usize| Id::unique(("gallery card", part, index));
    let mut next = chosen;
    if ui.memory(|memory| memory.has_focus(id(chosen))) {
        next = moved(ui, chosen, columns, sources.len());
        focus |= next != chosen;
    }
    gallery.chosen[part as usize] = next;
    let mut open = None;
    ui.spacing_mut().item_spacing = vec2(GAP, GAP);
    for (row, line) in sources.chunks(columns).enumerate() {
        ui.horizontal(|ui| {
            for (column, source) in line.iter().enumerate() {
                let index = row * columns + column;
                let (_, rect) = ui.allocate_space(card);
                let response = ui.interact(rect, id(index), Sense::click());
                paint(ui, t, gallery, source, (rect, &response, lang));
                if index == next && focus {
                    response.request_focus();
                    response.scroll_to_me(None);
                }
                if response.gained_focus() {
                    gallery.chosen[part as usize] = index;
                }
                if response.has_focus() {
                    let arrows =
                        EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
                    ui.memory_mut(|memory| memory.set_focus_lock_filter(id(index), arrows));
                }
                if response.clicked() {
                    open = Some(source.clone());
                }
            }
        });
    }
    open
}

/// The card that the arrow keys lead to.
fn moved(ui: &Ui, from: usize, columns: usize, count: usize) -> usize {
    let last = count - 1;
    ui.input(|input| {
        let mut at = from;
        for (key, step) in [(Key::ArrowRight, 1), (Key::ArrowDown, columns)] {
            at = if input.key_pressed(key) { (at + step).min(last) } else { at };
        }
        for (key, step) in [(Key::ArrowLeft, 1), (Key::ArrowUp, columns)] {
            at = if input.key_pressed(key) { at.checked_sub(step).unwrap_or(at) } else { at };
        }
        match (input.key_pressed(Key::Home), input.key_pressed(Key::End)) {
            (true, _) => 0,
            (_, true) => last,
            (false, false) => at,
        }
    })
}

fn paint(ui: &Ui, t: &Texts, gallery: &Gallery, source: &Source, (rect, response, lang): (Rect, &Response, Lang)) {
    let title = sanitize::escaped(&source.title(lang));
    let card = gallery.cards.get(source);
    let gone = matches!(source, Source::File(path) if gallery.part == Part::Recent && gallery.gone.contains(path));
    let fault = card.map_or("", |card| &card.fault);
    let own = card.and_then(|card| card.sentence.as_deref());
    let sentence = match (source, own) {
        (Source::File(path), _) if gone => format!("{} {}", sanitize::path(path), t.gone),
        (_, Some(own)) if !fault.is_empty() => format!("{fault} {own}").trim_end().to_owned(),
        (Source::File(path), Some("")) => sanitize::path(path),
        (_, own) => own.unwrap_or_default().to_owned(),
    };
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{title}: {sentence}")));
    let (visuals, painter) = (ui.visuals(), ui.painter());
    let look = ui.style().interact(response);
    painter.rect_filled(rect, 4.0, if response.hovered() { look.weak_bg_fill } else { visuals.extreme_bg_color });
    let border = if response.has_focus() {
        Stroke::new(2.0, visuals.hyperlink_color)
    } else {
        visuals.widgets.noninteractive.bg_stroke
    };
    painter.rect_stroke(rect, 4.0, border, StrokeKind::Inside);
    let picture = Rect::from_min_size(rect.min + Vec2::splat(MARGIN), picture_size());
    if let Some(texture) = card.and_then(|card| card.texture.as_ref()).filter(|_| !gone) {
        painter.image(texture.id(), picture, Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0)), Color32::WHITE);
    } else {
        let sign = if gone || !fault.is_empty() { "⚠" } else { "…" };
        let font = FontSelection::Default.resolve(ui.style());
        painter.text(picture.center(), Align2::CENTER_CENTER, sign, font, visuals.weak_text_color());
    }
    let line = |text: RichText, width: f32, mode| {
        WidgetText::from(text).into_galley(ui, Some(mode), width, FontSelection::Default)
    };
    let width = picture.width();
    let name = line(RichText::new(title).strong(), width, TextWrapMode::Truncate);
    let below = picture.left_bottom() + vec2(0.0, 3.0);
    let lower = below + vec2(0.0, name.size().y);
    painter.galley(below, name, visuals.text_color());
    let words = line(RichText::new(sanitize::within(&sentence, 120)).small(), width, TextWrapMode::Wrap);
    let painter = painter.with_clip_rect(rect.shrink(1.0).intersect(ui.clip_rect()));
    painter.galley(lower, words, visuals.text_color());
    if !sentence.is_empty() {
        response.clone().explained(sentence);
    }
}
