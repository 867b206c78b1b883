//! Reading certificates.

use std::iter::Enumerate;
use std::path::Path;
use std::str::{FromStr, Lines};

use triquad::ShapeCost;
use triquad::convert::Aims;
use triquad::matching::weighted::{Barrier, Certificate, Integers, NONE};

use super::format::FIRST_LINE;
use crate::failure::Failure;
use crate::{input, shell};

/// Statement of a certificate, and its proof.
pub struct Stated {
    pub aims: Aims<'static>,
    /// True if the costs are those of a file of their own.
    pub costs_are_listed: bool,
    pub certificate: Certificate,
    pub barrier: Option<Barrier>,
}

/// Reads a certificate.
pub fn read(path: &Path) -> Result<Stated, Failure> {
    let text = input::read_text(path)?;
    let mut reader = Reader { path, lines: text.lines().enumerate(), line: 0, words: Vec::new() };
    reader.stated()
}

/// Words of a text, line by line.
struct Reader<'a> {
    path: &'a Path,
    lines: Enumerate<Lines<'a>>,
    /// Number of the current line, from 1.
    line: usize,
    words: Vec<&'a str>,
}

impl Reader<'_> {
    fn stated(&mut self) -> Result<Stated, Failure> {
        self.advance()?;
        if self.words.join(" ") != FIRST_LINE {
            return Err(self.failure("is no certificate that 'triquad convert' wrote"));
        }
        self.advance()?;
        let (aims, costs_are_listed) = self.aims()?;
        let certificate = self.certificate()?;
        let barrier = match self.words.first() {
            Some(&"barrier") => {
                let nodes = self.section("barrier", |reader| {
                    let [node] = reader.numbers()?;
                    reader.index(node)
                })?;
                Some(Barrier { nodes })
            }
            _ => None,
        };
        match self.words[..] {
            ["end"] => Ok(Stated { aims, costs_are_listed, certificate, barrier }),
            _ => Err(self.failure("should be the line 'end'")),
        }
    }

    /// Reads the lines up to that of the triangles.
    fn aims(&mut self) -> Result<(Aims<'static>, bool), Failure> {
        let mut aims = Aims::default();
        let mut costs_are_listed = false;
        loop {
            match self.words[..] {
                ["cost", "default"] => aims.cost = None,
                ["cost", "shape"] => aims.cost = Some(&ShapeCost),
                ["cost", "listed"] => costs_are_listed = true,
                ["keep-sharp", degrees] => aims.keep.sharp = Some(self.number(degrees)?),
                ["keep-seams"] => aims.keep.seams = true,
                ["strict"] => aims.strict = true,
                ["quad-dominant", price] => aims.price = Some(self.number(price)?),
                ["keep-edges", _] => {
                    aims.keep.edges = self.section("keep-edges", |reader| {
                        let [a, b] = reader.numbers()?;
                        Ok([reader.index(a)?, reader.index(b)?])
                    })?;
                    return Ok((aims, costs_are_listed));
                }
                _ => return Err(self.failure("should say what the pairing is the best of")),
            }
            self.advance()?;
        }
    }

    fn certificate(&mut self) -> Result<Certificate, Failure> {
        let (potentials, innermost): (Vec<i128>, Vec<u32>) = self
            .section("triangles", |reader| {
                let [potential, set] = reader.numbers()?;
                Ok((potential, reader.set(set)?))
            })?
            .into_iter()
            .unzip();
        let (parents, values): (Vec<u32>, Vec<i128>) = self
            .section("sets", |reader| {
                let [parent, value] = reader.numbers()?;
                Ok((reader.set(parent)?, value))
            })?
            .into_iter()
            .unzip();
        let [potentials, values] = [potentials, values].map(Integers::Widest);
        Ok(Certificate { potentials, innermost, parents, values })
    }

    /// Reads a line with a name and a count, and so many lines; goes to the line after them.
    fn section<T>(
        &mut self,
        name: &str,
        mut item: impl FnMut(&mut Self) -> Result<T, Failure>,
    ) -> Result<Vec<T>, Failure> {
        let [given, count] = self.words[..] else { return Err(self.expected(name)) };
        if given != name {
            return Err(self.expected(name));
        }
        let count: usize = self.number(count)?;
        let mut items = Vec::new();
        for _ in 0..count {
            self.advance()?;
            items.push(item(self)?);
        }
        self.advance()?;
        Ok(items)
    }

    /// Goes to the next line.
    fn advance(&mut self) -> Result<(), Failure> {
        self.line += 1;
        let Some((_, line)) = self.lines.next() else {
            return Err(self.failure("is missing: the certificate is cut off"));
        };
        self.words.clear();
        self.words.extend(line.split_whitespace());
        Ok(())
    }

    /// Reads the numbers of the current line.
    fn numbers<const N: usize>(&self) -> Result<[i128; N], Failure> {
        let words: [&str; N] = self.words[..]
            .try_into()
            .map_err(|_| self.failure(&format!("should have {N} numbers")))?;
        let mut numbers = [0; N];
        for (number, word) in numbers.iter_mut().zip(words) {
            *number = self.number(word)?;
        }
        Ok(numbers)
    }

    fn number<T: FromStr>(&self, word: &str) -> Result<T, Failure> {
        word.parse().map_err(|_| self.failure(&format!("has {word:?} in place of a number")))
    }

    /// Turns a number that counts from 1 into an index.
    fn index(&self, number: i128) -> Result<u32, Failure> {
        let index = number.checked_sub(1).and_then(|index| u32::try_from(index).ok());
        let index = index.filter(|&index| index != NONE);
        index.ok_or_else(|| self.failure("has a number below 1 or beyond 2^32 - 1"))
    }

    /// Turns the number of a set into its index, 0 into none.
    fn set(&self, number: i128) -> Result<u32, Failure> {
        if number == 0 { Ok(NONE) } else { self.index(number) }
    }

    fn expected(&self, name: &str) -> Failure {
        self.failure(&format!("should be '{name}' and a count"))
    }

    fn failure(&self, problem: &str) -> Failure {
        let (path, line) = (self.path.display(), self.line);
        let word = shell::word(self.path);
        let remedy = format!("write it again with 'triquad convert IN --certificate {word}'");
        Failure::bad(format!("{path}:{line}: the line {problem}; {remedy}"))
    }
}
