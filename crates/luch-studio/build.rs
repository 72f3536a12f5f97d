//! Turns `locales/<language>/*.ftl` into typed functions: a text that one language lacks does not compile.

use fluent_typed::{BuildOptions, FtlOutputOptions, build_from_locales_folder};
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let Ok(out) = std::env::var("OUT_DIR") else { return ExitCode::FAILURE };
    let file = |name: &str| Path::new(&out).join(name).display().to_string();
    let options = BuildOptions::default()
        .with_output_file_path(&file("l10n.rs"))
        .with_ftl_output(FtlOutputOptions::single_file(&file("translations.ftl")))
        .with_prefix("")
        .without_format()
        // The labels are searched for by screen readers and tests, which would stumble over the invisible marks.
        .without_bidi_isolation();
    build_from_locales_folder(options)
}
