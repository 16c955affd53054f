//! `[[cameras]]`: more cameras of a figure, each with a name and a color.

use super::Figure;
use crate::appearance::Rgba;
use crate::camera::{ImageSize, LensForm, Parameters, Pasted, RecoveryError, Stated, camera_names, recognise};
use crate::limits::{MAX_CAMERA_NAME, MAX_CAMERAS};
use crate::sanitize::is_obeyed;

/// `[camera] name` and `color`. They go with the camera when another one takes its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CameraTag {
    /// No other camera of the figure has it.
    pub name: Option<String>,
    /// The color of its parts in the world while another camera is the current one; `None` means the color of its
    /// place.
    pub color: Option<Rgba>,
}

/// A camera besides the current one.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedCamera {
    /// Not empty, and no other camera of the figure has it.
    pub name: String,
    /// The color of its parts in the world; `None` means the color of its place in the list.
    pub color: Option<Rgba>,
    /// The keys of `[camera]`, which make a possible camera.
    pub parameters: Parameters,
    /// As [`Figure::lens`].
    pub lens: Option<LensForm>,
}

impl NamedCamera {
    /// The form in which θ was given, unless the angle has changed since, or the aspect from which it followed.
    pub fn lens_in_force(&self) -> Option<LensForm> {
        self.lens.filter(|lens| lens.view_angle(self.parameters.aspect) == self.parameters.view_angle)
    }
}

impl Figure {
    /// True if a camera of the figure may have this name: it's one line, and no other camera has it. `own` is the place
    /// in the list of the camera to rename, if it's there.
    pub fn may_name_camera(&self, name: &str, own: Option<usize>) -> bool {
        let is_line = !name.trim().is_empty() && !name.contains(is_obeyed) && name.chars().count() <= MAX_CAMERA_NAME;
        let mut others = self.cameras.iter().enumerate().filter(|(i, _)| Some(*i) != own);
        is_line && self.tag.name.as_deref() != Some(name) && others.all(|(_, camera)| camera.name != name)
    }

    /// The first free name of C1, C2, C3 …
    pub fn free_camera_name(&self) -> String {
        (1..).map(|i| format!("C{i}")).find(|name| self.may_name_camera(name, None)).unwrap_or_default()
    }

    /// Adds a camera to the list, unless it's full.
    pub fn add_camera(&mut self, camera: NamedCamera) {
        if self.cameras.len() < MAX_CAMERAS {
            self.cameras.push(camera);
        }
    }

    /// The current camera as one of the list, under its name or under a free one.
    pub fn current_camera(&self) -> NamedCamera {
        NamedCamera {
            name: self.tag.name.clone().unwrap_or_else(|| self.free_camera_name()),
            color: self.tag.color,
            parameters: self.camera,
            lens: self.lens,
        }
    }

    /// Takes the cameras of a file: the first that can be read becomes the current one, and the others the list, as
    /// many as it holds. None of the old ones stays. Returns the cameras that weren't taken, with the reason; `None`
    /// means that the list is full. `size`: that of every image, if you state it.
    pub fn take_cameras(
        &mut self,
        cameras: &[Pasted],
        stated: &Stated,
        size: Option<ImageSize>,
    ) -> Vec<(String, Option<RecoveryError>)> {
        let names = camera_names(cameras);
        let mut left = Vec::new();
        let mut taken = Vec::new();
        for (camera, name) in cameras.iter().zip(names) {
            let stated = Stated { image: size.or(camera.image).unwrap_or(stated.image), ..*stated };
            match recognise(camera, &stated, &self.camera) {
                Ok(_) if taken.len() > MAX_CAMERAS => left.push((name, None)),
                Ok(found) => taken.push((name, found.best().found.parameters, stated.image)),
                Err(error) => left.push((name, Some(error))),
            }
        }
        let mut taken = taken.into_iter();
        let Some((name, parameters, image)) = taken.next() else { return left };
        (self.cameras, self.compare, self.lens) = (Vec::new(), None, None);
        self.tag = CameraTag::default();
        self.tag.name = Some(name).filter(|name| self.may_name_camera(name, None));
        (self.camera, self.image) = (parameters, image);
        for (name, parameters, _) in taken {
            let name = if self.may_name_camera(&name, None) { name } else { self.free_camera_name() };
            self.add_camera(NamedCamera { name, color: None, parameters, lens: None });
        }
        left
    }

    /// Exchanges the current camera and one of the list, with their names and colors.
    pub fn look_through(&mut self, index: usize) {
        let current = self.current_camera();
        let Some(place) = self.cameras.get_mut(index) else { return };
        let own = current.name.clone();
        let NamedCamera { name, color, parameters, lens } = std::mem::replace(place, current);
        self.compare_with(&name, Some(&own));
        self.tag = CameraTag { name: Some(name), color };
        (self.camera, self.lens) = (parameters, lens);
    }

    /// Gives a camera another name; `None` means the current one.
    pub fn rename_camera(&mut self, index: Option<usize>, name: &str) {
        let Some(index) = index else { return self.tag.name = Some(name.to_owned()) };
        let Some(camera) = self.cameras.get_mut(index) else { return };
        let old = std::mem::replace(&mut camera.name, name.to_owned());
        self.compare_with(&old, Some(name));
    }

    /// Removes a camera from the list.
    pub fn remove_camera(&mut self, index: usize) {
        if index < self.cameras.len() {
            let removed = self.cameras.remove(index);
            self.compare_with(&removed.name, None);
        }
    }

    /// A comparison with the camera `old` becomes one with `new`, or ends.
    fn compare_with(&mut self, old: &str, new: Option<&str>) {
        let compared = self.compare.as_mut().filter(|comparison| comparison.camera.as_deref() == Some(old));
        match (compared, new) {
            (Some(comparison), Some(new)) => comparison.camera = Some(new.to_owned()),
            (Some(_), None) => self.compare = None,
            (None, _) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use crate::camera::Projection;
    use crate::figure::read::{parse, parse_with_any_camera};
    use crate::figure::write::to_toml;
    use crate::figure::{Figure, update};

    const PAIR: &str = "[camera]\nname = \"left\"\nposition = [-1, 0, 5]\n[[cameras]]\nname = \"right\" # of two\n\
                        color = \"#00785a\"\nposition = [1, 0, 5]\nhorizontal_angle = 60\n[[cameras]]\nname = \"map\"\n\
                        projection = \"parallel\"\nheight = 8\nnear = -1\n";

    #[test]
    fn cameras_are_read_written_and_edited() {
        let figure = parse(PAIR).unwrap();
        let [right, map] = figure.cameras.as_slice() else { panic!("two cameras") };
        assert_eq!((right.name.as_str(), right.parameters.position.x), ("right", 1.0));
        assert_eq!(right.color.unwrap().to_string(), "#00785a");
        assert_eq!((map.parameters.projection, map.parameters.near), (Projection::Parallel, -1.0));
        assert_eq!(parse(&to_toml(&figure)).unwrap(), figure);
        let mut moved = figure.clone();
        moved.cameras[0].parameters.position.x = 2.0;
        let edited = update(PAIR, &moved);
        assert!(edited.contains("# of two") && edited.contains("horizontal_angle = 60\n"), "{edited}");
        assert_eq!(parse(&edited).unwrap(), moved);
        let none = Figure { cameras: Vec::new(), ..figure };
        assert!(!update(PAIR, &none).contains("[[cameras]]"));
    }

    #[test]
    fn looking_through_a_camera_and_back_changes_nothing() {
        let figure = parse(PAIR).unwrap();
        let mut other = figure.clone();
        other.look_through(0);
        assert_eq!((other.tag.name.as_deref(), other.camera), (Some("right"), figure.cameras[0].parameters));
        assert_eq!((other.cameras[0].name.as_str(), other.cameras[0].parameters), ("left", figure.camera));
        other.look_through(0);
        assert_eq!(other, figure);
    }

    #[test]
    fn a_comparison_follows_its_camera_and_ends_with_it() {
        let figure = parse(&format!("{PAIR}[compare]\ncamera = \"right\"\nlayout = \"beside\"\n")).unwrap();
        let compared = |figure: &Figure| figure.compare.as_ref().and_then(|comparison| comparison.camera.clone());
        assert_eq!(parse(&to_toml(&figure)).unwrap(), figure);
        let other = figure.compare.clone().unwrap().other_side(&figure).unwrap();
        assert_eq!(other.camera.unwrap().position().x, 1.0);
        let swapped = figure.compare.clone().unwrap().swapped(&figure).unwrap();
        assert_eq!((swapped.camera.position.x, compared(&swapped).as_deref()), (1.0, Some("left")));
        let mut renamed = figure.clone();
        renamed.rename_camera(Some(0), "other");
        assert_eq!(compared(&renamed).as_deref(), Some("other"));
        renamed.remove_camera(0);
        assert_eq!(renamed.compare, None);
        let error = parse("[compare]\ncamera = \"none\"\n").unwrap_err();
        assert_eq!((error.line, error.key.as_str()), (2, "[compare] camera"));
    }

    #[test]
    fn a_camera_without_a_name_gets_a_free_one_when_another_takes_its_place() {
        let mut figure = parse("[[cameras]]\nname = \"C1\"\n").unwrap();
        figure.look_through(0);
        assert_eq!((figure.tag.name.as_deref(), figure.cameras[0].name.as_str()), (Some("C1"), "C2"));
    }

    #[test]
    fn faults_name_the_list_and_its_key() {
        let many: String = (0..33).map(|i| format!("[[cameras]]\nname = \"{i}\"\n")).collect();
        for (text, line, key) in [
            ("[[cameras]]\nposition = [1, 0, 5]\n", 1, "[[cameras]] name"),
            ("[[cameras]]\nname = \"\"\n", 2, "[[cameras]] name"),
            ("[[cameras]]\nname = \"A\"\n[[cameras]]\nname = \"A\"\n", 4, "[[cameras]] name"),
            ("[camera]\nname = \"A\"\n[[cameras]]\nname = \"A\"\n", 4, "[[cameras]] name"),
            ("[[cameras]]\nname = \"A\"\nnear = 5\nfar = 2\n", 4, "[[cameras]] far"),
            ("[[cameras]]\nname = \"A\"\nneer = 5\n", 3, "[[cameras]] neer"),
            ("[[cameras]]\nname = \"A\"\nlens = { focal_length = 0 }\n", 3, "[[cameras]] lens.focal_length"),
            ("[[cameras]]\nname = \"A\"\nwindow = { left = 1 }\n", 3, "[[cameras]] window.right"),
            (many.as_str(), 65, "[[cameras]]"),
        ] {
            let error = parse(text).unwrap_err();
            assert_eq!((error.line, error.key.as_str()), (line, key), "{error}");
        }
        // The window only repairs an impossible [camera].
        assert!(parse_with_any_camera("[[cameras]]\nname = \"A\"\nnear = 5\nfar = 2\n").is_err());
    }
}
