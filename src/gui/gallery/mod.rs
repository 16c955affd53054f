//! The gallery: the built-in figures, the recent ones, and those of a folder, each with a small picture.

mod card;
mod show;

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

pub use card::figures_in;
use eframe::egui::{Context, TextureHandle, TextureOptions};
pub(super) use show::{Chosen, show};

use self::card::{CardJob, CardOutcome, CardText, work};
use crate::appearance::Theme;
use crate::gui::kit::frames;
use camera_lab_desk::{Source, Worker};
use camera_lab_words::window::search::{folded, has_words};
use camera_lab_words::{Lang, messages};

/// A part of the gallery.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Part {
    /// The built-in figures.
    #[default]
    Examples,
    /// The recent figures.
    Recent,
    /// The figures of a folder.
    Folder,
}

impl Part {
    /// All.
    pub const ALL: [Self; 3] = [Self::Examples, Self::Recent, Self::Folder];
}

/// The content of the gallery, and its thumbnails.
#[derive(Debug)]
pub struct Gallery {
    /// The displayed part.
    pub part: Part,
    /// True if there are no files to show, as in a page of a browser.
    pub examples_alone: bool,
    /// The chosen figure in each part. `None`, or one that isn't there, means the first.
    chosen: [Option<Source>; 3],
    /// The words that cards are searched for.
    wanted: String,
    /// True if the figures at the limits of numbers are unfolded.
    shows_limits: bool,
    /// The chosen card gets the keyboard once there are cards.
    wants_focus: bool,
    /// The recent files, and the missing ones of these.
    recent: Vec<PathBuf>,
    gone: HashSet<PathBuf>,
    /// The folder, and its files with the number of older ones, or the reason why it can't be read.
    folder: Option<PathBuf>,
    files: Result<(Vec<PathBuf>, usize), String>,
    cards: BTreeMap<Source, Card>,
    /// The style of the thumbnails.
    style: (Theme, Lang),
    waiting: Vec<CardJob>,
    worker: Worker<CardJob, CardOutcome>,
}

/// The display of a figure.
#[derive(Default)]
struct Card {
    texture: Option<TextureHandle>,
    /// Its title and caption. `None` if not read yet.
    told: Option<CardText>,
    /// The reason why it can't be drawn. Empty if it can, or if that hasn't been tried.
    fault: String,
    /// False if it may have changed since, so that it's checked again.
    fresh: bool,
}

impl std::fmt::Debug for Card {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Card").field("told", &self.told).finish_non_exhaustive()
    }
}

impl Default for Gallery {
    fn default() -> Self {
        Self {
            part: Part::default(),
            examples_alone: cfg!(target_arch = "wasm32"),
            chosen: [None, None, None],
            wanted: String::new(),
            shows_limits: false,
            wants_focus: false,
            recent: Vec::new(),
            gone: HashSet::new(),
            folder: None,
            files: Ok((Vec::new(), 0)),
            cards: BTreeMap::new(),
            style: (Theme::default(), Lang::default()),
            waiting: Vec::new(),
            worker: Worker::new("gallery", crate::clock::now, work),
        }
    }
}

impl Gallery {
    /// Collects the figures again. `beside` is the folder of the open figure, which is `here` and chosen in any part.
    pub(super) fn begin(&mut self, recent: &[PathBuf], beside: Option<&Path>, here: Option<&Source>) {
        if here.is_some() {
            self.chosen.fill(here.cloned());
        }
        self.wanted.clear();
        self.recent = recent.to_vec();
        self.folder = self.folder.take().or_else(|| beside.map(Path::to_owned));
        for card in self.cards.values_mut() {
            (card.fresh, card.told) = (false, None);
        }
        self.waiting = vec![CardJob::Sort(self.recent.clone())];
        self.waiting.extend(self.folder.clone().map(CardJob::List));
    }

    /// The folder of the displayed figures.
    pub(super) fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// Sets the folder chosen in the last run of the program.
    pub(super) fn remember(&mut self, folder: PathBuf) {
        self.folder = Some(folder);
    }

    /// Shows the figures of this folder from now on.
    pub(super) fn look_into(&mut self, folder: PathBuf) {
        self.part = Part::Folder;
        self.chosen[Part::Folder as usize] = None;
        self.wants_focus = true;
        self.files = Ok((Vec::new(), 0));
        self.waiting.push(CardJob::List(folder.clone()));
        self.folder = Some(folder);
    }

    /// Cancels the drawing of thumbnails, because the gallery is closed.
    pub(super) fn end(&self) {
        self.worker.cancel();
    }

    /// The figures of the displayed part, and the number of remaining ones.
    fn sources(&self) -> (Vec<Source>, usize) {
        let files = |paths: &[PathBuf]| paths.iter().cloned().map(Source::File).collect();
        match self.part {
            Part::Examples => {
                (camera_lab_files::SHIPPED_FIGURES.map(|figure| Source::Shipped(figure.name)).to_vec(), 0)
            }
            Part::Recent => (files(&self.recent), 0),
            Part::Folder => self.files.as_ref().map_or((Vec::new(), 0), |(paths, older)| (files(paths), *older)),
        }
    }

    /// The match of a figure with the search words, first the typed ones, then their other names: 0 if they are in its
    /// title, more if only in its caption. `None` if they don't match.
    fn rank(&self, source: &Source, called: &[String]) -> Option<usize> {
        let told = self.cards.get(source).and_then(|card| card.told.as_ref());
        let (title, sentence) = told.map_or_else(
            || (folded(&source.name()), String::new()),
            |told| (folded(&told.title), folded(&told.sentence)),
        );
        let whole = format!("{title} {sentence}");
        let has = |text: &str, names: &[String]| names.iter().any(|name| has_words(text, name));
        let (typed, others) = called.split_at(called.len().min(1));
        [has(&title, typed), has(&title, others), has(&whole, typed), has(&whole, others)].into_iter().position(|is| is)
    }

    /// Takes the results, and starts the next request.
    fn go_on(&mut self, ctx: &Context, style: (Theme, Lang), sources: &[Source]) {
        if self.style != style {
            self.style = style;
            self.cards.values_mut().for_each(|card| (card.fresh, card.told) = (false, None));
        }
        let [done] = self.worker.take(std::time::Duration::ZERO);
        if let Some(outcome) = done.and_then(|done| done.outcome) {
            self.take(ctx, outcome);
        }
        if self.worker.is_pending(0) {
            return;
        }
        let (theme, lang) = style;
        let unread = |source: &&Source| self.cards.get(source).is_none_or(|card| card.told.is_none());
        let unread: Vec<Source> = sources.iter().filter(unread).cloned().collect();
        let read = (!unread.is_empty()).then_some(CardJob::Read(unread, lang));
        let is_stale = |source: &&Source| !self.cards.get(source).is_some_and(|card| card.fresh);
        let stale = sources.iter().find(is_stale);
        let draw = stale.map(|source| CardJob::Draw { source: source.clone(), theme, lang });
        // The examples are there in any case, and folders may take long.
        let (waits, shown) = (!self.waiting.is_empty(), read.or(draw));
        let next = match shown {
            Some(shown) if !waits || self.part == Part::Examples => Some(shown),
            _ => waits.then(|| self.waiting.remove(0)),
        };
        if let Some(job) = next {
            if let CardJob::Draw { source, .. } = &job {
                // Even if drawing panics, it isn't requested again.
                self.cards.entry(source.clone()).or_default().fresh = true;
            }
            self.worker.ask(&frames(ctx), 0, job);
        }
    }

    fn take(&mut self, ctx: &Context, outcome: CardOutcome) {
        match outcome {
            CardOutcome::Sorted(recent, gone) => (self.recent, self.gone) = (recent, gone),
            CardOutcome::Listed(folder, files) if self.folder.as_ref() == Some(&folder) => {
                let name = crate::sanitize::path(&folder);
                self.files = files.map_err(|error| messages::file(self.style.1, &name, &error));
            }
            CardOutcome::Listed(..) => {}
            CardOutcome::Read(all) => {
                for (source, told) in all {
                    self.cards.entry(source).or_default().told = Some(told);
                }
            }
            CardOutcome::Drawn(source, drawn) => {
                let fault = drawn.as_ref().err().cloned().unwrap_or_default();
                let texture = drawn.ok().map(|picture| {
                    let size = [picture.width() as usize, picture.height() as usize];
                    let pixels = eframe::egui::ColorImage::from_rgba_premultiplied(size, picture.rgba());
                    ctx.load_texture("gallery", pixels, TextureOptions::LINEAR)
                });
                let card = self.cards.entry(source).or_default();
                (card.texture, card.fault) = (texture, fault);
            }
        }
    }
}
