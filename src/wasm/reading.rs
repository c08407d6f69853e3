//! JavaScript values → Rust values. Where one is refused, the path to it is made on the way back out.

use super::error::{Failure, camel_case};
use js_sys::{Array, Float64Array, Function, Object, Reflect, Symbol, Uint8ClampedArray};
use wasm_bindgen::{JsCast, JsValue};

/// What options hold.
pub trait Read: Sized {
    /// The value, if it is of this kind.
    ///
    /// # Errors
    /// Why it is not, and where in it.
    fn read(value: &JsValue) -> Result<Self, Refused>;
}

/// A value that cannot be used. It is rare, and a box is quickly handed on.
pub type Refused = Box<Refusal>;

/// Where a value cannot be used, and why.
#[derive(Debug)]
pub struct Refusal {
    /// From the options to it: "view.width", "edges[2]".
    path: String,
    reason: Reason,
}

#[derive(Debug)]
enum Reason {
    Missing,
    /// A key that is none of these.
    Unknown(&'static [&'static str]),
    /// No object, which would have these keys.
    NoObject(&'static [&'static str]),
    Unusable(String),
    /// What a getter threw.
    Thrown(JsValue),
}

impl Reason {
    #[cold]
    fn here(self) -> Refused {
        Box::new(Refusal { path: String::new(), reason: self })
    }
}

impl Refusal {
    /// A value that is not what is expected, in words.
    #[cold]
    pub fn expected(value: &JsValue, words: &str) -> Refused {
        if is_absent(value) { Reason::Missing } else { Reason::Unusable(format!("expected {words}")) }.here()
    }

    /// As [`expected`](Self::expected), naming what there is instead.
    #[cold]
    fn instead(value: &JsValue, words: &str) -> Refused {
        let found = match (value.as_bool(), value.as_f64(), value.as_string()) {
            _ if is_absent(value) => return Reason::Missing.here(),
            (Some(boolean), ..) => format!("boolean `{boolean}`"),
            (_, Some(number), _) => format!("number `{number}`"),
            (.., Some(text)) => format!("string {text:?}"),
            _ => value.js_typeof().as_string().unwrap_or_default(),
        };
        Reason::Unusable(format!("invalid type: {found}, expected {words}")).here()
    }

    /// The same, seen from what holds the value under a key or, in brackets, an index.
    #[cold]
    fn within(mut self: Box<Self>, step: &str) -> Refused {
        let joint = if self.path.is_empty() || self.path.starts_with('[') { "" } else { "." };
        self.path = format!("{step}{joint}{}", self.path);
        self
    }
}

impl From<Refused> for Failure {
    fn from(refused: Refused) -> Self {
        let Refusal { path, reason } = *refused;
        let listed = |names: &[&str]| names.iter().map(|name| camel_case(name)).collect::<Vec<_>>().join(", ");
        let message = match reason {
            Reason::Thrown(error) => return Self::thrown(error),
            Reason::Missing if path.is_empty() => "The options are missing.".to_string(),
            Reason::Missing => format!("The option \"{path}\" is missing."),
            Reason::Unknown(names) => format!("There is no option \"{path}\"; there are {}.", listed(names)),
            Reason::NoObject(names) if path.is_empty() => {
                format!("Options must be an object; its keys can be {}.", listed(names))
            }
            Reason::NoObject(names) => {
                format!("The option \"{path}\" cannot be used: expected an object with keys of {}.", listed(names))
            }
            Reason::Unusable(reason) => format!("The option \"{path}\" cannot be used: {reason}."),
        };
        Self::option(&path, &message)
    }
}

/// The values of an object's own keys, in the order of a struct's fields.
#[derive(Debug)]
pub struct Fields {
    names: &'static [&'static str],
    values: Vec<JsValue>,
    next: usize,
}

impl Fields {
    /// Reads every property once. A misspelled one must not be silently ignored.
    ///
    /// # Errors
    /// A value that is no object, a key that is none of `names`, and what a getter throws.
    pub fn of(object: &JsValue, names: &'static [&'static str]) -> Result<Self, Refused> {
        if !object.is_object() {
            return Err(if is_absent(object) { Reason::Missing } else { Reason::NoObject(names) }.here());
        }
        let mut values = vec![JsValue::UNDEFINED; names.len()];
        for key in keys(object).iter() {
            let text = key.as_string().unwrap_or_default();
            let Some(k) = names.iter().position(|name| is_named(name, &text)) else {
                return Err(Reason::Unknown(names).here().within(&text));
            };
            values[k] = property(object, &key).map_err(|refused| refused.within(&text))?;
        }
        Ok(Self { names, values, next: 0 })
    }

    /// The next field, in their order.
    ///
    /// # Errors
    /// As [`Read::read`]; an absent value is undefined here.
    pub fn take<T: Read>(&mut self) -> Result<T, Refused> {
        let k = self.next;
        self.next += 1;
        T::read(&self.values[k]).map_err(|refused| self.within(k, refused))
    }

    #[cold]
    fn within(&self, k: usize, refused: Refused) -> Refused {
        refused.within(&camel_case(self.names[k]))
    }
}

/// Makes a struct readable: all its fields, which JavaScript names in camel case.
macro_rules! fields {
    ($name:ident: $($field:ident),*) => {
        impl $crate::wasm::reading::Read for $name {
            fn read(value: &wasm_bindgen::JsValue) -> Result<Self, $crate::wasm::reading::Refused> {
                let mut fields = $crate::wasm::reading::Fields::of(value, &[$(stringify!($field)),*])?;
                Ok(Self { $($field: fields.take()?),* })
            }
        }
    };
}
pub(super) use fields;

/// Whether a key of JavaScript's is that of a field: `maxUnknowns` is `max_unknowns`.
fn is_named(field: &str, key: &str) -> bool {
    let mut key = key.bytes();
    let mut is_initial = false;
    for letter in field.bytes() {
        if letter == b'_' {
            is_initial = true;
            continue;
        }
        let letter = if is_initial { letter.to_ascii_uppercase() } else { letter };
        if key.next() != Some(letter) {
            return false;
        }
        is_initial = false;
    }
    key.next().is_none()
}

/// The names and values of an object's own keys.
///
/// # Errors
/// A value that is no object, or whose values are not of this kind.
pub fn entries<T: Read>(object: &JsValue) -> Result<Vec<(String, T)>, Refused> {
    if !object.is_object() {
        return Err(Refusal::instead(object, "an object of names and values"));
    }
    let entry = |key: JsValue| {
        let name = key.as_string().unwrap_or_default();
        match property(object, &key).and_then(|value| T::read(&value)) {
            Ok(value) => Ok((name, value)),
            Err(refused) => Err(refused.within(&name)),
        }
    };
    keys(object).iter().map(entry).collect()
}

fn keys(object: &JsValue) -> Array {
    Object::keys(object.unchecked_ref::<Object>())
}

fn property(object: &JsValue, key: &JsValue) -> Result<JsValue, Refused> {
    Reflect::get(object, key).map_err(|error| Reason::Thrown(error).here())
}

/// The items of an array of whatever kind, or of anything else that can be gone through.
pub fn items(value: &JsValue) -> Option<Array> {
    if Array::is_array(value) {
        return Some(value.clone().unchecked_into());
    }
    let is_iterable = value.is_object() && Reflect::has(value, &Symbol::iterator()).unwrap_or(false);
    is_iterable.then(|| Array::from(value))
}

fn is_absent(value: &JsValue) -> bool {
    value.is_undefined() || value.is_null()
}

macro_rules! scalars {
    ($($type:ident: $words:literal, $read:expr;)*) => {
        $(impl Read for $type {
            fn read(value: &JsValue) -> Result<Self, Refused> {
                $read(value).ok_or_else(|| Refusal::instead(value, $words))
            }
        })*
    };
}
scalars! {
    f64: "a number", JsValue::as_f64;
    bool: "a boolean", JsValue::as_bool;
    String: "a string", JsValue::as_string;
    usize: "a whole number, 0 or more", |value| Some(whole(value, u32::MAX)? as usize);
    u32: "a whole number, 0 or more", |value| whole(value, u32::MAX);
    u8: "a whole number from 0 to 255", |value| Some(whole(value, 255)? as u8);
}

fn whole(value: &JsValue, most: u32) -> Option<u32> {
    value.as_f64().filter(|n| *n >= 0.0 && *n <= most.into() && n.fract() == 0.0).map(|n| n as u32)
}

impl<T: Read> Read for Option<T> {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        if is_absent(value) { Ok(None) } else { T::read(value).map(Some) }
    }
}

impl<T: Read> Read for Vec<T> {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        let items = items(value).ok_or_else(|| Refusal::instead(value, "an array"))?;
        let item = |(k, item)| T::read(&item).map_err(|refused| refused.within(&format!("[{k}]")));
        items.iter().enumerate().map(item).collect()
    }
}

impl<T: Read, const N: usize> Read for [T; N] {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        let wrong = |items: Vec<T>| {
            Reason::Unusable(format!("invalid length {}, expected an array of length {N}", items.len())).here()
        };
        Vec::read(value)?.try_into().map_err(wrong)
    }
}

/// Any value, passed through.
impl Read for JsValue {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        if is_absent(value) { Err(Reason::Missing.here()) } else { Ok(value.clone()) }
    }
}

/// Objects of JavaScript's classes, passed through.
macro_rules! objects {
    ($($class:ident),*) => {
        $(impl Read for $class {
            fn read(value: &JsValue) -> Result<Self, Refused> {
                value.dyn_ref::<Self>().cloned().ok_or_else(|| Refusal::expected(value, concat!("a ", stringify!($class))))
            }
        })*
    };
}
objects!(Float64Array, Function, Uint8ClampedArray);

/// The index of a string among words.
///
/// # Errors
/// A value that is none of them.
pub fn word(value: &JsValue, words: &[&str]) -> Result<usize, Refused> {
    let Some(given) = value.as_string() else {
        return Err(Refusal::instead(value, "a word"));
    };
    words.iter().position(|word| *word == given).ok_or_else(|| {
        Reason::Unusable(format!("unknown variant `{given}`, expected one of `{}`", words.join("`, `"))).here()
    })
}
