//! Pictures with hard content, and what a warp of them should look like: brute-force supersampling.

use conformal_warp::{Complex64, Frame, Light, Wrap};

/// A square picture of RGBA bytes.
pub struct Picture {
    pub size: usize,
    pub rgba: Vec<u8>,
}

impl Picture {
    /// Channels from functions of the texel's column and row.
    pub fn new(size: usize, mut rgb: impl FnMut(usize, usize) -> [u8; 3]) -> Self {
        let mut rgba = Vec::with_capacity(4 * size * size);
        for row in 0..size {
            for column in 0..size {
                let [r, g, b] = rgb(column, row);
                rgba.extend([r, g, b, 255]);
            }
        }
        Self { size, rgba }
    }

    /// A checkerboard with squares of `side` texels.
    pub fn checker(size: usize, side: usize) -> Self {
        Self::new(size, |column, row| [if (column / side + row / side) % 2 == 1 { 255 } else { 0 }; 3])
    }
}

/// 24 × 24 box supersampling of a bilinear texture: `shows` gives the plane point of the texture that a point of the
/// view shows, or NaN.
pub struct Truth<'a> {
    pub picture: &'a Picture,
    pub wrap: Wrap,
    pub light: Light,
    /// Samples along each side of a pixel.
    pub samples: usize,
}

pub fn to_light(byte: u8, light: Light) -> f64 {
    let share = f64::from(byte) / 255.0;
    match light {
        Light::Plain => share,
        Light::Linear if share <= 0.04045 => share / 12.92,
        Light::Linear => ((share + 0.055) / 1.055).powf(2.4),
    }
}

pub fn to_byte(light_share: f64, light: Light) -> f64 {
    255.0
        * match light {
            Light::Plain => light_share,
            Light::Linear if light_share <= 0.003_130_8 => 12.92 * light_share,
            Light::Linear => 1.055 * light_share.powf(1.0 / 2.4) - 0.055,
        }
}

impl Truth<'_> {
    /// Exact pixels (straight alpha, unrounded, 0..=255) of the whole view.
    pub fn render(&self, texture: &Frame, view: &Frame, shows: impl Fn(Complex64) -> Complex64) -> Vec<[f64; 4]> {
        let decode: Vec<f64> = (0..=255).map(|byte| to_light(byte, self.light)).collect();
        let [columns, rows] = view.pixels();
        let n = self.samples;
        let offset = |i: usize| (i as f64 + 0.5) / n as f64;
        let mut pixels = Vec::with_capacity(columns * rows);
        for pixel in 0..columns * rows {
            let mut sum = [0.0; 4];
            for sample in 0..n * n {
                let x = (pixel % columns) as f64 + offset(sample % n);
                let y = (pixel / columns) as f64 + offset(sample / n);
                let (u, v) = texture.to_pixels(shows(view.to_plane(x, y)));
                if !u.is_nan() {
                    self.add_bilinear(&mut sum, &decode, u, v);
                }
            }
            let alpha = sum[3] / (n * n) as f64;
            let color = |value: f64| if sum[3] > 0.0 { to_byte(value / sum[3], self.light) } else { 0.0 };
            pixels.push([color(sum[0]), color(sum[1]), color(sum[2]), 255.0 * alpha]);
        }
        pixels
    }

    fn add_bilinear(&self, sum: &mut [f64; 4], decode: &[f64], u: f64, v: f64) {
        let (x0, y0) = ((u - 0.5).floor(), (v - 0.5).floor());
        let (fx, fy) = (u - 0.5 - x0, v - 0.5 - y0);
        for (dx, dy, weight) in [
            (0.0, 0.0, (1.0 - fx) * (1.0 - fy)),
            (1.0, 0.0, fx * (1.0 - fy)),
            (0.0, 1.0, (1.0 - fx) * fy),
            (1.0, 1.0, fx * fy),
        ] {
            if let (Some(column), Some(row)) = (self.texel(x0 + dx), self.texel(y0 + dy)) {
                let at = 4 * (row * self.picture.size + column);
                let alpha = weight * f64::from(self.picture.rgba[at + 3]) / 255.0;
                for channel in 0..3 {
                    sum[channel] += alpha * decode[usize::from(self.picture.rgba[at + channel])];
                }
                sum[3] += alpha;
            }
        }
    }

    fn texel(&self, index: f64) -> Option<usize> {
        let size = self.picture.size as f64;
        let folded = match self.wrap {
            Wrap::Transparent => index,
            Wrap::Clamp => index.clamp(0.0, size - 1.0),
            Wrap::Repeat => index.rem_euclid(size),
            Wrap::Mirror => {
                let t = index.rem_euclid(2.0 * size);
                t.min(2.0 * size - 1.0 - t)
            }
        };
        (folded >= 0.0 && folded < size).then_some(folded as usize)
    }
}

/// Peak signal-to-noise ratio of one channel over the pixels that `select` names, in dB.
pub fn psnr(pixels: &[u8], truth: &[[f64; 4]], channel: usize, select: impl Fn(usize) -> bool) -> f64 {
    let mut sum = 0.0;
    let mut count = 0;
    for (index, exact) in truth.iter().enumerate().filter(|(index, _)| select(*index)) {
        sum += (f64::from(pixels[4 * index + channel]) - exact[channel]).powi(2);
        count += 1;
    }
    assert!(count > 0, "no pixel selected");
    10.0 * (255.0_f64.powi(2) * f64::from(count) / sum).log10()
}

/// A square JPEG of tests/fixtures.
pub fn fixture_photo(name: &str) -> Picture {
    let mut decoder = jpeg_decoder::Decoder::new(std::fs::File::open(super::fixture(name)).expect("the fixture"));
    let rgb = decoder.decode().expect("a JPEG");
    let size = usize::from(decoder.info().expect("decoded").width);
    let pixels = rgb.as_chunks::<3>().0;
    assert_eq!(pixels.len(), size * size, "square");
    Picture::new(size, |column, row| pixels[size * row + column])
}

/// Gaussian noise, blurred by 2 texels and stretched to all bytes; the same every time.
pub fn noise(size: usize) -> Vec<u8> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut uniform = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        ((state >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    };
    let white: Vec<f64> =
        (0..size * size).map(|_| (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos()).collect();
    let blur = |from: &[f64], step: usize| -> Vec<f64> {
        let tap = |at: usize, k: i64| {
            let (place, rest) = (at / step % size, at - at / step % size * step);
            let place = (place as i64 + k).rem_euclid(size as i64) as usize;
            (-0.125 * (k * k) as f64).exp() * from[rest + place * step]
        };
        (0..from.len()).map(|at| (-8..=8).map(|k| tap(at, k)).sum()).collect()
    };
    let soft = blur(&blur(&white, 1), size);
    let (low, high) = soft.iter().fold((f64::MAX, f64::MIN), |(low, high), &t| (low.min(t), high.max(t)));
    soft.iter().map(|t| ((t - low) / (high - low) * 255.0).round() as u8).collect()
}
