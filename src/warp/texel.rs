//! Texels: premultiplied colours, as bytes and as light, and how one becomes the other.

use super::light::{FULL, Tables};

/// Four bytes, premultiplied by the fourth: what is sampled unless light itself is to be interpolated.
pub(super) type ByteTexel = [u8; 4];

/// Light, premultiplied by the fourth channel, 0..=[`FULL`]: what levels are averaged in.
pub(super) type LightTexel = [i16; 4];

/// A pixel with straight alpha → a texel.
pub(super) fn premultiplied(pixel: [u8; 4]) -> ByteTexel {
    let [r, g, b, alpha] = pixel;
    match alpha {
        255 => pixel,
        _ => {
            let covered = |byte: u8| ((u32::from(byte) * u32::from(alpha) + 127) / 255) as u8;
            [covered(r), covered(g), covered(b), alpha]
        }
    }
}

/// Bytes → light.
#[inline(always)]
pub(super) fn decoded([r, g, b, alpha]: ByteTexel, tables: &Tables) -> LightTexel {
    let decode = |byte: u8| tables.decode[usize::from(byte)];
    match alpha {
        255 => [decode(r), decode(g), decode(b), FULL],
        0 => [0; 4],
        _ => {
            let a = i32::from(alpha);
            let covered = |byte: u8| {
                let straight = ((255 * i32::from(byte) + a / 2) / a).min(255) as u8;
                ((i32::from(decode(straight)) * a + 127) / 255) as i16
            };
            [covered(r), covered(g), covered(b), (128 * a) as i16]
        }
    }
}

/// Light → the nearest bytes.
pub(super) fn encoded([r, g, b, alpha]: LightTexel, tables: &Tables) -> ByteTexel {
    let encode = |value: i16| tables.encode[usize::from(value as u16 & 0x7fff)];
    match alpha {
        FULL => [encode(r), encode(g), encode(b), 255],
        0 => [0; 4],
        _ => {
            let (full, a) = (i32::from(FULL), i32::from(alpha));
            let coverage = (a + 64) >> 7;
            let covered = |value: i16| {
                let straight = encode(((i32::from(value) * full + a / 2) / a).min(full) as i16);
                ((i32::from(straight) * coverage + 127) / 255) as u8
            };
            [covered(r), covered(g), covered(b), coverage as u8]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::warp::Light;

    #[test]
    fn bytes_survive_the_way_to_light_and_back() {
        for light in [Light::Linear, Light::Plain] {
            let tables = light.tables();
            for alpha in [0, 1, 7, 100, 254, 255] {
                for byte in 0..=alpha {
                    let texel = [byte, alpha / 2, 0, alpha];
                    assert_eq!(encoded(decoded(texel, tables), tables), texel, "{light:?}");
                }
            }
        }
    }

    #[test]
    fn premultiplied_colors_are_the_nearest() {
        assert_eq!(premultiplied([255, 128, 1, 100]), [100, 50, 0, 100]);
        assert_eq!(premultiplied([9, 8, 7, 255]), [9, 8, 7, 255]);
        assert_eq!(premultiplied([255; 4].map(|_: u8| 200)), [157, 157, 157, 200]);
    }
}
