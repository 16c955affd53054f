//! Earlier viewpoints of the pictures. The user can go back to the one before a turn, a move or a zoom, which isn't a
//! change of the figure and so isn't an undo step.

use crate::figure::Observers;

/// Number of stored viewpoints.
const MOST: usize = 100;
/// A view counts once it has been still this long, in seconds. The turns of a wheel are one step.
const STILL: f64 = 0.4;

/// The views before and after the present one.
#[derive(Debug, Default)]
pub struct ViewHistory {
    past: Vec<Observers>,
    future: Vec<Observers>,
    /// The view that counts now.
    now: Observers,
    /// The candidate for the next one, with its time (seconds).
    turning: Option<(Observers, f64)>,
}

impl ViewHistory {
    /// Starts again, with another figure.
    pub fn reset(&mut self, observers: Observers) {
        *self = Self { now: observers, ..Self::default() };
    }

    /// Notes the viewpoints of the pictures at a time (seconds). Returns the seconds until it has to be called again.
    pub fn follow(&mut self, observers: Observers, time: f64) -> Option<f64> {
        if observers == self.now {
            self.turning = None;
            return None;
        }
        match self.turning {
            Some((turning, since)) if turning == observers => {
                let left = since + STILL - time;
                if left <= 0.0 {
                    self.settle(observers);
                    return None;
                }
                Some(left)
            }
            _ => {
                self.turning = Some((observers, time));
                Some(STILL)
            }
        }
    }

    /// The same viewpoints in pictures of another size, which isn't a step.
    pub fn framed_again(&mut self, before: Observers, after: Observers) {
        if self.now == before {
            self.now = after;
        }
    }

    fn settle(&mut self, observers: Observers) {
        self.turning = None;
        if observers != self.now {
            self.past.push(std::mem::replace(&mut self.now, observers));
            self.past.drain(..self.past.len().saturating_sub(MOST));
            self.future.clear();
        }
    }

    /// True if there is a view before `observers`, or after them.
    pub fn can_go(&self, observers: Observers, back: bool) -> bool {
        let is_now = observers == self.now;
        if back { !self.past.is_empty() || !is_now } else { !self.future.is_empty() && is_now }
    }

    /// The view before `observers`, or after them.
    pub fn go(&mut self, observers: Observers, back: bool) -> Option<Observers> {
        self.settle(observers);
        let (from, to) = if back { (&mut self.past, &mut self.future) } else { (&mut self.future, &mut self.past) };
        let next = from.pop()?;
        to.push(std::mem::replace(&mut self.now, next));
        Some(next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Observer;

    fn turned(azimuth: f64) -> Observers {
        let target = glam::DVec3::ZERO;
        let world = Observer { target, distance: 10.0, azimuth, elevation: 20.0, roll: 0.0, parallel: false };
        Observers { world: Some(world), ..Observers::default() }
    }

    #[test]
    fn a_gesture_is_one_view_and_one_goes_back_and_forward_among_them() {
        let mut history = ViewHistory::default();
        for k in 0..10_u8 {
            assert!(history.follow(turned(f64::from(k)), 0.05 * f64::from(k)).is_some());
        }
        assert!(history.follow(turned(9.0), 0.6).is_some());
        assert_eq!(history.follow(turned(9.0), 0.9), None);
        // A view that hasn't come to rest counts when the user goes back from it.
        assert!(history.follow(turned(30.0), 1.0).is_some());
        assert_eq!(history.go(turned(30.0), true), Some(turned(9.0)));
        assert!(history.can_go(turned(9.0), true) && history.can_go(turned(9.0), false));
        assert_eq!(history.go(turned(9.0), true), Some(Observers::default()));
        assert_eq!(history.go(Observers::default(), true), None);
        assert_eq!(history.go(Observers::default(), false), Some(turned(9.0)));
        // Another turn ends the way forward.
        assert_eq!(history.go(turned(50.0), true), Some(turned(9.0)));
        assert_eq!(history.go(turned(9.0), false), Some(turned(50.0)));
        assert_eq!(history.go(turned(50.0), false), None);
    }
}
