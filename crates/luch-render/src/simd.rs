//! Which instruction set the kernels use. It changes the time of a picture, never a bit of it.

use fearless_simd::{Level, Simd as _};

/// An instruction set that the user may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SimdLevel {
    /// The best that this machine has.
    #[default]
    Auto,
    /// What every machine of the target has without asking, which is what plain scalar code is compiled to: SSE2 on
    /// x86-64, NEON on 64-bit ARM. The picture that all others must equal.
    Scalar,
    /// SSE4.2, 4 lanes.
    Sse42,
    /// AVX2, 8 lanes.
    Avx2,
    /// AVX-512 (Ice Lake set), 16 lanes.
    Avx512,
    /// NEON, 4 lanes.
    Neon,
}

impl SimdLevel {
    /// Every level, in the order of help texts.
    pub const ALL: [Self; 6] = [Self::Auto, Self::Scalar, Self::Sse42, Self::Avx2, Self::Avx512, Self::Neon];

    /// The word for it on the command line.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Scalar => "scalar",
            Self::Sse42 => "sse4.2",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
            Self::Neon => "neon",
        }
    }

    /// The level of that word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|level| level.word() == word)
    }

    /// Whether this machine can run it.
    #[must_use]
    pub fn is_available(self) -> bool {
        self.level().is_some()
    }

    /// The levels that this machine can run, `Auto` left out.
    #[must_use]
    pub fn available() -> Vec<Self> {
        Self::ALL.into_iter().filter(|level| *level != Self::Auto && level.is_available()).collect()
    }

    /// The level that `Auto` stands for on this machine; any other is itself.
    #[must_use]
    pub fn resolved(self) -> Self {
        match self {
            Self::Auto => Self::available().pop().unwrap_or(Self::Scalar),
            other => other,
        }
    }

    /// Proof that the machine has the instruction set; `None` if it has not.
    pub(crate) fn level(self) -> Option<Level> {
        let best = Level::new();
        match self {
            Self::Auto => Some(best),
            Self::Scalar => Some(baseline().level()),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Sse42 => best.as_sse4_2().map(Level::Sse4_2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Avx2 => best.as_avx2().map(Level::Avx2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Avx512 => best.as_avx512().map(Level::Avx512),
            #[cfg(target_arch = "aarch64")]
            Self::Neon => best.as_neon().map(Level::Neon),
            #[allow(unreachable_patterns, reason = "which levels remain depends on the target")]
            _ => None,
        }
    }

    /// As [`SimdLevel::level`], with the best level where the machine lacks the one asked for.
    pub(crate) fn level_or_best(self) -> Level {
        self.level().unwrap_or_else(Level::new)
    }
}

/// Runs `$call` with the token of a level as `$simd`: what `fearless_simd::dispatch` does, for fewer levels.
///
/// Shading is much code in few places. Each level costs seconds of build time, and the emulation of sixteen lanes by
/// arrays costs minutes, so levels below AVX2 share the target's baseline. The bits are the same at every level.
macro_rules! shade_at {
    ($level:expr, $simd:ident => $call:expr) => {
        match $level {
            #[cfg(target_arch = "x86_64")]
            fearless_simd::Level::Avx512($simd) => fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $call,
            ),
            #[cfg(target_arch = "x86_64")]
            fearless_simd::Level::Avx2($simd) => fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $call,
            ),
            _ => {
                let $simd = crate::simd::baseline();
                $call
            }
        }
    };
}
pub(crate) use shade_at;

/// The token of the instruction set that every machine of the target has.
#[cfg(target_arch = "x86_64")]
pub(crate) fn baseline() -> fearless_simd::Sse2 {
    Level::new().as_sse2().unwrap_or_else(|| unreachable!("every x86-64 processor has SSE2"))
}

/// The token of the instruction set that every machine of the target has.
#[cfg(target_arch = "aarch64")]
pub(crate) fn baseline() -> fearless_simd::Neon {
    Level::new().as_neon().unwrap_or_else(|| unreachable!("every 64-bit ARM processor has NEON"))
}

/// The token of the instruction set that every machine of the target has.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
pub(crate) fn baseline() -> fearless_simd::Fallback {
    fearless_simd::Fallback::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read_back_and_scalar_is_always_there() {
        for level in SimdLevel::ALL {
            assert_eq!(SimdLevel::from_word(level.word()), Some(level));
        }
        assert!(SimdLevel::available().contains(&SimdLevel::Scalar));
        assert_ne!(SimdLevel::Auto.resolved(), SimdLevel::Auto);
    }
}
