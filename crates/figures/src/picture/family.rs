//! A family on a sheet: the same figure at several values of a key, in rows, with the value under each picture.

use super::composite::{Grid, lettered, of};
use super::{Composite, NoComposite, OnPaper, gap};
use crate::figure::Figure;
use crate::figure::variation::Variant;
use crate::limits::{MAX_PIXELS, MAX_SIDE};
use crate::views::{
    Arrangement, Captions, ObserverOf, Palette, Request, SharedScene, Shot, Size, View, Views, caption_height,
    with_observer,
};

/// The most pictures of a row, if their number isn't given and they have space.
const MOST_COLUMNS: usize = 4;

/// The figures of a family, and their display.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// The figures, each with its scene.
    pub members: Vec<(Variant, SharedScene)>,
    /// The pictures of each.
    pub views: Views,
    /// The number of pictures in a row; `None` means as many as there's space for.
    pub columns: Option<usize>,
    /// Letters before the captions: (a), (b) …
    pub parts: bool,
    /// Captions that replace the values, as far as there are any.
    pub captions: Vec<String>,
    /// The figure whose observers see all of them; `None` means one observer that has the subject of each in the
    /// picture.
    pub observer_of: Option<ObserverOf>,
}

/// The figures of a family, each with its scene, which `scene` makes. Figures with the same objects share one.
///
/// # Errors
/// The first error of `scene`.
pub fn members<E>(
    figures: Vec<Variant>,
    mut scene: impl FnMut(&Figure) -> Result<SharedScene, E>,
) -> Result<Vec<(Variant, SharedScene)>, E> {
    let mut members: Vec<(Variant, SharedScene)> = Vec::with_capacity(figures.len());
    for variant in figures {
        let same = |(other, _): &&(Variant, SharedScene)| have_same_scene(&other.figure, &variant.figure);
        let scene = match members.iter().find(same) {
            Some((_, scene)) => scene.clone(),
            None => scene(&variant.figure)?,
        };
        members.push((variant, scene));
    }
    Ok(members)
}

/// True if one scene serves both figures.
pub fn have_same_scene(a: &Figure, b: &Figure) -> bool {
    (&a.scene, &a.photograph, &a.style) == (&b.scene, &b.photograph, &b.style) && a.show.triangle == b.show.triangle
}

/// The size of a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SheetSize {
    /// That of the whole sheet, in pixels.
    Whole([u32; 2]),
    /// The width of the whole sheet. Each picture has the proportions of the image.
    Width(u32),
    /// Those of each picture.
    Pictures([u32; 2]),
}

impl Family {
    /// The sheet. `request` has the words and the settings of the pictures. `scale` is that of strokes and letters;
    /// `None` means by the size of the sheet.
    ///
    /// # Errors
    /// [`NoComposite`].
    pub fn sheet(
        &self,
        request: &Request,
        size: SheetSize,
        scale: Option<f32>,
        paper: Option<&OnPaper>,
    ) -> Result<Composite, NoComposite> {
        let views: Vec<_> = self.views.views().collect();
        let count = self.members.len();
        let columns =
            self.columns.unwrap_or_else(|| self.usual_columns(views.len(), size, paper)).clamp(1, count.max(1));
        if views.len() > 1 && !count.is_multiple_of(columns) {
            return Err(NoComposite::UnevenRows { count, columns });
        }
        let rows = count.div_ceil(columns) * views.len();
        let [width, height] = match size {
            SheetSize::Whole(size) => size,
            SheetSize::Width(width) => [width, width],
            SheetSize::Pictures(size) => size,
        };
        let scale = scale.unwrap_or_else(|| match size {
            SheetSize::Whole(_) => Size::as_on_a_screen(width, height).scale,
            SheetSize::Width(_) | SheetSize::Pictures(_) => 1.0,
        });
        let gap = gap(scale);
        let no_room = NoComposite::NoRoom { count: count * views.len(), gap };
        let places = [columns, rows].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
        // Remainders become margins of the sheet, so that all pictures have one size, and one scale.
        let share = |side: u32, n: u32, taken: u32| {
            let room = u64::from(side).checked_sub(u64::from(n - 1) * u64::from(gap) + u64::from(n) * u64::from(taken));
            room.and_then(|room| u32::try_from(room / u64::from(n)).ok()).filter(|side| *side > 0).ok_or(no_room)
        };
        let image = request.shot.look.image;
        let wide = if let SheetSize::Pictures(size) = size { size[0] } else { share(width, places[0], 0)? };
        #[expect(clippy::cast_possible_truncation, reason = "a side of a picture")]
        let natural = (f64::from(wide) / image.aspect()).round().clamp(1.0, f64::from(MAX_SIDE)) as u32;
        let guess = Size { width: wide, height: natural, scale };
        let letters = paper.and_then(|paper| Some(paper.pixels(paper.letters?)));
        #[expect(clippy::cast_possible_truncation, reason = "the height of letters")]
        let letters = letters.map_or(guess.letters(), |letters| letters as f32);
        let captions = self.captioned(request, views.len(), columns, letters);
        let below = caption_height(&captions, wide as f32);
        let high = match size {
            SheetSize::Whole(_) => share(height, places[1], below)?,
            SheetSize::Width(_) => natural,
            SheetSize::Pictures(size) => size[1],
        };
        let total = |n: u32, side: u32| u64::from(n) * u64::from(side) + u64::from(n - 1) * u64::from(gap);
        let whole = match size {
            SheetSize::Whole(_) => [width, height].map(u64::from),
            _ => [total(places[0], wide), total(places[1], high + below)],
        };
        if whole[0] * whole[1] > MAX_PIXELS || whole.iter().any(|side| *side > u64::from(MAX_SIDE)) {
            return Err(NoComposite::TooLarge);
        }
        let mut sizes = [Size { width: wide, height: high, scale }];
        let crowded = paper.and_then(|paper| lettered(&mut sizes, paper));
        let requests = self.requests(request, sizes[0], columns, paper);
        // Images without names have enough space.
        let has_names = |own: &Request| own.view != View::Image || own.shot.has_names();
        let crowded = crowded.filter(|_| requests.iter().any(has_names));
        let ground = Palette::of(request.shot.look.style.theme).paper;
        let ground = if request.finish.transparent { ground.with_alpha(0) } else { ground };
        let least = if let SheetSize::Whole(size) = size { size } else { [0, 0] };
        let grid = Some(Grid { columns, captions, below, least });
        Ok(Composite { requests, arrangement: Arrangement::Row, gap, ground, crowded, grid, width: None })
    }

    /// The pictures, in the order of their places.
    fn requests(&self, request: &Request, size: Size, columns: usize, paper: Option<&OnPaper>) -> Vec<Request> {
        let of_view = |view| {
            let picture = |(Variant { figure, camera, .. }, scene): &(Variant, SharedScene)| {
                let shot = Shot::of(figure);
                let template = Request { camera: camera.clone(), scene: scene.clone(), ..request.clone() };
                of(&template, &shot.picture(view), size, &shot, paper)
            };
            let pictures: Vec<Request> = self.members.iter().map(picture).collect();
            with_observer(pictures, self.observer_of.as_ref())
        };
        let of_views: Vec<Vec<Request>> = self.views.views().map(of_view).collect();
        let starts = (0..self.members.len()).step_by(columns.max(1));
        let row = |start: usize| of_views.iter().flat_map(move |all| all.iter().skip(start).take(columns).cloned());
        starts.flat_map(row).collect()
    }

    fn captioned(&self, request: &Request, views: usize, columns: usize, letters: f32) -> Captions {
        let rows = self.members.chunks(columns.max(1));
        let each = rows.flat_map(|row| std::iter::repeat_n(row, views).flatten());
        let values: Vec<_> = each.map(|(variant, _)| &*variant.at).collect();
        let theme = request.shot.look.style.theme;
        Captions::of(&values, &self.captions, self.parts, request.labels, (letters, theme))
    }

    /// A number of columns that leaves space for letters, and makes rows even.
    fn usual_columns(&self, views: usize, size: SheetSize, paper: Option<&OnPaper>) -> usize {
        let count = self.members.len();
        // If there are several variations, the values of the last one form a row.
        let first = self.members.first().map(|(variant, _)| &variant.at[..variant.at.len().saturating_sub(1)]);
        let in_row = self
            .members
            .iter()
            .take_while(|(variant, _)| Some(&variant.at[..variant.at.len().saturating_sub(1)]) == first);
        let row = in_row.count();
        if row < count || views > 1 {
            return row;
        }
        let width = match size {
            SheetSize::Whole([width, _]) | SheetSize::Width(width) => Some(f64::from(width)),
            SheetSize::Pictures(_) => None,
        };
        // There is space for the requested letters, or at least for legible ones.
        let most_of = |least: f64| {
            let fit = |columns: &usize| width.is_none_or(|width| width / *columns as f64 >= least);
            (1..=MOST_COLUMNS.min(count)).rev().find(fit).unwrap_or(1)
        };
        let most = paper.map_or(MOST_COLUMNS.min(count), |paper| {
            let [wanted, least] = paper.least_widths().map(most_of);
            if wanted > 1 { wanted } else { least }
        });
        // The same number of rows, with as few columns as possible.
        count.div_ceil(count.div_ceil(most).max(1))
    }
}
