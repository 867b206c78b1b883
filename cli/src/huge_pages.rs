//! The allocator of the tool: the system's, with huge pages for large arrays.
//!
//! Neighbours in a mesh may lie far apart in memory. With pages of 4 KiB such an access misses the
//! cache of addresses as well as the data, and the kernel provides each page on its own. Linux
//! offers 2 MiB pages, on most systems only on request (`madvise`).
//!
//! A block that the system refuses ends the process in good order, where Rust would abort it.

use std::alloc::{GlobalAlloc, Layout, System};
use std::ffi::c_void;

use rustix::mm::{Advice, madvise};

use crate::out_of_memory;

/// Forwards to [`System`], and advises the kernel to use huge pages for large blocks. A block is
/// never null.
pub struct HugePages;

const HUGE_PAGE: usize = 2 << 20;

/// Least size of a large block; at least half of it is whole huge pages.
const LARGE: usize = 4 * HUGE_PAGE;

// SAFETY: every call is forwarded to `System` with its arguments, and the block is returned as it
// is. The advice changes neither content nor owner of a block. Where there is no block, the process
// ends: nothing unwinds.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for HugePages {
    #[inline]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: `System` has the same contract, which the caller keeps.
        given(unsafe { System.alloc(layout) }, layout.size())
    }

    #[inline]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    #[inline]
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as above.
        given(unsafe { System.realloc(block, layout, size) }, size)
    }

    #[inline]
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) };
    }
}

/// Requests huge pages for a large block of `size` bytes. Returns the block, if there is one.
#[inline]
fn given(block: *mut u8, size: usize) -> *mut u8 {
    if block.is_null() {
        out_of_memory::end(size);
    }
    if size >= LARGE {
        advise_large(block, size);
    }
    block
}

/// Requests huge pages for the whole huge pages inside a block. Without effect where the kernel has
/// none.
#[cold]
#[allow(unsafe_code)]
fn advise_large(block: *mut u8, size: usize) {
    let before = block.align_offset(HUGE_PAGE);
    let size = size.saturating_sub(before) / HUGE_PAGE * HUGE_PAGE;
    let start: *mut c_void = block.wrapping_add(before).cast();
    // SAFETY: from `start`, `size` bytes are inside the block, which has just been allocated; this
    // advice lets the kernel move them to other physical memory and changes none of them.
    let _ = unsafe { madvise(start, size, Advice::LinuxHugepage) };
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the flags of the mapping that holds `address`, if the kernel lists them.
    fn flags_at(address: usize) -> Option<String> {
        let maps = std::fs::read_to_string("/proc/self/smaps").ok()?;
        let mut inside = false;
        for line in maps.lines() {
            let range = line.split(' ').next().and_then(|range| range.split_once('-'));
            let hexadecimal = |end| usize::from_str_radix(end, 16).ok();
            if let Some((start, end)) = range
                && let (Some(start), Some(end)) = (hexadecimal(start), hexadecimal(end))
            {
                inside = (start..end).contains(&address);
            } else if inside && let Some(flags) = line.strip_prefix("VmFlags:") {
                return Some(flags.into());
            }
        }
        None
    }

    fn has_advice(block: &[u8]) -> Option<bool> {
        let middle = block.as_ptr() as usize + block.len() / 2;
        Some(flags_at(middle)?.split(' ').any(|flag| flag == "hg"))
    }

    #[test]
    fn large_blocks_are_advised_and_hold_what_they_should() {
        // Too large for memory that has been used before.
        let zeroed = vec![0u8; 16 * LARGE];
        assert!(zeroed.iter().all(|&byte| byte == 0));
        let mut grown = Vec::with_capacity(1000);
        grown.extend((0..=u8::MAX).cycle().take(1000));
        grown.reserve_exact(16 * LARGE);
        assert!(grown.iter().copied().eq((0..=u8::MAX).cycle().take(1000)));
        grown.resize(16 * LARGE, 7);
        if !std::path::Path::new("/sys/kernel/mm/transparent_hugepage").exists() {
            eprintln!("skipped: this kernel has no huge pages on request");
            return;
        }
        for block in [&zeroed, &grown] {
            assert_ne!(has_advice(block), Some(false));
        }
    }
}
