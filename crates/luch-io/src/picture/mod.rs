//! Pictures: PNG for people and screens, EXR for what comes after. Each file says which scene and settings made it.

mod exr;
mod hash;
mod metadata;
mod png;
mod settings;

pub use exr::write_exr;
pub use hash::linear_hash;
pub use metadata::Metadata;
pub use png::{Pixels, encode_png, write_png};
pub use settings::PictureSettings;

use crate::atomic_save::STDOUT;
use crate::error::{Error, ErrorKind, Result};
use std::path::Path;

/// The formats that pictures are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFormat {
    /// sRGB in 8 or 16 bits.
    Png,
    /// Linear light in 32-bit floats.
    Exr,
}

impl PictureFormat {
    /// The format of a path's extension, in capital or small letters; the standard output (`-`) gets a PNG.
    ///
    /// # Errors
    /// `Output` for another extension or none. A program may treat it as wrong usage: nothing was tried yet.
    pub fn of(path: &Path) -> Result<Self> {
        if path.as_os_str() == STDOUT {
            return Ok(Self::Png);
        }
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        let text = match extension.as_deref() {
            Some("png") => return Ok(Self::Png),
            Some("exr") => return Ok(Self::Exr),
            Some(other) => format!("pictures are not written as .{other}"),
            None => "has no extension that tells the format".to_owned(),
        };
        let example = path.with_extension("png");
        Err(Error::new(ErrorKind::Output, path, text).hint(format!("use .png or .exr: {}", example.display())))
    }
}

/// Checks that there are as many values as a picture of that size has.
fn check_length(path: &Path, [width, height]: [u32; 2], values: usize) -> Result<()> {
    let expected = u64::from(width).saturating_mul(u64::from(height)).saturating_mul(3);
    let refused = |text| Err(Error::new(ErrorKind::Output, path, text));
    if expected == 0 {
        return refused(format!("a picture of {width} x {height} pixels has nothing to write"));
    }
    if u64::try_from(values) != Ok(expected) {
        return refused(format!("{values} values do not make a picture of {width} x {height} pixels of 3"));
    }
    Ok(())
}
