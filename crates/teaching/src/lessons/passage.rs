//! The way from the figure of one step to that of the next.

use std::sync::Arc;

use crate::camera::{Camera, CameraPath};
use crate::figure::{Figure, Observer, ShownStep};

/// The way from one figure to another: cameras on arcs about fixed points, observers likewise, and numbers that grow.
/// Anything without intermediate values (a style, an object) is as in the second figure from the start.
#[derive(Clone, Debug)]
pub struct Passage {
    from: Arc<Figure>,
    to: Arc<Figure>,
    camera: Option<CameraPath>,
}

impl Passage {
    /// The way between two figures. If no camera lies between theirs, that of the second is there at once.
    pub fn new(from: Arc<Figure>, to: Arc<Figure>) -> Self {
        let cameras = [&from, &to].map(|figure| Camera::new(&figure.camera));
        let camera = match &cameras {
            [Ok(a), Ok(b)] if a != b => CameraPath::new(a, b).ok(),
            _ => None,
        };
        Self { from, to, camera }
    }

    /// True if nothing moves on the way.
    pub fn is_at_once(&self) -> bool {
        self.camera.is_none() && self.shown_at(0.0) == *self.to
    }

    /// The figure after a share of the way, 0 … 1. Each of them can be drawn.
    ///
    /// *Guarantees*: at 1 it's the second figure.
    pub fn at(&self, share: f64) -> Figure {
        if share >= 1.0 {
            return (*self.to).clone();
        }
        let mut figure = self.shown_at(share);
        if let Some(camera) = self.camera.as_ref().and_then(|path| path.at(share).ok()) {
            figure.camera = *camera.parameters();
        }
        figure
    }

    /// The second figure with everything else that moves.
    fn shown_at(&self, share: f64) -> Figure {
        let (from, mut figure) = (&*self.from, (*self.to).clone());
        let observers = [
            (from.observers.world, &mut figure.observers.world),
            (from.observers.canonical, &mut figure.observers.canonical),
        ];
        for (from, to) in observers {
            if let (Some(from), Some(to)) = (from, to) {
                *to = observer(&from, to, share);
            }
        }
        if let (Some(from), Some(to)) = (from.show.painted, &mut figure.show.painted) {
            *to = between(from, *to, share);
        }
        if let (Some(ShownStep { way: of, at: Some(from) }), Some(ShownStep { way, at: Some(to) })) =
            (from.show.step, &mut figure.show.step)
            && of == *way
        {
            *to = between(from, *to, share);
        }
        figure
    }
}

/// From one observer to another: around the target, and nearer by equal factors.
fn observer(from: &Observer, to: &Observer, t: f64) -> Observer {
    // The shorter way round.
    let turn = |a: f64, b: f64| a + t * ((b - a + 180.0).rem_euclid(360.0) - 180.0);
    Observer {
        target: from.target.lerp(to.target, t),
        distance: from.distance * (to.distance / from.distance).powf(t),
        azimuth: turn(from.azimuth, to.azimuth).rem_euclid(360.0),
        elevation: between(from.elevation, to.elevation, t),
        roll: turn(from.roll, to.roll),
        parallel: if t < 0.5 { from.parallel } else { to.parallel },
    }
}

fn between(a: f64, b: f64, t: f64) -> f64 {
    a * (1.0 - t) + b * t
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::figure::read::parse;

    fn figure(text: &str) -> Arc<Figure> {
        Arc::new(parse(text).unwrap())
    }

    #[test]
    fn every_figure_on_the_way_can_be_drawn_and_the_last_is_the_second() {
        let a = figure("[camera]\nposition = [0, 0, 5]\nnear = 1\nfar = 9\n[show]\npainted = 0.0\n");
        let text = "[camera]\nposition = [5, 0, 0]\nnear = 2\nfar = 40\nview_angle = 60\n[show]\npainted = 1.0\n\
                    [style]\nshading = \"flat\"\n";
        let b = figure(text);
        let passage = Passage::new(a.clone(), b.clone());
        for step in 0..=20 {
            let share = f64::from(step) / 20.0;
            let on_the_way = passage.at(share);
            let camera = Camera::new(&on_the_way.camera).unwrap();
            assert!((camera.distance() - 5.0).abs() < 1e-9, "round PF, which stays");
            assert_eq!(on_the_way.style, b.style);
            assert!((on_the_way.show.painted.unwrap() - share).abs() < 1e-12);
        }
        assert_eq!(passage.at(0.0).camera, a.camera);
        assert_eq!(passage.at(1.0), *b);
    }

    #[test]
    fn an_observer_goes_the_shorter_way_round() {
        let observer = |azimuth: f64| format!("[observers.world]\ndistance = 8\nazimuth = {azimuth}\n");
        let passage = Passage::new(figure(&observer(350.0)), figure(&observer(20.0)));
        let azimuth = |share| passage.at(share).observers.world.unwrap().azimuth;
        assert!((azimuth(1.0 / 3.0) - 0.0).min(360.0 - azimuth(1.0 / 3.0)) < 1e-9);
        assert!(!passage.is_at_once());
    }

    #[test]
    fn a_passage_without_steps_in_between_is_immediate() {
        let passage = Passage::new(figure(""), figure("[style]\nshading = \"flat\"\n"));
        assert!(passage.is_at_once());
    }
}
