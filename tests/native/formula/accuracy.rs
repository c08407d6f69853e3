//! Formulas against tables made by mpmath (tests/fixtures/formula/make.py).

use conformal_warp::presets::PRESETS;
use conformal_warp::{Complex64, FormulaMap, Jet, PlaneMap};
use serde::Deserialize;

#[derive(Deserialize)]
struct Table {
    name: String,
    /// z, value, derivatives: two numbers each.
    rows: Vec<Vec<f64>>,
}

fn tables(text: &str) -> Vec<Table> {
    serde_json::from_str(text).expect("the fixtures are JSON")
}

fn complex(row: &[f64], index: usize) -> Complex64 {
    Complex64::new(row[2 * index], row[2 * index + 1])
}

/// |a − b| / |b|; what underflows is compared with the smallest normal number.
fn relative_error(a: Complex64, b: Complex64) -> f64 {
    (a - b).norm() / b.norm().max(f64::MIN_POSITIVE)
}

/// The largest relative errors of value and derivative over a table, each with its point.
fn worst(map: &FormulaMap, rows: &[Vec<f64>]) -> [(f64, Complex64); 2] {
    let points: Vec<Complex64> = rows.iter().map(|row| complex(row, 0)).collect();
    let mut jets = vec![Jet::UNDEFINED; points.len()];
    map.jets(&points, &mut jets);
    let mut worst = [(0.0, Complex64::ZERO); 2];
    for (row, jet) in rows.iter().zip(&jets) {
        for (index, computed) in [jet.value, jet.dz].into_iter().enumerate() {
            let error = relative_error(computed, complex(row, 1 + index));
            // NaN must not pass for small.
            if error.is_nan() || error > worst[index].0 {
                worst[index] = (error, complex(row, 0));
            }
        }
    }
    worst
}

#[test]
fn functions_agree_with_mpmath() {
    for Table { name, rows } in tables(include_str!("../../fixtures/formula/functions.json")) {
        let map = FormulaMap::new(&format!("{name}(z)")).unwrap();
        let (value, slope) = match name.as_str() {
            "gamma" => (1e-13, 1e-13),
            // 1/z is rounded before the function sees it.
            "asec" | "acsc" | "acot" | "asech" | "acsch" | "acoth" => (4e-15, 8e-15),
            _ => (1e-15, 2e-15),
        };
        let [(value_error, at), (slope_error, slope_at)] = worst(&map, &rows);
        assert!(value_error <= value, "{name}({at}) is wrong by {value_error:e}");
        assert!(slope_error <= slope, "{name}'({slope_at}) is wrong by {slope_error:e}");
    }
}

/// A function of the table special.json, which special.py writes.
#[derive(Deserialize)]
struct Special {
    name: String,
    tolerance: f64,
    /// z, value, derivative; then the sizes that errors of the two are relative to.
    rows: Vec<[f64; 8]>,
}

#[test]
fn special_functions_agree_with_mpmath() {
    let tables: Vec<Special> =
        serde_json::from_str(include_str!("../../fixtures/formula/special.json")).expect("the fixtures are JSON");
    for Special { name, tolerance, rows } in tables {
        let map = FormulaMap::new(&name).unwrap();
        for row in rows {
            let (z, jet) = (complex(&row, 0), map.jet(complex(&row, 0)));
            for (found, expected, size) in [(jet.value, complex(&row, 1), row[6]), (jet.dz, complex(&row, 2), row[7])] {
                let error = (found - expected).norm() / size;
                assert!(error <= tolerance, "{name} at {z}: {found:e} is not {expected:e}, wrong by {error:e}");
            }
        }
    }
}

/// Scales of 1e±300, the neighbourhoods of poles and branch points, both sides of cuts.
#[test]
fn functions_agree_with_mpmath_where_numbers_end() {
    #[derive(Deserialize)]
    struct Extremes {
        name: String,
        /// z; value and derivative where a double holds them.
        rows: Vec<[Option<Vec<f64>>; 3]>,
    }
    let mut wrong = Vec::new();
    let tables: Vec<Extremes> =
        serde_json::from_str(include_str!("../../fixtures/formula/extremes.json")).expect("the fixtures are JSON");
    for Extremes { name, rows } in tables {
        let map = FormulaMap::new(&format!("{name}(z)")).unwrap();
        for [at, value, slope] in rows {
            let z = complex(&at.unwrap(), 0);
            let jet = map.jet(z);
            for (what, found, expected) in [("", jet.value, value), ("'", jet.dz, slope)] {
                let Some(expected) = expected else { continue };
                let error = relative_error(found, complex(&expected, 0));
                if error.is_nan() || error > 1e-14 {
                    wrong.push(format!("{name}{what}({z:e}) = {found:e}, not {:e}", complex(&expected, 0)));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} values are wrong:\n{}", wrong.len(), wrong[..wrong.len().min(60)].join("\n"));
}

#[test]
fn inverse_functions_are_right_beside_their_poles() {
    let fault: serde_json::Value =
        serde_json::from_str(include_str!("../../fixtures/faults/atanh-near-pole.json")).unwrap();
    let pairs = |key: &str| -> Vec<Complex64> {
        let pairs = fault[key].as_array().unwrap().iter();
        pairs.map(|p| Complex64::new(p[0].as_f64().unwrap(), p[1].as_f64().unwrap())).collect()
    };
    let (points, expected) = (pairs("points"), pairs("expected"));
    let turned: Vec<Complex64> = points.iter().map(|z| Complex64::new(z.im, -z.re)).collect();
    let conjugate: Vec<Complex64> = points.iter().map(|z| z.conj()).collect();
    for (text, points) in [("atanh(z)", &points), ("i atan(z)", &turned), ("acoth(z)", &conjugate)] {
        for (found, expected) in FormulaMap::new(text).unwrap().eval(points).iter().zip(&expected) {
            // Re is even in y, Im is odd; 1/z has the other sign of y.
            assert!(relative_error(*found, *expected) < 1e-15, "{text}: {found} is not {expected}");
        }
    }
}

#[test]
fn formulas_agree_with_mpmath() {
    let params = [("t", Complex64::new(0.75, -0.5)), ("a", Complex64::new(1.5, 0.25))];
    for Table { name, rows } in tables(include_str!("../../fixtures/formula/formulas.json")) {
        let map = FormulaMap::with_params(&name, &params).unwrap();
        let points: Vec<Complex64> = rows.iter().map(|row| complex(row, 0)).collect();
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        map.jets(&points, &mut jets);
        assert_eq!(map.eval(&points), jets.iter().map(|jet| jet.value).collect::<Vec<_>>(), "{name}");
        for (row, jet) in rows.iter().zip(&jets) {
            let [value, dz, dzbar] = [1, 2, 3].map(|index| complex(row, index));
            let z = complex(row, 0);
            // The exponent of z^100 multiplies the rounding errors of the products.
            let tolerance = if name.contains("100") || name.contains("37") { 1e-13 } else { 2e-14 };
            assert!(relative_error(jet.value, value) < tolerance, "{name} at {z}: {} is not {value}", jet.value);
            let size = tolerance * (dz.norm() + dzbar.norm()).max(1e-3);
            assert!((jet.dz - dz).norm() < size, "∂({name})/∂z at {z}: {} is not {dz}", jet.dz);
            assert!((jet.dzbar - dzbar).norm() < size, "∂({name})/∂z̄ at {z}: {} is not {dzbar}", jet.dzbar);
            assert!(!map.is_analytic() || jet.dzbar == Complex64::ZERO);
        }
    }
}

#[test]
fn every_preset_agrees_with_mpmath() {
    let tables = tables(include_str!("../../fixtures/formula/presets.json"));
    for preset in &PRESETS {
        let table = tables.iter().find(|table| table.name == preset.name);
        let rows = &table.unwrap_or_else(|| panic!("{} has no table", preset.name)).rows;
        let [(value_error, at), (slope_error, slope_at)] = worst(&preset.map().expect("presets compile"), rows);
        assert!(value_error < 2e-15, "{} at {at} is wrong by {value_error:e}", preset.name);
        assert!(slope_error < 4e-15, "{}' at {slope_at} is wrong by {slope_error:e}", preset.name);
    }
}
