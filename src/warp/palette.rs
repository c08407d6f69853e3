//! Colours for numbers.

use super::light::linear_to_srgb;

/// A colour in sRGB, each channel in [0, 1], without alpha.
pub type Rgb = [f64; 3];

/// A hue in turns, at even lightness and chroma (OKLCh): all hues look equally bright, so only the argument shows.
///
/// After B. Ottosson, *A perceptual color space for image processing* (2020).
pub fn hue(turns: f64, lightness: f64) -> Rgb {
    /// The largest chroma that every hue can have at these lightnesses.
    const CHROMA: f64 = 0.11;
    // Red at argument 0, as is the custom.
    let (b, a) = (std::f64::consts::TAU * (turns + 0.08)).sin_cos();
    oklab_to_srgb(lightness, CHROMA * a, CHROMA * b)
}

fn oklab_to_srgb(lightness: f64, a: f64, b: f64) -> Rgb {
    let cube = |x: f64| x * x * x;
    let l = cube(lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b);
    let m = cube(lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b);
    let s = cube(lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b);
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ]
    .map(|linear| linear_to_srgb(linear.clamp(0.0, 1.0)))
}

/// −1 … 1 → blue over white to red (ColorBrewer's RdBu, reversed).
pub fn diverging(x: f64) -> Rgb {
    const STOPS: [[u8; 3]; 7] = [
        [33, 102, 172],
        [103, 169, 207],
        [209, 229, 240],
        [247, 247, 247],
        [253, 219, 199],
        [239, 138, 98],
        [178, 24, 43],
    ];
    let position = 3.0 * (x.clamp(-1.0, 1.0) + 1.0);
    let index = (position as usize).min(STOPS.len() - 2);
    let share = position - index as f64;
    std::array::from_fn(|channel| {
        let [low, high] = [index, index + 1].map(|k| f64::from(STOPS[k][channel]) / 255.0);
        low + share * (high - low)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_colours() {
        assert_eq!(diverging(0.0), [247.0 / 255.0; 3]);
        assert_eq!(diverging(-7.0), [33.0 / 255.0, 102.0 / 255.0, 172.0 / 255.0]);
        // White and sRGB red, from Ottosson's table.
        assert!(oklab_to_srgb(1.0, 0.0, 0.0).iter().all(|x| (x - 1.0).abs() < 1e-6));
        let red = oklab_to_srgb(0.627_955, 0.224_863, 0.125_846);
        assert!((red[0] - 1.0).abs() < 1e-3 && red[1] < 2e-3 && red[2] < 2e-3, "{red:?}");
    }

    #[test]
    fn hues_close_up_and_begin_with_red() {
        let (start, end) = (hue(0.0, 0.72), hue(1.0, 0.72));
        assert!(start.iter().zip(end).all(|(a, b)| (a - b).abs() < 1e-12));
        assert!(start[0] > start[1] && start[0] > start[2]);
    }
}
