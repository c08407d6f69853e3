//! A warp whose geometry is done once, for a picture that changes: a camera's frames, a stack of textures.

use super::buffer;
use super::options::{Quality, WarpOptions, Wrap};
use super::render::dim;
use super::sampler::{Row, Sampler};
use super::strip::Strip;
use super::texture::Texture;
use crate::{Error, Result};
use std::ops::Range;

/// For every pixel of a view, the point of a texture that it shows and its footprint there. What shows nothing takes no space,
/// and no time; drawing only samples.
///
/// ```
/// use conformal_warp::{Complex64, FormulaMap, Frame, Light, Texture, Warp, WarpOptions, Wrap};
/// let frame = Frame::new(Complex64::new(0.0, 0.0), 2.0, [64, 48])?;
/// let mut texture = Texture::new(&[0; 4 * 64 * 48], 64, 48, Wrap::Transparent, Light::Linear)?;
/// let prepared = FormulaMap::new("z^2")?.prepare(&texture, &WarpOptions::new(frame, frame))?;
/// let mut out = vec![0; 4 * 64 * 48];
/// for shade in [10, 20, 30] {
///     texture.replace(&[shade; 4 * 64 * 48])?;
///     prepared.warp_into(&texture, &mut out)?;
/// }
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PreparedWarp {
    /// Columns and rows that are drawn.
    size: [usize; 2],
    quality: Quality,
    /// The textures that it is good for.
    texture: ([usize; 2], Wrap),
    /// Whether these end at their frames, whatever their wrap mode.
    framed: bool,
    spans: Vec<Span>,
    footprints: Footprints,
    /// Pixels of which only a share shows something.
    shares: Vec<(usize, f32)>,
}

/// Pixels beside each other that show something.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    /// The first of them, counted through the rows that are drawn.
    pub pixel: usize,
    /// The number of pixels.
    pub count: usize,
    /// Where their footprints begin.
    start: usize,
}

impl Span {
    /// The bytes of its pixels.
    pub fn bytes(&self) -> Range<usize> {
        4 * self.pixel..4 * (self.pixel + self.count)
    }
}

/// Footprints as in a [`Strip`]: each span's in whole groups of four.
#[derive(Clone, Debug, Default)]
struct Footprints {
    u: Vec<f32>,
    v: Vec<f32>,
    level: Vec<f32>,
    jacobian: [Vec<f32>; 4],
}

/// The part of the plane of texels, [left, top] to [right, bottom], beyond which there is nothing to show.
#[derive(Clone, Copy, Debug)]
struct Reach([[f32; 2]; 2]);

impl Reach {
    /// Where a texture shows something.
    fn of(texture: &Texture, framed: bool) -> Self {
        match texture.wrap() {
            _ if framed => Self::of_frame(texture),
            Wrap::Transparent => Self::of_frame(texture),
            Wrap::Clamp | Wrap::Repeat | Wrap::Mirror => Self([[f32::NEG_INFINITY; 2], [f32::INFINITY; 2]]),
        }
    }

    fn of_frame(texture: &Texture) -> Self {
        Self([[0.0; 2], texture.size().map(|n| n as f32)])
    }

    /// Whether the pixel's footprint reaches in: a sampler reads half a texel of the coarser level around it, a texel at most.
    fn meets(&self, strip: &Strip, pixel: usize) -> bool {
        let margin = strip.level.get(pixel).map_or(1.0, |level| 1.0 + 2.0 * level.max(0.0).exp2());
        let [low, high] = self.0;
        let within = |t: f32, axis: usize| t >= low[axis] - margin && t <= high[axis] + margin;
        within(strip.u[pixel], 0) && within(strip.v[pixel], 1)
    }
}

impl PreparedWarp {
    /// Keeps the footprints of strips, which are those of textures like this one.
    pub(super) fn record(
        texture: &Texture,
        framed: bool,
        options: &WarpOptions,
        strips: impl FnOnce(&mut dyn FnMut(&Strip)) -> Result<()>,
    ) -> Result<Self> {
        let (first_row, reach) = (options.checked_rows()?.start, Reach::of(texture, framed));
        let mut prepared = Self {
            size: options.output_size()?,
            quality: options.quality,
            texture: (texture.size(), texture.wrap()),
            framed,
            spans: Vec::new(),
            footprints: Footprints::default(),
            shares: Vec::new(),
        };
        strips(&mut |strip| prepared.add(strip, strip.first_row - first_row, reach))?;
        Ok(prepared)
    }

    fn add(&mut self, strip: &Strip, first_row: usize, reach: Reach) {
        let [width, _] = self.size;
        for row in 0..strip.rows {
            let shown = |column: usize| reach.meets(strip, strip.start(row) + column);
            let mut column = 0;
            while let Some(first) = (column..width).find(|&column| shown(column)) {
                column = (first..width).find(|&column| !shown(column)).unwrap_or(width);
                let start = self.footprints.u.len();
                self.spans.push(Span { pixel: (first_row + row) * width + first, count: column - first, start });
                self.footprints.extend(strip, strip.start(row) + first..strip.start(row) + column);
            }
        }
        let shown = |&&(row, column, _): &&(usize, usize, f32)| reach.meets(strip, strip.start(row) + column);
        let pixel = |&(row, column, share): &(usize, usize, f32)| ((first_row + row) * width + column, share);
        self.shares.extend(strip.shares.iter().filter(shown).map(pixel));
    }

    /// [columns, rows] of what it draws.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Bytes that it holds.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let Footprints { u, v, level, jacobian } = &self.footprints;
        let numbers = u.len() + v.len() + level.len() + jacobian.iter().map(Vec::len).sum::<usize>();
        size_of::<f32>() * numbers + size_of_val(&self.spans[..]) + size_of_val(&self.shares[..])
    }

    /// The texture as the map shows it: RGBA bytes with straight alpha.
    ///
    /// # Errors
    /// [`Error::OtherTexture`] for one of another size or wrap mode than the one that it was prepared with.
    pub fn warp(&self, texture: &Texture) -> Result<Vec<u8>> {
        let mut out = buffer::blank(self.size)?;
        self.warp_into(texture, &mut out)?;
        Ok(out)
    }

    /// [`PreparedWarp::warp`], into `out`. Every byte of it is written.
    ///
    /// # Errors
    /// As [`PreparedWarp::warp`], and [`Error::WrongLength`] if `out` does not fit.
    pub fn warp_into(&self, texture: &Texture, out: &mut [u8]) -> Result<()> {
        self.check(texture)?;
        let sampler = Sampler::new(texture, self.framed, self.quality)?;
        self.fill(out, |row, line| sampler.row(texture, row, line))
    }

    /// # Errors
    /// [`Error::OtherTexture`] for one of another size or wrap mode than the one that it was prepared with.
    pub(super) fn check(&self, texture: &Texture) -> Result<()> {
        let (expected, found) = (self.texture.0, texture.size());
        let same = (found, texture.wrap()) == self.texture;
        if same { Ok(()) } else { Err(Error::OtherTexture { expected, found }) }
    }

    /// Fills `out` span by span, and what lies between with nothing.
    pub(super) fn fill(&self, out: &mut [u8], mut draw: impl FnMut(Row<'_>, &mut [u8])) -> Result<()> {
        buffer::check("The output", out.len(), self.size)?;
        let mut done = 0;
        for span in &self.spans {
            let bytes = span.bytes();
            out[done..bytes.start].fill(0);
            draw(self.footprints.row(span), &mut out[bytes.clone()]);
            done = bytes.end;
        }
        out[done..].fill(0);
        for &(pixel, share) in &self.shares {
            dim(&mut out[4 * pixel + 3], share);
        }
        Ok(())
    }

    pub(super) fn quality(&self) -> Quality {
        self.quality
    }

    pub(super) fn is_framed(&self) -> bool {
        self.framed
    }
}

impl Footprints {
    /// Adds those of a part of a strip, and none at all up to a whole group of four.
    fn extend(&mut self, strip: &Strip, part: Range<usize>) {
        let rest = part.len().next_multiple_of(4) - part.len();
        let Self { u, v, level, jacobian } = self;
        let planes = [(u, &strip.u), (v, &strip.v), (level, &strip.level)];
        for (plane, from) in planes.into_iter().chain(jacobian.iter_mut().zip(&strip.jacobian)) {
            if !from.is_empty() {
                plane.extend_from_slice(&from[part.clone()]);
                plane.extend(std::iter::repeat_n(f32::NAN, rest));
            }
        }
    }

    fn row(&self, span: &Span) -> Row<'_> {
        let groups = span.start..span.start + span.count.next_multiple_of(4);
        let [u, v, level] = [&self.u, &self.v, &self.level].map(|plane| plane.get(groups.clone()).unwrap_or_default());
        Row {
            u,
            v,
            level,
            jacobian: self.jacobian.each_ref().map(|plane| plane.get(groups.clone()).unwrap_or_default()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::FormulaMap;
    use crate::map::PlaneMap;
    use crate::plane::{Complex64, Frame};
    use crate::warp::{Direction, Light, TriangleMesh, Warp};

    const SIZE: [usize; 2] = [37, 29];

    fn picture(seed: usize) -> Vec<u8> {
        let pixel = |k: usize| {
            [(k * 7 + seed) as u8, (k / 3) as u8, (k * seed) as u8, if k.is_multiple_of(11) { 90 } else { 255 }]
        };
        (0..SIZE[0] * SIZE[1]).flat_map(pixel).collect()
    }

    fn frame(width: f64, pixels: [usize; 2]) -> Frame {
        Frame::new(Complex64::new(0.1, -0.05), width, pixels).unwrap()
    }

    /// Another picture, drawn by what the first one's warp prepared, is what the whole warp draws.
    fn check(map: &impl Warp, wrap: Wrap, options: &WarpOptions) {
        let mut texture = Texture::new(&picture(1), SIZE[0], SIZE[1], wrap, Light::Linear).unwrap();
        let prepared = map.prepare(&texture, options).unwrap();
        for seed in [1, 5] {
            texture.replace(&picture(seed)).unwrap();
            let expected = map.warp(&texture, options).unwrap();
            assert!(expected.iter().any(|&byte| byte > 0));
            assert!(prepared.warp(&texture).unwrap() == expected, "{wrap:?}, {options:?}");
        }
    }

    #[test]
    fn draws_what_the_warp_draws() {
        let (texture, view) = (frame(2.0, SIZE), frame(3.0, [71, 53]));
        let square = FormulaMap::new("z^2 + 0.3 conj(z)").unwrap();
        let nodes = [(-1.0, -0.7), (0.8, -0.9), (0.9, 0.8), (-0.6, 0.9)].map(|(x, y)| Complex64::new(x, y));
        let target = nodes.map(|z| 0.8 * z * z + z);
        let mesh = TriangleMesh { source: &nodes, target: &target, triangles: &[[0, 1, 2], [0, 2, 3]], stretch: None };
        for quality in [Quality::Nearest, Quality::Bilinear, Quality::Trilinear, Quality::Best] {
            for wrap in [Wrap::Transparent, Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
                let options = WarpOptions { quality, rows: Some(9..50), ..WarpOptions::new(texture, view) };
                check(&square, wrap, &options);
                let forward = WarpOptions { direction: Direction::PushForward, ..options };
                check(&square, wrap, &forward);
                check(&mesh, wrap, &forward);
            }
        }
    }

    /// The unit disk, and nothing beyond it.
    struct Disk;

    impl PlaneMap for Disk {
        fn jets(&self, points: &[Complex64], jets: &mut [crate::map::Jet]) {
            FormulaMap::new("z").unwrap().jets(points, jets);
            for (point, jet) in points.iter().zip(jets) {
                if point.norm() > 1.0 {
                    *jet = crate::map::Jet::UNDEFINED;
                }
            }
        }
    }

    #[test]
    fn what_shows_nothing_takes_no_space() {
        let view = frame(4.0, [200, 200]);
        let options = WarpOptions::new(frame(0.5, SIZE), view);
        let of_picture = |wrap| {
            let texture = Texture::new(&picture(1), SIZE[0], SIZE[1], wrap, Light::Linear).unwrap();
            check(&Disk, wrap, &options);
            Disk.prepare(&texture, &options).unwrap().bytes()
        };
        // Of 40 000 pixels of 12 bytes, the disk has 7 854, the picture 490.
        let (clamped, transparent) = (of_picture(Wrap::Clamp), of_picture(Wrap::Transparent));
        assert!(clamped > 7_854 * 12 && clamped < 9_000 * 12, "{clamped} bytes");
        assert!(transparent > 490 * 12 && transparent < 1_200 * 12, "{transparent} bytes");
    }

    #[test]
    fn other_textures_and_lengths_are_refused() {
        let texture = |size: [usize; 2], wrap| {
            Texture::new(&vec![1; 4 * size[0] * size[1]], size[0], size[1], wrap, Light::Linear).unwrap()
        };
        let options = WarpOptions::new(frame(2.0, SIZE), frame(2.0, [8, 8]));
        let prepared = Disk.prepare(&texture(SIZE, Wrap::Clamp), &options).unwrap();
        for other in [texture([37, 30], Wrap::Clamp), texture(SIZE, Wrap::Repeat)] {
            assert_eq!(prepared.warp(&other).unwrap_err().code(), "other-texture");
        }
        let short = prepared.warp_into(&texture(SIZE, Wrap::Clamp), &mut [0; 255]);
        assert_eq!(short.unwrap_err().code(), "wrong-length");
        assert_eq!(texture(SIZE, Wrap::Clamp).replace(&[0; 12]).unwrap_err().code(), "wrong-length");
    }
}
