//! The built-in figures and meshes, which are available wherever the program is, installed or not.

use std::borrow::Cow;
use std::path::Path;
use std::sync::LazyLock;

use crate::figure::read::parse;
use crate::figure::{Figure, Localized};

/// The prefix of a built-in mesh in a figure: `camera-lab:teapot.obj`.
pub const SHIPPED: &str = "camera-lab:";

/// A heading in the gallery.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Topic {
    /// The camera, and scenes to look at.
    Camera,
    /// Projection, and the canonical volume.
    Cube,
    /// Clipping, and dividing by w.
    Clipping,
    /// Hidden surfaces and depth.
    Hidden,
    /// Light, textures and shadows.
    Light,
    /// The exercises of the notes.
    Exercises,
    /// Cameras at the limits of numbers.
    Limits,
}

/// A built-in figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShippedFigure {
    /// Its name, without an ending.
    pub name: &'static str,
    /// The heading for it in the gallery.
    pub topic: Topic,
    text: &'static str,
}

macro_rules! shipped {
    ($($topic:ident $folder:literal: $($name:literal),*;)*) => {
        [$($(ShippedFigure {
            name: $name,
            topic: Topic::$topic,
            text: include_str!(concat!("../../../assets/figures/", $folder, $name, ".toml")),
        },)*)*]
    };
}

/// All of them, in the order of display. Every named scene is among them.
pub const SHIPPED_FIGURES: [ShippedFigure; 54] = shipped![
    Camera "": "primitives", "house", "corridor", "teapot", "arm", "cube", "empty";
    Camera "pipeline/": "look-at", "two-eyes";
    Cube "pipeline/": "frustum-to-cube", "parallel-perspective", "view-angles", "opengl-direct3d";
    Cube "": "ndc-cube";
    Clipping "pipeline/": "clipping", "divide-first", "culled";
    Hidden "pipeline/": "painter", "bsp", "depth", "depth-linear", "z-fighting";
    Light "pipeline/": "wireframe", "flat", "gouraud", "phong", "frame-cost", "texture-affine", "texture-levels",
    "texture-texels", "shadow-acne", "shadow-detached", "shadow-steps", "shadow-light";
    Exercises "": "pyramid", "exercise-5.1", "exercise-5.2", "exercise-5.3";
    Limits "extreme/":
    "far-plane",
    "far-near",
    "thin-volume",
    "narrow-angle",
    "wide-angle",
    "wide-window",
    "tall-window",
    "aside",
    "far-position",
    "small-distance",
    "large-distance",
    "steep-up",
    "zoomed-out",
    "solar",
    "half-cube",
    "far-world";
];

/// The built-in figures, parsed when first needed.
static FIGURES: LazyLock<Vec<Figure>> =
    LazyLock::new(|| SHIPPED_FIGURES.iter().map(|figure| parse(&figure.text()).unwrap_or_default()).collect());

impl ShippedFigure {
    /// The figure with this name.
    pub fn named(name: &str) -> Option<Self> {
        SHIPPED_FIGURES.into_iter().find(|figure| figure.name == name)
    }

    /// Its title and its caption.
    pub fn told(self) -> [Localized; 2] {
        let place = SHIPPED_FIGURES.iter().position(|figure| figure.name == self.name);
        let figure = place.and_then(|place| FIGURES.get(place));
        figure
            .map(|figure| [&figure.title, &figure.caption].map(|text| text.clone().unwrap_or_default()))
            .unwrap_or_default()
    }

    /// The text of its figure file. Its meshes are built-in, so that it means the same in every folder.
    pub fn text(self) -> Cow<'static, str> {
        if self.text.contains("../meshes/") {
            self.text.replace("../meshes/", SHIPPED).into()
        } else {
            self.text.into()
        }
    }
}

/// The bytes of a built-in file named by a scene, or by a built-in mesh. `None` for files.
pub(super) fn shipped_file(path: &str, named_by: Option<&str>) -> Option<&'static [u8]> {
    let by_mesh = named_by.is_some_and(|mesh| mesh.starts_with(SHIPPED));
    let name =
        path.strip_prefix(SHIPPED).or_else(|| by_mesh.then(|| Path::new(path).file_name()?.to_str()).flatten())?;
    match name {
        "teapot.obj" => Some(include_bytes!("../../../assets/meshes/teapot.obj")),
        "teapot.mtl" => Some(include_bytes!("../../../assets/meshes/teapot.mtl")),
        "house.png" => Some(include_bytes!("../../../assets/photographs/house.png")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::progress::{Progress, at_once};
    use crate::scene::Preset;
    use crate::scene::import::read;
    use crate::{FigureFiles, FileAccess};

    #[test]
    fn every_figure_of_the_program_is_shipped_and_every_named_scene_among_them() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/figures");
        let entries = [folder.join("extreme"), folder.join("pipeline"), folder]
            .into_iter()
            .flat_map(|folder| std::fs::read_dir(folder).unwrap());
        let paths = entries.map(|entry| entry.unwrap().path()).filter(|path| path.is_file());
        let mut files: Vec<String> = paths.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
        let mut names: Vec<&str> = SHIPPED_FIGURES.iter().map(|figure| figure.name).collect();
        files.sort();
        names.sort_unstable();
        assert_eq!(files, names);
        let presets: Vec<Preset> =
            SHIPPED_FIGURES.iter().map(|figure| parse(&figure.text()).unwrap().scene.preset).collect();
        for (name, preset) in Preset::NAMED {
            // [0] 5.1 is shipped without its answer, which the preset draws.
            assert!(presets.contains(preset) || *preset == Preset::Exercise51, "{name}");
        }
    }

    #[test]
    fn every_figure_of_the_program_has_a_title_and_a_caption_in_both_languages() {
        for figure in SHIPPED_FIGURES {
            let [title, caption] = figure.told();
            assert!(!title.en.is_empty() && !title.pt_br.is_empty() && caption.en != caption.pt_br, "{}", figure.name);
            for sentence in [caption.en, caption.pt_br] {
                assert!(sentence.ends_with(['.', '?']) && sentence.chars().count() < 110, "{sentence}");
            }
        }
    }

    #[test]
    fn figures_of_one_topic_stand_together() {
        let topics: Vec<Topic> = SHIPPED_FIGURES.map(|figure| figure.topic).to_vec();
        let mut runs: Vec<Topic> = topics.chunk_by(|a, b| a == b).map(|run| run[0]).collect();
        let count = runs.len();
        runs.sort_by_key(|topic| *topic as usize);
        runs.dedup();
        assert_eq!(runs.len(), count);
    }

    #[test]
    fn a_mesh_of_the_program_is_read_from_anywhere_with_its_colours() {
        assert!(ShippedFigure::named("teapot").unwrap().text().contains("\"camera-lab:teapot.obj\""));
        for reach in [FileAccess::Picture, FileAccess::Figure] {
            let mut files = FigureFiles::new(Path::new("/no/such/folder"), reach);
            let read = |path, files: &mut FigureFiles| {
                at_once(read(path, &mut |wanted| files.read(wanted), &Progress::default()))
            };
            let parts = read("camera-lab:teapot.obj", &mut files).unwrap();
            assert!(!parts.parts.is_empty() && files.unread().is_empty(), "{:?}", files.unread());
            assert!(read("camera-lab:nothing.obj", &mut files).is_err());
        }
    }
}
