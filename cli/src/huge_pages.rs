//! The allocator of the tool: the system's, but large arrays ask for huge pages.
//!
//! Neighbours in a mesh may lie far apart in memory, and with pages of 4 KiB the processor misses
//! not only the data but also where they are; and every page is given by the kernel on its own.
//! Linux has pages of 2 MiB, on most machines only for who asks.

use std::alloc::{GlobalAlloc, Layout, System};
use std::ffi::c_void;

use rustix::mm::{Advice, madvise};

/// Forwards to [`System`], and advises the kernel to use huge pages for large blocks.
pub struct HugePages;

const HUGE_PAGE: usize = 2 << 20;

/// Of a block of this size, half at least is whole huge pages.
const LARGE: usize = 4 * HUGE_PAGE;

// SAFETY: every call is forwarded to `System` with the arguments as they are, whose blocks are
// returned as they are; advice changes neither what is in a block nor who owns it.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for HugePages {
    #[inline]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are those that `System` asks for.
        advise(unsafe { System.alloc(layout) }, layout.size())
    }

    #[inline]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        advise(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    #[inline]
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as above.
        advise(unsafe { System.realloc(block, layout, size) }, size)
    }

    #[inline]
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) };
    }
}

/// Advises the kernel on the block of `size` bytes, if it is large, and gives it back.
#[inline]
fn advise(block: *mut u8, size: usize) -> *mut u8 {
    if size >= LARGE && !block.is_null() {
        advise_large(block, size);
    }
    block
}

/// Advises on what is whole huge pages inside a block, which nothing else is in. A kernel that has
/// none says so, and nothing has changed.
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

    /// The flags of the mapping that holds `address`, where the kernel tells.
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
            eprintln!("skipped: this kernel has no huge pages for who asks");
            return;
        }
        for block in [&zeroed, &grown] {
            assert_ne!(has_advice(block), Some(false));
        }
    }
}
