//! The view window becomes free, or symmetric again.

use crate::camera::{Camera, Parameters};

/// Frees the window without changing it.
pub(super) fn opened(parameters: &Parameters, good: &Camera) -> Parameters {
    let window = Camera::new(parameters).map_or_else(|_| good.window(), |camera| camera.window());
    Parameters { window: Some(window), ..*parameters }
}

/// Makes the window symmetric. Its size stays. If only the padlock has been used, θ, H and A stay to the last bit.
pub(super) fn closed(parameters: &Parameters) -> Parameters {
    let before = Parameters { window: None, ..*parameters };
    let Some(window) = parameters.window else { return before };
    if Camera::new(&before).is_ok_and(|camera| camera.window() == window) {
        return before;
    }
    let height = window.height();
    let angle = 2.0 * (height / 2.0 / parameters.near).atan().to_degrees();
    let after = Parameters { view_angle: angle, height, aspect: window.aspect(), ..before };
    if Camera::new(&after).is_ok() { after } else { before }
}
