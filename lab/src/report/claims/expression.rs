//! Products and quotients of numbers: `sg.unpaired_triangles / triangles`.

use serde::Deserialize;

use super::number::Number;

/// Factors, multiplied and divided from left to right.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(try_from = "String")]
pub struct Expression {
    /// At least one.
    pub factors: Vec<Factor>,
    text: String,
}

/// A number of an algorithm on a mesh, or of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// As in records, run as the papers ran it; `None` for a number of the mesh.
    pub algorithm: Option<String>,
    /// Which number.
    pub number: &'static Number,
    /// Whether it divides.
    pub divides: bool,
}

/// Why a text is no expression.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no such number: {0:?}")]
pub struct ParseError(String);

impl Expression {
    /// Whether one of its numbers is a time.
    pub fn is_about_times(&self) -> bool {
        self.factors.iter().any(|factor| factor.number.is_time)
    }

    /// As it was written.
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl TryFrom<String> for Expression {
    type Error = ParseError;

    /// Words apart by spaces: factors, and `*` or `/` between them.
    fn try_from(text: String) -> Result<Self, ParseError> {
        let words: Vec<&str> = text.split(' ').collect();
        let mut factors = vec![Factor::parse(words[0], false)?];
        for pair in words[1..].chunks(2) {
            factors.push(match pair {
                ["*", factor] => Factor::parse(factor, false)?,
                ["/", factor] => Factor::parse(factor, true)?,
                other => return Err(ParseError(other.join(" "))),
            });
        }
        Ok(Self { factors, text })
    }
}

impl Factor {
    /// `algorithm.number` or `number`.
    fn parse(word: &str, divides: bool) -> Result<Self, ParseError> {
        let (algorithm, name) = match word.split_once('.') {
            Some((algorithm, name)) => (Some(algorithm.to_owned()), name),
            None => (None, word),
        };
        let number = Number::named(name).ok_or_else(|| ParseError(word.to_owned()))?;
        Ok(Self { algorithm, number, divides })
    }

    /// Takes the factor into a product.
    pub fn apply(&self, product: f64, value: f64) -> f64 {
        if self.divides { product / value } else { product * value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Expression, ParseError> {
        Expression::try_from(text.to_owned())
    }

    #[test]
    fn factors_multiply_and_divide() {
        let found = parse("lrs.augmentation_seconds / lrs.augmenting_paths * triangles").unwrap();
        let divide: Vec<bool> = found.factors.iter().map(|factor| factor.divides).collect();
        assert_eq!(divide, [false, true, false]);
        assert_eq!(found.factors[0].algorithm.as_deref(), Some("lrs"));
        assert_eq!(found.factors[2].algorithm, None);
        assert!(found.is_about_times() && !parse("genus").unwrap().is_about_times());
        let value =
            [6.0, 3.0, 5.0].iter().zip(&found.factors).fold(1.0, |p, (v, f)| f.apply(p, *v));
        assert_eq!(value, 10.0);
    }

    #[test]
    fn what_is_no_expression_is_named() {
        for text in ["", "sg.", "sg.colour", "genus /", "genus + genus", "genus  / genus"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
