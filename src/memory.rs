//! How the large arrays grow: by a quarter, not by doubling, so that little is held in vain.

/// Makes room for `more` elements.
#[inline]
pub(crate) fn make_room<T>(list: &mut Vec<T>, more: usize) {
    if list.capacity() - list.len() < more {
        list.reserve_exact(more.max(list.len() / 4).max(16));
    }
}
