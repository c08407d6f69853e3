//! Wrap modes, as folds of the texture's axes.

#[cfg(target_feature = "simd128")]
use core::arch::wasm32::{f32x4_add, f32x4_floor, f32x4_mul, f32x4_pmax, f32x4_pmin, f32x4_splat, f32x4_sub, v128};

/// A wrap mode as a fold of the texture's axis: any coordinate → one that lies in 0..=`size`, or beyond the edge
/// where there is nothing.
pub(super) trait Fold {
    /// Whether the texture ends at its edge, whatever lies in the border of its levels.
    const FRAMED: bool = false;

    fn fold(t: f32, size: f32) -> f32;

    /// Four at once; `reciprocal` = 1 / `size`.
    #[cfg(target_feature = "simd128")]
    fn fold4(t: v128, size: v128, reciprocal: v128) -> v128;
}

pub(super) struct Unchanged;
pub(super) struct Framed;
pub(super) struct Clamped;
pub(super) struct Repeated;
pub(super) struct Mirrored;

impl Fold for Unchanged {
    fn fold(t: f32, _: f32) -> f32 {
        t
    }

    #[cfg(target_feature = "simd128")]
    #[inline(always)]
    fn fold4(t: v128, _: v128, _: v128) -> v128 {
        t
    }
}

impl Fold for Framed {
    const FRAMED: bool = true;

    fn fold(t: f32, _: f32) -> f32 {
        t
    }

    #[cfg(target_feature = "simd128")]
    #[inline(always)]
    fn fold4(t: v128, _: v128, _: v128) -> v128 {
        t
    }
}

impl Fold for Clamped {
    fn fold(t: f32, size: f32) -> f32 {
        t.clamp(0.0, size)
    }

    #[cfg(target_feature = "simd128")]
    #[inline(always)]
    fn fold4(t: v128, size: v128, _: v128) -> v128 {
        f32x4_pmin(f32x4_pmax(f32x4_splat(0.0), t), size)
    }
}

impl Fold for Repeated {
    fn fold(t: f32, size: f32) -> f32 {
        t - size * (t / size).floor()
    }

    #[cfg(target_feature = "simd128")]
    #[inline(always)]
    fn fold4(t: v128, size: v128, reciprocal: v128) -> v128 {
        f32x4_sub(t, f32x4_mul(size, f32x4_floor(f32x4_mul(t, reciprocal))))
    }
}

impl Fold for Mirrored {
    fn fold(t: f32, size: f32) -> f32 {
        let t = Repeated::fold(t, 2.0 * size);
        t.min(2.0 * size - t)
    }

    #[cfg(target_feature = "simd128")]
    #[inline(always)]
    fn fold4(t: v128, size: v128, reciprocal: v128) -> v128 {
        let period = f32x4_add(size, size);
        let t = Repeated::fold4(t, period, f32x4_mul(reciprocal, f32x4_splat(0.5)));
        f32x4_pmin(t, f32x4_sub(period, t))
    }
}
