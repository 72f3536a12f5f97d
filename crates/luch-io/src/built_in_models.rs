//! The models inside the program: the six chess pieces, as the files of assets/models.

/// A model inside the program.
#[derive(Debug)]
pub struct BuiltInModel {
    /// The path by which the built-in scenes name it: `../models/king.obj`.
    pub path: &'static str,
    /// The OBJ file.
    pub bytes: &'static [u8],
}

macro_rules! models {
    ($($name:literal),*) => {
        [$(BuiltInModel {
            path: concat!("../models/", $name, ".obj"),
            bytes: include_bytes!(concat!("../../../assets/models/", $name, ".obj")),
        }),*]
    };
}

/// All of them.
pub static BUILT_IN_MODELS: [BuiltInModel; 6] = models!["king", "queen", "rook", "bishop", "knight", "pawn"];

/// The model that a scene means by exactly this path.
#[must_use]
pub fn find(path: &str) -> Option<&'static BuiltInModel> {
    BUILT_IN_MODELS.iter().find(|model| model.path == path)
}
