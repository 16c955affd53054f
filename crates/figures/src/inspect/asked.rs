//! The quantities that open questions ask for. The window doesn't print them, nor what gives them away.

use super::quantity::{PointNumber, Quantity, RayNumber, ReportMatrix, WindowNumber};
use crate::camera::ParameterKey;
use crate::numbers::significant;

/// Digits that make a number telling: a shorter one is equal to others by chance.
const TELLING: usize = 3;

/// The quantities that open questions ask for, and the numbers of their answers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Asked {
    quantities: Vec<Quantity>,
    numbers: Vec<f64>,
    /// Numbers are asked for, be they telling or not.
    has_numbers: bool,
    /// The points of the answers. All coordinates of one together tell, however short they are.
    points: Vec<Vec<f64>>,
}

impl Asked {
    /// Adds quantities, and the numbers of an answer. Those with fewer than three digits, and those that the
    /// `statement` prints, tell nothing.
    pub fn add(&mut self, quantities: impl IntoIterator<Item = Quantity>, numbers: &[f64], statement: &str) {
        self.quantities.extend(quantities);
        self.has_numbers |= !numbers.is_empty();
        let printed: Vec<f64> = printed(statement).collect();
        let tells =
            |number: &f64| digits(*number) >= TELLING && !printed.iter().any(|given| looks_like(*given, *number));
        self.numbers.extend(numbers.iter().copied().filter(tells));
    }

    /// Adds points of an answer, with three coordinates or more each.
    pub fn add_points(&mut self, points: impl IntoIterator<Item = Vec<f64>>) {
        self.points.extend(points.into_iter().filter(|point| point.len() >= 3));
    }

    /// True if nothing is asked for. Otherwise a page that prints nearly every number would answer, however short the
    /// answer is.
    pub fn is_empty(&self) -> bool {
        self.quantities.is_empty() && !self.has_numbers
    }

    /// True if a text with these numbers would answer a question: those of an asked quantity, of one that gives it
    /// away, or with a number of the answer among them.
    pub fn hides(&self, quantities: &[Quantity], numbers: &[f64]) -> bool {
        let is_asked = |shown: &Quantity| self.quantities.iter().any(|asked| gives_away(*shown, *asked));
        let is_answer = |shown: &f64| self.numbers.iter().any(|asked| looks_like(*shown, *asked));
        let is_point = |asked: &Vec<f64>| {
            (3..=asked.len()).contains(&numbers.len()) && numbers.iter().zip(asked).all(|(a, b)| (a - b).abs() < 1e-6)
        };
        quantities.iter().any(is_asked) || numbers.iter().any(is_answer) || self.points.iter().any(is_point)
    }
}

/// The number of digits, without zeros at the ends.
fn digits(number: f64) -> usize {
    let text = significant(number, 6);
    let mantissa = text.split('e').next().unwrap_or_default();
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    digits.trim_matches('0').len()
}

/// True if both are printed alike, whatever the sign, because the opposite gives a number away.
fn looks_like(shown: f64, asked: f64) -> bool {
    (shown.abs() - asked.abs()).abs() <= 1e-3 * asked.abs()
}

/// The numbers in a text.
fn printed(text: &str) -> impl Iterator<Item = f64> {
    let words = text.split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | ',')));
    words.filter_map(|word| word.trim_matches(['.', ',']).replace(',', ".").parse().ok())
}

/// True if a quantity holds the asked one, or is one simple step away from it.
fn gives_away(shown: Quantity, asked: Quantity) -> bool {
    use Quantity::{Axis, Camera, CameraSide, Corner, Direction, Lens, Matrix, Plane, Point, Ray, Window};
    use ReportMatrix::{InverseProjection, InverseView, Projection, View, ViewProjection};
    let [shown, asked] = [shown, asked].map(as_one);
    shown == asked
        || match asked {
            Point(_, PointNumber::World) => false,
            Point(_, PointNumber::View) => matches!(shown, Point(_, number) if number != PointNumber::World),
            // Which pixel the pointer is on gives that of a point away, but it's needed for marking a place.
            Point(_, asked) => match shown {
                Point(_, number) => !matches!(number, PointNumber::World | PointNumber::View),
                Ray(_, RayNumber::Pixel) => asked != PointNumber::Inside,
                _ => false,
            },
            Camera(ParameterKey::Position) | Ray(_, RayNumber::Origin) => {
                let of_position =
                    matches!(shown, Camera(ParameterKey::Position) | Ray(_, RayNumber::Origin) | Corner(_));
                of_position || matches!(shown, Matrix(View | InverseView))
            }
            Axis(_) | Direction | Matrix(View | InverseView) => {
                let of_axes = matches!(shown, Axis(_) | Direction | Matrix(View | InverseView | ViewProjection));
                of_axes || matches!(shown, Ray(_, RayNumber::Direction) | Corner(_))
            }
            Matrix(_) => matches!(shown, Matrix(Projection | InverseProjection | ViewProjection)),
            Window(_) | CameraSide(_) | Lens(_) | Camera(_) => {
                matches!(
                    shown,
                    Lens(_) | Matrix(Projection | InverseProjection | ViewProjection) | Corner(_) | Plane(_)
                )
            }
            Ray(..) => matches!(shown, Ray(_, RayNumber::Origin | RayNumber::Direction)),
            Corner(_) | Plane(_) => matches!(shown, Corner(_) | Plane(_)),
            Quantity::Distance => false,
        }
}

/// One quantity for those that have several names, and for each point or ray.
fn as_one(quantity: Quantity) -> Quantity {
    match quantity {
        Quantity::Point(_, number) => Quantity::Point(0, number),
        Quantity::Ray(_, number) => Quantity::Ray(0, number),
        Quantity::Camera(ParameterKey::Height) => Quantity::Window(WindowNumber::Height),
        Quantity::Camera(ParameterKey::Aspect) => Quantity::Window(WindowNumber::Aspect),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inspect::quantity::BasisAxis;

    #[test]
    fn an_asked_quantity_is_hidden_with_what_gives_it_away() {
        let point = |number| Quantity::Point(3, number);
        let mut asked = Asked::default();
        assert!(asked.is_empty() && !asked.hides(&[point(PointNumber::Ndc)], &[0.125]));
        asked.add([Quantity::Point(0, PointNumber::Window)], &[], "");
        for shown in [PointNumber::Window, PointNumber::Ndc, PointNumber::Clip, PointNumber::Pixel] {
            assert!(asked.hides(&[point(shown)], &[]), "{shown:?}");
        }
        for shown in [PointNumber::World, PointNumber::View] {
            assert!(!asked.hides(&[point(shown)], &[]), "{shown:?}");
        }
        let mut asked = Asked::default();
        asked.add_points([vec![4.0, 15.0, 4.0, 1.0]]);
        assert!(asked.hides(&[], &[4.0, 15.0, 4.0]) && !asked.hides(&[], &[4.0, 15.0, 5.0]));
        let mut asked = Asked::default();
        asked.add([Quantity::Matrix(ReportMatrix::View)], &[], "");
        assert!(asked.hides(&[Quantity::Axis(BasisAxis::U)], &[]));
        assert!(!asked.hides(&[Quantity::Matrix(ReportMatrix::Projection)], &[]));
    }

    #[test]
    fn numbers_of_an_answer_tell_if_they_are_long_and_not_in_the_statement() {
        let mut asked = Asked::default();
        asked.add([], &[0.6157, 12.5, 0.5, 100.0], "The window is 12,5 wide, and θ = 45.");
        assert!(asked.hides(&[], &[1.0, -0.61570001]), "with any sign");
        for other in [12.5, 0.5, 100.0, 0.72] {
            assert!(!asked.hides(&[], &[other]), "{other}");
        }
        let mut short = Asked::default();
        short.add([], &[2.0], "");
        assert!(!short.is_empty() && !short.hides(&[], &[2.0]), "pages wait, single numbers don't");
    }
}
