//! Repairs: changes of the camera from small to large. The first one whose picture shows the missing objects is
//! offered.

use glam::DVec3;
use serde::{Serialize, Serializer};

use super::exact::{Fault, shadows, wrong_faces};
use super::place::Whereabouts;
use super::subject::{NamedThing, ball};
use super::{Ball, Cause, FEW, ImageSpec, Looked, MANY_BACK_FACES};
use crate::appearance::{DepthFormat, Shading, Style, Visibility};
use crate::camera::{Camera, Parameters, Projection, ViewWindow};
use crate::figure::{Figure, Reveal, words};
use crate::inspect::SidesReport;
use crate::numbers::{nice_above, nice_below, round_to};
use crate::numerics::health::{suggested_planes, with_planes};
use crate::progress::Progress;
use crate::scene::Scene;

/// A change of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repair {
    /// The camera afterwards.
    pub camera: Parameters,
    /// The style afterwards.
    pub style: Style,
    /// The inner work of the pipeline in the image afterwards.
    pub reveal: Reveal,
    /// The bias of shadow maps afterwards, in steps of the map; `None` leaves it as it is.
    pub shadow_bias: Option<f64>,
}

/// The success criterion of a repair.
#[derive(Clone, Copy, PartialEq)]
enum Wanted {
    /// All of it in the volume, on more than a few pixels.
    Well,
    /// Some pixels.
    AtAll,
}

impl Looked<'_> {
    /// The repair of a cause; `None` if none shows its objects.
    pub(super) fn repair(&mut self, cause: Cause, members: &[&NamedThing]) -> Option<Repair> {
        let largest = members.iter().max_by(|a, b| radius(a).total_cmp(&radius(b)))?;
        let style = *self.style;
        if cause == Cause::FullyTransparent {
            let can = members.iter().any(|member| member.can_be_wireframe());
            let style = Style { shading: Shading::Wireframe, ..style };
            return can.then_some(Repair { style, ..self.as_it_is() });
        }
        for (members, wanted) in [(members, Wanted::Well), (members, Wanted::AtAll), (&[*largest], Wanted::AtAll)] {
            let mut candidates = self.small(cause, members);
            candidates.extend(self.reframed(members));
            if let Some(camera) = candidates.into_iter().find(|camera| self.shows(camera, members, wanted)) {
                return Some(Repair { camera, ..self.as_it_is() });
            }
        }
        None
    }

    /// The repair that changes nothing.
    fn as_it_is(&self) -> Repair {
        Repair { camera: *self.camera.parameters(), style: *self.style, reveal: *self.reveal, shadow_bias: None }
    }

    /// The repair of wrong pixels: the first change after which the image has none of them, or the one that leaves the
    /// fewest, if that's less than half.
    pub(super) async fn repair_of_fault(
        &mut self,
        spec: &ImageSpec<'_>,
        fault: &Fault,
        progress: &Progress,
    ) -> Option<Repair> {
        let mut best: Option<(u64, Repair)> = None;
        for repair in self.changes_for(fault.cause) {
            let Ok(camera) = Camera::new(&repair.camera) else { continue };
            let lights = spec.scene.lights.iter().map(|light| {
                let mut light = *light;
                light.shadows.bias = repair.shadow_bias.unwrap_or(light.shadows.bias);
                light
            });
            let lit = repair.shadow_bias.map(|_| Scene { lights: lights.collect(), ..spec.scene.clone() });
            let scene = lit.as_ref().unwrap_or(spec.scene);
            let after = ImageSpec { scene, camera: &camera, style: &repair.style, reveal: &repair.reveal, ..*spec };
            let wrong = match fault.cause {
                Cause::DepthConflict | Cause::WrongOrder => wrong_faces(&after, &mut self.counter, progress).await?,
                // Less acne mustn't cost detached shadows.
                Cause::ShadowAcne | Cause::ShadowDetached => {
                    shadows(&after, progress).await?.iter().map(|fault| fault.pixels.wrong).sum()
                }
                // With w, a texture is right, and with exact vertices faces are in their pixels.
                _ => 0,
            };
            if wrong == 0 {
                return Some(repair);
            }
            if best.is_none_or(|(least, _)| wrong < least) {
                best = Some((wrong, repair));
            }
        }
        best.filter(|(wrong, _)| *wrong < fault.pixels.wrong / 2).map(|(_, repair)| repair)
    }

    /// The changes that may undo wrong pixels, the least first.
    fn changes_for(&self, cause: Cause) -> Vec<Repair> {
        let now = self.as_it_is();
        let style = |style: Style| Repair { style, ..now };
        match cause {
            Cause::DepthConflict => {
                let bounds = self.scene.bounds();
                let planes = bounds.and_then(|bounds| suggested_planes(self.camera, bounds));
                let planes = planes.map(|planes| Repair { camera: with_planes(&now.camera, planes), ..now });
                let finer = [DepthFormat::Fixed24, DepthFormat::Float]
                    .into_iter()
                    .filter(|format| *format != self.style.depth_format);
                let finer: Vec<DepthFormat> = finer.collect();
                let formats = finer.iter().map(|&depth_format| style(Style { depth_format, ..now.style }));
                let both = planes.into_iter().flat_map(|planes| {
                    finer
                        .iter()
                        .map(move |&depth_format| Repair { style: Style { depth_format, ..planes.style }, ..planes })
                });
                let exact = style(Style { visibility: Visibility::Bsp, ..now.style });
                planes.into_iter().chain(formats).chain(both).chain([exact]).collect()
            }
            Cause::WrongOrder => [Visibility::DepthBuffer, Visibility::Bsp]
                .into_iter()
                .filter(|visibility| *visibility != now.style.visibility)
                .map(|visibility| style(Style { visibility, ..now.style }))
                .collect(),
            Cause::ShadowAcne | Cause::ShadowDetached => {
                let shown = Reveal { shadows: None, ..now.reveal };
                let biases = [1.0, 2.0, 4.0].map(|bias| Repair { shadow_bias: Some(bias), reveal: shown, ..now });
                let as_in_file = (now.reveal != shown).then_some(Repair { reveal: shown, ..now });
                as_in_file.into_iter().chain(biases).collect()
            }
            Cause::VertexRounding => vec![style(now.style.with_exact_vertices())],
            Cause::AffineTexture => vec![Repair { reveal: Reveal { texture: None, ..now.reveal }, ..now }],
            _ => Vec::new(),
        }
    }

    /// True if the picture of a camera shows these subjects.
    fn shows(&mut self, parameters: &Parameters, members: &[&NamedThing], wanted: Wanted) -> bool {
        let Ok(camera) = Camera::new(parameters) else { return false };
        let mut alone = Scene { lights: self.scene.lights.clone(), ..Scene::default() };
        members.iter().for_each(|member| member.add_to(&mut alone, self.scene));
        let Some(drawn) = self.counter.draw(&alone, &camera, self.style, self.image) else { return false };
        let pixels = f64::from(self.image.width) * f64::from(self.image.height);
        let covered = drawn.pixels as f64 / pixels;
        if wanted == Wanted::AtAll {
            return drawn.pixels > 0;
        }
        let mut reports = drawn.objects.iter();
        // Marks keep their size, however near they are.
        let marks_only = members.iter().all(|member| member.is_point());
        (covered >= FEW || marks_only && drawn.pixels > 0)
            && members.iter().all(|member| {
                let report = member.index.and_then(|_| reports.next().copied());
                member.opacity == 0 || self.judge_from(&camera, member, report).causes.is_empty()
            })
            && {
                let all: Vec<usize> = (0..alone.objects.len()).collect();
                let is_closed = |i: &usize| alone.objects[*i].mesh.closed && !alone.objects[*i].two_sided;
                let closed: Vec<usize> = all.into_iter().filter(is_closed).collect();
                let opened = self.counter.back_faces(&alone, &closed, &camera, self.image);
                opened.iter().all(|&n| n < MANY_BACK_FACES)
            }
    }

    /// The smallest changes that undo a cause.
    fn small(&self, cause: Cause, members: &[&NamedThing]) -> Vec<Parameters> {
        let p = *self.camera.parameters();
        let places = members.iter().map(|member| Whereabouts::of(member, self.camera, self.image).depth);
        let depth = places.fold([f64::INFINITY, f64::NEG_INFINITY], |a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        match cause {
            Cause::BeyondFar => nice_above(1.05 * depth[1]).map(|far| Parameters { far, ..p }).into_iter().collect(),
            Cause::BeforeNear | Cause::HiddenByNearCut if depth[0] > 0.0 => {
                let nears = [nice_below(0.9 * depth[0]), nice_below(0.5 * depth[0])];
                nears.into_iter().flatten().map(|near| with_planes(&p, [near, p.far])).collect()
            }
            Cause::BehindCamera
            | Cause::OutsideLeft
            | Cause::OutsideRight
            | Cause::OutsideBottom
            | Cause::OutsideTop => self.turned(members),
            _ => Vec::new(),
        }
    }

    /// The ball around subjects. A point has no size of its own.
    fn ball(&self, members: &[&NamedThing]) -> Option<Ball> {
        let Ball { center, radius } = ball(members)?;
        Some(Ball { center, radius: if radius > 0.0 { radius } else { 0.05 * self.camera.distance() } })
    }

    /// Cameras turned towards the subjects from their own position, or, in parallel projection, moved sideways.
    fn turned(&self, members: &[&NamedThing]) -> Vec<Parameters> {
        let (p, Some(ball)) = (*self.camera.parameters(), self.ball(members)) else { return Vec::new() };
        let Ball { center, radius } = ball;
        let mut all = Vec::new();
        let window = self.camera.window();
        let basis = self.camera.basis();
        if p.projection == Projection::Parallel {
            let at = self.camera.view_point(center);
            let aside = DVec3::new(
                at.x - f64::midpoint(window.left, window.right),
                at.y - f64::midpoint(window.bottom, window.top),
                0.0,
            );
            let way = basis.u * aside.x + basis.v * aside.y;
            let unit = 1e-3 * (radius + window.height());
            let moved = |q: DVec3| rounded(q + way, unit);
            all.push(Parameters { position: moved(p.position), focal_point: moved(p.focal_point), ..p });
        }
        let distance = center.distance(p.position);
        if distance > radius {
            let focal_point = rounded(center, 1e-3 * distance);
            let forward = (focal_point - p.position).normalize_or_zero();
            all.push(Parameters { focal_point, view_up: upright(p.view_up, forward, basis.v), ..p });
        }
        all.iter().flat_map(|q| [*q, around(q, center, radius)]).collect()
    }

    /// Cameras placed so that a ball around the subjects fills the window, from their own direction or another one, and
    /// with their own lens or an ordinary one.
    fn reframed(&self, members: &[&NamedThing]) -> Vec<Parameters> {
        let (p, Some(ball)) = (*self.camera.parameters(), self.ball(members)) else { return Vec::new() };
        let b = self.camera.basis();
        let directions = [
            b.n,
            (b.n + 0.6 * b.v + 0.4 * b.u).normalize(),
            (b.n - 0.8 * b.u + 0.7 * b.v).normalize(),
            (b.u + b.v).normalize(),
            -b.n,
        ];
        let window = self.camera.window();
        let half = [0.5 * window.width(), 0.5 * window.height()];
        let symmetric = ViewWindow { left: -half[0], right: half[0], bottom: -half[1], top: half[1] };
        let own = Parameters { window: p.window.map(|_| symmetric), ..p };
        let half_aspect = 0.4 * self.image.aspect();
        let at_near = ViewWindow { left: -half_aspect, right: half_aspect, bottom: -0.4, top: 0.4 }.map(|x| x * p.near);
        let ordinary =
            Parameters { aspect: self.image.aspect(), view_angle: 45.0, window: p.window.map(|_| at_near), ..p };
        let lenses = [own, ordinary];
        let framed =
            |lens: Parameters| directions.map(|direction| framed(&lens, b.v, direction, ball.center, ball.radius));
        lenses.into_iter().flat_map(framed).collect()
    }
}

fn radius(subject: &NamedThing) -> f64 {
    ball(&[subject]).map_or(0.0, |ball| ball.radius)
}

/// Moves the near and far planes only if they would cut a ball.
fn around(p: &Parameters, center: DVec3, radius: f64) -> Parameters {
    let forward = (p.focal_point - p.position).normalize_or_zero();
    let depth = (center - p.position).dot(forward);
    let (least, most) = (depth - 1.02 * radius, depth + 1.02 * radius);
    let mut q = *p;
    if least < p.near
        && let Some(near) = nice_below(if least > 1e-3 * most { 0.9 * least } else { 1e-3 * most })
    {
        q = with_planes(&q, [near, q.far]);
    }
    if most > p.far || q.near >= q.far {
        q.far = nice_above(most).unwrap_or(q.far);
    }
    q
}

/// A camera with a lens that looks at a ball from a direction, so near that the ball fills the window.
fn framed(lens: &Parameters, v: DVec3, direction: DVec3, center: DVec3, radius: f64) -> Parameters {
    const ROOM: f64 = 1.15;
    let mut p = *lens;
    let distance = match lens.projection {
        Projection::Perspective => {
            let [across, up] = match lens.window {
                Some(window) => [window.width(), window.height()].map(|side| side / (2.0 * lens.near)),
                None => {
                    let up = (0.5 * lens.view_angle).to_radians().tan();
                    [up * lens.aspect, up]
                }
            };
            let half_angle = across.min(up).atan();
            ROOM * radius / half_angle.sin()
        }
        Projection::Parallel => {
            let aspect = lens.window.map_or(lens.aspect, |window| window.aspect());
            let height = 2.0 * ROOM * radius / aspect.min(1.0);
            p.height = nice(height);
            p.window = lens.window.map(|window| window.map(|x| x * height / window.height()));
            4.0 * radius
        }
    };
    p.focal_point = rounded(center, 1e-3 * radius);
    p.position = rounded(center + direction * distance, 1e-3 * radius.min(distance - radius));
    p.view_up = upright(lens.view_up, -direction, v);
    around(&p, center, radius)
}

/// To three digits.
fn nice(x: f64) -> f64 {
    round_to(x, 1e-2 * x)
}

/// A point without digits too small to see. It's unchanged if the rounding would be finer than an `f64`.
fn rounded(p: DVec3, unit: f64) -> DVec3 {
    let far_out = p.abs().max_element() > 1e13 * unit;
    if far_out { p } else { DVec3::from_array(p.to_array().map(|x| round_to(x, unit))) }
}

/// VUP if it can stay, else **v**, or an axis.
fn upright(up: DVec3, forward: DVec3, v: DVec3) -> DVec3 {
    let aslant = |up: &DVec3| up.normalize_or_zero().cross(forward).length() > 0.02;
    [up, v, DVec3::Y, DVec3::Z].into_iter().find(aslant).unwrap_or(up)
}

/// The new value of a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A point or a direction.
    Vector(DVec3),
    /// The sides of the view window.
    Window(ViewWindow),
    /// One of a list.
    Word(&'static str),
    /// None: the key goes.
    Absent,
}

/// The keys of `[camera]` that differ, with their new values.
pub fn changes(before: &Parameters, after: &Parameters) -> Vec<(&'static str, Value)> {
    let vectors = [
        ("position", before.position, after.position),
        ("focal_point", before.focal_point, after.focal_point),
        ("view_up", before.view_up, after.view_up),
    ];
    let numbers = [
        ("view_angle", before.view_angle, after.view_angle),
        ("height", before.height, after.height),
        ("aspect", before.aspect, after.aspect),
        ("near", before.near, after.near),
        ("far", before.far, after.far),
    ];
    let vectors = vectors.into_iter().filter(|(_, a, b)| a != b).map(|(key, _, after)| (key, Value::Vector(after)));
    let numbers = numbers.into_iter().filter(|(_, a, b)| a != b).map(|(key, _, after)| (key, Value::Number(after)));
    let window = after.window.filter(|_| before.window != after.window).map(|after| ("window", Value::Window(after)));
    vectors.chain(numbers).chain(window).collect()
}

impl Repair {
    /// The keys that it changes, with their new values. Keys of `[camera]` and `[style]` have their names alone, but
    /// `texture` and `shadows` of `[reveal]` and `shadow_bias` of the lights have their section too.
    pub fn changes(&self, figure: &Figure) -> Vec<(&'static str, Value)> {
        let Figure { camera, style, reveal, .. } = figure;
        let word = |key, is_changed: bool, word| is_changed.then_some((key, Value::Word(word)));
        let (new, old) = (&self.style, style);
        let words = [
            word("shading", new.shading != old.shading, words::name(words::SHADINGS, new.shading)),
            word("visibility", new.visibility != old.visibility, words::name(words::VISIBILITIES, new.visibility)),
            word(
                "depth_format",
                new.depth_format != old.depth_format,
                words::name(words::DEPTH_FORMATS, new.depth_format),
            ),
            word(
                "vertex_format",
                new.vertex_format != old.vertex_format,
                words::name(words::VERTEX_FORMATS, new.vertex_format),
            ),
            (new.subpixel_bits != old.subpixel_bits)
                .then(|| ("subpixel_bits", Value::Number(new.subpixel_bits.count().into()))),
        ];
        let gone = [
            (self.reveal.texture != reveal.texture).then_some(("reveal.texture", Value::Absent)),
            (self.reveal.shadows != reveal.shadows).then_some(("reveal.shadows", Value::Absent)),
        ];
        let bias = self.shadow_bias.map(|bias| ("scene.lights.shadow_bias", Value::Number(bias)));
        changes(camera, &self.camera).into_iter().chain(words.into_iter().chain(gone).flatten()).chain(bias).collect()
    }

    /// Applies it to a figure.
    pub fn apply(&self, figure: &mut Figure) {
        (figure.camera, figure.style, figure.reveal) = (self.camera, self.style, self.reveal);
        if let Some(bias) = self.shadow_bias {
            figure.scene.lights.iter_mut().for_each(|light| light.shadows.bias = bias);
        }
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(x) => x.serialize(serializer),
            Self::Vector(v) => v.to_array().serialize(serializer),
            Self::Word(word) => word.serialize(serializer),
            Self::Absent => serializer.serialize_unit(),
            Self::Window(window) => SidesReport::from(*window).serialize(serializer),
        }
    }
}
