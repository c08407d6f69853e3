//! Symm's map against exact answers.

use crate::support::{EXACT_CASES, angle_error, c, case, exact, largest, points, polygon, solve};
use conformal_warp::Complex64;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

#[test]
fn schwarz_christoffel_polygons() {
    for name in EXACT_CASES {
        let case = case(name);
        let map = solve(&case.region(), 1e-10);
        let estimate = map.error_estimate();
        assert!(estimate <= 1e-10, "{name}: estimate {estimate:e}");
        let vertices = largest(map.angles().iter().zip(&case.angles).map(|(a, b)| angle_error(*a, *b)));
        assert!(vertices < 1e-10 && vertices <= estimate, "{name}: vertices {vertices:e}, estimate {estimate:e}");
        let w = map.to_disk(&points(&case.interior_z));
        let interior = largest(w.iter().zip(points(&case.interior_w)).map(|(a, b)| (a - b).norm()));
        assert!(interior < 1e-10 && interior <= estimate, "{name}: interior {interior:e}, estimate {estimate:e}");
        let radius = (map.conformal_radius() / case.conformal_radius - 1.0).abs();
        assert!(radius < 1e-10, "{name}: conformal radius {radius:e}");
    }
}

#[test]
fn square() {
    let vertices = [c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)];
    let map = solve(&polygon(&vertices, c(0.0, 0.0)), 1e-13);
    for (k, angle) in map.angles().iter().enumerate() {
        assert!(angle_error(*angle, k as f64 * FRAC_PI_2) < 1e-13, "vertex {k}: {angle}");
    }
    assert!((map.conformal_radius() - 1.078_705_202_376_758_7).abs() < 1e-13);
    // Symmetry: the diagonal goes to a radius, the midpoint of the first edge to angle 45°.
    let w = map.to_disk(&[c(-0.5, -0.5), c(0.0, -1.0)]);
    assert!(w[0].im.abs() < 1e-13 && w[0].re > 0.0);
    assert!((w[1] - Complex64::cis(PI / 4.0)).norm() < 1e-13);
}

/// (0, 2, 2+i, 1+i, 1+2i, 2i) with f'(center) > 0: NUMERICS' figures, known to 13 digits.
#[test]
fn l_shape() {
    let vertices = [c(0.0, 0.0), c(2.0, 0.0), c(2.0, 1.0), c(1.0, 1.0), c(1.0, 2.0), c(0.0, 2.0)];
    let map = solve(&polygon(&vertices, c(0.5, 0.5)), 1e-12);
    assert!((map.conformal_radius() - 0.653_579_438_242_37).abs() < 1e-12);
    let exact =
        [-0.75 * PI, 0.122_504_729_417_3, 0.206_090_521_762_8, PI / 4.0, 1.364_705_805_032_1, 1.448_291_597_377_6];
    for (angle, exact) in map.angles().iter().zip(exact) {
        assert!(angle_error(*angle, exact - exact_first()) < 2e-12, "{angle} against {exact}");
    }
    fn exact_first() -> f64 {
        -0.75 * PI
    }
}

/// A smooth region as a fine inscribed polygon: the map differs by the geometric error, a share of edge².
#[test]
fn half_disk_as_polygon() {
    // u = ((1+z)/(1−z))² takes the half disk to the upper half plane, (u − u₀)/(u − ū₀) that to the disk.
    let center = c(0.0, 0.4);
    let half_plane = |z: Complex64| ((1.0 + z) / (1.0 - z)).powi(2);
    let u0 = half_plane(center);
    let exact = |z: Complex64| {
        let to_disk = |u: Complex64| (u - u0) / (u - u0.conj());
        to_disk(half_plane(z)) / to_disk(half_plane(c(-1.0, 0.0)))
    };
    let probes = [c(0.5, 0.2), c(-0.3, 0.7), c(0.0, 0.9), c(-0.8, 0.05)];
    let errors = [48, 96].map(|n| {
        let mut vertices = vec![c(-1.0, 0.0)];
        vertices.extend((0..n).map(|k| Complex64::cis(PI * f64::from(k) / f64::from(n))));
        let map = solve(&polygon(&vertices, center), 1e-8);
        largest(map.to_disk(&probes).iter().zip(&probes).map(|(w, z)| (w - exact(*z)).norm()))
    });
    // Sagitta of an edge: (π/48)²/8 = 5.4e-4.
    assert!(errors[0] < 3e-3, "{errors:?}");
    let ratio = errors[0] / errors[1];
    assert!((3.6..4.4).contains(&ratio), "error should fall as edge²: {errors:?}");
}

/// Ellipse x²/a² + y²/b² = 1 by its conjugate harmonic series: z ↦ √k·sn((2K/π)·asin(z/c)); only its symmetric
/// boundary points and its radius are needed: f(a) = 1, f(ib) = i.
#[test]
fn ellipse_as_polygon() {
    let (a, b) = (2.0, 1.0);
    let radius = exact::ellipse_conformal_radius(a, b);
    let errors = [64, 128].map(|n| {
        let vertices: Vec<_> =
            (0..n).map(|k| TAU * f64::from(k) / f64::from(n)).map(|t| c(a * t.cos(), b * t.sin())).collect();
        let map = solve(&polygon(&vertices, c(0.0, 0.0)), 1e-8);
        for quarter in 0..4 {
            let angle = map.angles()[quarter * n as usize / 4];
            assert!(angle_error(angle, quarter as f64 * FRAC_PI_2) < 1e-7);
        }
        (map.conformal_radius() - radius).abs()
    });
    assert!(errors[0] < 8e-3, "{errors:?}");
    let ratio = errors[0] / errors[1];
    assert!((3.6..4.4).contains(&ratio), "error should fall as edge²: {errors:?}");
}
