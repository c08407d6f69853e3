//! Slits against closed forms: Joukowski's map z = m + h/2 (ζ + 1/ζ) opens a slit into the unit circle, and the curves that come
//! out are smooth.

use super::{curve, options, square};
use crate::support::c;
use conformal_warp::{AnnulusMap, Complex64, Conductors, Curve, Domain, Electrostatics, Stop};

/// The ζ outside the unit circle that goes to z, for the slit from `a` to `b`.
fn opened(z: Complex64, a: f64, b: f64) -> Complex64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let u = (z - middle) / half;
    let root = (u - 1.0).sqrt() * (u + 1.0).sqrt();
    let zeta = u + root;
    if zeta.norm_sqr() >= 1.0 { zeta } else { zeta.inv() }
}

/// The capacity of the unit disk less a slit of the real axis. Points are denser where the slit comes near.
fn disk_less_slit(a: f64, b: f64, points: usize, denser: f64) -> AnnulusMap {
    let circle = curve(64, Complex64::cis);
    let outer = curve(points, |t| opened(Complex64::cis(t - 0.5 * denser * (2.0 * t).sin()), a, b));
    let domain = Domain::new(&outer, &[circle], Curve::Smooth).unwrap();
    AnnulusMap::solve(&domain, &options(1e-12), &mut |_, _| true).unwrap()
}

#[test]
fn disks_and_strips_less_a_slit() {
    let mut cases = vec![(0.0, 0.5, 3.126_803_845_392_223)];
    for (r, capacity) in [
        (0.25, 3.022_284_230_256_451_2),
        (0.5, 4.558_728_415_935_349_5),
        (0.75, 6.720_171_709_461_469_6),
        (0.9, 9.263_034_649_375_816_4),
    ] {
        cases.push((-r, r, capacity));
    }
    // The strip |Im| < π/2 less [−is, is] is the disk less a slit of length 2 tan(s/2), by tanh(z/2).
    for (s, capacity) in [
        (0.1f64, 1.703_662_933_054_232_7),
        (0.25, 2.270_486_340_549_104_6),
        (0.5, 3.053_400_295_538_071_4),
        (1.0, 4.885_188_789_695_906_1),
        (1.5, 10.272_049_808_010_688),
        (1.55, 13.392_537_613_450_108),
    ] {
        let r = (0.5 * s).tan();
        cases.push((-r, r, capacity));
    }
    for (a, b, capacity) in cases {
        let near = b.max(-a);
        let (points, denser) = if near < 0.6 { (128, 0.3) } else { (512, 0.9) };
        let map = disk_less_slit(a, b, points, denser);
        let error = (map.capacity() / capacity - 1.0).abs();
        println!("[{a}, {b}]: {error:.1e}, estimate {:.1e}, {:?}", map.error_estimate(), map.stop());
        assert!(error < 1e-12, "[{a}, {b}]: {error:e}");
        assert_eq!(map.stop(), Stop::Tolerance);
    }
}

/// The strips [−1, −k] and [k, 1] in the plane, and their logarithmic capacity √(1 − k²)/2.
#[test]
fn two_strips_in_one_plane() {
    let k = 0.5;
    // The first is opened; the second lies on the axis between `near` and `far` then.
    let [near, far] = [k, 1.0].map(|x| opened(c(x, 0.0), -1.0, -k).re);
    let map = disk_less_slit(1.0 / far, 1.0 / near, 512, 0.6);
    let error = (map.capacity() / 1.279_261_571_171_006_5 - 1.0).abs();
    assert!(error < 1e-12, "{error:e}");
    let bodies = [curve(64, Complex64::cis), curve(256, |t| opened(Complex64::cis(t), near, far))];
    let outside = Domain::exterior(&bodies, Curve::Smooth).unwrap();
    let given = Conductors::Charges(vec![1.0, -1.0]);
    let field = Electrostatics::solve(&outside, &given, &options(1e-12), &mut |_, _| true).unwrap();
    // Each opening shrinks what is far away by half the slit's half length.
    let shrunk = (0.25 * (1.0 - k)) * (0.25 * (far - near));
    let capacity = field.logarithmic_capacity().unwrap() * shrunk;
    let error = (capacity / (0.5 * (1.0 - k * k).sqrt()) - 1.0).abs();
    assert!(error < 1e-12, "{error:e}");
    assert!((field.capacitance()[0][0] / 1.279_261_571_171_006_5 - 1.0).abs() < 1e-12);
}

/// Square coaxial lines in air, in ohms.
#[test]
fn square_lines() {
    for (half, impedance) in [(0.5, 36.811_306_020_4), (0.25, 77.765_831_313_0)] {
        let frame = Domain::new(&square(1.0), &[square(half)], Curve::Polygon).unwrap();
        let given = Conductors::Potentials(vec![0.0, 1.0]);
        let field = Electrostatics::solve(&frame, &given, &options(1e-12), &mut |_, _| true).unwrap();
        assert!((field.impedance().unwrap() - impedance).abs() < 1e-9, "{:?}", field.impedance());
    }
}
