//! Wrap modes, as folds of the texture's axes.

#[cfg(target_feature = "simd128")]
use core::arch::wasm32::{f32x4_add, f32x4_floor, f32x4_mul, f32x4_pmax, f32x4_pmin, f32x4_splat, f32x4_sub, v128};

/// A wrap mode as a fold of the texture's axis: any coordinate → one that lies in 0..=`size`, or beyond the edge
/// where there is nothing.
///
/// Chosen anew for every few samples, always the same: a branch that processors foresee costs less than the code of a
/// kernel for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fold {
    /// As it is: the border of the levels shows what is there, if anything.
    Unchanged,
    /// As it is, and the texture ends at its edge, whatever lies in the border of its levels.
    Framed,
    Clamped,
    Repeated,
    Mirrored,
}

impl Fold {
    /// Whether the texture ends at its edge, whatever lies in the border of its levels.
    #[inline(always)]
    pub fn is_framed(self) -> bool {
        self == Self::Framed
    }

    pub fn apply(self, t: f32, size: f32) -> f32 {
        match self {
            Self::Unchanged | Self::Framed => t,
            Self::Clamped => t.clamp(0.0, size),
            Self::Repeated => repeated(t, size),
            Self::Mirrored => {
                let t = repeated(t, 2.0 * size);
                t.min(2.0 * size - t)
            }
        }
    }

    /// Four at once; `reciprocal` = 1 / `size`.
    #[cfg(target_feature = "simd128")]
    #[inline(always)]
    pub fn apply4(self, t: v128, size: v128, reciprocal: v128) -> v128 {
        match self {
            Self::Unchanged | Self::Framed => t,
            Self::Clamped => f32x4_pmin(f32x4_pmax(f32x4_splat(0.0), t), size),
            Self::Repeated => repeated4(t, size, reciprocal),
            Self::Mirrored => {
                let period = f32x4_add(size, size);
                let t = repeated4(t, period, f32x4_mul(reciprocal, f32x4_splat(0.5)));
                f32x4_pmin(t, f32x4_sub(period, t))
            }
        }
    }
}

fn repeated(t: f32, size: f32) -> f32 {
    t - size * (t / size).floor()
}

#[cfg(target_feature = "simd128")]
#[inline(always)]
fn repeated4(t: v128, size: v128, reciprocal: v128) -> v128 {
    f32x4_sub(t, f32x4_mul(size, f32x4_floor(f32x4_mul(t, reciprocal))))
}
