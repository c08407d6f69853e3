//! Regions and options → joint triangulation.

use super::density::{Middles, first_spacing};
use super::draft::Draft;
use super::options::{Density, MeshOptions};
use super::side::{Side, UnitDisk};
use super::{JointTriangulation, scan};
use crate::Result;
use crate::map::RiemannMap;
use crate::plane::Polygon;
use std::f64::consts::PI;

/// Samples keep this share of the spacing away from the boundary, where its own nodes are.
const CLEARANCE: f64 = 0.4;

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
}

/// Source → target by the paper's method "with boundaries", for any two copies.
pub(super) fn between(source: &dyn Side, target: &dyn Side, options: &MeshOptions) -> Result<JointTriangulation> {
    options.check()?;
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
        }
        Ok(draft)
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
