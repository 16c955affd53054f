//! The figure on the other side of a comparison, and the figures that a comparison makes.

use toml_edit::{Item, TableLike, Value};

use super::edit::{value_of, varied_together};
use super::error::{Allowed, FigureError, Problem};
use super::value::{NOTHING, quoted};
use super::write::sections;
use super::{Comparison, Figure};
use crate::camera::{Camera, Convention};
use crate::limits::MAX_COMPARED_KEYS;
use crate::sanitize::escaped;

/// The other side of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherSide {
    /// The figure in the other way, without its scene.
    pub figure: Figure,
    /// Its camera, if it's another one.
    pub camera: Option<Camera>,
    /// The compared keys, with the values of the figure and of the other side as written; `None` if there is none.
    pub values: Vec<(String, [Option<String>; 2])>,
}

impl Comparison {
    /// A figure compared in one key. If it has the first of two values, it's compared with the second, else with the
    /// first.
    pub fn of_pair(self, figure: &Figure, key: &str, pair: [&str; 2]) -> Figure {
        let other = quoted(if Self::stands_left(figure, key, pair[0]) { pair[1] } else { pair[0] }).to_string();
        let compare = Some(Self { with: vec![(key.to_owned(), other)], ops: Vec::new(), ..self });
        Figure { compare, ..figure.clone() }
    }

    /// True if a figure, which is the left side, has this value of a key.
    pub fn stands_left(figure: &Figure, key: &str, value: &str) -> bool {
        own_value(figure, key).as_deref() == Some(value)
    }

    /// A comparison with another figure of the same scene: its whole camera, and its styles that differ.
    pub fn with_figure(self, figure: &Figure, other: &Figure) -> Self {
        let written = |section: &str, of: &Figure| -> Vec<(String, String)> {
            let document = sections(of, &[section], false);
            let keys = document.get(section).and_then(Item::as_table_like).into_iter().flat_map(TableLike::iter);
            let value = |item: &Item| Some(item.as_value()?.to_string().trim().to_owned());
            keys.filter_map(|(key, item)| Some((format!("{section}.{key}"), value(item)?))).collect()
        };
        let mut with = written("camera", &Figure { camera: other.camera, lens: other.lens, ..Figure::default() });
        if other.camera.window.is_none() {
            with.push(("camera.window".to_owned(), NOTHING.to_owned()));
        }
        // Both sides show one scene, whose colours come from a theme.
        let own = written("style", figure);
        with.extend(written("style", other).into_iter().filter(|key| key.0 != "style.theme" && !own.contains(key)));
        with.truncate(MAX_COMPARED_KEYS);
        Self { with, ops: Vec::new(), ..self }
    }

    /// True if the whole camera is another one, not a single key.
    pub fn is_of_camera(&self) -> bool {
        ["position", "focal_point", "view_up"]
            .into_iter()
            .all(|key| self.with.iter().any(|(with, _)| with.strip_prefix("camera.") == Some(key)))
    }

    /// The values of the first key on both sides, as written, without quotes.
    pub fn values(&self, figure: &Figure) -> Vec<String> {
        let Some((key, other)) = self.with.first() else { return Vec::new() };
        let other = other.trim_matches('"').to_owned();
        own_value(figure, key).into_iter().chain([other]).collect()
    }

    /// The figure of the other side. Its own comparison is left out.
    ///
    /// # Errors
    /// [`FigureError`], whose line is meaningless, if a value is impossible together with those of the figure, or the
    /// camera can't do an operation.
    pub fn other_side(&self, figure: &Figure) -> Result<OtherSide, FigureError> {
        let bare =
            Figure { observers: figure.observers, show: figure.show.clone(), compare: None, ..figure.without_scene() };
        let keys: Vec<(&str, &str)> = self.with.iter().map(|(key, value)| (&**key, &**value)).collect();
        let mut other = varied_together(&bare, &keys)?;
        if let Some(name) = &self.camera {
            let index = other.cameras.iter().position(|camera| camera.name == *name);
            let unknown = || FigureError {
                line: 1,
                key: "[compare] camera".to_owned(),
                problem: Problem::Value { found: escaped(name), allowed: Allowed::Camera },
            };
            other.look_through(index.ok_or_else(unknown)?);
        }
        let refused = |error| FigureError { line: 1, key: "[camera]".to_owned(), problem: Problem::Camera(error) };
        let mut camera = Camera::new(&other.camera).map_err(refused)?;
        for operation in &self.ops {
            camera = operation.apply(&camera, Convention::default()).map_err(refused)?;
        }
        other.camera = *camera.parameters();
        let values = self.with.iter().map(|(key, _)| {
            let written =
                |value: Value| value.as_str().map_or_else(|| value.to_string().trim().to_owned(), str::to_owned);
            (key.clone(), [&bare, &other].map(|figure| any_value(figure, key).map(written)))
        });
        let (values, is_another) = (values.collect(), other.camera != bare.camera);
        Ok(OtherSide { figure: other, camera: is_another.then_some(camera), values })
    }

    /// The same comparison with its sides exchanged, and the figure that belongs to it. `None` if there's no other
    /// side, or the figure has no written value of one of its keys.
    pub fn swapped(&self, figure: &Figure) -> Option<Figure> {
        if let Some(name) = &self.camera {
            let index = figure.cameras.iter().position(|camera| camera.name == *name)?;
            let mut swapped = figure.clone();
            swapped.look_through(index);
            return Some(swapped);
        }
        let other = self.other_side(figure).ok().filter(|_| self.ops.is_empty())?;
        let own =
            |(key, _): &(String, String)| Some((key.clone(), any_value(figure, key)?.to_string().trim().to_owned()));
        let with: Option<Vec<_>> = if self.is_of_camera() {
            // θ may be written in another way on the other side.
            Some(Self::default().with_figure(&other.figure, figure).with)
        } else {
            self.with.iter().map(own).collect()
        };
        let compare = Some(Self { with: with?, wiper: self.wiper, ..self.clone() });
        Some(Figure { scene: figure.scene.clone(), compare, ..other.figure })
    }
}

/// The value that a figure has for a key, without quotes.
fn own_value(figure: &Figure, key: &str) -> Option<String> {
    Some(any_value(figure, key)?.to_string().trim().trim_matches('"').to_owned())
}

/// The value that a figure has for a key, written or not. A window that belongs to the angle is no value.
fn any_value(figure: &Figure, key: &str) -> Option<Value> {
    value_of(figure, key, true).or_else(|| (key == "camera.window").then(|| quoted("")))
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::appearance::Visibility;
    use crate::figure::read::parse;
    use crate::figure::write::to_toml;
    use crate::figure::{update, varied};

    #[test]
    fn a_comparison_is_read_written_and_edited() {
        let text = "[compare]\nwith = { \"style.visibility\" = \"painter\", camera = { near = 0.5 } } # two keys\n\
                    ops = [\"azimuth=30\", \"pan=1,-0.5\"]\nwiper = 0.25\ndifferences = true\n";
        let figure = parse(text).unwrap();
        let comparison = figure.compare.clone().unwrap();
        let with =
            [("style.visibility", "\"painter\""), ("camera.near", "0.5")].map(|(k, v)| (k.to_owned(), v.to_owned()));
        assert_eq!(comparison.with, with);
        assert_eq!((comparison.ops.len(), comparison.wiper, comparison.differences), (2, 0.25, true));
        assert_eq!(parse(&to_toml(&figure)).unwrap(), figure);
        let beside = Comparison { beside: true, wiper: 0.5, ..comparison.clone() };
        let beside = Figure { compare: Some(beside), ..figure.clone() };
        assert_eq!(parse(&to_toml(&beside)).unwrap(), beside);
        let moved = Figure { compare: Some(Comparison { wiper: 0.75, ..comparison }), ..figure.clone() };
        let edited = update(text, &moved);
        assert!(edited.contains("wiper = 0.75") && edited.contains("# two keys"), "{edited}");
        assert_eq!(parse(&edited).unwrap(), moved);
        let none = Figure { compare: None, ..figure };
        assert_eq!(parse(&update(text, &none)).unwrap(), none);
        assert!(!to_toml(&none).contains("compare"));
    }

    #[test]
    fn the_other_side_has_the_other_values_and_reads_impossible_ones() {
        let text = "[camera]\nnear = 2\n[compare]\nwith = { \"style.visibility\" = \"painter\", \"reveal.depth\" = true }\n\
                    ops = [\"zoom=2\"]\n";
        let figure = parse(text).unwrap();
        let comparison = figure.compare.clone().unwrap();
        let other = comparison.other_side(&figure).unwrap();
        assert_eq!(other.figure.style.visibility, Visibility::Painter);
        assert_eq!((other.camera.is_some(), other.figure.compare.clone()), (true, None));
        let text = |text: &str| Some(text.to_owned());
        assert_eq!(other.values[0].1, [text("depth-buffer"), text("painter")]);
        assert_eq!(other.values[1].1, [text("false"), text("true")]);
        // Near passes the old back plane, and the order of the keys doesn't matter.
        for keys in ["\"camera.near\" = 50, \"camera.far\" = 200", "\"camera.far\" = 200, \"camera.near\" = 50"] {
            let figure = parse(&format!("[compare]\nwith = {{ {keys} }}\n")).unwrap();
            let other = figure.compare.as_ref().unwrap().other_side(&figure).unwrap();
            assert_eq!([other.figure.camera.near, other.figure.camera.far], [50.0, 200.0]);
        }
        let far = parse("[compare]\nwith = { \"camera.near\" = 1e9 }\n").unwrap();
        assert!(far.compare.as_ref().unwrap().other_side(&far).is_err());
    }

    #[test]
    fn sides_are_swapped_and_swapped_back() {
        let figure =
            parse("[compare]\nwith = { \"style.visibility\" = \"painter\", \"world.section\" = true }\n").unwrap();
        let swapped = figure.compare.clone().unwrap().swapped(&figure).unwrap();
        assert_eq!((swapped.style.visibility, swapped.world.section), (Visibility::Painter, true));
        assert_eq!(swapped.compare.clone().unwrap().swapped(&swapped).unwrap(), figure);
    }

    #[test]
    fn one_key_is_set_anywhere_and_the_scene_stays() {
        let figure = parse("[scene]\npreset = \"house\"\n[camera]\nnear = 0.5\n").unwrap();
        let shaded = varied(&figure, "style.shading", "phong").unwrap();
        assert_eq!((shaded.style.shading, &shaded.scene), (crate::appearance::Shading::Phong, &figure.scene));
        assert_eq!(varied(&shaded, "style.shading", "").unwrap(), figure);
        assert_ne!(varied(&figure, "scene.preset", "cube").unwrap().scene, figure.scene);
        assert!(matches!(varied(&figure, "style.shadng", "flat").unwrap_err().problem, Problem::UnknownKey { .. }));
    }
}
