//! The observer of a picture that the user hasn't turned. It stays in place, so that a moving camera is seen to move,
//! and goes back, once, if something would leave the picture.

use crate::camera::{Camera, Ndc};
use crate::figure::{Observer, Outside};
use crate::views::observer::Viewpoint;
use crate::views::{Request, SharedScene, Size};

/// Seconds in which an observer goes back.
const GLIDE: f64 = 0.35;
/// The distance that an observer goes back, relative to the one from which everything just fits, so that a motion in
/// the same direction stays in the picture for a while.
const SPARE: f64 = 1.15;
/// The number of remembered cameras.
const REMEMBERED: usize = 64;

/// The moment for which an observer is requested.
#[derive(Clone, Copy, Debug)]
pub(in crate::gui::views) struct Moment {
    /// Time in seconds.
    pub(in crate::gui::views) now: f64,
    /// True while some button of the pointer is down, or the camera is moving. A dragged point stays below the pointer.
    /// While a value is dragged the scale stays, so that the window is seen to grow and not the rest to shrink.
    pub(in crate::gui::views) on_the_way: bool,
    /// True if there are no gliding motions.
    pub(in crate::gui::views) still: bool,
    /// Files of the scene are still being read.
    pub(in crate::gui::views) loading: bool,
}

/// Settings that make a picture larger or smaller besides the camera and the scene: the displayed parts outside the
/// volume, and the convention of NDC.
type Extent = (Outside, Ndc);

/// The observer of a figure that doesn't set one.
#[derive(Debug, Default)]
pub(in crate::gui::views) struct Auto {
    kept: Option<KeptObserver>,
    /// Earlier subjects with their observers. If a camera comes back, as by undo, its observer does too.
    before: std::collections::VecDeque<(Subject, Observer)>,
}

/// The subject of a framing, besides the scene and the size of the picture.
#[derive(Clone, Debug, PartialEq)]
struct Subject {
    camera: Camera,
    extent: Extent,
    /// The camera, if it's another one, the convention of the other side of a comparison, and true if there are two
    /// halves.
    compared: Option<(Option<Camera>, Ndc, bool)>,
}

impl Subject {
    fn of(request: &Request) -> Self {
        let compared = request.shot.compared.as_ref();
        Self {
            camera: request.camera.clone(),
            extent: (request.shot.look.reveal.outside, request.shot.ndc),
            compared: compared.map(|other| (other.camera.clone(), other.shot.ndc, other.comparison.beside)),
        }
    }
}

/// An observer in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::gui::views) struct AutoObserver {
    pub(in crate::gui::views) observer: Observer,
    /// True if it begins to go back, because something would have left the picture.
    pub(in crate::gui::views) goes_back: bool,
    /// True while it's going back.
    pub(in crate::gui::views) glides: bool,
}

#[derive(Debug)]
struct KeptObserver {
    observer: Observer,
    framed: Subject,
    scene: SharedScene,
    subject: u64,
    /// True if it was framed before all files of the scene had been read.
    incomplete: bool,
    size: Size,
    /// True if the camera wasn't moving.
    settled: bool,
    /// The observer from which it glides, and the start time.
    glide: Option<(Observer, f64)>,
}

impl Auto {
    /// The observer for a picture. `None` for the image. It looks in the same direction until there is another
    /// `subject`, a scene unrelated to the last one.
    pub(in crate::gui::views) fn observer(
        &mut self,
        request: &Request,
        subject: u64,
        moment: Moment,
    ) -> Option<AutoObserver> {
        let framed = Subject::of(request);
        let is_same =
            |kept: &&mut KeptObserver| kept.subject == subject && (!kept.incomplete || kept.scene == request.scene);
        let Some(kept) = self.kept.as_mut().filter(is_same) else {
            let observer = request.observer_from(Viewpoint::default())?;
            self.before.clear();
            self.kept = Some(KeptObserver {
                observer,
                framed,
                scene: request.scene.clone(),
                subject,
                incomplete: moment.loading,
                size: request.size,
                settled: !moment.on_the_way,
                glide: None,
            });
            return Some(AutoObserver { observer, goes_back: false, glides: false });
        };
        // Gear and letters have sizes of their own, in pixels.
        let resized = kept.size != request.size;
        let changed = kept.framed != framed;
        if resized || kept.scene != request.scene {
            self.before.clear();
        } else if kept.settled && changed {
            self.before.truncate(REMEMBERED - 1);
            self.before.push_front((kept.framed.clone(), kept.observer));
        }
        let returns = (changed || !kept.settled) && !moment.on_the_way;
        let then = self.before.iter().find(|(before, _)| returns && *before == framed);
        // A dragged value has changed when it's released.
        let is_new = resized || changed || kept.scene != request.scene;
        // A pressed button starts no motion before something changes.
        kept.settled = !moment.on_the_way || kept.settled && !changed;
        let mut goes_back = false;
        if let Some((_, observer)) = then {
            (kept.observer, kept.glide) = (*observer, None);
        } else if is_new && (resized || !moment.on_the_way) {
            if resized {
                (kept.observer, kept.glide) = (request.fitted(&kept.observer)?, None);
            } else if !request.holds(&kept.observer) {
                let fitted = request.fitted(&kept.observer)?;
                let from = kept.seen(moment.now);
                kept.observer = Observer { distance: SPARE * fitted.distance, ..fitted };
                kept.glide = (!moment.still).then_some((from, moment.now));
                goes_back = true;
            }
        }
        if !moment.on_the_way {
            (kept.size, kept.framed) = (request.size, framed);
            kept.scene = request.scene.clone();
        }
        let observer = kept.seen(moment.now);
        Some(AutoObserver { observer, goes_back, glides: kept.glide.is_some() })
    }

    /// Fits again in the next frame.
    pub(in crate::gui::views) fn forget(&mut self) {
        self.kept = None;
        self.before.clear();
    }
}

impl KeptObserver {
    /// The observer at a time.
    fn seen(&mut self, now: f64) -> Observer {
        let Some((from, since)) = self.glide else { return self.observer };
        let share = (now - since) / GLIDE;
        if !(0.0..1.0).contains(&share) {
            self.glide = None;
            return self.observer;
        }
        // Slow at both ends.
        let share = share * share * (3.0 - 2.0 * share);
        Observer {
            target: from.target.lerp(self.observer.target, share),
            distance: from.distance + share * (self.observer.distance - from.distance),
            ..self.observer
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use glam::DVec3;

    use super::*;
    use crate::camera::{Convention, Operation, Parameters};
    use crate::figure::Figure;
    use crate::geometry::Angle;
    use crate::views::View;
    use camera_lab_words::Lang;
    use camera_lab_words::pictures::labels;

    /// A picture of a figure without a scene, and its visible content.
    struct Seen {
        figure: Figure,
        scene: SharedScene,
        auto: Auto,
    }

    impl Seen {
        fn new() -> Self {
            Self { figure: Figure::default(), scene: SharedScene::default(), auto: Auto::default() }
        }

        fn of(&mut self, camera: &Camera, width: u32, moment: Moment) -> AutoObserver {
            let size = Size { width, height: 300, scale: 1.0 };
            let request = Request::of(&self.figure, View::World, camera, &self.scene, labels(Lang::En), size);
            self.auto.observer(&request, 0, moment).unwrap()
        }
    }

    const FREE: Moment = Moment { now: 0.0, on_the_way: false, still: true, loading: false };
    const HELD: Moment = Moment { on_the_way: true, ..FREE };

    fn at(position: DVec3) -> Camera {
        Camera::new(&Parameters { position, far: 12.0, ..Figure::default().camera }).unwrap()
    }

    #[test]
    fn turning_the_camera_turns_no_observer_and_returning_restores_the_view() {
        let mut seen = Seen::new();
        let camera = Camera::new(&seen.figure.camera).unwrap();
        let turned = |degrees| {
            let by = Operation::Azimuth(Angle::from_degrees(degrees));
            by.apply(&camera, Convention::RightHand).unwrap()
        };
        let first = seen.of(&camera, 400, FREE).observer;
        for degrees in [0.0, 20.0, 45.0, 65.0] {
            assert_eq!(seen.of(&turned(degrees), 400, HELD).observer, first, "nothing moves in the hand");
        }
        let moved = seen.of(&turned(65.0), 400, FREE).observer;
        assert_eq!((moved.azimuth, moved.elevation), (first.azimuth, first.elevation), "nor when it is let go");
        assert_eq!(seen.of(&camera, 400, FREE).observer, first, "undone");
        assert_eq!(seen.of(&turned(65.0), 400, FREE).observer, moved, "done again");
    }

    #[test]
    fn a_camera_that_leaves_the_picture_is_followed_once_and_outwards() {
        let mut seen = Seen::new();
        let near = DVec3::new(3.0, 4.0, 5.0);
        let first = seen.of(&at(near), 400, FREE).observer;
        assert_eq!(seen.of(&at(near * 1.02), 400, FREE).observer, first);
        assert_eq!(seen.of(&at(near * 9.0), 400, HELD).observer, first, "it is in the hand");
        let later = seen.of(&at(near * 9.0), 400, FREE);
        assert!(later.goes_back && later.observer.distance > 2.0 * first.distance);
        assert_eq!((later.observer.azimuth, later.observer.elevation), (first.azimuth, first.elevation));
        let again = seen.of(&at(near * 9.0), 400, FREE);
        assert!(!again.goes_back && again.observer == later.observer);
        assert_eq!(seen.of(&at(near * 2.0), 400, FREE).observer, later.observer, "it does not come nearer by itself");
        let narrow = seen.of(&at(near * 2.0), 150, HELD).observer;
        assert_ne!(narrow, later.observer, "another shape is fitted at once");
        assert_eq!(narrow.azimuth, first.azimuth);
    }

    #[test]
    fn the_view_before_a_press_comes_back_with_its_camera() {
        let mut seen = Seen::new();
        let near = DVec3::new(3.0, 4.0, 5.0);
        let first = seen.of(&at(near), 400, FREE).observer;
        // Pressed, but not moved yet.
        for factor in [1.0, 1.0, 4.0, 9.0, 8.0] {
            seen.of(&at(near * factor), 400, HELD);
        }
        let later = seen.of(&at(near * 8.0), 400, FREE).observer;
        assert_ne!(later, first);
        assert_eq!(seen.of(&at(near), 400, FREE).observer, first, "undone");
        assert_eq!(seen.of(&at(near * 8.0), 400, FREE).observer, later, "done again");
    }

    #[test]
    fn the_scale_stays_while_a_value_is_dragged_and_the_view_is_fitted_on_release() {
        let mut seen = Seen::new();
        let near = DVec3::new(3.0, 4.0, 5.0);
        let free = Moment { still: false, ..FREE };
        let first = seen.of(&at(near), 400, free).observer;
        let held = seen.of(&at(near * 4.0), 400, Moment { still: false, ..HELD });
        assert!(!held.goes_back && held.observer == first);
        let begins = seen.of(&at(near * 4.0), 400, free);
        assert!(begins.goes_back && begins.glides && begins.observer == first);
        let half = seen.of(&at(near * 4.0), 400, Moment { now: GLIDE / 2.0, ..free });
        let end = seen.of(&at(near * 4.0), 400, Moment { now: GLIDE, ..free });
        assert!(half.glides && !half.goes_back && !end.glides);
        assert!(first.distance < half.observer.distance && half.observer.distance < end.observer.distance);
    }

    #[test]
    fn a_scene_that_arrives_late_is_framed_as_if_it_had_been_there() {
        let camera = at(DVec3::new(0.0, 2.0, 9.0));
        let figure = crate::figure::read::parse(
            "[[scene.objects]]\nname = \"far\"\nshape = \"box\"\ntranslate = [40, 0, 0]\nscale = [3, 3, 3]\n",
        )
        .unwrap();
        let scene = crate::scene::build(&figure.scene, &figure.style, &mut crate::scene::no_files).unwrap();
        let mut late = Seen::new();
        let early = late.of(&camera, 400, Moment { loading: true, ..FREE }).observer;
        late.scene = SharedScene::new(scene.clone());
        let mut there = Seen { scene: SharedScene::new(scene), ..Seen::new() };
        let expected = there.of(&camera, 400, FREE);
        assert_ne!(early, expected.observer);
        assert_eq!(late.of(&camera, 400, FREE), expected);
    }
}
