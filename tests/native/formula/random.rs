//! Random formulas: derivatives against differences, and texts of any kind against panics.

use crate::support::random::Random;
use conformal_warp::{Complex64, Error, FormulaMap, Jet, PlaneMap};

const ANALYTIC: &[&str] = &[
    "exp", "log", "sqrt", "sin", "cos", "tan", "sec", "csc", "cot", "sinh", "cosh", "tanh", "sech", "csch", "coth",
    "asin", "acos", "atan", "asec", "acsc", "acot", "asinh", "acosh", "atanh", "asech", "acsch", "acoth", "gamma",
];
/// Special functions, around an argument @.
const SPECIAL: &[&str] = &[
    "sinc(@)",
    "erf(@)",
    "erfc(@)",
    "lambertw(@)",
    "lambertw(@, -1)",
    "lambertw(@, 2)",
    "besselj(0, @)",
    "besselj(-3, @)",
    "besselj(20, 9(@))",
    "zeta(@)",
    "zeta(-5(@))",
    "sn(@, 0.8)",
    "cn(@, t)",
    "dn(2(@), 3t)",
    "wp(@, i)",
    "℘(@, t)",
    "wpp(@, 1/t)",
];
const REAL: &[&str] = &["conj", "re", "im", "abs", "arg"];

/// A formula of that depth at most. `smooth` ones are analytic.
fn formula(random: &mut Random, depth: usize, smooth: bool) -> String {
    if depth == 0 || random.below(8) == 0 {
        return match random.below(6) {
            0 => format!("{:.3}", 4.0 * random.unit() + 0.1),
            // Not i alone: acot(i) is infinite, and derivatives through ∞ are nobody's promise.
            1 => random.pick(&["e", "pi", "t", "(1 + 2i)"]).to_string(),
            _ => "z".to_string(),
        };
    }
    let mut part = || formula(random, depth - 1, smooth);
    let (a, b) = (part(), part());
    match random.below(if smooth { 13 } else { 16 }) {
        0 => format!("({a} + {b})"),
        // The factor keeps z − z, and 1/(z − z), away.
        1 => format!("({a} − 1.3({b}))"),
        2 | 3 => format!("({a})({b})"),
        4 => format!("({a})/({b})"),
        5 => format!("(({a})^{})", random.pick(&["2", "3", "-1", "-2", "7", "0.5", "(1/3)", "(t)", "1.7"])),
        6 => format!("pow({a}, {b})"),
        7 => format!("log({a}, {})", random.pick(&["0", "1", "-2", "t"])),
        8 => format!("sum(n, 1, 3, ({a})/n + n)"),
        9 => format!("iterate(w, {a}, 2, w/2 + z)"),
        10..=12 => format!("{}({a})", random.pick(ANALYTIC)),
        13 => format!("|{a}|"),
        _ => format!("{}({a})", random.pick(REAL)),
    }
}

/// ∂/∂z and ∂/∂z̄ by differences of order 8.
fn differences(map: &FormulaMap, z: Complex64, h: f64) -> [Complex64; 2] {
    const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let along = |step: Complex64| {
        let points: Vec<Complex64> = (1..=4).flat_map(|k| [z + step * f64::from(k), z - step * f64::from(k)]).collect();
        let values = map.eval(&points);
        let pairs = values.as_chunks::<2>().0.iter();
        pairs.zip(WEIGHTS).map(|([after, before], weight)| (after - before) * weight).sum::<Complex64>() / h
    };
    let (dx, dy) = (along(Complex64::new(h, 0.0)), along(Complex64::new(0.0, h)));
    [(dx - Complex64::I * dy) / 2.0, (dx + Complex64::I * dy) / 2.0]
}

/// How many of the points could be judged: differences of two widths agree there.
fn judge(text: &str, random: &mut Random) -> usize {
    let params = [("t", Complex64::new(0.7, -0.4))];
    let map = FormulaMap::with_params(text, &params).unwrap_or_else(|error| panic!("{text}: {error}"));
    let points: Vec<Complex64> =
        (0..4).map(|_| Complex64::new(3.0 * random.unit() - 1.5, 3.0 * random.unit() - 1.5)).collect();
    let mut jets = vec![Jet::UNDEFINED; points.len()];
    map.jets(&points, &mut jets);
    let mut judged = 0;
    for (&z, jet) in points.iter().zip(&jets) {
        let [coarse, fine] = [8e-4, 4e-4].map(|h| differences(&map, z, h));
        let size = fine[0].norm() + fine[1].norm() + jet.value.norm();
        let doubt = (coarse[0] - fine[0]).norm() + (coarse[1] - fine[1]).norm();
        // Singularities within the stencil, and values so large or small that differences overflow or vanish.
        let through_infinity = jet.value == Complex64::ZERO;
        if doubt.is_nan() || doubt > 1e-10 * size || !(1e-100..1e100).contains(&size) || through_infinity {
            continue;
        }
        judged += 1;
        let error = (jet.dz - fine[0]).norm() + (jet.dzbar - fine[1]).norm();
        assert!(error <= 1e-9 * size, "{text} at {z}: {jet:?}, but differences give {fine:?}");
        assert!(!map.is_analytic() || jet.dzbar == Complex64::ZERO);
    }
    judged
}

#[test]
fn derivatives_agree_with_differences() {
    for (seed, smooth) in [(1, true), (2, false)] {
        let mut random = Random::new(seed);
        let mut judged = 0;
        for _ in 0..3000 {
            let text = formula(&mut random, 4, smooth);
            judged += judge(&text, &mut random);
        }
        assert!(judged > 6000, "only {judged} of 12000 points could be judged");
    }
}

#[test]
fn derivatives_of_special_functions_agree_with_differences() {
    let mut random = Random::new(4);
    for template in SPECIAL {
        let mut judged = 0;
        for _ in 0..60 {
            let text = template.replace('@', &formula(&mut random, 2, true));
            judged += judge(&text, &mut random);
        }
        assert!(judged > 60, "{template}: only {judged} of 240 points could be judged");
    }
}

/// Sizes from 1e-300 to 1e300, infinities, parameters of every kind: a number or none, in bounded time.
#[test]
fn special_functions_bear_every_number() {
    let numbers =
        [0.0, -0.0, 1.0, -1.0, 0.5, 2.0, -7.0, 30.0, 499.0, 1e-300, 1e-9, 1e4, -1e6, 1e17, 1e155, 1e300, f64::MAX];
    let mut random = Random::new(5);
    for template in [
        "lambertw(@, t)",
        "besselj(t, @)",
        "sn(@, t)",
        "cn(@, t)",
        "dn(@, t)",
        "wp(@, t)",
        "wpp(@, t)",
        "erf(@) erfc(@)",
        "zeta(@)",
    ] {
        let mut map = FormulaMap::with_params(&template.replace('@', "z"), &[("t", Complex64::ONE)])
            .or_else(|_| FormulaMap::new(&template.replace('@', "z")))
            .unwrap();
        for _ in 0..300 {
            let mut one = || numbers[random.below(numbers.len())];
            let mut number = || Complex64::new(one(), one());
            let (parameter, z) = (number(), number());
            if map.params().next().is_some() {
                map.set_param("t", parameter).unwrap();
            }
            let jet = map.jet(z);
            assert!(jet.value.is_finite() || jet.value.is_nan(), "{template} at {z} for t = {parameter}");
            assert!(!map.jet(Complex64::new(f64::INFINITY, 0.0)).value.is_infinite());
        }
    }
}

#[test]
fn every_text_gives_a_map_or_a_place() {
    let pieces = [
        "z",
        "i",
        "2",
        ".5",
        "1e3",
        "e",
        "π",
        "t",
        "+",
        "-",
        "*",
        "/",
        "^",
        "(",
        ")",
        "|",
        ",",
        "²",
        "⁻",
        "√",
        "\u{304}",
        "sin",
        "log(",
        "sum(n,1,3,",
        "iterate(w,",
        "pow(",
        "w",
        "n",
        " ",
        "iz",
        "𝜏",
        "😀",
        "\u{0}",
        "--",
        "1e999",
        "zz",
        "[",
        "]",
        "γ",
        "℘(",
        "besselj(2,",
    ];
    let mut random = Random::new(3);
    let mut compiled = 0;
    for _ in 0..35_000 {
        let text: String = (0..=random.below(12)).map(|_| random.pick(&pieces)).collect();
        match FormulaMap::with_params(&text, &[("t", Complex64::I)]) {
            Ok(map) => {
                compiled += 1;
                assert_eq!(map.eval(&[Complex64::new(0.3, 0.4)]).len(), 1);
            }
            Err(Error::Syntax { position, expected, found }) => {
                assert!(position <= text.encode_utf16().count(), "{text}: position {position}");
                assert!(!expected.is_empty() && !found.is_empty(), "{text}");
            }
            Err(error) => assert_eq!(error.code(), "formula-too-large", "{text}"),
        }
    }
    assert!(compiled > 1000, "only {compiled} texts were formulas");
}
