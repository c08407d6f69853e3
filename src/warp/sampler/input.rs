//! What every kernel is given: a row of footprints, a pyramid of texels, and the grid of samples of the best quality.

use super::fold::Fold;
use crate::warp::light::Tables;
use crate::warp::pyramid::Level;
use crate::warp::strip::Strip;
use crate::warp::texel::{ByteTexel, LightTexel};
use crate::warp::texture::Texture;

/// The `best` quality's samples in a pixel, as offsets from its centre: a rotated grid, so that near-horizontal and
/// near-vertical edges pass four different distances. Four boxes of half the pixel's side around them have the second
/// moment of the pixel itself (a² + b² = ⅛): measured, that is 1 to 3 dB better than the usual ⅛ and ⅜.
pub const ROTATED_GRID: [[f32; 2]; 4] = {
    let (a, b) = (0.111_803_4, 0.335_410_2);
    [[a, b], [-a, -b], [b, -a], [-b, a]]
};

/// The footprints of pixels that lie beside each other: a row of a strip, or a part of one. Whole groups of four; the last ones
/// may be none.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    pub u: &'a [f32],
    pub v: &'a [f32],
    pub level: &'a [f32],
    pub jacobian: [&'a [f32]; 4],
}

/// Draws a row's pixels from a texture, as many as the bytes are for.
pub type Kernel = fn(&Texture, Fold, Row<'_>, &mut [u8]);

impl<'a> Row<'a> {
    /// Columns `start..end` of the strip's row `row`; a quantity that the strip does not hold is empty.
    pub fn of(strip: &'a Strip, row: usize, start: usize, end: usize) -> Self {
        let first = strip.start(row);
        let part = |plane: &'a Vec<f32>| plane.get(first + start..first + end).unwrap_or_default();
        let [a, b, c, d] = &strip.jacobian;
        Self { u: part(&strip.u), v: part(&strip.v), level: part(&strip.level), jacobian: [a, b, c, d].map(part) }
    }
}

/// A pyramid of one kind of texels.
pub struct Pyramid<'a, T> {
    pub texels: &'a [T],
    pub levels: &'a [Level],
    pub tables: &'static Tables,
}

impl<'a, T: Kind> Pyramid<'a, T> {
    pub fn of(texture: &'a Texture) -> Self {
        Self { texels: T::texels(texture), levels: texture.levels(), tables: texture.light().tables() }
    }
}

/// A kind of texels that textures have.
pub trait Kind: Copy {
    fn texels(texture: &Texture) -> &[Self];
}

impl Kind for ByteTexel {
    fn texels(texture: &Texture) -> &[Self] {
        texture.texels()
    }
}

impl Kind for LightTexel {
    fn texels(texture: &Texture) -> &[Self] {
        texture.light_texels()
    }
}
