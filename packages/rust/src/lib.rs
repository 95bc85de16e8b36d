#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod fast;
pub mod fixed;
#[rustfmt::skip]
pub mod hash;
