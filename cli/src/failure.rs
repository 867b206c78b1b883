//! The failure of a verb.

/// An exit code other than 0 and its message.
pub struct Failure {
    /// Exit code.
    pub code: u8,
    /// One line for standard error.
    pub message: String,
}

impl Failure {
    /// Makes the failure of a check.
    pub fn no(message: String) -> Self {
        Self { code: 1, message }
    }

    /// Makes the failure of bad input or usage.
    pub fn bad(message: String) -> Self {
        Self { code: 2, message }
    }
}
