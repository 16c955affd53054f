//! Keys in the language of the window.

use eframe::egui::{Context, KeyboardShortcut};

use crate::views::{Arrangement, View};
use camera_lab_desk::{ObserverChange, Tab};
use camera_lab_words::{Grammar, Lang};

/// The Portuguese names of keys labelled with an English word.
const IN_PORTUGUESE: [(&str, &str); 10] = [
    ("Left", "Seta esquerda"),
    ("Right", "Seta direita"),
    ("Up", "Seta acima"),
    ("Down", "Seta abaixo"),
    ("Space", "Espaço"),
    ("Period", "Ponto"),
    ("Comma", "Vírgula"),
    ("Minus", "Menos"),
    ("Plus", "Mais"),
    ("Equals", "Igual"),
];

/// A combination of keys, for example Alt+Left, in Portuguese Alt+Seta esquerda.
pub(in crate::gui) fn written(ctx: &Context, keys: &KeyboardShortcut, lang: Lang) -> String {
    let name = ctx.format_shortcut(keys);
    if lang.grammar() != Grammar::Portuguese {
        return name;
    }
    let (before, key) = match name.rfind('+').filter(|at| at + 1 < name.len()) {
        Some(at) => name.split_at(at + 1),
        None => ("", name.as_str()),
    };
    let own = IN_PORTUGUESE.iter().find(|(english, _)| *english == key);
    own.map_or_else(|| name.clone(), |(_, own)| format!("{before}{own}"))
}

/// The enum of the commands, and the list of those without a value.
macro_rules! commands {
    ($($plain:ident)*; $($valued:ident($value:ty))*) => {
        /// A command of the user. `Arrange(None)` gives the pictures the arrangement that fits best.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[expect(missing_docs, reason = "what each does is said in its row, by its hint")]
        pub enum Command {
            $($plain,)*
            $($valued($value),)*
        }

        #[cfg(test)]
        pub(in crate::gui) const WITHOUT_VALUE: &[Command] = &[$(Command::$plain),*];
    };
}

commands! {
    New Open Gallery Recent Save SaveAs SaveWithFiles Title Export ExportFamily Handout ExerciseSheet StudentPage CoursePackage Class CopyLink QrCode Search Quit Undo Redo Aim FitImage Reset
    CopyNumbers Language Theme Contrast ReduceMotion Presentation NextFigure PreviousFigure Pen
    Spot Freeze Blank ClearAnnotations ZoomIn ZoomOut ZoomReset ParametersPanel NumbersPanel ViewBack ViewForward
    Section Dimensions Compare KeepCamera SwapSides LinkOrbits Labels Pipeline Numerics Explain Exercises Lessons AddStep StepAgain
    StepText StepQuestion StepNotes WriteLesson LeaveLesson Help About;
    Tab(Tab) Show(View) Arrange(Option<Arrangement>) Observe(ObserverChange)
}

#[cfg(test)]
mod tests {
    use eframe::egui::{Key, Modifiers};

    use super::*;

    #[test]
    fn keys_with_an_english_word_have_a_portuguese_name() {
        let ctx = Context::default();
        let of = |modifiers, key, lang| written(&ctx, &KeyboardShortcut::new(modifiers, key), lang);
        assert_eq!(of(Modifiers::ALT, Key::ArrowLeft, Lang::PtBr), "Alt+Seta esquerda");
        assert_eq!(of(Modifiers::NONE, Key::ArrowUp, Lang::PtBr), "Seta acima");
        assert_eq!(of(Modifiers::ALT, Key::G, Lang::PtBr), "Alt+G");
        for key in [Key::ArrowLeft, Key::Space, Key::Plus, Key::F11, Key::PageDown] {
            let english = of(Modifiers::ALT, key, Lang::En);
            assert_eq!(english, ctx.format_shortcut(&KeyboardShortcut::new(Modifiers::ALT, key)));
        }
    }
}
