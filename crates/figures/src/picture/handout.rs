//! Pictures with texts on pages of paper, for handing out.

use super::Composite;
use super::error::PictureError;
use super::handout_formula::{self, FormulaPart, INK, written};
use super::vectors::{Faces, KnownPictures, page};
use crate::appearance::Rgba;
use crate::drawing::Anchor;
use crate::export::vector::{Item, Letters, Page, pdf_of};
use crate::progress::Progress;
use crate::text::{Element, broken, measure};
use crate::views::Request;
use std::sync::Arc;

/// Width and height of a page in points: A4.
const PAPER: [f32; 2] = [595.0, 842.0];
/// The free border of a page.
const BORDER: f32 = 48.0;
/// The gap between columns.
const GUTTER: f32 = 22.0;
/// The gap below an entry.
const GAP: f32 = 16.0;
/// From line to line, in heights of the letters.
const LEADING: f32 = 1.35;
/// From line to line where a student writes, in points.
const WRITING: f32 = 21.0;
/// Resolution of faces that are pictures, in pixels per inch of the page.
const DPI: f64 = 200.0;
/// The most different pictures with their faces as areas. Each takes up to a fifth of a megabyte and a thirtieth of a
/// second, so a longer handout has pixels instead.
const MOST_WITH_AREAS: usize = 60;
/// Resolution of those. With lines and letters as vectors, it's enough to recognize a scene.
const DPI_OF_MANY: f64 = 120.0;

const FAINT: Rgba = Rgba::rgb(0x66, 0x66, 0x66);

/// A text of a handout. `_c` and `_{abc}` in it are subscripts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Paragraph {
    /// The heading of an entry.
    Heading(String),
    /// A text. Its lines are broken.
    Text(String),
    /// A formula on a line of its own.
    Formula(Vec<FormulaPart>),
    /// A remark in small letters.
    Remark(String),
    /// A formula of a remark.
    SmallFormula(Vec<FormulaPart>),
    /// Lines to write on.
    Room(usize),
}

/// A picture with its texts.
#[derive(Clone, Debug, Default)]
pub struct HandoutEntry {
    /// The pictures; `None` means only texts.
    pub picture: Option<Composite>,
    /// The texts below them.
    pub paragraphs: Vec<Paragraph>,
}

/// Entries that begin on a page of their own.
#[derive(Clone, Debug)]
pub struct HandoutPart {
    /// The title above its first entry.
    pub title: String,
    /// The text at the foot of each of its pages, beside the number. May be empty.
    pub foot: String,
    /// In the order of the pages.
    pub entries: Vec<HandoutEntry>,
}

/// Pictures with texts, on pages.
#[derive(Clone, Debug)]
pub struct Handout {
    /// The language, as a tag.
    pub language: &'static str,
    /// In the order of the pages. The pages of each foot are counted from 1.
    pub parts: Vec<HandoutPart>,
    /// The number of columns. Two make entries small, and they stand side by side in rows, four on a page.
    pub columns: usize,
}

impl Handout {
    /// The width of a picture in points.
    pub fn picture_width(columns: usize) -> f32 {
        let columns = columns.max(1) as f32;
        (PAPER[0] - 2.0 * BORDER - (columns - 1.0) * GUTTER) / columns
    }

    /// The handout as a PDF file with selectable texts.
    ///
    /// # Errors
    /// [`PictureError`]
    pub async fn pdf(&self, progress: &Progress) -> Result<Vec<u8>, PictureError> {
        pdf_of(&self.pages(progress).await?, Letters::Text, "").ok_or(PictureError::Font)
    }

    /// The pages of the handout.
    ///
    /// # Errors
    /// [`PictureError`]
    pub async fn pages(&self, progress: &Progress) -> Result<Vec<Page>, PictureError> {
        let width = Self::picture_width(self.columns);
        let mut pages = Pages::new(self, width);
        let size = if self.columns > 1 { 8.5 } else { 10.0 };
        let mut known = KnownPictures::new();
        for part in &self.parts {
            pages.begin(part);
            self.part(part, &mut pages, (size, width), &mut known, progress).await?;
        }
        Ok(pages.finish())
    }

    async fn part(
        &self,
        part: &HandoutPart,
        pages: &mut Pages<'_>,
        (size, width): (f32, f32),
        known: &mut KnownPictures,
        progress: &Progress,
    ) -> Result<(), PictureError> {
        let mut row = Vec::new();
        let (faces, dpi) = if self.has_many_pictures() { (Faces::Picture, DPI_OF_MANY) } else { (Faces::Auto, DPI) };
        for entry in &part.entries {
            let Some(sheet) = &entry.picture else {
                pages.put_row(std::mem::take(&mut row));
                pages.flow(&entry.paragraphs, size);
                continue;
            };
            let mut block = PlacedEntry { items: Vec::new(), height: 0.0, width };
            let per_inch = 72.0 * f64::from(sheet.size().ok_or(PictureError::TooLarge)?[0]) / f64::from(width);
            let drawn = page(sheet, (faces, known), [per_inch, dpi], false, progress).await?;
            block.picture(drawn.page);
            let fits = block.texts(&entry.paragraphs, size);
            row.push(block);
            if row.len() >= self.columns || !fits {
                pages.put_row(std::mem::take(&mut row));
            }
            if !fits {
                pages.flow(&entry.paragraphs, size);
            }
        }
        pages.put_row(row);
        Ok(())
    }

    /// True if it has more than [`MOST_WITH_AREAS`] different pictures.
    fn has_many_pictures(&self) -> bool {
        let mut different: Vec<&Request> = Vec::new();
        let entries = self.parts.iter().flat_map(|part| &part.entries);
        let sheets = entries.filter_map(|entry| entry.picture.as_ref());
        for request in sheets.flat_map(|sheet| &sheet.requests) {
            if different.len() <= MOST_WITH_AREAS && !different.contains(&request) {
                different.push(request);
            }
        }
        different.len() > MOST_WITH_AREAS
    }
}

/// An entry, laid out at (0, 0), in points.
struct PlacedEntry {
    items: Vec<Item>,
    height: f32,
    width: f32,
}

impl PlacedEntry {
    fn picture(&mut self, page: Page) {
        let scale = self.width / page.size[0].max(1.0);
        let clip = [0.0, 0.0, page.size[0], page.size[1]];
        self.items.push(Item::Group { corner: [0.0; 2], scale, clip, items: Arc::new(page.items) });
        self.height += page.size[1] * scale + 6.0;
    }

    fn paragraph(&mut self, paragraph: &Paragraph, size: f32) {
        let (text, size, color, indent) = match paragraph {
            Paragraph::Heading(text) => (text, 1.15 * size, INK, 0.0),
            Paragraph::Text(text) => (text, size, INK, 0.0),
            Paragraph::Formula(parts) => return self.formula(parts, size),
            Paragraph::SmallFormula(parts) => return self.formula(parts, 0.88 * size),
            Paragraph::Remark(text) => (text, 0.88 * size, FAINT, 0.0),
            Paragraph::Room(lines) => return self.room(*lines),
        };
        let bold = matches!(paragraph, Paragraph::Heading(_));
        for line in lines(text, size, self.width - indent) {
            self.height += LEADING * size;
            let at = [indent, self.height - 0.3 * size];
            let mut item = written(line, at, size, color);
            if let Item::Text(text) = &mut item
                && bold
            {
                // The bundled font has one weight. A heading has a border in its own colour, so that it's heavier and
                // still one text for a search.
                (text.halo, text.halo_width) = (color, 0.04 * size);
            }
            self.items.push(item);
        }
        self.height += 0.35 * size;
    }

    /// Adds texts below a picture. If they're higher than a page, there are fewer lines to write on. False if they
    /// don't fit even then, so that only the picture is left.
    fn texts(&mut self, paragraphs: &[Paragraph], size: f32) -> bool {
        let (above, most) = (self.height, PAPER[1] - 2.0 * BORDER);
        let given = paragraphs.iter().map(|paragraph| if let Paragraph::Room(lines) = paragraph { *lines } else { 0 });
        for room in (1..=given.max().unwrap_or_default().max(1)).rev() {
            self.items.truncate(1);
            self.height = above;
            for paragraph in paragraphs {
                match paragraph {
                    Paragraph::Room(lines) => self.room(room.min(*lines)),
                    paragraph => self.paragraph(paragraph, size),
                }
            }
            if self.height <= most {
                return true;
            }
        }
        self.items.truncate(1);
        self.height = above;
        false
    }

    fn formula(&mut self, parts: &[FormulaPart], size: f32) {
        const INDENT: f32 = 14.0;
        let set = handout_formula::set(parts, size, self.width - INDENT);
        let corner = [INDENT, self.height + 0.1 * size];
        let clip = [-INDENT, -size, self.width, set.height + size];
        self.items.push(Item::group(corner, clip, set.items));
        self.height += set.height + 0.5 * size;
    }

    fn room(&mut self, lines: usize) {
        for _ in 0..lines {
            self.height += WRITING;
            let path = vec![Element::Move([0.0, self.height]), Element::Line([self.width, self.height])];
            self.items.push(Item::stroke(path, Rgba::rgb(0xbb, 0xbb, 0xbb), 0.5, false));
        }
        self.height += 6.0;
    }
}

/// The lines of a text, no wider than `width`. A wider word is broken.
fn lines(text: &str, size: f32, width: f32) -> Vec<String> {
    let fits = |line: &str| measure(line, size, false).width <= width;
    let letters = |word: &str| word.chars().map(String::from).collect();
    let mut lines = Vec::new();
    for hard in text.lines() {
        let words = hard.split_whitespace().map(|word| format!("{word} "));
        let pieces = words.flat_map(|word| if fits(word.trim_end()) { vec![word] } else { letters(&word) });
        match broken(pieces, fits) {
            none if none.is_empty() => lines.push(String::new()),
            own => lines.extend(own),
        }
    }
    lines
}

/// The pages, filled row after row.
struct Pages<'a> {
    handout: &'a Handout,
    /// The title and the foot of the present part, and the number of its foot's pages so far.
    title: &'a str,
    foot: &'a str,
    number: usize,
    done: Vec<Page>,
    items: Vec<Item>,
    width: f32,
    /// The upper end of the free space on this page.
    y: f32,
    /// The rows on this page.
    rows: usize,
}

impl<'a> Pages<'a> {
    fn new(handout: &'a Handout, width: f32) -> Self {
        let [title, foot] = [""; 2];
        Self { handout, title, foot, number: 0, done: Vec::new(), items: Vec::new(), width, y: BORDER, rows: 0 }
    }

    /// Begins a part on a new page.
    fn begin(&mut self, part: &'a HandoutPart) {
        if !self.items.is_empty() {
            self.turn();
        }
        if part.foot != self.foot {
            self.number = 0;
        }
        (self.title, self.foot) = (&part.title, &part.foot);
        for line in lines(&part.title, 16.0, PAPER[0] - 2.0 * BORDER) {
            self.y += 1.3 * 16.0;
            self.items.push(written(line, [BORDER, self.y - 5.0], 16.0, INK));
        }
        self.y += 10.0;
    }

    /// Puts entries side by side, without breaking them.
    fn put_row(&mut self, row: Vec<PlacedEntry>) {
        if row.is_empty() {
            return;
        }
        let height = row.iter().map(|block| block.height).fold(0.0, f32::max);
        if self.handout.columns > 1 {
            // Two rows on a page. The second starts at its middle if the first leaves that free.
            match self.rows {
                0 => {}
                1 => self.y = self.y.max((0.5 * PAPER[1]).min(PAPER[1] - BORDER - height)),
                _ => self.turn(),
            }
        }
        self.make_room(height);
        self.rows += 1;
        let mut x = BORDER;
        for block in row {
            let clip = [-4.0, -4.0, self.width + GUTTER, block.height + GAP];
            self.items.push(Item::group([x, self.y], clip, block.items));
            x += self.width + GUTTER;
        }
        self.y += height + GAP;
    }

    /// Puts texts across the whole page. They stay on one page if they aren't higher than it. Otherwise they continue
    /// on the next one, and a heading stays with the text below it.
    fn flow(&mut self, paragraphs: &[Paragraph], size: f32) {
        let width = PAPER[0] - 2.0 * BORDER;
        let block = |paragraph: &Paragraph| {
            let mut block = PlacedEntry { items: Vec::new(), height: 0.0, width };
            block.paragraph(paragraph, size);
            block
        };
        // A text higher than a page continues line by line.
        let room = PAPER[1] - 2.0 * BORDER;
        let in_lines = |paragraph: &Paragraph| match paragraph {
            Paragraph::Text(text) if block(paragraph).height > room => {
                lines(text, size, width).into_iter().map(Paragraph::Text).collect()
            }
            paragraph => vec![paragraph.clone()],
        };
        let paragraphs: Vec<Paragraph> = paragraphs.iter().flat_map(in_lines).collect();
        let height: f32 = paragraphs.iter().map(|paragraph| block(paragraph).height).sum();
        if height <= room {
            self.make_room(height);
        }
        for (k, paragraph) in paragraphs.iter().enumerate() {
            let PlacedEntry { items, height, .. } = block(paragraph);
            // The first lines of an entry stay together.
            let below = paragraphs.get(k + 1..).unwrap_or_default().iter().take(if k == 0 { 2 } else { 0 });
            self.make_room(height + below.map(|paragraph| block(paragraph).height).sum::<f32>());
            let clip = [-4.0, -4.0, width + 8.0, height + 4.0];
            self.items.push(Item::group([BORDER, self.y], clip, items));
            self.y += height;
        }
        self.y += GAP;
    }

    /// Turns the page if the free space on it is less than a height.
    fn make_room(&mut self, height: f32) {
        if self.y + height > PAPER[1] - BORDER && !self.items.is_empty() {
            self.turn();
        }
    }

    fn turn(&mut self) {
        self.number += 1;
        let place = [PAPER[0] / 2.0, PAPER[1] - 0.55 * BORDER];
        let number = self.number.to_string();
        let foot = if self.foot.is_empty() { number } else { format!("{}  ·  {number}", self.foot) };
        self.items.push(Item::text(foot, place, 9.0, FAINT, Anchor::Center));
        self.done.push(Page {
            size: PAPER,
            points: 1.0,
            title: self.title.to_owned(),
            description: self.title.to_owned(),
            language: self.handout.language,
            items: std::mem::take(&mut self.items),
        });
        (self.y, self.rows) = (BORDER, 0);
    }

    fn finish(mut self) -> Vec<Page> {
        if !self.items.is_empty() {
            self.turn();
        }
        self.done
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::Camera;
    use crate::figure::Figure;
    use crate::progress::at_once;
    use crate::views::{SharedScene, Shot, Size, View, Views, scene_of, unlabelled};

    /// A handout of these figures, which all show the same scene.
    fn pdf(figures: &[Figure]) -> Vec<u8> {
        let no_files = &mut crate::scene::no_files;
        let scene = SharedScene::new(scene_of(&figures[0], no_files, &Progress::default()).unwrap());
        let entry = |figure: &Figure| {
            let (camera, shot) = (Camera::new(&figure.camera).unwrap(), Shot::of(figure));
            let size = Size { width: 300, height: 110, scale: 1.0 };
            let request = Request::new(&shot, View::Image, &camera, &scene, unlabelled(), size);
            let picture = Some(Composite::of(Views::All, &request, &shot, None).unwrap());
            HandoutEntry { picture, paragraphs: vec![Paragraph::Heading("Word".to_owned())] }
        };
        let entries = figures.iter().map(entry).collect();
        let parts = vec![HandoutPart { title: "A".to_owned(), foot: String::new(), entries }];
        let handout = Handout { language: "en", parts, columns: 1 };
        at_once(handout.pdf(&Progress::default())).unwrap()
    }

    #[test]
    fn pictures_that_stay_the_same_are_drawn_and_written_once() {
        let figure = Figure::default();
        let mut turned = figure.clone();
        turned.camera.position.x += 1.0;
        let one = pdf(std::slice::from_ref(&figure)).len();
        let many = pdf(&vec![figure.clone(); 40]).len();
        assert!(many < 2 * one, "{many} {one}");
        // Another one in between is written too, and the first is still known after it.
        let two = pdf(&[figure.clone(), turned.clone()]).len();
        assert!(two > one + one / 4, "{two} {one}");
        let back = pdf(&[figure.clone(), turned, figure]).len();
        assert!(back < two + two / 10, "{back} {two}");
    }
    #[test]
    fn many_different_pictures_have_their_faces_as_pixels() {
        let turned = |k: usize| {
            let mut figure = Figure::default();
            figure.camera.position.x += 0.01 * k as f64;
            figure
        };
        let figures: Vec<Figure> = (0..40).map(turned).collect();
        // Three views of each.
        let (few, many) = (pdf(&figures[..20]).len(), pdf(&figures).len());
        assert!(many < few, "{many} {few}");
    }
}
