//! What formulas may be made of, and what is said of those that may not.

use conformal_warp::{Complex64, Error, FormulaMap, Jet, PlaneMap};

const Z: Complex64 = Complex64::new(0.3, -1.7);

fn value(text: &str) -> Complex64 {
    FormulaMap::new(text).unwrap_or_else(|error| panic!("{text}: {error}")).eval(&[Z])[0]
}

/// (position, expected, found) of a formula's syntax error.
#[track_caller]
fn syntax(text: &str) -> (usize, String, String) {
    match FormulaMap::new(text) {
        Err(Error::Syntax { position, expected, found }) => (position, expected, found),
        other => panic!("{text} gave {other:?}"),
    }
}

#[test]
fn spellings_of_the_same_formula() {
    let same: [&[&str]; 13] = [
        &["2*z", "2z", "2 z", "2·z", "2×z", "z·2"],
        &["3*(z+1)", "3(z+1)", "(z+1)*3", "[z+1]*3"],
        &["z*sin(z)", "z sin(z)", "zsin(z)", "sin(z)z"],
        &["i*z", "iz", "i z", "zi", "(i)(z)"],
        &["2*pi*i", "2πi", "2pi i", "τi", "tau i", "2 i π"],
        &["z^2", "z²", "z**2", "pow(z,2)", "z*z", "z z"],
        &["1/z", "z^-1", "z⁻¹", "z^(-1)", "1÷z"],
        &["-(z^2)", "-z^2", "−z²", "–z**2"],
        &["abs(z)", "|z|", "|(z)|", "||z||"],
        &["abs(z)*abs(z+1)", "|z||z+1|", "|z| |z+1|", "|z|·|z+1|"],
        &["sqrt(z)*2", "√z*2", "2√z", "2√(z)", "2z^.5"],
        &["asin(z)", "arcsin(z)", "Arcsin(z)"],
        &["(1/2)*z", "1/2z", "z/2", ".5z", "5e-1z"],
    ];
    for spellings in same {
        for spelling in &spellings[1..] {
            let (a, b) = (value(spellings[0]), value(spelling));
            assert!((a - b).norm() <= 1e-15 * a.norm(), "{} is {a}, but {spelling} is {b}", spellings[0]);
        }
    }
}

#[test]
fn textbook_spellings() {
    for (a, b) in [
        ("sin z", "sin(z)"),
        ("sin 2z", "sin(2z)"),
        ("sin 2πz cos z", "sin(2πz)cos(z)"),
        ("sin z^2", "sin(z²)"),
        ("sin z (z+1)", "sin(z)(z+1)"),
        ("sin z + 1", "sin(z)+1"),
        ("sin^2(z)", "sin(z)*sin(z)"),
        ("sin²z", "sin(z)*sin(z)"),
        ("2 cosh^3 2z", "2cosh(2z)^3"),
        ("log |z|", "log(abs(z))"),
        ("|sin z|", "abs(sin(z))"),
        ("f(z) = z²", "z^2"),
        ("w = z²", "z^2"),
        ("x² + y²", "|z|^2"),
        ("x + I y", "z"),
        ("Z + I", "z + i"),
        ("log10(z)", "log(z)/log(10)"),
        ("sinc(z)", "sin(z)/z"),
        ("floor(z)", "0 - 2i"),
        ("mod(z, 1)", "0.3 + 0.3i"),
        ("mod(z, 2i)", "z - 2i floor(z/(2i))"),
        ("gamma(z) + 2 i", "gamma(z)+2i"),
    ] {
        let (found, expected) = (value(a), value(b));
        assert!((found - expected).norm() <= 1e-14 * expected.norm(), "{a} is {found}, but {b} is {expected}");
    }
    // A parameter of the name comes first.
    let map = FormulaMap::with_params("x + I", &[("x", Complex64::I), ("I", Complex64::ONE)]).unwrap();
    assert_eq!(map.eval(&[Z])[0], Complex64::new(1.0, 1.0));
    assert!(
        !FormulaMap::new("x").unwrap().is_analytic() && FormulaMap::new("floor(z) + mod(z, 2)").unwrap().is_analytic()
    );
}

#[test]
fn parameters_are_the_names_without_a_meaning() {
    for (text, names) in [
        ("t z + a", &["t", "a"][..]),
        ("az + a", &["a"]),
        ("iterate(w, z, 3, w^2 + c)", &["c"]),
        ("sum(n, 1, 4, z^n/n) + n", &["n"]),
        ("f(z) = x + y I + Z t1 + α", &["t1", "α"]),
        ("e^(i z) + 2e3", &[]),
    ] {
        assert_eq!(FormulaMap::parameters(text).unwrap(), names, "{text}");
    }
    // The mistake is blamed, and not the first parameter.
    let Err(Error::Syntax { position, found, .. }) = FormulaMap::parameters("a z + b + $") else {
        panic!("$ has no meaning")
    };
    assert_eq!((position, found.as_str()), (10, "“$”"));
}

#[test]
fn precedence() {
    assert_eq!(value("2^3^2"), Complex64::new(512.0, 0.0));
    assert_eq!(value("-2^2"), Complex64::new(-4.0, 0.0));
    assert_eq!(value("2^-2*8"), Complex64::new(2.0, 0.0));
    assert_eq!(value("10-4-3"), Complex64::new(3.0, 0.0));
    assert_eq!(value("12/2/3"), Complex64::new(2.0, 0.0));
    assert_eq!(value("2--3"), Complex64::new(5.0, 0.0));
    assert_eq!(value("√4²"), Complex64::new(4.0, 0.0));
    assert_eq!(value("2e-1"), Complex64::new(0.2, 0.0));
}

#[test]
fn branches() {
    let log = value("log(z)");
    assert!((value("log(z,-2)") - log + Complex64::new(0.0, 4.0 * std::f64::consts::PI)).norm() < 1e-15 * 13.0);
    assert_eq!(value("sqrt(z,1)"), -value("sqrt(z)"));
    assert_eq!(value("sqrt(z,2)"), value("sqrt(z)"));
    assert!((value("pow(z,1/3,1)").powi(3) - Z).norm() < 4e-15);
    assert!((value("pow(z,1/3,1)") / value("pow(z,1/3)") - Complex64::cis(std::f64::consts::TAU / 3.0)).norm() < 1e-15);
    assert_eq!(value("sqrt(-4)"), Complex64::new(0.0, 2.0));
    assert_eq!(value("(-1)^0.5"), Complex64::I);
}

#[test]
fn errors_have_a_place_and_an_expectation() {
    let operand = "a number, a name, “(” or “|”";
    for (text, position, expected, found) in [
        ("", 0, operand, "the end"),
        ("2z +", 4, operand, "the end"),
        ("2z + * 3", 5, operand, "“*”"),
        ("(z + 1", 6, "an operator or “)”", "the end"),
        ("|z + 1", 6, "an operator or “|”", "the end"),
        ("z + 1)", 5, "an operator or the end", "“)”"),
        ("z 2", 2, "an operator or the end", "“2”"),
        ("sin + z", 4, "“(” after sin", "“+”"),
        ("pow z", 4, "“(” after pow", "“z”"),
        ("sin^-1(z)", 4, "a positive whole exponent after sin; the inverse function has a name of its own", "“-”"),
        ("2 + cosn(z)", 4, "a name that formulas know, perhaps cosh", "“cosn”"),
        ("0,5 z", 1, "a point in a decimal number, as in 0.5", "“,”"),
        ("f(z) = 2z +", 11, operand, "the end"),
        ("z = = 2", 4, operand, "“=”"),
        ("sin(z, 2)", 5, "an operator or “)”", "“,”"),
        ("pow(z)", 5, "“,” and another argument", "“)”"),
        ("log(z,1,2)", 7, "an operator or “)”", "“,”"),
        ("2 blub", 2, "z, i, e, pi, tau, or a function such as sin", "“blub”"),
        ("z # 2", 2, "a number, a name or an operator", "“#”"),
        ("sum(z, 1, 2, z)", 4, "a name for the running variable, such as n or w", "“z”"),
        ("sum(n, 1, z, n)", 10, "a whole number that depends neither on z nor on a parameter", "a varying value"),
        ("sum(n, 1, 2.5, n)", 10, "a whole number that depends neither on z nor on a parameter", "2.5+0i"),
        ("iterate(w, z, 3)", 15, "“,” and the expression to repeat", "“)”"),
    ] {
        assert_eq!(syntax(text), (position, expected.to_string(), found.to_string()), "{text}");
    }
}

#[test]
fn special_functions_have_a_parameter_without_z() {
    let order = "a whole number up to 500, the order, that does not depend on z";
    for (text, position, expected, found) in [
        ("besselj(z, 2)", 8, order, "a varying value"),
        ("1 + besselj(0.5, z)", 12, order, "0.5+0i"),
        ("besselj(501, z)", 8, order, "501+0i"),
        ("iterate(w, z, 2, besselj(w, z))", 25, order, "a varying value"),
        ("lambertw(z, i)", 12, "a whole number, the branch, that does not depend on z", "0+1i"),
        ("sn(z, 2z)", 6, "a modulus that does not depend on z", "a varying value"),
        ("wp(z, 2)", 6, "a ratio of periods that is not real and does not depend on z", "2+0i"),
        ("wp(z)", 4, "“,” and another argument", "“)”"),
        ("besselj z", 8, "“(” after besselj", "“z”"),
    ] {
        assert_eq!(syntax(text), (position, expected.to_string(), found.to_string()), "{text}");
    }
    assert_eq!(value("lambertw z"), value("lambertw(z, 0)"));
    assert_eq!(value("℘(z, i)"), value("wp(z, 2i/2)"));
    assert_eq!(value("sum(n, 1, 2, besselj(n, z))"), value("besselj(1, z) + besselj(2, z)"));
    // A parameter moves without another program, and an order that is not whole has no value.
    let mut map = FormulaMap::with_params("besselj(n, z)", &[("n", Complex64::ONE)]).unwrap();
    assert_eq!(map.eval(&[Z])[0], value("besselj(1, z)"));
    map.set_param("n", Complex64::new(4.0, 0.0)).unwrap();
    assert_eq!(map.eval(&[Z])[0], value("besselj(4, z)"));
    map.set_param("n", Complex64::new(4.5, 0.0)).unwrap();
    assert!(map.eval(&[Z])[0].is_nan() && map.is_analytic());
}

#[test]
fn positions_are_those_of_javascript() {
    let params = [("𝜏", Complex64::ONE)];
    let Err(Error::Syntax { position, expected, .. }) = FormulaMap::with_params("2𝜏 + blub", &params) else {
        panic!("blub has no meaning")
    };
    assert_eq!(position, "2𝜏 + ".encode_utf16().count());
    assert_eq!(expected, "z, i, e, pi, tau, 𝜏, or a function such as sin");
}

#[test]
fn hostile_texts_are_refused_and_not_run() {
    let deep = |text: &str, n: usize| text.repeat(n);
    let long_sum = format!("z{}", "+z".repeat(4000));
    assert!((value(&long_sum) - Z * 4001.0).norm() < 1e-9);
    for (text, code) in [
        (deep("(", 1_000_000), "formula-too-large"),
        (deep("(", 5_000), "formula-too-large"),
        (deep("-", 5_000), "formula-too-large"),
        (deep("√", 5_000), "formula-too-large"),
        (deep("|", 5_000), "formula-too-large"),
        (deep("z^", 3_000), "formula-too-large"),
        (deep("sin(", 2_000), "formula-too-large"),
        (deep("sum(n,1,9,", 900), "formula-too-large"),
        (deep("z", 9_000), "syntax"),
        ("sum(n, 1, 999999999, 1)".into(), "formula-too-large"),
        ("sum(n, 1, 200, sum(m, 1, 200, z))".into(), "formula-too-large"),
        ("iterate(w, z, 1000000, w)".into(), "formula-too-large"),
        ("sum(n, 1, 1e9, z^n)".into(), "formula-too-large"),
        ("sum(n, -1e15, 1e15, 1)".into(), "formula-too-large"),
        ("sum(n, 1, 1e300, z)".into(), "syntax"),
        ("sum(n, 1, 0/0, z)".into(), "syntax"),
    ] {
        assert_eq!(FormulaMap::new(&text).unwrap_err().code(), code, "{:.30}", text);
    }
    assert_eq!(value("sum(n, 3, 1, z)"), Complex64::ZERO);
    assert_eq!(value("iterate(w, z, 0, w^2)"), Z);
    assert_eq!(value("iterate(w, z, -4, w^2)"), Z);
}

#[test]
fn parameters() {
    let mut map =
        FormulaMap::with_params("t z + t1^2", &[("t", Complex64::I), ("t1", Complex64::new(2.0, 0.0))]).unwrap();
    assert_eq!(map.eval(&[Z])[0], Complex64::I * Z + 4.0);
    map.set_param("t1", Complex64::ZERO).unwrap();
    assert_eq!(map.eval(&[Z])[0], Complex64::I * Z);
    assert_eq!(map.params().collect::<Vec<_>>(), [("t", Complex64::I), ("t1", Complex64::ZERO)]);
    let error = map.set_param("s", Complex64::ONE).unwrap_err();
    assert_eq!(error.to_string(), "The formula has no parameter “s”; it has t, t1.");
    assert_eq!(map.set_param("t", Complex64::new(f64::NAN, 0.0)).unwrap_err().code(), "not-finite");
    for name in ["", "z", "i", "sin", "2a", "a b", "a+", " a"] {
        let error = FormulaMap::with_params("z", &[(name, Complex64::ONE)]).unwrap_err();
        assert_eq!(error.code(), "invalid-parameter", "{name}");
    }
    let twice = FormulaMap::with_params("z", &[("t", Complex64::ONE), ("t", Complex64::ONE)]);
    assert_eq!(twice.unwrap_err().code(), "invalid-parameter");
}

#[test]
fn analyticity_is_seen_where_z_is_concerned() {
    for text in ["z^2 sin(z)", "|2 + i| z", "conj(i) z + arg(-1)", "3", "abs(t) z", "sum(n, 1, 3, z^re(n))"] {
        assert!(FormulaMap::with_params(text, &[("t", Complex64::I)]).unwrap().is_analytic(), "{text}");
    }
    for text in ["conj(z)", "z |z|", "sin(re(z))", "arg(z + 1)", "im(z)", "conj(conj(z))"] {
        assert!(!FormulaMap::new(text).unwrap().is_analytic(), "{text}");
    }
}

#[test]
fn undefined_points_are_nan_and_nothing_panics() {
    let odd =
        [0.0, -0.0, 1.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, 5e-324, 710.0];
    let points: Vec<Complex64> = odd.iter().flat_map(|&x| odd.map(|y| Complex64::new(x, y))).collect();
    let names = "exp log sqrt sin cos tan sec csc cot sinh cosh tanh sech csch coth asin acos atan asec acsc acot asinh \
                 acosh atanh asech acsch acoth gamma sinc floor log10 conj re im arg abs";
    let texts = names.split_whitespace().map(|name| format!("{name}(z)"));
    for text in texts.chain(["1/z", "z/z", "z^z", "z^0.3", "z^-7", "z^(2+i)", "0^z", "1/(1/z)"].map(String::from)) {
        let map = FormulaMap::new(&text).unwrap();
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        map.jets(&points, &mut jets);
        for (z, jet) in points.iter().zip(&jets) {
            assert!(jet.value.is_finite() || (jet.value.is_nan() && jet.dz.is_nan()), "{text} at {z}: {jet:?}");
        }
    }
    assert!(FormulaMap::new("1/z").unwrap().eval(&[Complex64::ZERO])[0].is_nan());
    // Infinity on the way is the sphere's.
    assert_eq!(FormulaMap::new("1/(1 + 1/z)").unwrap().eval(&[Complex64::ZERO])[0], Complex64::ZERO);
    assert_eq!(FormulaMap::new("exp(-1/z^2)").unwrap().eval(&[Complex64::ZERO])[0], Complex64::ZERO);
}

#[test]
fn block_boundaries_do_not_show() {
    let map = FormulaMap::new("z^3 exp(z)/(z - 2) + |z|").unwrap();
    let points: Vec<Complex64> = (0..200).map(|k| Complex64::cis(0.1 * f64::from(k)) * 1.5).collect();
    let all = map.eval(&points);
    for (k, &point) in points.iter().enumerate() {
        assert_eq!(map.eval(&[point])[0], all[k], "point {k}");
    }
    assert!(map.eval(&[]).is_empty());
}
