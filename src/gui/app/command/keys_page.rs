//! The keys of all commands on a page to print.

use eframe::egui::Context;

use crate::appearance::Rgba;
use crate::drawing::Anchor;
use crate::export::vector::{Item, Letters, Page, pdf_of};
use crate::gui::app::command::MENUS;
use crate::gui::app::presentation;
use crate::gui::kit::{Command, written};
use camera_lab_desk::Model;
use camera_lab_words::{Lang, window};

/// Width and height of a page in points (A4), its border, the width of the keys in a column, and the size of letters.
const PAPER: [f32; 2] = [595.0, 842.0];
const BORDER: f32 = 36.0;
const KEYS: f32 = 118.0;
const SIZE: f32 = 8.8;
const LINE: f32 = 13.2;
/// The gap after a menu, in lines, with its title's extra height.
const BETWEEN: f32 = 2.0;

/// The menus with their commands, and the letters of a presentation: the keys of each, and its name.
fn menus(model: &Model, lang: Lang) -> Vec<(&'static str, Vec<[String; 2]>)> {
    let (t, ctx) = (window::texts(lang), Context::default());
    let mut menus: Vec<(&str, Vec<[String; 2]>)> = Vec::new();
    for menu in MENUS {
        let row = |command: &Command| {
            let keys: Vec<String> = command.keys(model).map(|keys| written(&ctx, &keys, lang)).collect();
            (!keys.is_empty()).then(|| [keys.join(", "), named(*command, t)])
        };
        let rows = menu.groups(model).flatten().filter_map(|command| row(&command));
        // Some menus have a part that isn't in the bar.
        match menus.iter_mut().find(|(title, _)| *title == (menu.title)(t)) {
            Some((_, known)) => known.extend(rows),
            None => menus.push(((menu.title)(t), rows.collect())),
        }
    }
    menus.retain(|(_, rows)| !rows.is_empty());
    let letters = presentation::KEYS.iter().map(|(keys, command)| [written(&ctx, keys, lang), named(*command, t)]);
    menus.push((t.presentation, letters.collect()));
    menus
}

fn named(command: Command, t: &window::Texts) -> String {
    command.label(t).trim_end_matches('…').to_owned()
}

/// The keys as lines of text.
pub fn keys_text(model: &Model, lang: Lang) -> String {
    let menu = |(title, rows): (&str, Vec<[String; 2]>)| {
        let rows: String = rows.iter().map(|[keys, name]| format!("  {keys:<28} {name}\n")).collect();
        format!("{title}\n{rows}")
    };
    menus(model, lang).into_iter().map(menu).collect::<Vec<_>>().join("\n")
}

/// The keys as one page of paper, a PDF file. `None` if its fonts can't be read.
pub fn keys_pdf(model: &Model, lang: Lang) -> Option<Vec<u8>> {
    let (ink, faint) = (Rgba::rgb(0x16, 0x1a, 0x22), Rgba::rgb(0x66, 0x66, 0x66));
    let title = window::texts(lang).keys_title;
    let mut items = vec![Item::text(title.to_owned(), [BORDER, BORDER + 10.0], 14.0, ink, Anchor::Left)];
    let (top, width) = (BORDER + 26.0, (PAPER[0] - 2.0 * BORDER) / 2.0);
    let menus = menus(model, lang);
    // The second column begins at the menu that crosses the middle, because a menu isn't cut.
    let lines =
        |menus: &[(&str, Vec<[String; 2]>)]| menus.iter().map(|(_, rows)| rows.len() as f32 + BETWEEN).sum::<f32>();
    let (all, mut first) = (lines(&menus), 0);
    while first < menus.len() && lines(&menus[..first]) + 0.5 * lines(&menus[first..=first]) < 0.5 * all {
        first += 1;
    }
    // The taller one fills the page at most.
    let tallest = lines(&menus[..first]).max(lines(&menus[first..]));
    let line = LINE.min((PAPER[1] - BORDER - top) / tallest);
    for (left, menus) in [(BORDER, &menus[..first]), (BORDER + width, &menus[first..])] {
        let mut y = top;
        for (title, rows) in menus {
            items.push(Item::text((*title).to_owned(), [left, y], 1.2 * SIZE, faint, Anchor::Left));
            y += 1.2 * line;
            for [keys, name] in rows {
                items.push(Item::text(keys.clone(), [left, y], SIZE, ink, Anchor::Left));
                items.push(Item::text(name.clone(), [left + KEYS, y], SIZE, ink, Anchor::Left));
                y += line;
            }
            y += 0.8 * line;
        }
    }
    let title = title.to_owned();
    let page = Page { size: PAPER, points: 1.0, description: title.clone(), title, language: lang.tag(), items };
    pdf_of(&[page], Letters::Text, "")
}
