//! What the `overlay` methods of all maps share.

use super::error::Failure;
use super::options::{self, FrameOptions};
use super::reading::fields;
use super::words::words;
use crate::map::PlaneMap;
use crate::plane::Frame;
use crate::warp::{Overlay, Stroke, WarpOptions, buffer};
use js_sys::Uint8ClampedArray;
use tsify::{Ts, Tsify};

/// What can be drawn over a view whose point p is taken to f(p).
#[derive(Clone, Copy, Debug)]
pub enum OverlayKind {
    /// Lines of constant Re f and Im f.
    Cartesian,
    /// Rays and rings.
    Polar,
    /// One circle around 0.
    Circle,
    /// |f'| as colours.
    Stretch,
    /// arg f as a hue.
    Argument,
}

words! {
    /// What can be drawn over a view whose point p is taken to f(p).
    OverlayKind {
        Cartesian = "cartesian", Polar = "polar", Circle = "circle", Stretch = "stretch", Argument = "argument"
    }
}

/// A drawing that explains a map, to be laid over its picture.
#[derive(Debug, Tsify)]
pub struct OverlayOptions {
    /// "cartesian": lines where Re f or Im f is a multiple of `spacing`. "polar": `spokes` rays of constant arg f, and
    /// the rings that make squares with them. "circle": where |f| is `radius`. "stretch": |f'| as colours, blue below
    /// 1 and red above, over so many `doublings`. "argument": arg f as a hue, red at 0, with waves of |f|.
    pub kind: OverlayKind,
    /// The view that the picture has.
    pub view: FrameOptions,
    /// Distance of the lines of "cartesian", 1 by default.
    #[tsify(optional)]
    pub spacing: Option<f64>,
    /// Number of rays of "polar", 12 by default.
    #[tsify(optional)]
    pub spokes: Option<u32>,
    /// Radius of "circle", 1 by default.
    #[tsify(optional)]
    pub radius: Option<f64>,
    /// How many doublings, up or down, the colours of "stretch" span; 4 by default.
    #[tsify(optional)]
    pub doublings: Option<f64>,
    /// Opacity of "stretch" and "argument", 1 by default.
    #[tsify(optional)]
    pub opacity: Option<f64>,
    /// Width of the lines in pixels, 1.5 by default.
    #[tsify(optional)]
    pub width: Option<f64>,
    /// Colour of the lines, RGBA with 0 … 255 each; translucent white by default.
    #[tsify(optional, type = "[red: number, green: number, blue: number, alpha: number]")]
    pub color: Option<[u8; 4]>,
    /// Pixels to draw over, 4 · columns · rows bytes; transparent ones by default.
    #[tsify(optional, type = "Uint8ClampedArray")]
    pub out: Option<Uint8ClampedArray>,
    /// The band of rows to draw, [first, the one after the last].
    #[tsify(optional, type = "[first: Count, end: Count]")]
    pub rows: Option<[usize; 2]>,
}
fields!(OverlayOptions: kind, view, spacing, spokes, radius, doublings, opacity, width, color, out, rows);

impl OverlayKind {
    const ALL: [Self; 5] = [Self::Cartesian, Self::Polar, Self::Circle, Self::Stretch, Self::Argument];
}

impl OverlayOptions {
    /// The drawing of this kind, all that was given being right, used or not.
    fn checked(&self) -> crate::Result<Overlay> {
        for kind in OverlayKind::ALL {
            self.overlay(kind).check()?;
        }
        Ok(self.overlay(self.kind))
    }

    fn overlay(&self, kind: OverlayKind) -> Overlay {
        let usual = Stroke::default();
        let stroke = Stroke { width: self.width.unwrap_or(usual.width), color: self.color.unwrap_or(usual.color) };
        let opacity = self.opacity.unwrap_or(1.0);
        match kind {
            OverlayKind::Cartesian => Overlay::Cartesian { spacing: self.spacing.unwrap_or(1.0), stroke },
            OverlayKind::Polar => Overlay::Polar { spokes: self.spokes.unwrap_or(12), stroke },
            OverlayKind::Circle => Overlay::Circle { radius: self.radius.unwrap_or(1.0), stroke },
            OverlayKind::Stretch => Overlay::Stretch { doublings: self.doublings.unwrap_or(4.0), opacity },
            OverlayKind::Argument => Overlay::Argument { opacity },
        }
    }
}

/// The drawing's RGBA bytes with straight alpha: over `out`, and that array itself, if it was given.
///
/// # Errors
/// "invalid-option", "invalid-frame", "invalid-rows", "wrong-length".
pub fn draw(map: &dyn PlaneMap, given: &Ts<OverlayOptions>) -> Result<Uint8ClampedArray, Failure> {
    let given = options::read(given)?;
    let overlay = given.checked()?;
    let view: Frame = given.view.try_into()?;
    let rows = given.rows.map(|[first, end]| first..end);
    let mut rgba = match &given.out {
        Some(out) => out.to_vec(),
        None => buffer::blank(WarpOptions { rows: rows.clone(), ..WarpOptions::new(view, view) }.output_size()?)?,
    };
    overlay.draw(map, &view, rows, &mut rgba)?;
    Ok(match given.out {
        Some(out) => {
            out.copy_from(&rgba);
            out
        }
        None => Uint8ClampedArray::from(&rgba[..]),
    })
}
