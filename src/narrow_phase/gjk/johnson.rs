//! The point of a simplex closest to the origin by Johnson's distance sub-algorithm (Gilbert, Johnson & Keerthi 1988):
//! for each sub-simplex X the cofactors Δᵢ(X), from the smaller ones by
//! Δⱼ(X ∪ {j}) = Σ_{i ∈ X} Δᵢ(X) (yᵢ·y_k − yᵢ·yⱼ) with any k in X, and Δᵢ({i}) = 1.
//!
//! X carries the closest point where all Δᵢ(X) are positive and no Δⱼ(X ∪ {j}) is; its weights are Δᵢ(X) / Σ Δᵢ(X).
//! Where rounding has left no such X, the backup procedure takes the best of all X with positive cofactors. The
//! products of products lose digits fast: sets whose cofactors are rounding are passed over.

use super::simplex::{Best, Simplex, SubAlgorithm, Weights};
use crate::shape::Wide;

pub(super) struct Johnson;

/// A sum of cofactors below this share of (size · edge)² for triangles and of its cube for tetrahedra is rounding: the
/// points span less than they should, and the signs mean nothing.
const FLAT: f64 = 1e-14;

/// The sub-simplices as sets of bits, small ones first.
const SUBSETS: [usize; 15] = [1, 2, 4, 8, 3, 5, 6, 9, 10, 12, 7, 11, 13, 14, 15];

impl SubAlgorithm for Johnson {
    fn weights(s: &Simplex) -> Weights {
        let n = s.len();
        let size = s.scale();
        if !size.is_normal() {
            return [1.0, 0.0, 0.0, 0.0];
        }
        let mut y = [Wide::zeros(); 4];
        (0..n).for_each(|i| y[i] = s.w(i) / size);
        let mut dot = [[0.0; 4]; 4];
        let mut edge: f64 = 0.0;
        for i in 0..n {
            for j in 0..=i {
                edge = edge.max((y[i] - y[j]).amax());
                dot[i][j] = y[i].dot(&y[j]);
                dot[j][i] = dot[i][j];
            }
        }
        let mut cofactor = [[0.0; 4]; 16];
        for set in SUBSETS.into_iter().filter(|set| *set < 1 << n) {
            if set.is_power_of_two() {
                cofactor[set][set.trailing_zeros() as usize] = 1.0;
            }
            let k = set.trailing_zeros() as usize;
            for j in (0..n).filter(|j| set >> j & 1 == 0) {
                cofactor[set | 1 << j][j] = (0..n)
                    .filter(|i| set >> i & 1 == 1)
                    .map(|i| cofactor[set][i] * (dot[i][k] - dot[i][j]))
                    .sum();
            }
        }
        let mut backup = Best::new();
        for set in SUBSETS.into_iter().filter(|set| *set < 1 << n) {
            let delta = cofactor[set];
            if (0..n).any(|i| set >> i & 1 == 1 && delta[i] <= 0.0) {
                continue;
            }
            let sum: f64 = delta.iter().sum();
            let least = match set.count_ones() {
                1 | 2 => 0.0,
                3 => FLAT * edge * edge,
                _ => FLAT * edge * edge * edge,
            };
            if sum <= least {
                continue;
            }
            let weight = delta.map(|d| d / sum);
            if (0..n).all(|j| set >> j & 1 == 1 || cofactor[set | 1 << j][j] <= 0.0) {
                return weight;
            }
            backup.offer(s, weight);
        }
        backup.weight
    }
}
