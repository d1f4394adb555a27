/* ODE behind peer.h. */
#include "peer.h"
#include <math.h>
#include <ode/ode.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* The most contacts of two shapes. */
enum { MOST = 16 };

typedef struct {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    unsigned count, joint_count, sub_steps;
    double dt, bounce_speed;
    int solver;
    /* Whether ODE has given up in a step. */
    int failed;
    /* Of ODE's generator, which is one for all worlds: each goes on from its own. */
    unsigned long seed;
    peer_body *bodies;
    /* Null for what is static. */
    dBodyID *ids;
    /* Pairs that a joint holds, lesser index first, in order. */
    unsigned (*joined)[2];
    /* Force and torque for the next step. */
    double (*pushes)[6];
} ode_world;

PEER_FUNCTIONS(ode)

/* ODE has a random generator, and caches, for the whole program. */
static pthread_mutex_t one = PTHREAD_MUTEX_INITIALIZER;

static void quiet(int number, const char *format, va_list arguments) {
    (void)number, (void)format, (void)arguments;
}

static _Thread_local jmp_buf *escape;

/* ODE would end the program where a number is not finite. */
static void give_up(int number, const char *format, va_list arguments) {
    (void)number;
    if (escape) {
        longjmp(*escape, 1);
    }
    vfprintf(stderr, format, arguments);
    abort();
}

static void start_ode(void) {
    static int started = 0;
    if (!started) {
        dInitODE2(0);
        /* The pivoting solver complains by the thousand; what comes of it is measured. */
        dSetMessageHandler(quiet);
        dSetErrorHandler(give_up);
        dSetDebugHandler(give_up);
        started = 1;
    }
    dAllocateODEDataForThread(dAllocateMaskAll);
}

/* x, y, z, w to w, x, y, z. */
static void quaternion(const double q[4], dQuaternion out) {
    out[0] = q[3], out[1] = q[0], out[2] = q[1], out[3] = q[2];
}

static void rotate(const double q[4], const double v[3], double out[3]) {
    dQuaternion p;
    dMatrix3 r;
    quaternion(q, p);
    dQtoR(p, r);
    for (int i = 0; i < 3; i++) {
        out[i] = r[4 * i] * v[0] + r[4 * i + 1] * v[1] + r[4 * i + 2] * v[2];
    }
}

/* A point of a body, in the world. */
static void point_of(const peer_body *body, const double local[3], double out[3]) {
    rotate(body->rotation, local, out);
    for (int k = 0; k < 3; k++) {
        out[k] += body->position[k];
    }
}

static int order_pairs(const void *a, const void *b) {
    const unsigned *p = a, *q = b;
    if (p[0] != q[0]) {
        return p[0] < q[0] ? -1 : 1;
    }
    return p[1] < q[1] ? -1 : p[1] > q[1];
}

static int are_joined(const ode_world *w, unsigned a, unsigned b) {
    unsigned pair[2] = {a < b ? a : b, a < b ? b : a};
    return w->joint_count > 0 && bsearch(pair, w->joined, w->joint_count, sizeof pair, order_pairs) != NULL;
}

static void touch(void *data, dGeomID a, dGeomID b) {
    ode_world *w = data;
    unsigned i = (unsigned)(uintptr_t)dGeomGetData(a), k = (unsigned)(uintptr_t)dGeomGetData(b);
    if (i == k || are_joined(w, i, k)) {
        return;
    }
    dContact contacts[MOST];
    int n = dCollide(a, b, MOST, &contacts[0].geom, sizeof(dContact));
    const peer_body *p = &w->bodies[i], *q = &w->bodies[k];
    double bounce = fmax(p->restitution, q->restitution);
    for (int c = 0; c < n; c++) {
        /* A touch of hulls without depth has a normal of 0, of which ODE would make a number that is none. */
        const dReal *normal = contacts[c].geom.normal;
        if (!(dCalcVectorDot3(normal, normal) > 0.5)) {
            continue;
        }
        dSurfaceParameters *surface = &contacts[c].surface;
        surface->mode = dContactApprox1 | (bounce > 0.0 ? dContactBounce : 0);
        surface->mu = sqrt(p->friction * q->friction);
        surface->bounce = bounce;
        surface->bounce_vel = w->bounce_speed;
        dJointAttach(dJointCreateContact(w->world, w->contacts, &contacts[c]), w->ids[i], w->ids[k]);
    }
}

static dGeomID make_shape(ode_world *w, const peer_scene *scene, const peer_shape *s) {
    const double *size = s->size;
    switch (s->kind) {
    case PEER_BOX:
        return dCreateBox(w->space, 2.0 * size[0], 2.0 * size[1], 2.0 * size[2]);
    case PEER_SPHERE:
        return dCreateSphere(w->space, size[0]);
    case PEER_CAPSULE:
        return dCreateCapsule(w->space, size[0], 2.0 * size[1]);
    default: {
        const peer_hull *h = &scene->hulls[s->hull];
        return dCreateConvex(w->space, h->planes, h->plane_count, h->points, h->point_count, h->polygons);
    }
    }
}

/* ODE without libccd lets hulls and boxes pass through each other. */
static int meets_hulls(ode_world *w, const peer_scene *scene) {
    int meets = 1;
    for (unsigned h = 0; h < scene->hull_count && meets; h++) {
        peer_shape hull = {.kind = PEER_HULL, .hull = h}, box = {.kind = PEER_BOX, .size = {1e-3, 1e-3, 1e-3}};
        dGeomID a = make_shape(w, scene, &hull), b = make_shape(w, scene, &hull), c = make_shape(w, scene, &box);
        dContactGeom contact;
        meets = dCollide(a, b, 1, &contact, sizeof contact) > 0 && dCollide(a, c, 1, &contact, sizeof contact) > 0;
        dGeomDestroy(a), dGeomDestroy(b), dGeomDestroy(c);
    }
    return meets;
}

static void add_shapes(ode_world *w, const peer_scene *scene, unsigned index) {
    const peer_body *body = &scene->bodies[index];
    for (unsigned k = 0; body->collides && k < body->shape_count; k++) {
        const peer_shape *s = &scene->shapes[body->first_shape + k];
        dGeomID geom = make_shape(w, scene, s);
        dGeomSetData(geom, (void *)(uintptr_t)index);
        /* What does not give way touches only what does. */
        unsigned long moves = body->kind == PEER_DYNAMIC;
        dGeomSetCategoryBits(geom, moves ? 2 : 1);
        dGeomSetCollideBits(geom, moves ? 3 : 2);
        dQuaternion q;
        if (w->ids[index]) {
            dGeomSetBody(geom, w->ids[index]);
            quaternion(s->rotation, q);
            dGeomSetOffsetPosition(geom, s->position[0], s->position[1], s->position[2]);
            dGeomSetOffsetQuaternion(geom, q);
        } else {
            double at[3];
            dQuaternion own, inner;
            point_of(body, s->position, at);
            quaternion(body->rotation, own);
            quaternion(s->rotation, inner);
            dQMultiply0(q, own, inner);
            dGeomSetPosition(geom, at[0], at[1], at[2]);
            dGeomSetQuaternion(geom, q);
        }
    }
}

static void add_body(ode_world *w, const peer_scene *scene, unsigned index, int turns_whole) {
    const peer_body *body = &scene->bodies[index];
    if (body->kind != PEER_STATIC) {
        dBodyID id = w->ids[index] = dBodyCreate(w->world);
        dQuaternion q;
        quaternion(body->rotation, q);
        dBodySetPosition(id, body->position[0], body->position[1], body->position[2]);
        dBodySetQuaternion(id, q);
        if (body->kind == PEER_DYNAMIC) {
            const double *i = body->inertia;
            dMass mass;
            dMassSetParameters(&mass, body->mass, 0, 0, 0, i[0], i[1], i[2], 0, 0, 0);
            dBodySetMass(id, &mass);
        } else {
            dBodySetKinematic(id);
        }
        dBodySetLinearVel(id, body->velocity[0], body->velocity[1], body->velocity[2]);
        dBodySetAngularVel(id, body->spin[0], body->spin[1], body->spin[2]);
        dBodySetFiniteRotationMode(id, turns_whole);
    }
    add_shapes(w, scene, index);
}

/* A spring and a damper are a constraint with this share of the error mended a step, and this give. */
static void spring(const peer_joint *j, double dt, double *erp, double *cfm) {
    double k = dt * j->stiffness + j->damping;
    *erp = dt * j->stiffness / k;
    *cfm = 1.0 / k;
}

/* A slider counts from where its bodies are when its axis is set: that is to be where its frames meet. */
static void add_slider(ode_world *w, const peer_joint *j, const double ends[2][3], const double axis[3]) {
    dBodyID moved = w->ids[j->bodies[1]] ? w->ids[j->bodies[1]] : w->ids[j->bodies[0]];
    double sign = w->ids[j->bodies[1]] ? 1.0 : -1.0;
    const dReal *at = dBodyGetPosition(moved);
    double there[3] = {at[0], at[1], at[2]}, zero[3];
    for (int k = 0; k < 3; k++) {
        zero[k] = there[k] - sign * (ends[1][k] - ends[0][k]);
    }
    dJointID joint = dJointCreateSlider(w->world, 0);
    dBodySetPosition(moved, zero[0], zero[1], zero[2]);
    dJointAttach(joint, w->ids[j->bodies[0]], w->ids[j->bodies[1]]);
    dJointSetSliderAxis(joint, axis[0], axis[1], axis[2]);
    dBodySetPosition(moved, there[0], there[1], there[2]);
    if (j->springs) {
        double erp, cfm;
        spring(j, w->dt, &erp, &cfm);
        /* ODE takes stops that are not below and above in the order given: twice, so that both are set. */
        for (int k = 0; k < 2; k++) {
            dJointSetSliderParam(joint, dParamLoStop, 0.0);
            dJointSetSliderParam(joint, dParamHiStop, 0.0);
        }
        dJointSetSliderParam(joint, dParamStopERP, erp);
        dJointSetSliderParam(joint, dParamStopCFM, cfm);
    }
}

static void add_distance(ode_world *w, const peer_joint *j, const double ends[2][3]) {
    dJointID joint = dJointCreateDBall(w->world, 0);
    dJointAttach(joint, w->ids[j->bodies[0]], w->ids[j->bodies[1]]);
    dJointSetDBallAnchor1(joint, ends[0][0], ends[0][1], ends[0][2]);
    dJointSetDBallAnchor2(joint, ends[1][0], ends[1][1], ends[1][2]);
    dJointSetDBallDistance(joint, j->length);
    if (j->springs) {
        double erp, cfm;
        spring(j, w->dt, &erp, &cfm);
        dJointSetDBallParam(joint, dParamERP, erp);
        dJointSetDBallParam(joint, dParamCFM, cfm);
    }
}

/* Whether the frames of a joint begin where they should be; if not, ODE would take where they are for that. */
static int starts_together(const peer_joint *j, const double ends[2][3], const double axis[3]) {
    double d[3], along = 0.0, apart = 0.0;
    for (int k = 0; k < 3; k++) {
        d[k] = ends[1][k] - ends[0][k];
        along += d[k] * axis[k];
    }
    for (int k = 0; k < 3; k++) {
        double off = d[k] - (j->kind == PEER_SLIDER ? along * axis[k] : 0.0);
        apart += off * off;
    }
    return apart < 1e-12;
}

static const char *add_joint(ode_world *w, const peer_scene *scene, const peer_joint *j) {
    double ends[2][3], axis[3], along[3] = {j->kind == PEER_SLIDER, 0.0, j->kind != PEER_SLIDER};
    dBodyID a = w->ids[j->bodies[0]], b = w->ids[j->bodies[1]];
    if (!a && !b) {
        return NULL;
    }
    for (int k = 0; k < 2; k++) {
        point_of(&scene->bodies[j->bodies[k]], j->position[k], ends[k]);
    }
    double inner[3];
    rotate(j->rotation[0], along, inner);
    rotate(scene->bodies[j->bodies[0]].rotation, inner, axis);
    if (j->kind == PEER_ROD || j->kind == PEER_SPRING) {
        add_distance(w, j, ends);
        return NULL;
    }
    if (!starts_together(j, ends, axis)) {
        return "a joint whose frames start apart";
    }
    if (j->kind == PEER_SLIDER) {
        add_slider(w, j, ends, axis);
    } else if (j->kind == PEER_WELD) {
        dJointID joint = dJointCreateFixed(w->world, 0);
        dJointAttach(joint, a, b);
        dJointSetFixed(joint);
    } else if (j->kind == PEER_HINGE) {
        dJointID joint = dJointCreateHinge(w->world, 0);
        dJointAttach(joint, a, b);
        dJointSetHingeAnchor(joint, ends[0][0], ends[0][1], ends[0][2]);
        dJointSetHingeAxis(joint, axis[0], axis[1], axis[2]);
    } else {
        dJointID joint = dJointCreateBall(w->world, 0);
        dJointAttach(joint, a, b);
        dJointSetBallAnchor(joint, ends[0][0], ends[0][1], ends[0][2]);
    }
    return NULL;
}

static void fill_joined(ode_world *w, const peer_scene *scene) {
    for (unsigned k = 0; k < scene->joint_count; k++) {
        const unsigned *b = scene->joints[k].bodies;
        w->joined[k][0] = b[0] < b[1] ? b[0] : b[1];
        w->joined[k][1] = b[0] < b[1] ? b[1] : b[0];
    }
    w->joint_count = scene->joint_count;
    if (w->joint_count > 0) {
        qsort(w->joined, w->joint_count, sizeof *w->joined, order_pairs);
    }
}

void *ode_create(const peer_scene *scene, const peer_setting *setting, char *why, unsigned why_size) {
    pthread_mutex_lock(&one);
    start_ode();
    unsigned n = scene->body_count;
    ode_world *w = calloc(1, sizeof *w);
    w->world = dWorldCreate();
    w->space = dHashSpaceCreate(0);
    w->contacts = dJointGroupCreate(0);
    w->count = n;
    w->sub_steps = setting->sub_steps;
    w->dt = setting->dt;
    w->solver = setting->solver;
    w->bounce_speed = fmax(scene->restitution_threshold, 0.0);
    w->bodies = calloc(n, sizeof *w->bodies);
    w->ids = calloc(n, sizeof *w->ids);
    w->pushes = calloc(n, sizeof *w->pushes);
    w->joined = calloc(scene->joint_count + 1, sizeof *w->joined);
    dWorldSetGravity(w->world, scene->gravity[0], scene->gravity[1], scene->gravity[2]);
    dWorldSetAutoDisableFlag(w->world, scene->sleeps);
    if (setting->iterations > 0) {
        dWorldSetQuickStepNumIterations(w->world, (int)setting->iterations);
    }
    for (unsigned k = 0; k < n; k++) {
        w->bodies[k] = scene->bodies[k];
        add_body(w, scene, k, setting->integrator == 1);
    }
    fill_joined(w, scene);
    const char *problem = meets_hulls(w, scene) ? NULL : "this build of ODE has no collision of hulls";
    for (unsigned k = 0; k < scene->joint_count && !problem; k++) {
        problem = add_joint(w, scene, &scene->joints[k]);
    }
    pthread_mutex_unlock(&one);
    if (problem) {
        snprintf(why, why_size, "%s", problem);
        ode_destroy(w);
        return NULL;
    }
    return w;
}

static void advance(ode_world *w) {
    for (unsigned s = 0; s < w->sub_steps; s++) {
        for (unsigned k = 0; k < w->count; k++) {
            const double *p = w->pushes[k];
            if (w->ids[k] && (p[0] != 0 || p[1] != 0 || p[2] != 0 || p[3] != 0 || p[4] != 0 || p[5] != 0)) {
                dBodyAddForce(w->ids[k], p[0], p[1], p[2]);
                dBodyAddTorque(w->ids[k], p[3], p[4], p[5]);
            }
        }
        dSpaceCollide(w->space, w, touch);
        if (w->solver == 0) {
            dWorldQuickStep(w->world, w->dt);
        } else {
            dWorldStep(w->world, w->dt);
        }
        dJointGroupEmpty(w->contacts);
    }
}

void ode_step(void *world) {
    ode_world *w = world;
    jmp_buf here;
    if (w->failed) {
        return;
    }
    pthread_mutex_lock(&one);
    dRandSetSeed(w->seed);
    escape = &here;
    if (setjmp(here) == 0) {
        advance(w);
    } else {
        w->failed = 1;
    }
    escape = NULL;
    w->seed = dRandGetSeed();
    pthread_mutex_unlock(&one);
    for (unsigned k = 0; k < w->count; k++) {
        for (int i = 0; i < 6; i++) {
            w->pushes[k][i] = 0.0;
        }
    }
}

void ode_push(void *world, unsigned body, const double force[3], const double torque[3]) {
    double *p = ((ode_world *)world)->pushes[body];
    for (int i = 0; i < 3; i++) {
        p[i] += force[i];
        p[3 + i] += torque[i];
    }
}

void ode_motions(const void *world, peer_motion *out) {
    const ode_world *w = world;
    for (unsigned k = 0; k < w->count; k++) {
        peer_motion *m = &out[k];
        if (!w->ids[k]) {
            for (int i = 0; i < 4; i++) {
                m->rotation[i] = w->bodies[k].rotation[i];
            }
            for (int i = 0; i < 3; i++) {
                m->position[i] = w->bodies[k].position[i];
                m->velocity[i] = m->spin[i] = 0.0;
            }
            continue;
        }
        const dReal *p = dBodyGetPosition(w->ids[k]), *q = dBodyGetQuaternion(w->ids[k]);
        const dReal *v = dBodyGetLinearVel(w->ids[k]), *s = dBodyGetAngularVel(w->ids[k]);
        for (int i = 0; i < 3; i++) {
            m->position[i] = p[i];
            m->velocity[i] = v[i];
            m->spin[i] = s[i];
            m->rotation[i] = q[1 + i];
        }
        m->rotation[3] = q[0];
    }
}

int ode_is_broken(const void *world) {
    return ((const ode_world *)world)->failed;
}

void ode_destroy(void *world) {
    ode_world *w = world;
    pthread_mutex_lock(&one);
    dJointGroupDestroy(w->contacts);
    dSpaceDestroy(w->space);
    dWorldDestroy(w->world);
    pthread_mutex_unlock(&one);
    free(w->bodies);
    free(w->ids);
    free(w->pushes);
    free(w->joined);
    free(w);
}

const char *ode_version(void) {
    return dODE_VERSION;
}
