//! Mesh files: what is written reads back to the last bit, what others write is understood, texture
//! coordinates and groups survive, and no content makes a reader panic.

mod attributes;
mod damage;
mod oracle;
mod round_trips;
mod spellings;
mod texts;
