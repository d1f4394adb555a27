//! The error state of each thread, and the callbacks that hear of failures.

use super::guard;
use crate::error::{Error, ErrorCode};
use core::ffi::{c_char, c_int};
use std::cell::{Cell, RefCell};
use std::ffi::{CStr, CString};
use std::sync::{PoisonError, RwLock};

/// The kind of a failure: one of the mv_error... constants. Numbers are never reused.
pub type mvErrorCode = i32;

/// No call of this thread has failed since the last mvGetLastError().
pub const mv_errorNone: mvErrorCode = 0;
/// An id or a pointer is null where one is needed.
pub const mv_errorNull: mvErrorCode = 1;
/// The id's object was destroyed.
pub const mv_errorStale: mvErrorCode = 2;
/// The id belongs to another world.
pub const mv_errorForeign: mvErrorCode = 3;
/// A definition was not made by its mvDefault...Def() function, or by that of another build of the library.
pub const mv_errorDefinition: mvErrorCode = 4;
/// A number is NaN or infinite.
pub const mv_errorNotFinite: mvErrorCode = 5;
/// A value lies outside its stated range.
pub const mv_errorRange: mvErrorCode = 6;
/// Geometry without volume, direction or size.
pub const mv_errorDegenerate: mvErrorCode = 7;
/// The world is inside a step or a query of this thread: a callback must not change it.
pub const mv_errorLocked: mvErrorCode = 8;
/// Another thread is using the world.
pub const mv_errorBusy: mvErrorCode = 9;
/// A stated capacity is exhausted.
pub const mv_errorCapacity: mvErrorCode = 10;
/// A choice that exists but is not built into this version.
pub const mv_errorUnsupported: mvErrorCode = 11;
/// An internal fault was caught earlier; the world can only be destroyed.
pub const mv_errorFaulted: mvErrorCode = 12;
/// An internal fault was caught in this call. Please report it with the message.
pub const mv_errorInternal: mvErrorCode = 13;

/// Hears the message of every failing call, in UTF-8, on the thread that made the call. The message is valid
/// during the callback only.
pub type mvLogFcn = Option<unsafe extern "C" fn(message: *const c_char)>;

/// Hears of internal faults: what was violated and where, in UTF-8, valid during the callback only. The return
/// value is reserved: return 0.
pub type mvAssertFcn = Option<
    unsafe extern "C" fn(condition: *const c_char, fileName: *const c_char, lineNumber: c_int) -> c_int,
>;

static LOG: RwLock<mvLogFcn> = RwLock::new(None);
static ASSERT: RwLock<mvAssertFcn> = RwLock::new(None);

thread_local! {
    static CODE: Cell<mvErrorCode> = const { Cell::new(mv_errorNone) };
    static MESSAGE: RefCell<CString> = RefCell::new(CString::default());
    /// Whether this thread is inside the log or assert callback, which is not told of its own failures.
    static TELLING: Cell<bool> = const { Cell::new(false) };
}

/// Get the code of the latest failing call of this thread, and clear it.
///
/// @return one of the mv_error... constants; mv_errorNone when no call of this thread has failed since the last
/// time this was asked.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetLastError() -> mvErrorCode {
    CODE.try_with(|c| c.replace(mv_errorNone)).unwrap_or(mv_errorNone)
}

/// Get the sentence of the latest failing call of this thread. mvGetLastError() does not clear it.
///
/// @return UTF-8 that says what was wrong and what would be right, empty when nothing has failed yet; never
/// null. Valid until the next failing call of this thread, or its end.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetLastErrorMessage() -> *const c_char {
    MESSAGE.try_with(|m| m.borrow().as_ptr()).unwrap_or(c"".as_ptr())
}

/// Set the callback that hears of every failing call, on all threads.
///
/// The callback may call the library; failures of those calls are not logged.
/// @param logFcn the callback, or null for silence (the default)
#[unsafe(no_mangle)]
pub extern "C" fn mvSetLogFcn(log_fcn: mvLogFcn) {
    *LOG.write().unwrap_or_else(PoisonError::into_inner) = log_fcn;
}

/// Set the callback that hears of internal faults, that is, of bugs of this library.
///
/// The faulty call returns mv_errorInternal whether or not there is a callback; nothing is aborted.
/// @param assertFcn the callback, or null for none (the default)
#[unsafe(no_mangle)]
pub extern "C" fn mvSetAssertFcn(assert_fcn: mvAssertFcn) {
    *ASSERT.write().unwrap_or_else(PoisonError::into_inner) = assert_fcn;
}

/// Notes a failure of the exported function `function` for this thread and tells the log.
pub(super) fn report(function: &str, error: &Error) {
    let sentence = &in_words_of_c(error.sentence());
    let text = if function.is_empty() { sentence.to_owned() } else { format!("{function}: {sentence}") };
    let text = c_string(&text);
    let log = *LOG.read().unwrap_or_else(PoisonError::into_inner);
    if let Some(log) = log {
        // Sound: the caller of mvSetLogFcn promises a function of this signature; the text outlives the call.
        tell(|| unsafe { log(text.as_ptr()) });
    }
    // After the log, whose own calls must not hide this failure.
    let _ = MESSAGE.try_with(|m| *m.borrow_mut() = text);
    let _ = CODE.try_with(|c| c.set(error.code() as mvErrorCode));
}

/// The sentence with field names as the header spells them: linear_velocity becomes linearVelocity.
fn in_words_of_c(sentence: &str) -> String {
    let mut out = String::with_capacity(sentence.len());
    let mut chars = sentence.chars().peekable();
    while let Some(c) = chars.next() {
        match chars.peek() {
            Some(next)
                if c == '_'
                    && next.is_ascii_lowercase()
                    && out.ends_with(|p: char| p.is_ascii_lowercase()) =>
            {
                out.push(next.to_ascii_uppercase());
                chars.next();
            }
            _ => out.push(c),
        }
    }
    out
}

/// Tells the assert callback of a caught panic and makes an error of it.
pub(super) fn internal_fault() -> Error {
    let fault = guard::take_fault();
    let assert = *ASSERT.read().unwrap_or_else(PoisonError::into_inner);
    if let Some(assert) = assert {
        let (condition, file) = (c_string(&fault.message), c_string(&fault.file));
        // Sound: as for the log above.
        tell(|| {
            unsafe { assert(condition.as_ptr(), file.as_ptr(), fault.line as c_int) };
        });
    }
    let (message, file, line) = (&fault.message, &fault.file, fault.line);
    Error::new(ErrorCode::Internal, format!("Internal fault at {file}:{line}: {message}."))
}

/// Runs a callback of the reporting kind, unless this thread is inside one.
fn tell(callback: impl FnOnce()) {
    if TELLING.try_with(|t| t.replace(true)).unwrap_or(true) {
        return;
    }
    callback();
    let _ = TELLING.try_with(|t| t.set(false));
}

/// A C string of `s`, cut at the first zero byte.
pub(super) fn c_string(s: &str) -> CString {
    let end = s.find('\0').unwrap_or(s.len());
    CString::new(&s[..end]).unwrap_or_default()
}

/// The text at `s`: null means empty; not UTF-8 is an error.
///
/// # Safety
/// `s` is null or points to a zero-terminated string.
pub(super) unsafe fn text<'a>(what: &str, s: *const c_char) -> Result<&'a str, Error> {
    if s.is_null() {
        return Ok("");
    }
    // Sound: by this function's contract; the caller copies the text before returning to C.
    let s = unsafe { CStr::from_ptr(s) };
    s.to_str().map_err(|e| {
        Error::new(ErrorCode::Range, format!("{what} is not UTF-8: byte {} is wrong.", e.valid_up_to()))
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn sentences_name_fields_as_the_header_does() {
        assert_eq!(super::in_words_of_c("linear_velocity is NaN."), "linearVelocity is NaN.");
        assert_eq!(super::in_words_of_c("a _b c_ d__e"), "a _b c_ d__e");
    }
}
