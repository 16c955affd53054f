//! The arguments of a package for a course platform, besides its lesson or exercises.

use std::path::PathBuf;

use clap::Args;

use crate::cli::Failure;
use camera_lab_words::Lang;
use camera_lab_words::learn::exercise_messages as said;

/// The page, the mark to pass, and the file to write.
#[derive(Debug, Args)]
pub(in crate::cli) struct PackedArgs {
    /// The page in one file, camera-lab.html, of this version
    #[arg(long, value_name = "PAGE.html")]
    pub(in crate::cli) page: PathBuf,
    /// Percentage of the questions, right at the first try, with which it's passed: 0 to 100
    #[arg(long, value_name = "PERCENT", default_value = "50", allow_hyphen_values = true)]
    pass: String,
    /// File to write: .zip
    #[arg(short, long, value_name = "OUT.zip")]
    pub(in crate::cli) output: PathBuf,
}

impl PackedArgs {
    pub(in crate::cli) fn pass(&self, lang: Lang) -> Result<f64, Failure> {
        let pass = self.pass.trim().trim_end_matches('%').parse().ok().filter(|pass| (0.0..=100.0).contains(pass));
        pass.ok_or_else(|| Failure::BadInput(said::pass(lang, &self.pass)))
    }
}
