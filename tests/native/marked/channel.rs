//! Channels against closed forms.

use super::options;
use crate::support::{c, largest, points, polygon, spread_points};
use conformal_warp::{ChannelEnds, ChannelFlow, Complex64, Curve, Edge, FlowLines, Region};
use std::f64::consts::{FRAC_PI_2, LN_2, PI, TAU};

fn solve(region: &Region, ends: ChannelEnds, flux: f64) -> ChannelFlow {
    ChannelFlow::solve(region, ends, flux, &options(1e-12), &mut |_, _| true).unwrap()
}

/// 0 < x < a, 0 < y < b, from left to right.
fn straight(a: f64, b: f64, flux: f64) -> (Region, ChannelFlow) {
    let corners = points(&[[0.0, b], [0.0, 0.0], [a, 0.0], [a, b]]);
    let region = polygon(&corners, c(0.5 * a, 0.5 * b));
    let flow = solve(&region, ChannelEnds::Sides(corners.try_into().unwrap()), flux);
    (region, flow)
}

#[test]
fn a_straight_channel() {
    for (a, b, flux) in [(2.0, 1.0, 1.0), (1.0, 3.0, 2.5), (30.0, 0.5, 0.1)] {
        let (region, flow) = straight(a, b, flux);
        let (speed, length) = (flux / b, a.max(b) / a.min(b));
        assert!((flow.speed() / speed - 1.0).abs() < 1e-14, "{a} × {b}");
        assert!((flow.potential_difference() / (speed * a) - 1.0).abs() < 1e-12 * length, "{a} × {b}");
        let places = spread_points(&region, 100);
        let off = flow.potential(&places).into_iter().zip(&places).map(|(w, z)| (w - speed * z).norm() / flux);
        let off = largest(off);
        assert!(off < 5e-12 * length && off <= flow.error_estimate(), "{a} × {b}: {off:e}");
        let psi = flow.stream(&places).into_iter().zip(&places).map(|(psi, z)| (psi / flux - z.im / b).abs());
        assert!(largest(psi) < 5e-12 * length, "{a} × {b}");
        assert!(largest(flow.velocity(&places).iter().map(|u| (u / speed - 1.0).norm())) < 1e-7, "{a} × {b}");
        assert!(largest(flow.pressure(&places).iter().map(|p| p.abs())) < 1e-6, "{a} × {b}");
        let outside = [c(-0.1, 0.1), c(a + 0.1, 0.1)];
        assert!(flow.potential(&outside).iter().all(|w| w.is_nan()) && flow.stream(&outside)[0].is_nan());
    }
}

#[test]
fn its_lines_are_straight() {
    let (_, flow) = straight(20.0, 1.0, 2.0);
    let streamlines = flow.level_lines(FlowLines::Streamlines, &[0.0, 0.5, 2.0, 2.1, -0.1, f64::NAN]);
    assert_eq!(streamlines.iter().map(|line| line.level).collect::<Vec<_>>(), [0.0, 0.5, 2.0]);
    for line in &streamlines {
        assert!(!line.closed && line.points[0].re.abs() < 1e-9, "{line:?}");
        assert!((line.points[line.points.len() - 1].re - 20.0).abs() < 1e-9, "{line:?}");
        assert!(line.points.iter().all(|z| (2.0 * z.im - line.level).abs() < 1e-9), "{line:?}");
    }
    let potentials = flow.level_lines(FlowLines::Potentials, &[-1.0, 10.0, 41.0]);
    assert_eq!(potentials.len(), 1);
    assert!(potentials[0].points.iter().all(|z| (z.re - 5.0).abs() < 1e-9));
    assert!(potentials[0].points[0].im < 1e-9 && potentials[0].points.len() > 64);
}

/// A right bend of a channel of width 1 is as long as 1 − (2/π) log 2 of it, but for e^(−2π·leg).
#[test]
fn a_bend() {
    let bend = |leg: f64| {
        let end = leg + 1.0;
        let corners = points(&[[0.0, 0.0], [end, 0.0], [end, 1.0], [1.0, 1.0], [1.0, end], [0.0, end]]);
        let region = polygon(&corners, c(0.5, 0.5));
        let ends = ChannelEnds::Sides([corners[4], corners[5], corners[1], corners[2]]);
        (region.clone(), solve(&region, ends, 1.0))
    };
    let (region, flow) = bend(4.0);
    let known = 9.0 - 2.0 * LN_2 / PI;
    let missing = flow.potential_difference() - known;
    assert!(missing.abs() < 1e-9, "{missing:e}");
    // The velocity is the slope of φ, and −i times that of ψ.
    let places: Vec<Complex64> =
        spread_points(&region, 60).into_iter().filter(|z| (z - c(1.0, 1.0)).norm() > 0.2).collect();
    let (velocity, h) = (flow.velocity(&places), 1e-5);
    let along = |by: Complex64| {
        let [ahead, behind] = [by, -by].map(|by| flow.potential(&places.iter().map(|z| z + by).collect::<Vec<_>>()));
        ahead.into_iter().zip(behind).map(move |(a, b)| (a - b) / (2.0 * h)).collect::<Vec<_>>()
    };
    let (x, y) = (along(c(h, 0.0)), along(c(0.0, h)));
    let inner = (0..places.len()).filter(|&k| !x[k].is_nan() && !y[k].is_nan()).collect::<Vec<_>>();
    assert!(inner.len() > 40);
    let off = inner.iter().map(|&k| (velocity[k] - c(x[k].re, y[k].re)).norm() + (velocity[k].im + x[k].im).abs());
    assert!(largest(off) < 1e-6);
    // As much flows through every section: across the first leg, the bend, the second leg.
    for (from, to) in [(c(0.0, 3.0), c(1.0, 3.0)), (c(0.0, 0.0), c(1.0, 1.0)), (c(2.5, 0.0), c(2.0, 1.0))] {
        const STEPS: u32 = 4000;
        let normal = (to - from) * Complex64::i() / f64::from(STEPS);
        let middles =
            (0..STEPS).map(|k| from + (to - from) * ((f64::from(k) + 0.5) / f64::from(STEPS))).collect::<Vec<_>>();
        let flux: f64 = flow.velocity(&middles).iter().map(|u| -(u * normal.conj()).re).sum();
        assert!((flux.abs() - 1.0).abs() < 2e-2, "{from} to {to}: {flux}");
        let psi = flow.stream(&[from, to]);
        assert!((psi[1] - psi[0]).abs() > 1.0 - 1e-9, "{psi:?}");
    }
    // It rests in the outer corner and runs fast around the inner one.
    let speeds = flow.velocity(&[c(1e-6, 1e-6), c(1.0 - 1e-6, 1.0 - 1e-6)]);
    assert!(speeds[0].norm() < 1e-4 && speeds[1].norm() > 10.0, "{speeds:?}");
}

/// A quarter turn between circles of radii 1 and 2: φ grows with the angle, ψ like −log r.
#[test]
fn an_annular_sector() {
    let edges = [
        Edge::line(c(1.0, 0.0), c(2.0, 0.0)),
        Edge::circular(c(0.0, 0.0), 2.0, 0.0, FRAC_PI_2),
        Edge::line(c(0.0, 2.0), c(0.0, 1.0)),
        Edge::circular(c(0.0, 0.0), 1.0, FRAC_PI_2, -FRAC_PI_2),
    ];
    let region = Region::from_edges(&edges, c(1.0, 1.0), c(2.0, 0.0)).unwrap();
    let flux = 0.7;
    // From the x axis to the y axis: counter-clockwise, the inner wall on the left.
    let flow = solve(&region, ChannelEnds::Sides([c(1.0, 0.0), c(2.0, 0.0), c(0.0, 2.0), c(0.0, 1.0)]), flux);
    assert!((flow.potential_difference() - flux * FRAC_PI_2 / LN_2).abs() < 1e-10);
    assert!((flow.speed() - flux).abs() < 1e-13);
    let places = spread_points(&region, 80);
    for ((w, u), z) in flow.potential(&places).into_iter().zip(flow.velocity(&places)).zip(&places) {
        let exact = c(z.arg(), LN_2 - z.norm().ln()) * (flux / LN_2);
        assert!((w - exact).norm() < 1e-9, "{z}: {w}, {exact}");
        let turning = Complex64::i() * z / z.norm_sqr() * (flux / LN_2);
        assert!((u - turning).norm() < 1e-7, "{z}: {u}, {turning}");
    }
    // The other way around.
    let back = solve(&region, ChannelEnds::Sides([c(0.0, 2.0), c(0.0, 1.0), c(1.0, 0.0), c(2.0, 0.0)]), flux);
    let z = c(0.9, 1.1);
    assert!((back.velocity(&[z])[0] + flow.velocity(&[z])[0]).norm() < 1e-7);
    // The mean speed is also that of a curved inlet: radially, from the inner arc.
    let radial = solve(&region, ChannelEnds::Sides([c(0.0, 1.0), c(1.0, 0.0), c(2.0, 0.0), c(0.0, 2.0)]), flux);
    assert!((radial.speed() - flux / FRAC_PI_2).abs() < 1e-9, "{}", radial.speed());
    assert!((radial.potential_difference() - flux * LN_2 / FRAC_PI_2).abs() < 1e-10);
}

/// From one point of a circle to another: W = flux/π · log((z − a)/(z − b)) + a constant.
#[test]
fn between_two_points() {
    let circle: Vec<_> = (0..32).map(|k| Complex64::cis(TAU * f64::from(k) / 32.0)).collect();
    let region = Region::new(&circle, Curve::Smooth, c(0.0, 0.0), circle[0]).unwrap();
    let (a, b, flux) = (circle[3], circle[20], 1.3);
    let flow = solve(&region, ChannelEnds::Points([a, b]), flux);
    for z in [c(0.0, 0.0), c(0.3, 0.2), c(-0.5, 0.7), c(0.1, -0.9)] {
        let exact = ((z - a).inv() - (z - b).inv()).conj() * (flux / PI);
        let found = flow.velocity(&[z])[0];
        assert!((found - exact).norm() < 1e-9, "{z}: {found}, {exact}");
    }
    assert!(flow.potential_difference().is_infinite());
    assert!(flow.pressure(&[c(0.0, 0.0)])[0].abs() < 1e-9);
    let lines = flow.level_lines(FlowLines::Streamlines, &[0.2, 0.6, 1.3]);
    assert_eq!(lines.len(), 3);
    for line in &lines {
        let last = line.points[line.points.len() - 1];
        assert!((line.points[0] - a).norm() < 1e-6 && (last - b).norm() < 1e-6, "{} {last}", line.points[0]);
        // Beside an end no number tells the streamlines apart.
        let off_ends = |z: &Complex64| (z - a).norm() > 1e-4 && (z - b).norm() > 1e-4;
        let inner: Vec<Complex64> = line.points.iter().copied().filter(off_ends).collect();
        assert!(inner.len() > 30);
        assert!(largest(flow.stream(&inner).iter().map(|psi| (psi - line.level).abs())) < 1e-8);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let corners = points(&[[0.0, 1.0], [0.0, 0.0], [4.0, 0.0], [4.0, 1.0]]);
    let region = polygon(&corners, c(2.0, 0.5));
    let error = |ends: ChannelEnds, flux: f64| {
        ChannelFlow::solve(&region, ends, flux, &options(1e-6), &mut |_, _| true).unwrap_err()
    };
    let sides = |order: [usize; 4]| ChannelEnds::Sides(order.map(|k| corners[k]));
    for flux in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(error(sides([0, 1, 2, 3]), flux).code(), "invalid-option");
    }
    assert_eq!(error(sides([3, 2, 1, 0]), 1.0).code(), "invalid-map");
    assert_eq!(error(sides([0, 0, 2, 3]), 1.0).code(), "invalid-map");
    assert_eq!(error(ChannelEnds::Points([corners[0], corners[0]]), 1.0).code(), "invalid-map");
    assert_eq!(error(ChannelEnds::Points([c(f64::NAN, 0.0), corners[0]]), 1.0).code(), "not-finite");
}
