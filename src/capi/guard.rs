//! Nothing gets past here: every exported function runs its body in [`call`], which turns an error into a code,
//! a sentence and a neutral value, and a panic into an error.

use super::error;
use crate::error::{Error, ErrorCode, Result};
use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind};
use std::sync::Once;

/// What a failing call returns: a null id, zero, false, an identity, an empty array.
pub(super) trait Neutral {
    const NEUTRAL: Self;
}

macro_rules! neutral {
    ($($t:ty = $value:expr;)+) => {$(
        impl $crate::capi::guard::Neutral for $t {
            const NEUTRAL: Self = $value;
        }
    )+};
}
pub(super) use neutral;

neutral! {
    () = ();
    bool = false;
    i32 = 0;
    i64 = 0;
    u32 = 0;
    u64 = 0;
    f32 = 0.0;
    f64 = 0.0;
}

impl<T> Neutral for *mut T {
    const NEUTRAL: Self = std::ptr::null_mut();
}

impl<T> Neutral for *const T {
    const NEUTRAL: Self = std::ptr::null();
}

/// Runs the body of an exported function.
pub(super) fn call<R: Neutral, F: FnOnce() -> Result<R>>(body: F) -> R {
    match caught(body) {
        Ok(value) => value,
        Err(error) => {
            error::report(exported_name(std::any::type_name::<F>()), &error);
            R::NEUTRAL
        }
    }
}

/// `body`, with a panic turned into an error. What the body was changing may be left half changed: the caller
/// marks it as faulted.
pub(super) fn caught<R>(body: impl FnOnce() -> Result<R>) -> Result<R> {
    install_hook();
    DEPTH.with(|d| d.set(d.get() + 1));
    let result = catch_unwind(AssertUnwindSafe(body));
    DEPTH.with(|d| d.set(d.get() - 1));
    result.unwrap_or_else(|_| Err(error::internal_fault()))
}

/// The exported function in whose body a closure stands, from the closure's type name; empty if unclear.
fn exported_name(closure: &'static str) -> &'static str {
    let owner = closure.split("::{{closure}}").next().unwrap_or("");
    let name = owner.rsplit("::").next().unwrap_or("");
    if name.starts_with("mv") { name } else { "" }
}

/// Where and why a panic happened.
#[derive(Default)]
pub(super) struct Fault {
    pub message: String,
    pub file: String,
    pub line: u32,
}

thread_local! {
    static DEPTH: Cell<u32> = const { Cell::new(0) };
    static FAULT: RefCell<Fault> = RefCell::default();
}

/// The latest fault of this thread.
pub(super) fn take_fault() -> Fault {
    FAULT.try_with(RefCell::take).unwrap_or_default()
}

/// Panics inside the library are noted quietly; those of other Rust code in the process go where they went.
fn install_hook() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let previous = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if DEPTH.try_with(Cell::get).unwrap_or(0) > 0 {
                let _ = FAULT.try_with(|f| f.replace(fault(info)));
            } else {
                previous(info);
            }
        }));
    });
}

fn fault(info: &PanicHookInfo<'_>) -> Fault {
    let payload = info.payload();
    let text = payload.downcast_ref::<&str>().copied();
    let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    let message = text.unwrap_or("unknown").to_owned();
    let (file, line) = info.location().map_or((String::new(), 0), |l| (l.file().to_owned(), l.line()));
    Fault { message, file, line }
}

/// The value behind a pointer that must not be null.
pub(super) fn needed<T>(what: &str, value: Option<T>) -> Result<T> {
    value.ok_or_else(|| Error::new(ErrorCode::Null, format!("{what} is null.")))
}

/// A count that must not be negative.
pub(super) fn count(what: &str, n: core::ffi::c_int) -> Result<usize> {
    usize::try_from(n)
        .map_err(|_| Error::new(ErrorCode::Range, format!("{what} is {n}; it must not be negative.")))
}

/// A count as C sees it.
pub(super) fn c_count(n: usize) -> core::ffi::c_int {
    core::ffi::c_int::try_from(n).unwrap_or(core::ffi::c_int::MAX)
}

/// The `n` elements at `data`, which may be null only when `n` is 0.
///
/// # Safety
/// `data` is null or points to `n` readable elements that nobody changes during `'a`.
pub(super) unsafe fn slice<'a, T>(what: &str, data: *const T, n: core::ffi::c_int) -> Result<&'a [T]> {
    let n = count(&format!("the number of {what}"), n)?;
    if n == 0 {
        return Ok(&[]);
    }
    check_array(what, data)?;
    // Sound: not null, aligned, and of n elements by this function's contract. T are plain numbers.
    Ok(unsafe { std::slice::from_raw_parts(data, n) })
}

/// Room for `n` elements at `data`; a null array is room for none.
///
/// # Safety
/// `data` is null or points to `n` writable elements that nobody else uses during `'a`. They may be
/// uninitialised.
pub(super) unsafe fn room<'a, T>(
    what: &str,
    data: *mut T,
    n: core::ffi::c_int,
) -> Result<&'a mut [std::mem::MaybeUninit<T>]> {
    let n = count(&format!("the capacity of {what}"), n)?;
    if n == 0 || data.is_null() {
        return Ok(&mut []);
    }
    check_array(what, data)?;
    // Sound: not null, aligned, and of n elements by this function's contract; nothing is read from it.
    Ok(unsafe { std::slice::from_raw_parts_mut(data.cast(), n) })
}

fn check_array<T>(what: &str, data: *const T) -> Result<()> {
    if data.is_null() {
        return Err(Error::new(ErrorCode::Null, format!("The array of {what} is null.")));
    }
    if !data.is_aligned() {
        let need = align_of::<T>();
        return Err(Error::new(
            ErrorCode::Range,
            format!("The array of {what} is not aligned to {need} bytes."),
        ));
    }
    Ok(())
}

/// Writes as many of `values` as there is room for; returns how many there are in all.
pub(super) fn fill<T>(
    room: &mut [std::mem::MaybeUninit<T>],
    values: impl Iterator<Item = T>,
) -> core::ffi::c_int {
    let mut total = 0;
    for value in values {
        if let Some(place) = room.get_mut(total) {
            place.write(value);
        }
        total += 1;
    }
    c_count(total)
}

#[cfg(test)]
mod tests {
    use super::super::error::*;
    use super::*;
    use std::ffi::CStr;

    // The name of an exported function, so that the message can find it.
    #[allow(non_snake_case)]
    fn mvPanics() -> i32 {
        call(|| -> Result<i32> { panic!("on purpose") })
    }

    #[allow(non_snake_case)]
    fn mvFails() -> i32 {
        call(|| Err(Error::new(ErrorCode::Range, "Too much.")))
    }

    fn message() -> String {
        // Sound: never null, valid until the next failure of this thread.
        unsafe { CStr::from_ptr(mvGetLastErrorMessage()) }.to_str().unwrap().to_owned()
    }

    #[test]
    fn a_panic_becomes_an_error_with_its_place() {
        assert_eq!(mvPanics(), 0);
        assert_eq!(mvGetLastError(), mv_errorInternal);
        assert!(message().starts_with("mvPanics: Internal fault at src/capi/guard.rs:"), "{}", message());
        assert!(message().ends_with(": on purpose."));
        assert_eq!(mvGetLastError(), mv_errorNone);
    }

    #[test]
    fn a_failure_has_code_name_and_sentence_and_the_message_stays() {
        assert_eq!(mvFails(), 0);
        assert_eq!((mvGetLastError(), mvGetLastError()), (mv_errorRange, mv_errorNone));
        assert_eq!(message(), "mvFails: Too much.");
        std::thread::spawn(|| assert_eq!((mvGetLastError(), message()), (mv_errorNone, String::new())))
            .join()
            .unwrap();
    }
}
