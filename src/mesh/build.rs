//! Regions and options → joint triangulation.

use super::correspondence::{Correspondence, OntoDisk};
use super::density::first_spacing;
use super::draft::Draft;
use super::joint::{JointTriangulation, Shape};
use super::locate::Located;
use super::options::{Density, MeshOptions, Route};
use super::side::Outline;
use super::{net, quality, scan};
use crate::Result;
use crate::plane::{Complex64, Polygon};
use crate::riemann::{RegionMap, RiemannMap};
use std::collections::HashMap;
use std::f64::consts::PI;

/// A point of the net keeps this share of its distance from the boundary away from samples.
const APART: f64 = 0.6;

impl JointTriangulation {
    /// Region → disk: the nodes of the region and their images under its Riemann map.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Curve, JointTriangulation, MeshOptions, Region, RiemannMap, SolveOptions};
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
        between(&OntoDisk(map), options)
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
        let exact = RegionMap::between(from, to);
        match options.route {
            Route::Exact => between(&exact, options),
            Route::Located => {
                let mut draft = chosen(&exact, options)?;
                draft.relocate(&Located::sampled(&exact, spacing)?)?;
                let mut mesh = draft.finish()?;
                mesh.evidence.route_difference = mesh.largest_difference(&exact);
                Ok(mesh)
            }
        }
    }

    /// How far the nodes of the target are from where the map puts those of the source.
    fn largest_difference(&self, map: &RegionMap) -> f64 {
        let distances = map.forward(&self.source).into_iter().zip(&self.target).map(|(z, w)| (z - w).norm());
        distances.filter(|distance| distance.is_finite()).fold(0.0, f64::max)
    }
}

/// Source → target by the paper's method "with boundaries", for any two copies.
pub(super) fn between(map: &dyn Correspondence, options: &MeshOptions) -> Result<JointTriangulation> {
    let mut draft = chosen(map, options)?;
    draft.connect_valid(map)?;
    draft.finish()
}

/// The nodes that the options ask for.
fn chosen<'a>(map: &'a dyn Correspondence, options: &MeshOptions) -> Result<Draft<'a>> {
    options.check()?;
    match options.density {
        Density::Spacing(spacing) => Draft::sampled(map, spacing),
        Density::MaxError { pixels, frame } => {
            let area = map.copies()[0].polygon().map_or(PI, Polygon::area);
            let mut draft = Draft::sampled(map, first_spacing(area))?;
            draft.evidence.pixel_size = Some(frame.pixel_size());
            draft.refine_to(pixels * frame.pixel_size())?;
            Ok(draft)
        }
    }
}

impl<'a> Draft<'a> {
    /// The refined boundary and the source's interior samples: the paper's grid, through the center so that it is a node.
    fn sampled(map: &'a dyn Correspondence, spacing: f64) -> Result<Self> {
        let mut draft = Self::new(map, spacing)?;
        let [source, _] = map.copies();
        if let Some(polygon) = source.polygon() {
            let samples = scan::fill(polygon, source.center(), spacing, scan::CLEARANCE * spacing)?;
            draft.add_grid(&samples);
            let angles: Vec<_> = draft.ring.iter().map(|(_, node)| source.angle(node.source)).collect();
            draft.add_net(&net::over(&angles, draft.trust()), spacing);
        }
        Ok(draft)
    }

    /// The joint triangulation, with what its making found out.
    fn finish(mut self) -> Result<JointTriangulation> {
        self.evidence.largest_error = self.largest_error();
        let exact = self.map.magnification(&self.source, &self.target);
        let shape = |outline: &Outline| match outline.straight() {
            Some(polygon) => Shape::Polygon(polygon.clone()),
            None if outline.is_polygon() => Shape::Curve,
            None => Shape::Disk,
        };
        let mesh = JointTriangulation {
            shapes: [shape(&self.outlines[0]), shape(&self.outlines[1])],
            outline: self.ring.iter().map(|(id, _)| *id).collect(),
            magnification: quality::magnification(&self.source, &self.target, &self.triangles),
            source: self.source,
            target: self.target,
            triangles: self.triangles,
            evidence: self.evidence,
        };
        mesh.with_magnification(&exact)
    }

    /// Puts the inner nodes where another map says, and connects them.
    fn relocate(&mut self, map: &dyn Correspondence) -> Result<()> {
        let places = map.forward(&self.source);
        for k in (0..self.source.len()).filter(|&k| self.places[k].is_none()) {
            if self.outlines[1].depth(places[k]) > 0.0 {
                self.target[k] = places[k];
            }
        }
        self.connect_valid(map)
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
        let mut places = self.map.undo_disk(points);
        places.retain(|&z| {
            let depth = self.outlines[0].depth(z);
            depth < spacing && !near(z, APART * depth)
        });
        self.add_inner(&places, self.map);
    }
}

#[cfg(test)]
mod tests {
    use super::super::star::{Star, StarOntoDisk, Stars};
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
                for map in [&Stars(source, target) as &dyn Correspondence, &StarOntoDisk(source)] {
                    let mesh = between(map, &options).unwrap();
                    mesh.validate().unwrap();
                    assert_eq!(mesh.flipped(), 0);
                }
            }
        }
    }
}
