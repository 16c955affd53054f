//! Shadow maps of several sizes, biases and soft edges against rays to the light.
//!
//! The error is the share of wrong pixels among those that receive light: in all, those wrongly dark (acne), and those
//! wrongly lit (detached shadows). Under a soft edge, a pixel is lit if more than half of the light arrives. The time
//! is that of a picture and its maps.

use crate::camera::{Camera, ImageSize};
use crate::figure::read::parse;
use crate::figure::{Figure, Reveal, ShadowReveal, write};
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, Watch};
use crate::numerics::{Findings, Group, Lab, Method, OWN, Row, Study, Unit};
use crate::picture::shadow_truth::{TrueLight, Verdict, arriving, under};
use crate::pipeline::Pipeline;
use crate::pipeline::shadow_rays::Solids;
use crate::progress::Progress;
use crate::raster::Rasterizer;
use crate::scene::{Light, Scene, SceneSpec, Shadows, build, no_files};

const SIZE: ImageSize = ImageSize { width: 160, height: 120 };
/// Sides of the map, texels.
const MAPS: [u32; 4] = [256, 512, 1024, 2048];
/// Number of maps of a lamp.
const VIEWS: usize = 6;

/// The shadows of a method; `None` means the default of a figure, whatever the size of the others' maps.
type Way = Option<fn(u32) -> Shadows>;

const METHODS: [(&str, Way); 6] = [
    ("bias 0, edge 1", Some(|map| Shadows { map, bias: 0.0, ..Shadows::CAST })),
    ("bias 30, edge 1", Some(|map| Shadows { map, bias: 30.0, ..Shadows::CAST })),
    ("bias 1, edge 0", Some(|map| Shadows { map, softness: 0.0, ..Shadows::CAST })),
    ("bias 1, edge 1", Some(|map| Shadows { map, ..Shadows::CAST })),
    ("bias 1, edge 4", Some(|map| Shadows { map, softness: 4.0, ..Shadows::CAST })),
    (OWN, None),
];

/// Figures of the program with a light each, in three cases, and how far the light of an input is from it.
const CASES: [Case; 3] = [
    Case {
        names: ["screen and ball", "screen and ball, acne", "screen and ball, detached"],
        figure: include_str!("../../../../../assets/figures/pipeline/shadow-acne.toml"),
        light: Light::directional(SUN),
    },
    Case {
        names: ["house", "house, acne", "house, detached"],
        figure: include_str!("../../../../../assets/figures/house.toml"),
        light: Light::directional(SUN),
    },
    Case {
        names: ["corridor with a lamp", "corridor with a lamp, acne", "corridor with a lamp, detached"],
        figure: include_str!("../../../../../assets/figures/corridor.toml"),
        light: Light::point(glam::DVec3::new(0.1, 1.7, -2.0)),
    },
];
const SUN: glam::DVec3 = glam::DVec3::new(1.3, -1.6, -0.3);
/// The length of the vector added to a light's vector, in a random direction.
const ASIDE: f64 = 0.2;

struct Case {
    /// The names for all wrong pixels, for the dark ones, and for the lit ones.
    names: [&'static str; 3],
    figure: &'static str,
    light: Light,
}

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let (count, maps) = (lab.many(3, 1), &MAPS[..lab.many(4, 2)]);
    let watch = lab.watch(CASES.len() * maps.len() * METHODS.len(), count);
    let mut by_case: [Vec<Row>; 3 * CASES.len()] = Default::default();
    for (c, case) in CASES.iter().enumerate() {
        let mut random = Random::new(lab.effort.seed, 1000 + c as u64);
        let mut setups = Vec::new();
        for _ in 0..count {
            let vector = case.light.vector + random.direction() * ASIDE;
            setups.extend(Setup::new(case.figure, Light { vector, ..case.light }, &lab.progress).await);
        }
        for &map in maps {
            if lab.progress.is_cancelled() {
                break;
            }
            let shadows = |way: Way| way.map_or(Shadows::CAST, |way| way(map));
            let (mut methods, mut figures): ([Vec<Method>; 3], [Vec<Option<String>>; 3]) = Default::default();
            let run = async |k: usize, trials: &mut [Trial; 3]| {
                for (input, setup) in setups.iter().enumerate() {
                    let wrong = setup.wrong(shadows(METHODS[k].1), &mut trials[0], &watch).await;
                    for (trial, error) in trials.iter_mut().zip(wrong.into_iter().flatten()) {
                        trial.note(input, Off { error, bits: 64.0 * error });
                    }
                }
            };
            let measured = lab.in_turns(METHODS.len(), run).await;
            for ((name, way), trials) in METHODS.into_iter().zip(measured) {
                let shadows = shadows(way);
                for (k, trial) in trials.into_iter().enumerate() {
                    figures[k].push(setups.get(trial.worst_input()).map(|setup| setup.figure(shadows)));
                    methods[k].push(Method::new(name, trial));
                }
            }
            for (k, (methods, figures)) in methods.into_iter().zip(figures).enumerate() {
                let (case, parameter) = (case.names[k].to_owned(), f64::from(map));
                // Each method has a figure of its own with its shadows.
                let rows = Group { case, parameter, unit: Unit::Share, methods }.rows(Study::Shadows, |_| None);
                let rows = rows.into_iter().zip(figures).map(|(row, figure)| Row { figure, ..row });
                by_case[k * CASES.len() + c].extend(rows);
            }
        }
    }
    let most = maps.last().map_or(0, |&map| map as usize);
    let working_set = VIEWS * most * most * size_of::<f32>();
    let rows = by_case.into_iter().flatten().collect();
    Findings { study: Study::Shadows, reference: "rays to the light in f64", working_set, rows }
}

/// A scene, its camera, a light, and the results of rays.
struct Setup {
    figure: Figure,
    camera: Camera,
    scene: Scene,
    light: Light,
    solids: Solids,
    truth: TrueLight,
}

impl Setup {
    async fn new(figure: &str, light: Light, progress: &Progress) -> Option<Self> {
        let figure = parse(figure).ok()?;
        let camera = Camera::new(&figure.camera).ok()?;
        let scene = under(&build(&figure.scene, &figure.style, &mut no_files).ok()?, light);
        let solids = Solids::of(&scene);
        let truth = TrueLight::by_rays(&solids, &camera, &light, SIZE, progress).await?;
        Some(Self { figure, camera, scene, light, solids, truth })
    }

    /// The shares of pixels that are wrong, wrongly dark and wrongly lit. `None` after the first turn.
    async fn wrong(&self, shadows: Shadows, trial: &mut Trial, watch: &Watch) -> Option<[f64; 3]> {
        let scene = Scene { lights: vec![self.light.with_shadows(shadows)], ..self.scene.clone() };
        let mut rasterizer = Rasterizer::default();
        let mut painted = None;
        trial.time_whole(watch, 1, || {
            // A pipeline that hasn't seen the light, so it makes the maps.
            let drawing = arriving(&mut Pipeline::default(), &scene, &self.camera, SIZE);
            painted = rasterizer.paint(&drawing);
        });
        let pixmap = painted.filter(|_| trial.is_first())?;
        let verdicts = self.truth.judge(&pixmap, &self.solids, &self.camera, &watch.progress).await?;
        let count = |is: fn(Verdict) -> bool| verdicts.iter().filter(|verdict| is(**verdict)).count();
        let of = count(|verdict| verdict != Verdict::None).max(1);
        let dark = count(|verdict| verdict == Verdict::WronglyDark);
        let lit = count(|verdict| verdict == Verdict::WronglyLit);
        Some([dark + lit, dark, lit].map(|wrong| wrong as f64 / of as f64))
    }

    /// The figure with its wrong pixels marked.
    fn figure(&self, shadows: Shadows) -> String {
        let lights = vec![self.light.with_shadows(shadows)];
        let scene = SceneSpec { lights, ..self.figure.scene.clone() };
        let reveal = Reveal { shadows: Some(ShadowReveal::Truth), ..Reveal::default() };
        write::to_toml(&Figure { camera: self.figure.camera, image: SIZE, scene, reveal, ..Figure::default() })
    }
}
