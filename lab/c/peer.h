/* How an engine in C or C++ stands behind the lab: a world from plain data, steps, pushes, and where bodies are.
   src/engines/shim has the same structs in Rust. Units are SI; quaternions are x, y, z, w; a body's frame is its centre
   of mass with its principal axes. */
#ifndef PEER_H
#define PEER_H

#ifdef __cplusplus
extern "C" {
#endif

/* A capsule lies along the z of its shape; size is half sides, radius, or radius and half length. */
enum { PEER_BOX, PEER_SPHERE, PEER_CAPSULE, PEER_HULL };
enum { PEER_STATIC, PEER_KINEMATIC, PEER_DYNAMIC };
enum { PEER_BALL, PEER_HINGE, PEER_SLIDER, PEER_WELD, PEER_ROD, PEER_SPRING };

/* A convex hull: points, planes (outward normal and offset each), and polygons (count and then so many indices,
   counter-clockwise from outside) in the order of the planes. They live as long as the world. */
typedef struct {
    const double *points;
    unsigned point_count;
    const double *planes;
    unsigned plane_count;
    const unsigned *polygons;
} peer_hull;

typedef struct {
    int kind;
    unsigned hull;
    double size[3];
    double position[3];
    double rotation[4];
} peer_shape;

typedef struct {
    int kind;
    unsigned first_shape;
    unsigned shape_count;
    int collides;
    double position[3];
    double rotation[4];
    double velocity[3];
    double spin[3];
    double mass;
    double inertia[3];
    double friction;
    double restitution;
} peer_body;

/* A slider's axis is x, a hinge's z. The spring of a slider rests at 0, that between points at `length`. */
typedef struct {
    int kind;
    int springs;
    unsigned bodies[2];
    double position[2][3];
    double rotation[2][4];
    double length;
    double stiffness;
    double damping;
} peer_joint;

typedef struct {
    double gravity[3];
    /* Negative: the engine's own. */
    double restitution_threshold;
    int sleeps;
    unsigned hull_count;
    unsigned shape_count;
    unsigned body_count;
    unsigned joint_count;
    const peer_hull *hulls;
    const peer_shape *shapes;
    const peer_body *bodies;
    const peer_joint *joints;
} peer_scene;

/* dt is that of a sub-step; solver and integrator count in the order of the adapter's lists. */
typedef struct {
    double dt;
    unsigned sub_steps;
    unsigned iterations;
    int solver;
    int integrator;
} peer_setting;

typedef struct {
    double position[3];
    double rotation[4];
    double velocity[3];
    double spin[3];
} peer_motion;

/* What each engine offers. `create` returns null and says why in `why`. A push (force and torque about the centre of
   mass) lasts for the next step with all its sub-steps. `motions` fills one for each body. */
#define PEER_FUNCTIONS(name)                                                                                      \
    void *name##_create(const peer_scene *, const peer_setting *, char *why, unsigned why_size);                  \
    void name##_step(void *);                                                                                     \
    void name##_push(void *, unsigned body, const double force[3], const double torque[3]);                       \
    void name##_motions(const void *, peer_motion *);                                                             \
    int name##_is_broken(const void *);                                                                           \
    void name##_destroy(void *);                                                                                  \
    const char *name##_version(void);

#ifdef __cplusplus
}
#endif

#endif
