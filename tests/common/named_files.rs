//! A figure with each kind of file: a mesh with its materials, a texture, a photograph.

use std::fs;
use std::path::Path;

/// The names of the files.
pub(crate) const NAMES: [&str; 4] = ["m.obj", "m.mtl", "t.png", "ph.png"];

/// Writes the files and the figure `figure.toml` into a folder. The figure has nothing to repair, and `diagnose`
/// writes it.
pub(crate) fn write(folder: &Path) {
    let image = |name: &str, color| {
        image::RgbImage::from_pixel(2, 2, image::Rgb(color)).save(folder.join(name)).expect("an image is written");
    };
    image("t.png", [0, 200, 0]);
    image("ph.png", [0, 0, 200]);
    let file = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file is written");
    file("m.obj", "mtllib m.mtl\nv -2 0 0\nv -1 0 0\nv -2 1 0\nusemtl red\nf 1 2 3\nf 1 3 2\n");
    file("m.mtl", "newmtl red\nKd 1 0 0\n");
    file(
        "figure.toml",
        "[image]\nwidth = 64\nheight = 48\nphotograph = \"ph.png\"\n[scene]\npreset = \"empty\"\n\
         [[scene.objects]]\nname = \"b\"\nshape = \"box\"\ntexture = \"t.png\"\n\
         [[scene.objects]]\nname = \"m\"\nshape = \"mesh\"\npath = \"m.obj\"\n",
    );
}
