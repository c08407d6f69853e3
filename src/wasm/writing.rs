//! Rust structs → plain JavaScript objects.

use super::error::camel_case;
use js_sys::{Object, Reflect};
use wasm_bindgen::JsValue;

/// An object with these properties, which JavaScript names in camel case.
#[must_use]
pub fn object(properties: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in properties {
        // Setting a property of an object that was just made does not fail.
        let _ = Reflect::set(&object, &camel_case(name).into(), value);
    }
    object.into()
}

/// Makes a struct writable: all its fields.
macro_rules! written {
    ($name:ident: $($field:ident),*) => {
        impl From<$name> for wasm_bindgen::JsValue {
            fn from($name { $($field),* }: $name) -> Self {
                $crate::wasm::writing::object(&[$((stringify!($field), $field.into())),*])
            }
        }
    };
}
pub(super) use written;
