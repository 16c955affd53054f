//! The texts of the window, for tests: a better word in the program breaks none of them.

/// English.
pub(crate) mod en {
    use camera_lab_words::learn::{exercise_window, lessons};
    use camera_lab_words::why::{
        conventions, dialects, explain, explain_point, homogeneous, numerics, order, stages, this_figure,
    };
    use camera_lab_words::window::{canvas, coach, compare, gallery, labels, scenes};
    use camera_lab_words::{Lang, families, window};

    pub(crate) const CANVAS: &canvas::Texts = canvas::texts(Lang::En);
    pub(crate) const COACH: &coach::Texts = coach::texts(Lang::En);
    pub(crate) const COMPARE: &compare::Texts = compare::texts(Lang::En);
    pub(crate) const CONVENTIONS: &conventions::Texts = conventions::texts(Lang::En);
    pub(crate) const DIALECTS: &dialects::Texts = dialects::texts(Lang::En);
    pub(crate) const EXERCISE_WINDOW: &exercise_window::Texts = exercise_window::texts(Lang::En);
    pub(crate) const EXPLAIN: &explain::Texts = explain::texts(Lang::En);
    pub(crate) const EXPLAIN_POINT: &explain_point::Texts = explain_point::texts(Lang::En);
    pub(crate) const FAMILIES: &families::Texts = families::texts(Lang::En);
    pub(crate) const GALLERY: &gallery::Texts = gallery::texts(Lang::En);
    pub(crate) const HOMOGENEOUS: &homogeneous::Texts = homogeneous::texts(Lang::En);
    pub(crate) const LABELS: &labels::Texts = labels::texts(Lang::En);
    pub(crate) const LESSONS: &lessons::Texts = lessons::texts(Lang::En);
    pub(crate) const NUMERICS: &numerics::Texts = numerics::texts(Lang::En);
    pub(crate) const ORDER: &order::Texts = order::texts(Lang::En);
    pub(crate) const SCENES: &scenes::Texts = scenes::texts(Lang::En);
    pub(crate) const STAGES: &stages::Texts = stages::texts(Lang::En);
    pub(crate) const THIS_FIGURE: &this_figure::Texts = this_figure::texts(Lang::En);
    pub(crate) const WINDOW: &window::Texts = window::texts(Lang::En);
}

/// Brazilian Portuguese.
pub(crate) mod pt {
    use camera_lab_words::why::{conventions, dialects, numerics};
    use camera_lab_words::window::{canvas, compare, gallery, scenes};
    use camera_lab_words::{Lang, window};

    pub(crate) const CANVAS: &canvas::Texts = canvas::texts(Lang::PtBr);
    pub(crate) const COMPARE: &compare::Texts = compare::texts(Lang::PtBr);
    pub(crate) const CONVENTIONS: &conventions::Texts = conventions::texts(Lang::PtBr);
    pub(crate) const DIALECTS: &dialects::Texts = dialects::texts(Lang::PtBr);
    pub(crate) const GALLERY: &gallery::Texts = gallery::texts(Lang::PtBr);
    pub(crate) const NUMERICS: &numerics::Texts = numerics::texts(Lang::PtBr);
    pub(crate) const SCENES: &scenes::Texts = scenes::texts(Lang::PtBr);
    pub(crate) const WINDOW: &window::Texts = window::texts(Lang::PtBr);
}
