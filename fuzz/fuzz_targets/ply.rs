#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| camera_lab_fuzz::ply::run(bytes));
