//! Whatever follows in a lesson file, it is a lesson or a fault with its line; its texts have the numbers of its
//! figures.
#![no_main]

use camera_lab::i18n::{Lang, lessons as words};
use camera_lab::lessons::parse;
use libfuzzer_sys::fuzz_target;

/// A step, which whatever comes goes on.
const HEAD: &str = "id = \"a\"\ntitle = \"A\"\n[[step]]\ntitle = \"B\"\ntext = \"{basis.u} $n$\"\n";

fuzz_target!(|bytes: &[u8]| {
    let text = format!("{HEAD}{}", String::from_utf8_lossy(bytes));
    match parse(&text) {
        Ok(lesson) => assert!([Lang::En, Lang::PtBr].iter().all(|lang| !words::to_read(*lang, &lesson).is_empty())),
        Err(error) => assert!(error.line >= 1 && error.line <= text.lines().count() + 1, "{error}"),
    }
});
