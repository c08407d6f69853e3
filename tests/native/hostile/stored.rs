//! Maps stored as bytes: read back to the bit, or refused whatever happened to them.

use super::rounds;
use crate::support::random::{self, Random};
use crate::support::{case, largest, largest_difference, points, solve, spread_points};
use conformal_warp::{Complex64, Curve, FormulaMap, Region, RegionMap, RiemannMap};
use std::f64::consts::TAU;

fn bits(points: &[Complex64]) -> Vec<[u64; 2]> {
    points.iter().map(|z| [z.re.to_bits(), z.im.to_bits()]).collect()
}

/// Everything that a map answers, as bits.
fn answers(map: &RiemannMap) -> Vec<Vec<[u64; 2]>> {
    let inside = spread_points(map.region(), 200);
    let disk: Vec<_> = (0..200).map(|k| Complex64::from_polar(f64::from(k) / 199.0, f64::from(k * k))).collect();
    let boundary: Vec<_> = (0..50).map(|k| map.boundary_point(TAU * f64::from(k) / 50.0).point).collect();
    let evidence = [map.conformal_radius(), map.error_estimate(), map.residual(), map.unknowns() as f64];
    let angles: Vec<_> = map.angles().iter().map(|angle| Complex64::from(*angle)).collect();
    let evidence: Vec<_> = evidence.map(Complex64::from).to_vec();
    let derivative = map.derivative(&inside);
    let both = [map.to_disk(&inside), derivative, map.from_disk(&disk), map.to_disk(&boundary)];
    [boundary, evidence, angles].iter().chain(&both).map(|points| bits(points)).collect()
}

fn ellipse(shift: f64) -> Region {
    let points: Vec<_> = (0..90)
        .map(|k| TAU * f64::from(k) / 90.0)
        .map(|t| Complex64::new(shift - 3.0 * t.cos(), shift + t.sin()))
        .collect();
    Region::new(&points, Curve::Smooth, Complex64::new(shift + 0.5, shift), points[7]).unwrap()
}

#[test]
fn a_map_that_was_stored_is_the_same_to_the_bit() {
    let mut regions: Vec<Region> =
        (0..2 * rounds()).map(|seed| random::region(&mut Random::new(8_000_000 + seed))).collect();
    regions.extend(["neck", "rect20"].map(|name| case(name).region()));
    regions.extend([ellipse(0.0), ellipse(1e6)]);
    for (k, region) in regions.iter().enumerate() {
        let map = solve(region, [1e-8, 1e-4, 1e-10][k % 3]);
        let bytes = map.to_bytes();
        let again = RiemannMap::from_bytes(&bytes).unwrap();
        assert_eq!(answers(&map), answers(&again), "region {k}");
        assert_eq!((again.stop(), again.region()), (map.stop(), map.region()), "region {k}");
        assert_eq!(again.to_bytes(), bytes, "region {k}");
        let (points, known) = (bytes.len() / 8, region.boundary().len() * 4 + map.unknowns() * 2 + 100);
        assert!(points < known, "region {k}: {points} numbers for {known}");

        // Another center: the system, which was not stored, is made when it is needed.
        let center = 0.7 * region.center() + 0.3 * spread_points(region, 1)[0];
        let toward = region.boundary()[0];
        let Ok(moved) = map.with_center(center, toward, &mut |_, _| true) else { continue };
        let also = again.with_center(center, toward, &mut |_, _| true).unwrap();
        let (away, allowed) = (largest_difference(&also, &moved), also.error_estimate() + moved.error_estimate());
        assert!(away <= allowed, "region {k}: {away:e} for {allowed:e}");
        assert_eq!(answers(&RiemannMap::from_bytes(&moved.to_bytes()).unwrap()), answers(&moved), "region {k}, moved");
    }
}

#[test]
fn maps_between_regions_and_formulas_are_stored_too() {
    let map = RegionMap::between(&solve(&case("rect10").region(), 1e-8), &solve(&ellipse(2.0), 1e-8));
    let again = RegionMap::from_bytes(&map.to_bytes()).unwrap();
    let inside = spread_points(map.source().region(), 300);
    let there = map.forward(&inside);
    assert_eq!(bits(&again.forward(&inside)), bits(&there));
    assert_eq!(bits(&again.inverse(&there)), bits(&map.inverse(&there)));

    let mut map = FormulaMap::with_params("t z² + sin(s z)", &[("t", Complex64::I), ("s", Complex64::ONE)]).unwrap();
    map.set_param("s", Complex64::new(0.3, -0.0)).unwrap();
    let again = FormulaMap::from_bytes(&map.to_bytes()).unwrap();
    assert_eq!(again.text(), map.text());
    assert!(again.params().eq(map.params()));
    assert_eq!(bits(&again.eval(&inside)), bits(&map.eval(&inside)));
    assert_eq!(RiemannMap::from_bytes(&map.to_bytes()).unwrap_err().code(), "not-stored");
}

/// The sum at the end made right again, for what somebody has changed on purpose.
fn resummed(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len().saturating_sub(8);
    let step = |sum: u64, byte: &u8| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    let sum = bytes[..end].iter().fold(0xcbf2_9ce4_8422_2325, step);
    bytes.truncate(end);
    bytes.extend_from_slice(&sum.to_le_bytes());
    bytes
}

fn stored() -> [Vec<u8>; 2] {
    let square = points(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]);
    let square = Region::new(&square, Curve::Polygon, Complex64::ZERO, square[0]).unwrap();
    [square, ellipse(0.0)].map(|region| solve(&region, 1e-3).to_bytes())
}

#[test]
fn damage_is_always_noticed() {
    for bytes in stored() {
        for end in 0..bytes.len() {
            let error = RiemannMap::from_bytes(&bytes[..end]).unwrap_err();
            assert!(["not-stored", "damaged"].contains(&error.code()), "{end} bytes: {error}");
        }
        for bit in 0..8 * bytes.len() {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            let error = RiemannMap::from_bytes(&damaged).unwrap_err();
            assert!(["not-stored", "other-format", "damaged"].contains(&error.code()), "bit {bit}: {error}");
        }
    }
}

/// Bytes that were changed and summed anew give an error or a map that answers, and no count is believed.
#[test]
fn forged_bytes_are_refused_or_harmless() {
    let (mut accepted, mut tried) = (0, 0);
    for (kind, bytes) in stored().into_iter().enumerate() {
        let (head, end) = (20, bytes.len() - 8);
        let mut check = |forged: Vec<u8>| {
            tried += 1;
            if let Ok(map) = RiemannMap::from_bytes(&resummed(forged)) {
                accepted += 1;
                let points = [map.region().center(), Complex64::new(0.4, 0.4)];
                let back = map.from_disk(&map.to_disk(&points));
                assert!(back.len() == 2 && map.conformal_radius() >= 0.0);
            }
        };
        for at in (head..end - 4).step_by(3) {
            let mut huge = bytes.clone();
            huge[at..at + 4].copy_from_slice(&u32::MAX.to_le_bytes());
            check(huge);
        }
        for seed in 0..100 * rounds() {
            let mut random = Random::new(9_000_000 + 2 * seed + kind as u64);
            let mut forged = bytes.clone();
            for _ in 0..=random.below(3) {
                let at = head + random.below(end - head);
                forged[at] = random.below(256) as u8;
            }
            check(forged);
        }
        let mut newer = bytes.clone();
        newer[8] = 3;
        assert_eq!(RiemannMap::from_bytes(&resummed(newer)).unwrap_err().code(), "other-format");
    }
    let share = f64::from(accepted) / f64::from(tried);
    assert!(largest([share]) < 1.0 && accepted > 0, "{accepted} of {tried}");
}
