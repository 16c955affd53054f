//! The words of the gallery: its parts, and the headings of the built-in figures.

use crate::Lang;
use camera_lab_files::Topic;

texts!("window/gallery");

/// The heading of a topic.
pub fn heading(lang: Lang, topic: Topic) -> &'static str {
    let t = texts(lang);
    match topic {
        Topic::Camera => t.camera,
        Topic::Cube => t.cube,
        Topic::Clipping => t.clipping,
        Topic::Hidden => t.hidden,
        Topic::Light => t.light,
        Topic::Exercises => t.exercises,
        Topic::Limits => t.limits,
    }
}
