//! Maps onto rings against exact and published moduli.

use super::{curve, options, square};
use crate::support::points;
use conformal_warp::{AnnulusMap, Complex64, Curve, Domain, Stop};
use std::f64::consts::TAU;

fn ring(outer: &[Complex64], hole: &[Complex64], curve: Curve) -> AnnulusMap {
    let domain = Domain::new(outer, &[hole.to_vec()], curve).unwrap();
    AnnulusMap::solve(&domain, &options(1e-12), &mut |_, _| true).unwrap()
}

/// Square in square, half-sides a and 1 (exact): a, capacity, inner radius.
const FRAMES: [(f64, f64, f64); 11] = [
    (0.1, 2.839_777_419_052_236_6, 0.109_419_889_621_631_14),
    (0.2, 4.134_487_024_234_089_6, 0.218_777_225_865_129_03),
    (0.25, 4.844_419_548_422_174_1, 0.273_352_130_910_173_72),
    (0.3, 5.632_828_000_941_653_2, 0.327_764_997_112_514_42),
    (0.4, 7.561_531_539_810_583_1, 0.435_639_230_224_850_78),
    (0.5, 10.234_092_569_368_051_7, 0.541_210_760_957_991_01),
    (0.6, 14.234_879_675_824_352_0, 0.643_139_493_472_939_94),
    (0.7, 20.901_581_676_413_955_4, 0.740_367_846_497_672_95),
    (0.75, 26.234_915_195_912_196_9, 0.787_023_579_735_851_74),
    (0.8, 34.234_915_198_773_434_1, 0.832_325_657_835_606_23),
    (0.9, 74.234_915_198_778_787_3, 0.918_843_725_197_075_07),
];

#[test]
fn square_frames() {
    for (half, capacity, radius) in FRAMES {
        let map = ring(&square(1.0), &square(half), Curve::Polygon);
        let error = (map.inner_radius() - radius).abs();
        println!(
            "a = {half}: error {error:.1e}, capacity {:.1e}, estimate {:.1e}, {} unknowns, {:?}",
            (map.capacity() / capacity - 1.0).abs(),
            map.error_estimate(),
            map.unknowns(),
            map.stop()
        );
        assert!(error < 1e-12, "a = {half}: {error:e}");
        assert!((map.capacity() / capacity - 1.0).abs() < 1e-12);
        assert_eq!(map.stop(), Stop::Tolerance, "a = {half}: {:e}", map.error_estimate());
    }
}

#[test]
fn smooth_rings() {
    let circle = |center: f64, radius: f64| curve(64, |t| center + Complex64::from_polar(radius, t));
    let ellipse = |center: f64, a: f64, b: f64, turn: f64| {
        curve(64, |t| center + Complex64::new(a * t.cos(), b * t.sin()) * Complex64::cis(turn))
    };
    let star =
        |waves: f64, size: f64, depth: f64| curve(256, |t| Complex64::from_polar(size + depth * (waves * t).cos(), t));
    let cases = [
        ("eccentric .5 .25", circle(0.0, 1.0), circle(0.5, 0.25), 0.344_131_154_255_050_2),
        ("eccentric .3 .5", circle(0.0, 1.0), circle(0.3, 0.5), 0.572_122_461_732_037_3),
        ("eccentric .2 .3", circle(0.0, 1.0), circle(0.2, 0.3), 0.313_859_338_365_492_84),
        ("ellipses of chebfun", ellipse(-1.0, 3.0, 1.8, 0.0), ellipse(0.0, 1.0, 0.6, 0.5), 0.409_705_344_001_634),
        (
            "curves of chebfun's help",
            curve(128, |t| Complex64::cis(t) * (1.0 + 0.1 * Complex64::cis(4.0 * t)).norm()),
            curve(128, |t| 0.5 * Complex64::cis(t) * (1.0 + 0.2 * Complex64::cis(3.0 * t)).norm()),
            0.539_197_261_773_603,
        ),
        ("wiggly curves of chebfun", star(8.0, 2.0, 0.1), star(5.0, 1.0, 0.1), 0.515_907_564_661_645),
        // Confocal: ρ is the ratio of the sums of the semi-axes.
        (
            "confocal ellipses",
            ellipse(0.0, 2.0, 3f64.sqrt(), 0.0),
            ellipse(0.0, 1.25, 0.75, 0.0),
            2.0 / (2.0 + 3f64.sqrt()),
        ),
    ];
    for (name, outer, hole, radius) in cases {
        let map = ring(&outer, &hole, Curve::Smooth);
        let error = (map.inner_radius() - radius).abs();
        println!("{name}: error {error:.1e}, estimate {:.1e}, {} unknowns", map.error_estimate(), map.unknowns());
        assert!(error < 1e-12, "{name}: {error:e}");
        assert_eq!(map.stop(), Stop::Tolerance, "{name}");
    }
}

/// SC Toolbox, tests/testAnnulus.m: the three values that it lists, which are rounded to 1e-10 and turned.
#[test]
fn toolbox_ring() {
    let outer = points(&[
        [-2.0335, 3.0056],
        [-3.3743, -0.4358],
        [-2.3911, -2.5363],
        [0.3799, -3.2737],
        [2.6816, -1.3073],
        [3.2402, 2.6704],
        [1.1844, 3.3855],
    ]);
    let hole = points(&[[-0.5363, 0.8603], [-0.6034, 0.2570], [0.2682, -0.0559], [0.2682, 1.0838]]);
    let map = ring(&outer, &hole, Curve::Polygon);
    assert!((map.inner_radius() - 0.164_826_723_016).abs() < 1e-12, "{}", map.inner_radius());
    assert!((map.capacity() - 3.485_120_027_85).abs() < 1e-11);
    let values = points(&[
        [0.701_045_278_132_939, 1.857_617_315_721_354],
        [-1.950_884_613_357_281, 1.858_444_064_736_838],
        [-2.520_096_092_184_397, -2.260_713_861_045_573],
    ]);
    let images = map.to_annulus(&values);
    // The last lies on the circle up to 1e-10, which may be outside.
    let last = map.to_annulus(&[values[2] * (1.0 - 1e-10)])[0];
    let turn = images[0] / 0.5;
    assert!((turn.norm() - 1.0).abs() < 1e-9, "{turn}");
    assert!((images[1] - Complex64::new(0.0, 0.8) * turn).norm() < 1e-9, "{images:?}");
    assert!((last + turn).norm() < 1e-9, "{last}");
}

/// w → z → w and z → w → z, in the ring, at its walls and beside corners.
#[test]
fn there_and_back() {
    let outer = points(&[[-2.0, -1.0], [1.0, -1.5], [2.0, 0.5], [0.5, 0.6], [0.0, 2.0], [-1.5, 1.0]]);
    let hole = points(&[[-0.5, -0.5], [0.5, -0.3], [-0.2, 0.5]]);
    for curve_kind in [Curve::Polygon, Curve::Smooth] {
        let (outer, hole) = if curve_kind == Curve::Polygon {
            (outer.clone(), hole.clone())
        } else {
            (
                curve(64, |t| Complex64::new(2.0 * t.cos(), 1.2 * t.sin())),
                curve(64, |t| Complex64::new(0.3, 0.1) + 0.4 * Complex64::cis(t)),
            )
        };
        let map = ring(&outer, &hole, curve_kind);
        let radius = map.inner_radius();
        let mut images = Vec::new();
        for share in [0.0, 1e-9, 0.01, 0.3, 0.5, 0.9, 1.0 - 1e-6, 1.0] {
            let r = radius.powf(share);
            images.extend((0..23).map(|k| Complex64::from_polar(r, 0.1 + TAU * f64::from(k) / 23.0)));
        }
        let places = map.from_annulus(&images);
        let again = map.to_annulus(&places);
        for ((w, z), back) in images.iter().zip(&places).zip(&again) {
            assert!(map.domain().contains(*z), "{w} came to {z}");
            assert!((back - w).norm() < 1e-9, "{curve_kind:?} {w} → {z} → {back}");
        }
        let inside = |z: &Complex64| map.domain().contains(*z);
        let grid: Vec<Complex64> = (0..400)
            .map(|k| Complex64::new(f64::from(k % 20) * 0.2 - 1.93, f64::from(k / 20) * 0.2 - 1.87))
            .filter(inside)
            .collect();
        let back = map.from_annulus(&map.to_annulus(&grid));
        for (z, back) in grid.iter().zip(&back) {
            assert!((back - z).norm() < 1e-9, "{curve_kind:?} {z} came back to {back}");
        }
        let h = 1e-5;
        for z in &grid {
            let [before, after] = [z - h, z + h].map(|z| map.to_annulus(&[z])[0]);
            let slope = map.derivative(&[*z])[0];
            let difference = (after - before) / (2.0 * h);
            if !difference.is_nan() && map.domain().contains(z + 0.02) && map.domain().contains(z - 0.02) {
                assert!((slope - difference).norm() < 1e-5 * slope.norm(), "{z}: {slope} {difference}");
            }
        }
        let nan = map.to_annulus(&[Complex64::new(9.0, 9.0), hole.iter().sum::<Complex64>() / hole.len() as f64]);
        assert!(nan.iter().all(|w| w.is_nan()), "{nan:?}");
        let beyond = [Complex64::ZERO, Complex64::new(1.001, 0.0), Complex64::new(0.0, 0.99 * radius)];
        assert!(map.from_annulus(&beyond).iter().all(|z| z.is_nan()));
    }
}
