//! One picture, or all three on a sheet, with their sizes, their arrangement, and their gaps.

use crate::appearance::Rgba;
use crate::limits::MAX_PIXELS;
use crate::views::{
    Arrangement, Captions, Finish, ObserverOf, Palette, Picture, Request, Shot, Size, Views, aspect_shown,
    best_arrangement, share_of_first, used_area,
};

/// Room between two pictures on a sheet, in pixels at scale 1.
const GAP: f32 = 4.0;

/// The space that a picture needs, width and height, as multiples of the height of its letters. With less space, names
/// cover their objects.
const ROOM_IN_LETTERS: [f64; 2] = [16.0, 11.0];

/// The height of the smallest letters that are legible on paper, in points.
const LEAST_LETTERS: f64 = 6.0;

/// The settings for paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnPaper {
    /// Pixels per inch.
    pub dpi: f64,
    /// Height of the letters of names in points; `None` means by the scale of the picture. If there are several
    /// pictures whose letters would cover their objects, the letters are smaller, as long as they stay legible. See
    /// [`Composite::crowded`].
    pub letters: Option<f64>,
    /// Width of the edges of solids in points, and other strokes in proportion; `None` means in proportion to the
    /// letters.
    pub lines: Option<f64>,
    /// True if several pictures are arranged so that they become as large as the shape of the paper allows. Otherwise
    /// they're side by side.
    pub arranged: bool,
}

impl OnPaper {
    /// Points in pixels.
    pub fn pixels(&self, points: f64) -> f64 {
        points / 72.0 * self.dpi
    }

    /// Centimetres in pixels, not rounded.
    pub fn pixels_across(&self, centimetres: f64) -> f64 {
        centimetres / 2.54 * self.dpi
    }

    /// The narrowest pictures in which the letters, and the smallest legible ones, don't cover their objects, in
    /// pixels.
    pub(super) fn least_widths(&self) -> [f64; 2] {
        [self.letters.unwrap_or(LEAST_LETTERS), LEAST_LETTERS].map(|letters| ROOM_IN_LETTERS[0] * self.pixels(letters))
    }

    /// Pixels in centimetres.
    fn centimetres(&self, pixels: u32) -> f64 {
        f64::from(pixels) / self.dpi * 2.54
    }
}

/// Several pictures with less space on paper than their letters need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crowded {
    /// Width and height of the smallest picture in centimetres.
    pub smallest: [f64; 2],
    /// The requested height of letters, or else of the smallest legible ones, in points.
    pub wanted: f64,
    /// Width and height in centimetres of a picture with space for those.
    pub room: [f64; 2],
}

/// The reason why there's no sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoComposite {
    /// More pixels than any picture may have.
    #[error("there is not enough memory for an image of this size")]
    TooLarge,
    /// The pictures don't all fit on it.
    #[error("{count} images with gaps of {gap} pixels do not fit on a sheet of this size")]
    NoRoom {
        /// Number of pictures.
        count: usize,
        /// Pixels between two of them.
        gap: u32,
    },
    /// Several pictures of each figure, but the rows wouldn't align them in columns.
    #[error("{count} figures with several images each do not fill rows of {columns}")]
    UnevenRows {
        /// The number of figures.
        count: usize,
        /// The number of columns.
        columns: usize,
    },
}

/// Pictures in rows, with captions.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    /// The number of pictures in a row.
    pub(super) columns: usize,
    /// The texts under them.
    pub(super) captions: Captions,
    /// The space for these, in pixels.
    pub(super) below: u32,
    /// The least size of the sheet in pixels, unless its pictures are cropped.
    pub(super) least: [u32; 2],
}

/// Pictures that belong together, and their layout on a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Composite {
    /// The pictures, in the order of the shot.
    pub requests: Vec<Request>,
    /// Their arrangement on the sheet.
    pub arrangement: Arrangement,
    /// Pixels between two of them.
    pub(super) gap: u32,
    /// The background between them.
    pub(super) ground: Rgba,
    /// The message if several pictures have little space on their paper.
    pub crowded: Option<Crowded>,
    /// The rows of a family, and its captions; `None` means as in the arrangement.
    pub(super) grid: Option<Grid>,
    /// The width of the sheet in pixels once its pictures are cropped; `None` means the width of the rest.
    pub(super) width: Option<u32>,
}

impl Composite {
    /// The first picture of a kind, or all pictures of a shot, with `request` for each of them, seen by its observer.
    /// Together they're as large as `request` says.
    ///
    /// # Errors
    /// [`NoComposite`] if there's no space for all of them, or they'd have more pixels than any picture may have.
    pub fn of(views: Views, request: &Request, shot: &Shot, paper: Option<&OnPaper>) -> Result<Self, NoComposite> {
        // Each of the three may be as large as a picture can be, and so may their sheet.
        let whole = request.size;
        if u64::from(whole.width) * u64::from(whole.height) > MAX_PIXELS {
            return Err(NoComposite::TooLarge);
        }
        let (pictures, arrangement) = match views {
            Views::One(kind) => (vec![shot.picture(kind)], Arrangement::Row),
            Views::All | Views::Without(_) => {
                let pictures = shot.pictures.iter().filter(|picture| views.contains(picture.kind));
                let pictures: Vec<Picture> = pictures.cloned().collect();
                let arranged = paper.is_some_and(|paper| paper.arranged);
                let arrangement = if arranged { best(&pictures, request) } else { Arrangement::Row };
                (pictures, arrangement)
            }
        };
        let (mut sizes, mut crowded) = (vec![whole], None);
        if !matches!(views, Views::One(_)) {
            // Gaps alone aren't pictures.
            let fit = |all: &Vec<Size>| all.iter().all(|s| s.width > 0 && s.height > 0);
            let no_room = NoComposite::NoRoom { count: pictures.len(), gap: gap(whole.scale) };
            sizes = sizes_of(pictures.len(), arrangement, whole).filter(fit).ok_or(no_room)?;
            crowded = paper.and_then(|paper| lettered(&mut sizes, paper));
        }
        let framed = !matches!(views, Views::One(_));
        let request = &Request { finish: Finish { framed, ..request.finish }, ..request.clone() };
        let requests = pictures.iter().zip(sizes).map(|(picture, size)| of(request, picture, size, shot, paper));
        let ground = Palette::of(request.shot.look.style.theme).surround;
        let ground = if request.finish.transparent { ground.with_alpha(0) } else { ground };
        Ok(Self {
            requests: requests.collect(),
            arrangement,
            gap: gap(whole.scale),
            ground,
            crowded,
            grid: None,
            width: None,
        })
    }
}

impl Composite {
    /// The height in points of the smallest letters, if they're too small to be legible on paper with this number of
    /// pixels per inch, and the reason isn't a [`crowded`](Self::crowded) sheet.
    pub fn tiny_letters(&self, dpi: f64) -> Option<f64> {
        let heights = self.requests.iter().map(|request| f64::from(request.size.letters()) * 72.0 / dpi);
        let least = heights.fold(f64::INFINITY, f64::min);
        // A request for 6 points is 6 points, in spite of rounding.
        (self.crowded.is_none() && least < LEAST_LETTERS - 0.01).then_some(least)
    }

    /// The same sheet, with pictures seen by the observers of another figure.
    pub fn seen_by(mut self, other: &ObserverOf) -> Self {
        let requests = self.requests.into_iter().map(|own| {
            let observer = other.observer(&own);
            own.seen_by(observer)
        });
        self.requests = requests.collect();
        self
    }

    /// The same sheet, with everything in each picture that its observer was meant to show, see [`Request::gone_back`].
    pub fn gone_back(mut self) -> Self {
        self.requests = self.requests.into_iter().map(Request::gone_back).collect();
        self
    }

    /// Width and height in pixels, if they're possible.
    pub fn size(&self) -> Option<[u32; 2]> {
        let sizes: Vec<[u32; 2]> = self.requests.iter().map(|own| [own.size.width, own.size.height]).collect();
        Some(self.layout(&sizes, false)?.size)
    }

    /// The same sheet, reduced by a factor with letters and strokes, for a preview.
    pub fn reduced(mut self, factor: f32) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "no more than it was")]
        let side = |side: u32| (side as f32 * factor.min(1.0)).round().max(1.0) as u32;
        for Size { width, height, scale } in self.requests.iter_mut().map(|request| &mut request.size) {
            (*width, *height, *scale) = (side(*width), side(*height), *scale * factor.min(1.0));
        }
        self.gap = side(self.gap);
        self.width = self.width.map(side);
        if let Some(Grid { captions, below, least, .. }) = &mut self.grid {
            captions.letters *= factor.min(1.0);
            *below = side(*below);
            // The pictures are rounded one by one.
            *least = [0, 0];
        }
        self
    }
}

/// One of the pictures.
pub(super) fn of(request: &Request, picture: &Picture, size: Size, shot: &Shot, paper: Option<&OnPaper>) -> Request {
    let Request { camera, scene, labels, .. } = request;
    let Request { view, observer, camera, shot, .. } = Request::of_picture(shot, picture, camera, scene, labels, size);
    let mut request = Request { view, observer, camera, shot, size, ..request.clone() };
    let lettered = paper.is_some_and(|paper| paper.letters.is_some());
    request.finish.framed |= lettered;
    request.finish.least_letters |= lettered;
    if let Some((paper, lines)) = paper.and_then(|paper| Some((paper, paper.lines?))) {
        #[expect(clippy::cast_possible_truncation, reason = "the width of a line")]
        let edges = paper.pixels(lines) as f32;
        request.finish.stroke_factor = Some(size.stroke_factor(edges));
    }
    request
}

/// Gives several pictures the letters of the paper. Returns the message if the smallest hardly has space for them.
/// Names without a place are left out there, but the letters keep the requested height.
pub(super) fn lettered(sizes: &mut [Size], paper: &OnPaper) -> Option<Crowded> {
    let room_of = |size: &Size| {
        let [wide, high] = ROOM_IN_LETTERS;
        (f64::from(size.width) / wide).min(f64::from(size.height) / high)
    };
    let smallest = sizes.iter_mut().min_by(|a, b| room_of(a).total_cmp(&room_of(b)))?;
    let room = room_of(smallest);
    let smallest = [smallest.width, smallest.height].map(|side| paper.centimetres(side));
    let wanted = paper.letters.unwrap_or(LEAST_LETTERS);
    if let Some(letters) = paper.letters {
        #[expect(clippy::cast_possible_truncation, reason = "the height of letters")]
        let letters = paper.pixels(letters) as f32;
        sizes.iter_mut().for_each(|size| *size = Size::with_letters(size.width, size.height, letters));
    }
    (room < paper.pixels(wanted)).then(|| Crowded {
        smallest,
        wanted,
        room: ROOM_IN_LETTERS.map(|letters| letters * wanted / 72.0 * 2.54),
    })
}

/// The arrangement in which pictures use most of a sheet.
fn best(pictures: &[Picture], request: &Request) -> Arrangement {
    let aspects = || pictures.iter().map(|picture| aspect_shown(picture.kind, request.shot.look.image));
    let used = |(size, aspect): (Size, f32)| used_area(size.width as f32, size.height as f32, aspect);
    best_arrangement(pictures.len(), |arrangement| {
        let sizes = sizes_of(pictures.len(), arrangement, request.size);
        sizes.map_or(0.0, |sizes| sizes.into_iter().zip(aspects()).map(used).sum())
    })
}

/// The sizes of this number of pictures on a sheet; `None` if there's no space for them.
fn sizes_of(count: usize, arrangement: Arrangement, sheet: Size) -> Option<Vec<Size>> {
    let gap = gap(sheet.scale);
    let wide = |width| Size { width, ..sheet };
    let high = |height, of: Size| Size { height, ..of };
    Some(match arrangement {
        Arrangement::Row => parts(count, sheet.width, gap)?.map(wide).collect(),
        Arrangement::Column => parts(count, sheet.height, gap)?.map(|height| high(height, sheet)).collect(),
        Arrangement::Above => {
            let [first, rest] = first_and_rest(sheet.height, gap, arrangement)?;
            let others = parts(count.checked_sub(1)?, sheet.width, gap)?.map(|width| high(rest, wide(width)));
            std::iter::once(high(first, sheet)).chain(others).collect()
        }
        Arrangement::Beside => {
            let [first, rest] = first_and_rest(sheet.width, gap, arrangement)?;
            let others = parts(count.checked_sub(1)?, sheet.height, gap)?.map(|height| high(height, wide(rest)));
            std::iter::once(wide(first)).chain(others).collect()
        }
    })
}

/// Equal parts of a length with gaps between them. The remainder goes to the first ones, a pixel each.
fn parts(count: usize, length: u32, gap: u32) -> Option<impl Iterator<Item = u32>> {
    let count = u32::try_from(count).ok()?;
    let room = length.checked_sub(count.checked_sub(1)?.checked_mul(gap)?)?;
    Some((0..count).rev().map(move |later| (room + later) / count))
}

/// The lengths of the first picture and of the others.
fn first_and_rest(length: u32, gap: u32, arrangement: Arrangement) -> Option<[u32; 2]> {
    let room = length.checked_sub(gap)?;
    #[expect(clippy::cast_possible_truncation, reason = "a share of the room")]
    let first = (f64::from(room) * f64::from(share_of_first(arrangement))).round() as u32;
    Some([first, room - first])
}

/// Room between two pictures on a sheet, in pixels.
pub fn gap(scale: f32) -> u32 {
    #[expect(clippy::cast_possible_truncation, reason = "a small positive number")]
    let gap = (GAP * scale).round().clamp(1.0, 100.0) as u32;
    gap
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::Camera;
    use crate::figure::Figure;
    use crate::scene::Scene;
    use crate::views::{SharedScene, View, unlabelled};

    fn three(arrangement: Arrangement, sheet: Size) -> [Size; 3] {
        sizes_of(3, arrangement, sheet).unwrap().try_into().unwrap()
    }

    /// A sheet of the default figure, of this size in pixels.
    fn sheet(views: Views, [width, height]: [u32; 2], paper: Option<OnPaper>) -> Composite {
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        let size = Size { width, height, scale: 1.0 };
        let scene = SharedScene::new(Scene::default());
        let request = Request::of(&figure, View::Image, &camera, &scene, unlabelled(), size);
        Composite::of(views, &request, &Shot::of(&figure), paper.as_ref()).unwrap()
    }

    const PAPER: OnPaper = OnPaper { dpi: 300.0, letters: Some(9.0), lines: None, arranged: true };

    #[test]
    fn the_pictures_and_the_gaps_between_them_are_the_sheet() {
        for (width, height, scale) in [(200, 100, 1.0), (201, 77, 1.0), (202, 300, 1.0), (9, 9, 1.0), (1000, 400, 2.5)]
        {
            let (size, gap) = (Size { width, height, scale }, gap(scale));
            for arrangement in Arrangement::ALL {
                let [a, b, c] = three(arrangement, size).map(|size| [size.width, size.height]);
                let (wide, high) = match arrangement {
                    Arrangement::Row => (a[0] + b[0] + c[0] + 2 * gap, [a[1], b[1], c[1]]),
                    Arrangement::Column => (a[0], [a[1] + b[1] + c[1] + 2 * gap; 3]),
                    Arrangement::Above => (b[0] + c[0] + gap, [a[1] + b[1] + gap, a[1] + c[1] + gap, height]),
                    Arrangement::Beside => (a[0] + b[0] + gap, [a[1], b[1] + c[1] + gap, height]),
                };
                assert_eq!((wide, high), (width, [height; 3]), "{arrangement:?}");
            }
            let [a, b, c] = three(Arrangement::Row, size).map(|size| size.width);
            assert!(a >= b && b >= c && a - c <= 1, "{a} {b} {c}");
        }
        for arrangement in Arrangement::ALL {
            assert_eq!(sizes_of(3, arrangement, Size { width: 3, height: 3, scale: 1.0 }), None);
        }
    }

    #[test]
    fn on_paper_three_pictures_are_arranged_for_its_shape_and_elsewhere_side_by_side() {
        let of = |size, paper| sheet(Views::All, size, paper).arrangement;
        assert_eq!(of([945, 709], Some(PAPER)), Arrangement::Beside);
        assert_eq!(of([900, 900], Some(PAPER)), Arrangement::Above);
        assert_eq!(of([2000, 480], Some(PAPER)), Arrangement::Row);
        assert_eq!(of([500, 1600], Some(PAPER)), Arrangement::Column);
        assert_eq!(of([945, 709], None), Arrangement::Row);
        assert_eq!(of([945, 709], Some(OnPaper { arranged: false, ..PAPER })), Arrangement::Row);
    }

    #[test]
    fn letters_have_their_height_and_pictures_without_room_for_them_are_named() {
        let heights = |size, paper: OnPaper| {
            let sheet = sheet(Views::All, size, Some(paper));
            let letters: Vec<f32> = sheet.requests.iter().map(|request| request.size.letters()).collect();
            assert!(letters.iter().all(|height| (height - letters[0]).abs() < 0.01 * height), "{letters:?}");
            (f64::from(letters[0]) / paper.dpi * 72.0, sheet.crowded)
        };
        let about = |a: f64, b: f64| assert!((a - b).abs() < 0.02 * b, "{a} {b}");
        // 16 × 12 cm: 9 points have space.
        let (letters, crowded) = heights([1890, 1417], PAPER);
        about(letters, 9.0);
        assert_eq!(crowded, None);
        // 8 × 6 cm: the two at the right are 3.5 cm wide.
        let (letters, crowded) = heights([945, 709], PAPER);
        let crowded = crowded.unwrap();
        about(letters, 9.0);
        about(crowded.smallest[0], 3.5);
        assert_eq!(crowded.wanted, 9.0);
        about(crowded.room[0], 16.0 * 9.0 / 72.0 * 2.54);
        // 3 × 2 cm.
        about(heights([354, 236], PAPER).0, 9.0);
        about(heights([354, 236], OnPaper { letters: Some(4.0), ..PAPER }).0, 4.0);
        // A single picture has the requested letters.
        assert_eq!(sheet(Views::One(View::World), [354, 236], Some(PAPER)).crowded, None);
    }

    #[test]
    fn a_smaller_sheet_has_the_same_proportions_in_letters_too() {
        for (size, factor) in [([6000, 3000], 0.12), ([945, 709], 0.7), ([400, 4000], 0.12)] {
            let whole = sheet(Views::All, size, Some(PAPER));
            let small = whole.clone().reduced(factor);
            for (whole, small) in whole.requests.iter().zip(&small.requests) {
                assert!((small.size.width as f32 - factor * whole.size.width as f32).abs() <= 0.5, "{small:?}");
                assert!((small.size.letters() / whole.size.letters() / factor - 1.0).abs() < 0.02, "{small:?}");
            }
            assert_eq!((small.arrangement, small.crowded), (whole.arrangement, whole.crowded));
            assert_eq!(whole.clone().reduced(2.0), whole, "nothing is enlarged");
        }
    }

    #[test]
    fn lines_are_as_wide_as_they_are_asked_for_in_each_picture() {
        let widths = |lines| {
            let sheet = sheet(Views::All, [1890, 1417], Some(OnPaper { lines, ..PAPER }));
            let width = |request: &Request| Some(request.size.letters() / 14.0 * request.finish.stroke_factor?);
            sheet.requests.iter().map(width).collect::<Vec<_>>()
        };
        assert_eq!(widths(None), [None; 3]);
        // 1.2 points are 5 pixels at 300 per inch.
        for width in widths(Some(1.2)) {
            assert!((width.unwrap() - 5.0).abs() < 0.01, "{width:?}");
        }
    }
}
