//! `[reveal] single_precision`: the image of a pipeline in f32 beside the right one.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::figure::read;
use camera_lab::raster::Rasterizer;
use tiny_skia::Pixmap;

use crate::views::Pictured;

/// The image of a cone at this distance along x from the origin, and of a camera that goes with it.
fn image(at: f64, single: bool) -> Pixmap {
    let text = format!(
        "[camera]\nposition = [{}, 3.0, 6.0]\nfocal_point = [{}, 0.5, 0.0]\nview_angle = 36.0\nnear = 3.5\nfar = 12.0\n\
         [scene]\npreset = \"empty\"\n[[scene.objects]]\nname = \"cone\"\nshape = \"cone\"\n\
         translate = [{}, -1.0, 0.0]\n[reveal]\nsingle_precision = {single}\n",
        at + 4.0,
        at + 1.0,
        at + 1.25,
    );
    let figure = read::parse(&text).unwrap();
    assert_eq!(figure.reveal.single_precision, single);
    Rasterizer::default().paint(&Pictured::of(figure).image()).unwrap()
}

/// Pixels whose colours differ by more than rounding.
fn different(a: &Pixmap, b: &Pixmap) -> usize {
    let far = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 24);
    a.data().chunks(4).zip(b.data().chunks(4)).filter(|pair| far(*pair)).count()
}

#[test]
fn single_precision_is_enough_near_the_origin_and_breaks_a_million_units_away() {
    let near = different(&image(0.0, false), &image(0.0, true));
    let far = different(&image(1e6, false), &image(1e6, true));
    assert!(near < 5, "{near} pixels differ near the origin");
    assert!(far > 200, "{far} pixels differ a million units away");
    // In f64 the same picture comes out at both places.
    assert!(different(&image(0.0, false), &image(1e6, false)) < 50);
}
