//! Regions and options → joint triangulation.

use super::correspondence::{Correspondence, OntoDisk};
use super::density::{Known, first_spacing};
use super::draft::Draft;
use super::joint::{JointTriangulation, MeshStop, Shape};
use super::locate::Located;
use super::options::{Density, MeshOptions, Route};
use super::ring::Room;
use super::side::Outline;
use super::{net, quality, scan};
use crate::plane::Complex64;
use crate::riemann::{RegionMap, RiemannMap};
use crate::symm::options::Progress;
use crate::{Error, Result};
use rustc_hash::FxHashMap;
use std::f64::consts::PI;

/// A point of the net keeps this share of its distance from the boundary away from samples.
const APART: f64 = 0.6;
/// Undoing flips changes triangles, which may need more nodes in turn; so often at most.
const MOST_TURNS: usize = 4;

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
    /// [`Error::InvalidOption`], and [`Error::Crowded`] where double precision cannot keep nodes apart.
    pub fn region_to_disk(map: &RiemannMap, options: &MeshOptions) -> Result<Self> {
        Self::region_to_disk_with(map, options, &mut |_, _| true)
    }

    /// [`JointTriangulation::region_to_disk`]; `progress` hears the stage and the fraction done, and cancels by returning
    /// false.
    ///
    /// # Errors
    /// Those of the call without `progress`, and [`Error::Cancelled`].
    pub fn region_to_disk_with(map: &RiemannMap, options: &MeshOptions, progress: Progress) -> Result<Self> {
        options.check()?;
        ready(map, progress)?;
        between(&OntoDisk(map), options, progress)
    }

    /// Region → region through the disk: center goes to center, `toward` to `toward`, and each outline to the other.
    ///
    /// # Errors
    /// As [`JointTriangulation::region_to_disk`], and [`Error::TooFarApart`] where nobody can tell what belongs together. `to` may
    /// have no corners of angle 0.
    pub fn region_to_region(from: &RiemannMap, to: &RiemannMap, options: &MeshOptions) -> Result<Self> {
        Self::region_to_region_with(from, to, options, &mut |_, _| true)
    }

    /// [`JointTriangulation::region_to_region`]; `progress` hears the stage and the fraction done, and cancels by returning
    /// false.
    ///
    /// # Errors
    /// Those of the call without `progress`, and [`Error::Cancelled`].
    pub fn region_to_region_with(
        from: &RiemannMap,
        to: &RiemannMap,
        options: &MeshOptions,
        progress: Progress,
    ) -> Result<Self> {
        options.check()?;
        ready(from, progress)?;
        ready(to, progress)?;
        let exact = RegionMap::between(from, to);
        exact.check()?;
        if let Some(at) = to.region().curved().and_then(|outline| outline.tip()) {
            // All that comes to lie in a horn is one point of the source.
            return Err(Error::Crowded { at });
        }
        match options.route {
            Route::Exact => between(&exact, options, progress),
            Route::Located => located(&exact, options, progress),
        }
    }

    /// How far the nodes of the target are from where the map puts those of the source.
    fn largest_difference(&self, map: &RegionMap) -> f64 {
        let distances = map.forward(&self.source).into_iter().zip(&self.target).map(|(z, w)| (z - w).norm());
        distances.filter(|distance| distance.is_finite()).fold(0.0, f64::max)
    }
}

/// Builds what evaluation needs, with progress; what curved edges need is built as it is asked for, and nodes ask for little of it.
fn ready(map: &RiemannMap, progress: Progress) -> Result<()> {
    if map.region().curved().is_some() { Ok(()) } else { map.prepare(progress) }
}

/// Source → target by the paper's method "with boundaries", for any two copies.
pub(super) fn between(
    map: &dyn Correspondence,
    options: &MeshOptions,
    progress: Progress,
) -> Result<JointTriangulation> {
    with_room(map, |room| {
        let mut draft = chosen(map, options, room, progress)?;
        if let Density::Spacing(_) = options.density {
            draft.connect_valid(map, progress)?;
            draft.measure(&Known::default());
        }
        draft.finish()
    })
}

/// The same with the samples of the source where triangles of the target's samples have them.
fn located(exact: &RegionMap, options: &MeshOptions, progress: Progress) -> Result<JointTriangulation> {
    options.check()?;
    let [source, target] = [exact.source(), exact.target()].map(|map| map.region().polygon().area());
    let spacing = match options.density {
        Density::Spacing(spacing) => spacing * (target / source).sqrt(),
        Density::MaxError { .. } => target.sqrt() / 60.0,
    };
    let triangles = Located::sampled(exact, spacing)?;
    with_room(exact, |room| {
        let mut draft = chosen(exact, options, room, progress)?;
        draft.relocate(&triangles, progress)?;
        let mut mesh = draft.finish()?;
        mesh.evidence.route_difference = mesh.largest_difference(exact);
        Ok(mesh)
    })
}

/// Makes a mesh with boundary nodes as near to each other as double precision can do with; where curves lie so close to each other
/// that chords cross, with more of them; or else farther apart.
fn with_room(
    map: &dyn Correspondence,
    mut make: impl FnMut(Room) -> Result<JointTriangulation>,
) -> Result<JointTriangulation> {
    let has_curves = map.copies().iter().any(|side| side.contour().is_some_and(|contour| contour.curved().is_some()));
    let finer = if has_curves { &Room::OF_CURVES[..] } else { &[] };
    let mut made = make(Room::LEAST);
    for &room in finer.iter().chain([&Room::AMPLE]) {
        if !matches!(made, Err(Error::Crowded { .. } | Error::InvalidMesh { .. })) {
            break;
        }
        made = make(room);
    }
    made
}

/// The nodes that the options ask for; connected, if an error was asked for.
fn chosen<'a>(map: &'a dyn Correspondence, options: &MeshOptions, room: Room, progress: Progress) -> Result<Draft<'a>> {
    options.check()?;
    let (pixels, frame) = match options.density {
        Density::MaxError { pixels, frame } => (pixels, frame),
        Density::Spacing(spacing) => return Draft::sampled(map, spacing, room),
    };
    let area = map.copies()[0].contour().map_or(PI, |contour| contour.polygon().area());
    let mut draft = Draft::sampled(map, first_spacing(area), room)?;
    draft.evidence.pixel_size = Some(frame.pixel_size());
    draft.keep_within(pixels * frame.pixel_size(), progress)?;
    Ok(draft)
}

impl<'a> Draft<'a> {
    /// The refined boundary and the source's interior samples: the paper's grid, through the center so that it is a node.
    fn sampled(map: &'a dyn Correspondence, spacing: f64, room: Room) -> Result<Self> {
        let mut draft = Self::new(map, spacing, room)?;
        let [source, _] = map.copies();
        if let Some(contour) = source.contour() {
            let samples = scan::fill(contour.polygon(), source.center(), spacing, scan::CLEARANCE * spacing)?;
            draft.add_grid(&samples);
            let angles: Vec<_> = draft.ring.iter().map(|(_, node)| source.angle(node.source)).collect();
            draft.add_net(&net::over(&angles, draft.trust()), spacing);
        }
        Ok(draft)
    }

    /// Connects nodes, as many as it takes to stay within `bound` (plane units of the target) of the map where that is
    /// possible.
    fn keep_within(&mut self, bound: f64, progress: Progress) -> Result<()> {
        let mut known = Known::default();
        for _ in 0..MOST_TURNS {
            let before = self.source.len();
            let full = self.refine_to(bound, &mut known, progress)?;
            self.connect_valid(self.map, progress)?;
            if self.evidence.mended > 0 {
                // What was known was so of nodes that have been moved.
                known = Known::default();
            }
            self.measure(&known);
            self.evidence.stop = match self.evidence.largest_error.max(self.evidence.crowded_error) <= bound {
                true => MeshStop::Density,
                false if full => MeshStop::MaxNodes,
                false => MeshStop::Crowded,
            };
            if self.evidence.stop != MeshStop::Crowded || self.evidence.mended > 0 || self.source.len() == before {
                break;
            }
        }
        Ok(())
    }

    /// The joint triangulation, proven to be one.
    fn finish(self) -> Result<JointTriangulation> {
        let exact = self.map.magnification(&self.source, &self.target);
        let shape = |outline: &Outline| match outline.straight() {
            Some(polygon) => Shape::Polygon(polygon.clone()),
            None if outline.is_circle() => Shape::Disk,
            None => Shape::Curve,
        };
        let mesh = JointTriangulation {
            shapes: self.outlines.each_ref().map(|outline| vec![shape(outline)]),
            outlines: vec![self.ring.iter().map(|(id, _)| *id).collect()],
            magnification: quality::magnification(&self.source, &self.target, &self.triangles),
            source: self.source,
            target: self.target,
            triangles: self.triangles,
            evidence: self.evidence,
        };
        mesh.validate()?;
        mesh.with_magnification(&exact)
    }

    /// Puts the inner nodes where another map says, and connects them.
    fn relocate(&mut self, map: &dyn Correspondence, progress: Progress) -> Result<()> {
        let places = map.forward(&self.source);
        for k in (0..self.source.len()).filter(|&k| self.places[k].is_none()) {
            if self.outlines[1].depth(places[k]) > 0.0 {
                self.target[k] = places[k];
            }
        }
        self.connect_valid(map, progress)?;
        self.measure(&Known::default());
        Ok(())
    }

    /// Adds points of the disk with their places in both copies, except those that samples `spacing` apart stand in for.
    fn add_net(&mut self, points: &[Complex64], spacing: f64) {
        let cell = |z: Complex64| [z.re, z.im].map(|x| (x / spacing).floor() as i64);
        let samples: FxHashMap<_, _> = self.source[self.ring.len()..].iter().map(|&z| (cell(z), z)).collect();
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
    use super::super::side::Side;
    use super::super::star::{Star, StarOntoDisk, Stars};
    use super::*;
    use crate::plane::{BoundaryPoint, Complex64, Frame};

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
                    let mesh = between(map, &options, &mut |_, _| true).unwrap();
                    mesh.validate().unwrap();
                    assert_eq!(mesh.flipped(), 0);
                }
            }
        }
    }

    /// A map that has no value in a part of its region.
    struct Torn<'a>(StarOntoDisk<'a>);

    impl Correspondence for Torn<'_> {
        fn copies(&self) -> [&dyn Side; 2] {
            self.0.copies()
        }

        fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
            let lost = |z: &Complex64| (z - Complex64::new(0.5, 0.5)).norm() < 0.2;
            let image = |(z, w)| if lost(z) { Complex64::new(f64::NAN, 0.0) } else { w };
            points.iter().zip(self.0.forward(points)).map(image).collect()
        }

        fn backward(&self, points: &[Complex64]) -> Vec<Complex64> {
            self.0.backward(points)
        }

        fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint {
            self.0.boundary_forward(point)
        }

        fn boundary_backward(&self, point: BoundaryPoint) -> BoundaryPoint {
            self.0.boundary_backward(point)
        }

        fn undo_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
            self.0.undo_disk(points)
        }

        fn magnification(&self, source: &[Complex64], target: &[Complex64]) -> Vec<f64> {
            self.0.magnification(source, target)
        }
    }

    #[test]
    fn what_has_no_image_is_an_error() {
        let corners = points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]);
        let square = Star::new(&corners, Complex64::new(1.0, 1.0), Complex64::new(2.0, 1.0));
        let frame = Frame::new(Complex64::ZERO, 2.0, [200, 200]).unwrap();
        let torn = Torn(StarOntoDisk(&square));
        let mesh = between(&torn, &MeshOptions::quarter_pixel(frame), &mut |_, _| true).unwrap();
        mesh.validate().unwrap();
        assert_eq!(mesh.evidence().largest_error, f64::INFINITY);
        assert_eq!(mesh.evidence().stop, MeshStop::Crowded);
    }
}
