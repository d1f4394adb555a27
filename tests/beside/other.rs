//! A Rust library that has nothing to do with merev, linked statically beside it.

/// The sum of squares below `n`, or -1 where that panics.
#[unsafe(no_mangle)]
pub extern "C" fn other_sum(n: i32) -> i32 {
    std::panic::catch_unwind(|| {
        let squares: Vec<i32> = (0..n).map(|k| k * k).collect();
        assert!(!squares.is_empty(), "nothing to sum");
        squares.iter().sum()
    })
    .unwrap_or(-1)
}
