//! Rays, and batches of rays, hits and answers in lanes.
//!
//! The unit of work of a ray query is a batch. Its storage is a structure of arrays, padded to whole groups of
//! [`LANES`] rays, so that a SIMD producer writes it and a SIMD kernel reads it without shuffling or remainders.

use glam::Vec3;

/// Batches are padded to a multiple of this many rays: the widest vector any kernel uses.
pub const LANES: usize = 16;

/// The object index of a ray that hit nothing.
pub const NO_OBJECT: u32 = u32::MAX;

/// A half-line `origin + t * direction`, of which the part `t_min < t < t_max` counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where `t` is 0.
    pub origin: Vec3,
    /// Need not have unit length; `t` is measured in multiples of it.
    pub direction: Vec3,
    /// Hits at or before it do not count; at least 0.
    pub t_min: f32,
    /// Hits at or beyond it do not count; may be infinite.
    pub t_max: f32,
}

impl Ray {
    /// The whole half-line: `t_min` 0, `t_max` infinite.
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction, t_min: 0.0, t_max: f32::INFINITY }
    }

    /// The point `origin + t * direction`.
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + self.direction * t
    }

    /// A ray that can hit nothing, for the padding of batches. Finite where a kernel computes with it.
    const NOTHING: Self =
        Self { origin: Vec3::ZERO, direction: Vec3::Z, t_min: f32::INFINITY, t_max: f32::NEG_INFINITY };
}

/// What is known about the rays of a batch. A hint only: it never changes a bit of the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coherence {
    /// Rays next to each other in the batch start close together and point nearly the same way (camera rays, shadow
    /// rays to one light). Best in square blocks: 16 rays of 4x4 pixels, or 64 rays of 8x8 pixels row by row.
    Coherent,
    /// Nothing is known.
    Incoherent,
}

/// Rays in lanes. Growing keeps the allocation; reuse one batch for all waves of a tile.
#[derive(Clone, Debug, Default)]
pub struct RayBatch {
    lanes: [Vec<f32>; 8],
    len: usize,
}

/// The eight arrays of a [`RayBatch`], each [`RayBatch::padded_len`] long, for producers that write whole lanes.
#[derive(Debug)]
pub struct RayLanesMut<'a> {
    /// Origins, one array per axis.
    pub origin: [&'a mut [f32]; 3],
    /// Directions, one array per axis.
    pub direction: [&'a mut [f32]; 3],
    /// [`Ray::t_min`] of each ray.
    pub t_min: &'a mut [f32],
    /// [`Ray::t_max`] of each ray.
    pub t_max: &'a mut [f32],
}

impl RayBatch {
    /// An empty batch.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty batch with room for `rays` rays.
    pub fn with_capacity(rays: usize) -> Self {
        let padded = rays.next_multiple_of(LANES);
        Self { lanes: std::array::from_fn(|_| Vec::with_capacity(padded)), len: 0 }
    }

    /// Makes the batch empty; keeps the memory.
    pub fn clear(&mut self) {
        self.lanes.iter_mut().for_each(Vec::clear);
        self.len = 0;
    }

    /// Number of rays, padding not counted.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no rays.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Length of the lane arrays: [`RayBatch::len`] rounded up to a multiple of [`LANES`].
    pub fn padded_len(&self) -> usize {
        self.lanes[0].len()
    }

    /// Appends a ray.
    pub fn push(&mut self, ray: &Ray) {
        if self.len == self.padded_len() {
            self.resize(self.len + 1);
        } else {
            self.len += 1;
        }
        self.set(self.len - 1, ray);
    }

    /// Makes the batch `len` rays long. New rays, like the padding, can hit nothing until they are set.
    pub fn resize(&mut self, len: usize) {
        let (keep, padded) = (self.len.min(len), len.next_multiple_of(LANES));
        for (lane, nothing) in self.lanes.iter_mut().zip(to_lanes(&Ray::NOTHING)) {
            lane.truncate(keep);
            lane.resize(padded, nothing);
        }
        self.len = len;
    }

    /// The ray at `index`.
    ///
    /// # Panics
    /// If `index` is not below [`RayBatch::len`].
    pub fn get(&self, index: usize) -> Ray {
        assert!(index < self.len, "ray {index} of a batch of {}", self.len);
        let [ox, oy, oz, dx, dy, dz, t_min, t_max] = std::array::from_fn(|k| self.lanes[k][index]);
        Ray { origin: Vec3::new(ox, oy, oz), direction: Vec3::new(dx, dy, dz), t_min, t_max }
    }

    /// Replaces the ray at `index`.
    ///
    /// # Panics
    /// If `index` is not below [`RayBatch::len`].
    pub fn set(&mut self, index: usize, ray: &Ray) {
        assert!(index < self.len, "ray {index} of a batch of {}", self.len);
        for (lane, value) in self.lanes.iter_mut().zip(to_lanes(ray)) {
            lane[index] = value;
        }
    }

    /// Origins along `axis` (0 to 2), padded.
    pub fn origin(&self, axis: usize) -> &[f32] {
        assert!(axis < 3, "axis {axis}");
        &self.lanes[axis]
    }

    /// Directions along `axis` (0 to 2), padded.
    pub fn direction(&self, axis: usize) -> &[f32] {
        assert!(axis < 3, "axis {axis}");
        &self.lanes[3 + axis]
    }

    /// [`Ray::t_min`] of each ray, padded.
    pub fn t_min(&self) -> &[f32] {
        &self.lanes[6]
    }

    /// [`Ray::t_max`] of each ray, padded.
    pub fn t_max(&self) -> &[f32] {
        &self.lanes[7]
    }

    /// All arrays for writing. A producer that writes whole groups of lanes may write the padding too, but must leave
    /// rays there that can hit nothing (`t_max` below `t_min`).
    pub fn lanes_mut(&mut self) -> RayLanesMut<'_> {
        let [ox, oy, oz, dx, dy, dz, t_min, t_max] = &mut self.lanes;
        RayLanesMut { origin: [ox, oy, oz], direction: [dx, dy, dz], t_min, t_max }
    }
}

fn to_lanes(ray: &Ray) -> [f32; 8] {
    let (o, d) = (ray.origin, ray.direction);
    [o.x, o.y, o.z, d.x, d.y, d.z, ray.t_min, ray.t_max]
}

/// Where a ray met the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The ray's parameter: the point is `origin + t * direction`. Finite.
    pub t: f32,
    /// Barycentric weight of the triangle's vertex 1; 0 for analytic shapes.
    pub u: f32,
    /// Barycentric weight of the triangle's vertex 2; 0 for analytic shapes.
    pub v: f32,
    /// Index of the object in the slice the scene's tree was built from.
    pub object: u32,
    /// Index of the triangle in its mesh; of a cuboid the face, `2 * axis`, plus 1 on the positive side; else 0.
    pub primitive: u32,
}

/// Answers of a closest-hit query, in lanes. [`HitBatch::padded_len`] follows that of the rays.
#[derive(Clone, Debug, Default)]
pub struct HitBatch {
    /// [`Hit::t`]; infinite for a miss.
    pub t: Vec<f32>,
    /// [`Hit::u`].
    pub u: Vec<f32>,
    /// [`Hit::v`].
    pub v: Vec<f32>,
    /// [`Hit::object`]; [`NO_OBJECT`] for a miss.
    pub object: Vec<u32>,
    /// [`Hit::primitive`]; `u32::MAX` for a miss.
    pub primitive: Vec<u32>,
    len: usize,
}

impl HitBatch {
    /// An empty batch; queries give it the length it needs.
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes it `len` misses long.
    pub fn reset(&mut self, len: usize) {
        let padded = len.next_multiple_of(LANES);
        for (lane, miss) in [(&mut self.t, f32::INFINITY), (&mut self.u, 0.0), (&mut self.v, 0.0)] {
            lane.clear();
            lane.resize(padded, miss);
        }
        for lane in [&mut self.object, &mut self.primitive] {
            lane.clear();
            lane.resize(padded, NO_OBJECT);
        }
        self.len = len;
    }

    /// Number of answers, padding not counted.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no answers.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Length of the lane arrays.
    pub fn padded_len(&self) -> usize {
        self.t.len()
    }

    /// The answer for ray `index`: `None` for a miss.
    ///
    /// # Panics
    /// If `index` is not below [`HitBatch::len`].
    pub fn get(&self, index: usize) -> Option<Hit> {
        assert!(index < self.len, "hit {index} of a batch of {}", self.len);
        (self.object[index] != NO_OBJECT).then(|| Hit {
            t: self.t[index],
            u: self.u[index],
            v: self.v[index],
            object: self.object[index],
            primitive: self.primitive[index],
        })
    }

    /// Replaces the answer for ray `index`.
    pub fn set(&mut self, index: usize, hit: Option<Hit>) {
        const MISS: Hit = Hit { t: f32::INFINITY, u: 0.0, v: 0.0, object: NO_OBJECT, primitive: NO_OBJECT };
        let hit = hit.unwrap_or(MISS);
        self.t[index] = hit.t;
        self.u[index] = hit.u;
        self.v[index] = hit.v;
        self.object[index] = hit.object;
        self.primitive[index] = hit.primitive;
    }
}

/// One bit per ray, in words of [`LANES`] bits.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mask {
    words: Vec<u16>,
    len: usize,
}

impl Mask {
    /// An empty mask; queries give it the length they need.
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes it `len` bits long, all false.
    pub fn reset(&mut self, len: usize) {
        self.words.clear();
        self.words.resize(len.div_ceil(LANES), 0);
        self.len = len;
    }

    /// Number of bits.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no bits.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The bit of ray `index`.
    ///
    /// # Panics
    /// If `index` is not below [`Mask::len`].
    pub fn get(&self, index: usize) -> bool {
        assert!(index < self.len, "bit {index} of a mask of {}", self.len);
        self.words[index / LANES] >> (index % LANES) & 1 != 0
    }

    /// Replaces the bit of ray `index`.
    ///
    /// # Panics
    /// If `index` is not below [`Mask::len`].
    pub fn set(&mut self, index: usize, value: bool) {
        assert!(index < self.len, "bit {index} of a mask of {}", self.len);
        let bit = 1 << (index % LANES);
        let word = &mut self.words[index / LANES];
        *word = if value { *word | bit } else { *word & !bit };
    }

    /// Number of true bits.
    pub fn count(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// The bits of rays `LANES * k ..` in word `k`, lowest first. Bits beyond the length are false.
    pub fn words(&self) -> &[u16] {
        &self.words
    }

    /// Replaces word `k`; bits beyond the length stay false.
    pub(crate) fn set_word(&mut self, k: usize, word: u16) {
        let bits = self.len - k * LANES;
        self.words[k] = if bits < LANES { word & ((1 << bits) - 1) } else { word };
    }
}
