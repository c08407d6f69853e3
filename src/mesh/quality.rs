//! How good a mesh is: distortion of angles.

use crate::plane::Complex64;

/// The largest change of an angle, in radians, that the affine map between two anticlockwise triangles makes.
///
/// With f(z) = p·z + q·z̄ + r and Beltrami coefficient μ = q/p, angles change by at most 2·asin|μ| (0 if conformal).
pub(super) fn angle_error(source: [Complex64; 3], target: [Complex64; 3]) -> f64 {
    let (u, v) = (source[1] - source[0], source[2] - source[0]);
    let (s, t) = (target[1] - target[0], target[2] - target[0]);
    // p·u + q·ū = s and p·v + q·v̄ = t, up to the common determinant.
    let p = s * v.conj() - t * u.conj();
    let q = t * u - s * v;
    2.0 * (q.norm() / p.norm()).min(1.0).asin()
}

/// Changes of angles over a mesh, in radians.
pub(super) struct AngleErrors {
    pub(super) largest: f64,
    /// Weighted by the triangles' areas in the target.
    pub(super) mean: f64,
}

/// The largest and mean changes of an angle, over all triangles.
pub(super) fn angle_errors(source: &[Complex64], target: &[Complex64], triangles: &[[u32; 3]]) -> AngleErrors {
    let corners = |points: &[Complex64], t: &[u32; 3]| t.map(|k| points[k as usize]);
    let (mut largest, mut sum, mut area): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for t in triangles {
        let [a, b, c] = corners(target, t);
        let error = angle_error(corners(source, t), [a, b, c]);
        let weight = ((b - a).conj() * (c - a)).im;
        largest = largest.max(error);
        sum += weight * error;
        area += weight;
    }
    AngleErrors { largest, mean: sum / area }
}

/// How much each node's surroundings grow from source to target: the square root of the ratio of the areas of the
/// triangles around it. Tends to |f'| as the mesh gets finer, and is finite at corners, where |f'| is 0 or infinite.
pub(super) fn magnification(source: &[Complex64], target: &[Complex64], triangles: &[[u32; 3]]) -> Vec<f64> {
    let area = |points: &[Complex64], t: [u32; 3]| {
        let [a, b, c] = t.map(|k| points[k as usize]);
        ((b - a).conj() * (c - a)).im
    };
    let mut areas = vec![[0.0; 2]; source.len()];
    for &t in triangles {
        let [from, to] = [area(source, t), area(target, t)];
        for k in t {
            areas[k as usize][0] += from;
            areas[k as usize][1] += to;
        }
    }
    areas.iter().map(|[from, to]| (to / from).sqrt()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Complex64; 3] = [Complex64::new(0.0, 0.0), Complex64::new(1.0, 0.0), Complex64::new(0.3, 0.8)];

    #[test]
    fn similar_triangles_have_no_angle_error() {
        let turned = TRIANGLE.map(|z| z * Complex64::new(0.4, -2.0) + Complex64::new(3.0, 1.0));
        assert!(angle_error(TRIANGLE, turned) < 1e-14);
    }

    #[test]
    fn a_stretch_by_k_changes_angles_by_twice_asin_mu() {
        let stretched = TRIANGLE.map(|z| Complex64::new(3.0 * z.re, z.im));
        assert!((angle_error(TRIANGLE, stretched) - 2.0 * 0.5_f64.asin()).abs() < 1e-14);
    }

    #[test]
    fn magnification_of_a_similarity_is_its_factor() {
        let turned = TRIANGLE.map(|z| z * Complex64::new(0.0, 2.5));
        assert!(magnification(&TRIANGLE, &turned, &[[0, 1, 2]]).iter().all(|m| (m - 2.5).abs() < 1e-14));
    }
}
