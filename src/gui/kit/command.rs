//! The commands of the window, by name. The table in `app` has the words, the keys and the work of each.

use crate::views::{Arrangement, View};
use camera_lab_desk::{ObserverChange, Tab};

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
    New Open Gallery Recent Save SaveAs SaveWithFiles Title Export ExportFamily Handout ExerciseSheet CopyLink QrCode Search Quit Undo Redo Reset
    CopyNumbers Language Theme ReduceMotion Presentation NextFigure PreviousFigure Pen
    Spot Freeze Blank ClearAnnotations ZoomIn ZoomOut ZoomReset ParametersPanel NumbersPanel ViewBack ViewForward
    Section Dimensions Compare KeepCamera SwapSides LinkOrbits Labels Pipeline Numerics Explain Exercises Lessons AddStep StepAgain
    StepText StepQuestion StepNotes WriteLesson LeaveLesson Help About;
    Tab(Tab) Show(View) Arrange(Option<Arrangement>) Observe(ObserverChange)
}
