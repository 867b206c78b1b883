//! Exit codes with their messages.

/// Why a verb ends without success: an exit code and a line for standard error.
pub struct Failure {
    /// Exit code.
    pub code: u8,
    /// One line for standard error.
    pub message: String,
}

impl Failure {
    /// A check said no.
    pub fn no(message: String) -> Self {
        Self { code: 1, message }
    }

    /// Bad input or usage.
    pub fn bad(message: String) -> Self {
        Self { code: 2, message }
    }
}
