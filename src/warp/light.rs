//! Light: what the numbers of a picture mean, and the tables between its bytes and the texels that filters work on.

use std::sync::OnceLock;

/// The quantity that is averaged when texels become the coarser levels of a texture, and interpolated in the best quality.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Light {
    /// The light itself: bytes are decoded by the sRGB curve (IEC 61966-2-1) first, and encoded at the end.
    #[default]
    Linear,
    /// The bytes as they are.
    Plain,
}

/// The texel value of full light or full alpha: 255 · 128, so that alpha and plain light are exact.
///
/// One sRGB step is at least 9.9 of these units (it is shortest near black), so a texel never loses a level.
pub(crate) const FULL: i16 = 255 * 128;

/// Byte → texel and texel → byte.
pub(crate) struct Tables {
    /// Texel value of each byte, to half a unit.
    pub decode: [i16; 256],
    /// Byte nearest to each texel value 0..=[`FULL`]; as long as 15 bits reach, so that such an index needs no check.
    pub encode: Box<[u8; 1 << 15]>,
}

impl Light {
    /// The tables of this light, made on first use.
    pub(crate) fn tables(self) -> &'static Tables {
        static LINEAR: OnceLock<Tables> = OnceLock::new();
        static PLAIN: OnceLock<Tables> = OnceLock::new();
        match self {
            Self::Linear => LINEAR.get_or_init(|| Tables::new(srgb_to_linear)),
            Self::Plain => PLAIN.get_or_init(|| Tables::new(|share| share)),
        }
    }
}

impl Tables {
    /// `curve`: share of the full byte → share of full light, increasing.
    fn new(curve: impl Fn(f64) -> f64) -> Self {
        let texel_of = |byte: f64| f64::from(FULL) * curve(byte / 255.0);
        let decode = std::array::from_fn(|byte| texel_of(byte as f64).round() as i16);
        let mut encode = Box::new([0; 1 << 15]);
        let mut first = 0;
        for byte in 0..=255_u8 {
            let end = if byte == 255 { encode.len() } else { texel_of(f64::from(byte) + 0.5).ceil() as usize };
            encode[first..end].fill(byte);
            first = end;
        }
        Self { decode, encode }
    }
}

/// IEC 61966-2-1, both sides of it shares of 1.
fn srgb_to_linear(share: f64) -> f64 {
    if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
}

/// Linear light → sRGB, both shares of 1.
pub(super) fn linear_to_srgb(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_exact_to_half_a_level_both_ways() {
        let tables = Light::Linear.tables();
        for byte in 0..=255_u8 {
            let exact = f64::from(FULL) * srgb_to_linear(f64::from(byte) / 255.0);
            assert!((f64::from(tables.decode[byte as usize]) - exact).abs() <= 0.5);
        }
        for (texel, &byte) in tables.encode.iter().enumerate().take(FULL as usize + 1) {
            let exact = 255.0 * linear_to_srgb(texel as f64 / f64::from(FULL));
            // The standard's two pieces meet with a gap of 1e-7: hence the margin.
            assert!((f64::from(byte) - exact).abs() <= 0.5 + 1e-4, "texel {texel}: {byte}, not {exact}");
        }
    }

    #[test]
    fn every_byte_survives_the_round_trip() {
        for light in [Light::Linear, Light::Plain] {
            let tables = light.tables();
            for byte in 0..=255_u8 {
                assert_eq!(tables.encode[tables.decode[byte as usize] as usize], byte);
            }
        }
    }
}
