//! The edited figure: the last possible one, the draft that may be impossible, its file, undo and redo.

pub mod source;

use std::collections::BTreeSet;
use std::mem::take;
use std::path::{Path, PathBuf};

use glam::DVec3;

use super::history::{History, Moment, Revision};
use super::message::Message;
use crate::camera::{Camera, CameraError, Convention, LensForm, Operation, Parameters, camera_repairs};
use crate::figure::{Figure, Labels, Observers, Screen, Show, update};
use crate::progress::Progress;
use crate::scene::{ObjectSpec, Preset, Shape};
use crate::views::scene_of;
use camera_lab_files::{
    Carried, FigureFiles, FileAccess, Renamed, ShippedFigure, SourceFile, carried_mesh, figure_from, rename, share,
};

/// The edited figure.
#[derive(Clone, Debug)]
pub struct Document {
    /// Identifies this document for good, even when it changes.
    id: Revision,
    figure: Figure,
    camera: Camera,
    draft: Parameters,
    problem: Option<CameraError>,
    path: Option<PathBuf>,
    /// The name of the built-in figure that it began as, while it has no file.
    shipped: Option<&'static str>,
    folder: Option<PathBuf>,
    reach: FileAccess,
    /// The files that came with the figure in a picture.
    carried: Carried,
    source: String,
    saved: Figure,
    /// The revision of the scene, and true if it differs from the saved one.
    revision: Revision,
    scene_is_changed: bool,
    /// The number of the document, apart from its observers and `[show]`, and that of the one of which the last step
    /// was made.
    version: Revision,
    committed: Option<Revision>,
    is_changed: bool,
    opened: Parameters,
    history: History,
    /// See [`Self::has_stand_in_camera`].
    stands_in: bool,
    /// True if kept operations have left the figure, until [`Self::take_operations_gone`].
    operations_gone: bool,
}

/// The viewpoints of a figure, its explanations, and the layout of the window.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// The viewpoints.
    pub observers: Observers,
    /// The explanations.
    pub show: Show,
    /// The layout.
    pub screen: Screen,
}

impl Seen {
    /// As the figure itself sets them.
    pub fn of(figure: &Figure) -> Self {
        Self { observers: figure.observers, show: figure.show.clone(), screen: figure.screen }
    }
}

/// The figure that a window begins with: the default scene, from a good viewpoint for it and its view volume.
pub fn fresh() -> Figure {
    Figure::of_preset(Preset::default())
}

impl Document {
    /// A document without changes.
    ///
    /// # Errors
    /// [`CameraError`] if the figure's camera is impossible.
    pub fn new(figure: Figure, file: Option<SourceFile>) -> Result<Self, CameraError> {
        let camera = Camera::new(&figure.camera)?;
        let folder = file.as_ref().and_then(|file| file.path.parent()).map(Path::to_owned);
        let reach = file.as_ref().map_or(FileAccess::Figure, |file| FileAccess::of(&file.path, file.is_picture, false));
        let (path, source, carried) = match file {
            // A picture holds a figure, but it isn't a figure file. Saving must not replace it.
            Some(SourceFile { text, is_picture: true, carried, .. }) => (None, text, carried),
            Some(SourceFile { path, text, is_picture: false, carried }) => (Some(path), text, carried),
            None => (None, String::new(), Carried::default()),
        };
        let revision = Revision::fresh();
        Ok(Self {
            id: Revision::fresh(),
            history: History::new(&figure, revision, &camera),
            revision,
            scene_is_changed: false,
            version: Revision::fresh(),
            committed: None,
            is_changed: false,
            camera,
            draft: figure.camera,
            problem: None,
            path,
            shipped: None,
            folder,
            reach,
            carried,
            source,
            saved: figure.clone(),
            opened: figure.camera,
            figure,
            stands_in: false,
            operations_gone: false,
        })
    }

    /// A built-in figure. `None` if there is none of this name. Saving asks for a file.
    pub fn shipped(name: &'static str) -> Option<Self> {
        let text = ShippedFigure::named(name)?.text().into_owned();
        let figure = figure_from(text.as_bytes()).ok()?.figure;
        // An empty path has no folder.
        let file = SourceFile { text, ..SourceFile::default() };
        let document = Self::new(figure, Some(file)).ok()?;
        Some(Self { path: None, shipped: Some(name), ..document })
    }

    /// A figure of a lesson, which looks for meshes in the folder of the lesson's file. Saving asks for a file.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn of_lesson(figure: Figure, lesson: Option<&Path>) -> Result<Self, CameraError> {
        let file = |path: &Path| SourceFile { path: path.to_owned(), ..SourceFile::default() };
        let (reach, carried) = (FileAccess::of_lesson(lesson, false), Carried::of_lesson(lesson));
        let lesson = lesson.filter(|path| share::link_of(path).is_none());
        Ok(Self { path: None, reach, carried, ..Self::new(figure, lesson.map(file))? })
    }

    /// A new figure in the folder of a mesh, whose scene is the mesh, seen whole from a corner.
    ///
    /// # Errors
    /// [`Message`] if it can't be read, or if no camera sees it.
    pub fn of_mesh(path: &Path) -> Result<Self, Box<Message>> {
        let impossible = |error| Message::NotOpened(path.to_owned(), error);
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let named = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut figure = Figure::of_preset(Preset::Empty);
        figure.scene.objects.push(ObjectSpec {
            segments: 32,
            outline: true,
            ..ObjectSpec::new(name, Shape::Mesh { path: named })
        });
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut files = FigureFiles::new(folder, FileAccess::of(path, true, false));
        let scene = scene_of(&figure, &mut |wanted| files.read(wanted), &Progress::default());
        let scene = scene.map_err(|error| Message::NoScene(path.to_owned(), error))?;
        if let Some((middle, points)) = scene.extent_of(&figure.scene, &BTreeSet::new()) {
            let size = points.iter().map(|p| p.distance(middle)).fold(f64::MIN_POSITIVE, f64::max);
            let position = middle + DVec3::new(3.0, 2.5, 4.0) * size;
            let far = Parameters { position, focal_point: middle, near: size, far: 12.0 * size, ..figure.camera };
            let fitted = Camera::new(&far).and_then(|camera| camera.fitted_to(&points)).map_err(impossible)?;
            figure.camera = *fitted.parameters();
        }
        let text = update("", &figure);
        let file = SourceFile { path: path.to_owned(), text, is_picture: true, carried: Carried::default() };
        Ok(Self::new(figure, Some(file)).map_err(impossible)?)
    }

    /// A figure whose camera may be impossible. Then it's drawn with the first repair of its camera, and the fields
    /// hold the numbers of the file, with the reason as [`Self::problem`].
    ///
    /// # Errors
    /// [`CameraError`] if neither a repair nor the default camera is possible.
    pub fn with_any_camera(figure: Figure, file: Option<SourceFile>) -> Result<Self, CameraError> {
        let draft = figure.camera;
        let Err(error) = Camera::new(&draft) else { return Self::new(figure, file) };
        let good = Camera::new(&Parameters::default())?;
        let repairs = camera_repairs(&error, &draft, &good);
        let camera = repairs.first().map_or(*good.parameters(), |(_, camera)| *camera);
        let mut document = Self::new(Figure { camera, ..figure }, file)?;
        document.set_parameters(draft);
        // The user hasn't changed the file's numbers yet, and none of ours may replace them without a request.
        document.saved.camera = draft;
        document.is_changed = false;
        document.stands_in = true;
        Ok(document)
    }

    /// The drawn figure. Its camera is always possible.
    pub fn figure(&self) -> &Figure {
        &self.figure
    }

    /// The camera of [`Self::figure`], with the rest beyond the `f64`s of its parameters. Pictures are drawn without
    /// it, see [`Camera::rounded`].
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// True if the camera only stands in for an impossible one of the file, whose numbers saving would replace.
    pub fn has_stand_in_camera(&self) -> bool {
        self.stands_in
    }

    /// The parameters as in the fields. They may be impossible.
    pub fn draft(&self) -> &Parameters {
        &self.draft
    }

    /// The reason why the draft isn't a camera.
    pub fn problem(&self) -> Option<&CameraError> {
        self.problem.as_ref()
    }

    /// Takes new camera parameters. Possible ones become the figure's. Otherwise the last good ones stay and
    /// [`Self::problem`] gives the reason.
    pub fn set_parameters(&mut self, parameters: Parameters) {
        if self.draft == parameters {
            return;
        }
        self.draft = parameters;
        match Camera::new(&parameters) {
            Ok(camera) => {
                self.figure.camera = parameters;
                self.camera = camera;
                self.problem = None;
                self.stands_in = false;
            }
            Err(error) => self.problem = Some(error),
        }
        self.note_change();
    }

    /// Notes the form in which θ was given.
    pub fn set_lens(&mut self, lens: LensForm) {
        self.figure.lens = Some(lens);
        self.note_change();
    }

    /// Changes anything but the camera. A change of `figure.camera` is ignored.
    pub fn edit(&mut self, change: impl FnOnce(&mut Figure)) {
        let camera = self.figure.camera;
        change(&mut self.figure);
        self.figure.camera = camera;
        self.has_scene(Revision::fresh());
    }

    /// Sets a part of the figure, but not its camera, if it differs.
    pub fn set<T: PartialEq>(&mut self, part: fn(&mut Figure) -> &mut T, value: T) {
        if *part(&mut self.figure) != value {
            self.edit(|figure| *part(figure) = value);
        }
    }

    /// Changes the author's labels. The scene stays the same.
    pub fn edit_labels(&mut self, change: impl FnOnce(&mut Labels)) {
        change(&mut self.figure.labels);
        self.note_change();
    }

    /// Changes the other cameras, and the name and color of the current one. The scene stays the same.
    pub fn edit_cameras(&mut self, change: impl FnOnce(&mut Figure)) {
        change(&mut self.figure);
        self.note_change();
    }

    /// Exchanges the camera and one of the others. Drops impossible parameters.
    pub fn look_through(&mut self, index: usize) {
        let other = self.figure.cameras.get(index).and_then(|other| Camera::new(&other.parameters).ok());
        if let Some(camera) = other {
            self.figure.look_through(index);
            self.set_camera(camera);
        }
    }

    /// Notes that the figure has this scene now.
    fn has_scene(&mut self, revision: Revision) {
        self.revision = revision;
        self.scene_is_changed = self.figure.scene != self.saved.scene;
        self.note_change();
    }

    /// Notes that the document has changed.
    fn note_change(&mut self) {
        self.version = Revision::fresh();
        self.is_changed = self.scene_is_changed || self.draft != self.saved.camera || self.differs_without_scene();
    }

    /// True if [`Figure::without_scene`] differs from that of the saved figure. A drag asks for every frame, so the
    /// parts that don't count are put aside instead of copying the rest.
    fn differs_without_scene(&mut self) -> bool {
        let put_aside =
            |figure: &mut Figure| (take(&mut figure.scene), take(&mut figure.observers), take(&mut figure.show));
        let aside = [&mut self.figure, &mut self.saved].map(put_aside);
        let differs = self.figure != self.saved;
        for (figure, parts) in [&mut self.figure, &mut self.saved].into_iter().zip(aside) {
            (figure.scene, figure.observers, figure.show) = parts;
        }
        differs
    }

    /// A number that this document keeps through every change, and that no other document has.
    pub fn id(&self) -> Revision {
        self.id
    }

    /// A number that identifies the document without comparing it, apart from its viewpoints and explanations.
    pub fn version(&self) -> Revision {
        self.version
    }

    /// A number that identifies the figure's scene without comparing it.
    pub fn revision(&self) -> Revision {
        self.revision
    }

    /// The observers: stored in the file, but neither a change of the figure nor an undo step.
    pub fn observers_mut(&mut self) -> &mut Observers {
        &mut self.figure.observers
    }

    /// `[show]`, which is saved in the file like the observers, and isn't a change of the figure. Choices in it (a
    /// stage, a triangle, a measure) are undo steps.
    pub fn show_mut(&mut self) -> &mut Show {
        &mut self.figure.show
    }

    fn restore(&mut self, moment: Option<Moment>) {
        let Some(Moment { figure, revision, camera, draft }) = moment else { return };
        (self.figure, self.draft) = (figure, draft);
        self.camera = camera;
        self.has_scene(revision);
        self.problem = Camera::new(&self.draft).err();
    }

    /// Makes an undo step of the changes since the last one. True if there are any.
    pub(super) fn commit(&mut self) -> bool {
        let is_another = self.committed.replace(self.version) != Some(self.version);
        if is_another && self.history.leads_elsewhere(&self.figure.show, &self.camera) {
            // They'd explain a move that the camera hasn't made.
            self.figure.show.operations.clear();
            self.operations_gone = true;
        }
        (is_another || self.history.shows_other(&self.figure.show))
            && self.history.commit((&self.figure, self.revision), &self.camera, &self.draft)
    }

    /// The present step of undo.
    pub const fn step(&self) -> Revision {
        self.history.step()
    }

    /// True once after kept operations have left the figure, because they don't lead to its camera.
    pub fn take_operations_gone(&mut self) -> bool {
        take(&mut self.operations_gone)
    }

    /// True if there is a step to undo (`back`), or to redo.
    pub fn can_undo(&self, back: bool) -> bool {
        self.history.can_undo(back)
    }

    /// Goes one step `back`, or forward.
    pub(super) fn undo(&mut self, back: bool) {
        self.commit();
        let moment = self.history.undo(&self.figure, back);
        self.restore(moment);
    }

    /// Takes another figure over, as one undo step.
    ///
    /// # Errors
    /// [`CameraError`] if the figure's camera is impossible. Nothing has changed then.
    pub fn replace(&mut self, figure: Figure) -> Result<(), CameraError> {
        let camera = Camera::new(&figure.camera)?;
        self.commit();
        self.draft = figure.camera;
        self.camera = camera;
        let before = std::mem::replace(&mut self.figure, figure);
        self.problem = None;
        self.has_scene(Revision::fresh());
        self.history.replace(before.show, (&self.figure, self.revision), &self.camera);
        Ok(())
    }

    /// A document without a file, which finds its files in the folder of this one.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub(super) fn beside(&self, figure: Figure) -> Result<Self, CameraError> {
        let (folder, carried) = (self.folder.clone(), self.carried.clone());
        Ok(Self { folder, carried, reach: self.reach, ..Self::new(figure, None)? })
    }

    /// Drops the steps to redo.
    pub(super) fn forget_future(&mut self) {
        self.history.forget_future();
    }

    /// The figure as opened or last saved.
    pub const fn saved(&self) -> &Figure {
        &self.saved
    }

    /// True if the camera differs from the one the figure was opened with.
    pub fn can_reset(&self) -> bool {
        self.draft != self.opened
    }

    /// Restores the camera from when the figure was opened.
    pub fn reset(&mut self) {
        self.set_parameters(self.opened);
    }

    /// Sets a camera, with the rest beyond the `f64`s of its parameters.
    pub fn set_camera(&mut self, camera: Camera) {
        self.draft = *camera.parameters();
        self.figure.camera = self.draft;
        self.camera = camera;
        self.problem = None;
        self.note_change();
    }

    /// Applies an operation to the camera.
    ///
    /// *Guarantees*: the camera retains the rest beyond the `f64`s of its parameters, so that errors don't add up. For
    /// example, twelve turns by 30° give it back bit for bit.
    ///
    /// # Errors
    /// [`CameraError`] if the operation has no result, or if the edited parameters aren't a camera. Nothing has changed
    /// then.
    pub fn operate(&mut self, operation: Operation, convention: Convention) -> Result<(), CameraError> {
        self.operate_from(&self.camera.clone(), operation, convention)
    }

    /// As [`Self::operate`], but applied to `start`, the camera before a slider was pulled.
    ///
    /// # Errors
    /// As for [`Self::operate`].
    pub fn operate_from(
        &mut self,
        start: &Camera,
        operation: Operation,
        convention: Convention,
    ) -> Result<(), CameraError> {
        if let Some(problem) = &self.problem {
            return Err(problem.clone());
        }
        let camera = operation.apply(start, convention)?;
        self.set_camera(camera);
        Ok(())
    }

    /// The name of the file, without its folder. For a built-in figure without a file, the name that it could have.
    pub fn name(&self) -> Option<String> {
        match (&self.path, self.shipped) {
            (Some(path), _) => Some(path.file_name()?.to_string_lossy().into_owned()),
            (None, shipped) => shipped.map(|name| format!("{name}.toml")),
        }
    }

    /// The name of the built-in figure that it began as, while it has no file.
    pub fn shipped_name(&self) -> Option<&'static str> {
        self.shipped
    }

    /// True if title and caption are those of the gallery's card that the figure was made from, and the figure is a
    /// different one by now. They don't describe it.
    pub fn has_words_of_card(&self) -> bool {
        let words = |figure: &Figure| (figure.title.clone(), figure.caption.clone());
        self.shipped.is_some() && self.is_changed && words(&self.figure) == words(&self.saved)
    }

    /// The file, once there is one.
    pub fn path(&self) -> Option<&PathBuf> {
        self.path.as_ref()
    }

    /// The folder of the figure's file, which paths of meshes are relative to.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// The files that the figure may name.
    pub fn reach(&self) -> FileAccess {
        self.reach
    }

    /// The files that came with the figure in a picture.
    pub fn carried(&self) -> &Carried {
        &self.carried
    }

    /// Reads the files that the figure names.
    pub fn files(&self) -> FigureFiles {
        FigureFiles::new(self.folder().unwrap_or(Path::new("")), self.reach).with(&self.carried)
    }

    /// Takes a mesh and the files that it names into a figure from a link, which finds no files. Returns the name of
    /// the mesh. `None` for other figures, and if the mesh can't be read or is too large.
    pub fn carry_mesh(&mut self, path: &Path) -> Option<String> {
        let (name, carried) = Some(path).filter(|_| self.reach == FileAccess::Link).and_then(carried_mesh)?;
        self.carried = self.carried.and(&carried);
        Some(name)
    }

    /// Lets the figure name any file of this machine, with the user's permission.
    pub fn allow_files(&mut self) {
        self.reach = FileAccess::Anywhere;
        self.note_change();
    }

    /// The text of the file as last read or written, with its comments. Empty without a file.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Records that `saved`, a state of this figure, is now in a file with this text. Its files have new names there,
    /// which all its other states get too.
    pub fn mark_saved(&mut self, path: PathBuf, source: String, saved: Figure, renamed: &Renamed) {
        rename(self.figure.files_mut(), renamed);
        self.history.rename(renamed);
        let (screen, folder) = (saved.screen, path.parent().map(Path::to_owned));
        if self.path.as_ref() != Some(&path) {
            // It's the user's own file now.
            self.reach = self.reach.max(FileAccess::Figure);
        }
        (self.figure.screen, self.folder, self.path, self.source) = (screen, folder, Some(path), source);
        // Viewpoints and explanations aren't changes.
        self.saved = Figure { show: self.figure.show.clone(), observers: self.figure.observers, ..saved };
        self.scene_is_changed = self.figure.scene != self.saved.scene;
        self.note_change();
    }

    /// Forgets the files that came with the figure, once they lie beside its file.
    pub fn forget_carried(&mut self) {
        self.carried = Carried::default();
    }

    /// Leaves the file alone from now on, so that saving asks for one.
    pub fn forget_file(&mut self) {
        self.path = None;
        self.note_change();
    }

    /// True if the explanation differs from the file's. The convention of NDC doesn't count, because it's the window's.
    pub fn explains_other(&self, show: &Show) -> bool {
        let own = |show: &Show| Show { ndc: None, ..show.clone() };
        own(show) != own(&self.saved.show)
    }

    /// True if closing would lose something. Observers and explanations don't count.
    pub fn is_changed(&self) -> bool {
        self.is_changed
    }

    /// True if the user has built something: the scene, points, labels, title or caption differ from the saved ones.
    /// The camera, the image and the way of drawing don't count, because users only try them.
    pub fn is_built_on(&self) -> bool {
        let built = |figure: &Figure| {
            let Figure { title, caption, points, labels, .. } = figure;
            (title.clone(), caption.clone(), points.clone(), labels.clone())
        };
        self.is_changed && (self.scene_is_changed || built(&self.figure) != built(&self.saved))
    }
}

#[cfg(test)]
mod tests;
