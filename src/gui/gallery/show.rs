//! The gallery on the screen.

use std::ops::Range;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Align2, Color32, Event, EventFilter, FontSelection, Id, Key, Label, Layout, Modifiers, Rect, Response,
    RichText, ScrollArea, Sense, Stroke, StrokeKind, TextStyle, TextWrapMode, Ui, Vec2, WidgetInfo, WidgetText, pos2,
    vec2,
};

use super::card::SIZE;
use super::{Gallery, Part};
use crate::gui::kit::{Explained, TextField, theme, with_room_before};
use crate::sanitize;
use camera_lab_desk::Source;
use camera_lab_files::{ShippedFigure, Topic};
use camera_lab_words::Lang;
use camera_lab_words::window::gallery::Texts;
use camera_lab_words::window::search::also_called;
use camera_lab_words::window::{self, gallery as words};

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
/// Below the picture of a card: its name, and a few lines.
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

/// Shows the gallery in a theme and a language. `first` is true when it has just been opened.
pub(in crate::gui) fn show(
    ui: &mut Ui,
    gallery: &mut Gallery,
    style: (crate::appearance::Theme, Lang),
    first: bool,
) -> Option<Chosen> {
    let t = words::texts(style.1);
    let mut asked = None;
    let before = gallery.part;
    ui.horizontal(|ui| {
        ui.heading(t.gallery);
        ui.add_space(12.0);
        // A page in a browser has no folders.
        if !gallery.examples_alone {
            parts(ui, t, &mut gallery.part);
            ui.add_space(12.0);
        }
        asked = search(ui, t, gallery);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if gallery.part == Part::Folder && ui.button(t.choose).clicked() {
                asked = Some(Chosen::Folder);
            }
            if let (Part::Folder, Some(folder)) = (gallery.part, &gallery.folder) {
                ui.add(Label::new(RichText::new(sanitize::path(folder)).weak()).truncate());
            }
        });
    });
    let (mut sources, more) = gallery.sources();
    gallery.go_on(ui.ctx(), style, &sources);
    let is_searched = !gallery.wanted.trim().is_empty();
    if is_searched {
        let called = also_called(&gallery.wanted);
        sources.retain(|source| gallery.rank(source, &called).is_some());
        sources.sort_by_key(|source| gallery.rank(source, &called));
    }
    ui.add_space(6.0);
    let top = ui.cursor().top();
    let goes_to = if is_searched { None } else { headings(ui, t.lang, &sources) };
    gallery.shows_limits |= goes_to == Some(Topic::Limits);
    // They're many, and few look for them.
    let is_limit = |source: &Source| topic(source) == Some(Topic::Limits);
    let limits = sources.iter().filter(|source| is_limit(source)).count();
    let is_here = gallery.chosen[gallery.part as usize].as_ref().is_some_and(is_limit);
    let folds = limits > 0 && !is_searched && !gallery.shows_limits && !is_here;
    if folds {
        sources.retain(|source| !is_limit(source));
    }
    let height = (ui.ctx().content_rect().height() - 130.0 - (ui.cursor().top() - top)).max(120.0);
    let area = ScrollArea::vertical().id_salt(gallery.part).max_height(height).min_scrolled_height(height);
    gallery.wants_focus |= first || before != gallery.part;
    area.auto_shrink(false).show(ui, |ui| {
        if let Some(source) = cards(ui, t, gallery, &sources, goes_to) {
            asked = Some(Chosen::Open(source));
        }
        if folds && ui.button(format!("▸ {} ({limits})", words::heading(t.lang, Topic::Limits))).clicked() {
            gallery.shows_limits = true;
        }
        if more > 0 && !is_searched {
            ui.label(format!("{} {more}", t.more));
        }
    });
    let keys = if gallery.examples_alone { t.keys_of_one } else { t.keys };
    let text = |ui: &mut Ui| drop(ui.add(Label::new(RichText::new(keys).small().weak()).truncate()));
    // A finger has no Esc.
    let closes = ui.horizontal(|ui| with_room_before(ui, text, |ui| ui.button(window::texts(t.lang).close).clicked()));
    if closes.inner {
        asked = Some(Chosen::Nothing);
    }
    asked
}

/// The headings of the cards as links. Returns the clicked one.
fn headings(ui: &mut Ui, lang: Lang, sources: &[Source]) -> Option<Topic> {
    let mut topics: Vec<Topic> = sources.iter().filter_map(topic).collect();
    topics.dedup();
    if topics.len() < 2 {
        return None;
    }
    let links = ui.horizontal_wrapped(|ui| {
        topics.into_iter().filter(|topic| ui.link(words::heading(lang, *topic)).clicked()).last()
    });
    links.inner
}

/// The names of the parts. Ctrl+Tab goes to the next one.
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

/// The search field. Enter opens the first matching card, ↓ goes to it.
fn search(ui: &mut Ui, t: &Texts, gallery: &mut Gallery) -> Option<Chosen> {
    let id = Id::unique("gallery search");
    let goes_down = ui.memory(|memory| memory.has_focus(id))
        && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::ArrowDown));
    let before = gallery.wanted.clone();
    if !ui.ctx().text_edit_focused() {
        // Who types means the search.
        let typed = ui.input(|input| {
            let text = |event: &Event| if let Event::Text(text) = event { Some(text.clone()) } else { None };
            input.events.iter().filter_map(text).collect::<String>()
        });
        if !typed.trim().is_empty() {
            // The field takes the text typed in this frame already.
            ui.memory_mut(|memory| memory.request_focus(id));
        }
    }
    let field = TextField::line(&mut gallery.wanted, crate::limits::MAX_TYPED_NAME);
    let field = field.with(|edit| edit.id(id).hint_text(t.wanted).desired_width(190.0));
    let response = field.show(ui, t.lang).accessible_name(t.wanted);
    if gallery.wanted != before {
        gallery.chosen[gallery.part as usize] = None;
    }
    gallery.wants_focus |= goes_down;
    let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    let called = also_called(&gallery.wanted);
    let best = || {
        let ranked =
            gallery.sources().0.into_iter().filter_map(|source| Some((gallery.rank(&source, &called)?, source)));
        ranked.min_by_key(|(rank, _)| *rank).map(|(_, source)| source)
    };
    if entered { best().map(Chosen::Open) } else { None }
}

/// The cards in rows, under their headings. Returns the figure of the pressed one.
fn cards(ui: &mut Ui, t: &Texts, gallery: &mut Gallery, sources: &[Source], goes_to: Option<Topic>) -> Option<Source> {
    if sources.is_empty() {
        let text = match (gallery.part, &gallery.files) {
            _ if !gallery.wanted.trim().is_empty() => t.nothing,
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
    // Search results are sorted by how well they match, without headings.
    let topic = if gallery.wanted.trim().is_empty() { topic } else { |_: &Source| None };
    let rows = rows(sources, columns, topic);
    let is_chosen = |source: &Source| gallery.chosen[part as usize].as_ref() == Some(source);
    let chosen = sources.iter().position(is_chosen).unwrap_or(0);
    let id = |source: &Source| Id::unique(("gallery card", part, source));
    let mut next = chosen;
    if ui.memory(|memory| memory.has_focus(id(&sources[chosen]))) {
        next = moved(ui, chosen, &rows);
        focus |= next != chosen;
    }
    if next != chosen {
        gallery.chosen[part as usize] = Some(sources[next].clone());
    }
    let mut open = None;
    ui.spacing_mut().item_spacing = vec2(GAP, GAP);
    let mut heading = None;
    for row in rows {
        let topic = topic(&sources[row.start]);
        if topic != std::mem::replace(&mut heading, topic)
            && let Some(topic) = topic
        {
            let heading = ui.label(RichText::new(words::heading(t.lang, topic)).strong());
            if goes_to == Some(topic) {
                heading.scroll_to_me(Some(Align::TOP));
            }
        }
        ui.horizontal(|ui| {
            for index in row {
                let source = &sources[index];
                let (_, rect) = ui.allocate_space(card);
                let response = ui.interact(rect, id(source), Sense::click());
                paint(ui, t, gallery, source, (rect, &response));
                if index == next && focus {
                    response.request_focus();
                    // With its heading.
                    ui.scroll_to_rect(rect.expand2(vec2(0.0, 3.0 * GAP)), None);
                }
                if response.gained_focus() {
                    gallery.chosen[part as usize] = Some(source.clone());
                }
                if response.has_focus() {
                    let arrows =
                        EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
                    ui.memory_mut(|memory| memory.set_focus_lock_filter(id(source), arrows));
                }
                if response.clicked() {
                    open = Some(source.clone());
                }
            }
        });
    }
    open
}

/// The topic of a built-in figure.
fn topic(source: &Source) -> Option<Topic> {
    match source {
        Source::Shipped(name) => ShippedFigure::named(name).map(|figure| figure.topic),
        Source::File(_) => None,
    }
}

/// The rows of cards. Each topic begins one.
fn rows(sources: &[Source], columns: usize, topic: fn(&Source) -> Option<Topic>) -> Vec<Range<usize>> {
    let mut rows = Vec::new();
    let mut start = 0;
    for group in sources.chunk_by(|a, b| topic(a) == topic(b)) {
        let end = start + group.len();
        rows.extend((start..end).step_by(columns).map(|first| first..end.min(first + columns)));
        start = end;
    }
    rows
}

/// The card that the arrow keys lead to.
fn moved(ui: &Ui, from: usize, rows: &[Range<usize>]) -> usize {
    let last = rows.last().map_or(0, |row| row.end - 1);
    let in_row = |at: usize, down: bool| {
        let row = rows.iter().position(|row| row.contains(&at)).unwrap_or(0);
        let to = if down { rows.get(row + 1) } else { row.checked_sub(1).map(|row| &rows[row]) };
        to.map_or(at, |to| (to.start + at - rows[row].start).min(to.end - 1))
    };
    ui.input(|input| {
        let mut at = from;
        for (key, to) in [
            (Key::ArrowRight, (at + 1).min(last)),
            (Key::ArrowLeft, at.saturating_sub(1)),
            (Key::ArrowDown, in_row(at, true)),
            (Key::ArrowUp, in_row(at, false)),
            (Key::Home, 0),
            (Key::End, last),
        ] {
            at = if input.key_pressed(key) { to } else { at };
        }
        at
    })
}

fn paint(ui: &Ui, t: &Texts, gallery: &Gallery, source: &Source, (rect, response): (Rect, &Response)) {
    let card = gallery.cards.get(source);
    let told = card.and_then(|card| card.told.as_ref());
    let title = sanitize::escaped(&told.map_or(source.name(), |told| told.title.as_str().into()));
    let gone = matches!(source, Source::File(path) if gallery.part == Part::Recent && gallery.gone.contains(path));
    let fault = card.map_or("", |card| &card.fault);
    let own = told.map(|told| told.sentence.as_str());
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
    let name = line(RichText::new(&title).strong(), width, TextWrapMode::Truncate);
    let title_is_cut = name.elided;
    let below = picture.left_bottom() + vec2(0.0, 3.0);
    let lower = below + vec2(0.0, name.size().y);
    painter.galley(below, name, visuals.text_color());
    let short = sanitize::within(&sentence, 120);
    let words = theme::sentence(ui, &short, &TextStyle::Small, visuals.text_color());
    let words = WidgetText::from(words).into_galley(ui, Some(TextWrapMode::Wrap), width, FontSelection::Default);
    let cut = [
        title_is_cut.then_some(title),
        (short != sentence || lower.y + words.size().y > rect.bottom()).then_some(sentence),
    ];
    let painter = painter.with_clip_rect(rect.shrink(1.0).intersect(ui.clip_rect()));
    painter.galley(lower, words, visuals.text_color());
    let cut: Vec<String> = cut.into_iter().flatten().collect();
    if !cut.is_empty() {
        response.clone().explained(cut.join("\n"));
    }
}
