//! Gzip streams: all members, padding behind the last, and a limit for what comes out.

use std::io::{self, BufRead, BufReader, Read};

use flate2::bufread::GzDecoder;

use super::error::{MeshError, Place};
use super::text::is_padding_byte;

/// The bytes that every gzip file starts with.
pub(super) const GZIP: [u8; 2] = [0x1f, 0x8b];

/// Bytes that any gzip file may expand to, however short it is.
const ALWAYS: u64 = 1 << 28;

/// A larger file may expand to so many times its size. Texts of meshes are below 40.
const RATIO: u64 = 100;

/// The content of a gzip file.
pub(super) struct Expanded<R> {
    /// The decoder of the current member; none behind the last one.
    member: Option<GzDecoder<BufReader<Counted<R>>>>,
    given: u64,
    limit: Option<u64>,
    /// The limit that was passed.
    passed: Option<u64>,
}

impl<R: Read> Expanded<R> {
    /// Begins a gzip file. `limit` takes the place of the usual one.
    pub(super) fn new(input: R, limit: Option<u64>) -> Self {
        // Room for the decoder to work on, or it would read byte by byte.
        let input = BufReader::with_capacity(1 << 16, Counted { input, taken: 0 });
        Self { member: Some(GzDecoder::new(input)), given: 0, limit, passed: None }
    }

    /// Returns what an error met while the content was read means.
    pub(super) fn explain(&self, error: MeshError) -> MeshError {
        match error {
            _ if self.passed.is_some() => MeshError::Expanded(self.passed.unwrap_or_default()),
            MeshError::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                let missing = "its gzip stream does".into();
                MeshError::Truncated { place: Place::End, missing, element: None }
            }
            MeshError::Io(error) => {
                MeshError::malformed(Place::End, format!("damaged gzip stream: {error}"))
            }
            error => error,
        }
    }

    /// Counts bytes given out; an error ends the reading behind the limit.
    fn count(&mut self, bytes: usize) -> io::Result<()> {
        self.given += bytes as u64;
        if self.given <= self.limit.unwrap_or(ALWAYS) {
            return Ok(());
        }
        let taken = self.member.as_ref().map_or(0, |member| member.get_ref().get_ref().taken);
        let limit = self.limit.unwrap_or(ALWAYS.max(RATIO.saturating_mul(taken)));
        if self.given <= limit {
            return Ok(());
        }
        self.passed = Some(limit);
        Err(io::Error::other("beyond the limit"))
    }
}

impl<R: Read> Read for Expanded<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        while let Some(member) = &mut self.member {
            let given = member.read(out)?;
            if given > 0 || out.is_empty() {
                self.count(given)?;
                return Ok(given);
            }
            let rest = self.member.take().map(GzDecoder::into_inner);
            self.member = rest.map(next_member).transpose()?.flatten();
        }
        Ok(0)
    }
}

/// Returns the decoder of the member that `input` begins with; none if nothing but padding is left.
fn next_member<R: BufRead>(mut input: R) -> io::Result<Option<GzDecoder<R>>> {
    let mut any_padding = false;
    loop {
        let buffer = input.fill_buf()?;
        let padding = buffer.iter().take_while(|&&byte| is_padding_byte(byte)).count();
        match (buffer.len(), buffer.get(padding)) {
            (0, _) => return Ok(None),
            (_, None) => input.consume(padding),
            (_, Some(_)) if padding == 0 && !any_padding => return Ok(Some(GzDecoder::new(input))),
            (_, Some(_)) => {
                let problem = "something follows the padding behind the stream";
                return Err(io::Error::new(io::ErrorKind::InvalidData, problem));
            }
        }
        any_padding = true;
    }
}

/// A reader and the number of bytes taken from it.
struct Counted<R> {
    input: R,
    taken: u64,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let taken = self.input.read(out)?;
        self.taken += taken as u64;
        Ok(taken)
    }
}
