//! SHA-256 of files and of words.

use std::io;
use std::path::Path;

use sha2::{Digest, Sha256};

/// Returns the SHA-256 of a file, in hexadecimal digits.
///
/// # Errors
/// It cannot be read.
pub fn hash_of_file(path: &Path) -> io::Result<String> {
    let mut hasher = Sha256::new();
    let mut file = std::fs::File::open(path)?;
    let mut buffer = vec![0; 1 << 16];
    loop {
        match io::Read::read(&mut file, &mut buffer)? {
            0 => return Ok(hexadecimal(&hasher.finalize())),
            read => hasher.update(&buffer[..read]),
        }
    }
}

/// Returns the SHA-256 of `words`, in 16 hexadecimal digits.
pub fn hash_of_words(words: &[&str]) -> String {
    let mut hasher = Sha256::new();
    for word in words {
        hasher.update(word);
        // UTF-8 never uses this byte, so that words cannot run together.
        hasher.update([0xff]);
    }
    hexadecimal(&hasher.finalize())[..16].to_owned()
}

/// Returns the SHA-256 of `bytes`, in hexadecimal digits.
pub(crate) fn hash_of_bytes(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_are_those_of_the_standard() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("abc");
        std::fs::write(&path, "abc").unwrap();
        let hash = hash_of_file(&path).unwrap();
        assert_eq!(hash, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        assert_ne!(hash_of_words(&["a", "bc"]), hash_of_words(&["ab", "c"]));
        assert_eq!(hash_of_words(&["a"]).len(), 16);
        assert_eq!(hash_of_bytes(b"abc"), hash);
    }
}
