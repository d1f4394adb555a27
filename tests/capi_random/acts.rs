//! What a story can do: every function of the header that takes an id, and most of the others.

use super::*;
use std::mem::MaybeUninit;

pub const ACTS: &[Act] = &[
    // Worlds.
    ("create world", |s| {
        let def = s.world_def();
        let w = mvCreateWorld(if s.r.below(30) == 0 { None } else { Some(&def) });
        if w.index1 != 0 {
            s.worlds.push(w);
        }
    }),
    ("destroy world", |s| {
        if s.r.below(6) == 0 {
            mvDestroyWorld(s.world());
        }
    }),
    ("step", step),
    ("step again", step),
    ("step and again", step),
    ("callbacks", |s| {
        let (w, on) = (s.world(), s.r.below(2) == 0);
        let context = null_mut();
        match s.r.below(4) {
            0 => mvWorld_SetCustomFilterCallback(w, on.then_some(filter as _), context),
            1 => mvWorld_SetPreSolveCallback(w, on.then_some(pre_solve as _), context),
            2 => mvWorld_SetFrictionCallback(w, on.then_some(mixing as _), context),
            _ => mvWorld_SetRestitutionCallback(w, on.then_some(mixing as _), context),
        }
    }),
    ("tune world", |s| {
        let (w, x) = (s.world(), s.r.num());
        match s.r.below(10) {
            0 => mvWorld_SetGravity(w, s.r.vec()),
            1 => mvWorld_EnableSleeping(w, s.r.flag()),
            2 => mvWorld_EnableWarmStarting(w, s.r.flag()),
            3 => mvWorld_SetRestitutionThreshold(w, x),
            4 => mvWorld_SetHitEventThreshold(w, x),
            5 => mvWorld_SetContactTuning(w, x, s.r.num(), s.r.num()),
            6 => mvWorld_SetMaximumLinearSpeed(w, if s.r.below(3) == 0 { x } else { mvFloat::INFINITY }),
            7 => mvWorld_SetWorkerCount(w, s.r.choice()),
            8 => mvWorld_SetAccuracy(w, x),
            _ => mvWorld_SetUserData(w, std::ptr::without_provenance_mut(s.r.word() as usize)),
        }
    }),
    ("read world", |s| {
        let w = s.world();
        match s.r.below(20) {
            0 => drop(mvWorld_GetGravity(w)),
            1 => drop(mvWorld_IsSleepingEnabled(w)),
            2 => drop(mvWorld_IsWarmStartingEnabled(w)),
            3 => drop(mvWorld_GetRestitutionThreshold(w)),
            4 => drop(mvWorld_GetHitEventThreshold(w)),
            5 => drop(mvWorld_GetContactTuning(w)),
            6 => drop(mvWorld_GetMaximumLinearSpeed(w)),
            7 => drop(mvWorld_GetAwakeBodyCount(w)),
            8 => drop(mvWorld_GetWorkerCount(w)),
            9 => drop(mvWorld_GetProfile(w)),
            10 => drop(mvWorld_GetCounters(w)),
            11 => drop(mvWorld_GetStepReport(w)),
            12 => drop(mvWorld_GetStateHash(w)),
            13 => drop(mvWorld_GetUserData(w)),
            14 => drop(mvWorld_GetBounds(w)),
            15 => drop(mvWorld_IsValid(w)),
            16 => drop(mvGetByteCount()),
            17 => drop(mvGetWorldCount()),
            18 => mvWorld_RebuildStaticTree(w),
            _ => drop(mvGetLastErrorMessage()),
        }
    }),
    ("events", |s| {
        let w = s.world();
        let (moves, contacts) = (mvWorld_GetBodyEvents(w), mvWorld_GetContactEvents(w));
        if s.alone && s.r.below(2) == 0 {
            for k in 0..moves.move_count as usize {
                // Sound: the array is valid until the next step, which is not before the next call.
                let event = unsafe { *moves.move_events.add(k) };
                assert!(event.transform.p.x.is_finite() && event.transform.q.s.is_finite());
            }
            for k in 0..contacts.begin_count as usize {
                // Sound: as above.
                s.contacts.push(unsafe { *contacts.begin_events.add(k) }.contact_id);
            }
        }
    }),
    ("draw", |s| {
        let (w, mut draw) = (s.world(), mvDefaultDebugDraw());
        draw.draw_segment_fcn = Some(segment);
        draw.draw_shape_fcn = (s.r.below(2) == 0).then_some(draw_shape as _);
        draw.draw_polygon_fcn = Some(polygon);
        draw.draw_string_fcn = Some(string);
        if s.r.below(4) == 0 {
            draw.drawing_bounds = s.r.aabb();
            draw.force_scale = s.r.num();
            draw.joint_scale = s.r.num();
        }
        for on in [
            &mut draw.draw_shapes,
            &mut draw.draw_edges,
            &mut draw.draw_joint_extras,
            &mut draw.draw_bounds,
            &mut draw.draw_mass,
            &mut draw.draw_sleep,
            &mut draw.draw_body_names,
            &mut draw.draw_contacts,
            &mut draw.draw_contact_features,
            &mut draw.draw_contact_normals,
            &mut draw.draw_contact_forces,
            &mut draw.draw_friction_forces,
            &mut draw.draw_islands,
            &mut draw.tessellate,
        ] {
            *on = u8::from(s.r.below(2) == 0);
        }
        if s.r.below(10) == 0 {
            draw.draw_graph_colors = s.r.word() as u8;
        }
        let (draw, mask) = (if s.r.below(30) == 0 { None } else { Some(&draw) }, s.r.word());
        if s.r.below(2) == 0 {
            // Sound: the functions are of the right signatures.
            unsafe { mvWorld_Draw(w, draw, mask) };
        } else if s.alone {
            let b = mvWorld_DrawBuffers(w, draw, u64::MAX);
            for k in 0..b.line_count as usize {
                // Sound: valid until the next drawing, which is not before the next call.
                let line = unsafe { *b.lines.add(k) };
                assert!(line.p1.x.is_finite() && line.color <= 0xff_ff_ff);
            }
            for k in 0..b.triangle_count as usize {
                // Sound: as above.
                let triangle = unsafe { *b.triangles.add(k) };
                assert!(triangle.p3.y.is_finite() && triangle.normal.x.is_finite());
            }
        }
    }),
    ("bulk", |s| {
        let (w, n) = (s.world(), [0, 5, 64, -1][s.r.below(4)]);
        let mut ids = [MaybeUninit::<mvBodyId>::uninit(); 64];
        let mut linear = [MaybeUninit::<mvVec3>::uninit(); 64];
        let all = s.r.below(2) == 0;
        // Sound: there is room for 64.
        let total = unsafe {
            let linear = if all { linear.as_mut_ptr().cast() } else { null_mut() };
            mvWorld_GetAwakeBodies(w, ids.as_mut_ptr().cast(), null_mut(), linear, null_mut(), n)
        };
        assert!(total >= 0);
        for id in &ids[..total.min(n.max(0)) as usize] {
            // Sound: as many as were found, and as there was room for, are written.
            s.bodies.push(unsafe { id.assume_init() });
        }
    }),
    ("move bodies", |s| {
        let n = s.r.below(4);
        let ids: Vec<_> = (0..n).map(|_| s.body()).collect();
        let transforms: Vec<_> = (0..n).map(|_| s.r.world_transform()).collect();
        // Sound: both arrays have n elements.
        unsafe { mvBody_SetTransforms(ids.as_ptr(), transforms.as_ptr(), n as c_int) };
    }),
    // Bodies.
    ("create body", create_body),
    ("create another body", create_body),
    ("destroy body", |s| {
        if s.r.below(3) == 0 {
            mvDestroyBody(s.body());
        }
    }),
    ("read body", |s| {
        let (b, v, p) = (s.body(), s.r.vec(), s.r.pos());
        match s.r.below(34) {
            0 => drop(mvBody_IsValid(b)),
            1 => drop(mvBody_GetWorld(b)),
            2 => drop(mvBody_GetType(b)),
            3 => drop(mvBody_GetUserData(b)),
            4 => drop(mvBody_IsAwake(b)),
            5 => drop(mvBody_IsSleepEnabled(b)),
            6 => drop(mvBody_GetSleepThreshold(b)),
            7 => drop(mvBody_IsEnabled(b)),
            8 => drop(mvBody_GetMotionLocks(b)),
            9 => drop(mvBody_GetShapeCount(b)),
            10 => drop(mvBody_ComputeAABB(b)),
            11 => drop(mvBody_GetContactCapacity(b)),
            12 => drop(mvBody_GetPosition(b)),
            13 => drop(mvBody_GetRotation(b)),
            14 => drop(mvBody_GetTransform(b)),
            15 => drop(mvBody_GetLocalPoint(b, p)),
            16 => drop(mvBody_GetWorldPoint(b, v)),
            17 => drop(mvBody_GetLocalVector(b, v)),
            18 => drop(mvBody_GetWorldVector(b, v)),
            19 => drop(mvBody_GetLocalPointVelocity(b, v)),
            20 => drop(mvBody_GetWorldPointVelocity(b, p)),
            21 => drop(mvBody_GetLinearVelocity(b)),
            22 => drop(mvBody_GetAngularVelocity(b)),
            23 => drop(mvBody_GetMomentum(b)),
            24 => drop(mvBody_GetAngularMomentum(b)),
            25 => drop(mvBody_GetKineticEnergy(b)),
            26 => drop((mvBody_GetMass(b), mvBody_GetInverseMass(b))),
            27 => drop(mvBody_GetLocalRotationalInertia(b)),
            28 => drop(mvBody_GetWorldInverseRotationalInertia(b)),
            29 => drop((mvBody_GetLocalCenter(b), mvBody_GetWorldCenter(b))),
            30 => drop(mvBody_GetMassData(b)),
            31 => drop((mvBody_GetLinearDamping(b), mvBody_GetAngularDamping(b), mvBody_GetGravityScale(b))),
            32 => drop(mvBody_GetClosestPoint(b, None, v)),
            _ => {
                let name = mvBody_GetName(b);
                if s.alone && !name.is_null() {
                    // Sound: valid until the name changes, on this thread only.
                    assert!(unsafe { CStr::from_ptr(name) }.to_bytes().len() < 10);
                }
            }
        }
    }),
    ("place body", |s| mvBody_SetTransform(s.body(), s.r.place(), s.r.quat())),
    ("target body", |s| mvBody_SetTargetTransform(s.body(), s.r.world_transform(), s.r.num(), s.r.flag())),
    ("velocities", |s| {
        let (b, v) = (s.body(), s.r.vec());
        match s.r.below(4) {
            0 => mvBody_SetLinearVelocity(b, v),
            1 => mvBody_SetAngularVelocity(b, v),
            2 => mvBody_SetMomentum(b, v),
            _ => mvBody_SetAngularMomentum(b, v),
        }
    }),
    ("push", |s| {
        let (b, f, p, wake) = (s.body(), s.r.vec(), s.r.pos(), s.r.flag());
        match s.r.below(6) {
            0 => mvBody_ApplyForce(b, f, p, wake),
            1 => mvBody_ApplyForceToCenter(b, f, wake),
            2 => mvBody_ApplyTorque(b, f, wake),
            3 => mvBody_ApplyLinearImpulse(b, f, p, wake),
            4 => mvBody_ApplyLinearImpulseToCenter(b, f, wake),
            _ => mvBody_ApplyAngularImpulse(b, f, wake),
        }
    }),
    ("set body", |s| {
        let (b, x, flag) = (s.body(), s.r.num(), s.r.flag());
        match s.r.below(16) {
            0 => mvBody_SetType(b, s.r.choice()),
            1 => mvBody_SetUserData(b, null_mut()),
            2 => mvBody_SetAwake(b, flag),
            3 => mvBody_EnableSleep(b, flag),
            4 => mvBody_SetSleepThreshold(b, x),
            5 => mvBody_Disable(b),
            6 | 7 => mvBody_Enable(b),
            8 => {
                let [linear_x, linear_y, linear_z, angular_x, angular_y, angular_z] =
                    [0; 6].map(|_: u8| s.r.flag());
                let locks = mvMotionLocks { linear_x, linear_y, linear_z, angular_x, angular_y, angular_z };
                mvBody_SetMotionLocks(b, locks);
            }
            9 => mvBody_EnableHitEvents(b, flag),
            10 => mvBody_SetLinearDamping(b, x),
            11 => mvBody_SetAngularDamping(b, x),
            12 => mvBody_SetGravityScale(b, x),
            13 => mvBody_ApplyMassFromShapes(b),
            14 => {
                let d = s.r.size();
                let mut m = mvBody_GetMassData(b);
                (m.mass, m.center) = (s.r.size(), s.r.vec());
                m.inertia = mvMatrix3 {
                    cx: mvVec3 { x: d, y: 0.0, z: 0.0 },
                    cy: mvVec3 { x: 0.0, y: d, z: 0.0 },
                    cz: mvVec3 { x: 0.0, y: 0.0, z: s.r.size() },
                };
                mvGetLastError();
                mvBody_SetMassData(b, m);
            }
            _ => {
                let name = name(&mut s.r);
                // Sound: null or a string.
                unsafe { mvBody_SetName(b, name.as_ref().map_or(null(), |n| n.as_ptr())) };
            }
        }
    }),
    ("shapes of body", |s| {
        let (b, n) = (s.body(), s.r.choice().min(8));
        let mut ids = [mvShapeId::default(); 8];
        // Sound: there is room for 8.
        let got = unsafe { mvBody_GetShapes(b, ids.as_mut_ptr(), n) };
        assert!(got >= 0 && got <= n.max(0));
        s.shapes.extend(&ids[..got as usize]);
    }),
    ("contacts", |s| {
        let (b, id, n) = (s.body(), s.shape(), s.r.choice().min(8));
        let mut data = [const { MaybeUninit::<mvContactData>::uninit() }; 8];
        // Sound: there is room for 8.
        let got = unsafe {
            if s.r.below(2) == 0 {
                mvBody_GetContactData(b, data.as_mut_ptr().cast(), n)
            } else {
                mvShape_GetContactData(id, data.as_mut_ptr().cast(), n)
            }
        };
        for d in &data[..got as usize] {
            // Sound: as many as it says are written; manifolds are valid until the next step.
            let d = unsafe { d.assume_init() };
            s.contacts.push(d.contact_id);
            if s.alone {
                let m = unsafe { *d.manifolds };
                assert!(m.point_count <= 4 && m.normal.x.is_finite());
            }
        }
    }),
    ("contact", |s| {
        let _ = mvContact_IsValid(s.contacts[s.r.late(s.contacts.len())]);
    }),
    ("cast at body", |s| {
        let (b, o, v, f, t) = (s.body(), s.r.pos(), s.r.vec(), s.r.filter(), s.r.world_transform());
        with_proxy(s, |s, proxy| {
            let (most, flag) = (s.r.size(), s.r.flag());
            // Sound: the proxy is as it says.
            unsafe {
                match s.r.below(3) {
                    0 => drop(mvBody_CastRay(b, o, v, f, most, t)),
                    1 => drop(mvBody_CastShape(b, o, proxy, v, f, most, flag, t)),
                    _ => drop(mvBody_OverlapShape(b, o, proxy, f, t)),
                }
            }
        });
    }),
    // Shapes.
    ("create shape", create_shape),
    ("create another shape", create_shape),
    ("and another shape", create_shape),
    ("destroy shape", |s| {
        if s.r.below(2) == 0 {
            mvDestroyShape(s.shape(), s.r.flag());
        }
    }),
    ("read shape", |s| {
        let id = s.shape();
        match s.r.below(25) {
            0 => drop(mvShape_IsValid(id)),
            1 => drop(mvShape_GetType(id)),
            2 => drop(mvShape_GetBody(id)),
            3 => drop(mvShape_GetWorld(id)),
            4 => drop(mvShape_GetUserData(id)),
            5 => drop(mvShape_GetSphere(id)),
            6 => drop(mvShape_GetCapsule(id)),
            7 => drop(mvShape_GetPlane(id)),
            8 => drop(mvShape_GetDensity(id)),
            9 => drop(mvShape_GetFriction(id)),
            10 => drop(mvShape_GetStaticFriction(id)),
            11 => drop(mvShape_GetRestitution(id)),
            12 => drop(mvShape_GetSurfaceMaterial(id)),
            13 => drop(mvShape_GetFilter(id)),
            14 => drop(mvShape_AreContactEventsEnabled(id)),
            15 => drop(mvShape_ArePreSolveEventsEnabled(id)),
            16 => drop(mvShape_AreHitEventsEnabled(id)),
            17 => drop(mvShape_GetAABB(id)),
            18 => drop(mvShape_ComputeMassData(id)),
            19 => drop(mvShape_GetContactCapacity(id)),
            20 => drop(mvShape_GetClosestPoint(id, s.r.vec())),
            21 => drop(mvShape_RayCast(id, s.r.pos(), s.r.vec())),
            22 => drop(mvShape_GetName(id)),
            _ => {
                let hull = mvShape_GetHull(id);
                if s.alone && !hull.is_null() {
                    // Sound: valid until the shape changes, on this thread only.
                    s.hulls.push(unsafe { mvCloneHull(hull) });
                }
            }
        }
    }),
    ("set shape", |s| {
        let (id, x, flag) = (s.shape(), s.r.num(), s.r.flag());
        match s.r.below(16) {
            0 => mvShape_SetUserData(id, null_mut()),
            1 => mvShape_SetDensity(id, x, flag),
            2 => mvShape_SetFriction(id, x),
            3 => mvShape_SetStaticFriction(id, x),
            4 => mvShape_SetRestitution(id, x),
            5 => mvShape_SetSurfaceMaterial(id, s.shape_def().base_material),
            6 => mvShape_SetFilter(id, s.shape_def().filter, flag),
            7 => mvShape_EnableContactEvents(id, flag),
            8 => mvShape_EnablePreSolveEvents(id, flag),
            9 => mvShape_EnableHitEvents(id, flag),
            10 => mvShape_SetSphere(id, Some(&sphere(s))),
            11 => mvShape_SetCapsule(id, Some(&capsule(s))),
            12 | 13 => {
                let hull = s.hull();
                // Sound: null or a hull.
                unsafe { mvShape_SetHull(id, hull) };
            }
            _ => {
                let name = name(&mut s.r);
                // Sound: null or a string.
                unsafe { mvShape_SetName(id, name.as_ref().map_or(null(), |n| n.as_ptr())) };
            }
        }
    }),
    // Joints.
    ("create joint", joints::create),
    ("create another joint", joints::create),
    ("and another joint", joints::create),
    ("destroy joint", joints::destroy),
    ("joints of body", joints::list),
    ("joint events", joints::events),
    ("set joint", joints::change),
    ("set joint again", joints::change),
    ("read joint", joints::read),
    // Queries.
    ("query", |s| {
        let (w, o, v, f, a) = (s.world(), s.r.pos(), s.r.vec(), s.r.filter(), s.r.aabb());
        let n = s.r.choice().min(8);
        let mut ids = [mvShapeId::default(); 8];
        let mut hits = [const { MaybeUninit::<mvRayResult>::uninit() }; 8];
        with_proxy(s, |s, proxy| {
            let context = null_mut();
            // Sound: the proxy is as it says, and there is room for 8.
            unsafe {
                match s.r.below(10) {
                    0 => drop(mvWorld_OverlapAABB(w, a, f, Some(overlap), context)),
                    1 => drop(mvWorld_OverlapAABBAll(w, a, f, ids.as_mut_ptr(), n)),
                    2 => drop(mvWorld_OverlapShape(w, o, proxy, f, Some(overlap), context)),
                    3 => drop(mvWorld_OverlapShapeAll(w, o, proxy, f, ids.as_mut_ptr(), n)),
                    4 => drop(mvWorld_CastRay(w, o, v, f, Some(cast), context)),
                    5 => drop(mvWorld_CastRayClosest(w, o, v, f)),
                    6 => drop(mvWorld_CastRayAll(w, o, v, f, hits.as_mut_ptr().cast(), n)),
                    7 => drop(mvWorld_CastShape(w, o, proxy, v, f, Some(cast), context)),
                    8 => drop(mvWorld_CastShapeClosest(w, o, proxy, v, f)),
                    _ => drop(mvWorld_CastShapeAll(w, o, proxy, v, f, hits.as_mut_ptr().cast(), n)),
                }
            }
        });
        s.shapes.extend(ids.iter().filter(|i| i.index1 != 0));
    }),
    // Geometry.
    ("make hull", |s| {
        let n = s.r.below(40);
        let points: Vec<mvVec3> = (0..n).map(|_| s.r.vec()).collect();
        // Sound: as many points as it says.
        let hull = unsafe {
            match s.r.below(5) {
                0 => mvCreateCylinder(s.r.size(), s.r.size(), s.r.num(), s.r.choice().min(40)),
                1 => mvCreateCone(s.r.size(), s.r.size(), s.r.size(), s.r.choice().min(40)),
                2 => mvCloneHull(s.hull()),
                3 => mvCloneAndTransformHull(s.hull(), s.r.transform(), s.r.vec()),
                _ => mvCreateHull(points.as_ptr(), n as c_int, s.r.choice()),
            }
        };
        if !hull.is_null() {
            s.hulls.push(hull);
        }
    }),
    ("destroy hull", |s| {
        if s.hulls.len() > 4 {
            let k = s.r.below(s.hulls.len());
            // Sound: the story made it and has not destroyed it yet.
            unsafe { mvDestroyHull(s.hulls.swap_remove(k)) };
        } else {
            // Sound: an address that no hull has is refused without being followed.
            unsafe { mvDestroyHull(std::ptr::without_provenance_mut(8 * s.r.below(1 << 20))) };
        }
    }),
    ("make box", |s| {
        let (x, y, z) = (s.r.size(), s.r.size(), s.r.size());
        let mut b = match s.r.below(4) {
            0 => mvMakeCubeHull(x),
            1 => mvMakeBoxHull(x, y, z),
            2 => mvMakeOffsetBoxHull(x, y, z, s.r.vec()),
            _ => mvMakeTransformedBoxHull(x, y, z, s.r.transform()),
        };
        if s.r.below(10) == 0 {
            // Sound: any bits make a box, though none that is accepted.
            let bytes = unsafe { &mut *(&raw mut b).cast::<[u8; size_of::<mvBoxHull>()]>() };
            bytes[s.r.below(bytes.len())] ^= 1 << s.r.below(8);
        }
        s.boxes.push(b);
    }),
    ("measure", |s| {
        let (ball, pill, hull, t, x) = (sphere(s), capsule(s), s.hull(), s.r.transform(), s.r.size());
        let ray = mvRayCastInput { origin: s.r.vec(), translation: s.r.vec(), max_fraction: s.r.size() };
        // Sound: null or a hull.
        unsafe {
            match s.r.below(10) {
                0 => drop(mvComputeSphereMass(Some(&ball), x)),
                1 => drop(mvComputeCapsuleMass(Some(&pill), x)),
                2 => drop(mvComputeHullMass(hull, x)),
                3 => drop(mvComputeSphereAABB(Some(&ball), t)),
                4 => drop(mvComputeCapsuleAABB(Some(&pill), t)),
                5 => drop(mvComputeHullAABB(hull, t)),
                6 => drop(mvRayCastSphere(Some(&ball), Some(&ray))),
                7 => drop(mvRayCastCapsule(Some(&pill), Some(&ray))),
                8 => drop(mvRayCastHull(hull, Some(&ray))),
                _ => drop(mvIsValidRay(Some(&ray))),
            }
        }
    }),
    ("collide", |s| {
        let (a, b, p, q) = (sphere(s), sphere(s), capsule(s), capsule(s));
        let (h, g, t, n) = (s.hull(), s.hull(), s.r.transform(), s.r.choice().min(4));
        let mut points = [const { MaybeUninit::<mvLocalManifoldPoint>::uninit() }; 4];
        let mut m = mvLocalManifold {
            normal: mvVec3::default(),
            points: points.as_mut_ptr().cast(),
            point_count: -5,
        };
        let out = Some(&mut m);
        // Sound: room for 4 points; null or hulls.
        unsafe {
            match s.r.below(6) {
                0 => mvCollideSpheres(out, n, Some(&a), Some(&b), t),
                1 => mvCollideCapsuleAndSphere(out, n, Some(&p), Some(&b), t),
                2 => mvCollideCapsules(out, n, Some(&p), Some(&q), t),
                3 => mvCollideHullAndSphere(out, n, h, Some(&b), t, None),
                4 => mvCollideHullAndCapsule(out, n, h, Some(&q), t, None),
                _ => mvCollideHulls(out, n, h, g, t, None),
            }
        }
        assert!((0..=4).contains(&m.point_count));
    }),
    ("distance", |s| {
        let (ball, pill, hull, t, v) = (sphere(s), capsule(s), s.hull(), s.r.transform(), s.r.vec());
        let points = [s.r.vec(), s.r.vec(), s.r.vec()];
        let mine =
            mvShapeProxy { points: points.as_ptr(), count: 1 + s.r.below(3) as c_int, radius: s.r.size() };
        with_proxy(s, |s, proxy| {
            let other = *proxy.unwrap_or(&mine);
            let most = s.r.size();
            let input = mvDistanceInput {
                proxy_a: mine,
                proxy_b: other,
                transform: t,
                use_radii: s.r.flag(),
                gjk: s.r.below(6) as i32,
            };
            let cast = mvShapeCastInput { proxy: other, translation: v, max_fraction: most, can_encroach: 0 };
            let pair = mvShapeCastPairInput {
                proxy_a: mine,
                proxy_b: other,
                transform: t,
                translation_b: v,
                max_fraction: most,
                can_encroach: s.r.flag(),
            };
            let mut cache = mvSimplexCache { metric: 0.0, count: 0, index_a: [0; 4], index_b: [0; 4] };
            let mut simplex = MaybeUninit::<mvSimplex>::uninit();
            // Sound: proxies are as they say, room for one simplex; null or a hull.
            unsafe {
                match s.r.below(8) {
                    0 => drop(mvShapeDistance(Some(&input), Some(&mut cache), simplex.as_mut_ptr(), 1)),
                    1 => drop(mvShapeCast(Some(&pair))),
                    2 => drop(mvOverlapSphere(Some(&ball), t, Some(&other))),
                    3 => drop(mvOverlapCapsule(Some(&pill), t, Some(&other))),
                    4 => drop(mvOverlapHull(hull, t, Some(&other))),
                    5 => drop(mvShapeCastSphere(Some(&ball), Some(&cast))),
                    6 => drop(mvShapeCastCapsule(Some(&pill), Some(&cast))),
                    _ => drop(mvShapeCastHull(hull, Some(&cast))),
                }
            }
        });
    }),
    ("mathematics", |s| {
        let (a, b, x) = (s.r.vec(), s.r.vec(), s.r.num());
        match s.r.below(6) {
            0 => drop(mvAtan2(x, s.r.num())),
            1 => drop(mvComputeCosSin(x)),
            2 => drop(mvComputeQuatBetweenUnitVectors(a, b)),
            3 => drop(mvSteiner(x, a)),
            4 => drop(mvSegmentDistance(a, b, s.r.vec(), s.r.vec())),
            _ => drop(mvLineDistance(a, b, s.r.vec(), s.r.vec())),
        }
    }),
];

fn step(s: &mut Story) {
    let (w, dt) = (s.world(), if s.r.below(12) == 0 { s.r.num() } else { 1.0 / 60.0 });
    // A step of hours may take its time, but not in this test.
    let dt = if dt.is_finite() { dt.min(1e6) } else { dt };
    mvWorld_Step(w, dt, if s.r.below(12) == 0 { s.r.choice().min(20) } else { 1 + s.r.below(4) as c_int });
}

fn create_body(s: &mut Story) {
    let (w, def) = (s.world(), s.body_def());
    if mvWorld_GetCounters(w).body_count as usize >= MOST_BODIES {
        return;
    }
    mvGetLastError();
    let def = if s.r.below(40) == 0 { None } else { Some(&def) };
    // Sound: the name is null or a string.
    let b = unsafe { mvCreateBody(w, def) };
    if b.index1 != 0 {
        s.bodies.push(b);
    }
}

fn create_shape(s: &mut Story) {
    let (b, def) = (s.body(), s.shape_def());
    if mvBody_GetShapeCount(b) > 3 {
        return;
    }
    mvGetLastError();
    let def = if s.r.below(40) == 0 { None } else { Some(&def) };
    let (ball, pill, hull) = (sphere(s), capsule(s), s.hull());
    let plane = mvPlane { normal: s.r.vec(), offset: s.r.num() };
    // Sound: the name is null or a string, the hull null or a hull.
    let id = unsafe {
        match s.r.below(8) {
            0 | 1 => mvCreateSphereShape(b, def, Some(&ball)),
            2 => mvCreateCapsuleShape(b, def, Some(&pill)),
            3 | 4 => mvCreateHullShape(b, def, hull),
            5 => mvCreateTransformedHullShape(b, def, hull, s.r.transform(), s.r.vec()),
            6 => mvCreateBoxShape(b, def, s.r.size(), s.r.size(), s.r.size()),
            _ => mvCreatePlaneShape(b, def, Some(&plane)),
        }
    };
    if id.index1 != 0 {
        s.shapes.push(id);
    }
}

fn sphere(s: &mut Story) -> mvSphere {
    let center = if s.r.below(3) == 0 { s.r.vec() } else { mvVec3::default() };
    mvSphere { center, radius: s.r.size() }
}

fn capsule(s: &mut Story) -> mvCapsule {
    mvCapsule { center1: s.r.vec(), center2: s.r.vec(), radius: s.r.size() }
}

/// Runs `f` with a proxy, good, bad or null.
fn with_proxy(s: &mut Story, f: impl FnOnce(&mut Story, Option<&mvShapeProxy>)) {
    let n = s.r.below(10);
    let points: Vec<mvVec3> = (0..n).map(|_| s.r.vec()).collect();
    let count = if s.r.below(20) == 0 { -1 } else { n as c_int };
    let proxy = mvShapeProxy {
        points: if s.r.below(20) == 0 { null() } else { points.as_ptr() },
        count,
        radius: if s.r.below(3) == 0 { 0.0 } else { s.r.size() },
    };
    let none = s.r.below(20) == 0;
    f(s, if none { None } else { Some(&proxy) });
}
