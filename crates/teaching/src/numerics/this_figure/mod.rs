//! Error, time and memory of the figure at hand: which of the ways to draw it is the cheapest whose image can't be told
//! from the exact one?
//!
//! The choices are the keys that this scene doesn't make irrelevant. Each combination is drawn and compared with the
//! exact image. All are timed in turns, so that whatever slows the machine slows them alike.
//!
//! Up to 64 combinations are all tried. Above that, values that can't be part of an answer are dropped, in
//! groups of keys that interact: first those that others beat and that are worse than the best by more than the
//! tolerance, then all that others beat. Then the two smallest groups become one. Errors and bytes decide, never a
//! clock.

mod chart;
mod choices;
mod savings;
mod tables;

use std::collections::HashMap;
use std::sync::Arc;

use crate::appearance::{FaceOrder, Samples, Shading, Visibility};
use crate::camera::ImageSize;
use crate::clock;
use crate::drawing::{Base, Drawing, Rays, ShadowMap, SurfaceLight};
use crate::figure::{Figure, Reveal, Show};
use crate::numerics::diagnosis::{Counter, ImageSpec, wrong_faces};
use crate::numerics::times::{Interval, decide};
pub use crate::picture::exact_image::{ExactImage, NoExactImage, SAMPLES};
use crate::picture::{Pixels, Renderer, exact_image};
use crate::progress::{Activity, Progress};
use crate::scene::Scene;
use crate::views::{Labels, Request, SharedScene, Size, View, image_frame};
pub use chart::ChartWords;
pub use choices::{Choice, Key, LeftOut, Value, WhyNot, apply};
use choices::{Combination, canonical, chosen};
pub use savings::{Saving, savings};

/// Up to this many combinations are all tried.
const ALL_TRIED: usize = 64;
/// A channel that differs by more than this, of 255, makes its pixel differ.
pub const VISIBLE: u8 = 4;
/// A combination whose share of differing pixels is at most this above the best one's can't be told from it.
pub const WITHIN: f64 = 0.001;
/// Seconds for timing.
pub const SECONDS: f64 = 10.0;
/// More rounds add nothing new.
const MOST_ROUNDS: usize = 1000;

/// The figure to examine.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The figure.
    pub figure: &'a Figure,
    /// Its scene.
    pub scene: &'a SharedScene,
    /// The request for its image.
    pub request: &'a Request,
}

/// The effort of a study.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Seconds for timing. 0 means one round.
    pub seconds: f64,
    /// See [`WITHIN`].
    pub within: f64,
}

impl Default for Effort {
    fn default() -> Self {
        Self { seconds: SECONDS, within: WITHIN }
    }
}

/// One way to draw the figure.
#[derive(Clone, Debug)]
pub struct Way {
    /// The place of its value, for each choice.
    pub combination: Vec<usize>,
    /// Its difference from the exact image, and its bytes.
    pub cost: Cost,
    /// Milliseconds of each round.
    pub rounds: Vec<f64>,
    /// Milliseconds of a frame: median, and an interval that holds it with 95 %.
    pub ms: Interval,
    /// No other way has at most its errors and bytes, and an interval of time wholly below its own.
    pub front: bool,
    /// More rounds could change [`front`](Self::front).
    pub undecided: bool,
}

/// Errors and bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// The share of pixels of which a channel differs by more than 4 of 255 from the exact image.
    pub different: f64,
    /// The share of pixels that show another face than exact visibility.
    pub wrong: f64,
    /// Root mean square of the differences in linear light, 0 … 1.
    pub rms: f64,
    /// Bytes of image, samples, depths, shadow maps and faces.
    pub bytes: usize,
}

impl Cost {
    /// True if neither an error nor the bytes are greater.
    pub(super) fn is_at_most(&self, other: &Self) -> bool {
        self.different <= other.different && self.rms <= other.rms && self.bytes <= other.bytes
    }
}

/// The result.
#[derive(Clone, Debug)]
pub struct Study {
    /// Size of the image, pixels.
    pub size: [u32; 2],
    /// The keys that were tried.
    pub choices: Vec<Choice>,
    /// The keys that weren't.
    pub left_out: Vec<LeftOut>,
    /// Sections of the figure that the study leaves out: `[reveal]`.
    pub set_aside: Vec<&'static str>,
    /// The exact image.
    pub exact: Arc<ExactImage>,
    /// All ways that were tried.
    pub ways: Vec<Way>,
    /// The place of the figure's own way.
    pub yours: usize,
    /// The place of the cheapest way that can't be told from the best.
    pub cheapest: usize,
    /// The requests of the ways, for their images.
    pub requests: Arc<Vec<Request>>,
}

impl Study {
    /// The least share of differing pixels of all ways.
    pub fn best(&self) -> f64 {
        self.ways.iter().map(|way| way.cost.different).fold(f64::INFINITY, f64::min)
    }

    /// The keys of a way with their values.
    pub fn set(&self, way: &Way) -> impl Iterator<Item = (Key, Value)> {
        self.choices.iter().zip(&way.combination).map(|(choice, &place)| (choice.key, choice.values[place]))
    }

    /// The keys in which a way differs from the figure, with the way's values.
    pub fn changes(&self, way: &Way) -> Vec<(Key, Value)> {
        changes(&self.choices, &way.combination)
    }
}

/// The keys in which a combination differs from the figure, with its values.
fn changes(choices: &[Choice], combination: &[usize]) -> Vec<(Key, Value)> {
    let changed = choices.iter().zip(combination).filter(|(choice, place)| choice.own != **place);
    changed.map(|(choice, &place)| (choice.key, choice.values[place])).collect()
}

/// The request for the image of a figure without the parts that a study sets aside, and those parts.
pub fn request_of(
    figure: &Figure,
    scene: &SharedScene,
    camera: &crate::camera::Camera,
    labels: &'static Labels,
    size: Size,
) -> (Request, Vec<&'static str>) {
    let plain = Figure {
        reveal: Reveal::default(),
        compare: None,
        photograph: None,
        show: Show { stage: None, painted: None, triangle: None, ..figure.show.clone() },
        ..figure.clone()
    };
    let is_aside = [
        ("[reveal]", figure.reveal != plain.reveal),
        ("[compare]", figure.compare.is_some()),
        ("[image] photograph", figure.photograph.is_some()),
        ("[show]", figure.show != plain.show),
    ];
    let without = || Scene { photograph: None, ..Scene::clone(scene) };
    let scene = if scene.photograph.is_some() { scene.marked(without()) } else { scene.clone() };
    let request = Request::of(&plain, View::Image, camera, &scene, labels, size);
    (request, is_aside.into_iter().filter(|(_, aside)| *aside).map(|(name, _)| name).collect())
}

/// Examines a figure. `partial` is told of the results after each round. It pauses after each image.
///
/// # Errors
/// [`NoExactImage`] says why there's no exact image to compare with.
pub async fn study(
    subject: Subject<'_>,
    effort: Effort,
    progress: &Progress,
    partial: impl Fn(&Study),
) -> Result<Study, NoExactImage> {
    let Subject { figure, scene, request } = subject;
    let exact = Arc::new(exact_image::exact_image(request, progress).await?);
    let mut tried = Tried {
        subject,
        plan_of: Renderer::default(),
        choices: Vec::new(),
        exact: exact.pixels.clone(),
        counter: Counter::default(),
        wrong: HashMap::new(),
        known: HashMap::new(),
        progress: progress.clone(),
    };
    let plain = request.clone().with_shot(|shot| {
        shot.look.style.visibility = Visibility::DepthBuffer;
        shot.look.style.antialias = Samples::Four;
    });
    let plan = tried.plan_of.drawing(&plain).ok_or(NoExactImage::Memory)?.plan;
    let costs = tried.plan_of.costs(&plain, progress).await.ok_or(NoExactImage::Cancelled)?;
    let (all, left_out) = choices::choices(figure, scene, &plan, &costs.fills, &exact.minified);
    tried.choices = all;
    let combinations = tried.combinations(effort.within).await?;
    let mut ways = Vec::new();
    let mut requests = Vec::new();
    for combination in combinations {
        let Some(cost) = tried.cost(&combination).await? else { continue };
        requests.extend(tried.request(&combination));
        ways.push(Way {
            combination,
            cost,
            rounds: Vec::new(),
            ms: Interval::default(),
            front: false,
            undecided: false,
        });
    }
    let own: Combination = tried.choices.iter().map(|choice| choice.own).collect();
    let yours = ways.iter().position(|way| way.combination == own).unwrap_or(0);
    let size = [request.size.width, request.size.height];
    let choices = tried.choices;
    let mut study = Study {
        size,
        choices,
        left_out,
        set_aside: Vec::new(),
        exact,
        ways,
        yours,
        cheapest: yours,
        requests: Arc::new(requests),
    };
    study.time(effort, progress, partial).await?;
    Ok(study)
}

/// The state of trying combinations.
struct Tried<'a> {
    subject: Subject<'a>,
    plan_of: Renderer,
    choices: Vec<Choice>,
    exact: Pixels,
    counter: Counter,
    /// Wrong pixels, by visibility and format.
    wrong: HashMap<Combination, f64>,
    known: HashMap<Combination, Option<Cost>>,
    progress: Progress,
}

impl Tried<'_> {
    fn request(&self, combination: &[usize]) -> Option<Request> {
        chosen(self.subject.request, self.subject.figure, &changes(&self.choices, combination))
    }

    /// Errors and bytes of a combination. `None` if the figure can't have it.
    async fn cost(&mut self, combination: &Combination) -> Result<Option<Cost>, NoExactImage> {
        if let Some(known) = self.known.get(combination) {
            return Ok(*known);
        }
        let Some(request) = self.request(combination) else {
            self.known.insert(combination.clone(), None);
            return Ok(None);
        };
        let mut pixels = Pixels::default();
        self.plan_of.forget();
        self.plan_of.pixels_into(&request, &mut pixels).await.ok_or(NoExactImage::Memory)?;
        let drawing = self.plan_of.drawing(&request).ok_or(NoExactImage::Memory)?.drawing;
        let (different, rms) = difference(&pixels, &self.exact);
        let wrong = self.wrong(combination, &request).await?;
        let cost = Cost { different, wrong, rms, bytes: bytes_of(&drawing) };
        self.known.insert(combination.clone(), Some(cost));
        self.progress.advance_and_pause(1).await;
        Ok(Some(cost))
    }

    /// The share of pixels that show a wrong face. Only visibility and format change it.
    async fn wrong(&mut self, combination: &[usize], request: &Request) -> Result<f64, NoExactImage> {
        let matters = |key: Key| matches!(key, Key::Visibility | Key::DepthFormat);
        let key = self.choices.iter().zip(combination).filter(|(choice, _)| matters(choice.key)).map(|(_, &k)| k);
        let key: Combination = key.collect();
        if let Some(known) = self.wrong.get(&key) {
            return Ok(*known);
        }
        let frame = image_frame(request.size, request.shot.look.image_aspect(&request.camera));
        let style = &request.shot.look.style;
        let spec = ImageSpec {
            scene: &request.scene,
            camera: &request.camera,
            style,
            reveal: &Reveal::default(),
            image: ImageSize { width: frame.width, height: frame.height },
            compared: u64::MAX,
        };
        let count = if style.shading == Shading::Wireframe {
            0
        } else {
            wrong_faces(&spec, &mut self.counter, &self.progress).await.ok_or(NoExactImage::Cancelled)?
        };
        let share = count as f64 / (f64::from(request.size.width) * f64::from(request.size.height));
        self.wrong.insert(key, share);
        Ok(share)
    }

    /// The combinations to time, the figure's own among them.
    async fn combinations(&mut self, within: f64) -> Result<Vec<Combination>, NoExactImage> {
        let own: Combination = self.choices.iter().map(|choice| choice.own).collect();
        // Each group lists combinations in which only its own keys differ from the figure.
        let mut groups: Vec<Vec<Combination>> = Vec::new();
        let mut numbers: Vec<usize> = self.choices.iter().map(|choice| choice.key.group()).collect();
        numbers.dedup();
        for number in numbers {
            let mut group = vec![own.clone()];
            for (k, choice) in self.choices.iter().enumerate().filter(|(_, choice)| choice.key.group() == number) {
                let values = 0..choice.values.len();
                let with = |value: usize| group.iter().map(move |of| with_value(of, k, value));
                group = values.flat_map(with).map(|of| canonical(&self.choices, of)).collect();
            }
            groups.push(distinct(group));
        }
        self.progress.begin(Activity::Measuring, 0);
        let product = |groups: &[Vec<Combination>]| groups.iter().map(Vec::len).fold(1, usize::saturating_mul);
        for strict in [false, true] {
            if product(&groups) <= ALL_TRIED {
                break;
            }
            for group in &mut groups {
                *group = self.pruned(std::mem::take(group), &own, (!strict).then_some(within)).await?;
            }
        }
        while product(&groups) > ALL_TRIED && groups.len() > 1 {
            groups.sort_by_key(Vec::len);
            let pair: Vec<Vec<Combination>> = groups.drain(..2).collect();
            let joined = self.pruned(joined(&pair, &own), &own, Some(within)).await?;
            let joined = if joined.len() > ALL_TRIED { self.pruned(joined, &own, None).await? } else { joined };
            groups.push(joined);
        }
        let all = joined(&groups, &own).into_iter().map(|of| canonical(&self.choices, of)).collect();
        Ok(distinct(all))
    }

    /// A group without the combinations that another of it beats. With a tolerance, only those that are also worse than
    /// the best by more than that. The figure's own stays.
    async fn pruned(
        &mut self,
        group: Vec<Combination>,
        own: &Combination,
        within: Option<f64>,
    ) -> Result<Vec<Combination>, NoExactImage> {
        let mut costs = Vec::with_capacity(group.len());
        for combination in group {
            if let Some(cost) = self.cost(&combination).await? {
                costs.push((combination, cost));
            }
        }
        let best = costs.iter().map(|(_, cost)| cost.different).fold(f64::INFINITY, f64::min);
        let beaten = |k: usize, cost: &Cost| {
            let others = costs.iter().enumerate().filter(|(other, _)| *other != k);
            let mut stronger =
                others.filter(|(other, (_, of))| of.is_at_most(cost) && (!cost.is_at_most(of) || *other < k));
            stronger.next().is_some() && within.is_none_or(|within| cost.different > best + within)
        };
        let stays = |(k, (of, cost)): &(usize, &(Combination, Cost))| of == own || !beaten(*k, cost);
        Ok(costs.iter().enumerate().filter(stays).map(|(_, (of, _))| of.clone()).collect())
    }
}

fn with_value(of: &Combination, choice: usize, value: usize) -> Combination {
    let mut of = of.clone();
    of[choice] = value;
    of
}

/// Every combination of one of each group. Where a group has the figure's own value, another may have its own.
fn joined(groups: &[Vec<Combination>], own: &Combination) -> Vec<Combination> {
    groups.iter().fold(vec![own.clone()], |all, group| {
        let merged = |a: &Combination, b: &Combination| -> Combination {
            a.iter().zip(b).zip(own).map(|((&a, &b), &own)| if b == own { a } else { b }).collect()
        };
        all.iter().flat_map(|a| group.iter().map(move |b| merged(a, b))).collect()
    })
}

/// Each once, in order.
fn distinct(all: Vec<Combination>) -> Vec<Combination> {
    let mut seen = std::collections::HashSet::new();
    all.into_iter().filter(|combination| seen.insert(combination.clone())).collect()
}

impl Study {
    /// Times all ways in turns. Each round begins with another one, and every second one goes backwards, so that no way
    /// always follows the same one.
    async fn time(&mut self, effort: Effort, progress: &Progress, partial: impl Fn(&Self)) -> Result<(), NoExactImage> {
        let (mut renderer, mut pixels) = (Renderer::default(), Pixels::default());
        let end = clock::now() + std::time::Duration::try_from_secs_f64(effort.seconds).unwrap_or_default();
        for round in 0..MOST_ROUNDS {
            progress.begin(Activity::Measuring, self.ways.len());
            for k in 0..self.ways.len() {
                let k = turn(k, round, self.ways.len());
                let start = clock::now();
                renderer.forget();
                renderer.pixels_into(&self.requests[k], &mut pixels).await.ok_or(NoExactImage::Memory)?;
                self.ways[k].rounds.push(clock::now().saturating_sub(start).as_secs_f64() * 1e3);
                if progress.is_cancelled() {
                    return Err(NoExactImage::Cancelled);
                }
                progress.advance_and_pause(1).await;
            }
            self.judge(effort.within);
            partial(self);
            if clock::now() >= end {
                break;
            }
        }
        Ok(())
    }

    /// Finds the front and the cheapest way from the times so far.
    fn judge(&mut self, within: f64) {
        self.ways.iter_mut().for_each(|way| way.ms = Interval::of(&way.rounds));
        let verdicts = decide(&self.ways.iter().map(|way| (way.cost, way.ms)).collect::<Vec<_>>(), Cost::is_at_most);
        for (way, (front, undecided)) in self.ways.iter_mut().zip(verdicts) {
            (way.front, way.undecided) = (front, undecided);
        }
        let most = self.best() + within;
        let good = self.ways.iter().enumerate().filter(|(_, way)| way.cost.different <= most);
        let fastest = good.min_by(|(_, a), (_, b)| a.ms.median.total_cmp(&b.ms.median));
        self.cheapest = fastest.map_or(self.yours, |(k, _)| k);
    }
}

/// The k-th of some things in a round: each round begins with another one, and every second one goes backwards.
const fn turn(k: usize, round: usize, count: usize) -> usize {
    let k = (k + round / 2) % count;
    if round.is_multiple_of(2) { k } else { count - 1 - k }
}

/// The share of pixels that differ visibly, and the root mean square of the differences in linear light.
fn difference(a: &Pixels, b: &Pixels) -> (f64, f64) {
    let linear: Vec<f64> = (0..=255_u8).map(linear).collect();
    let (mut differ, mut squares, mut pixels) = (0.0, 0.0, 0.0);
    for (a, b) in a.rgba().chunks_exact(4).zip(b.rgba().chunks_exact(4)) {
        let channels = || a.iter().zip(b).take(3);
        pixels += 1.0;
        differ += f64::from(u8::from(channels().any(|(a, b)| a.abs_diff(*b) > VISIBLE)));
        squares += channels().map(|(&a, &b)| (linear[usize::from(a)] - linear[usize::from(b)]).powi(2)).sum::<f64>();
    }
    let pixels = f64::max(pixels, 1.0);
    (differ / pixels, (squares / (3.0 * pixels)).sqrt())
}

/// A channel of sRGB as linear light (IEC 61966-2-1).
fn linear(channel: u8) -> f64 {
    let v = f64::from(channel) / 255.0;
    if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

/// The bytes that the textbook's rasterizer holds for a drawing: its image, a colour for each sample if there are
/// several, a depth for each sample in the format if depths are compared, with the place of its face in the list if
/// faces come in another order, shadow maps, and the arrays of its faces.
fn bytes_of(drawing: &Drawing) -> usize {
    let pixels = drawing.width as usize * drawing.height as usize;
    let samples = usize::from(drawing.antialias.count());
    let has_depths = !drawing.painted_in_order && drawing.surfaces.iter().any(|surface| surface.depth_test);
    let depth = drawing.depth_format.greatest().map_or(4, |greatest| if greatest > 65_535.0 { 3 } else { 2 });
    let mut maps: Vec<*const ShadowMap> = Vec::new();
    let mut bytes = 4 * pixels + if samples > 1 { 4 * pixels * samples } else { 0 };
    bytes += if has_depths { depth * pixels * samples } else { 0 };
    bytes += if drawing.face_order() == FaceOrder::AsListed { 0 } else { 4 * pixels * samples };
    for surface in &drawing.surfaces {
        bytes += size_of_val(&surface.positions[..])
            + size_of_val(&surface.inverse_w[..])
            + size_of_val(&surface.triangles[..])
            + match &surface.base {
                Base::Solid(_) => 0,
                Base::Faces(colors) | Base::Vertices(colors) => size_of_val(&colors[..]),
                Base::Texture { uv, tints, .. } => size_of_val(&uv[..]) + size_of_val(&tints[..]),
            }
            + match &surface.light {
                SurfaceLight::InBase => 0,
                SurfaceLight::Faces(light) | SurfaceLight::Vertices(light) => size_of_val(&light[..]),
                SurfaceLight::PerPixel(light) => size_of_val(&light.normals[..]) + size_of_val(&light.positions[..]),
            };
        for shadow in &surface.shadows {
            bytes += size_of_val(&shadow.places[..]) + size_of_val(&shadow.planes[..]);
            let map = Arc::as_ptr(&shadow.map);
            if !maps.contains(&map) {
                maps.push(map);
                let views = if matches!(shadow.map.rays, Rays::FromLamp { .. }) { 6 } else { 1 };
                bytes += 4 * views * (shadow.map.size as usize).pow(2);
            }
        }
    }
    bytes
}

#[cfg(test)]
mod tests;
