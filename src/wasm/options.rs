//! Plain JavaScript objects → Rust structs. A wrong option is refused in words that name it.

use super::error::Failure;
use super::points;
use super::reading::{Read, Refusal, Refused, fields, items};
use super::writing::written;
use crate::plane::{Complex64, Frame};
use js_sys::Array;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** A whole number, 0 or more. */
export type Count = number;

/** A frame, as options hold it. */
export type FrameOptions = Frame;
";

/// A point of the plane.
#[derive(Clone, Copy, Debug, Tsify)]
#[tsify(type = "[x: number, y: number]")]
pub struct Point(#[tsify(type = "number")] Complex64);

impl Read for Point {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        let [x, y] = two_numbers(value).ok_or_else(|| Refusal::expected(value, "two numbers [x, y]"))?;
        Ok(Self(Complex64::new(x, y)))
    }
}

impl From<Point> for JsValue {
    fn from(point: Point) -> Self {
        points::pair(point.0).into()
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
#[derive(Clone, Copy, Debug, Tsify)]
#[tsify(rename = "Frame")]
pub struct FrameOptions {
    /// The middle of the picture, in the plane.
    pub center: Point,
    /// Width in plane units; the height follows from `pixels`.
    pub width: f64,
    /// Columns and rows.
    pub pixels: PixelCounts,
}
fields!(FrameOptions: center, width, pixels);
written!(FrameOptions: center, width, pixels);

/// Columns and rows of a picture.
#[derive(Clone, Copy, Debug, Tsify)]
#[tsify(type = "[columns: Count, rows: Count]")]
pub struct PixelCounts(#[tsify(type = "number")] [usize; 2]);

impl Read for PixelCounts {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        let counts = two_numbers(value).filter(|counts| counts.iter().all(|n| n.fract() == 0.0 && *n >= 0.0));
        let counts = counts.ok_or_else(|| Refusal::expected(value, "two whole numbers [columns, rows]"))?;
        Ok(Self(counts.map(|n| n as usize)))
    }
}

impl From<PixelCounts> for JsValue {
    fn from(PixelCounts([columns, rows]): PixelCounts) -> Self {
        Array::of2(&columns.into(), &rows.into()).into()
    }
}

/// An array, of whatever kind, that holds two numbers.
fn two_numbers(value: &JsValue) -> Option<[f64; 2]> {
    let items = items(value).filter(|items| items.length() == 2)?;
    Some([items.get(0).as_f64()?, items.get(1).as_f64()?])
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
pub fn read<T: Tsify + Read>(given: &Ts<T>) -> Result<T, Failure> {
    Ok(T::read(&given.js_value())?)
}

/// As [`read`], or the defaults where no options are given.
///
/// # Errors
/// As [`read`].
pub fn read_or_default<T: Tsify + Read + Default>(given: Option<&Ts<T>>) -> Result<T, Failure> {
    given.map_or_else(|| Ok(T::default()), read)
}

/// A pair of numbers → a point; `name` is what the caller knows it as.
///
/// # Errors
/// "invalid-option" for anything else.
pub fn read_point(name: &str, given: &Ts<Point>) -> Result<Complex64, Failure> {
    let point = Point::read(&given.js_value());
    point.map(Into::into).map_err(|_| Failure::option(name, &format!("{name} must be an array of two numbers.")))
}

/// A Rust value → JavaScript, with its generated type.
pub fn write<T: Tsify + Into<JsValue>>(value: T) -> Ts<T> {
    Ts::new_unchecked(value.into())
}
