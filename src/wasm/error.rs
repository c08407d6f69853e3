//! Errors on their way to JavaScript: `Error` objects with a stable `code` and the values of the case.

use super::points;
use crate::Error;
use js_sys::{Array, Reflect};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r#"
/** What this package throws: a sentence for people, and a stable code for programs. */
export interface ConformalWarpError extends Error {
    /** The case, for example "self-intersecting", "center-outside", "invalid-option" or "cancelled". */
    code: ErrorCode;
    /** Where in the plane it went wrong, if that is known. */
    at?: [x: number, y: number];
    /** "syntax": where in the formula's text. */
    position?: number;
    /** "self-intersecting": the two edges that meet; edge k runs from vertex k to vertex k + 1. */
    edges?: [number, number];
    /** Which hole is wrong, counted from 0, if one is; `edges` are its own then. */
    hole?: number;
    /** "invalid-option": the option's path, for example "view.width". */
    option?: string;
    /** "invalid-argument": the argument's name. */
    argument?: string;
}
"#;

/// Something to throw: what every exported function returns as its error.
#[derive(Debug)]
pub struct Failure(JsValue);

impl Failure {
    /// An `Error` with a code.
    #[must_use]
    pub fn new(code: &str, message: &str) -> Self {
        Self(js_sys::Error::new(message).into()).with("code", &code.into())
    }

    /// An option that cannot be used; `path` is its name, with dots for options inside options.
    #[must_use]
    pub fn option(path: &str, message: &str) -> Self {
        Self::new("invalid-option", message).with("option", &path.into())
    }

    /// What a function of the caller's threw: passed on as it is.
    #[must_use]
    pub fn thrown(value: JsValue) -> Self {
        Self(value)
    }

    /// The same with a property more.
    #[must_use]
    pub fn with(self, name: &str, value: &JsValue) -> Self {
        // Setting a property of an object that was just made does not fail.
        let _ = Reflect::set(&self.0, &name.into(), value);
        self
    }
}

impl From<Failure> for JsValue {
    fn from(failure: Failure) -> Self {
        failure.0
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::new(error.code(), &message(&error)).with_values(error)
    }
}

impl Failure {
    /// The same with the values of the error's case.
    fn with_values(self, error: Error) -> Self {
        let failure = self;
        match error {
            Error::InHole { hole, error } => failure.with_values(*error).with("hole", &(hole as f64).into()),
            Error::HoleOutside { hole, .. } => failure.with("hole", &(hole as f64).into()),
            Error::SelfIntersecting { first, second, at } => failure
                .with("edges", &Array::of2(&(first as f64).into(), &(second as f64).into()))
                .with("at", &points::pair(at).into()),
            Error::CenterOutside { center: at }
            | Error::PointOutside { at, .. }
            | Error::Crowded { at }
            | Error::TooFarApart { at } => failure.with("at", &points::pair(at).into()),
            Error::Syntax { position, .. } => failure.with("position", &(position as f64).into()),
            Error::InvalidOption { name, .. } => failure.with("option", &camel_case(name).into()),
            _ => failure,
        }
    }
}

/// The error's sentence, options being named as JavaScript does.
fn message(error: &Error) -> String {
    let text = error.to_string();
    match error {
        Error::InvalidOption { name, .. } => text.replacen(name, &camel_case(name), 1),
        _ => text,
    }
}

pub(super) fn camel_case(name: &str) -> String {
    let mut words = name.split('_');
    let first = words.next().unwrap_or_default().to_string();
    words.fold(first, |text, word| {
        let (initial, rest) = word.split_at(word.len().min(1));
        text + &initial.to_ascii_uppercase() + rest
    })
}
