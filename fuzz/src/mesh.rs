//! A mesh file gives parts whose numbers are finite and whose indices are in range, or an error.

use camera_lab::progress::{Progress, at_once};
use camera_lab::scene::import::import;
use camera_lab::scene::no_files;

macro_rules! formats {
    ($($name:ident)*) => {
        $(
            /// Files of one format.
            pub mod $name {
                /// Tries one input.
                pub fn run(bytes: &[u8]) {
                    super::read(concat!("m.", stringify!($name)), bytes);
                }
            }
        )*
    };
}

formats!(gltf obj ply stl);

fn read(path: &str, bytes: &[u8]) {
    let Ok(imported) = at_once(import(path, bytes, &mut no_files, &Progress::default())) else { return };
    for part in imported.parts {
        let points = part.mesh.positions.len();
        assert!(part.mesh.positions.iter().all(|p| p.is_finite()));
        assert!(part.mesh.triangles.iter().flatten().all(|&i| (i as usize) < points));
        assert!(part.uv.is_empty() || part.uv.len() == part.mesh.triangles.len());
        assert!(part.colors.is_empty() || part.colors.len() == points);
    }
}
