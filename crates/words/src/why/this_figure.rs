//! The words of the study of the figure at hand: error, time and memory of each way to draw it.

use super::reasons::reason;
use crate::figure::words::{DEPTH_FORMATS, FACE_ORDERS, SHADINGS, VISIBILITIES, Words};
use crate::limits::{MAX_RAY_TRIANGLES, MAX_STEPPED_PIXELS};
use crate::numbers::{in_threes, significant};
use crate::numerics::this_figure::{
    ChartWords, Key, LeftOut, NoExactImage, SAMPLES, Saving, Study, Value, Way, WhyNot,
};
use crate::pictures::labels;
use crate::scene::SceneSpec;
use crate::window::scenes;

texts!("why/this_figure");

/// Why there's no exact image.
pub fn no_exact_image(lang: Lang, error: NoExactImage) -> String {
    match error {
        NoExactImage::Pixels => {
            let most = in_threes(usize::try_from(MAX_STEPPED_PIXELS).unwrap_or(usize::MAX));
            text!(lang, too_many_pixels, most)
        }
        NoExactImage::Triangles => text!(lang, too_many_triangles, most = in_threes(MAX_RAY_TRIANGLES)),
        NoExactImage::Memory => text!(lang, no_memory).to_owned(),
        NoExactImage::Cancelled => text!(lang, cancelled).to_owned(),
    }
}

/// Why a key isn't tried.
pub fn why_not(lang: Lang, why: WhyNot) -> String {
    match why {
        WhyNot::Plan(why) => reason(lang, why),
        WhyNot::Look => text!(lang, look).to_owned(),
        WhyNot::Preset => text!(lang, preset).to_owned(),
        WhyNot::Magnified => text!(lang, magnified).to_owned(),
        WhyNot::FewFills(share) => text!(lang, few_fills, saved = percent(lang, share)),
    }
}

/// A value of a key in words: “painter”, “4 samples”. `scene` names the objects.
pub fn value(lang: Lang, scene: &SceneSpec, key: Key, value: Value) -> String {
    let labels = labels(lang);
    match (key, value) {
        (Key::Visibility, Value::Word(word)) => named(VISIBILITIES, &labels.visibilities, word),
        (Key::DepthFormat, Value::Word(word)) => named(DEPTH_FORMATS, &labels.depth_formats, word),
        (Key::Order, Value::Word(word)) => named(FACE_ORDERS, &labels.face_orders, word),
        (Key::Shading, Value::Word(word)) => named(SHADINGS, &labels.shadings, word),
        (Key::Filter(k), Value::Word(word)) => {
            let t = scenes::texts(lang);
            let filter = match word {
                "nearest" => t.filter_nearest,
                "bilinear" => t.filter_bilinear,
                _ => t.filter_trilinear,
            };
            let object = scene.objects.get(k).map_or("", |object| &object.name);
            text!(lang, filter, object = crate::sanitize::escaped(object), filter)
        }
        (Key::Antialias, Value::Number(1.0)) => text!(lang, one_sample).to_owned(),
        (Key::Antialias, Value::Number(count)) => text!(lang, samples, count),
        (Key::ShadowMap(_), Value::Number(size)) => text!(lang, map, size),
        (Key::ShadowBias(_), Value::Number(value)) => text!(lang, bias, value = lang.mark().number(value, 3)),
        (_, Value::Word(word)) => word.to_owned(),
        (_, Value::Number(number)) => lang.mark().number(number, 6),
    }
}

fn named<T>(words: Words<T>, texts: &[&str], word: &str) -> String {
    let place = words.iter().position(|(name, _)| *name == word);
    place.and_then(|place| texts.get(place)).copied().unwrap_or(word).to_owned()
}

/// The values of a way in words, one after the other.
pub fn set(lang: Lang, scene: &SceneSpec, study: &Study, way: &Way) -> String {
    values(lang, scene, study.set(way), way_of_hiding(study, way))
}

/// The values in which a way differs from the figure, in words. Nothing for the figure's own way.
pub fn changed(lang: Lang, scene: &SceneSpec, study: &Study, way: &Way) -> String {
    values(lang, scene, study.changes(way).into_iter(), way_of_hiding(study, way))
}

fn way_of_hiding(study: &Study, way: &Way) -> Option<Value> {
    study.set(way).find_map(|(key, value)| (key == Key::Visibility).then_some(value))
}

/// Values in words. Without a depth buffer, its format and the order of faces mean nothing.
fn values(lang: Lang, scene: &SceneSpec, of: impl Iterator<Item = (Key, Value)>, visibility: Option<Value>) -> String {
    let has_depths = visibility == Some(Value::Word("depth-buffer"));
    let of = of.filter(|(key, _)| has_depths || !matches!(key, Key::DepthFormat | Key::Order));
    let text = of.map(|(key, of)| value(lang, scene, key, of)).collect::<Vec<_>>().join(", ");
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// A share as a percentage, without its sign: `0.02`.
fn percent(lang: Lang, share: f64) -> String {
    lang.mark().number(100.0 * share, 2)
}

fn milliseconds(lang: Lang, ms: f64) -> String {
    lang.mark().number(ms, 3)
}

/// A way with its time and its error, in one line.
pub fn way(lang: Lang, scene: &SceneSpec, study: &Study, way: &Way) -> String {
    let [ms, low, high] = [way.ms.median, way.ms.low, way.ms.high].map(|ms| milliseconds(lang, ms));
    let (set, different) = (set(lang, scene, study, way), percent(lang, way.cost.different));
    text!(lang, way, set, ms, low, high, different)
}

/// If even the best way differs in a greater share of the pixels, that share alone says little.
const MANY: f64 = 0.05;

/// The two answers: the figure as it is, and the cheapest way that can't be told from the best.
pub fn answers(lang: Lang, scene: &SceneSpec, study: &Study) -> Vec<String> {
    let [Some(yours), Some(cheapest)] = [study.yours, study.cheapest].map(|place| study.ways.get(place)) else {
        return Vec::new();
    };
    if study.choices.is_empty() {
        let different = percent(lang, yours.cost.different);
        let best = text!(lang, best_is, best = different.clone(), this = different);
        return vec![text!(lang, only_way).to_owned(), best];
    }
    let mut lines = vec![text!(lang, yours_is, way = way(lang, scene, study, yours))];
    if study.yours == study.cheapest {
        lines.push(text!(lang, yours_is_cheapest).to_owned());
    } else {
        let share = lang.mark().number(cheapest.ms.median / yours.ms.median, 2);
        lines.push(text!(lang, cheapest_is, way = way(lang, scene, study, cheapest), share));
    }
    let [best, this] = [study.best(), cheapest.cost.different].map(|share| percent(lang, share));
    if best != this {
        lines.push(text!(lang, best_is, best, this));
    }
    if study.best() > MANY {
        lines.push(text!(lang, all_differ).to_owned());
    }
    lines
}

/// The keys that weren't tried, and the sections that were set aside.
pub fn left_out(lang: Lang, study: &Study) -> Vec<String> {
    let line = |LeftOut { key, why }: &LeftOut| text!(lang, left_out, key, reason = why_not(lang, *why));
    let mut lines: Vec<String> = study.left_out.iter().map(line).collect();
    if !study.set_aside.is_empty() {
        lines.push(text!(lang, set_aside, list = study.set_aside.join(", ")));
    }
    lines
}

/// Time, share of differing pixels, root mean square and memory of a way.
pub fn columns(lang: Lang, way: &Way) -> [String; 4] {
    let different = format!("{} %", percent(lang, way.cost.different));
    let rms = lang.mark().printed(&significant(way.cost.rms, 2));
    [milliseconds(lang, way.ms.median), different, rms, mebibytes(lang, way.cost.bytes)]
}

/// The mark of a way: on the front, off it, or undecided.
pub const fn mark(way: &Way) -> char {
    match (way.undecided, way.front) {
        (true, _) => '?',
        (false, true) => '*',
        (false, false) => ' ',
    }
}

/// A study as a table: `*` marks the front, the fastest way comes first.
pub fn table(lang: Lang, scene: &SceneSpec, study: &Study) -> String {
    let t = texts(lang);
    let ([width, height], samples) = (study.size, SAMPLES);
    let rays = in_threes(usize::try_from(study.exact.rays).unwrap_or(usize::MAX));
    let mut table = text!(lang, head, width, height, samples, rays, ways = study.ways.len());
    table += &format!(
        "\n\n    {:>10}{:>10}{:>10}{:>9}{:>16}{:>11}\n",
        t.different, t.wrong, t.rms, t.ms, t.interval, t.memory
    );
    let mut ways: Vec<&Way> = study.ways.iter().collect();
    ways.sort_by(|a, b| a.ms.median.total_cmp(&b.ms.median));
    for way in ways {
        let mark = mark(way);
        let share = |share: f64| format!("{} %", percent(lang, share));
        let [low, high] = [way.ms.low, way.ms.high].map(|ms| milliseconds(lang, ms));
        table += &format!(
            "  {mark} {:>10}{:>10}{:>10}{:>9}{:>16}{:>11}  {}\n",
            share(way.cost.different),
            share(way.cost.wrong),
            lang.mark().printed(&significant(way.cost.rms, 2)),
            milliseconds(lang, way.ms.median),
            format!("{low} … {high}"),
            mebibytes(lang, way.cost.bytes),
            set(lang, scene, study, way),
        );
    }
    table += &format!("{}\n\n", t.star);
    for line in answers(lang, scene, study).into_iter().chain(left_out(lang, study)) {
        table += &format!("{line}\n");
    }
    table
}

/// Bytes as MiB.
pub fn mebibytes(lang: Lang, bytes: usize) -> String {
    format!("{} MiB", lang.mark().number(bytes as f64 / f64::from(1 << 20), 3))
}

/// The words of the chart, given to `with`.
pub fn with_words<T>(lang: Lang, scene: &SceneSpec, with: impl FnOnce(&ChartWords) -> T) -> T {
    let t = texts(lang);
    with(&ChartWords {
        title: t.title,
        time: t.time,
        share: t.share,
        front: t.front,
        yours: t.yours,
        mark: lang.mark(),
        value: &|key, of| value(lang, scene, key, of),
    })
}

/// The savings of the plan, a line for each stage that it leaves out.
pub fn savings(lang: Lang, savings: &[Saving]) -> String {
    if savings.is_empty() {
        return format!("{}\n", text!(lang, saved_nothing));
    }
    let line = |Saving { stage, ms, same_bytes }: &Saving| {
        let [ms, low, high] = [ms.median, ms.low, ms.high].map(|ms| lang.mark().printed(&format!("{ms:.3}")));
        let bytes = if *same_bytes { text!(lang, same_bytes) } else { text!(lang, other_bytes) };
        format!("{:<18} {}\n", super::pipeline::stage(lang, *stage), text!(lang, saved, ms, low, high, bytes))
    };
    format!("{}\n{}", text!(lang, saved_head), savings.iter().map(line).collect::<String>())
}
