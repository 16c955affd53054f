//! The promises of the fuzz targets, on inputs that are the same every time: they need no nightly compiler, and a
//! failure stays one.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::path::Path;

#[path = "../../fuzz/src/lib.rs"]
#[expect(unreachable_pub, reason = "a library of its own for libFuzzer")]
mod promises;

/// Random inputs of a target, and changed copies of each of its seeds.
const RANDOM: usize = 400;
const COPIES: usize = 12;
const LONGEST: u64 = 700;

/// The generator `SplitMix64`.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `end`, which is not 0.
    fn below(&mut self, end: u64) -> usize {
        usize::try_from(self.next() % end).unwrap()
    }

    fn bytes(&mut self) -> Vec<u8> {
        (0..self.below(LONGEST)).map(|_| self.next().to_le_bytes()[0]).collect()
    }

    /// A copy with some bytes replaced, a stretch taken out, or another one put in twice.
    fn changed(&mut self, seed: &[u8]) -> Vec<u8> {
        let mut bytes = seed.to_vec();
        for _ in 0..=self.below(4) {
            let [a, b] = [0; 2].map(|_| self.below(bytes.len() as u64 + 1));
            let (from, to) = (a.min(b), a.max(b).min(a.min(b) + 64));
            match self.below(3) {
                0 => bytes.iter_mut().skip(from).take(2).for_each(|byte| *byte = self.next().to_le_bytes()[0]),
                1 => drop(bytes.drain(from..to)),
                _ => {
                    let stretch = bytes[from..to].to_vec();
                    bytes.splice(to..to, stretch);
                }
            }
        }
        bytes
    }
}

fn try_all(run: fn(&[u8]), seeds: &str) {
    let mut random = Random(20_261_121);
    for _ in 0..RANDOM {
        run(&random.bytes());
    }
    if seeds.is_empty() {
        return;
    }
    let mut files = files_below(&Path::new(env!("CARGO_MANIFEST_DIR")).join(seeds));
    files.sort();
    assert!(!files.is_empty(), "{seeds} has no files");
    for file in files {
        let seed = std::fs::read(&file).unwrap();
        run(&seed);
        for _ in 0..COPIES {
            run(&random.changed(&seed));
        }
    }
}

fn files_below(folder: &Path) -> Vec<std::path::PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

macro_rules! promises {
    ($($name:ident $seeds:literal;)*) => {
        $(
            #[test]
            fn $name() {
                try_all(promises::$name::run, $seeds);
            }
        )*
    };
}

promises! {
    answer "";
    clip "";
    draw "";
    exercise "";
    expression "";
    figure "assets/figures";
    gltf "";
    lesson "assets/lessons";
    link "";
    obj "assets/meshes";
    paper "";
    ply "fuzz/seeds/ply";
    png "";
    raster "";
    stl "fuzz/seeds/stl";
    texture "fuzz/seeds/texture";
}
