//! No subcommand: the window.

use super::Failure;
use super::args::WindowArgs;
use crate::i18n::{Lang, command_line as texts};

#[cfg(feature = "gui")]
pub(super) fn run(args: &WindowArgs, lang: Lang) -> Result<(), Failure> {
    use crate::gui::{self, GuiError, Start};
    use crate::i18n::messages;

    let start = if let Some(path) = &args.figure {
        let (opened, _) = super::open(path, &args.common, lang)?;
        Start { figure: opened.figure, file: Some((path.clone(), opened.text)), lang }
    } else {
        let mut figure = gui::fresh();
        super::operate(&mut figure, &args.common.operations(lang)?, args.common.convention())
            .map_err(|error| Failure::BadInput(messages::inspect(lang, &error)))?;
        Start { figure, file: None, lang }
    };
    gui::run(start).map_err(|error| match error {
        GuiError::NoWindow(why) => Failure::Failed(texts::no_window(lang, &why)),
        GuiError::Camera(error) => Failure::BadInput(messages::camera(lang, &error)),
    })
}

#[cfg(not(feature = "gui"))]
pub(super) fn run(args: &WindowArgs, lang: Lang) -> Result<(), Failure> {
    if let Some(path) = &args.figure {
        super::open(path, &args.common, lang)?;
    }
    Err(Failure::Failed(texts::not_built_in(lang)))
}
