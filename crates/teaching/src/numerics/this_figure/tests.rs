#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use super::*;
use crate::camera::Camera;
use crate::figure::read::parse;
use crate::progress::at_once;
use crate::scene::{build, no_files};

pub(super) fn small() -> Size {
    Size { width: 96, height: 72, scale: 1.0 }
}

/// Words for labels: the pictures of these tests have none.
pub(super) fn labels() -> &'static Labels {
    static EMPTY: std::sync::LazyLock<Labels> = std::sync::LazyLock::new(Labels::default);
    &EMPTY
}

pub(super) fn read(text: &str) -> (Figure, SharedScene, Camera) {
    let figure = parse(text).unwrap();
    let scene = build(&figure.scene, &figure.style, &mut no_files).unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    (figure, SharedScene::new(scene), camera)
}

/// A figure of the program.
pub(super) fn opened(name: &str) -> (Figure, SharedScene, Camera) {
    let path = format!("{}/../../assets/figures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    read(&std::fs::read_to_string(path).unwrap())
}

fn study_of(name: &str) -> Study {
    let (figure, scene, camera) = opened(name);
    let (request, _) = request_of(&figure, &scene, &camera, labels(), small());
    let subject = Subject { figure: &figure, scene: &scene, request: &request };
    let effort = Effort { seconds: 0.0, ..Effort::default() };
    at_once(study(subject, effort, &Progress::default(), |_| ())).unwrap()
}

#[test]
fn every_study_has_the_figures_own_way_and_one_answer() {
    for name in ["house", "empty", "pipeline/wireframe", "pipeline/phong", "pipeline/texture-texels"] {
        let study = study_of(name);
        let own: Vec<usize> = study.choices.iter().map(|choice| choice.own).collect();
        assert_eq!(study.ways[study.yours].combination, own, "{name}");
        assert!(study.ways[study.cheapest].cost.different <= study.best() + WITHIN, "{name}");
        assert!(study.ways.iter().all(|way| way.rounds.len() == 1), "{name}");
        let kinds: Vec<Key> = study.choices.iter().map(|choice| choice.key).collect();
        assert_eq!(kinds.contains(&Key::Shading), name == "pipeline/phong" || name == "pipeline/texture-texels");
        let all: usize = study.choices.iter().map(|choice| choice.values.len()).product();
        assert!(all >= study.ways.len(), "{name}");
    }
    assert_eq!(study_of("empty").ways.len(), 1);
    assert_eq!(study_of("pipeline/wireframe").ways.len(), 1);
    // Formats of depths and orders mean nothing without a depth buffer: 3 · 3 + 1 + 1 ways of hiding, three numbers
    // of samples. The cube's faces hide nothing of one another, so no order saves a fill.
    assert_eq!(study_of("cube").ways.len(), 15);
    assert_eq!(study_of("house").ways.len(), 33);
}

/// Of a figure with more combinations than are all tried, every one is tried here.
#[test]
fn a_combination_that_is_not_tried_is_beaten_by_one_that_is() {
    for name in ["pipeline/texture-levels", "pipeline/shadow-detached"] {
        let (figure, scene, camera) = opened(name);
        let (request, _) = request_of(&figure, &scene, &camera, labels(), small());
        let study = study_of(name);
        let progress = Progress::default();
        let exact = at_once(exact_image::exact_image(&request, &progress)).unwrap();
        let mut tried = Tried {
            subject: Subject { figure: &figure, scene: &scene, request: &request },
            plan_of: Renderer::default(),
            choices: study.choices.clone(),
            exact: exact.pixels,
            counter: Counter::default(),
            wrong: HashMap::new(),
            known: HashMap::new(),
            progress,
        };
        let mut all: Vec<Combination> = vec![Vec::new()];
        for choice in &study.choices {
            let with = |of: &Combination, value| of.iter().copied().chain([value]).collect();
            all = all.iter().flat_map(|of| (0..choice.values.len()).map(move |value| with(of, value))).collect();
        }
        let all = distinct(all.into_iter().map(|of| canonical(&study.choices, of)).collect());
        assert!(all.len() > study.ways.len() && study.ways.len() <= ALL_TRIED, "{name}: {}", all.len());
        let most = study.best() + WITHIN;
        for combination in all {
            let cost = at_once(tried.cost(&combination)).unwrap().unwrap();
            // None that could be the answer is missing, unless one that was tried is as good and as small.
            let stands_for = |way: &Way| way.combination == combination || way.cost.is_at_most(&cost);
            assert!(cost.different > most || study.ways.iter().any(stands_for), "{name}: {combination:?} {cost:?}");
            assert!(cost.different >= study.best() - WITHIN, "{name}: {combination:?} {cost:?}");
        }
    }
}

#[test]
fn the_exact_image_is_that_of_the_best_way_but_for_its_edges() {
    // In so small an image, edges are a hundredth of the pixels. Wrong light would be wrong in far more.
    for name in ["house", "corridor", "pipeline/phong", "pipeline/shadow-detached"] {
        let best = study_of(name).best();
        assert!(best < 0.03, "{name}: {best}");
    }
}

#[test]
fn a_cancelled_study_ends() {
    let (figure, scene, camera) = opened("house");
    let (request, _) = request_of(&figure, &scene, &camera, labels(), small());
    let subject = Subject { figure: &figure, scene: &scene, request: &request };
    let progress = Progress::default();
    progress.cancel();
    let ended = at_once(study(subject, Effort::default(), &progress, |_| ()));
    assert_eq!(ended.err(), Some(NoExactImage::Cancelled));
}
