//! `usemtl` and `mtllib`: from names in the model to looks of its triangles.

use super::OpenLibrary;
use super::cursor::before_comment;
use super::mtl::{self, MtlMaterial};
use super::place::{line_of, shown};
use super::triangles::Triangles;
use crate::budget::{Budget, OverBudget};
use crate::error::{Error, ErrorKind, Result};
use crate::report::Report;
use luch_scene::{Material, MeshMaterial};
use std::collections::HashMap;
use std::path::Path;

/// The most libraries that a model opens.
const MOST_LIBRARIES: usize = 64;

/// The names that a model uses.
#[derive(Debug, Default)]
pub(super) struct MaterialNames<'a> {
    used: Vec<&'a [u8]>,
    numbers: HashMap<&'a [u8], u32>,
    libraries: Vec<(&'a [u8], usize)>,
}

impl<'a> MaterialNames<'a> {
    /// The number of triangles before the first `usemtl`.
    pub(super) const NONE: u32 = u32::MAX;
    /// The most names: one less than a u16 counts, for the triangles without any.
    const MOST: usize = 65_535;

    /// The number of a name, in the order of first use; `None` if there are too many.
    pub(super) fn number_of(&mut self, name: &'a [u8]) -> Option<u32> {
        if let Some(number) = self.numbers.get(name) {
            return Some(*number);
        }
        let number = u32::try_from(self.used.len()).ok().filter(|_| self.used.len() < Self::MOST)?;
        self.used.push(name);
        self.numbers.insert(name, number);
        Some(number)
    }

    /// Notes what stands behind an `mtllib` at byte `statement`.
    pub(super) fn add_library(&mut self, name: &'a [u8], statement: usize) {
        if self.libraries.len() < MOST_LIBRARIES && !self.libraries.iter().any(|(old, _)| *old == name) {
            self.libraries.push((name, statement));
        }
    }
}

/// The looks of a model.
#[derive(Debug, Default)]
pub(super) struct Looks {
    /// One for each used name; empty if no library gave any.
    pub(super) list: Vec<MeshMaterial>,
}

/// Opens the libraries and finds the used names in them.
pub(super) fn resolve(
    names: &MaterialNames<'_>,
    text: &[u8],
    file: &Path,
    open: &mut OpenLibrary<'_>,
    budget: &mut Budget,
    report: &mut Report,
) -> Result<Looks> {
    let mut known: HashMap<Vec<u8>, (MtlMaterial, bool)> = HashMap::new();
    for (name, statement) in &names.libraries {
        let place = || format!("{}:{}", file.display(), line_of(text, *statement));
        for material in read_libraries(name, &place, open, budget, report)? {
            // The first of a name wins, as it would in a reader that stops at the first.
            known.entry(material.name.clone()).or_insert((material, false));
        }
    }
    if known.is_empty() {
        if names.libraries.is_empty() && !names.used.is_empty() {
            report.warn("materials are named but no library: the default look serves", || file.display().to_string());
        }
        return Ok(Looks::default());
    }
    let mut list = Vec::new();
    for name in &names.used {
        let key = if known.contains_key(*name) { name } else { before_comment(name) };
        let found = known.get_mut(key);
        if found.is_none() {
            report.warn("materials that no library has get the default look", || format!("\"{}\"", shown(name)));
        }
        let found = found.map(|(material, is_used)| {
            *is_used = true;
            &*material
        });
        list.push(MeshMaterial {
            name: String::from_utf8_lossy(name).chars().take(256).collect(),
            color: found.and_then(|m| m.color).unwrap_or(Material::DEFAULT_COLOR),
            gloss: found.and_then(MtlMaterial::gloss),
        });
    }
    let unused = known.values().filter(|(_, is_used)| !is_used).count();
    if unused > 0 {
        report.warn("materials of a library that nothing uses", || format!("{unused} ({})", file.display()));
    }
    Ok(Looks { list })
}

/// One `mtllib` line: a file whose name may have blanks, or several files.
fn read_libraries(
    line: &[u8],
    place: &dyn Fn() -> String,
    open: &mut OpenLibrary<'_>,
    budget: &mut Budget,
    report: &mut Report,
) -> Result<Vec<MtlMaterial>> {
    const UNREADABLE: &str = "material libraries that cannot be read are left out";
    let mut materials = Vec::new();
    let mut read = |name: &[u8], report: &mut Report| -> Result<Option<String>> {
        let Ok(name) = std::str::from_utf8(name) else {
            return Ok(Some(format!("\"{}\": the name is no UTF-8", shown(name))));
        };
        match open(name, budget) {
            Ok(bytes) => {
                mtl::read(&bytes, Path::new(name), &mut materials, report);
                budget.release_list(&bytes, bytes.capacity());
                Ok(None)
            }
            Err(error) if error.kind == ErrorKind::Cancelled => Err(error),
            Err(Error { file, text, .. }) => Ok(Some(format!("{}: {text}", file.display()))),
        }
    };
    // The whole line first: names with blanks are common, several names are not.
    let name = before_comment(line);
    let Some(mut fault) = read(line, report)? else { return Ok(materials) };
    if name != line {
        match read(name, report)? {
            None => return Ok(materials),
            Some(other) => fault = other,
        }
    }
    let parts: Vec<&[u8]> =
        name.split(|b| matches!(b, b' ' | b'\t')).filter(|part| !part.is_empty()).take(MOST_LIBRARIES).collect();
    if parts.len() < 2 {
        report.warn(UNREADABLE, || format!("{fault} ({})", place()));
        return Ok(materials);
    }
    for part in parts {
        if let Some(fault) = read(part, report)? {
            report.warn(UNREADABLE, || format!("{fault} ({})", place()));
        }
    }
    Ok(materials)
}

impl Looks {
    /// For each triangle the index of its look; empty where one look serves all. Adds a look for the triangles before
    /// the first `usemtl`, if there are any.
    pub(super) fn of_triangles(
        &mut self,
        triangles: &Triangles,
        budget: &mut Budget,
    ) -> std::result::Result<Vec<u16>, OverBudget> {
        if self.list.is_empty() {
            return Ok(Vec::new());
        }
        let values = || triangles.materials.values(triangles.len(), MaterialNames::NONE);
        let without = values().any(|m| m == MaterialNames::NONE);
        if !without && self.list.len() == 1 {
            return Ok(Vec::new());
        }
        let default = u16::try_from(self.list.len()).unwrap_or(u16::MAX);
        if without {
            self.list.push(MeshMaterial { name: String::new(), color: Material::DEFAULT_COLOR, gloss: None });
        }
        let mut list = Vec::new();
        budget.reserve(&mut list, triangles.len(), "materials of triangles")?;
        list.extend(values().map(|m| u16::try_from(m).unwrap_or(default)));
        Ok(list)
    }
}
