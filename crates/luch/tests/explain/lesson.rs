//! The lesson in docs/explain.md says what the program says.

use crate::support::Folder;
use std::collections::BTreeSet;

const PAGE: &str = include_str!("../../../../docs/explain.md");

/// A command of the page and the lines that it is said to print; `...` stands for any.
struct Quote {
    args: Vec<&'static str>,
    lines: Vec<&'static str>,
}

/// The indented blocks that begin with a command.
fn quotes() -> Vec<Quote> {
    let mut quotes: Vec<Quote> = Vec::new();
    let mut inside = false;
    for line in PAGE.lines() {
        let Some(code) = line.strip_prefix("    ") else {
            inside = false;
            continue;
        };
        if let Some(command) = code.strip_prefix("$ luch ") {
            quotes.push(Quote { args: command.split(' ').collect(), lines: Vec::new() });
            inside = true;
        } else if let Some(quote) = quotes.last_mut().filter(|_| inside) {
            quote.lines.push(code);
        }
    }
    quotes
}

#[test]
fn every_quoted_line_is_printed_in_that_order() {
    let folder = Folder::new();
    let quotes = quotes();
    assert!(quotes.len() >= 5, "the page shows {} commands", quotes.len());
    for Quote { args, lines } in quotes {
        let printed = folder.ok(&args).stdout;
        let mut rest = printed.lines();
        for line in lines.into_iter().filter(|line| *line != "...") {
            assert!(
                rest.any(|printed| printed == line),
                "`luch {}` does not print, in this place:\n{line}",
                args.join(" ")
            );
        }
    }
}

/// Numbers of a text with at least four decimals, which nobody makes up.
fn precise_numbers(text: &str) -> BTreeSet<String> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let words = text.split(|c: char| !is_part(c)).map(|word| word.trim_matches('.'));
    let precise = |word: &&str| word.split_once('.').is_some_and(|(_, decimals)| decimals.len() >= 4);
    words.filter(precise).map(str::to_owned).collect()
}

#[test]
fn every_number_of_the_prose_is_one_that_the_program_prints() {
    let folder = Folder::new();
    let mut printed = String::new();
    for quote in quotes() {
        printed += &folder.ok(&quote.args).stdout;
    }
    let (said, known) = (precise_numbers(PAGE), precise_numbers(&printed));
    let unknown: Vec<&String> = said.difference(&known).collect();
    assert!(unknown.is_empty(), "no command of the page prints {unknown:?}");
    assert!(said.len() > 40);
}

#[test]
fn the_pictures_of_the_page_are_there() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/");
    let mut shown = 0;
    for picture in PAGE.split("](explain/").skip(1).filter_map(|rest| rest.split(')').next()) {
        let bytes =
            std::fs::metadata(format!("{folder}explain/{picture}")).unwrap_or_else(|e| panic!("{picture}: {e}"));
        assert!(bytes.len() < 300_000, "{picture} has {} bytes", bytes.len());
        shown += 1;
    }
    assert!(shown >= 4);
}
