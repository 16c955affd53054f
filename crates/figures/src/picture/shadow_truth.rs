//! Compares shadow maps with rays, pixel by pixel, and finds where the shadows of a picture aren't those of the scene.

use std::sync::Arc;

use rayon::prelude::*;
use tiny_skia::Pixmap;

use crate::appearance::{DepthFormat, FaceOrder, HiddenLines, Rgba, Samples, Shading, Style, Theme, Visibility};
use crate::camera::{Camera, ImageSize};
use crate::drawing::{Base, BlockedLight, Drawing, SurfaceLight};
use crate::figure::{Depth, ShadowReveal};
use crate::limits::{MAX_RAY_TRIANGLES, MAX_STEPPED_PIXELS};
use crate::pipeline::shadow_rays::{Solids, to_light};
use crate::pipeline::{Options, Pipeline, Target};
use crate::progress::{Progress, pause};
use crate::raster::Rasterizer;
use crate::scene::{Light, Object, Scene};
use crate::views::{Request, ShadowTruth, SharedScene, View};

/// Light that's either all or nothing.
const ALL: [f32; 2] = [1.0, 0.0];
/// Rows of pixels between two pauses.
const ROWS: u32 = 16;
/// Within this part of a pixel of an edge, the rasterizer may draw another face than the ray meets.
const BESIDE: f64 = 0.01;
/// Number of cached pictures: the two sides of a comparison.
const KEPT: usize = 2;

/// The shadow map's answer at a pixel, compared with a ray to the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// No verdict: no face, one that receives no light or is turned away from it, or the edge of a face.
    None,
    /// Light or shadow, in agreement with the ray.
    Right,
    /// In shadow, although the ray reaches the light, because a face shadows itself.
    WronglyDark,
    /// In the light, although something stops the ray. The shadow is detached.
    WronglyLit,
}

impl Verdict {
    /// True if the map is wrong.
    pub const fn is_wrong(self) -> bool {
        matches!(self, Self::WronglyDark | Self::WronglyLit)
    }
}

/// The scene for judging shadows: its opaque faces, under one light.
pub fn under(scene: &Scene, light: Light) -> Scene {
    let plain = |object: &Object| Object { edges: None, outline: None, ..object.clone() };
    let opaque = scene.objects.iter().filter(|object| object.faces && !object.paint.is_translucent());
    Scene { objects: opaque.map(plain).collect(), lights: vec![light], ..Scene::default() }
}

/// A drawing of a scene [`under`] one light, whose pixels are the share of it that arrives according to the shadow map,
/// from black to white, one sample per pixel.
pub fn arriving(pipeline: &mut Pipeline, scene: &Scene, camera: &Camera, image: ImageSize) -> Drawing {
    let (white, black) = (Rgba::rgb(255, 255, 255), Rgba::rgb(0, 0, 0));
    let style = Style {
        shading: Shading::Flat,
        visibility: Visibility::DepthBuffer,
        hidden_lines: HiddenLines::Hidden,
        antialias: Samples::One,
        theme: Theme::Light,
        depth_format: DepthFormat::Float,
        order: FaceOrder::AsListed,
    };
    let target = Target { width: image.width, height: image.height, scale: 1.0, background: black };
    let mut drawing = pipeline.frame(scene, camera, target, &style, Options::default()).drawing;
    for surface in &mut drawing.surfaces {
        surface.base = Base::Solid(white);
        if surface.shadows.is_empty() {
            surface.light = SurfaceLight::InBase;
            continue;
        }
        let all = vec![ALL; surface.triangles.len()];
        surface.shadows.iter_mut().for_each(|shadow| shadow.taken = BlockedLight::Faces(all.clone()));
        surface.light = SurfaceLight::Faces(all);
    }
    drawing
}

/// The truth of shadows at each pixel of an image: true if a light reaches the visible point.
#[derive(Clone, Debug)]
pub struct TrueLight {
    image: ImageSize,
    /// Row by row, the triangle and whether it's lit; `None` if there's no verdict.
    seen: Vec<Option<(usize, bool)>>,
}

impl TrueLight {
    /// Casts rays through each pixel of an image, and on to a light. `None` if it was cancelled. It pauses on the way.
    pub async fn by_rays(
        solids: &Solids,
        camera: &Camera,
        light: &Light,
        image: ImageSize,
        progress: &Progress,
    ) -> Option<Self> {
        let seen = |pixel| {
            let seen = solids.seen(camera, image, pixel)?;
            let is_turned_to_it = seen.lit && seen.normal.dot(to_light(seen.point, light).0) > 0.0;
            is_turned_to_it.then(|| (seen.triangle, solids.is_lit(seen.point, seen.triangle, light)))
        };
        let seen = by_rows(image, progress, |pixel, _| seen(pixel.map(center))).await?;
        Some(Self { image, seen })
    }

    /// The verdict at each pixel, row by row, from the pixels of a drawing of the light [`arriving`]. `None` if it was
    /// cancelled. It pauses on the way.
    pub async fn judge(
        &self,
        arriving: &Pixmap,
        solids: &Solids,
        camera: &Camera,
        progress: &Progress,
    ) -> Option<Vec<Verdict>> {
        let (image, shares) = (self.image, arriving.data());
        let verdict = |pixel: [u32; 2], at: usize| {
            let Some((triangle, is_truly_lit)) = self.seen.get(at).copied().flatten() else { return Verdict::None };
            let is_lit = shares.get(4 * at).is_some_and(|&red| red > 127);
            if is_lit == is_truly_lit {
                return Verdict::Right;
            }
            let [x, y] = pixel.map(center);
            let is_inside = [[BESIDE, 0.0], [-BESIDE, 0.0], [0.0, BESIDE], [0.0, -BESIDE]].iter().all(|[dx, dy]| {
                solids.seen(camera, image, [x + dx, y + dy]).is_some_and(|beside| beside.triangle == triangle)
            });
            match is_lit {
                _ if !is_inside => Verdict::None,
                true => Verdict::WronglyLit,
                false => Verdict::WronglyDark,
            }
        };
        by_rows(image, progress, verdict).await
    }
}

/// A value for each pixel, by its column and row and by its place among all. `None` if it was cancelled. It pauses
/// on the way.
pub async fn by_rows<T: Send>(
    image: ImageSize,
    progress: &Progress,
    of: impl Fn([u32; 2], usize) -> T + Sync,
) -> Option<Vec<T>> {
    let mut found = Vec::with_capacity((image.width * image.height) as usize);
    for first in (0..image.height).step_by(ROWS as usize) {
        let row = |j: u32| (0..image.width).map(|i| of([i, j], (j * image.width + i) as usize)).collect();
        let rows: Vec<Vec<T>> = (first..image.height.min(first + ROWS)).into_par_iter().map(row).collect();
        found.extend(rows.into_iter().flatten());
        if progress.is_cancelled() {
            return None;
        }
        pause().await;
    }
    Some(found)
}

/// The middle of a pixel, along one axis.
pub fn center(pixel: u32) -> f64 {
    f64::from(pixel) + 0.5
}

/// The truth of the last pictures.
#[derive(Clone, Debug, Default)]
pub(super) struct FoundShadows {
    kept: Vec<(ShadowKey, Arc<ShadowTruth>)>,
}

/// The inputs of the truth of a picture's shadows.
#[derive(Clone, Debug, PartialEq)]
struct ShadowKey {
    camera: Camera,
    scene: SharedScene,
    image: ImageSize,
}

impl FoundShadows {
    /// The places where the shadow maps of the image of a request are wrong; `None` if that isn't shown, or was
    /// cancelled.
    pub(super) async fn of(&mut self, request: &Request, progress: &Progress) -> Option<Arc<ShadowTruth>> {
        let look = &request.shot.look;
        let is_shown = request.view == View::Image
            && look.reveal.shadows == Some(ShadowReveal::Truth)
            && look.reveal.depth == Depth::Off
            && !look.reveal.divide_first
            && look.style.shading != Shading::Wireframe;
        if !is_shown || !request.scene.lights.iter().any(|light| light.shadows.cast) {
            return None;
        }
        let (camera, scene) = (request.camera.clone(), request.scene.clone());
        let key = ShadowKey { camera, scene, image: look.image };
        if let Some((_, truth)) = self.kept.iter().find(|(of, _)| *of == key) {
            return Some(Arc::clone(truth));
        }
        let truth = Arc::new(truth(&key, progress).await?);
        self.kept.truncate(KEPT - 1);
        self.kept.insert(0, (key, Arc::clone(&truth)));
        Some(truth)
    }
}

async fn truth(key: &ShadowKey, progress: &Progress) -> Option<ShadowTruth> {
    let ShadowKey { camera, scene, image } = key;
    let pixels = u64::from(image.width) * u64::from(image.height);
    if pixels > MAX_STEPPED_PIXELS || Solids::count(scene) > MAX_RAY_TRIANGLES {
        return Some(ShadowTruth::TooMuch);
    }
    let solids = Solids::of(scene);
    pause().await;
    let mut all: Vec<Verdict> = Vec::new();
    let (mut pipeline, mut rasterizer, mut pixmap) = (Pipeline::default(), Rasterizer::default(), Pixmap::new(1, 1)?);
    rasterizer.watch(progress);
    for light in scene.lights.iter().filter(|light| light.shadows.cast) {
        let drawing = arriving(&mut pipeline, &under(scene, *light), camera, *image);
        if !rasterizer.paint_into(&drawing, &mut pixmap).await || progress.is_cancelled() {
            return None;
        }
        let truly = TrueLight::by_rays(&solids, camera, light, *image, progress).await?;
        let of_light = truly.judge(&pixmap, &solids, camera, progress).await?;
        if all.is_empty() {
            all = of_light;
            continue;
        }
        // Wrong for any light, or right for any.
        let rank = |verdict: Verdict| (verdict.is_wrong(), verdict != Verdict::None);
        all.iter_mut().zip(of_light).filter(|(old, new)| rank(*new) > rank(**old)).for_each(|(old, new)| *old = new);
    }
    let (mut rows, width) = (Vec::new(), image.width.max(1) as usize);
    for (j, row) in (0..).zip(all.chunks(width)) {
        let mut i = 0;
        for run in row.chunk_by(|a, b| a.is_wrong() == b.is_wrong()) {
            let after = i + u32::try_from(run.len()).unwrap_or(u32::MAX);
            if run.first().is_some_and(|verdict| verdict.is_wrong()) {
                rows.push([j, i, after]);
            }
            i = after;
        }
    }
    let of = all.iter().filter(|verdict| **verdict != Verdict::None).count();
    Some(ShadowTruth::Found { rows, of })
}
