//! Regions and options → joint triangulation.

use super::density::{Middles, first_spacing};
use super::draft::Draft;
use super::locate::Located;
use super::options::{Density, MeshOptions, Route};
use super::side::{Side, UnitDisk};
use super::{JointTriangulation, net, scan};
use crate::map::RiemannMap;
use crate::plane::{Complex64, Polygon};
use crate::{Error, Result};
use std::collections::HashMap;
use std::f64::consts::PI;

/// Samples keep this share of the spacing away from the boundary, where its own nodes are.
pub(super) const CLEARANCE: f64 = 0.4;

/// A point of the net keeps this share of its distance from the boundary away from samples.
const APART: f64 = 0.6;

impl JointTriangulation {
    /// Region → disk: the nodes of the region and their images under its Riemann map.
    ///
    /// ```
    /// use conformal_warp::map::{RiemannMap, SolveOptions};
    /// use conformal_warp::mesh::{JointTriangulation, MeshOptions};
    /// use conformal_warp::plane::{Complex64, Curve, Region};
    /// let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    /// let corners = corners.map(|(x, y)| Complex64::new(x, y));
    /// let region = Region::new(&corners, Curve::Polygon, Complex64::new(0.6, 0.6), Complex64::new(2.0, 0.5))?;
    /// let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
    /// let mesh = JointTriangulation::region_to_disk(&map, &MeshOptions::with_spacing(0.1))?;
    /// assert_eq!(mesh.flipped(), 0);
    /// mesh.validate()?;
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`crate::Error::InvalidOption`], and [`crate::Error::Crowded`] where double precision cannot keep nodes apart.
    pub fn region_to_disk(map: &RiemannMap, options: &MeshOptions) -> Result<Self> {
        between(map, &UnitDisk, options)
    }

    /// How far the nodes of the target are from where the maps put those of the source.
    fn largest_difference(&self, from: &dyn Side, to: &dyn Side) -> f64 {
        let exact = to.to_region(&from.to_disk(&self.source));
        let distances = exact.iter().zip(&self.target).map(|(z, w)| (z - w).norm());
        distances.filter(|distance| distance.is_finite()).fold(0.0, f64::max)
    }

    /// Region → region through the disk: center goes to center, `toward` to `toward`, and each outline to the other.
    ///
    /// # Errors
    /// As [`JointTriangulation::region_to_disk`].
    pub fn region_to_region(from: &RiemannMap, to: &RiemannMap, options: &MeshOptions) -> Result<Self> {
        options.check()?;
        let [source, target] = [from, to].map(|map| map.region().polygon().area());
        let spacing = match options.density {
            Density::Spacing(spacing) => spacing * (target / source).sqrt(),
            Density::MaxError { .. } => target.sqrt() / 60.0,
        };
        match options.route {
            Route::Exact => between(from, to, options),
            Route::Located => {
                let located = Located::sampled(to, spacing)?;
                let mut mesh = between(from, &located, options)?;
                mesh.evidence.route_difference = mesh.largest_difference(from, to);
                Ok(mesh)
            }
        }
    }
}

/// Source → target by the paper's method "with boundaries", for any two copies. Where the target has pockets that the
/// source cannot show, the target is triangulated first instead.
pub(super) fn between(source: &dyn Side, target: &dyn Side, options: &MeshOptions) -> Result<JointTriangulation> {
    options.check()?;
    match build(source, target, options) {
        Err(Error::Crowded { at }) => match build(target, source, options) {
            Ok(mesh) => Ok(mesh.inverse()),
            Err(_) => Err(Error::Crowded { at }),
        },
        other => other,
    }
}

fn build(source: &dyn Side, target: &dyn Side, options: &MeshOptions) -> Result<JointTriangulation> {
    let area = source.polygon().map_or(PI, Polygon::area);
    let mut middles = Middles::default();
    let mut draft;
    match options.density {
        Density::Spacing(spacing) => draft = Draft::sampled(source, target, spacing)?,
        Density::MaxError { pixels, frame } => {
            draft = Draft::sampled(source, target, first_spacing(area))?;
            draft.refine_to(pixels * frame.pixel_size(), &mut middles)?;
        }
    }
    draft.connect_valid()?;
    draft.evidence.largest_error = draft.largest_error(&mut middles);
    Ok(draft.finish())
}

impl<'a> Draft<'a> {
    /// The refined boundary and the source's interior samples: the paper's grid, through the center so that it is a node.
    fn sampled(source: &'a dyn Side, target: &'a dyn Side, spacing: f64) -> Result<Self> {
        let mut draft = Self::new(source, target, spacing)?;
        if let Some(polygon) = source.polygon() {
            let samples = scan::fill(polygon, source.center(), spacing, CLEARANCE * spacing)?;
            draft.add_inner(&samples);
            let angles: Vec<_> = draft.ring.iter().map(|(_, node)| node.angle).collect();
            draft.add_net(&net::over(&angles, draft.trust()), spacing);
        }
        Ok(draft)
    }

    /// Adds points of the disk with their places in both copies, except those that samples `spacing` apart stand in for.
    fn add_net(&mut self, points: &[Complex64], spacing: f64) {
        let cell = |z: Complex64| [z.re, z.im].map(|x| (x / spacing).floor() as i64);
        let samples: HashMap<_, _> = self.source[self.ring.len()..].iter().map(|&z| (cell(z), z)).collect();
        let near = |z: Complex64, reach: f64| {
            let [i, j] = cell(z);
            (i - 1..=i + 1)
                .flat_map(|i| (j - 1..=j + 1).map(move |j| [i, j]))
                .any(|cell| samples.get(&cell).is_some_and(|sample| (sample - z).norm() < reach))
        };
        let [source, target] = self.sides.map(|side| side.to_region(points));
        let pairs: Vec<_> = source
            .into_iter()
            .zip(target)
            .filter(|(z, _)| {
                let depth = self.outlines[0].depth(*z);
                depth < spacing && !near(*z, APART * depth)
            })
            .collect();
        self.add_pairs(&pairs);
    }
}

#[cfg(test)]
mod tests {
    use super::super::side::UnitDisk;
    use super::super::star::Star;
    use super::*;
    use crate::plane::{Complex64, Frame};

    fn points(xy: &[(f64, f64)]) -> Vec<Complex64> {
        xy.iter().map(|&(x, y)| Complex64::new(x, y)).collect()
    }

    fn star_of(corners: usize, dent: f64) -> Star {
        let corner = |k: usize| {
            let radius = if k.is_multiple_of(2) { 1.0 } else { dent };
            Complex64::from_polar(radius, std::f64::consts::TAU * k as f64 / corners as f64)
        };
        Star::new(&(0..corners).map(corner).collect::<Vec<_>>(), Complex64::ZERO, Complex64::new(1.0, 0.0))
    }

    #[test]
    fn disk_and_stars_become_valid_meshes() {
        let corners = points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
        let square = Star::new(&corners, Complex64::new(1.0, 1.0), Complex64::new(2.0, 1.0));
        let star = star_of(10, 0.7);
        let frame = Frame::new(Complex64::ZERO, 2.0, [200, 200]).unwrap();
        for options in [MeshOptions::with_spacing(0.1), MeshOptions::quarter_pixel(frame)] {
            for (source, target) in [(&square, &star), (&star, &square)] {
                for target in [target as &dyn Side, &UnitDisk] {
                    let mesh = between(source, target, &options).unwrap();
                    mesh.validate().unwrap();
                    assert_eq!(mesh.flipped(), 0);
                    println!("{} nodes, {:?}", mesh.source().len(), mesh.evidence());
                }
            }
        }
    }
}
