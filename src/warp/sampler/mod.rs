//! Samplers: footprints of a strip → RGBA bytes.
//!
//! The quality and the wrap mode are chosen once an image; below that everything is one loop a row.

mod scalar;

use super::options::Quality;
use super::strip::Strip;
use super::texture::{Texture, Wrap};

/// The `best` quality's samples in a pixel, as offsets from its centre: a rotated grid, so that near-horizontal and
/// near-vertical edges pass four different distances. Four boxes of half the pixel's side around them have the second
/// moment of the pixel itself (a² + b² = ⅛): measured, that is 1 to 3 dB better than the usual ⅛ and ⅜.
const ROTATED_GRID: [[f32; 2]; 4] = {
    let (a, b) = (0.111_803_4, 0.335_410_2);
    [[a, b], [-a, -b], [b, -a], [-b, a]]
};

/// One row of a strip.
#[derive(Clone, Copy)]
struct Row<'a> {
    u: &'a [f32],
    v: &'a [f32],
    level: &'a [f32],
    jacobian: [&'a [f32]; 4],
}

impl<'a> Row<'a> {
    /// Row `row` of the strip; a quantity that the strip does not hold is empty.
    fn of(strip: &'a Strip, row: usize) -> Self {
        let start = strip.start(row);
        let part = |plane: &'a Vec<f32>| plane.get(start..start + strip.stride).unwrap_or_default();
        let [a, b, c, d] = &strip.jacobian;
        Self { u: part(&strip.u), v: part(&strip.v), level: part(&strip.level), jacobian: [a, b, c, d].map(part) }
    }
}

/// Draws every row of the strip: `out` holds `strip.rows` rows of 4 · `strip.width` bytes.
pub(super) fn sample(texture: &Texture, quality: Quality, strip: &Strip, out: &mut [u8]) {
    match texture.wrap() {
        Wrap::Transparent => sample_wrapped::<Unchanged>(texture, quality, strip, out),
        Wrap::Clamp => sample_wrapped::<Clamped>(texture, quality, strip, out),
        Wrap::Repeat => sample_wrapped::<Repeated>(texture, quality, strip, out),
        Wrap::Mirror => sample_wrapped::<Mirrored>(texture, quality, strip, out),
    }
}

fn sample_wrapped<W: Fold>(texture: &Texture, quality: Quality, strip: &Strip, out: &mut [u8]) {
    let draw = match quality {
        Quality::Nearest => scalar::nearest::<W>,
        Quality::Bilinear => scalar::bilinear::<W>,
        Quality::Trilinear => scalar::trilinear::<W>,
        Quality::Best => scalar::best::<W>,
    };
    for (row, line) in out.chunks_exact_mut(4 * strip.width).enumerate() {
        draw(texture, Row::of(strip, row), line);
    }
}

/// A wrap mode as a fold of the texture's axis: any coordinate → one that lies in 0..=`size`, or beyond the edge
/// where there is nothing.
trait Fold {
    fn fold(t: f32, size: f32) -> f32;
}

struct Unchanged;
struct Clamped;
struct Repeated;
struct Mirrored;

impl Fold for Unchanged {
    fn fold(t: f32, _: f32) -> f32 {
        t
    }
}

impl Fold for Clamped {
    fn fold(t: f32, size: f32) -> f32 {
        t.clamp(0.0, size)
    }
}

impl Fold for Repeated {
    fn fold(t: f32, size: f32) -> f32 {
        t - size * (t / size).floor()
    }
}

impl Fold for Mirrored {
    fn fold(t: f32, size: f32) -> f32 {
        let t = Repeated::fold(t, 2.0 * size);
        t.min(2.0 * size - t)
    }
}
