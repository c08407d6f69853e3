//! V1 of one hemisphere, whichever way its map was made.

use super::model::twice_area;
use super::remembered::{Memory, Remembered};
use super::view::UpsideDown;
use super::{CorticalModel, Degrees, Gaze, Mirrored, OutlineView, RetinoCorticalMap};
use crate::map::{Compose, Inverse, InvertibleMap, Jet, PlaneMap};
use crate::plane::{Complex64, Frame, Region};
use crate::{Error, Result};
use std::fmt;
use std::rc::Rc;

/// The two halves of the brain. Each sees the opposite half of the visual field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hemisphere {
    /// Sees the right half of the field.
    #[default]
    Left,
    /// Sees the left half: the mirror image of the other.
    Right,
}

/// Visual field → V1: E·e^{iθ} in degrees to the cortex plane in millimetres.
#[derive(Clone)]
pub struct VisualCortex {
    map: Rc<dyn InvertibleMap>,
    hemisphere: Hemisphere,
    /// Counter-clockwise, in millimetres.
    outline: Rc<[Complex64]>,
    /// Of cortex → field coordinate, for eyes that move.
    memory: Memory,
}

/// Vertices of a model's outline.
const MODEL_VERTICES: usize = 720;

/// Cortex → picture: what each point of the cortex sees. A warp that pulls back by it draws the cortical image.
pub type CorticalImage = Compose<Inverse<Gaze>, Remembered<Compose<Inverse<Degrees>, Inverse<VisualCortex>>>>;

impl VisualCortex {
    /// The cortex of a closed formula.
    #[must_use]
    pub fn from_model(model: CorticalModel, hemisphere: Hemisphere) -> Self {
        Self::of_left(model, model.outline(MODEL_VERTICES), hemisphere)
    }

    /// The cortex of a region, which is the outline of a left hemisphere, by the conformal map of the half disk onto it.
    #[must_use]
    pub fn from_outline<M>(map: RetinoCorticalMap<M>, region: &Region, hemisphere: Hemisphere) -> Self
    where
        RetinoCorticalMap<M>: InvertibleMap + 'static,
    {
        let outline = region.boundary().to_vec();
        Self::of_left(Compose { outer: map, inner: Degrees.inverted() }, outline, hemisphere)
    }

    /// [`VisualCortex::from_outline`] of an outline that is seen from the side that `view` says. The map's landmark must have
    /// been given as [`OutlineView::coordinate`] has it.
    #[must_use]
    pub fn from_view<M>(map: RetinoCorticalMap<M>, region: &Region, view: OutlineView, hemisphere: Hemisphere) -> Self
    where
        RetinoCorticalMap<M>: InvertibleMap + 'static,
    {
        match view {
            OutlineView::Mirrored => Self::from_outline(map, region, hemisphere),
            OutlineView::Pial => {
                let upright = Compose { outer: map, inner: Degrees.inverted() };
                Self::of_left(UpsideDown(upright), region.boundary().to_vec(), hemisphere)
            }
        }
    }

    fn of_left(map: impl InvertibleMap + 'static, outline: Vec<Complex64>, hemisphere: Hemisphere) -> Self {
        let memory = Memory::default();
        match hemisphere {
            Hemisphere::Left => Self { map: Rc::new(map), hemisphere, outline: outline.into(), memory },
            Hemisphere::Right => {
                let outline = outline.iter().rev().map(|w| Complex64::new(-w.re, w.im)).collect();
                Self { map: Rc::new(Mirrored(map)), hemisphere, outline, memory }
            }
        }
    }

    /// The outline of the cortex as a polygon, counter-clockwise in millimetres.
    #[must_use]
    pub fn outline(&self) -> &[Complex64] {
        &self.outline
    }

    /// The area of the cortex, in mm².
    #[must_use]
    pub fn area(&self) -> f64 {
        0.5 * twice_area(&self.outline)
    }

    /// The frame around the cortex with so many pixels a millimetre.
    ///
    /// # Errors
    /// [`Error::InvalidOption`](crate::Error::InvalidOption) unless that is positive and makes 8192 pixels a side at most.
    pub fn frame(&self, dots_per_millimetre: f64) -> Result<Frame> {
        let corner = |least: fn(f64, f64) -> f64| {
            self.outline.iter().copied().reduce(|a, b| Complex64::new(least(a.re, b.re), least(a.im, b.im)))
        };
        let (low, high) = (corner(f64::min).unwrap_or_default(), corner(f64::max).unwrap_or_default());
        let dots = [high.re - low.re, high.im - low.im].map(|length| (length * dots_per_millimetre).ceil());
        if !dots.iter().all(|dots| (1.0..=8192.0).contains(dots)) {
            let expected = "positive, and such that the cortex has 8192 pixels a side at most";
            return Err(Error::InvalidOption { name: "dots_per_millimetre", expected, value: dots_per_millimetre });
        }
        Frame::new(0.5 * (low + high), dots[0] / dots_per_millimetre, dots.map(|dots| dots as usize))
    }

    /// The half of the brain that it is.
    #[must_use]
    pub fn hemisphere(&self) -> Hemisphere {
        self.hemisphere
    }

    /// Cortical magnification at points of the field, in mm per degree: the largest over all directions.
    #[must_use]
    pub fn magnification(&self, field: &[Complex64]) -> Vec<f64> {
        let mut jets = vec![Jet::UNDEFINED; field.len()];
        self.jets(field, &mut jets);
        jets.iter().map(Jet::stretch).collect()
    }

    /// What this cortex sees of a picture through an eye. Where its points look is remembered: the next eye costs less.
    #[must_use]
    pub fn seeing(&self, gaze: Gaze) -> CorticalImage {
        let field = Compose { outer: Degrees.inverted(), inner: self.clone().inverted() };
        Compose { outer: gaze.inverted(), inner: Remembered::new(field, self.memory.clone()) }
    }
}

impl fmt::Debug for VisualCortex {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("VisualCortex").field("hemisphere", &self.hemisphere).finish_non_exhaustive()
    }
}

impl PlaneMap for VisualCortex {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.map.jets(points, jets);
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for VisualCortex {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.map.inverse_jets(points, jets);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cortex::FieldPoint;

    fn values(map: &impl PlaneMap, points: &[Complex64]) -> Vec<Complex64> {
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        map.jets(points, &mut jets);
        jets.iter().map(|jet| jet.value).collect()
    }

    #[test]
    fn each_hemisphere_sees_the_opposite_half() {
        let [left, right] = [Hemisphere::Left, Hemisphere::Right]
            .map(|hemisphere| VisualCortex::from_model(CorticalModel::POLIMENI_2006, hemisphere));
        let seen = [Complex64::new(10.0, 4.0), Complex64::new(-10.0, 4.0)];
        let (by_left, by_right) = (values(&left, &seen), values(&right, &seen));
        assert!(by_left[0].re > 0.0 && by_left[1].is_nan());
        assert!(by_right[0].is_nan());
        assert_eq!(by_right[1], Complex64::new(-by_left[0].re, by_left[0].im));
        let expected = CorticalModel::POLIMENI_2006.magnification(10.0);
        assert!((right.magnification(&[Complex64::new(-10.0, 0.0)])[0] - expected).abs() < 1e-12);
    }

    #[test]
    fn a_point_of_the_cortex_sees_what_lies_in_its_direction() {
        let frame = Frame::new(Complex64::ZERO, 2.0, [600, 400]).unwrap();
        let gaze = Gaze::new(&frame, 60.0, Complex64::new(0.2, 0.1)).unwrap();
        let cortex = VisualCortex::from_model(CorticalModel::SCHIRA_2010, Hemisphere::Left);
        let picture = [Complex64::new(0.5, 0.3), Complex64::new(0.21, 0.1), Complex64::new(0.9, -0.6)];
        let field: Vec<Complex64> = picture
            .iter()
            .map(|&point| gaze.direction(point))
            .map(|FieldPoint { eccentricity, azimuth }| Complex64::from_polar(eccentricity, azimuth.to_radians()))
            .collect();
        let seen = values(&cortex.seeing(gaze), &values(&cortex, &field));
        for (point, seen) in picture.iter().zip(seen) {
            assert!((point - seen).norm() < 1e-12, "{point} is seen as {seen}");
        }
    }
}
