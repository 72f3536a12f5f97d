//! "Did you mean": the known word that is nearest to a mistyped one.

/// The nearest of the known words, if one is near enough to be meant.
///
/// Near enough is one slip for every three letters begun: `colr` finds `color`, `fong` finds `phong`, `xyz` nothing.
#[must_use]
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // No known word is longer; without this a file could make us measure megabytes against each key.
    const LONGEST: usize = 64;
    let word: Vec<char> = word.chars().take(LONGEST).flat_map(char::to_lowercase).collect();
    let reach = word.len().div_ceil(3).max(1);
    let slips = |k: &&str| slips(&word, &k.chars().flat_map(char::to_lowercase).collect::<Vec<_>>());
    // The first of equals: the order of `known` is the order of the documentation.
    known.into_iter().map(|k| (slips(&k), k)).filter(|&(n, _)| n <= reach).min_by_key(|&(n, _)| n).map(|(_, k)| k)
}

/// How many slips of the finger lie between two words: a letter too many, too few, a wrong one, or two swapped.
///
/// Optimal string alignment distance (Damerau, 1964), three rows of the table at a time.
fn slips(a: &[char], b: &[char]) -> usize {
    let mut before_last: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for (i, &ca) in a.iter().enumerate() {
        let mut row = vec![i.saturating_add(1)];
        for (j, &cb) in b.iter().enumerate() {
            let at = |row: &[usize], j: usize| row.get(j).copied().unwrap_or(usize::MAX);
            let replaced = at(&last, j).saturating_add(usize::from(ca != cb));
            let removed = at(&last, j.saturating_add(1)).saturating_add(1);
            let added = at(&row, j).saturating_add(1);
            let mut best = replaced.min(removed).min(added);
            let swapped = |k: Option<usize>, l: Option<usize>| {
                k.and_then(|k| a.get(k)) == Some(&cb) && l.and_then(|l| b.get(l)) == Some(&ca)
            };
            if swapped(i.checked_sub(1), j.checked_sub(1)) {
                best = best.min(at(&before_last, j.saturating_sub(1)).saturating_add(1));
            }
            row.push(best);
        }
        before_last = std::mem::replace(&mut last, row);
    }
    last.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_counted() {
        let count = |a: &str, b: &str| slips(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>());
        for (a, b, n) in [
            ("", "", 0),
            ("", "abc", 3),
            ("abc", "", 3),
            ("colr", "color", 1),
            ("centre", "center", 1),
            ("ab", "ba", 1),
        ] {
            assert_eq!(count(a, b), n, "{a} {b}");
        }
        assert_eq!(count("kitten", "sitting"), 3);
    }

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let known = ["name", "color", "center", "reflection"];
        assert_eq!(nearest("colr", known), Some("color"));
        assert_eq!(nearest("Colour", known), Some("color"));
        assert_eq!(nearest("reflexion", known), Some("reflection"));
        assert_eq!(nearest("xyz", known), None);
        assert_eq!(nearest("fong", ["flat", "gouraud", "phong"]), Some("phong"));
        assert_eq!(nearest("", known), None);
        assert_eq!(nearest(&"c".repeat(1 << 20), known), None);
    }
}
