//! What the classes of regions with holes share: the getters that tell how good a solve is.

/// Gives a class the evidence of what its field `$field` has solved.
macro_rules! solved_methods {
    ($class:ident, $field:tt, $($estimate:tt)*) => {
        #[wasm_bindgen::prelude::wasm_bindgen]
        impl $class {
            $(#[doc = $estimate])*
            #[wasm_bindgen(getter, js_name = errorEstimate)]
            pub fn error_estimate(&self) -> f64 {
                self.$field.error_estimate()
            }

            /// The largest violation of the boundary conditions at points where they were not imposed.
            #[wasm_bindgen(getter)]
            pub fn residual(&self) -> f64 {
                self.$field.residual()
            }

            /// Why the solve ended: with the tolerance met, or short of it.
            #[wasm_bindgen(getter)]
            pub fn stop(&self) -> Result<tsify::Ts<$crate::symm::options::Stop>, $crate::wasm::error::Failure> {
                $crate::wasm::options::write(&self.$field.stop())
            }

            /// How many unknowns were solved for.
            #[wasm_bindgen(getter)]
            pub fn unknowns(&self) -> usize {
                self.$field.unknowns()
            }
        }
    };
}
pub(super) use solved_methods;
