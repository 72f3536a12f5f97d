//! The few lane operations the kernels need beyond `fearless_simd`: a table look-up by nibbles, and a push onto a stack
//! of those lanes that were hit. Each has a portable form, which is the definition, and where it pays a native one.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x16, mask32x16, u32x16};

/// `[f(0), f(1), f(2)]`. Unlike `array::map` it is certain to be inlined: a closure that is not runs without the vector
/// instructions around it, several times slower.
#[inline(always)]
pub(crate) fn each<T>(mut f: impl FnMut(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}

/// Sixteen times the same. A function, not a closure in each kernel, for the same reason.
#[inline(always)]
pub(crate) fn splat<S: Simd>(simd: S, x: f32) -> f32x16<S> {
    f32x16::splat(simd, x)
}

/// Sixteen in a row.
#[inline(always)]
pub(crate) fn load<S: Simd>(simd: S, row: &[f32; 16]) -> f32x16<S> {
    f32x16::load_array_ref(simd, row)
}

/// Sixteen numbers of four bits, one per lane, laid out for a vector shift: lane `i` is nibble `i / 2` of the low word
/// if `i` is even, of the high word if it is odd.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub(crate) struct Nibbles(pub(crate) u64);

impl Nibbles {
    pub(crate) const ZERO: Self = Self(0);

    const fn shift(lane: usize) -> u32 {
        ((lane & 1) * 32 + (lane >> 1) * 4) as u32
    }

    pub(crate) fn set(&mut self, lane: usize, value: usize) {
        let shift = Self::shift(lane);
        self.0 = self.0 & !(15 << shift) | (value as u64 & 15) << shift;
    }

    pub(crate) const fn get(self, lane: usize) -> usize {
        (self.0 >> Self::shift(lane) & 15) as usize
    }

    /// Lane `i` becomes lane `15 - i`.
    pub(crate) const fn reversed(self) -> Self {
        const LOW: u64 = 0x0f0f_0f0f_0f0f_0f0f;
        let bytes = self.0.swap_bytes();
        Self((bytes >> 4) & LOW | (bytes & LOW) << 4)
    }
}

/// Calls `$call` with the token of a level as `$simd`. Like `fearless_simd::dispatch`, whose token is known to be
/// `Simd` only, not [`Wide`].
macro_rules! at_level {
    ($level:expr, $simd:ident => $call:expr) => {
        match $level {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            fearless_simd::Level::Sse2($simd) => $call,
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            fearless_simd::Level::Sse4_2($simd) => $call,
            #[cfg(target_arch = "x86_64")]
            fearless_simd::Level::Avx2($simd) => $call,
            #[cfg(target_arch = "x86_64")]
            fearless_simd::Level::Avx512($simd) => $call,
            #[cfg(target_arch = "aarch64")]
            fearless_simd::Level::Neon($simd) => $call,
            #[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
            fearless_simd::Level::Fallback($simd) => $call,
            #[allow(unreachable_patterns, reason = "the enum is open; these are all of its levels")]
            _ => unreachable!("no such level on this target"),
        }
    };
}
pub(crate) use at_level;

/// A SIMD level that the kernels run on.
pub(crate) trait Wide: Simd {
    /// [`Nibbles`] ready for [`Wide::pick`].
    type Index: Copy;

    fn index(self, nibbles: Nibbles) -> Self::Index;

    /// Lane `i` is `table[index[i]]`.
    fn pick(self, table: f32x16<Self>, index: Self::Index) -> f32x16<Self>;

    /// Writes child and distance of each hit lane to the start of the two slices, roughly the far ones first; returns
    /// how many. `order` lists the lanes far to near along the ray's octant; what lies beyond the returned count is
    /// garbage. The order is advice: it decides how soon something is found, not what.
    fn push_hit(
        self,
        child: u32x16<Self>,
        near: f32x16<Self>,
        hit: mask32x16<Self>,
        order: Nibbles,
        to_child: &mut [u32; 16],
        to_near: &mut [f32; 16],
    ) -> usize;
}

/// The portable push: sorted by distance, which without a compress instruction costs little more than not to sort.
#[inline(always)]
fn push_sorted<S: Simd>(
    child: u32x16<S>,
    near: f32x16<S>,
    hit: mask32x16<S>,
    to_child: &mut [u32; 16],
    to_near: &mut [f32; 16],
) -> usize {
    let (mut bits, mut count) = (hit.to_bitmask() as u32, 0);
    while bits != 0 {
        let lane = bits.trailing_zeros() as usize & 15;
        bits &= bits - 1;
        let distance = near[lane];
        let mut at = count;
        while at > 0 && to_near[at - 1] < distance {
            (to_near[at], to_child[at]) = (to_near[at - 1], to_child[at - 1]);
            at -= 1;
        }
        (to_near[at], to_child[at]) = (distance, child[lane]);
        count += 1;
    }
    count
}

macro_rules! portable {
    ($($level:ty),*) => { $(
        impl Wide for $level {
            type Index = Nibbles;

            #[inline(always)]
            fn index(self, nibbles: Nibbles) -> Nibbles {
                nibbles
            }

            #[inline(always)]
            fn pick(self, table: f32x16<Self>, index: Nibbles) -> f32x16<Self> {
                f32x16::from_fn(self, |lane| table[index.get(lane)])
            }

            #[inline(always)]
            fn push_hit(
                self,
                child: u32x16<Self>,
                near: f32x16<Self>,
                hit: mask32x16<Self>,
                _order: Nibbles,
                to_child: &mut [u32; 16],
                to_near: &mut [f32; 16],
            ) -> usize {
                push_sorted(child, near, hit, to_child, to_near)
            }
        }
    )* };
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
portable!(fearless_simd::Fallback);
#[cfg(target_arch = "aarch64")]
portable!(fearless_simd::aarch64::Neon);
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
portable!(fearless_simd::x86::Sse2, fearless_simd::x86::Sse4_2);

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Nibbles, Wide, push_sorted};
    use fearless_simd::prelude::*;
    use fearless_simd::x86::{Avx2, Avx512};
    use fearless_simd::{f32x8, f32x16, mask32x16, u32x16};
    use std::arch::x86_64::*;

    fearless_simd::kernel!(
        #[inline(always)]
        fn expand_256(_level: Avx2, nibbles: Nibbles) -> [__m256i; 2] {
            let both = _mm256_set1_epi64x(nibbles.0.cast_signed());
            [
                _mm256_srlv_epi32(both, _mm256_setr_epi32(0, 0, 4, 4, 8, 8, 12, 12)),
                _mm256_srlv_epi32(both, _mm256_setr_epi32(16, 16, 20, 20, 24, 24, 28, 28)),
            ]
        }
    );

    fearless_simd::kernel!(
        #[inline(always)]
        fn pick_256(_level: Avx2, low: __m256, high: __m256, index: __m256i) -> __m256 {
            // The permute looks at three bits of the index; the fourth, moved to the sign, chooses the half.
            let high_half = _mm256_castsi256_ps(_mm256_slli_epi32::<28>(index));
            let (a, b) = (_mm256_permutevar8x32_ps(low, index), _mm256_permutevar8x32_ps(high, index));
            _mm256_blendv_ps(a, b, high_half)
        }
    );

    impl Wide for Avx2 {
        type Index = [__m256i; 2];

        #[inline(always)]
        fn index(self, nibbles: Nibbles) -> Self::Index {
            expand_256(self, nibbles)
        }

        #[inline(always)]
        fn pick(self, table: f32x16<Self>, index: Self::Index) -> f32x16<Self> {
            let (low, high) = table.split();
            let half = |index| -> f32x8<Self> { pick_256(self, low.into(), high.into(), index).simd_into(self) };
            half(index[0]).combine(half(index[1]))
        }

        #[inline(always)]
        fn push_hit(
            self,
            child: u32x16<Self>,
            near: f32x16<Self>,
            hit: mask32x16<Self>,
            _order: Nibbles,
            to_child: &mut [u32; 16],
            to_near: &mut [f32; 16],
        ) -> usize {
            push_sorted(child, near, hit, to_child, to_near)
        }
    }

    fearless_simd::kernel!(
        #[inline(always)]
        fn expand_512(_level: Avx512, nibbles: Nibbles) -> __m512i {
            let both = _mm512_set1_epi64(nibbles.0.cast_signed());
            let shifts = _mm512_setr_epi32(0, 0, 4, 4, 8, 8, 12, 12, 16, 16, 20, 20, 24, 24, 28, 28);
            // The permutes look at the low four bits only.
            _mm512_srlv_epi32(both, shifts)
        }
    );

    fearless_simd::kernel!(
        #[inline(always)]
        fn permute_512(_level: Avx512, table: __m512, index: __m512i) -> __m512 {
            _mm512_permutexvar_ps(index, table)
        }
    );

    fearless_simd::kernel!(
        /// Children in the node's own order for the octant, then compressed: no branch depends on what was hit.
        /// Fuetterer, Lojewski, Pfreundt, Hamann, Ebert, "Accelerated Single Ray Tracing for Wide Vector Units" (2017).
        #[inline(always)]
        fn push_512(
            level: Avx512,
            child: __m512i,
            near: __m512,
            hit: u16,
            order: Nibbles,
            to_child: &mut [u32; 16],
            to_near: &mut [f32; 16],
        ) -> usize {
            let index = expand_512(level, order);
            let missed = _mm512_set1_ps(f32::INFINITY);
            let near = _mm512_permutexvar_ps(index, _mm512_mask_blend_ps(hit, missed, near));
            let child = _mm512_permutexvar_epi32(index, child);
            let keep = _mm512_cmplt_ps_mask(near, missed);
            let child: u32x16<Avx512> = _mm512_maskz_compress_epi32(keep, child).simd_into(level);
            let near: f32x16<Avx512> = _mm512_maskz_compress_ps(keep, near).simd_into(level);
            child.store_array(to_child);
            near.store_array(to_near);
            hit.count_ones() as usize
        }
    );

    impl Wide for Avx512 {
        type Index = __m512i;

        #[inline(always)]
        fn index(self, nibbles: Nibbles) -> Self::Index {
            expand_512(self, nibbles)
        }

        #[inline(always)]
        fn pick(self, table: f32x16<Self>, index: Self::Index) -> f32x16<Self> {
            permute_512(self, table.into(), index).simd_into(self)
        }

        #[inline(always)]
        fn push_hit(
            self,
            child: u32x16<Self>,
            near: f32x16<Self>,
            hit: mask32x16<Self>,
            order: Nibbles,
            to_child: &mut [u32; 16],
            to_near: &mut [f32; 16],
        ) -> usize {
            push_512(self, child.into(), near.into(), hit.to_bitmask() as u16, order, to_child, to_near)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::available_levels;

    fn some_nibbles() -> Nibbles {
        let mut nibbles = Nibbles::ZERO;
        (0..16).for_each(|lane| nibbles.set(lane, (lane * 7 + 3) % 16));
        nibbles
    }

    #[test]
    fn nibbles_keep_what_is_set_and_turn_round() {
        let nibbles = some_nibbles();
        for lane in 0..16 {
            assert_eq!(nibbles.get(lane), (lane * 7 + 3) % 16);
            assert_eq!(nibbles.reversed().get(lane), nibbles.get(15 - lane));
        }
    }

    #[test]
    fn pick_looks_up_the_same_at_every_level() {
        fn picked<S: Wide>(simd: S) -> [f32; 16] {
            let table = f32x16::from_fn(simd, |lane| lane as f32 * 10.0);
            simd.pick(table, simd.index(some_nibbles())).into()
        }
        let want: [f32; 16] = std::array::from_fn(|lane| some_nibbles().get(lane) as f32 * 10.0);
        for (name, level) in available_levels() {
            assert_eq!(at_level!(level, simd => picked(simd)), want, "{name}");
        }
    }

    #[test]
    fn a_push_writes_exactly_the_lanes_hit() {
        fn pushed<S: Wide>(simd: S, bits: u64) -> Vec<(u32, u32)> {
            let (mut child, mut near) = ([0; 16], [0.0; 16]);
            let links = u32x16::from_fn(simd, |lane| 100 + lane as u32);
            let enter = f32x16::from_fn(simd, |lane| lane as f32 * 0.5);
            let hit = mask32x16::from_bitmask(simd, bits);
            let count = simd.push_hit(links, enter, hit, some_nibbles(), &mut child, &mut near);
            let mut pairs: Vec<_> = (0..count).map(|k| (child[k], near[k].to_bits())).collect();
            pairs.sort_unstable();
            pairs
        }
        for (name, level) in available_levels() {
            for bits in [0, 1, 0x8000, 0x5555, 0xffff, 0x0ff0] {
                let lanes = (0..16).filter(|lane| bits >> lane & 1 != 0);
                let want: Vec<_> = lanes.map(|lane| (100 + lane as u32, (lane as f32 * 0.5).to_bits())).collect();
                assert_eq!(at_level!(level, simd => pushed(simd, bits)), want, "{name} {bits:x}");
            }
        }
    }
}
