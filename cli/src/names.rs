//! Algorithms and the like as values of options.

use clap::builder::{PossibleValuesParser, TypedValueParser};

/// Returns a parser of the names of `all`, which help and errors list.
pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.map(name)).map(move |given| {
        let named = all.into_iter().find(|&one| name(one) == given);
        named.expect("one of the possible values")
    })
}
