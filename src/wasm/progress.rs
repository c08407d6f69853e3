//! The caller's `onProgress(stage, fraction)`.

use super::error::Failure;
use js_sys::{Function, Promise};
use wasm_bindgen::{JsCast, JsValue};

/// Tells a JavaScript function how far a computation is. `false` cancels, and so does throwing; what was thrown is
/// thrown on once the computation has stopped.
#[derive(Debug)]
pub struct Progress {
    function: Option<Function>,
    thrown: Option<JsValue>,
}

impl Progress {
    /// Reports to `function`, or to nobody.
    #[must_use]
    pub fn new(function: Option<Function>) -> Self {
        Self { function, thrown: None }
    }

    /// Whether to go on.
    pub fn report(&mut self, stage: &'static str, fraction: f64) -> bool {
        let Some(function) = &self.function else { return true };
        match function.call2(&JsValue::UNDEFINED, &stage.into(), &fraction.into()) {
            Ok(answer) if answer.has_type::<Promise>() => self.stop(late().into()),
            Ok(answer) => answer != JsValue::FALSE,
            Err(thrown) => self.stop(thrown),
        }
    }

    fn stop(&mut self, thrown: JsValue) -> bool {
        self.thrown = Some(thrown);
        false
    }

    /// The computation's result, unless the caller's function threw.
    ///
    /// # Errors
    /// What the function threw, or else the computation's own error.
    pub fn finish<T>(self, result: crate::Result<T>) -> Result<T, Failure> {
        match self.thrown {
            Some(thrown) => Err(Failure::thrown(thrown)),
            None => Ok(result?),
        }
    }
}

/// Of an async function, which cannot cancel.
fn late() -> Failure {
    Failure::option("onProgress", "onProgress must answer at once: it gave a promise, whose false would come too late.")
}
