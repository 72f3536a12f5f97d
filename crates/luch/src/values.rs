//! The values of flags: text in, a number of the right range out, or a sentence that says what belongs there.

use luch_scene::{ImageSize, NonNegative, NumberError, RayCount};
use luch_study::plan;
use std::ops::RangeInclusive;

/// `--antialiasing` and `--depth-of-field`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rays {
    Off,
    On(RayCount),
}

/// `--crop`: a part of the picture, in pixels from its upper left corner. Neither side is 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Part {
    pub(crate) x: u32,
    pub(crate) y: u32,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// Numbers with commas between them, at least one, each once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct List(pub(crate) Vec<u64>);

/// `--pixel`, right or wrong for the picture: that only the scene can tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct PixelPlace {
    pub(crate) x: i64,
    pub(crate) y: i64,
}

/// `--sample`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shown {
    All,
    One(u32),
}

/// Reads a number as people write it; what is no number is refused, NaN and infinities are left to the ranges.
pub(crate) fn number(text: &str) -> Result<f64, String> {
    let text = text.trim();
    text.parse().map_err(|_| {
        if text.contains(',') {
            format!("\"{text}\" is not a number: decimals are written with a point, as in 0.5")
        } else {
            format!("\"{text}\" is not a number")
        }
    })
}

/// Reads a number of a range.
pub(crate) fn ranged<T: TryFrom<f64, Error = NumberError>>(text: &str) -> Result<T, String> {
    T::try_from(number(text)?).map_err(|e| e.to_string())
}

/// Reads a share: `0.5`, or `50%` of one.
pub(crate) fn share<T: TryFrom<f64, Error = NumberError>>(text: &str) -> Result<T, String> {
    match text.trim().strip_suffix('%') {
        Some(percent) => T::try_from(number(percent)? / 100.0).map_err(|e| e.to_string()),
        None => ranged(text).map_err(|refusal| {
            let meant = number(text).ok().filter(|v| *v > 1.0 && T::try_from(v / 100.0).is_ok());
            meant.map_or(refusal.clone(), |v| format!("{refusal}; for {v} percent write {v}%"))
        }),
    }
}

/// Reads `80` or `80%` as 0.8.
pub(crate) fn percent(text: &str) -> Result<NonNegative, String> {
    let value = number(text.trim().strip_suffix('%').unwrap_or(text))?;
    NonNegative::try_from(value / 100.0)
        .map_err(|_| format!("{value} is not a finite number of at least 0, in percent"))
}

/// Reads a whole number of a range, `what` being its unit.
pub(crate) fn whole(text: &str, range: RangeInclusive<u32>, what: &str) -> Result<u32, String> {
    let (low, high) = (range.start(), range.end());
    let expected = || format!("\"{}\" is not a number of {what} from {low} to {high}", text.trim());
    text.trim().parse().ok().filter(|n| range.contains(n)).ok_or_else(expected)
}

/// Reads a number of threads.
pub(crate) fn threads(text: &str) -> Result<u32, String> {
    whole(text, 1..=1024, "threads")
}

/// Reads a number of repeats.
pub(crate) fn repeats(text: &str) -> Result<u32, String> {
    whole(text, 1..=100_000, "repeats")
}

/// Reads a number of counted runs.
pub(crate) fn runs(text: &str) -> Result<u32, String> {
    whole(text, of(&plan::RUNS), "runs")
}

/// Reads a number of runs that are not counted.
pub(crate) fn warm_up(text: &str) -> Result<u32, String> {
    whole(text, of(&plan::WARM_UP), "warm-up runs")
}

/// Reads the rays per pixel of a reference.
pub(crate) fn reference(text: &str) -> Result<u32, String> {
    whole(text, of(&plan::RAYS), "rays per pixel")
}

/// Reads `1,2,4` as numbers of threads.
pub(crate) fn thread_counts(text: &str) -> Result<List, String> {
    list(text, &plan::THREADS, "threads")
}

/// Reads `1000,100000` as numbers of triangles.
pub(crate) fn triangle_counts(text: &str) -> Result<List, String> {
    list(text, &plan::TRIANGLES, "triangles")
}

/// Reads `1,16,256` as numbers of rays per pixel.
pub(crate) fn ray_counts(text: &str) -> Result<List, String> {
    list(text, &plan::RAYS, "rays per pixel")
}

/// Reads `16,32,64` as sides of tiles.
pub(crate) fn tile_sides(text: &str) -> Result<List, String> {
    list(text, &plan::TILES, "pixels")
}

/// Reads whole numbers of a range with commas between them, each once.
fn list(text: &str, range: &RangeInclusive<u64>, what: &str) -> Result<List, String> {
    if text.trim().is_empty() {
        return Err(format!("write numbers of {what} with commas between them, as in 8,16,32"));
    }
    let mut numbers = Vec::new();
    for part in text.split(',') {
        let number = u64::from(whole(part, of(range), what)?);
        if numbers.contains(&number) {
            return Err(format!("{number} is there twice"));
        }
        numbers.push(number);
    }
    Ok(List(numbers))
}

/// The range of a study's plan; its numbers are far below 2^32.
fn of(range: &RangeInclusive<u64>) -> RangeInclusive<u32> {
    let end = |n: u64| u32::try_from(n).unwrap_or(u32::MAX);
    end(*range.start())..=end(*range.end())
}

/// Reads a depth.
pub(crate) fn depth(text: &str) -> Result<u32, String> {
    whole(text, 0..=luch_scene::RenderSettings::MAX_DEPTH, "surfaces")
}

/// Reads `1920x1080`.
pub(crate) fn size(text: &str) -> Result<ImageSize, String> {
    let sides = text.split_once(['x', 'X', '×']).filter(|(w, h)| is_digits(w) && is_digits(h));
    let (width, height) = sides.ok_or("write the width and the height in pixels, as in 1920x1080")?;
    let side = |digits: &str| whole(digits, 1..=ImageSize::MAX_SIDE, "pixels");
    ImageSize::new(side(width)?, side(height)?).map_err(|e| e.to_string())
}

/// Reads `64` or `off`.
pub(crate) fn rays(text: &str) -> Result<Rays, String> {
    if text.trim() == "off" {
        return Ok(Rays::Off);
    }
    let count = whole(text, 1..=RayCount::MAX, "rays").map_err(|e| e + ", nor the word off")?;
    RayCount::new(count).map(Rays::On).map_err(|e| e.to_string())
}

/// Reads `X,Y,W,H`.
pub(crate) fn crop(text: &str) -> Result<Part, String> {
    let numbers: Result<Vec<u32>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[x, y, width, height]) if width > 0 && height > 0 => Ok(Part { x, y, width, height }),
        Ok([_, _, _, _]) => Err("the width and the height of a part are at least 1".to_owned()),
        _ => {
            Err("write the left edge, the top edge, the width and the height in pixels, as in 100,50,320,240"
                .to_owned())
        }
    }
}

/// Reads `X,Y`.
pub(crate) fn pixel(text: &str) -> Result<PixelPlace, String> {
    let place = text.split_once(',').and_then(|(x, y)| Some([x.trim().parse().ok()?, y.trim().parse().ok()?]));
    let [x, y] = place.ok_or("write the column and the row of the pixel, both from 0, as in 480,360")?;
    Ok(PixelPlace { x, y })
}

/// Reads `3` or `all`.
pub(crate) fn shown(text: &str) -> Result<Shown, String> {
    if text.trim() == "all" {
        return Ok(Shown::All);
    }
    let number = whole(text, 0..=RayCount::MAX - 1, "a sample");
    number.map(Shown::One).map_err(|e| e + ", nor the word all")
}

/// Reads an amount of memory: bytes, or with `K`, `M`, `G`, `T` (powers of 1024; `KiB` and `KB` are the same).
pub(crate) fn memory(text: &str) -> Result<u64, String> {
    let text = text.trim();
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let unit = text[digits.len()..].to_ascii_lowercase();
    let shift = match unit.strip_suffix("ib").or(unit.strip_suffix('b')).unwrap_or(&unit) {
        "" => Some(0),
        "k" => Some(10),
        "m" => Some(20),
        "g" => Some(30),
        "t" => Some(40),
        _ => None,
    };
    let amount = digits.trim().parse::<f64>().ok().filter(|n| *n > 0.0);
    let (Some(shift), Some(amount)) = (shift, amount) else {
        return Err("write an amount of memory such as 512M, 8G or 1.5GiB".to_owned());
    };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive, and saturating is right")]
    let bytes = (amount * (1_u64 << shift) as f64) as u64;
    Ok(bytes.max(1))
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{FieldOfView, Unit};

    #[test]
    fn sizes() {
        assert_eq!(size("16x9"), Ok(ImageSize::new(16, 9).unwrap()));
        assert_eq!(size("65535X1"), Ok(ImageSize::new(65_535, 1).unwrap()));
        for bad in [
            "",
            "x",
            "16",
            "16x",
            "x9",
            "0x9",
            "16x0",
            "16x9x3",
            "-1x9",
            "+1x9",
            "1.5x2",
            "65536x1",
            "9e3x1",
            "99999999999999x1",
        ] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn shares_and_percents() {
        assert_eq!(share::<Unit>("95%").unwrap().get(), 0.95);
        assert_eq!(share::<Unit>("0.95").unwrap().get(), 0.95);
        assert_eq!(share::<Unit>("95").unwrap_err(), "95 is not a number from 0 to 1; for 95 percent write 95%");
        assert_eq!(share::<Unit>("950").unwrap_err(), "950 is not a number from 0 to 1");
        assert_eq!(percent("80").unwrap().get(), 0.8);
        assert_eq!(percent("80%").unwrap().get(), 0.8);
        for bad in ["-1", "nan", "inf", "", "%", "1e99"] {
            assert!(percent(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn numbers_that_are_none() {
        assert!(ranged::<FieldOfView>("45,5").unwrap_err().contains("point"));
        for bad in ["", "nan", "inf", "1e400", "0x10", "ten", "180", "-3"] {
            assert!(ranged::<FieldOfView>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn amounts_of_memory() {
        assert_eq!(memory("512M"), Ok(512 << 20));
        assert_eq!(memory("1.5GiB"), Ok(3 << 29));
        assert_eq!(memory("8gb"), Ok(8 << 30));
        assert_eq!(memory("1000"), Ok(1000));
        for bad in ["", "0", "-1G", "G", "8X", "8 GG", "nan", "1..5G"] {
            assert!(memory(bad).is_err(), "{bad}");
        }
        assert_eq!(memory("1e30T"), Ok(u64::MAX));
    }

    #[test]
    fn parts_of_a_picture() {
        assert_eq!(crop("1,2,3,4"), Ok(Part { x: 1, y: 2, width: 3, height: 4 }));
        for bad in ["", "1,2,3", "1,2,3,4,5", "-1,2,3,4", "1,2,0,4", "1,2,3,0", "a,b,c,d", "99999999999,0,1,1"] {
            assert!(crop(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn lists_of_numbers() {
        assert_eq!(thread_counts("1,2, 64"), Ok(List(vec![1, 2, 64])));
        assert_eq!(triangle_counts("10000000"), Ok(List(vec![10_000_000])));
        for (bad, words) in [
            ("", "commas"),
            (" ", "commas"),
            ("1,2,", "\"\" is not a number of threads"),
            ("1,0", "\"0\" is not a number of threads from 1 to 1024"),
            ("100000", "\"100000\" is not a number of threads from 1 to 1024"),
            ("1;2", "\"1;2\""),
            ("-1", "\"-1\""),
            ("2,1,2", "2 is there twice"),
            ("1,,2", "\"\""),
        ] {
            assert!(thread_counts(bad).unwrap_err().contains(words), "{bad}");
        }
        assert!(
            runs("0").is_err() && warm_up("0").is_ok() && tile_sides("1025").is_err() && ray_counts("4097").is_err()
        );
    }

    #[test]
    fn places_of_pixels() {
        assert_eq!(pixel("480,360"), Ok(PixelPlace { x: 480, y: 360 }));
        assert_eq!(pixel(" -1 , 0 "), Ok(PixelPlace { x: -1, y: 0 }));
        for bad in ["", "1", "1,", ",1", "1,2,3", "1.5,2", "a,b", "1;2", "99999999999999999999,0"] {
            assert!(pixel(bad).unwrap_err().contains("480,360"), "{bad}");
        }
        assert_eq!((shown("all"), shown("63")), (Ok(Shown::All), Ok(Shown::One(63))));
        for bad in ["", "-1", "4096", "first"] {
            assert!(shown(bad).unwrap_err().contains("all"), "{bad}");
        }
    }

    #[test]
    fn rays_per_pixel() {
        assert_eq!(rays("off"), Ok(Rays::Off));
        assert_eq!(rays("4096"), Ok(Rays::On(RayCount::new(4096).unwrap())));
        for bad in ["0", "4097", "on", "-1", "", "1.5"] {
            assert!(rays(bad).unwrap_err().contains("off"), "{bad}");
        }
    }
}
