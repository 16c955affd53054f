//! The words of the window.

pub mod canvas;
pub mod coach;
pub mod progress;
pub mod scenes;
pub mod search;
pub mod sessions;

use crate::camera::ParameterKey;

/// A parameter of the camera by its symbol and its name, as beside its field.
pub fn parameter(lang: Lang, key: ParameterKey) -> String {
    let t = texts(lang);
    let name = match key {
        ParameterKey::Position => t.position,
        ParameterKey::FocalPoint => t.focal_point,
        ParameterKey::ViewUp => t.view_up,
        ParameterKey::ViewAngle => t.view_angle,
        ParameterKey::Height => t.height,
        ParameterKey::Aspect => t.aspect,
        ParameterKey::Near => t.near,
        ParameterKey::Far => t.far,
        ParameterKey::Window => t.window,
    };
    format!("{} {name}", key.symbol())
}

/// The window's words for a key of figure files: a parameter of the camera, or the part that the key belongs to.
pub fn key_in_words(lang: Lang, key: &str) -> String {
    let t = texts(lang);
    let parameter = key.strip_prefix("camera.");
    if let Some(known) = ParameterKey::ALL.into_iter().find(|known| Some(known.name()) == parameter) {
        return self::parameter(lang, known);
    }
    let section = key.split('.').next().unwrap_or_default();
    let words = match section {
        "camera" => t.camera,
        "image" => t.image,
        "scene" => t.scene,
        "style" => t.style,
        "world" => t.show_world,
        "observers" => t.menu_viewpoint,
        "show" | "reveal" => t.explain_panel,
        "labels" => labels::texts(lang).title,
        _ => return key.to_owned(),
    };
    words.to_owned()
}

/// The words of the list of cameras, in both languages.
pub mod cameras {
    texts!("window/cameras");

    texts_with_values! {
        /// A camera has been kept under this name.
        kept(lang, name: &str);
    }
}

/// The words of the lens: the view angle as cameras and other programs give it, in both languages.
pub mod lens {
    texts!("window/lens");
}

/// Links to figures, and the differences in a page of a browser, in both languages.
pub mod sharing {
    texts!("window/sharing");
}

/// The words of *Predict first*: an operation asks about its effect beforehand.
pub mod predict {
    texts!("window/predict");

    texts_with_values! {
        /// The question of an operation about a point.
        where_to(lang, operation: &str);

        /// The question of an operation about sizes.
        how_large(lang, operation: &str);

        /// The answer about a point: its pixel, and the distance `off` of the mark.
        landed(lang, place: [f64; 2], off: &str): (pixel = lang.mark().tuple(&place.map(f64::floor), 5), off);

        /// The answer about sizes beside the outcome, as the factor by which the objects grow.
        sizes(lang, said: &str, happened: &str, times: f64): (said, happened, times = lang.mark().number(times, 3));
    }
}

/// The words of the gallery: its parts, and the headings of the built-in figures.
pub mod gallery {
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
}

/// The words of the dialog that compares a figure with itself in another way, and of the wiper, in both languages.
pub mod compare {
    use crate::figure::FigureError;
    use crate::messages;

    texts!("window/compare");

    /// The reason why there is no other side.
    pub fn impossible(lang: Lang, error: &FigureError) -> String {
        format!("{} {}", texts(lang).impossible, messages::without_line(lang, error))
    }

    /// The other figure has another scene.
    pub fn other_scene(lang: Lang, file: &str) -> String {
        text!(lang, other_scene, file)
    }
}

/// The words of the mode *Labels*, in both languages.
pub mod labels {
    use crate::figure::labels::LabelTextError;
    use crate::limits::MAX_LABEL_TEXT;
    use crate::messages::figure_files;
    use crate::sanitize::escaped;

    texts!("window/labels");

    /// The reason why a text can't be that of a label.
    pub fn refused(lang: Lang, error: &LabelTextError) -> String {
        match error {
            LabelTextError::Length => text!(lang, refused_length, MAX_LABEL_TEXT),
            LabelTextError::Formula(error) => {
                text!(lang, refused_formula, formula = figure_files::formula(lang, error))
            }
        }
    }

    /// A name in `[labels]` that no label has.
    pub fn unknown(lang: Lang, name: &str, near: Option<&str>) -> String {
        let name = escaped(name);
        let meant = figure_files::meant(lang, near);
        text!(lang, unknown, name, meant)
    }
}

/// The words of the photograph under the image, and of the tool that finds its camera, in both languages.
pub mod photograph {
    use crate::camera::WorldAxis;

    texts!("window/photograph");

    /// The name of an end of a line: its number from 1 and its axis, and true for the first end.
    pub fn end(lang: Lang, (number, axis): (usize, WorldAxis), is_first: bool) -> String {
        let axis = axis.name();
        if is_first { text!(lang, end_is_first, number, axis) } else { text!(lang, end_first, number, axis) }
    }

    /// A point on an axis with its coordinate: x = 2.
    pub fn length(lang: Lang, (axis, coordinate): (WorldAxis, f64)) -> String {
        format!("{} = {}", axis.name(), lang.mark().number(coordinate, 4))
    }

    /// The count of lines along each axis.
    pub fn counts(lang: Lang, [x, y, z]: [usize; 3]) -> String {
        text!(lang, counts, x, y, z)
    }

    /// The size of the photograph.
    pub fn size(lang: Lang, [width, height]: [u32; 2]) -> String {
        text!(lang, size, width, height)
    }
}

texts!("window");
