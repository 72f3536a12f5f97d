//! What a person can do with an account.

/// A thing to do with the account of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ExplainCommand {
    /// Explain the pixel at this column and row.
    Pixel([u32; 2]),
    /// Explain the pixel so many columns and rows away from the one at hand.
    Step([i32; 2]),
    /// Show no account any more.
    Close,
    /// Look at a ray, by its place in the account.
    SelectRay(u32),
    /// Hide or show what a ray caused.
    Fold(u32, bool),
    /// Hide or show what all rays caused.
    FoldAll(bool),
    /// Show another side of the account.
    Show(Page),
    /// Write every digit of each number, or as many as a person reads.
    SetEveryDigit(bool),
    /// Draw the boxes of this level.
    SetLevel(u32),
    /// Draw the boxes of the levels above it, too.
    SetOuterLevels(bool),
    /// Put the account on the clipboard.
    Copy(Format),
}

/// How an account is written out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    Text,
    Markdown,
    Latex,
    Json,
}

impl Format {
    pub(crate) const ALL: [Self; 4] = [Self::Text, Self::Markdown, Self::Latex, Self::Json];
}

/// A side of the account, beside the tree of rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Page {
    /// The lighting sum with its numbers.
    #[default]
    Sum,
    /// The scene from above, with the rays.
    Top,
    /// The boxes that a ray goes into, and the shapes that it is tested against.
    Boxes,
}

impl Page {
    pub(crate) const ALL: [Self; 3] = [Self::Sum, Self::Top, Self::Boxes];
}
