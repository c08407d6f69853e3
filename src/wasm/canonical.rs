//! What the classes of maps onto canonical regions share: that `RegionMap` can join them.

use crate::riemann::CanonicalMap;
use wasm_bindgen::prelude::wasm_bindgen;

/// A map onto a canonical region, on its way from its class to `RegionMap`.
#[derive(Debug)]
#[wasm_bindgen(skip_typescript)]
pub struct Canonical(CanonicalMap);

impl Canonical {
    /// Takes a map along.
    #[must_use]
    pub fn new(map: CanonicalMap) -> Self {
        Self(map)
    }

    /// The map.
    #[must_use]
    pub fn into_inner(self) -> CanonicalMap {
        self.0
    }
}

#[wasm_bindgen]
extern "C" {
    /// A map onto a canonical region, of whichever class.
    #[wasm_bindgen(typescript_type = "RiemannMap | AnnulusMap | ExteriorMap | RectangleMap | StripMap | HalfPlaneMap")]
    #[derive(Debug)]
    pub type Joinable;

    /// The map itself.
    #[wasm_bindgen(method, structural, js_name = __canonical)]
    pub fn canonical(this: &Joinable) -> Canonical;
}

/// Lets `RegionMap` join the map in a class' field `$field` with others.
macro_rules! joinable {
    ($class:ident, $field:tt) => {
        #[wasm_bindgen::prelude::wasm_bindgen]
        impl $class {
            /// For `RegionMap`.
            #[wasm_bindgen(js_name = __canonical, skip_typescript)]
            pub fn canonical(&self) -> $crate::wasm::canonical::Canonical {
                $crate::wasm::canonical::Canonical::new(self.$field.clone().into())
            }
        }
    };
}
pub(super) use joinable;
