//! Plain JavaScript objects → Rust structs. A wrong option is refused in words that name it.

use super::error::Failure;
use crate::plane::{Complex64, Frame};
use js_sys::{Array, Float64Array, Object};
use serde::de::value::Error as Introspected;
use serde::de::{DeserializeOwned, Deserializer, Error as _, Visitor};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify, serde_wasm_bindgen};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** A whole number, 0 or more. */
export type Count = number;

/** A frame, as options hold it. */
export type FrameOptions = Frame;
";

/// A point of the plane.
#[derive(Clone, Copy, Debug, Serialize, Tsify)]
#[serde(into = "[f64; 2]")]
#[tsify(type = "[x: number, y: number]")]
pub struct Point(#[tsify(type = "number")] Complex64);

impl<'de> Deserialize<'de> for Point {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let [x, y] = two_numbers(from, "two numbers [x, y]")?;
        Ok(Self(Complex64::new(x, y)))
    }
}

impl From<Point> for [f64; 2] {
    fn from(Point(z): Point) -> Self {
        [z.re, z.im]
    }
}

impl From<Point> for Complex64 {
    fn from(point: Point) -> Self {
        point.0
    }
}

/// Where a picture lies in the plane: the only place where pixels and the plane meet.
///
/// Pixels are square, pixel centres lie at +0.5, rows count downwards while the plane's y points up.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(rename = "Frame")]
pub struct FrameOptions {
    /// The middle of the picture, in the plane.
    pub center: Point,
    /// Width in plane units; the height follows from `pixels`.
    pub width: f64,
    /// Columns and rows.
    pub pixels: PixelCounts,
}

/// Columns and rows of a picture.
#[derive(Clone, Copy, Debug, Serialize, Tsify)]
#[tsify(type = "[columns: Count, rows: Count]")]
pub struct PixelCounts(#[tsify(type = "number")] [usize; 2]);

impl<'de> Deserialize<'de> for PixelCounts {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        const EXPECTED: &str = "two whole numbers [columns, rows]";
        let counts = two_numbers(from, EXPECTED)?;
        if counts.iter().any(|n| n.fract() != 0.0 || *n < 0.0) {
            return Err(D::Error::custom(format!("expected {EXPECTED}")));
        }
        Ok(Self(counts.map(|n| n as usize)))
    }
}

impl TryFrom<FrameOptions> for Frame {
    type Error = crate::Error;

    fn try_from(FrameOptions { center, width, pixels }: FrameOptions) -> Result<Self, Self::Error> {
        Self::new(center.into(), width, pixels.0)
    }
}

impl From<Frame> for FrameOptions {
    fn from(frame: Frame) -> Self {
        Self { center: Point(frame.center()), width: frame.width(), pixels: PixelCounts(frame.pixels()) }
    }
}

/// An options object → `T`.
///
/// # Errors
/// "invalid-option", with the option's path, for one that is unknown, missing or of the wrong kind.
pub fn read<T: Tsify + DeserializeOwned>(given: &Ts<T>) -> Result<T, Failure> {
    let value = given.js_value();
    refuse_unknown(&value, field_names::<T>())?;
    attempt(&value).map_err(|reason| explained(&value, &reason, &|value| attempt::<T>(value).err()))
}

/// The options, or serde's reason against them. Every kind of options is compiled once, here.
#[inline(never)]
fn attempt<T: DeserializeOwned>(value: &JsValue) -> Result<T, String> {
    T::deserialize(serde_wasm_bindgen::Deserializer::from(value.clone())).map_err(|error| {
        let reason = error.to_string();
        reason.strip_prefix("Error: ").map(str::to_string).unwrap_or(reason)
    })
}

fn explained(value: &JsValue, reason: &str, failure: &dyn Fn(&JsValue) -> Option<String>) -> Failure {
    describe(&culprit(value, reason, failure), reason)
}

/// The path of what fails for a reason: without it there is another reason, or none.
fn culprit(value: &JsValue, reason: &str, failure: &dyn Fn(&JsValue) -> Option<String>) -> String {
    let is_missing = missing(reason).is_some_and(|name| !js_sys::Reflect::has(value, &name.into()).unwrap_or(false));
    if !value.is_object() || is_missing {
        return String::new();
    }
    let is_array = Array::is_array(value);
    for key in Object::keys(value.unchecked_ref::<Object>()).iter() {
        let with = |inner: &JsValue| {
            let copy: JsValue = if is_array {
                Array::from(value).into()
            } else {
                Object::assign(&Object::new(), value.unchecked_ref()).into()
            };
            // A fresh object of its own takes any key.
            let _ = js_sys::Reflect::set(&copy, &key, inner);
            copy
        };
        let without = with(&JsValue::UNDEFINED);
        if !is_array {
            let _ = js_sys::Reflect::delete_property(without.unchecked_ref::<Object>(), &key);
        }
        if failure(&without).as_deref() == Some(reason) {
            continue;
        }
        let inner = js_sys::Reflect::get(value, &key).unwrap_or(JsValue::UNDEFINED);
        let rest = culprit(&inner, reason, &|inner| failure(&with(inner)));
        let key = key.as_string().unwrap_or_default();
        let step = if is_array { format!("[{key}]") } else { key };
        return if rest.is_empty() || rest.starts_with('[') { step + &rest } else { format!("{step}.{rest}") };
    }
    String::new()
}

/// The field that a reason says is missing.
fn missing(reason: &str) -> Option<&str> {
    reason.strip_prefix("missing field `").and_then(|rest| rest.strip_suffix('`'))
}

/// As [`read`], or the defaults where no options are given.
///
/// # Errors
/// As [`read`].
pub fn read_or_default<T: Tsify + DeserializeOwned + Default>(given: Option<&Ts<T>>) -> Result<T, Failure> {
    given.map_or_else(|| Ok(T::default()), read)
}

/// A pair of numbers → a point; `name` is what the caller knows it as.
///
/// # Errors
/// "invalid-option" for anything else.
pub fn read_point(name: &str, given: &Ts<Point>) -> Result<Complex64, Failure> {
    let point = Point::deserialize(serde_wasm_bindgen::Deserializer::from(given.js_value()));
    point.map(Into::into).map_err(|_| Failure::option(name, &format!("{name} must be an array of two numbers.")))
}

/// A Rust value → JavaScript, with its generated type.
///
/// # Errors
/// None that a value of this crate causes: the serialiser's.
pub fn write<T: Tsify + Serialize>(value: &T) -> Result<Ts<T>, Failure> {
    value.into_ts().map_err(|error| Failure::new("internal", &error.to_string()))
}

/// A misspelled option must not be silently ignored.
fn refuse_unknown(value: &JsValue, known: &[&str]) -> Result<(), Failure> {
    if !value.is_object() {
        let known = known.join(", ");
        return Err(Failure::option("", &format!("Options must be an object; its keys can be {known}.")));
    }
    for key in Object::keys(value.unchecked_ref::<Object>()).iter().filter_map(|key| key.as_string()) {
        if !known.contains(&key.as_str()) {
            let message = format!("There is no option \"{key}\"; there are {}.", known.join(", "));
            return Err(Failure::option(&key, &message));
        }
    }
    Ok(())
}

fn describe(path: &str, reason: &str) -> Failure {
    if let Some(name) = missing(reason) {
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        return Failure::option(&path, &format!("The option \"{path}\" is missing."));
    }
    let reason = KINDS.iter().fold(reason.to_string(), |text, (rust, words)| text.replace(rust, words));
    Failure::option(path, &format!("The option \"{path}\" cannot be used: {reason}."))
}

/// Serde's names of types, in words.
const KINDS: [(&str, &str); 6] = [
    ("expected f64", "expected a number"),
    ("expected usize", "expected a whole number, 0 or more"),
    ("expected u32", "expected a whole number, 0 or more"),
    ("expected u8", "expected a whole number from 0 to 255"),
    ("unit value", "undefined or null"),
    ("floating point", "number"),
];

/// The names of a struct's fields, as serde knows them: it hands them to whoever deserialises the struct.
fn field_names<T: DeserializeOwned>() -> &'static [&'static str] {
    struct Asking<'a>(&'a mut &'static [&'static str]);

    impl<'de> Deserializer<'de> for Asking<'_> {
        type Error = Introspected;

        fn deserialize_struct<V: Visitor<'de>>(
            self,
            _name: &'static str,
            fields: &'static [&'static str],
            _visitor: V,
        ) -> Result<V::Value, Self::Error> {
            *self.0 = fields;
            Err(Introspected::custom("only the names were asked for"))
        }

        fn deserialize_any<V: Visitor<'de>>(self, _visitor: V) -> Result<V::Value, Self::Error> {
            Err(Introspected::custom("not a struct"))
        }

        serde::forward_to_deserialize_any! {
            bool i8 i16 i32 i64 u8 u16 u32 u64 f32 f64 char str string bytes byte_buf option unit unit_struct
            newtype_struct seq tuple tuple_struct map enum identifier ignored_any
        }
    }

    let mut names: &'static [&'static str] = &[];
    let _ = T::deserialize(Asking(&mut names));
    names
}

/// An array, of whatever kind, that holds two numbers.
fn two_numbers<'de, D: Deserializer<'de>>(from: D, expected: &str) -> Result<[f64; 2], D::Error> {
    let value: JsValue = serde_wasm_bindgen::preserve::deserialize(from)?;
    let numbers: Option<Vec<f64>> = match js_sys::try_iter(&value) {
        Ok(Some(items)) if !value.is_string() => items.map(|item| item.ok()?.as_f64()).collect(),
        _ => None,
    };
    numbers.and_then(|n| <[f64; 2]>::try_from(n).ok()).ok_or_else(|| D::Error::custom(format!("expected {expected}")))
}

/// For `#[serde(deserialize_with)]`: a `Float64Array`, copied.
///
/// # Errors
/// The deserialiser's, for anything else.
pub fn numbers<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<f64>, D::Error> {
    let value: JsValue = serde_wasm_bindgen::preserve::deserialize(from)?;
    let array = value.dyn_into::<Float64Array>().map_err(|_| D::Error::custom("expected a Float64Array"))?;
    Ok(array.to_vec())
}

/// For `#[serde(default, deserialize_with)]`: a `Float64Array`, copied; none for undefined.
///
/// # Errors
/// The deserialiser's, for anything else.
pub fn some_numbers<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec<f64>>, D::Error> {
    let value: JsValue = serde_wasm_bindgen::preserve::deserialize(from)?;
    if value.is_undefined() || value.is_null() {
        return Ok(None);
    }
    let array = value.dyn_into::<Float64Array>().map_err(|_| D::Error::custom("expected a Float64Array"))?;
    Ok(Some(array.to_vec()))
}

/// For `#[serde(default, deserialize_with)]`: any value, passed through; none for undefined.
///
/// # Errors
/// None.
pub fn some_value<'de, D: Deserializer<'de>>(from: D) -> Result<Option<JsValue>, D::Error> {
    let value: JsValue = serde_wasm_bindgen::preserve::deserialize(from)?;
    Ok((!value.is_undefined() && !value.is_null()).then_some(value))
}

/// For `#[serde(default, deserialize_with)]`: an object of a JavaScript class, passed through; none for undefined.
///
/// # Errors
/// The deserialiser's, for an object of another class.
pub fn object<'de, D: Deserializer<'de>, T: JsCast>(from: D) -> Result<Option<T>, D::Error> {
    let value: JsValue = serde_wasm_bindgen::preserve::deserialize(from)?;
    if value.is_undefined() || value.is_null() {
        return Ok(None);
    }
    let class = std::any::type_name::<T>().rsplit("::").next().unwrap_or_default();
    value.dyn_into().map(Some).map_err(|_| D::Error::custom(format!("expected a {class}")))
}
