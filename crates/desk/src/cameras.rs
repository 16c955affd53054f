//! The list of cameras between frames, and the way to look through one of them.

use crate::Model;
use crate::camera::Convergence;
use crate::figure::NamedCamera;
use camera_lab_words::window::cameras;

/// The list of cameras.
#[derive(Clone, Debug, Default)]
pub struct CameraList {
    /// The baseline of the next stereo pair. `None` for a thirtieth of D, as in the textbooks of stereo photography.
    pub baseline: Option<f64>,
    /// True if the search leads to one of its buttons, so that the list is unfolded.
    pub was_called: bool,
}

impl CameraList {
    /// Looks through one of the other cameras of the figure.
    pub fn look_through(&mut self, model: &mut Model, index: usize) {
        model.desk.commit();
        model.desk.shown.look_through(index);
        // Its aspect is its own.
        let camera = model.desk.shown.draft();
        let image = model.desk.shown.figure().image;
        let is_of_image = camera.aspect == f64::from(image.width) / f64::from(image.height);
        model.settings.aspect_follows_image &= is_of_image || camera.window.is_some();
    }
}

impl Model {
    /// Keeps the current camera in the list under a name, or one like it.
    pub fn keep_camera(&mut self, name: &str) {
        let figure = self.desk.shown.figure();
        let camera = NamedCamera { name: free(figure, name), color: None, ..figure.current_camera() };
        self.desk.shown.edit_cameras(|figure| figure.add_camera(camera));
    }

    /// Makes the current camera and one more a stereo pair around it. The left one becomes the current one.
    pub fn make_stereo(&mut self, baseline: f64, convergence: Convergence) {
        let t = cameras::texts(self.settings.lang);
        match self.desk.shown.camera().stereo(baseline, convergence) {
            Err(error) => self.say_camera_error(Err(error)),
            Ok([left, right]) => {
                self.desk.commit();
                let name = free(self.desk.shown.figure(), t.right);
                let parameters = *right.parameters();
                let right = NamedCamera { name, color: None, parameters, lens: None };
                let figure = self.desk.shown.figure();
                let has_it = figure.tag.name.as_deref() == Some(t.left);
                let name = if has_it { t.left.to_owned() } else { free(figure, t.left) };
                self.desk.shown.edit_cameras(|figure| {
                    figure.tag.name = Some(name);
                    figure.add_camera(right);
                });
                self.desk.shown.set_camera(left);
            }
        }
    }
}

/// The name, or if it's taken, the name with the first free number.
fn free(figure: &crate::figure::Figure, name: &str) -> String {
    if figure.may_name_camera(name, None) {
        return name.to_owned();
    }
    (2..).map(|i| format!("{name} {i}")).find(|name| figure.may_name_camera(name, None)).unwrap_or_default()
}
