//! The command lines, as docs/functional-tests.md shows them.

/// Test `n` is command `n - 1`. Each writes `NN.png`.
pub(crate) const COMMANDS: [&str; 14] = [
    "luch render two-spheres -o 01.png",
    "luch render chess -o 02.png",
    "luch render knight -o 03.png",
    "luch render two-spheres -o 04.png --camera 2",
    "luch render two-spheres -o 05.png --camera 3",
    "luch render chess -o 06.png --camera 2",
    "luch render two-spheres -o 07.png --camera 3 --fov 90",
    "luch render knight -o 08.png --camera 3 --set 'Knight.color=#ffff00'",
    "luch render knight -o 09.png --camera 2 --set 'Cube.reflection=95%'",
    "luch render two-spheres -o 10.png --light-intensity 80",
    "luch render two-spheres -o 11.png --camera 2 --antialiasing 64",
    "luch render knight -o 12.png --depth-of-field 64 --focal-distance 4",
    "luch render two-spheres -o 13.png --set 'Left sphere.gloss=0%' --set 'Left sphere.reflection=0%' \
     --set 'Right sphere.gloss=0%' --set 'Right sphere.reflection=0%'",
    "luch render two-spheres -o 14.png --set 'Left sphere.gloss=100%' --set 'Left sphere.reflection=20%' \
     --set 'Right sphere.gloss=100%' --set 'Right sphere.reflection=20%'",
];

/// The words of a line, as a shell splits them: at spaces, but not between single quotes.
pub(crate) fn words(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    for (place, part) in line.split('\'').enumerate() {
        let quoted = place % 2 == 1;
        for (k, piece) in if quoted { vec![part] } else { part.split(' ').collect() }.into_iter().enumerate() {
            if k > 0 {
                words.push(String::new());
            }
            words.last_mut().unwrap().push_str(piece);
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

#[test]
fn words_are_split_as_a_shell_does() {
    assert_eq!(words("a 'b c.d=1%' --e  f"), ["a", "b c.d=1%", "--e", "f"]);
}
