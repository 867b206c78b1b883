//! Products and quotients of numbers: `sg.unpaired_triangles / triangles`.

use serde::Deserialize;

use super::number::Number;
use crate::experiment::Job;

/// Factors, multiplied and divided from left to right.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(try_from = "String")]
pub struct Expression {
    /// At least one.
    pub factors: Vec<Factor>,
}

/// A number of an algorithm on a mesh, or of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// The algorithm as its paper ran it; `None` for a number of the mesh.
    pub job: Option<Job>,
    /// The number.
    pub number: &'static Number,
    /// True if it divides.
    pub divides: bool,
}

/// Reason why a text is no expression.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no such number: {0:?}")]
pub struct ExpressionError(String);

impl Expression {
    /// Returns whether one of its numbers is a time.
    pub fn is_about_times(&self) -> bool {
        self.factors.iter().any(|factor| factor.number.is_time)
    }
}

impl TryFrom<String> for Expression {
    type Error = ExpressionError;

    /// Parses words apart by spaces: factors, and `*` or `/` between them.
    fn try_from(text: String) -> Result<Self, ExpressionError> {
        let words: Vec<&str> = text.split(' ').collect();
        let mut factors = vec![Factor::parse(words[0], false)?];
        for pair in words[1..].chunks(2) {
            factors.push(match pair {
                ["*", factor] => Factor::parse(factor, false)?,
                ["/", factor] => Factor::parse(factor, true)?,
                other => return Err(ExpressionError(other.join(" "))),
            });
        }
        Ok(Self { factors })
    }
}

impl Factor {
    /// Parses `algorithm.number` or `number`.
    fn parse(word: &str, divides: bool) -> Result<Self, ExpressionError> {
        let error = || ExpressionError(word.to_owned());
        let (job, name) = match word.split_once('.') {
            Some((algorithm, name)) => (Some(Job::named(algorithm).map_err(|_| error())?), name),
            None => (None, word),
        };
        let number = Number::named(name).ok_or_else(error)?;
        Ok(Self { job, number, divides })
    }

    /// Multiplies a product by the factor or divides it.
    pub fn apply(&self, product: f64, value: f64) -> f64 {
        if self.divides { product / value } else { product * value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Expression, ExpressionError> {
        Expression::try_from(text.to_owned())
    }

    #[test]
    fn factors_multiply_and_divide() {
        let found = parse("lrs.augmentation_seconds / lrs.augmenting_paths * triangles").unwrap();
        let divide: Vec<bool> = found.factors.iter().map(|factor| factor.divides).collect();
        assert_eq!(divide, [false, true, false]);
        assert_eq!(found.factors[0].job.map(Job::algorithm), Some("lrs"));
        assert_eq!(found.factors[2].job, None);
        assert!(found.is_about_times() && !parse("genus").unwrap().is_about_times());
        let value =
            [6.0, 3.0, 5.0].iter().zip(&found.factors).fold(1.0, |p, (v, f)| f.apply(p, *v));
        assert_eq!(value, 10.0);
    }

    #[test]
    fn what_is_no_expression_is_named() {
        for text in
            ["", "sg.", "xx.genus", "sg.colour", "genus /", "genus + genus", "genus  / genus"]
        {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
