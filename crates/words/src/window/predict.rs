//! The words of *Predict first*: an operation asks about its effect beforehand.

use crate::Lang;

texts!("window/predict");

texts_with_values! {
    /// The question of an operation about a point.
    where_to(lang, operation: &str);

    /// The question of an operation about sizes.
    how_large(lang, operation: &str);

    /// The answer about a point: its pixel, and the distance `off` of the mark.
    landed(lang, place: [f64; 2], off: &str): (pixel = lang.mark().tuple(&place.map(f64::floor), 5), off);

    /// The answer about sizes beside the outcome, as the factor by which the objects grow.
    sizes(lang, said: &str, happened: &str, times: f64): (said, happened, times = lang.mark().number(times, 3));
}
