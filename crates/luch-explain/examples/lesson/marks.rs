//! Rings with numbers on a picture.

/// Digits 1 to 3, five dots wide.
const DIGITS: [[u8; 7]; 3] = [
    [0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110],
    [0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111],
    [0b01110, 0b10001, 0b00001, 0b00110, 0b00001, 0b10001, 0b01110],
];
const RADIUS: f32 = 9.0;
/// Pixels of a dot's side.
const DOT: i32 = 2;

/// Draws a white ring with a dark rim around a place, and the number beside it.
pub(crate) fn mark(bytes: &mut [u8], size: [u32; 2], [x, y]: [u32; 2], number: usize) {
    let (x, y) = (i32::try_from(x).unwrap_or(0), i32::try_from(y).unwrap_or(0));
    for (width, color) in [(3.0, 0), (1.2, 255)] {
        for dy in -14..=14_i32 {
            for dx in -14..=14_i32 {
                #[allow(clippy::cast_precision_loss, reason = "a few pixels")]
                let away = ((dx * dx + dy * dy) as f32).sqrt() - RADIUS;
                if away.abs() <= width {
                    set(bytes, size, [x + dx, y + dy], color);
                }
            }
        }
        let grow = i32::from(color == 0);
        for (row, bits) in (0..).zip(DIGITS[number - 1]) {
            for column in (0..5).filter(|column| bits >> (4 - column) & 1 != 0) {
                for dy in -grow..DOT + grow {
                    for dx in -grow..DOT + grow {
                        set(bytes, size, [x + 16 + column * DOT + dx, y - 7 + row * DOT + dy], color);
                    }
                }
            }
        }
    }
}

fn set(bytes: &mut [u8], [width, height]: [u32; 2], [x, y]: [i32; 2], value: u8) {
    if let (Ok(x), Ok(y)) = (u32::try_from(x), u32::try_from(y))
        && x < width
        && y < height
    {
        let at = (y * width + x) as usize * 3;
        bytes[at..at + 3].fill(value);
    }
}
