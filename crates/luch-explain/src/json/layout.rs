//! How the JSON is laid out: as `serde_json` does it for people, but with the numbers of a list in one line, so that a
//! vector takes one line and not five.

use serde_json::ser::{CompactFormatter, Formatter};
use std::io;

/// The state of the layout.
#[derive(Debug, Default)]
pub(super) struct Layout {
    depth: usize,
    /// For each open list or object whether it has a line of its own for each entry; one without entries has none.
    tall: Vec<bool>,
    /// An entry of a list is about to be written; true for the first.
    pending: Option<bool>,
}

type Writer<'a, W> = &'a mut W;

impl Layout {
    fn line<W: ?Sized + io::Write>(&self, to: Writer<'_, W>) -> io::Result<()> {
        to.write_all(b"\n")?;
        (0..self.depth).try_for_each(|_| to.write_all(b"  "))
    }

    /// What stands before something that fits in a line.
    fn small<W: ?Sized + io::Write>(&mut self, to: Writer<'_, W>) -> io::Result<()> {
        match self.pending.take() {
            Some(false) => to.write_all(b", "),
            _ => Ok(()),
        }
    }

    /// What stands before something that gets lines of its own.
    fn large<W: ?Sized + io::Write>(&mut self, to: Writer<'_, W>) -> io::Result<()> {
        let Some(first) = self.pending.take() else { return Ok(()) };
        if let Some(tall) = self.tall.last_mut() {
            *tall = true;
        }
        if !first {
            to.write_all(b",")?;
        }
        self.line(to)
    }

    fn open<W: ?Sized + io::Write>(&mut self, to: Writer<'_, W>, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        self.tall.push(false);
        to.write_all(bracket)
    }

    fn close<W: ?Sized + io::Write>(&mut self, to: Writer<'_, W>, bracket: &[u8]) -> io::Result<()> {
        self.depth -= 1;
        if self.tall.pop().unwrap_or(false) {
            self.line(to)?;
        }
        to.write_all(bracket)
    }
}

impl Formatter for Layout {
    fn write_null<W: ?Sized + io::Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.small(to)?;
        to.write_all(b"null")
    }

    fn write_u32<W: ?Sized + io::Write>(&mut self, to: &mut W, value: u32) -> io::Result<()> {
        self.small(to)?;
        write!(to, "{value}")
    }

    fn write_f32<W: ?Sized + io::Write>(&mut self, to: &mut W, value: f32) -> io::Result<()> {
        self.small(to)?;
        CompactFormatter.write_f32(to, value)
    }

    fn begin_string<W: ?Sized + io::Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.small(to)?;
        CompactFormatter.begin_string(to)
    }

    fn begin_array<W: ?Sized + io::Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.large(to)?;
        self.open(to, b"[")
    }

    fn end_array<W: ?Sized + io::Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.pending = None;
        self.close(to, b"]")
    }

    fn begin_array_value<W: ?Sized + io::Write>(&mut self, _to: &mut W, first: bool) -> io::Result<()> {
        self.pending = Some(first);
        Ok(())
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.large(to)?;
        self.open(to, b"{")
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.close(to, b"}")
    }

    fn begin_object_key<W: ?Sized + io::Write>(&mut self, to: &mut W, first: bool) -> io::Result<()> {
        if let Some(tall) = self.tall.last_mut() {
            *tall = true;
        }
        if !first {
            to.write_all(b",")?;
        }
        self.line(to)
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, to: &mut W) -> io::Result<()> {
        to.write_all(b": ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Serialize;

    #[derive(Serialize)]
    struct Sample {
        none: Option<f32>,
        empty: [u32; 0],
        vector: [f32; 3],
        triangle: [[f32; 2]; 2],
        inner: Vec<Inner>,
    }

    #[derive(Serialize)]
    struct Inner {
        name: &'static str,
        list: [u32; 2],
    }

    #[test]
    fn vectors_take_one_line_and_the_rest_is_indented() {
        let sample = Sample {
            none: None,
            empty: [],
            vector: [0.1, -2.0, 1e-20],
            triangle: [[1.0, 0.5], [0.0, 1e30]],
            inner: vec![Inner { name: "a\"b", list: [1, 2] }, Inner { name: "c", list: [3, 4] }],
        };
        let mut text = Vec::new();
        let mut serializer = serde_json::Serializer::with_formatter(&mut text, Layout::default());
        sample.serialize(&mut serializer).unwrap();
        let expected = r#"{
  "none": null,
  "empty": [],
  "vector": [0.1, -2.0, 1e-20],
  "triangle": [
    [1.0, 0.5],
    [0.0, 1e+30]
  ],
  "inner": [
    {
      "name": "a\"b",
      "list": [1, 2]
    },
    {
      "name": "c",
      "list": [3, 4]
    }
  ]
}"#;
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text.replace("1e30", "1e+30"), expected);
        let read: serde_json::Value = serde_json::from_str(&text).unwrap();
        let compact = serde_json::to_string(&sample).unwrap();
        assert_eq!(read, serde_json::from_str::<serde_json::Value>(&compact).unwrap());
    }
}
