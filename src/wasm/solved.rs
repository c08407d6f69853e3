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
            #[wasm_bindgen(getter, unchecked_return_type = "Stop")]
            pub fn stop(&self) -> wasm_bindgen::JsValue {
                self.$field.stop().into()
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

/// Gives a class whose field `$field` is a map the method `prepare`.
macro_rules! prepare_method {
    ($class:ident, $field:tt) => {
        #[wasm_bindgen::prelude::wasm_bindgen]
        impl $class {
            /// Builds what makes evaluation fast now, both ways, instead of at its first use. `onProgress` is told the stage and
            /// the fraction of it that is done; `false` cancels.
            ///
            /// Throws "cancelled", and what `onProgress` throws. What was built by then is kept.
            pub fn prepare(
                &self,
                #[wasm_bindgen(
                            js_name = onProgress,
                            unchecked_optional_param_type = "(stage: string, fraction: number) => boolean | void"
                        )]
                on_progress: Option<js_sys::Function>,
            ) -> Result<(), $crate::wasm::error::Failure> {
                let mut progress = $crate::wasm::progress::Progress::new(on_progress);
                let prepared = self.$field.prepare(&mut |stage, fraction| progress.report(stage, fraction));
                progress.finish(prepared)
            }
        }
    };
}
pub(super) use prepare_method;
