#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

use wesl_core::{StaticPackage, StaticPackageModule};

static FIXED: StaticPackageModule =
    StaticPackageModule { name: "fixed", source: include_str!("../shaders/fixed.wesl"), submodules: &[] };
static ROOT: StaticPackageModule = StaticPackageModule {
    name: "hashnoise_wgsl",
    source: include_str!("../shaders/package.wesl"),
    submodules: &[&FIXED],
};

/// The package for a resolver of the crate `wesl`: `resolver.add_package(&hashnoise_wgsl::PACKAGE)`.
pub static PACKAGE: StaticPackage =
    StaticPackage { crate_name: "hashnoise_wgsl", root: &ROOT, dependencies: &[] };
