//! The presets in JavaScript.

use super::options;
use super::points;
use super::words::words;
use super::writing::{object, written};
use crate::presets::{self, Picture, Placement};
use crate::warp::{Direction, Wrap};
use js_sys::Array;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** A frame without pixel counts, as presets hold it. */
export type PlacementOptions = Placement;
";

/// A formula and how to look at it: `new FormulaMap(preset.formula, { params: preset.params })`.
#[derive(Debug, Tsify)]
pub struct Preset {
    /// A short stable name: letters and hyphens.
    pub name: &'static str,
    /// A heading.
    pub title: &'static str,
    /// What the picture shows, in a sentence.
    pub shows: &'static str,
    /// The formula.
    pub formula: &'static str,
    /// Its parameters and their first values.
    #[tsify(type = "Record<string, [re: number, im: number]>")]
    pub params: JsValue,
    /// Which way the formula is used.
    pub direction: Direction,
    /// Where the picture lies.
    pub texture: PlacementOptions,
    /// What part of the plane to look at.
    pub view: PlacementOptions,
    /// How the picture continues.
    pub wrap: Wrap,
    /// The kind of picture that shows it best.
    pub picture: Picture,
}
written!(Preset: name, title, shows, formula, params, direction, texture, view, wrap, picture);

/// A frame without pixel counts.
#[derive(Debug, Tsify)]
#[tsify(rename = "Placement")]
pub struct PlacementOptions {
    /// The middle, in the plane.
    #[tsify(type = "[x: number, y: number]")]
    pub center: Array,
    /// Width in plane units.
    pub width: f64,
}
written!(PlacementOptions: center, width);

/// All presets.
#[derive(Debug, Tsify)]
#[tsify(type = "Preset[]")]
pub struct Presets(#[tsify(type = "Preset[]")] Array);

impl From<Presets> for JsValue {
    fn from(presets: Presets) -> Self {
        presets.0.into()
    }
}

words! {
    /// Kinds of pictures.
    Picture { Photo = "photo", Lattice = "lattice" }
}

impl From<Placement> for PlacementOptions {
    fn from(Placement { center, width }: Placement) -> Self {
        Self { center: points::pair(center), width }
    }
}

impl From<&presets::Preset> for Preset {
    fn from(preset: &presets::Preset) -> Self {
        let parameters = preset.params.iter().map(|&(name, value)| (name, points::pair(value).into()));
        Self {
            name: preset.name,
            title: preset.title,
            shows: preset.shows,
            formula: preset.formula,
            params: object(&parameters.collect::<Vec<_>>()),
            direction: preset.direction,
            texture: preset.texture.into(),
            view: preset.view.into(),
            wrap: preset.wrap,
            picture: preset.picture,
        }
    }
}

/// Named formulas with frames that show them well: the report's figures 1 and 2, and the classics.
#[wasm_bindgen(js_name = presets)]
pub fn all() -> Ts<Presets> {
    options::write(Presets(presets::PRESETS.iter().map(Preset::from).map(JsValue::from).collect()))
}
