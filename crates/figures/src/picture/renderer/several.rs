//! Several pictures at the same time, and sheets of them.

use tiny_skia::{IntRect, Pixmap, PixmapPaint, Transform};

use super::Renderer;
use crate::appearance::Shading;
use crate::export::crop;
use crate::picture::{Composite, Pixels, RenderReport};
use crate::pipeline::OverBudget;
use crate::progress::at_once;
use crate::views::{Request, SharedScene, View};

/// Number of pictures made at the same time. More would need more memory, and a large one has several threads.
const AT_ONCE: usize = View::COUNT;

impl Renderer {
    /// Several pictures, each as in [`pixels_into`](Self::pixels_into), at the same time if there are threads, but then
    /// without a pause, because one of the threads is always making part of a picture. `None` if one of the results is.
    pub async fn all_into(&mut self, requests: &[Request], pictures: &mut [Pixels]) -> Option<Vec<RenderReport>> {
        let jobs = requests.iter().zip(pictures);
        if rayon::current_num_threads() < 2 {
            let mut reports = Vec::with_capacity(requests.len());
            for (request, picture) in jobs {
                reports.push(self.pixels_into(request, picture).await?);
            }
            return Some(reports);
        }
        self.paint_shadows(requests);
        let count = AT_ONCE.min(requests.len());
        let mut beside = std::mem::take(&mut self.beside);
        beside.resize_with(beside.len().max(count.saturating_sub(1)), || Self::sharing(&self.shadow_maps));
        for other in &mut beside {
            other.measure(self.clock);
            // Reports the progress of this one.
            other.watch(&self.progress.part());
        }
        let mut reports: Vec<Option<RenderReport>> = requests.iter().map(|_| None).collect();
        let mut shares: Vec<Vec<_>> = (0..count).map(|_| Vec::new()).collect();
        for (k, job) in jobs.zip(&mut reports).enumerate() {
            shares[k % count].push(job);
        }
        // Threads of the pool. One that shares a part with others begins it at once, and needn't be woken. While it
        // waits for them it may make another picture, so the data that pictures share is prepared without the pool.
        rayon::scope(|scope| {
            for (renderer, share) in [&mut *self].into_iter().chain(&mut beside).zip(shares) {
                scope.spawn(move |_| {
                    for ((request, picture), report) in share {
                        *report = at_once(renderer.pixels_into(request, picture));
                    }
                });
            }
        });
        self.beside = beside;
        reports.into_iter().collect()
    }

    /// Paints the shadow maps of pictures made at the same time. Otherwise each would paint them.
    fn paint_shadows(&mut self, requests: &[Request]) {
        let shaded = requests.iter().filter(|request| request.shot.look.style.shading != Shading::Wireframe);
        let scenes: Vec<&SharedScene> = shaded.map(|request| &request.scene).collect();
        // Only the maps of one scene at a time are kept.
        let Some(scene) = scenes.first() else { return };
        self.shadow_maps.clone().paint_alone(|maps| {
            for map in maps.of_scene((&***scene).into()) {
                at_once(self.rasterizer.paint_shadows(&map));
            }
        });
    }

    /// The pictures of a sheet (if there's only one, the picture itself), and the shortfall of any of them. With
    /// `crop`, each is without the empty background around it. `None` as for [`pixels`](Self::pixels), and without
    /// pictures.
    pub async fn sheet(&mut self, sheet: &Composite, crop: bool) -> Option<(Pixels, Option<OverBudget>)> {
        let mut pictures = vec![Pixels::default(); sheet.requests.len()];
        let reports = self.all_into(&sheet.requests, &mut pictures).await?;
        let over_budget = reports.into_iter().find_map(|report| report.over_budget);
        if crop {
            pictures = cropped(pictures, sheet)?;
        }
        if pictures.len() == 1 && sheet.grid.is_none() {
            return Some((pictures.pop()?, over_budget));
        }
        let sizes: Vec<[u32; 2]> = pictures.iter().map(Pixels::size).collect();
        let layout = sheet.layout(&sizes, crop)?;
        let mut whole = Pixels::arranged(pictures, &layout, sheet.ground)?;
        let mut pixmap = whole.take_pixmap()?;
        for ([left, top], strip) in sheet.strips(&layout, &sizes) {
            let texts = self.rasterizer.paint(&strip)?;
            let (left, top) = (i32::try_from(left).ok()?, i32::try_from(top).ok()?);
            pixmap.draw_pixmap(left, top, texts.as_ref(), &PixmapPaint::default(), Transform::identity(), None);
        }
        Some((pixmap.into(), over_budget))
    }
}

/// The pictures of a sheet without the empty background around each, except for the part that gives the sheet the
/// requested width.
fn cropped(pictures: Vec<Pixels>, sheet: &Composite) -> Option<Vec<Pixels>> {
    let pixmaps: Vec<Pixmap> = pictures.into_iter().map(|mut picture| picture.take_pixmap()).collect::<Option<_>>()?;
    let parts = sheet.kept(pixmaps.iter().map(|pixmap| crop::part(pixmap, sheet.gap)).collect());
    let kept = |(pixmap, [left, top, width, height]): (&Pixmap, [u32; 4])| {
        let rect = IntRect::from_xywh(i32::try_from(left).ok()?, i32::try_from(top).ok()?, width, height)?;
        Some(Pixels::from(pixmap.clone_rect(rect)?))
    };
    pixmaps.iter().zip(parts).map(kept).collect()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::picture::renderer::tests::request;
    use crate::progress::Progress;
    use crate::views::{Finish, Shot, Size, Views};

    #[test]
    fn pictures_of_a_sheet_are_cropped_and_transparent_gaps_stay_clear() {
        let pixel = |picture: &Pixels, [x, y]: [u32; 2]| {
            let at = 4 * (y * picture.width() + x) as usize;
            <[u8; 4]>::try_from(&picture.rgba()[at..at + 4]).unwrap()
        };
        let request =
            Request { size: Size { width: 720, height: 200, scale: 1.0 }, ..request(View::Image, "depth-buffer") };
        let sheet = |transparent| {
            let finish = Finish { transparent, ..Finish::default() };
            let request = Request { finish, ..request.clone() };
            Composite::of(Views::All, &request, &Shot::default(), None).unwrap()
        };
        let (whole, _) = at_once(Renderer::default().sheet(&sheet(false), false)).unwrap();
        let (clear, _) = at_once(Renderer::default().sheet(&sheet(true), false)).unwrap();
        let first = sheet(false).requests[0].size;
        let gap = [first.width + 1, 100];
        assert_eq!((pixel(&whole, gap)[3], pixel(&clear, gap)), (255, [0; 4]));

        let (cropped, _) = at_once(Renderer::default().sheet(&sheet(false), true)).unwrap();
        let each: Vec<Pixels> = sheet(false)
            .requests
            .iter()
            .map(|request| Renderer::default().pixels(request).unwrap().cropped(sheet(false).gap))
            .collect();
        let wide: u32 = each.iter().map(Pixels::width).sum();
        assert_eq!(cropped.width(), wide + 2 * sheet(false).gap);
        assert_eq!(cropped.height(), each.iter().map(Pixels::height).max().unwrap());
        assert!(each.iter().all(|picture| picture.width() < first.width), "there was ground to crop");
    }

    #[test]
    fn pictures_at_the_same_time_are_those_one_after_the_other() {
        let requests: Vec<Request> = ["depth-buffer", "bsp"]
            .iter()
            .flat_map(|visibility| View::ALL.map(|view| request(view, visibility)))
            .collect();
        let mut renderer = Renderer::default();
        // On any machine.
        let threads = rayon::ThreadPoolBuilder::new().num_threads(4).build().unwrap();
        let all = |renderer: &mut Renderer, pictures: &mut [Pixels]| {
            threads.install(|| at_once(renderer.all_into(&requests, pictures)))
        };
        for _ in 0..2 {
            let mut pictures = vec![Pixels::default(); requests.len()];
            let reports = all(&mut renderer, &mut pictures).unwrap();
            assert_eq!(reports.len(), requests.len());
            for (request, picture) in requests.iter().zip(&pictures) {
                assert_eq!(Renderer::default().pixels(request).as_ref(), Some(picture));
            }
            renderer.forget();
        }
        let progress = Progress::default();
        renderer.watch(&progress);
        progress.cancel();
        let mut pictures = vec![Pixels::default(); requests.len()];
        assert!(all(&mut renderer, &mut pictures).is_none());
        assert!(pictures.iter().all(|picture| *picture == Pixels::default()), "none of them was made");
    }
}
