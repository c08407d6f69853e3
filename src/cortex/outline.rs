//! Curves → polygons that stay equally close to them everywhere.

use crate::plane::Complex64;

/// Samples of a curve from which its polygon is chosen.
const FINE: usize = 1 << 14;

/// Vertices on a closed curve that consists of smooth `arcs`, each over [0, 1] and starting where the one before ends. The
/// start of each arc is a vertex. An edge of length h over a curvature κ misses the curve by κh²/8, which is made the
/// same for all edges; and the vertices between stand out by two thirds of that, so that the edges lie as much inside the
/// curve as outside: what is conformal sees the mean, and errs by h³ where a polygon on the curve errs by h².
pub fn polygon(arcs: &[&dyn Fn(f64) -> Complex64], vertices: usize) -> Vec<Complex64> {
    let arcs: Vec<Arc> = arcs.iter().map(|arc| Arc::new(arc)).collect();
    let total: f64 = arcs.iter().map(Arc::weight).sum();
    let free = vertices.saturating_sub(arcs.len()) as f64;
    let (mut polygon, mut before, mut placed) = (Vec::with_capacity(vertices), 0.0, 0);
    for arc in &arcs {
        before += arc.weight() / total;
        let inner = (free * before).round() as usize - placed;
        placed += inner;
        let on_curve: Vec<Complex64> = (0..=inner + 1).map(|k| arc.at(k as f64 / (inner + 1) as f64)).collect();
        polygon.push(on_curve[0]);
        // The second difference is four times the gap under an edge, so a sixth of it is two thirds of the gap.
        polygon.extend(on_curve.windows(3).map(|w| w[1] + (w[1] - (w[0] + w[2]) / 2.0) / 6.0));
    }
    polygon
}

struct Arc {
    points: Vec<Complex64>,
    /// ∫ √κ ds from the start to each point.
    weights: Vec<f64>,
}

impl Arc {
    fn new(curve: &dyn Fn(f64) -> Complex64) -> Self {
        let points: Vec<Complex64> = (0..=FINE).map(|k| curve(k as f64 / FINE as f64)).collect();
        let mut weights = vec![0.0];
        for k in 0..FINE {
            let (before, here, after) = (points[k.max(1) - 1], points[k.max(1)], points[k.max(1) + 1]);
            let (a, b) = (here - before, after - here);
            let (turn, length) = ((b * a.conj()).arg().abs(), (points[k + 1] - points[k]).norm());
            // √(κ ds · ds), and a little of the length, so that straight parts get vertices too.
            weights.push(weights[k] + (turn * length).sqrt() + 3e-2 * length);
        }
        Self { points, weights }
    }

    fn weight(&self) -> f64 {
        self.weights[FINE]
    }

    /// The sample that lies the given share of the weight from the start.
    fn at(&self, share: f64) -> Complex64 {
        let wanted = share * self.weight();
        self.points[self.weights.partition_point(|&weight| weight < wanted).min(FINE)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn edges_miss_the_curve_equally() {
        // An ellipse, whose curvature varies 125-fold, in two halves.
        let point = |t: f64| Complex64::new(5.0 * t.cos(), t.sin());
        let polygon = polygon(&[&|t| point(PI * t), &|t| point(PI * (1.0 + t))], 200);
        assert_eq!((polygon.len(), polygon[0]), (200, point(0.0)));
        let miss = |k: usize| {
            let middle = (polygon[k] + polygon[(k + 1) % 200]) / 2.0;
            1.0 - ((middle.re / 5.0).powi(2) + middle.im.powi(2)).sqrt()
        };
        // Distance along the normal, from the level of the ellipse's equation.
        let distance = |k: usize| {
            let middle = (polygon[k] + polygon[(k + 1) % 200]) / 2.0;
            miss(k) / (middle.re / 25.0).hypot(middle.im)
        };
        let (least, most) = (0..200).map(distance).fold((f64::INFINITY, 0.0), |(a, b), d| (d.min(a), d.max(b)));
        assert!(least > 0.0 && most < 4.0 * least, "{least:e} … {most:e}");
    }
}
