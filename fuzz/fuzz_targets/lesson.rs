//! Whatever is in a lesson file, it is a lesson or a fault with its line; its texts have the numbers of its figures.
#![no_main]

use camera_lab::i18n::{Lang, lessons as words};
use camera_lab::lessons::parse_bytes;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(lesson) = parse_bytes(bytes) else { return };
    for lang in [Lang::En, Lang::PtBr] {
        assert!(!words::to_read(lang, &lesson).is_empty());
    }
});
