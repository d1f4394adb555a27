//! Version, precision, hash, memory.

use super::guard::{call, slice};
use core::ffi::c_int;

/// A version by the rules of semver.org.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvVersion {
    /// Changes when programs have to be changed.
    pub major: c_int,
    /// Changes with new features.
    pub minor: c_int,
    /// Changes with repairs.
    pub revision: c_int,
}

/// The revision of the binary interface that this header describes. A program may compare it with
/// mvGetAbiRevision() to learn whether the library that was loaded is the one it was compiled for.
pub const MV_ABI_REVISION: i32 = 1;

/// The start value of mvHash().
pub const MV_HASH_INIT: u32 = 5381;

/// Get the version of the library.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetVersion() -> mvVersion {
    const fn number(s: &str) -> c_int {
        let (s, mut i, mut n) = (s.as_bytes(), 0, 0);
        while i < s.len() {
            n = n * 10 + (s[i] - b'0') as c_int;
            i += 1;
        }
        n
    }
    const VERSION: mvVersion = mvVersion {
        major: number(env!("CARGO_PKG_VERSION_MAJOR")),
        minor: number(env!("CARGO_PKG_VERSION_MINOR")),
        revision: number(env!("CARGO_PKG_VERSION_PATCH")),
    };
    VERSION
}

/// Get the revision of the library's binary interface: layouts of structs and signatures of functions. It
/// equals MV_ABI_REVISION of the header that belongs to the library.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetAbiRevision() -> i32 {
    MV_ABI_REVISION
}

/// Whether the library computes in double precision: whether its mvFloat is a double. A program must define
/// MV_DOUBLE_PRECISION, before it includes this header, exactly when this is true.
#[unsafe(no_mangle)]
pub extern "C" fn mvIsDoublePrecision() -> bool {
    cfg!(feature = "f64")
}

/// Hash bytes, for tests of determinism: h becomes 33 h + byte, modulo 2 to the power of 32.
///
/// @param hash the hash of what went before; MV_HASH_INIT at the start
/// @param data the bytes; may be null when count is 0
/// @param count the number of bytes, not negative
/// @return the hash; 0 for bad arguments
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvHash(hash: u32, data: *const u8, count: c_int) -> u32 {
    call(|| {
        // Sound: the caller passes count bytes.
        let data = unsafe { slice("bytes", data, count) }?;
        Ok(data.iter().fold(hash, |h, &byte| h.wrapping_mul(33).wrapping_add(u32::from(byte))))
    })
}
