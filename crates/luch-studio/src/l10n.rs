//! The texts of the window in English and Russian. The functions are generated from `locales/` by `build.rs`.

mod generated {
    #![allow(
        clippy::all,
        clippy::allow_attributes_without_reason,
        missing_docs,
        unreachable_pub,
        dead_code,
        reason = "generated code"
    )]
    include!(concat!(env!("OUT_DIR"), "/l10n.rs"));
}

pub(crate) use generated::L10n as Language;
pub(crate) use generated::L10nLanguage as Texts;

/// The language of the system, if the window speaks it, else English.
pub(crate) fn system_language() -> Language {
    sys_locale::get_locales().find_map(|tag| of_tag(&tag)).unwrap_or(Language::En)
}

/// The language of a tag like `ru-RU` or `en`.
pub(crate) fn of_tag(tag: &str) -> Option<Language> {
    match tag.split(['-', '_', '.']).next().unwrap_or_default().to_ascii_lowercase().as_str() {
        "ru" => Some(Language::Ru),
        "en" => Some(Language::En),
        _ => None,
    }
}

/// The tag of a language, as [`of_tag`] reads it.
pub(crate) const fn tag(language: Language) -> &'static str {
    match language {
        Language::En => "en",
        Language::Ru => "ru",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_are_read_back_and_unknown_ones_are_not() {
        for &language in Language::iter() {
            assert_eq!(of_tag(tag(language)).map(tag), Some(tag(language)));
        }
        assert_eq!(of_tag("ru_RU.UTF-8").map(tag), Some("ru"));
        assert!(of_tag("de-DE").is_none());
        assert!(of_tag("").is_none());
    }
}
