//! Launch options of one window, which aren't stored. They come from the command line, or from the address of a page
//! (`?view=image&panels=none&lang=pt-BR&theme=dark`, `?lesson=basis&step=3`), as in lecture notes that show a figure
//! inside a page.

use percent_encoding::percent_decode_str;

use crate::appearance::Theme;
use crate::figure::words::{self, THEMES, Words};
use crate::lessons::{OpenLesson, shipped};
use crate::views::{View, Views};
use camera_lab_words::Lang;

/// The languages, by the names that `--lang` has for them.
pub(in crate::gui) const LANGUAGES: Words<Lang> = &Lang::TAGGED;

/// Launch options of one window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LaunchOptions {
    /// The language.
    pub lang: Option<Lang>,
    /// The ground of the window and its pictures.
    pub theme: Option<Theme>,
    /// The displayed pictures.
    pub views: Option<Views>,
    /// True for the pictures alone, without panels and menus.
    pub bare: bool,
    /// The built-in lesson to play, by its place.
    pub lesson: Option<usize>,
    /// Its step, from 1.
    pub step: Option<usize>,
}

impl LaunchOptions {
    /// The options in an address after the `?`, and its unreadable parts, word for word.
    pub fn of_query(query: &str) -> (Self, Vec<String>) {
        let mut asked = Self::default();
        let mut unknown = Vec::new();
        for pair in query.trim_start_matches('?').split('&').filter(|pair| !pair.is_empty()) {
            let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
            let value = percent_decode_str(value).decode_utf8_lossy();
            let is_known = match key {
                "lang" => put(&mut asked.lang, words::value(LANGUAGES, &value)),
                "theme" => put(&mut asked.theme, words::value(THEMES, &value)),
                "view" => put(&mut asked.views, Views::CHOICES.into_iter().find(|views| views.name() == value)),
                "lesson" => put(&mut asked.lesson, shipped().iter().position(|shipped| shipped.lesson.id == value)),
                "step" => put(&mut asked.step, value.parse().ok().filter(|step| *step > 0)),
                "panels" => {
                    asked.bare = value == "none";
                    asked.bare
                }
                // Who may send messages: a matter of the page's script.
                "allow" => true,
                _ => false,
            };
            if !is_known {
                unknown.push(pair.to_owned());
            }
        }
        (asked, unknown)
    }

    /// Sets a window up so, but for the lesson.
    pub fn apply(self, model: &mut camera_lab_desk::Model) {
        let settings = &mut model.settings;
        settings.lang = self.lang.unwrap_or(settings.lang);
        settings.theme = self.theme.unwrap_or(settings.theme);
        if self.bare {
            settings.bare = true;
            settings.panels.wanted = [false; 3];
            model.layout.strip = false;
        }
        if let Some(views) = self.views {
            model.layout.shown = View::ALL.map(|view| views.contains(view));
        }
    }

    /// The lesson to play. It replaces the figure, so `file_flow` asks first.
    pub fn open_lesson(self) -> Option<OpenLesson> {
        let lesson = shipped().get(self.lesson?)?.lesson.clone();
        let last = lesson.steps.len().saturating_sub(1);
        let step = self.step.map_or(0, |step| step - 1).min(last);
        Some(OpenLesson { lesson, path: None, step })
    }
}

/// True if there is a value.
fn put<T>(place: &mut Option<T>, value: Option<T>) -> bool {
    let is_known = value.is_some();
    *place = value.or(place.take());
    is_known
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::gui::{Start, State};

    #[test]
    fn an_address_sets_options_and_reports_unknown_ones() {
        let (asked, unknown) = LaunchOptions::of_query("?view=image&panels=none&lang=pt-BR&theme=dark");
        assert_eq!(unknown, [""; 0]);
        let all = LaunchOptions {
            lang: Some(Lang::PtBr),
            theme: Some(Theme::Dark),
            views: Some(Views::One(View::Image)),
            bare: true,
            ..LaunchOptions::default()
        };
        assert_eq!(asked, all);
        let mut state = State::new(Start::default()).unwrap();
        asked.apply(&mut state.model);
        assert_eq!((state.model.layout.shown, state.model.settings.panels.wanted), ([false, false, true], [false; 3]));
        assert_eq!(
            (state.model.settings.lang, state.model.settings.theme, state.model.settings.bare),
            (Lang::PtBr, Theme::Dark, true)
        );

        let (asked, unknown) =
            LaunchOptions::of_query("view=side&panels=some&lang=%70t-BR&theme=&utm_source=x&view=all");
        assert_eq!(unknown, ["view=side", "panels=some", "theme=", "utm_source=x"]);
        assert_eq!(
            asked,
            LaunchOptions { lang: Some(Lang::PtBr), views: Some(Views::All), ..LaunchOptions::default() }
        );
        assert_eq!(LaunchOptions::of_query(""), Default::default());

        let (asked, unknown) = LaunchOptions::of_query("?lesson=basis&step=3");
        assert_eq!(unknown, [""; 0]);
        let open = asked.open_lesson().unwrap();
        assert_eq!((open.lesson.id.as_str(), open.step), ("basis", 2));
        assert_eq!(LaunchOptions::of_query("lesson=none&step=0").1, ["lesson=none", "step=0"]);
    }
}
