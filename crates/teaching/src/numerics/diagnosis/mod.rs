//! Answers the question "Why is my picture empty?" It names the parts of a scene that a camera doesn't show, the
//! reasons, and the changes of the camera that would show them.
//!
//! Visibility is counted in pixels that the pipeline really draws. The reason for a missing part follows from the sides
//! of the planes of the volume on which its points lie. A repair is offered only after it was applied and its picture
//! checked. Then the image is compared with exact visibility. Only if that finds no wrong pixel either is there nothing
//! to report.

mod camera;
mod count;
mod exact;
mod place;
mod repair;
mod subject;

use glam::DVec3;

use crate::appearance::{Shading, Style};
use crate::camera::{Camera, CameraError, ImageSize};
use crate::figure::Reveal;
use crate::pipeline::{FacesDone, ObjectReport, infinite_faces};
use crate::progress::Progress;
use crate::scene::Scene;
pub use camera::{ImpossibleCamera, impossible_camera};
pub use count::Counter;
pub use exact::WrongPixels;
pub(super) use exact::wrong_faces;
pub use repair::{Repair, Value, changes};

use place::{Side, Whereabouts};
use subject::NamedThing;

/// Less than this share of the image is few pixels: 0.1 %, a square of 28 pixels in 1024 × 768.
const FEW: f64 = 1e-3;
/// With less than this share of its box on the image, an object counts as cut off by the border.
const SLIVER: f64 = 0.2;

crate::worded! {
    /// The reason why something isn't in the picture, or is wrong there.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Cause {
        /// There is nothing to see.
        EmptyScene = "empty-scene",
        /// The eye is inside it.
        CameraInsideObject = "camera-inside-object",
        /// Behind the plane of the eye.
        BehindCamera = "behind-camera",
        /// Between the eye and the front plane.
        BeforeNear = "before-near",
        /// Beyond the back plane.
        BeyondFar = "beyond-far",
        /// To the left of the window.
        OutsideLeft = "outside-left",
        /// To the right of the window.
        OutsideRight = "outside-right",
        /// Above the window.
        OutsideTop = "outside-top",
        /// Below the window.
        OutsideBottom = "outside-bottom",
        /// Smaller than a pixel, or so thin that it lies between the pixels' centres.
        SmallerThanPixel = "smaller-than-pixel",
        /// Its colour has alpha 0.
        FullyTransparent = "fully-transparent",
        /// The near plane opens it, so that its inside is visible instead of its front.
        HiddenByNearCut = "hidden-by-near-cut",
        /// The scene is visible, but on less than 0.1 % of the image.
        FewPixels = "few-pixels",
        /// VUP is along the view, or has no length.
        ViewUpAlongView = "view-up-along-view",
        /// C = PF.
        FocalPointAtPosition = "focal-point-at-position",
        /// Not 0 < F < B.
        NearBeyondFar = "near-beyond-far",
        /// Not 0° < θ < 180°.
        ViewAngleRange = "view-angle-range",
        /// Another parameter of the camera is out of its range.
        CameraValue = "camera-value",
        /// The figure's depth format shows farther faces in front of nearer ones.
        DepthConflict = "depth-conflict",
        /// The order of painting shows farther faces in front of nearer ones.
        WrongOrder = "wrong-order",
        /// Faces lie in their own shadow.
        ShadowAcne = "shadow-acne",
        /// Shadows are detached from the thing that casts them.
        ShadowDetached = "shadow-detached",
        /// The format of vertices, or the grid of the image, puts faces in other pixels.
        VertexRounding = "vertex-rounding",
        /// A texture is interpolated without w.
        AffineTexture = "affine-texture",
        /// The image is too large, or has too many faces, for a comparison with exact visibility.
        NotCompared = "not-compared",
    }
    /// Its name in JSON.
    pub fn code
}

impl Cause {
    const fn outside(side: Side) -> Self {
        match side {
            Side::Left => Self::OutsideLeft,
            Side::Right => Self::OutsideRight,
            Side::Bottom => Self::OutsideBottom,
            Side::Top => Self::OutsideTop,
        }
    }
}

/// One statement about a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The reason.
    pub cause: Cause,
    /// The names of the objects that are missing entirely, in the order of the scene. Empty for an object without a
    /// name.
    pub whole: Vec<String>,
    /// The names of objects that are still partly visible.
    pub partly: Vec<String>,
    /// The repair that shows the objects for which it's most useful. These are the objects that only this cause keeps
    /// out of the picture, if there are any. `None` if no change of the camera does.
    pub repair: Option<Repair>,
    /// The wrong pixels, if the cause concerns pixels.
    pub pixels: Option<WrongPixels>,
}

/// The image to examine.
#[derive(Clone, Copy, Debug)]
pub struct ImageSpec<'a> {
    /// The scene in it.
    pub scene: &'a Scene,
    /// Its camera.
    pub camera: &'a Camera,
    /// Its style.
    pub style: &'a Style,
    /// The inner work of the pipeline in it. Textures without w and shadows without bias are drawn wrong on purpose.
    pub reveal: &'a Reveal,
    /// Its size.
    pub image: ImageSize,
    /// The greatest number of its pixels compared with exact visibility, evenly spread. See [`IN_A_WINDOW`].
    pub compared: u64,
}

/// Pixels to compare while a user works. They're enough for the share of wrong ones, in a few hundredths of a second.
pub const IN_A_WINDOW: u64 = 1 << 16;

impl Finding {
    /// The names of all objects concerned, first those that are missing entirely.
    pub fn objects(&self) -> impl Iterator<Item = &str> {
        self.whole.iter().chain(&self.partly).map(String::as_str).filter(|name| !name.is_empty())
    }
}

/// The visible share of a scene, and the reasons why it isn't larger.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// Pixels of the image that the scene covers, without antialiasing.
    pub visible: u64,
    /// Their share of the image.
    pub covered: f64,
    /// Every vertex is drawn within this distance of its place, pixels, which is proved.
    pub placed_within: f64,
    /// The findings, the most useful first. Empty only if the image was compared with exact visibility and is right.
    pub findings: Vec<Finding>,
    /// Faces that the format of vertices leaves out of the image, because a coordinate isn't finite in it.
    pub infinite_faces: usize,
    /// The reason why there's no image: the parameters make no camera.
    pub camera_error: Option<CameraError>,
}

/// Examines the image that a camera makes of a scene, and compares it with exact visibility. It pauses on the way.
///
/// # Errors
/// [`NoDiagnosis`] if the image can't be drawn, or the work was cancelled.
pub async fn diagnose(spec: &ImageSpec<'_>, progress: &Progress) -> Result<Diagnosis, NoDiagnosis> {
    let ImageSpec { scene, camera, style, image, .. } = *spec;
    let infinite_faces = infinite_faces(scene, camera, style.vertex_format);
    let mut counter = Counter::default();
    let drawn = counter.draw(scene, camera, style, image).ok_or(NoDiagnosis::TooLarge)?;
    let covered = drawn.pixels as f64 / (f64::from(image.width) * f64::from(image.height));
    let subjects = NamedThing::all(scene);
    let mut findings = CauseGroups::default();
    if subjects.is_empty() {
        findings.0.push(CauseGroup { cause: Cause::EmptyScene, rank: 0, members: Vec::new() });
    }
    let mut looked = Looked { scene, camera, style, reveal: spec.reveal, image, counter };
    let mut seen = Vec::new();
    for (index, subject) in subjects.iter().enumerate() {
        let report = subject.index.and_then(|i| drawn.objects.get(i).copied());
        let Judgement { causes, partly } = looked.judge(subject, report);
        // In a picture of other things, a point beside them is there on purpose.
        if subject.is_point() && covered >= FEW {
            continue;
        }
        // If something is smaller than a pixel, its strokes are visible, because they're never thinner than one.
        let is_seen = causes.is_empty() || partly || causes[0] == Cause::SmallerThanPixel;
        if is_seen && subject.opacity > 0 && !subject.is_point() {
            seen.push(index);
        }
        for (k, cause) in causes.into_iter().enumerate() {
            findings.note(cause, index, partly, if k > 0 || partly { 2 } else { 1 });
        }
    }
    let opened = looked.opened_by_near(&subjects, &drawn.objects);
    opened.into_iter().for_each(|index| findings.note(Cause::HiddenByNearCut, index, true, 1));
    if drawn.pixels > 0 && covered < FEW && !seen.is_empty() {
        findings.few(&seen);
    }
    let mut found = Vec::new();
    for group in findings.sorted() {
        let names = |partly: bool| {
            let members = group.members.iter().filter(|member| member.partly == partly);
            members.map(|member| subjects[member.subject].name.to_owned()).collect()
        };
        let leading: Vec<&NamedThing> = group.leading().map(|member| &subjects[member.subject]).collect();
        let repair = looked.repair(group.cause, &leading);
        found.push(Finding { cause: group.cause, whole: names(false), partly: names(true), repair, pixels: None });
    }
    let faults = exact::faults(spec, &mut looked.counter, progress).await.ok_or(NoDiagnosis::Cancelled)?;
    for fault in faults {
        let repair = looked.repair_of_fault(spec, &fault, progress).await;
        let names =
            fault.objects.iter().filter_map(|&place| scene.objects.get(place)).map(|object| object.name.clone());
        let pixels = (fault.cause != Cause::NotCompared).then_some(fault.pixels);
        found.push(Finding { cause: fault.cause, whole: Vec::new(), partly: names.collect(), repair, pixels });
    }
    // Nothing is proved of vertices that other machines round.
    let is_exact = *style == style.with_exact_vertices();
    let (visible, placed_within) = (drawn.pixels, if is_exact { drawn.placed_within } else { f64::INFINITY });
    Ok(Diagnosis { visible, covered, placed_within, findings: found, infinite_faces, camera_error: None })
}

/// The reason why there's no diagnosis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoDiagnosis {
    /// The image can't be drawn.
    #[error("the image is too large to be drawn")]
    TooLarge,
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

/// A subject with a cause.
struct Member {
    /// Its place among the subjects.
    subject: usize,
    /// Like the rank of its group.
    rank: u8,
    /// Part of it is visible all the same.
    partly: bool,
}

/// Subjects with the same cause.
struct CauseGroup {
    cause: Cause,
    /// The least rank of its members. 0 is the most important, 1 means that something is missing or wrong, and 2 that
    /// it comes on top of another cause, or is partly visible.
    rank: u8,
    /// In the order of the scene.
    members: Vec<Member>,
}

impl CauseGroup {
    /// The members that have its rank.
    fn leading(&self) -> impl Iterator<Item = &Member> {
        self.members.iter().filter(|member| member.rank == self.rank)
    }
}

/// The findings so far, one group for each cause.
#[derive(Default)]
struct CauseGroups(Vec<CauseGroup>);

impl CauseGroups {
    fn note(&mut self, cause: Cause, subject: usize, partly: bool, rank: u8) {
        let member = Member { subject, rank, partly };
        match self.0.iter_mut().find(|group| group.cause == cause) {
            Some(group) => {
                group.rank = group.rank.min(rank);
                group.members.push(member);
            }
            None => self.0.push(CauseGroup { cause, rank, members: vec![member] }),
        }
    }

    /// Everything visible is tiny. If some of it is larger than a pixel, smaller things aren't worth a word.
    fn few(&mut self, seen: &[usize]) {
        let tiny = |group: &CauseGroup| group.cause == Cause::SmallerThanPixel;
        if self.0.iter().filter(|group| tiny(group)).flat_map(|group| &group.members).count() < seen.len() {
            self.0.retain(|group| !tiny(group));
            seen.iter().for_each(|&subject| self.note(Cause::FewPixels, subject, true, 0));
        }
    }

    /// The most useful first: those that concern the most objects, and are the first obstacle.
    fn sorted(mut self) -> Vec<CauseGroup> {
        self.0.sort_by_key(|group| (group.rank, std::cmp::Reverse(group.leading().count()), group.cause));
        self.0
    }
}

/// The causes that keep a subject out of the picture.
#[derive(Debug, Default)]
struct Judgement {
    /// Empty if it's in the picture. If undoing a single cause would show it, that cause comes first.
    causes: Vec<Cause>,
    /// Part of it is in the picture all the same.
    partly: bool,
}

impl Judgement {
    fn whole(causes: Vec<Cause>) -> Self {
        Self { causes, partly: false }
    }
}

/// The scene under examination.
struct Looked<'a> {
    scene: &'a Scene,
    camera: &'a Camera,
    style: &'a Style,
    reveal: &'a Reveal,
    image: ImageSize,
    counter: Counter,
}

impl Looked<'_> {
    /// Judges a subject with another camera.
    fn judge_from(&mut self, camera: &Camera, subject: &NamedThing, report: Option<ObjectReport>) -> Judgement {
        let counter = std::mem::take(&mut self.counter);
        let mut other = Looked { camera, counter, ..*self };
        let judgement = other.judge(subject, report);
        self.counter = other.counter;
        judgement
    }

    /// Finds the reason why a subject isn't in the picture, given the pipeline's `report` on it.
    fn judge(&mut self, subject: &NamedThing, report: Option<ObjectReport>) -> Judgement {
        let place = Whereabouts::of(subject, self.camera, self.image);
        let sides = |sides: Vec<Side>| sides.into_iter().map(Cause::outside);
        let mut judgement = if subject.contains(self.camera.position()) {
            Judgement { causes: vec![Cause::CameraInsideObject], partly: true }
        } else if place.is_before_near() {
            let cause = if place.depth[1] <= 0.0 { Cause::BehindCamera } else { Cause::BeforeNear };
            let aside = if place.depth[0] > 0.0 { place.outside() } else { Vec::new() };
            Judgement::whole(std::iter::once(cause).chain(sides(aside)).collect())
        } else if place.is_beyond_far() {
            Judgement::whole(std::iter::once(Cause::BeyondFar).chain(sides(place.outside())).collect())
        } else if !place.outside().is_empty() {
            Judgement::whole(sides(place.outside()).collect())
        } else if let Some(judgement) = self.not_drawn(subject, report, &place) {
            judgement
        } else if !subject.is_point() && self.is_between_pixels(subject, &place) {
            Judgement::whole(vec![Cause::SmallerThanPixel])
        } else {
            self.partly_outside(subject, &place)
        };
        if subject.opacity == 0 && !subject.is_shown_by_wireframe(self.style) {
            judgement.causes.push(Cause::FullyTransparent);
            judgement.partly &= judgement.causes.len() > 1;
        }
        judgement
    }

    /// True if a subject is smaller than a pixel, or is a face so thin that no pixel centre lies on it.
    fn is_between_pixels(&mut self, subject: &NamedThing, place: &Whereabouts) -> bool {
        place.is_smaller_than_pixel()
            || (place.is_thin() && subject.has_faces(self.style) && self.alone(subject) == Some(0))
    }

    /// Judges a subject that no single plane keeps out of the volume, but that still isn't drawn. Examples are a floor
    /// around an eye that looks up, and a surface that shows only back faces to the eye.
    fn not_drawn(
        &mut self,
        subject: &NamedThing,
        report: Option<ObjectReport>,
        place: &Whereabouts,
    ) -> Option<Judgement> {
        if !subject.has_faces(self.style) {
            let outside = !subject.is_point() && !place::crosses(subject, self.camera);
            return outside.then(|| Judgement::whole(vec![place.aside()]));
        }
        let report = report?;
        if report.triangles > 0 {
            return None;
        }
        let turned_away = report.faces == FacesDone::BackDropped && {
            let both_sides = subject.both_sides(self.scene);
            let drawn = self.counter.draw(&both_sides, self.camera, self.style, self.image);
            drawn.is_some_and(|drawn| drawn.objects.iter().any(|object| object.triangles > 0))
        };
        let cause = if turned_away { Cause::CameraInsideObject } else { place.aside() };
        Some(Judgement::whole(vec![cause]))
    }

    /// Judges a subject of which clipping leaves little.
    fn partly_outside(&self, subject: &NamedThing, place: &Whereabouts) -> Judgement {
        let mut causes = Vec::new();
        if subject.has_faces(self.style) && place.center_depth() > self.camera.far() {
            causes.push(Cause::BeyondFar);
        }
        if causes.is_empty() && place.share_inside().is_some_and(|share| share < SLIVER) {
            causes.extend(place.center_outside().map(Cause::outside));
        }
        let partly = !causes.is_empty();
        Judgement { causes, partly }
    }

    /// The pixels of a subject without all others.
    fn alone(&mut self, subject: &NamedThing) -> Option<u64> {
        self.counter.draw(&subject.alone(self.scene), self.camera, self.style, self.image).map(|drawn| drawn.pixels)
    }

    /// The subjects whose inside is visible because the near plane cuts their front away.
    fn opened_by_near(&mut self, subjects: &[NamedThing], reports: &[ObjectReport]) -> Vec<usize> {
        if self.style.shading == Shading::Wireframe {
            return Vec::new();
        }
        let cut_open = |subject: &NamedThing| {
            let report = subject.index.and_then(|i| reports.get(i));
            report.is_some_and(|report| report.faces == FacesDone::CutOpen && report.triangles > 0)
                && !subject.contains(self.camera.position())
        };
        let cut: Vec<usize> = (0..subjects.len()).filter(|&i| cut_open(&subjects[i])).collect();
        if cut.is_empty() {
            return cut;
        }
        let marked: Vec<usize> = cut.iter().filter_map(|&i| subjects[i].index).collect();
        let inside = self.counter.back_faces(self.scene, &marked, self.camera, self.image);
        cut.into_iter().zip(inside).filter(|(_, pixels)| *pixels >= MANY_BACK_FACES).map(|(i, _)| i).collect()
    }
}

/// More pixels of a back face than this appear only if a solid is open. At a silhouette, rounding makes a few.
const MANY_BACK_FACES: u64 = 6;

/// The centre and radius of a ball around points.
#[derive(Clone, Copy, Debug)]
struct Ball {
    center: DVec3,
    radius: f64,
}
