//! `FormulaMap` in JavaScript.

use super::error::Failure;
use super::options::{self, Point};
use super::overlay::{self, OverlayOptions};
use super::points;
use super::reading::{Read, Refused, entries, fields};
use super::warp::{self};
use crate::warp::Direction;
use js_sys::{Object, Uint8ClampedArray};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// What belongs to a formula.
#[derive(Debug, Default, Tsify)]
pub struct FormulaOptions {
    /// The parameters that the formula may name, with their first values `[re, im]`.
    #[tsify(optional, type = "Record<string, [re: number, im: number]>")]
    pub params: Option<Parameters>,
}
fields!(FormulaOptions: params);

/// Parameters and their first values.
#[derive(Debug)]
pub struct Parameters(Vec<(String, Point)>);

impl Read for Parameters {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        entries(value).map(Self)
    }
}

/// A map plane → plane given by a formula in z, compiled once: `new FormulaMap("(z - 1)/(z + 1)")`.
///
/// - `z`; `i`, `e`, `pi` or `π`, `tau` or `τ`; numbers; the parameters.
/// - `+ − * / ^`, parentheses, `|z|`; multiplication may be left out: `2z`, `3(z+1)`, `z sin(z)`. `z²`, `√`, `z̄` work too.
/// - `exp log sqrt pow`; `sin cos tan sec csc cot`, the same with `h`, and the inverses of all with `a` or `arc` before
///   the name; `gamma`; `conj re im arg abs`.
/// - `x` and `y` are re(z) and im(z), unless a parameter has the name; `f(z) =` may stand before all. `sin z`, `sin²(z)`.
/// - `log10 sinc floor`, `mod(z, m)`; `erf erfc zeta`.
/// - `lambertw(z, k)`, `besselj(n, z)`, Jacobi's `sn(z, k)`, `cn(z, k)`, `dn(z, k)` of modulus k, Weierstrass's `wp(z, t)` of the
///   lattice 1, t, and `wpp`, its derivative; k, n and t must not depend on z.
/// - Branches: `log(z, k)`, `sqrt(z, k)`, `pow(z, a, k)`; `sum(n, 1, 10, z^n/n)`, `prod(…)`, `iterate(w, z, 8, w^2 + z)`.
#[derive(Debug)]
#[wasm_bindgen]
pub struct FormulaMap(crate::formula::FormulaMap);

#[wasm_bindgen]
impl FormulaMap {
    /// Compiles the formula.
    ///
    /// Throws "syntax" with the `position` in the text, "formula-too-large", "invalid-parameter" or "invalid-option".
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str, options: Option<Ts<FormulaOptions>>) -> Result<Self, Failure> {
        let FormulaOptions { params } = options::read_or_default(options.as_ref())?;
        let params: Vec<_> =
            params.iter().flat_map(|params| &params.0).map(|(name, value)| (name.as_str(), (*value).into())).collect();
        Ok(Self(crate::formula::FormulaMap::with_params(text, &params)?))
    }

    /// The formula and its parameters' present values as bytes, to be stored or sent to a worker.
    #[wasm_bindgen(js_name = toBytes)]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.0.to_bytes()
    }

    /// The map that `toBytes` stored.
    ///
    /// Throws "not-stored", "other-format" or "damaged", and what the constructor throws.
    #[wasm_bindgen(js_name = fromBytes)]
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Failure> {
        Ok(Self(crate::formula::FormulaMap::from_bytes(bytes)?))
    }

    /// The names that a formula uses and that mean nothing by themselves, in the order in which they first appear: its
    /// parameters. Names that `sum`, `prod` and `iterate` bind are not among them.
    ///
    /// Throws "syntax" with the `position` in the text, or "formula-too-large".
    pub fn parameters(text: &str) -> Result<Vec<String>, Failure> {
        Ok(crate::formula::FormulaMap::parameters(text)?)
    }

    /// f at each point `[x0, y0, x1, y1, …]`; NaN where it is not defined.
    pub fn eval(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.0.eval(&points)))
    }

    /// ∂f/∂z at each point, which is f' where the map is analytic; NaN where f is not defined.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.0.derivative(&points)))
    }

    /// Gives a parameter another value `[re, im]`. Nothing is compiled again.
    ///
    /// Throws "unknown-parameter" or "not-finite".
    #[wasm_bindgen(js_name = setParam)]
    pub fn set_param(&mut self, name: &str, value: Ts<Point>) -> Result<(), Failure> {
        Ok(self.0.set_param(name, options::read_point("value", &value)?)?)
    }

    /// A drawing that explains the map, to be laid over its picture: grids pulled back, stretch, argument. RGBA bytes with
    /// straight alpha; `out`, drawn over, if it was given.
    ///
    /// Throws "invalid-option", "invalid-frame", "invalid-rows" or "wrong-length".
    pub fn overlay(&self, options: Ts<OverlayOptions>) -> Result<Uint8ClampedArray, Failure> {
        overlay::draw(&self.0, &options)
    }

    /// The parameters and their present values.
    #[wasm_bindgen(getter, unchecked_return_type = "Record<string, [re: number, im: number]>")]
    pub fn params(&self) -> Result<Object, Failure> {
        let entries = self.0.params().map(|(name, value)| js_sys::Array::of2(&name.into(), &points::pair(value)));
        Object::from_entries(&entries.collect::<js_sys::Array>()).map_err(Failure::thrown)
    }

    /// The formula as it was given.
    #[wasm_bindgen(getter)]
    pub fn text(&self) -> String {
        self.0.text().to_string()
    }

    /// Whether the map is analytic where it is defined: no `conj`, `re`, `im`, `abs` or `arg` of what depends on z.
    #[wasm_bindgen(getter, js_name = isAnalytic)]
    pub fn is_analytic(&self) -> bool {
        self.0.is_analytic()
    }
}

warp::warp_methods! {
    FormulaMap, Direction::PullBack,
    " The texture as the formula shows it: RGBA bytes with straight alpha; `out`, filled, if it was given. A formula"
    " pulls back unless the options say `push-forward`, which draws the image of the texture's frame."
}

impl FormulaMap {
    /// The map itself, for the classes that are made from one.
    #[must_use]
    pub fn inner(&self) -> &crate::formula::FormulaMap {
        &self.0
    }
}
