//! The chess models keep their promises: closed, outward, unit normals, a flat bottom centred on the origin, and so on.
//!
//! The reader here is strict and knows only what `cargo xtask models` writes, so that the files are judged by something that
//! shares no code with their maker nor with the renderer.

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

use glam::DVec3;

/// Millimetres per unit of the files.
const SQUARE: f64 = 57.0;
/// Name, height and base radius in millimetres, tallest first.
const PIECES: [(&str, f64, f64); 6] = [
    ("king", 95.0, 20.5),
    ("queen", 85.0, 19.2),
    ("bishop", 74.0, 17.5),
    ("knight", 68.0, 18.0),
    ("rook", 57.0, 17.5),
    ("pawn", 49.0, 15.5),
];

#[derive(Clone, Debug, Default)]
struct Mesh {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// For each corner the position and the normal.
    faces: Vec<[(usize, usize); 3]>,
}

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../assets/models").join(format!("{name}.obj"))
}

fn load(name: &str) -> Mesh {
    let path = path(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    parse(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn parse(text: &str) -> Result<Mesh, String> {
    let mut mesh = Mesh::default();
    for (number, line) in text.lines().enumerate() {
        let bad = || format!("line {}: {line:?}", number + 1);
        let words: Vec<&str> = line.split(' ').collect();
        let vector = || -> Option<DVec3> {
            let [_, x, y, z] = words[..] else { return None };
            let v = DVec3::new(x.parse().ok()?, y.parse().ok()?, z.parse().ok()?);
            v.is_finite().then_some(v)
        };
        match words[0] {
            "#" | "o" => {}
            "v" => mesh.positions.push(vector().ok_or_else(bad)?),
            "vn" => mesh.normals.push(vector().ok_or_else(bad)?),
            "f" => {
                let corners: Vec<(usize, usize)> = words[1..].iter().filter_map(|w| corner(w, &mesh)).collect();
                mesh.faces.push(corners.try_into().map_err(|_| bad())?);
            }
            _ => return Err(bad()),
        }
    }
    Ok(mesh)
}

/// `position//normal`, counted from one, both already read.
fn corner(word: &str, mesh: &Mesh) -> Option<(usize, usize)> {
    let (v, n) = word.split_once("//")?;
    let (v, n) = (v.parse::<usize>().ok()?, n.parse::<usize>().ok()?);
    let known = (1..=mesh.positions.len()).contains(&v) && (1..=mesh.normals.len()).contains(&n);
    known.then(|| (v - 1, n - 1))
}

impl Mesh {
    fn points(&self, face: &[(usize, usize); 3]) -> [DVec3; 3] {
        face.map(|(v, _)| self.positions[v])
    }

    fn area_vector(&self, face: &[(usize, usize); 3]) -> DVec3 {
        let [a, b, c] = self.points(face);
        0.5 * (b - a).cross(c - a)
    }

    fn height(&self) -> f64 {
        self.positions.iter().map(|p| p.y).fold(f64::MIN, f64::max)
    }

    fn radius(&self) -> f64 {
        self.positions.iter().map(|p| p.x.hypot(p.z)).fold(0.0, f64::max)
    }
}

/// Every rule that holds for each model alone; the error names the rule.
fn check(mesh: &Mesh) -> Result<(), String> {
    triangle_count(mesh)?;
    everything_is_used_once(mesh)?;
    closed_manifold(mesh)?;
    one_piece(mesh)?;
    no_zero_area(mesh)?;
    outward(mesh)?;
    bottom_is_flat_and_centred(mesh)?;
    normals_are_unit_and_agree(mesh)
}

fn triangle_count(mesh: &Mesh) -> Result<(), String> {
    let count = mesh.faces.len();
    if (5_000..=60_000).contains(&count) { Ok(()) } else { Err(format!("triangle count: {count}")) }
}

/// No stray vertices or normals, and no two vertices at the same place (which would hide a crack).
fn everything_is_used_once(mesh: &Mesh) -> Result<(), String> {
    let used: HashSet<usize> = mesh.faces.iter().flatten().map(|c| c.0).collect();
    let normals: HashSet<usize> = mesh.faces.iter().flatten().map(|c| c.1).collect();
    if used.len() != mesh.positions.len() || normals.len() != mesh.normals.len() {
        return Err("use: a vertex or a normal belongs to no face".to_owned());
    }
    let places: HashSet<[u64; 3]> = mesh.positions.iter().map(|p| p.to_array().map(f64::to_bits)).collect();
    if places.len() == mesh.positions.len() { Ok(()) } else { Err("use: two vertices at one place".to_owned()) }
}

/// Each directed edge once, its opposite once; around each vertex the faces form one fan.
fn closed_manifold(mesh: &Mesh) -> Result<(), String> {
    let mut face_left_of: HashMap<(usize, usize), usize> = HashMap::new();
    for (f, face) in mesh.faces.iter().enumerate() {
        for i in 0..3 {
            let edge = (face[i].0, face[(i + 1) % 3].0);
            if face_left_of.insert(edge, f).is_some() {
                return Err(format!("manifold: edge {edge:?} runs twice the same way"));
            }
        }
    }
    if let Some(edge) = face_left_of.keys().find(|(a, b)| !face_left_of.contains_key(&(*b, *a))) {
        return Err(format!("closed: edge {edge:?} has a face on one side only"));
    }
    let mut valence = vec![0; mesh.positions.len()];
    let mut start = vec![(0, 0); mesh.positions.len()];
    for face in &mesh.faces {
        for i in 0..3 {
            valence[face[i].0] += 1;
            start[face[i].0] = (face[i].0, face[(i + 1) % 3].0);
        }
    }
    for (v, &(_, first)) in start.iter().enumerate() {
        // Walk from face to face around v; the fan must hold all its faces.
        let (mut at, mut steps) = (first, 0);
        loop {
            let face = &mesh.faces[face_left_of[&(v, at)]];
            let i = face.iter().position(|c| c.0 == v).unwrap_or(0);
            at = face[(i + 2) % 3].0;
            steps += 1;
            if at == first || steps > valence[v] {
                break;
            }
        }
        if steps != valence[v] {
            return Err(format!("manifold: vertex {v} joins two fans"));
        }
    }
    Ok(())
}

fn one_piece(mesh: &Mesh) -> Result<(), String> {
    let mut parent: Vec<usize> = (0..mesh.positions.len()).collect();
    fn root(parent: &mut [usize], mut i: usize) -> usize {
        while parent[i] != i {
            parent[i] = parent[parent[i]];
            i = parent[i];
        }
        i
    }
    for face in &mesh.faces {
        for i in 1..3 {
            let (a, b) = (root(&mut parent, face[0].0), root(&mut parent, face[i].0));
            parent[a] = b;
        }
    }
    let roots = (0..parent.len()).filter(|i| parent[*i] == *i).count();
    if roots == 1 { Ok(()) } else { Err(format!("pieces: {roots}")) }
}

fn no_zero_area(mesh: &Mesh) -> Result<(), String> {
    // 1e-9 square units are 3 square micrometres of a tournament piece.
    match mesh.faces.iter().position(|f| mesh.area_vector(f).length() < 1e-9) {
        None => Ok(()),
        Some(f) => Err(format!("area: face {f} is degenerate: {:?}", mesh.points(&mesh.faces[f]))),
    }
}

fn outward(mesh: &Mesh) -> Result<(), String> {
    let volume: f64 = mesh.faces.iter().map(|f| mesh.points(f)[0].dot(mesh.area_vector(f)) / 3.0).sum();
    if volume > 0.01 { Ok(()) } else { Err(format!("volume: {volume}")) }
}

fn bottom_is_flat_and_centred(mesh: &Mesh) -> Result<(), String> {
    let lowest = mesh.positions.iter().map(|p| p.y).fold(f64::MAX, f64::min);
    if lowest != 0.0 {
        return Err(format!("bottom: lowest point at y = {lowest}"));
    }
    let (mut area, mut moment) = (0.0, DVec3::ZERO);
    for face in mesh.faces.iter().filter(|f| mesh.points(f).iter().all(|p| p.y == 0.0)) {
        let vector = mesh.area_vector(face);
        if vector.y >= 0.0 || face.iter().any(|c| mesh.normals[c.1].dot(DVec3::NEG_Y) < 0.999) {
            return Err("bottom: a face or a normal does not look down".to_owned());
        }
        area -= vector.y;
        moment += mesh.points(face).into_iter().sum::<DVec3>() / 3.0 * -vector.y;
    }
    let center = moment / area;
    let disc = std::f64::consts::PI * (0.9 * mesh.radius()).powi(2);
    if area > disc && center.length() < 1e-4 { Ok(()) } else { Err(format!("bottom: area {area}, centre {center}")) }
}

fn normals_are_unit_and_agree(mesh: &Mesh) -> Result<(), String> {
    if let Some(n) = mesh.normals.iter().find(|n| (n.length() - 1.0).abs() >= 1e-3) {
        return Err(format!("normals: length of {n} is {}", n.length()));
    }
    for (f, face) in mesh.faces.iter().enumerate() {
        let side = mesh.area_vector(face);
        if face.iter().any(|c| mesh.normals[c.1].dot(side) <= 0.0) {
            return Err(format!("normals: face {f} and a normal of it look to different sides"));
        }
    }
    Ok(())
}

#[test]
fn every_model_keeps_every_rule() {
    for (name, ..) in PIECES {
        if let Err(rule) = check(&load(name)) {
            panic!("{name}: {rule}");
        }
    }
}

#[test]
fn sizes_step_down_from_the_king() {
    let meshes: Vec<Mesh> = PIECES.iter().map(|(name, ..)| load(name)).collect();
    for ((name, height, radius), mesh) in PIECES.iter().zip(&meshes) {
        let (h, r) = (mesh.height() * SQUARE, mesh.radius() * SQUARE);
        assert!((h - height).abs() < 0.8 && (r - radius).abs() < 0.5, "{name}: {h} mm high, radius {r} mm");
    }
    assert!(meshes.windows(2).all(|m| m[0].height() > m[1].height()), "heights step down");
    let base = 2.0 * meshes[0].radius();
    assert!((0.7..=0.78).contains(&base), "the king's base fills about three quarters of its square: {base}");
}

/// A crease is one position with several normals; a smooth part shares them.
#[test]
fn creases_are_kept_and_the_rest_is_smooth() {
    for (name, ..) in PIECES {
        let mesh = load(name);
        let mut normals_at: HashMap<usize, HashSet<usize>> = HashMap::new();
        for (v, n) in mesh.faces.iter().flatten() {
            normals_at.entry(*v).or_default().insert(*n);
        }
        let sharp = normals_at.values().filter(|n| n.len() > 1).count();
        assert!(sharp > 300 && sharp * 3 < mesh.positions.len(), "{name}: {sharp} of {}", mesh.positions.len());
    }
}

/// What makes a kind unmistakable is really there.
#[test]
fn features_are_modelled() {
    // The rook is hollow: on the axis it is far lower than its battlements.
    let rook = load("rook");
    let floor = rook.positions.iter().filter(|p| p.x.hypot(p.z) < 0.03).map(|p| p.y).fold(0.0, f64::max);
    assert!(rook.height() - floor > 5.0 / SQUARE, "the rook's floor is at {floor}");
    // Six notches: along the rim's circle the top is interrupted six times.
    let mut top: Vec<f64> =
        rook.positions.iter().filter(|p| p.y > rook.height() - 0.01).map(|p| p.z.atan2(p.x)).collect();
    top.sort_by(f64::total_cmp);
    let wrap = top[0] + std::f64::consts::TAU - top[top.len() - 1];
    let gaps = top.windows(2).map(|w| w[1] - w[0]).chain([wrap]).filter(|g| *g > 0.2).count();
    assert_eq!(gaps, 6, "notches of the rook");
    // The knight faces +z and its sides mirror each other.
    let knight = load("knight");
    let reach = |f: fn(&DVec3) -> f64| knight.positions.iter().filter(|p| p.y > 0.6).map(f).fold(f64::MIN, f64::max);
    assert!(reach(|p| p.z) > 0.27 && reach(|p| p.x) < 0.2, "the muzzle reaches to +z");
    assert!((reach(|p| p.x) - reach(|p| -p.x)).abs() < 0.005, "both sides are equal");
}

#[test]
fn the_files_together_stay_small() {
    let total: u64 = PIECES.iter().map(|(name, ..)| std::fs::metadata(path(name)).map_or(0, |m| m.len())).sum();
    assert!(total < 13_000_000, "{total} bytes");
}

/// Each rule, broken on purpose, is seen.
#[test]
fn broken_models_are_caught() {
    let good = load("pawn");
    assert_eq!(check(&good), Ok(()));
    let broken = |spoil: fn(&mut Mesh)| {
        let mut mesh = good.clone();
        spoil(&mut mesh);
        check(&mesh).expect_err("the rule must be seen as broken")
    };
    assert!(broken(|m| m.faces.truncate(4000)).starts_with("triangle count"));
    assert!(broken(|m| m.positions.push(DVec3::ONE)).starts_with("use"));
    assert!(broken(|m| m.positions[7] = m.positions[8]).starts_with("use"));
    assert!(broken(|m| _ = m.faces.remove(9000)).starts_with("closed"));
    assert!(broken(|m| m.faces[9000].swap(0, 1)).starts_with("manifold"));
    assert!(broken(|m| m.faces.push(m.faces[9000])).starts_with("manifold"));
    assert!(broken(add_a_stray_tetrahedron).starts_with("pieces"));
    assert!(broken(flatten_a_face).starts_with("area"));
    assert!(broken(|m| m.faces.iter_mut().for_each(|f| f.swap(0, 1))).starts_with("volume"));
    assert!(broken(|m| m.positions.iter_mut().for_each(|p| p.y += 0.01)).starts_with("bottom"));
    assert!(broken(|m| m.positions.iter_mut().for_each(|p| p.x += 0.01)).starts_with("bottom"));
    assert!(broken(|m| m.normals[900] *= 1.01).starts_with("normals"));
    assert!(broken(|m| m.normals[900] *= -1.0).starts_with("normals"));
    assert!(parse("v 0 0 nan\n").is_err() && parse("f 1//1 2//1 3//1\n").is_err() && parse("vt 0 0\n").is_err());
}

fn add_a_stray_tetrahedron(mesh: &mut Mesh) {
    let v = mesh.positions.len();
    mesh.positions.extend([
        DVec3::ONE,
        DVec3::new(2.0, 1.0, 1.0),
        DVec3::new(1.0, 2.0, 1.0),
        DVec3::new(1.0, 1.0, 2.0),
    ]);
    for [a, b, c] in [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] {
        mesh.faces.push([(v + a, 0), (v + b, 0), (v + c, 0)]);
    }
}

/// Moves a corner of a face nearly onto its opposite edge.
fn flatten_a_face(mesh: &mut Mesh) {
    let [a, b, c] = mesh.faces[9000].map(|corner| corner.0);
    mesh.positions[a] = mesh.positions[b].lerp(mesh.positions[c], 0.37);
}
