//! Enums whose values are words in JavaScript.

/// Gives every value of enums its word, both ways, and the enums their types in the declarations: the help, the name and the words.
/// A value after a semicolon has none: it is not for options.
macro_rules! words {
    ($($(#[doc = $help:literal])* $name:ident {
        $first:ident = $word:literal $(, $other:ident = $more:literal)* $(; $wordless:ident)?
    })*) => {
        $(const _: () = {
            #[wasm_bindgen::prelude::wasm_bindgen(typescript_custom_section)]
            const TYPESCRIPT: &str = concat!(
                "/**\n", $(" *", $help, "\n",)* " */\nexport type ", stringify!($name), " = \"", $word, "\"", $(" | \"", $more, "\"",)* ";",
            );

            impl $crate::wasm::reading::Read for $name {
                fn read(value: &wasm_bindgen::JsValue) -> Result<Self, $crate::wasm::reading::Refused> {
                    const VALUES: &[$name] = &[$name::$first $(, $name::$other)*];
                    Ok(VALUES[$crate::wasm::reading::word(value, &[$word $(, $more)*])?])
                }
            }

            impl From<$name> for wasm_bindgen::JsValue {
                fn from(value: $name) -> Self {
                    match value {
                        $name::$first => $word.into(),
                        $($name::$other => $more.into(),)*
                        $($name::$wordless => Self::UNDEFINED,)?
                    }
                }
            }
        };)*
    };
}
pub(super) use words;
