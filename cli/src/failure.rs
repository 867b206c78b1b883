//! The failure of a verb.

use serde::Serialize;

/// An exit code other than 0 and its message.
pub struct Failure {
    /// Exit code.
    pub code: u8,
    /// One line for standard error.
    pub message: String,
    /// Parts of the message.
    facts: Box<Facts>,
}

/// Fault of a file, for programs; what does not apply is null.
#[derive(Default, Serialize)]
pub struct Facts {
    pub file: Option<String>,
    pub law: Option<&'static str>,
    pub element: Option<String>,
    pub count: Option<usize>,
    pub remedy: Option<String>,
}

impl Failure {
    /// Makes the failure of a check.
    pub fn no(message: String) -> Self {
        Self::with_code(1, message)
    }

    /// Makes the failure of bad input or usage.
    pub fn bad(message: String) -> Self {
        Self::with_code(2, message)
    }

    /// Makes a failure that ends the process with this exit code.
    pub fn with_code(code: u8, message: String) -> Self {
        Self { code, message, facts: Box::default() }
    }

    /// Adds the parts of the message.
    pub fn with(self, facts: Facts) -> Self {
        Self { facts: Box::new(facts), ..self }
    }

    /// Returns the failure as JSON on one line.
    pub fn json(&self) -> String {
        #[derive(Serialize)]
        struct Record<'a> {
            schema: &'static str,
            exit_code: u8,
            message: &'a str,
            #[serde(flatten)]
            facts: &'a Facts,
        }
        let Self { code, message, facts } = self;
        let record = Record { schema: "triquad-failure-1", exit_code: *code, message, facts };
        serde_json::to_string(&record).expect("text and numbers")
    }
}
