//! A picture that is begun: its triangles one after the other, in each order, until it is the whole one.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::appearance::{Shading, Visibility};
use camera_lab::camera::Camera;
use camera_lab::figure::{Depth, Figure};
use camera_lab::picture::{Pixels, Renderer};
use camera_lab::scene::Preset;
use camera_lab::views::{Finish, Request, SharedScene, Size, View, scene_of};
use camera_lab_words::{Lang, pictures::labels};

fn request(visibility: Visibility, depth: Depth) -> Request {
    let mut figure = Figure::default();
    figure.scene.preset = Preset::House;
    (figure.camera.near, figure.camera.far) = (2.0, 20.0);
    (figure.style.visibility, figure.style.shading, figure.reveal.depth) = (visibility, Shading::Flat, depth);
    let camera = Camera::new(&figure.camera).unwrap();
    let scene = scene_of(&figure, &mut |_| unreachable!("no meshes"), &Default::default()).unwrap();
    let size = Size { width: 160, height: 120, scale: 1.0 };
    let request = Request::of(&figure, View::Image, &camera, &SharedScene::new(scene), labels(Lang::En), size);
    // Without the legend, which says how many triangles there are.
    Request { finish: Finish { bare: true, ..Finish::default() }, ..request }
}

/// Pixels that are not the paper's.
fn painted(picture: &Pixels) -> usize {
    let paper: [u8; 4] = picture.rgba()[..4].try_into().unwrap();
    picture.rgba().chunks_exact(4).filter(|pixel| *pixel != paper).count()
}

#[test]
fn more_and_more_is_painted_in_every_order() {
    for visibility in [Visibility::Painter, Visibility::Bsp, Visibility::DepthBuffer] {
        for depth in [Depth::Off, Depth::Stored] {
            let mut renderer = Renderer::default();
            let mut at = |share| {
                painted(
                    &renderer
                        .pixels(&request(visibility, depth).with_shot(|shot| shot.show.painted = Some(share)))
                        .unwrap(),
                )
            };
            assert_eq!(at(0.0), 0, "{visibility:?} {depth:?}");
            let counts = [0.1, 0.3, 0.5, 0.8, 1.0].map(&mut at);
            assert!(counts.is_sorted() && counts[0] < counts[4], "{visibility:?} {depth:?}: {counts:?}");
            assert_eq!(at(7.0), counts[4]);
        }
    }
}

/// The whole of it has the colours of the usual picture, which has strokes besides.
#[test]
fn all_triangles_together_are_the_faces_of_the_picture() {
    for visibility in [Visibility::Bsp, Visibility::DepthBuffer] {
        let mut renderer = Renderer::default();
        let plain = request(visibility, Depth::Off);
        let begun = renderer.pixels(&plain.clone().with_shot(|shot| shot.show.painted = Some(1.0))).unwrap();
        let usual = renderer.pixels(&plain).unwrap();
        let same = begun.rgba().chunks_exact(4).zip(usual.rgba().chunks_exact(4)).filter(|(a, b)| a == b).count();
        assert!(same * 10 > 160 * 120 * 8, "{visibility:?}: {same} pixels are the same");
    }
}
