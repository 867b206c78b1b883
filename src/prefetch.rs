//! A hint to the processor that memory will be needed soon.

/// Starts to load `items[index]` into the cache and does not wait for it; any `index` will do.
///
/// Does nothing on processors for which the standard library has no such instruction. Use it in
/// walks whose next steps lie far apart in memory. Without it the pairing of a regular torus of a
/// million triangles takes twice as long.
#[inline]
#[allow(unsafe_code)]
pub(crate) fn prefetch<T>(items: &[T], index: usize) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        let address = items.as_ptr().wrapping_add(index).cast();
        // SAFETY: a prefetch changes no memory, gives nothing back and faults for no address, valid
        // or not; the instruction is part of SSE, which every x86-64 processor has. The address is
        // computed by wrapping arithmetic, which is defined for every index.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(address) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (items, index);
}
