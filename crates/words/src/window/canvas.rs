//! The words around the three pictures: titles, hints, readouts, and descriptions for screen readers.

use glam::DVec3;

use crate::camera::{Camera, ImageSize};
use crate::views::{Arrangement, View};

texts!("window/canvas");

/// The texts of the canvas in one language, under a name that distinguishes them from the window's, which are often at
/// hand too.
pub type CanvasTexts = Texts;

/// The observer of a picture went back. The first key fits the picture, undo of the camera brings it back.
pub fn went_back(lang: Lang, view: View) -> String {
    let name = texts(lang).view(view);
    text!(lang, went_back, name)
}

impl CanvasTexts {
    /// The name of an arrangement. `None` is the automatic one.
    pub fn arrangement(&self, arrangement: Option<Arrangement>) -> &'static str {
        match arrangement {
            None => self.arrange_auto,
            Some(Arrangement::Row) => self.arrange_row,
            Some(Arrangement::Column) => self.arrange_column,
            Some(Arrangement::Above) => self.arrange_above,
            Some(Arrangement::Beside) => self.arrange_beside,
        }
    }
}

impl Texts {
    /// The name of a picture.
    pub fn view(&self, view: View) -> &'static str {
        let t = super::texts(self.lang);
        match view {
            View::World => t.show_world,
            View::Canonical => t.show_canonical,
            View::Image => t.show_image,
        }
    }
}

/// A picture in words: the camera's place of the world, the size of the image in pixels.
pub fn describe(lang: Lang, view: View, camera: &Camera, image: ImageSize) -> String {
    match view {
        View::World => {
            let place = |p: DVec3| lang.mark().tuple(&p.to_array(), 4);
            describe_world(lang, &place(camera.position()), &place(camera.focal_point()))
        }
        View::Canonical => describe_canonical(lang),
        View::Image => describe_image(lang, image.width, image.height),
    }
}

/// The world in words, from the coordinates of C and PF.
fn describe_world(lang: Lang, position: &str, focal_point: &str) -> String {
    text!(lang, describe_world, position, focal_point)
}

/// The canonical volume in words.
fn describe_canonical(lang: Lang) -> String {
    text!(lang, describe_canonical).to_owned()
}

/// The image in words, from its size in pixels.
fn describe_image(lang: Lang, width: u32, height: u32) -> String {
    text!(lang, describe_image, width, height)
}
