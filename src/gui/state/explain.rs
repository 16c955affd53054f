//! What the side of explanations shows.

/// A tab of the side of explanations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ExplainTab {
    /// Each entry of each matrix, as formula and as number.
    #[default]
    Matrices,
}

/// The side of explanations. Whether it is shown is said by [`Panels`](super::Panels).
#[derive(Clone, Debug, Default)]
pub struct Explain {
    /// The tab that is shown.
    pub tab: ExplainTab,
}
