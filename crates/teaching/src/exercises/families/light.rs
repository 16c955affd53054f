//! Light on a vertex, `[2]` and `[3]` §1.8: the ways to the lamps, their cosines, the share of the vertex's own colour,
//! and the highlight.

use glam::DVec3;

use super::cameras::{about, small, telling, with_image, with_point};
use crate::appearance::Shading;
use crate::camera::Parameters;
use crate::exercises::worked::{Worked, named};
use crate::exercises::{Ask, Exercise, Fact, Kind, Nature, Slip, Slips, Subject, Table, follows};
use crate::explain::{Formula, Function, Named, minus, over, plus, sum, times};
use crate::figure::Figure;
use crate::numbers::random::Random;
use crate::scene::palette::BLUE;
use crate::scene::{Light, ObjectSpec, Preset, Shape};

/// The shares of the program's own model: for a vertex that no lamp reaches, for a lamp that meets it squarely, and the
/// white of the highlight.
const AMBIENT: f64 = 0.35;
const DIFFUSE: f64 = 0.65;
const SPECULAR: f64 = 0.3;

/// The mistakes that every exercise of the family has to reveal.
const SLIPS: [Slip; 17] = [
    Slip::NNotNormalised,
    Slip::LengthForgotten,
    Slip::HalfwaySum,
    Slip::HalfwayMean,
    Slip::TravelForWay,
    Slip::LampReversed,
    Slip::PositionForgotten,
    Slip::ViewForLight,
    Slip::NegativeLight,
    Slip::CosineLeftAsAngle,
    Slip::ShareOfRightAngle,
    Slip::AmbientForgotten,
    Slip::DiffuseForgotten,
    Slip::SpecularForgotten,
    Slip::LightForHalfway,
    Slip::ReflectedForHalfway,
    Slip::ExponentForgotten,
];

/// Vectors of whole numbers and whole length, none of them along an axis.
const WAYS: [[i8; 3]; 3] = [[1, 2, 2], [0, 3, 4], [2, 3, 6]];

/// The light of a lamp.
#[derive(Clone, Copy)]
enum Lamp {
    /// It stands at a point.
    Near(DVec3),
    /// It's so far away that its light travels along one vector.
    Far(DVec3),
}

/// A vertex under two lamps, the second of which is behind its surface.
#[derive(Clone, Copy)]
struct Vertex {
    position: DVec3,
    /// As given: not of length 1.
    normal: DVec3,
    eye: DVec3,
    lamps: [Lamp; 2],
    exponent: i32,
}

impl Vertex {
    /// The starting point of the ways.
    fn from(&self, slips: Slips) -> DVec3 {
        if slips.has(Slip::PositionForgotten) { DVec3::ZERO } else { self.position }
    }

    fn unit_normal(&self, slips: Slips) -> DVec3 {
        if slips.has(Slip::NNotNormalised) { self.normal } else { self.normal.normalize() }
    }

    /// The way to the viewer, of any length.
    fn way_to_viewer(&self, slips: Slips) -> DVec3 {
        self.eye - self.from(slips)
    }

    /// The way to a lamp, of any length.
    fn way(&self, k: usize, slips: Slips) -> DVec3 {
        match self.lamps[k] {
            _ if k == 0 && slips.has(Slip::ViewForLight) => self.way_to_viewer(slips),
            Lamp::Near(_) if slips.has(Slip::LampReversed) => -self.way(k, Slips::NONE),
            Lamp::Near(lamp) => lamp - self.from(slips),
            Lamp::Far(travel) if slips.has(Slip::TravelForWay) => travel,
            Lamp::Far(travel) => -travel,
        }
    }

    /// **L**
    fn lamp_direction(&self, k: usize, slips: Slips) -> DVec3 {
        let way = self.way(k, slips);
        if slips.has(Slip::LengthForgotten) { way } else { way.normalize() }
    }

    /// **V**
    fn viewer_direction(&self, slips: Slips) -> DVec3 {
        let way = self.way_to_viewer(slips);
        if slips.has(Slip::LengthForgotten) { way } else { way.normalize() }
    }

    /// **H**
    fn halfway(&self, slips: Slips) -> DVec3 {
        halfway(self.lamp_direction(0, slips), self.viewer_direction(slips), slips)
    }

    /// **N** · **L**
    fn cosine(&self, k: usize, slips: Slips) -> f64 {
        let cosine = self.unit_normal(slips).dot(self.lamp_direction(k, slips));
        slips.pick(
            [
                (Slip::CosineLeftAsAngle, cosine.acos().to_degrees()),
                (Slip::ShareOfRightAngle, 1.0 - cosine.acos().to_degrees() / 90.0),
            ],
            cosine,
        )
    }

    /// The share of its own colour that the vertex sends back.
    fn share(&self, slips: Slips) -> Option<f64> {
        // An angle in place of a share makes an implausible amount of light.
        let white = if slips.has(Slip::HighlightAdded) { self.highlight(Slips::NONE)? } else { 0.0 };
        (!slips.has(Slip::CosineLeftAsAngle)).then(|| white + share([0, 1].map(|k| self.cosine(k, slips)), slips))
    }

    /// The white that lamp 1 adds. No white is no evidence of any mistake.
    fn highlight(&self, slips: Slips) -> Option<f64> {
        let (n, l, v) = (self.unit_normal(slips), self.lamp_direction(0, slips), self.viewer_direction(slips));
        let cosine = slips.pick(
            [(Slip::LightForHalfway, n.dot(l)), (Slip::ReflectedForHalfway, (2.0 * n.dot(l) * n - l).dot(v))],
            n.dot(self.halfway(slips)),
        );
        let power = if slips.has(Slip::ExponentForgotten) { 1 } else { self.exponent };
        let white = if slips.has(Slip::SpecularForgotten) { 1.0 } else { SPECULAR };
        (cosine > 0.0).then(|| white * cosine.powi(power))
    }

    /// True if its numbers belong to a vertex that's visible and lit by lamp 1 alone, far enough from all borders.
    fn is_lit(&self) -> bool {
        let (n, h) = (self.normal.normalize(), self.halfway(Slips::NONE));
        let [first, second] = [0, 1].map(|k| self.cosine(k, Slips::NONE));
        (0.2..0.9).contains(&first)
            && (-0.9..-0.15).contains(&second)
            && (0.25..0.95).contains(&n.dot(self.viewer_direction(Slips::NONE)))
            && (0.55..0.98).contains(&n.dot(h))
            && self.lamp_direction(0, Slips::NONE).dot(self.viewer_direction(Slips::NONE)) > -0.4
    }
}

/// The share of its own colour that a vertex sends back under lamps of these cosines.
fn share(cosines: [f64; 2], slips: Slips) -> f64 {
    let least = if slips.has(Slip::NegativeLight) { f64::NEG_INFINITY } else { 0.0 };
    let cosines = if slips.has(Slip::AbsoluteCosine) { cosines.map(f64::abs) } else { cosines };
    let diffuse =
        slips.pick([(Slip::DiffuseForgotten, 1.0), (Slip::MeanOfLights, DIFFUSE / cosines.len() as f64)], DIFFUSE);
    let ambient =
        slips.pick([(Slip::AmbientForgotten, 0.0), (Slip::AmbientPerLight, AMBIENT * cosines.len() as f64)], AMBIENT);
    ambient + diffuse * cosines.into_iter().map(|cosine| cosine.max(least)).sum::<f64>()
}

/// The vector halfway between two ways.
fn halfway(lamp_direction: DVec3, viewer_direction: DVec3, slips: Slips) -> DVec3 {
    let sum = lamp_direction + viewer_direction;
    slips.pick([(Slip::HalfwaySum, sum), (Slip::HalfwayMean, sum / 2.0)], sum.normalize())
}

pub(super) fn light(random: &mut Random) -> Exercise {
    telling(&SLIPS, || {
        loop {
            let vertex = any_vertex(random);
            if vertex.is_lit() {
                let exercise = light_of(vertex);
                if tells_apart(&exercise) {
                    return exercise;
                }
            }
        }
    })
}

/// One of [`WAYS`], its coordinates in any order and with any signs.
fn way(random: &mut Random) -> DVec3 {
    let [x, y, z] = random.one_of(&WAYS).map(f64::from);
    let order = random.one_of(&[[x, y, z], [x, z, y], [y, x, z], [y, z, x], [z, x, y], [z, y, x]]);
    DVec3::from_array(order.map(|x| if random.whole(0, 1) == 0 { x } else { -x }))
}

fn any_vertex(random: &mut Random) -> Vertex {
    let position = loop {
        let p = DVec3::new(small(random, 3), small(random, 3), small(random, 3));
        // At the origin nothing shows that P was forgotten.
        if p.length() > 1.0 {
            break p;
        }
    };
    let lamp = |is_near: bool, way: DVec3| if is_near { Lamp::Near(position + way) } else { Lamp::Far(-way) };
    let first_is_near = random.whole(0, 1) == 0;
    let viewer_direction = way(random);
    // Not so near that the ball about P fills the picture.
    let eye = position + viewer_direction * if viewer_direction.length() < 4.0 { 2.0 } else { 1.0 };
    Vertex {
        position,
        normal: way(random),
        eye,
        lamps: [lamp(first_is_near, way(random)), lamp(!first_is_near, way(random))],
        exponent: if random.whole(0, 1) == 0 { 2 } else { 4 },
    }
}

/// True if no two mistakes that change the answer to a question give the same wrong answer.
fn tells_apart(exercise: &Exercise) -> bool {
    exercise.asks.iter().all(|ask| {
        let wrong: Vec<(Slip, Table)> = SLIPS
            .iter()
            .filter(|slip| ask.tells(**slip))
            .filter_map(|slip| Some((*slip, ask.expected().slipped(Slips::one(*slip))?)))
            .collect();
        wrong.iter().enumerate().all(|(k, (first, one))| {
            let others = wrong[k + 1..].iter().filter(|(second, _)| second.mistake() != first.mistake());
            others.into_iter().all(|(_, other)| {
                let apart = one.entries.iter().zip(&other.entries).map(|(a, b)| (a - b).abs());
                apart.fold(0.0, f64::max) > 0.005 * one.size()
            })
        })
    })
}

fn light_of(vertex: Vertex) -> Exercise {
    let n = vertex.normal.normalize();
    let (viewer_direction, behind) = (vertex.viewer_direction(Slips::NONE), vertex.cosine(1, Slips::NONE));
    let highlight = move |h: DVec3| SPECULAR * n.dot(h).max(0.0).powi(vertex.exponent);
    let between = move |l: DVec3| follows::unit(l + viewer_direction);
    let one = |x: f64| Some(Table::number(x));
    let [to_light, normal, cosine, share_step, half, white] = steps(&vertex);
    let all = |steps: &[&Worked]| steps.iter().copied().cloned().collect::<Vec<_>>();

    let l = Ask::computed("L", Kind::Vector(3), all(&[&to_light]), move |slips| {
        Some(Table::from(vertex.lamp_direction(0, slips)))
    });
    let cosine_ask = Ask::computed("cosine", Kind::Number, all(&[&to_light, &normal, &cosine]), move |slips| {
        one(vertex.cosine(0, slips))
    });
    let share_ask =
        Ask::computed("share", Kind::Number, all(&[&to_light, &normal, &cosine, &share_step]), move |slips| {
            one(vertex.share(slips)?)
        });
    let h = Ask::computed("H", Kind::Vector(3), all(&[&to_light, &half]), move |slips| {
        Some(Table::from(vertex.halfway(slips)))
    });
    let highlight_ask =
        Ask::computed("highlight", Kind::Number, all(&[&to_light, &normal, &half, &white]), move |slips| {
            one(vertex.highlight(slips)?)
        });
    let asks = vec![
        l.of_nature(Nature::Direction),
        cosine_ask.of_nature(Nature::Cosine).following(&["L"], move |tables| one(n.dot(tables[0].vector()?))),
        share_ask
            .of_nature(Nature::Light)
            .following(&["cosine"], move |tables| one(share([*tables[0].entries.first()?, behind], Slips::NONE)))
            .following(&["L"], move |tables| one(share([n.dot(tables[0].vector()?), behind], Slips::NONE))),
        h.of_nature(Nature::Direction)
            .following(&["L"], move |tables| Some(Table::from(between(tables[0].vector()?)?))),
        highlight_ask
            .of_nature(Nature::Light)
            .following(&["H"], move |tables| one(highlight(tables[0].vector()?)))
            .following(&["L"], move |tables| one(highlight(between(tables[0].vector()?)?))),
    ];
    Exercise { asks, ..about(subject(&vertex)) }.with_facts(facts(&vertex))
}

fn facts(vertex: &Vertex) -> Vec<(&'static str, Fact)> {
    let first_is_near = matches!(vertex.lamps[0], Lamp::Near(_));
    let lamps = vertex.lamps.map(|lamp| match lamp {
        Lamp::Near(at) => ("S", at.into()),
        Lamp::Far(along) => ("d", along.into()),
    });
    let facts = vec![
        ("P", vertex.position.into()),
        ("N", vertex.normal.into()),
        ("ka", AMBIENT.into()),
        ("kd", DIFFUSE.into()),
        ("ks", SPECULAR.into()),
        ("exponent", f64::from(vertex.exponent).into()),
        ("lamps", Fact::Text(if first_is_near { "lamps-near-far" } else { "lamps-far-near" })),
    ];
    facts.into_iter().chain(lamps).collect()
}

/// A ball that contains the vertex and its normal, under the two lamps, and a camera that looks at it.
fn subject(vertex: &Vertex) -> Subject {
    let centre = vertex.position - vertex.normal.normalize();
    let ball = ObjectSpec::new("ball", Shape::Sphere).at(centre.x, centre.y, centre.z).colored(BLUE);
    let mut figure = Figure::of_preset(Preset::Empty);
    figure.scene.objects = vec![ball];
    figure.scene.lights = vertex
        .lamps
        .map(|lamp| match lamp {
            Lamp::Near(at) => Light::point(at),
            Lamp::Far(along) => Light::directional(along),
        })
        .to_vec();
    figure.style.shading = Shading::Phong;
    let distance = (vertex.eye - vertex.position).length();
    figure.camera = Parameters {
        position: vertex.eye,
        focal_point: vertex.position,
        view_angle: 40.0,
        near: 2.0,
        far: 2.0 * distance,
        ..Parameters::default()
    };
    with_point(with_image(Subject { figure, ..Subject::default() }, 480), vertex.position)
}

/// A name in plain text and in LaTeX.
type Name = (&'static str, &'static str);

const L: [Name; 3] = [("L_x", "L_x"), ("L_y", "L_y"), ("L_z", "L_z")];
const FAR_L: [Name; 3] = [("L₂_x", "L_{2x}"), ("L₂_y", "L_{2y}"), ("L₂_z", "L_{2z}")];
const V: [Name; 3] = [("V_x", "V_x"), ("V_y", "V_y"), ("V_z", "V_z")];
const N: [Name; 3] = [("N_x", "N_x"), ("N_y", "N_y"), ("N_z", "N_z")];
const H: [Name; 3] = [("H_x", "H_x"), ("H_y", "H_y"), ("H_z", "H_z")];
const OF_P: [Name; 3] = [("P_x", "P_x"), ("P_y", "P_y"), ("P_z", "P_z")];
const OF_S: [Name; 3] = [("S_x", "S_x"), ("S_y", "S_y"), ("S_z", "S_z")];
const OF_D: [Name; 3] = [("d_x", "d_x"), ("d_y", "d_y"), ("d_z", "d_z")];
const OF_C: [Name; 3] = [("C_x", "C_x"), ("C_y", "C_y"), ("C_z", "C_z")];
const GIVEN_N: [Name; 3] = [("N'_x", "N'_x"), ("N'_y", "N'_y"), ("N'_z", "N'_z")];

fn coordinates(names: [Name; 3], v: DVec3) -> [Named; 3] {
    [0, 1, 2].map(|k| named(names[k].0, names[k].1, v[k]))
}

/// The square root of the sum of squares of three numbers.
fn norm(of: [Formula; 3]) -> Formula {
    Formula::Of(Function::Root, Box::new(sum(of.map(|x| times([x.clone(), x])))))
}

fn dot(a: [Named; 3], b: [Named; 3]) -> Formula {
    sum([0, 1, 2].map(|k| times([a[k].into(), b[k].into()])))
}

/// The rows of a unit vector along another vector, whose length has a name of its own.
fn unit_rows(step: Worked, names: [Name; 3], (length, latex): Name, along: [Formula; 3], value: DVec3) -> Worked {
    let size = named(length, latex, value.length());
    let unit = coordinates(names, value.normalize());
    let step = step.row(size, norm(along.clone()));
    unit.into_iter().zip(along).fold(step, |step, (symbol, of)| step.row(symbol, over(of, size)))
}

/// The way to a lamp, made unit length.
fn lamp_rows(step: Worked, vertex: &Vertex, k: usize, names: [Name; 3]) -> Worked {
    let p = coordinates(OF_P, vertex.position);
    let value = vertex.way(k, Slips::NONE);
    match vertex.lamps[k] {
        Lamp::Near(at) => {
            let s = coordinates(OF_S, at);
            let along = [0, 1, 2].map(|c| minus(s[c], p[c]));
            unit_rows(step, names, ("‖S − P‖", r"\|S - P\|"), along, value)
        }
        Lamp::Far(travel) => {
            let along = coordinates(OF_D, travel).map(|d| -Formula::from(d));
            unit_rows(step, names, ("‖d‖", r"\|\mathbf{d}\|"), along, value)
        }
    }
}

/// The steps to lamp 1, to **N**, to their cosine, to the share of the colour, to **H** and to the highlight.
fn steps(vertex: &Vertex) -> [Worked; 6] {
    let (n, l) = (vertex.normal.normalize(), vertex.lamp_direction(0, Slips::NONE));
    let (v, h) = (vertex.viewer_direction(Slips::NONE), vertex.halfway(Slips::NONE));
    let [first, second] = [("N·L", r"\mathbf{N}\cdot\mathbf{L}"), ("N·L₂", r"\mathbf{N}\cdot\mathbf{L}_2")];
    let first = named(first.0, first.1, n.dot(l));
    let second = named(second.0, second.1, vertex.cosine(1, Slips::NONE));
    let [ambient, diffuse, specular] =
        [("k_a", AMBIENT), ("k_d", DIFFUSE), ("k_s", SPECULAR)].map(|(name, value)| named(name, name, value));
    let unit_n = coordinates(N, n);
    let source = "[2], [3] §1.1";

    let to_light = lamp_rows(Worked::new("to-light", source), vertex, 0, L);
    let given = coordinates(GIVEN_N, vertex.normal).map(Formula::from);
    let normal = unit_rows(Worked::new("unit-normal", source), N, ("‖N'‖", r"\|\mathbf{N}'\|"), given, vertex.normal);
    let cosine = Worked::new("cosine", source).row(first, dot(unit_n, coordinates(L, l)));
    let share_step = lamp_rows(Worked::new("share-of-colour", source), vertex, 1, FAR_L)
        .row(second, dot(unit_n, coordinates(FAR_L, vertex.lamp_direction(1, Slips::NONE))))
        .row(
            named("I", "I", share([first.value, second.value], Slips::NONE)),
            plus(ambient, times([diffuse.into(), first.into()])),
        );
    let to_eye = {
        let (c, p) = (coordinates(OF_C, vertex.eye), coordinates(OF_P, vertex.position));
        [0, 1, 2].map(|k| minus(c[k], p[k]))
    };
    let value = vertex.way_to_viewer(Slips::NONE);
    let half = unit_rows(Worked::new("halfway", source), V, ("‖C − P‖", r"\|C - P\|"), to_eye, value);
    let both = {
        let (l, v) = (coordinates(L, l), coordinates(V, v));
        [0, 1, 2].map(|k| plus(l[k], v[k]))
    };
    let half = unit_rows(half, H, ("‖L + V‖", r"\|\mathbf{L} + \mathbf{V}\|"), both, l + v);
    let met = named("N·H", r"\mathbf{N}\cdot\mathbf{H}", n.dot(h));
    let powers = (0..vertex.exponent).map(|_| Formula::from(met));
    let white = Worked::new("highlight", source).row(met, dot(unit_n, coordinates(H, h))).row(
        named("w", "w", SPECULAR * met.value.powi(vertex.exponent)),
        times(std::iter::once(Formula::from(specular)).chain(powers)),
    );
    [to_light, normal, cosine, share_step, half, white]
}

#[cfg(test)]
mod tests {
    use camera_lab_engine::drawing::{Lighting, ViewLight};
    use camera_lab_engine::lighting::shade;

    use super::*;
    use crate::appearance::Rgba;

    /// The program lights the vertex of the exercise as the answers say, whatever the exponent.
    #[test]
    fn the_program_lights_it_so() {
        #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
        let single = |v: DVec3| v.to_array().map(|x| x as f32);
        for seed in 0..40 {
            let exercise = light(&mut crate::exercises::families::cameras::numbers("light", seed));
            let fact = |name: &str| exercise.facts.iter().rev().find(|(fact, _)| *fact == name).map(|(_, f)| f.clone());
            let vector = |name| match fact(name) {
                Some(Fact::Tuple(values)) => DVec3::from_slice(&values),
                other => panic!("{name}: {other:?}"),
            };
            let Some(Fact::Number(exponent)) = fact("exponent") else { panic!("{seed}") };
            let (p, c) = (vector("P"), vector("C"));
            // The eye is the origin of view space. The light is the same whichever way it looks.
            let mut lighting = Lighting {
                ambient: crate::pipeline::reflection::AMBIENT,
                diffuse: crate::pipeline::reflection::DIFFUSE,
                specular: crate::pipeline::reflection::SPECULAR,
                #[expect(clippy::cast_possible_truncation, reason = "a few units")]
                shininess: exponent as f32,
                lights: vec![
                    ViewLight::point(single(vector("S") - c)),
                    ViewLight::directional(single(-vector("d").normalize())),
                ],
                ..Lighting::default()
            };
            let gray = Rgba::rgba(100, 100, 100, 255);
            let answer = |name: &str| {
                let ask = exercise.asks.iter().find(|ask| ask.name == name);
                ask.and_then(|ask| ask.expected().table()).map_or(f64::NAN, |table| table.entries[0])
            };
            let expected = 100.0 * answer("share") + 255.0 * answer("highlight");
            let lit = |lighting: &Lighting| f64::from(shade(lighting, single(vector("N")), single(p - c), gray).r);
            assert!((lit(&lighting) - expected).abs() <= 0.51, "{seed}: {} for {expected}", lit(&lighting));
            lighting.specular = 0.0;
            assert!((lit(&lighting) - 100.0 * answer("share")).abs() <= 0.51, "{seed}");
        }
    }
}
