//! Any file as the texture of an object: it has all its texels and levels of detail, or the object keeps its colour and
//! a notice says why.

use camera_lab::appearance::Style;
use camera_lab::scene::{MeshNotice, ObjectPaint, ObjectSpec, Preset, SceneSpec, Shape, TextureSource, build};

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let texture = Some(TextureSource::File("t.png".to_owned()));
    let cube = ObjectSpec { texture, ..ObjectSpec::new("cube", Shape::Box) };
    let spec = SceneSpec { preset: Preset::Empty, objects: vec![cube], ..SceneSpec::default() };
    let Ok(scene) = build(&spec, &Style::default(), &mut |_| Ok(bytes.to_vec())) else { panic!("a cube") };
    match (&scene.objects[0].paint, scene.notices.as_slice()) {
        (ObjectPaint::Texture(pictured), []) => {
            for level in pictured.image.levels() {
                assert_eq!(level.rgba.len(), 4 * level.width as usize * level.height as usize);
            }
            let last = pictured.image.levels().last().map(|level| (level.width, level.height));
            assert_eq!(last, Some((1, 1)));
        }
        (ObjectPaint::Solid(_), [(_, MeshNotice::Texture(_))]) => {}
        other => panic!("{other:?}"),
    }
}
