//! The `[[cameras]]` of a figure as pictures draw them.

use super::Palette;
use crate::appearance::Rgba;
use crate::camera::Camera;
use crate::figure::Figure;

/// A camera of the figure that isn't the one of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherCamera {
    /// Its name in the figure.
    pub name: String,
    /// Its color; `None` means the color of its place.
    pub color: Option<Rgba>,
    /// The camera, [rounded](Camera::rounded).
    pub camera: Camera,
}

impl OtherCamera {
    /// The `[[cameras]]` of a figure.
    pub fn of_figure(figure: &Figure) -> Vec<Self> {
        let one = |camera: &Camera| camera.rounded();
        let others = figure.cameras.iter().filter_map(|named| {
            let camera = one(&Camera::new(&named.parameters).ok()?);
            Some(Self { name: named.name.clone(), color: named.color, camera })
        });
        others.collect()
    }

    /// The name of its label, with which an author changes it.
    pub fn label_name(&self) -> String {
        format!("camera:{}", self.name)
    }

    /// The names of all of its labels.
    pub fn label_names(&self) -> [String; 4] {
        let own = self.label_name();
        ["", ":u", ":v", ":n"].map(|axis| format!("{own}{axis}"))
    }

    /// The color of a camera at a place of the list, either the given one, or that of its place.
    pub fn color_at(given: Option<Rgba>, place: usize, palette: Palette) -> Rgba {
        let [x, y, z] = palette.axes;
        let usual = [z, palette.view_up, y, x];
        given.map_or(usual[place % usual.len()], |color| color.with_alpha(255))
    }
}
