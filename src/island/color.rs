//! Graph colouring: constraints of one colour share no moving body, so they can be solved side by side.
//! Colours persist with the constraint; what finds none of the 24 is overflow, solved one after another.

/// How many colours there are.
pub const COLORS: usize = 24;
/// The "colour" of constraints that found none.
pub const OVERFLOW: u8 = COLORS as u8;
/// Not a constraint.
pub const NO_COLOR: u8 = u8::MAX;

/// Constraints between two moving bodies search from colour 0 up, those with something immovable from the last
/// one down: a body's support is solved last, so that it holds when the sweep ends.
#[derive(Clone, Debug)]
pub struct Coloring {
    /// For each colour, a bit for each body that has a constraint of that colour.
    used: [Vec<u64>; COLORS],
}

impl Default for Coloring {
    fn default() -> Self {
        Self { used: std::array::from_fn(|_| Vec::new()) }
    }
}

impl Coloring {
    /// Finds a colour for a constraint between the given moving bodies (one or two) and takes it.
    pub fn assign(&mut self, moving: &[u32]) -> u8 {
        let free = |color: usize, used: &[Vec<u64>; COLORS]| {
            moving.iter().all(|&b| used[color].get(b as usize / 64).is_none_or(|w| w >> (b % 64) & 1 == 0))
        };
        let found = if moving.len() > 1 {
            (0..COLORS).find(|&c| free(c, &self.used))
        } else {
            (0..COLORS).rev().find(|&c| free(c, &self.used))
        };
        let Some(color) = found else { return OVERFLOW };
        for &b in moving {
            let word = b as usize / 64;
            if self.used[color].len() <= word {
                self.used[color].resize(word + 1, 0);
            }
            self.used[color][word] |= 1 << (b % 64);
        }
        color as u8
    }

    /// Gives a colour back.
    pub fn release(&mut self, color: u8, moving: &[u32]) {
        if (color as usize) < COLORS {
            for &b in moving {
                self.used[color as usize][b as usize / 64] &= !(1 << (b % 64));
            }
        }
    }

    /// The bodies that have a constraint of this colour, in order.
    pub fn holders(&self, color: usize) -> impl Iterator<Item = u32> + '_ {
        (0..self.used[color].len() as u32 * 64)
            .filter(move |&b| self.used[color][b as usize / 64] >> (b % 64) & 1 == 1)
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.used.iter().map(|w| w.capacity() * 8).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constraints_that_share_a_body_get_different_colours_until_none_is_left() {
        let mut coloring = Coloring::default();
        let mut seen = Vec::new();
        for other in 1..=COLORS as u32 {
            let color = coloring.assign(&[0, other]);
            assert!(!seen.contains(&color) && color != OVERFLOW);
            seen.push(color);
        }
        assert_eq!(coloring.assign(&[0, 99]), OVERFLOW);
        coloring.release(seen[3], &[0, 4]);
        assert_eq!(coloring.assign(&[0, 99]), seen[3]);
    }

    #[test]
    fn supports_are_coloured_from_the_end() {
        let mut coloring = Coloring::default();
        assert_eq!(coloring.assign(&[5]), COLORS as u8 - 1);
        assert_eq!(coloring.assign(&[5, 6]), 0);
    }
}
