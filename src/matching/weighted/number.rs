//! The integers that potentials are kept in: 32 bits while they suffice, else 64 or 128.
//!
//! Sums wrap. A stored potential is one summand of three, and only their total is bounded, by
//! [`Number::LIMIT`]; two's complement makes the total right whatever the summands do.

use std::fmt::Debug;
use std::num::Wrapping;
use std::ops::{Add, AddAssign, Neg, Sub, SubAssign};

use super::certificate::Integers;
use super::refusal::Refusal;

/// A signed integer of some width.
pub(super) trait Number:
    Copy
    + Debug
    + Default
    + Ord
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Send
    + Sync
{
    /// A time and a code in one, ordered by time and then by code.
    type Event: Copy + Debug + Ord + Send;
    /// The bits of a node that are no numbers.
    type State: Copy + Debug + Into<u64> + Send + Sync;

    /// 0.
    const ZERO: Self;
    /// The greatest number.
    const GREATEST: Self;
    /// Clocks, costs in halves and potentials at the start of a search stay within ± this, an
    /// eighth of the range. Then every time, slack and potential fits: see `pass_guard` in
    /// `blossoms`.
    const LIMIT: Self;

    /// Returns the value, if it is within the limit.
    fn within_limit(value: i128) -> Option<Self>;
    /// Returns the number as the widest of integers.
    fn widen(self) -> i128;
    /// Returns half of the number, rounded down.
    fn half(self) -> Self;
    /// Returns whether the number is odd.
    fn is_odd(self) -> bool;
    /// Packs a time and a code; times are not negative.
    fn event(time: Self, code: u32) -> Self::Event;
    /// Returns the time and code of an event.
    fn unpack(event: Self::Event) -> (Self, u32);
    /// Keeps the low bits of a state.
    fn state(bits: u64) -> Self::State;
    /// Packs numbers for a certificate.
    fn integers(numbers: impl Iterator<Item = Self>) -> Integers;
}

/// Doubles a cost or price, if the numbers are wide enough.
#[inline]
pub(super) fn doubled<N: Number>(cost: i128) -> Result<N, Refusal> {
    cost.checked_mul(2).and_then(N::within_limit).ok_or(Refusal::TooNarrow)
}

macro_rules! number {
    ($int:ty, $state:ty, $event:ty, $integers:ident, $pack:ident, $unpack:ident) => {
        impl Number for Wrapping<$int> {
            type Event = $event;
            type State = $state;

            const ZERO: Self = Wrapping(0);
            const GREATEST: Self = Wrapping(<$int>::MAX);
            const LIMIT: Self = Wrapping(<$int>::MAX / 8);

            #[inline]
            fn within_limit(value: i128) -> Option<Self> {
                let number = <$int>::try_from(value).ok()?;
                (-Self::LIMIT.0..=Self::LIMIT.0).contains(&number).then_some(Wrapping(number))
            }
            #[inline]
            fn widen(self) -> i128 {
                i128::from(self.0)
            }
            #[inline]
            fn half(self) -> Self {
                Wrapping(self.0 >> 1)
            }
            #[inline]
            fn is_odd(self) -> bool {
                self.0 & 1 != 0
            }
            #[inline]
            fn event(time: Self, code: u32) -> Self::Event {
                debug_assert!(time >= Self::ZERO);
                $pack(time.0, code)
            }
            #[inline]
            fn unpack(event: Self::Event) -> (Self, u32) {
                let (time, code) = $unpack(event);
                (Wrapping(time), code)
            }
            #[inline]
            fn state(bits: u64) -> Self::State {
                bits as $state
            }
            fn integers(numbers: impl Iterator<Item = Self>) -> Integers {
                Integers::$integers(numbers.map(|number| number.0).collect())
            }
        }
    };
}

#[inline]
fn pack_32(time: i32, code: u32) -> u64 {
    u64::from(time as u32) << 32 | u64::from(code)
}

#[inline]
fn unpack_32(event: u64) -> (i32, u32) {
    ((event >> 32) as i32, event as u32)
}

#[inline]
fn pack_64(time: i64, code: u32) -> u128 {
    u128::from(time as u64) << 32 | u128::from(code)
}

#[inline]
fn unpack_64(event: u128) -> (i64, u32) {
    ((event >> 32) as i64, event as u32)
}

#[inline]
fn pack_128(time: i128, code: u32) -> (i128, u32) {
    (time, code)
}

#[inline]
fn unpack_128(event: (i128, u32)) -> (i128, u32) {
    event
}

number!(i32, u32, u64, Narrow, pack_32, unpack_32);
number!(i64, u64, u128, Wide, pack_64, unpack_64);
number!(i128, u64, (i128, u32), Widest, pack_128, unpack_128);
