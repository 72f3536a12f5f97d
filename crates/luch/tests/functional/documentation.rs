//! The page of the fourteen tests shows what is tested here.

use crate::commands::COMMANDS;

#[test]
fn the_page_shows_the_commands_and_their_pictures() {
    let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");
    let page = std::fs::read_to_string(format!("{docs}/functional-tests.md")).unwrap();
    for (command, number) in COMMANDS.iter().zip(1..) {
        assert!(page.contains(&format!("`{command}`")), "{command}");
        let picture = format!("functional/{number:02}.png");
        assert!(page.contains(&format!("({picture})")), "{picture} is not shown");
        let bytes = std::fs::metadata(format!("{docs}/{picture}")).unwrap_or_else(|e| panic!("{picture}: {e}")).len();
        assert!(bytes < 150_000, "{picture} has {bytes} bytes");
    }
}
