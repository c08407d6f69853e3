//! Drawings that explain a map, laid over the view: coordinate grids pulled back, stretch, argument.
//!
//! Lines are level sets of a real function u of f(p). Their distance in pixels is the distance in u divided by |∇u|, which
//! the map's exact derivative gives: so every line is as wide as asked for, wherever the map takes it.

use super::buffer;
use super::palette::{self, Rgb};
use crate::map::{Jet, PlaneMap};
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};
use std::f64::consts::{LN_2, TAU};
use std::ops::Range;

/// What to draw over a view whose point p is taken to f(p).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Overlay {
    /// Lines where Re f or Im f is a multiple of `spacing`.
    Cartesian {
        /// Distance of the lines, in units of f.
        spacing: f64,
        /// How the lines look.
        stroke: Stroke,
    },
    /// Where arg f is a multiple of 2π/`spokes`, and the rings that make squares with them, |f| = 1 being one.
    Polar {
        /// Number of rays.
        spokes: u32,
        /// How the lines look.
        stroke: Stroke,
    },
    /// Where |f| is `radius`.
    Circle {
        /// The radius, in units of f.
        radius: f64,
        /// How the line looks.
        stroke: Stroke,
    },
    /// How much f stretches at most, |f'| where it is analytic: blue below 1, white at 1, red above.
    Stretch {
        /// How many doublings, up or down, the colours span.
        doublings: f64,
        /// Opacity, 0 … 1.
        opacity: f64,
    },
    /// arg f as a hue (red at 0, then yellow, green, blue), |f| as waves of lightness, one a doubling.
    Argument {
        /// Opacity, 0 … 1.
        opacity: f64,
    },
}

/// How lines look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Width in pixels.
    pub width: f64,
    /// Straight RGBA.
    pub color: [u8; 4],
}

impl Default for Stroke {
    fn default() -> Self {
        Self { width: 1.5, color: [255, 255, 255, 200] }
    }
}

impl Overlay {
    /// Lays the drawing over `rgba`, the straight-alpha pixels of the view's `rows` (all of them by default). Where the map
    /// is not defined nothing is drawn.
    ///
    /// ```
    /// use conformal_warp::{Complex64, FormulaMap, Frame, Overlay, Stroke};
    /// let view = Frame::new(Complex64::ZERO, 4.0, [64, 64])?;
    /// let mut rgba = vec![0; 4 * 64 * 64];
    /// let grid = Overlay::Cartesian { spacing: 0.5, stroke: Stroke::default() };
    /// grid.draw(&FormulaMap::new("z^2")?, &view, None, &mut rgba)?;
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongLength`], [`Error::InvalidRows`], and [`Error::InvalidOption`] for a spacing, count, width or radius
    /// that is not positive or an opacity outside 0 … 1.
    pub fn draw(&self, map: &dyn PlaneMap, view: &Frame, rows: Option<Range<usize>>, rgba: &mut [u8]) -> Result<()> {
        self.check()?;
        let [columns, height] = view.pixels();
        let rows = rows.unwrap_or(0..height);
        if rows.start > rows.end || rows.end > height {
            return Err(Error::InvalidRows { start: rows.start, end: rows.end, height });
        }
        buffer::check("The overlay", rgba.len(), [columns, rows.len()])?;
        let mut points = vec![Complex64::ZERO; columns];
        let mut jets = vec![Jet::UNDEFINED; columns];
        for (row, line) in rows.zip(rgba.chunks_exact_mut(4 * columns)) {
            for (column, point) in points.iter_mut().enumerate() {
                *point = view.to_plane(column as f64 + 0.5, row as f64 + 0.5);
            }
            map.jets(&points, &mut jets);
            for (jet, pixel) in jets.iter().zip(line.as_chunks_mut().0) {
                let (color, opacity) = self.paint(jet, view.pixel_size());
                lay_over(pixel, color, opacity);
            }
        }
        Ok(())
    }

    /// Colour and opacity at a pixel `size` plane units wide.
    fn paint(&self, jet: &Jet, size: f64) -> (Rgb, f64) {
        if !jet.value.is_finite() {
            return ([0.0; 3], 0.0);
        }
        match *self {
            Self::Cartesian { spacing, stroke } => {
                let lines = [RealFunction::real(jet), RealFunction::imaginary(jet)]
                    .map(|u| u.lines(spacing, size, stroke.width));
                stroke.paint(union(lines))
            }
            Self::Polar { spokes, stroke } => {
                let step = TAU / f64::from(spokes);
                let lines = [RealFunction::log_modulus(jet), RealFunction::argument(jet)]
                    .map(|u| u.lines(step, size, stroke.width));
                stroke.paint(union(lines))
            }
            Self::Circle { radius, stroke } => {
                stroke.paint(RealFunction::log_modulus(jet).line(radius.ln(), size, stroke.width))
            }
            Self::Stretch { doublings, opacity } => {
                let stretch = jet.stretch();
                if stretch.is_nan() {
                    ([0.0; 3], 0.0)
                } else {
                    (palette::diverging(stretch.log2() / doublings), opacity)
                }
            }
            Self::Argument { opacity } => (argument_color(jet, size), opacity),
        }
    }

    /// Whether it can be drawn.
    ///
    /// # Errors
    /// [`Error::InvalidOption`].
    pub(crate) fn check(&self) -> Result<()> {
        let positive = |name, value: f64| {
            let valid = value.is_finite() && value > 0.0;
            if valid { Ok(()) } else { Err(Error::InvalidOption { name, expected: "a positive number", value }) }
        };
        let share = |value: f64| {
            let valid = (0.0..=1.0).contains(&value);
            if valid {
                Ok(())
            } else {
                Err(Error::InvalidOption { name: "opacity", expected: "between 0 and 1", value })
            }
        };
        match *self {
            Self::Cartesian { spacing, stroke } => {
                positive("spacing", spacing)?;
                positive("width", stroke.width)
            }
            Self::Polar { spokes, stroke } => {
                positive("spokes", f64::from(spokes))?;
                positive("width", stroke.width)
            }
            Self::Circle { radius, stroke } => {
                positive("radius", radius)?;
                positive("width", stroke.width)
            }
            Self::Stretch { doublings, opacity } => {
                positive("doublings", doublings)?;
                share(opacity)
            }
            Self::Argument { opacity } => share(opacity),
        }
    }
}

impl Stroke {
    fn paint(&self, coverage: f64) -> (Rgb, f64) {
        let [r, g, b, alpha] = self.color.map(|byte| f64::from(byte) / 255.0);
        ([r, g, b], alpha * coverage)
    }
}

/// A real function at a pixel: its value and the length of its gradient in plane units.
#[derive(Clone, Copy)]
struct RealFunction {
    value: f64,
    gradient: f64,
}

impl RealFunction {
    fn real(jet: &Jet) -> Self {
        Self::new(jet.value.re, Complex64::ONE, jet)
    }

    fn imaginary(jet: &Jet) -> Self {
        Self::new(jet.value.im, -Complex64::I, jet)
    }

    fn log_modulus(jet: &Jet) -> Self {
        Self::new(jet.value.norm().ln(), jet.value.inv(), jet)
    }

    fn argument(jet: &Jet) -> Self {
        Self::new(jet.value.arg(), -Complex64::I * jet.value.inv(), jet)
    }

    /// u with du = Re(w df) = Re((w ∂f + conj(w ∂̄f)) dz).
    fn new(value: f64, w: Complex64, jet: &Jet) -> Self {
        Self { value, gradient: (w * jet.dz + (w * jet.dzbar).conj()).norm() }
    }

    /// Coverage of a pixel by the lines u = k·spacing. Lines that would run together fade out instead of beating
    /// with the pixels.
    fn lines(self, spacing: f64, size: f64, width: f64) -> f64 {
        let nearest = spacing * (self.value / spacing).round();
        let apart = spacing / (self.gradient * size);
        let fade = ((apart - 2.0 * width) / (4.0 * width)).clamp(0.0, 1.0);
        if fade > 0.0 { fade * self.line(nearest, size, width) } else { 0.0 }
    }

    /// Coverage of a pixel by the line u = level, `width` pixels wide.
    fn line(self, level: f64, size: f64, width: f64) -> f64 {
        let distance = (self.value - level).abs() / (self.gradient * size);
        // A thin line covers less than a pixel, also where it goes through its middle. NaN (a critical point on
        // the line) counts as on it.
        let reach = 0.5 * width.max(1.0) + 0.5;
        let coverage = if distance.is_nan() { 1.0 } else { (reach - distance).clamp(0.0, 1.0) };
        coverage * width.min(1.0)
    }
}

/// Coverage by either of two lines.
fn union([a, b]: [f64; 2]) -> f64 {
    a + b - a * b
}

fn argument_color(jet: &Jet, size: f64) -> Rgb {
    let level = RealFunction::log_modulus(jet);
    // Waves shorter than a few pixels would alias.
    let wavelength = LN_2 / (level.gradient * size);
    let depth = 0.07 * ((wavelength - 3.0) / 6.0).clamp(0.0, 1.0);
    let wave = if depth > 0.0 { depth * (TAU * level.value / LN_2).cos() } else { 0.0 };
    palette::hue(jet.value.arg() / TAU, 0.74 + wave)
}

/// Source over, both with straight alpha.
fn lay_over(pixel: &mut [u8; 4], color: Rgb, opacity: f64) {
    if opacity <= 0.0 || opacity.is_nan() {
        return;
    }
    let below = f64::from(pixel[3]) / 255.0 * (1.0 - opacity);
    let alpha = opacity + below;
    for (byte, above) in pixel.iter_mut().zip(color) {
        let mixed = (255.0 * above * opacity + f64::from(*byte) * below) / alpha;
        *byte = (mixed + 0.5) as u8;
    }
    pixel[3] = (255.0 * alpha + 0.5) as u8;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::FormulaMap;

    fn draw(overlay: Overlay, formula: &str, width: f64, pixels: usize) -> Vec<u8> {
        let view = Frame::new(Complex64::ZERO, width, [pixels, pixels]).unwrap();
        let mut rgba = vec![0; 4 * pixels * pixels];
        overlay.draw(&FormulaMap::new(formula).unwrap(), &view, None, &mut rgba).unwrap();
        rgba
    }

    fn alpha_total(rgba: &[u8]) -> f64 {
        rgba.as_chunks::<4>().0.iter().map(|pixel| f64::from(pixel[3]) / 255.0).sum()
    }

    const OPAQUE: Stroke = Stroke { width: 3.0, color: [10, 20, 30, 255] };

    #[test]
    fn lines_are_as_wide_as_asked_however_the_map_stretches() {
        for width in [0.5, 1.0, 3.0] {
            let stroke = Stroke { width, ..OPAQUE };
            // |f| = 1 pulled back is a circle of radius r in the view: its area is its circumference times the width.
            for (formula, r) in [("z", 1.0), ("7z", 1.0 / 7.0), ("z^3", 1.0), ("conj(z)^2", 1.0)] {
                let rgba = draw(Overlay::Circle { radius: 1.0, stroke }, formula, 2.5 * r, 300);
                let circumference = TAU * 120.0;
                let measured = alpha_total(&rgba) / circumference;
                assert!((measured / width - 1.0).abs() < 0.02, "{formula}, width {width}: {measured}");
            }
        }
    }

    #[test]
    fn grids_have_the_lines_they_should() {
        // Four lines each way in a view 4 units wide, with the crossings counted once.
        let rgba = draw(Overlay::Cartesian { spacing: 1.0, stroke: OPAQUE }, "z + (1+i)/2", 4.0, 200);
        assert!((alpha_total(&rgba) - (8.0 * 3.0 * 200.0 - 16.0 * 9.0)).abs() < 20.0, "{}", alpha_total(&rgba));
        // In the logarithm's plane a polar grid is a Cartesian one.
        let polar = draw(Overlay::Polar { spokes: 16, stroke: OPAQUE }, "exp(z)", 2.0, 200);
        let cartesian = draw(Overlay::Cartesian { spacing: TAU / 16.0, stroke: OPAQUE }, "z", 2.0, 200);
        let differing = polar.iter().zip(&cartesian).filter(|(a, b)| a.abs_diff(**b) > 1).count();
        assert_eq!(differing, 0);
    }

    #[test]
    fn lines_too_dense_to_tell_apart_are_not_drawn() {
        let rgba = draw(Overlay::Cartesian { spacing: 0.01, stroke: OPAQUE }, "z", 4.0, 200);
        assert_eq!(alpha_total(&rgba), 0.0);
    }

    #[test]
    fn stretch_and_argument_have_their_colours() {
        let at = |rgba: &[u8], x: usize, y: usize| <[u8; 4]>::try_from(&rgba[4 * (y * 64 + x)..][..4]).unwrap();
        let heat = |formula| at(&draw(Overlay::Stretch { doublings: 2.0, opacity: 1.0 }, formula, 2.0, 64), 5, 9);
        assert_eq!(
            [heat("z"), heat("4z"), heat("conj(z)/4")],
            [[247, 247, 247, 255], [178, 24, 43, 255], [33, 102, 172, 255]]
        );
        let phase = draw(Overlay::Argument { opacity: 1.0 }, "z^2", 2.0, 64);
        // z² has the same argument at opposite points, and red on the real axis.
        assert_eq!(at(&phase, 10, 20), at(&phase, 53, 43));
        let [r, g, b, _] = at(&phase, 60, 31);
        assert!(r > g && r > b);
        assert_eq!(at(&draw(Overlay::Argument { opacity: 1.0 }, "0/0 + z", 2.0, 64), 3, 3), [0; 4]);
    }

    #[test]
    fn drawing_goes_over_what_is_there() {
        let view = Frame::new(Complex64::ZERO, 2.0, [8, 8]).unwrap();
        let map = FormulaMap::new("z").unwrap();
        let mut rgba = [100, 100, 100, 255].repeat(2 * 8);
        Overlay::Stretch { doublings: 1.0, opacity: 0.5 }.draw(&map, &view, Some(3..5), &mut rgba).unwrap();
        assert_eq!(rgba[..4], [174, 174, 174, 255]);
        let bad = Overlay::Stretch { doublings: 1.0, opacity: 1.5 }.draw(&map, &view, Some(3..5), &mut rgba);
        assert_eq!(bad.unwrap_err().code(), "invalid-option");
        let bad = Overlay::Argument { opacity: 0.5 }.draw(&map, &view, Some(3..9), &mut rgba);
        assert_eq!(bad.unwrap_err().code(), "invalid-rows");
        let bad = Overlay::Argument { opacity: 0.5 }.draw(&map, &view, None, &mut rgba);
        assert_eq!(bad.unwrap_err().code(), "wrong-length");
    }
}
