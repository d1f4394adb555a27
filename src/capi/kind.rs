//! Choices among several ways, and their names.

use super::def::*;
use super::def_check::choice;
use super::guard::call;
use crate::broad_phase::BroadPhaseKind;
use crate::error::Result;
use crate::integrate::IntegratorKind;
use crate::narrow_phase::{GjkKind, ManifoldKind, NarrowPhaseKind};
use crate::solver::SolverKind;
use core::ffi::{CStr, c_char};

/// Soft contacts, sub-steps instead of iterations.
pub const mv_solver_softStep: mvSolverKind = 1;
/// The thesis's: the impulse of a collision at every point, again and again; for comparison.
pub const mv_solver_sequentialImpulse: mvSolverKind = 2;
/// Accumulated impulses, their sum is clamped; begins with those of the last step.
pub const mv_solver_projectedGaussSeidel: mvSolverKind = 3;
/// All contacts of an island at once by complementary pivoting, friction pyramids; for small scenes.
pub const mv_solver_lemke: mvSolverKind = 4;
/// All contacts of an island at once by principal pivoting with bounds, friction pyramids; for small scenes.
pub const mv_solver_dantzig: mvSolverKind = 5;
/// All contacts of an island at once, exact friction cones; for scenes of moderate size.
pub const mv_solver_proximalAdmm: mvSolverKind = 6;
/// Velocities of the start of the step: the thesis's method, for comparison.
pub const mv_integrator_explicitEuler: mvIntegratorKind = 1;
/// Velocities of the end of the step: what most engines do, for comparison.
pub const mv_integrator_semiImplicitEuler: mvIntegratorKind = 2;
/// Exact flight, and a rotation that keeps energy and angular momentum.
pub const mv_integrator_moserVeselov: mvIntegratorKind = 3;
/// Exact flight, rotation by exact turns about the principal axes.
pub const mv_integrator_symmetricSplitting: mvIntegratorKind = 4;
/// Exact flight, rotation by the angular velocity of the middle of the step.
pub const mv_integrator_lieMidpoint: mvIntegratorKind = 5;
/// Exact flight, rotation by Runge and Kutta's method of fourth order.
pub const mv_integrator_rk4: mvIntegratorKind = 6;
/// Exact flight, rotation by elliptic functions.
pub const mv_integrator_exactRotation: mvIntegratorKind = 7;
/// All pairs are looked at: slow, simple, a yardstick.
pub const mv_broadPhase_bruteForce: mvBroadPhaseKind = 1;
/// Trees of boxes that follow the motion.
pub const mv_broadPhase_dynamicBvh: mvBroadPhaseKind = 2;
/// One list sorted along the axis of greatest spread.
pub const mv_broadPhase_sortAndSweep: mvBroadPhaseKind = 3;
/// Three sorted lists, whose overlaps are intersected.
pub const mv_broadPhase_sortAndSweep3: mvBroadPhaseKind = 4;
/// Guttman's R-tree, grown box by box.
pub const mv_broadPhase_rTree: mvBroadPhaseKind = 5;
/// The R*-tree, grown box by box with reinsertion.
pub const mv_broadPhase_rStar: mvBroadPhaseKind = 6;
/// An R-tree packed by sort-tile-recursive, built anew as boxes change.
pub const mv_broadPhase_str: mvBroadPhaseKind = 7;
/// An R-tree packed top-down with least overlap, built anew as boxes change.
pub const mv_broadPhase_omt: mvBroadPhaseKind = 8;
/// All pairs but those of two standing shapes.
pub const mv_broadPhase_bruteForceSplit: mvBroadPhaseKind = 9;
/// The same as mv_broadPhase_sortAndSweep, with what stands in a list of its own.
pub const mv_broadPhase_sortAndSweepSplit: mvBroadPhaseKind = 10;
/// The same as mv_broadPhase_sortAndSweep3, with what stands in lists of its own.
pub const mv_broadPhase_sortAndSweep3Split: mvBroadPhaseKind = 11;
/// The same as mv_broadPhase_rTree, with what stands in a tree of its own.
pub const mv_broadPhase_rTreeSplit: mvBroadPhaseKind = 12;
/// The same as mv_broadPhase_rStar, with what stands in a tree of its own.
pub const mv_broadPhase_rStarSplit: mvBroadPhaseKind = 13;
/// The same as mv_broadPhase_str, with what stands in a tree of its own.
pub const mv_broadPhase_strSplit: mvBroadPhaseKind = 14;
/// The same as mv_broadPhase_omt, with what stands in a tree of its own.
pub const mv_broadPhase_omtSplit: mvBroadPhaseKind = 15;
/// R-trees packed as mv_broadPhase_omt, patched where shapes move and packed anew when worn out.
pub const mv_broadPhase_dynamicRTree: mvBroadPhaseKind = 16;
/// Closed forms and separating axes.
pub const mv_narrowPhase_specialised: mvNarrowPhaseKind = 1;
/// Iterative distance and penetration: a cross-check by another way.
pub const mv_narrowPhase_gjkEpa: mvNarrowPhaseKind = 2;
/// Iterative distance, and penetration along a ray: cheaper, but the penetration need not be the least.
pub const mv_narrowPhase_gjkMpr: mvNarrowPhaseKind = 3;
/// A linear system for barycentric coordinates, with recursion over faces: slow, a yardstick.
pub const mv_gjk_barycentric: mvGjkKind = 1;
/// The Voronoi regions of vertices, edges and faces.
pub const mv_gjk_cutSpace: mvGjkKind = 2;
/// Signs of volumes.
pub const mv_gjk_signedVolumes: mvGjkKind = 3;
/// Cofactors of all faces, with a backup procedure.
pub const mv_gjk_johnson: mvGjkKind = 4;
/// One face is cut by the sides of the other.
pub const mv_manifold_sutherlandHodgman: mvManifoldKind = 1;
/// Both faces are intersected by the polygon library Clipper2. Fails with mv_errorUnsupported where it is not built in.
pub const mv_manifold_clipper2: mvManifoldKind = 2;

// The numbers of the header are those of the engine.
const _: () = {
    assert!(mv_solver_softStep == SolverKind::SoftStep as i32);
    assert!(mv_solver_sequentialImpulse == SolverKind::SequentialImpulse as i32);
    assert!(mv_solver_projectedGaussSeidel == SolverKind::ProjectedGaussSeidel as i32);
    assert!(mv_solver_lemke == SolverKind::Lemke as i32);
    assert!(mv_solver_dantzig == SolverKind::Dantzig as i32);
    assert!(mv_solver_proximalAdmm == SolverKind::ProximalAdmm as i32);
    assert!(mv_integrator_explicitEuler == IntegratorKind::ExplicitEuler as i32);
    assert!(mv_integrator_semiImplicitEuler == IntegratorKind::SemiImplicitEuler as i32);
    assert!(mv_integrator_moserVeselov == IntegratorKind::MoserVeselov as i32);
    assert!(mv_integrator_symmetricSplitting == IntegratorKind::SymmetricSplitting as i32);
    assert!(mv_integrator_lieMidpoint == IntegratorKind::LieMidpoint as i32);
    assert!(mv_integrator_rk4 == IntegratorKind::Rk4 as i32);
    assert!(mv_integrator_exactRotation == IntegratorKind::ExactRotation as i32);
    assert!(mv_broadPhase_bruteForce == BroadPhaseKind::BruteForce as i32);
    assert!(mv_broadPhase_dynamicBvh == BroadPhaseKind::DynamicBvh as i32);
    assert!(mv_broadPhase_sortAndSweep == BroadPhaseKind::SortAndSweep as i32);
    assert!(mv_broadPhase_sortAndSweep3 == BroadPhaseKind::SortAndSweep3 as i32);
    assert!(mv_broadPhase_rTree == BroadPhaseKind::RTree as i32);
    assert!(mv_broadPhase_rStar == BroadPhaseKind::RStar as i32);
    assert!(mv_broadPhase_str == BroadPhaseKind::Str as i32);
    assert!(mv_broadPhase_omt == BroadPhaseKind::Omt as i32);
    assert!(mv_broadPhase_bruteForceSplit == BroadPhaseKind::BruteForceSplit as i32);
    assert!(mv_broadPhase_sortAndSweepSplit == BroadPhaseKind::SortAndSweepSplit as i32);
    assert!(mv_broadPhase_sortAndSweep3Split == BroadPhaseKind::SortAndSweep3Split as i32);
    assert!(mv_broadPhase_rTreeSplit == BroadPhaseKind::RTreeSplit as i32);
    assert!(mv_broadPhase_rStarSplit == BroadPhaseKind::RStarSplit as i32);
    assert!(mv_broadPhase_strSplit == BroadPhaseKind::StrSplit as i32);
    assert!(mv_broadPhase_omtSplit == BroadPhaseKind::OmtSplit as i32);
    assert!(mv_broadPhase_dynamicRTree == BroadPhaseKind::DynamicRTree as i32);
    assert!(mv_narrowPhase_specialised == NarrowPhaseKind::Specialised as i32);
    assert!(mv_narrowPhase_gjkEpa == NarrowPhaseKind::GjkEpa as i32);
    assert!(mv_narrowPhase_gjkMpr == NarrowPhaseKind::GjkMpr as i32);
    assert!(mv_gjk_barycentric == GjkKind::Barycentric as i32);
    assert!(mv_gjk_cutSpace == GjkKind::CutSpace as i32);
    assert!(mv_gjk_signedVolumes == GjkKind::SignedVolumes as i32);
    assert!(mv_gjk_johnson == GjkKind::Johnson as i32);
    assert!(mv_manifold_sutherlandHodgman == ManifoldKind::SutherlandHodgman as i32);
    assert!(mv_manifold_clipper2 == ManifoldKind::Clipper2 as i32);
};

/// Get the name of a solver.
///
/// @return a constant, null for a number that is none of the constants
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetSolverKindName(kind: mvSolverKind) -> *const c_char {
    call(|| Ok(constant(solver(kind)?.name())))
}

/// Get the name of an integrator.
///
/// @return a constant, null for a number that is none of the constants
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetIntegratorKindName(kind: mvIntegratorKind) -> *const c_char {
    call(|| Ok(constant(integrator(kind)?.name())))
}

/// Get the name of a broad phase.
///
/// @return a constant, null for a number that is none of the constants
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetBroadPhaseKindName(kind: mvBroadPhaseKind) -> *const c_char {
    call(|| Ok(constant(broad_phase(kind)?.name())))
}

/// Get the name of a narrow phase.
///
/// @return a constant, null for a number that is none of the constants
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetNarrowPhaseKindName(kind: mvNarrowPhaseKind) -> *const c_char {
    call(|| Ok(constant(narrow_phase(kind)?.name())))
}

/// Get the name of a way to look at simplices.
///
/// @return a constant, null for a number that is none of the constants
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetGjkKindName(kind: mvGjkKind) -> *const c_char {
    call(|| Ok(constant(gjk(kind)?.name())))
}

/// Get the name of a way to find contact points.
///
/// @return a constant, null for a number that is none of the constants
/// @note Errors: mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvGetManifoldKindName(kind: mvManifoldKind) -> *const c_char {
    call(|| Ok(constant(manifold(kind)?.name())))
}

pub(super) fn solver(kind: mvSolverKind) -> Result<SolverKind> {
    if kind == mv_solver_auto {
        return Ok(SolverKind::Auto);
    }
    choice("solver", kind, &SolverKind::ALL, |k| k as i32)
}

pub(super) fn integrator(kind: mvIntegratorKind) -> Result<IntegratorKind> {
    if kind == mv_integrator_auto {
        return Ok(IntegratorKind::Auto);
    }
    choice("integrator", kind, &IntegratorKind::ALL, |k| k as i32)
}

pub(super) fn broad_phase(kind: mvBroadPhaseKind) -> Result<BroadPhaseKind> {
    if kind == BroadPhaseKind::Auto as i32 {
        return Ok(BroadPhaseKind::Auto);
    }
    choice("broadPhase", kind, &BroadPhaseKind::ALL, |k| k as i32)
}

pub(super) fn narrow_phase(kind: mvNarrowPhaseKind) -> Result<NarrowPhaseKind> {
    choice("narrowPhase", kind, &NarrowPhaseKind::ALL, |k| k as i32)
}

pub(super) fn gjk(kind: mvGjkKind) -> Result<GjkKind> {
    choice("gjk", kind, &GjkKind::ALL, |k| k as i32)
}

pub(super) fn manifold(kind: mvManifoldKind) -> Result<ManifoldKind> {
    choice("manifold", kind, &ManifoldKind::ALL, |k| k as i32)
}

/// The engine's name as a C constant.
fn constant(name: &str) -> *const c_char {
    #[rustfmt::skip]
    const NAMES: &[&CStr] = &[
        c"auto",
        c"soft_step",
        c"sequential_impulse",
        c"projected_gauss_seidel",
        c"lemke",
        c"dantzig",
        c"proximal_admm",
        c"explicit_euler",
        c"semi_implicit_euler",
        c"moser_veselov",
        c"symmetric_splitting",
        c"lie_midpoint",
        c"rk4",
        c"exact_rotation",
        c"brute_force",
        c"dynamic_bvh",
        c"specialised",
        c"gjk_epa",
        c"gjk_mpr",
        c"barycentric",
        c"cut_space",
        c"signed_volumes",
        c"johnson",
        c"sutherland_hodgman",
        c"clipper2",
        c"sort_and_sweep",
        c"sort_and_sweep_3",
        c"rtree",
        c"rstar",
        c"str",
        c"omt",
        c"brute_force_split",
        c"sort_and_sweep_split",
        c"sort_and_sweep_3_split",
        c"rtree_split",
        c"rstar_split",
        c"str_split",
        c"omt_split",
        c"dynamic_rtree",
    ];
    NAMES.iter().find(|n| n.to_bytes() == name.as_bytes()).map_or(c"unnamed".as_ptr(), |n| n.as_ptr())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_the_engine_has_a_number_and_a_name() {
        let named = |p: *const c_char| {
            assert!(!p.is_null());
            // Sound: a constant.
            assert_ne!(unsafe { CStr::from_ptr(p) }, c"unnamed");
        };
        SolverKind::ALL.iter().for_each(|&k| named(mvGetSolverKindName(k as i32)));
        IntegratorKind::ALL.iter().for_each(|&k| named(mvGetIntegratorKindName(k as i32)));
        BroadPhaseKind::ALL.iter().for_each(|&k| named(mvGetBroadPhaseKindName(k as i32)));
        NarrowPhaseKind::ALL.iter().for_each(|&k| named(mvGetNarrowPhaseKindName(k as i32)));
        GjkKind::ALL.iter().for_each(|&k| named(mvGetGjkKindName(k as i32)));
        ManifoldKind::ALL.iter().for_each(|&k| named(mvGetManifoldKindName(k as i32)));
    }
}
