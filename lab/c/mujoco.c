/* MuJoCo behind peer.h. Joints make trees in reduced coordinates, as is MuJoCo's way; what closes a loop, or starts
   with velocities that its joint does not allow, is an equality constraint. */
#include "peer.h"
#include <math.h>
#include <mujoco/mujoco.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The most explicit pairs of shapes, which surfaces need that MuJoCo would mix otherwise. */
enum { MOST_PAIRS = 4000 };

typedef struct {
    mjModel *model;
    mjData *data;
    unsigned count, sub_steps;
    /* MuJoCo's index of each body. */
    int *ids;
    /* Whether all that moves does so freely: then its state is read as it stands. */
    int is_free;
    int failed;
    peer_body *bodies;
} mujoco_world;

/* What is known of a joint or a body while the model grows. */
typedef struct {
    const peer_scene *scene;
    mjSpec *spec;
    mjsBody **made;
    /* The joint by which a body hangs in the tree; -1 for none. */
    int *by;
    int *parent;
    int *used;
    const char *problem;
} maker;

PEER_FUNCTIONS(mujoco)

static _Thread_local jmp_buf *escape;
static _Thread_local char last_error[200];

/* MuJoCo would end the program. */
static void on_error(const char *text) {
    snprintf(last_error, sizeof last_error, "%s", text);
    if (escape) {
        longjmp(*escape, 1);
    }
    fprintf(stderr, "MuJoCo: %s\n", text);
    abort();
}

/* MuJoCo would write a file. What is dropped is counted in the data. */
static void on_warning(const char *text) {
    (void)text;
}

/* x, y, z, w to w, x, y, z, and back. */
static void to_quat(const double q[4], double out[4]) {
    out[0] = q[3], out[1] = q[0], out[2] = q[1], out[3] = q[2];
}

static void from_quat(const double q[4], double out[4]) {
    out[0] = q[1], out[1] = q[2], out[2] = q[3], out[3] = q[0];
}

static void turn(const double q[4], const double v[3], double out[3]) {
    double p[4];
    to_quat(q, p);
    mju_rotVecQuat(out, v, p);
}

static void turn_back(const double q[4], const double v[3], double out[3]) {
    double p[4], n[4];
    to_quat(q, p);
    mju_negQuat(n, p);
    mju_rotVecQuat(out, v, n);
}

static double distance(const double a[3], const double b[3]) {
    return mju_dist3(a, b);
}

/* Where a joint's end is, and how fast. */
static void end_of(const peer_scene *scene, const peer_joint *j, int side, double at[3], double velocity[3]) {
    const peer_body *b = &scene->bodies[j->bodies[side]];
    double arm[3], swing[3];
    turn(b->rotation, j->position[side], arm);
    mju_add3(at, b->position, arm);
    mju_cross(swing, b->spin, arm);
    mju_add3(velocity, b->velocity, swing);
}

/* A joint's axis in the world. */
static void axis_of(const peer_scene *scene, const peer_joint *j, int side, double axis[3]) {
    double own[3] = {j->kind == PEER_SLIDER, 0.0, j->kind != PEER_SLIDER}, inner[3];
    turn(j->rotation[side], own, inner);
    turn(scene->bodies[j->bodies[side]].rotation, inner, axis);
}

/* The part of a vector across an axis. */
static double across(const double v[3], const double axis[3]) {
    double along = mju_dot3(v, axis), rest[3];
    for (int k = 0; k < 3; k++) {
        rest[k] = v[k] - along * axis[k];
    }
    return mju_norm3(rest);
}

/* Whether places and velocities are those that the joint allows: then it may be a joint of the tree. */
static int starts_right(const peer_scene *scene, const peer_joint *j) {
    const double close = 1e-9;
    const peer_body *a = &scene->bodies[j->bodies[0]], *b = &scene->bodies[j->bodies[1]];
    double p[2][3], v[2][3], axes[2][3], gap[3], speed[3], spin[3];
    for (int side = 0; side < 2; side++) {
        end_of(scene, j, side, p[side], v[side]);
        axis_of(scene, j, side, axes[side]);
    }
    mju_sub3(gap, p[1], p[0]);
    mju_sub3(speed, v[1], v[0]);
    mju_sub3(spin, b->spin, a->spin);
    switch (j->kind) {
    case PEER_BALL:
        return mju_norm3(gap) < close && mju_norm3(speed) < close;
    case PEER_HINGE:
        return mju_norm3(gap) < close && mju_norm3(speed) < close && distance(axes[0], axes[1]) < close &&
               across(spin, axes[0]) < close;
    case PEER_WELD:
        return mju_norm3(gap) < close && mju_norm3(speed) < close && mju_norm3(spin) < close;
    case PEER_SLIDER:
        return across(gap, axes[0]) < close && across(speed, axes[0]) < close && mju_norm3(spin) < close;
    default:
        return 0;
    }
}

/* Hangs bodies on each other by joints, breadth first: what is static, then the first of each group. */
static void plan_tree(maker *m) {
    const peer_scene *scene = m->scene;
    unsigned n = scene->body_count, head = 0, tail = 0, next = 0;
    unsigned *queue = calloc(n + 1, sizeof *queue);
    char *seen = calloc(n + 1, 1);
    unsigned *first = calloc(n + 2, sizeof *first), *list = calloc(2 * scene->joint_count + 1, sizeof *list);
    for (unsigned j = 0; j < scene->joint_count; j++) {
        first[scene->joints[j].bodies[0] + 1]++;
        first[scene->joints[j].bodies[1] + 1]++;
    }
    for (unsigned k = 0; k < n; k++) {
        first[k + 1] += first[k];
    }
    unsigned *fill = calloc(n + 1, sizeof *fill);
    for (unsigned j = 0; j < scene->joint_count; j++) {
        for (int side = 0; side < 2; side++) {
            unsigned b = scene->joints[j].bodies[side];
            list[first[b] + fill[b]++] = j;
        }
    }
    for (unsigned k = 0; k < n; k++) {
        m->by[k] = m->parent[k] = -1;
        if (scene->bodies[k].kind == PEER_STATIC) {
            queue[tail++] = k;
            seen[k] = 1;
        }
    }
    for (;;) {
        if (head == tail) {
            while (next < n && seen[next]) {
                next++;
            }
            if (next == n) {
                break;
            }
            queue[tail++] = next;
            seen[next] = 1;
        }
        unsigned b = queue[head++];
        for (unsigned i = first[b]; i < first[b + 1]; i++) {
            const peer_joint *j = &scene->joints[list[i]];
            unsigned other = j->bodies[0] == b ? j->bodies[1] : j->bodies[0];
            if (!seen[other] && starts_right(scene, j)) {
                seen[other] = 1;
                m->by[other] = (int)list[i];
                m->parent[other] = (int)b;
                m->used[list[i]] = 1;
                queue[tail++] = other;
            }
        }
    }
    free(queue), free(seen), free(first), free(list), free(fill);
}

static mjsGeom *add_geom(mjsBody *body, const peer_shape *s, const char *name) {
    mjsGeom *g = mjs_addGeom(body, NULL);
    char mesh[24];
    mjs_setName(g->element, name);
    memcpy(g->pos, s->position, sizeof g->pos);
    to_quat(s->rotation, g->quat);
    memcpy(g->size, s->size, sizeof g->size);
    switch (s->kind) {
    case PEER_BOX:
        g->type = mjGEOM_BOX;
        break;
    case PEER_SPHERE:
        g->type = mjGEOM_SPHERE;
        break;
    case PEER_CAPSULE:
        g->type = mjGEOM_CAPSULE;
        break;
    default:
        g->type = mjGEOM_MESH;
        snprintf(mesh, sizeof mesh, "h%u", s->hull);
        mjs_setString(g->meshname, mesh);
    }
    return g;
}

static void add_geoms(maker *m, unsigned index, mjsBody *body, int pairs) {
    const peer_body *b = &m->scene->bodies[index];
    for (unsigned k = 0; b->collides && k < b->shape_count; k++) {
        char name[24];
        snprintf(name, sizeof name, "g%u", b->first_shape + k);
        mjsGeom *g = add_geom(body, &m->scene->shapes[b->first_shape + k], name);
        g->friction[0] = b->friction;
        g->condim = b->friction > 0.0 ? 3 : 1;
        if (pairs) {
            g->contype = g->conaffinity = 0;
        }
    }
}

/* The joint by which a body hangs. */
static void add_joint(maker *m, unsigned index, mjsBody *body) {
    const peer_joint *j = &m->scene->joints[m->by[index]];
    int side = j->bodies[1] == index;
    if (j->kind == PEER_WELD) {
        return;
    }
    mjsJoint *joint = mjs_addJoint(body, NULL);
    memcpy(joint->pos, j->position[side], sizeof joint->pos);
    joint->type = j->kind == PEER_BALL ? mjJNT_BALL : j->kind == PEER_HINGE ? mjJNT_HINGE : mjJNT_SLIDE;
    if (j->kind != PEER_BALL) {
        double own[3] = {j->kind == PEER_SLIDER, 0.0, j->kind != PEER_SLIDER};
        turn(j->rotation[side], own, joint->axis);
    }
    if (j->kind == PEER_SLIDER) {
        double p[2][3], v[3], axis[3], gap[3];
        end_of(m->scene, j, 0, p[0], v);
        end_of(m->scene, j, 1, p[1], v);
        axis_of(m->scene, j, side, axis);
        mju_sub3(gap, p[side], p[!side]);
        joint->ref = mju_dot3(gap, axis);
        joint->springref = 0.0;
        joint->stiffness[0] = j->stiffness;
        joint->damping[0] = j->damping;
    }
}

/* A body under its parent, which is made before it. */
static mjsBody *add_body(maker *m, unsigned index, int pairs) {
    if (m->made[index]) {
        return m->made[index];
    }
    const peer_body *b = &m->scene->bodies[index];
    int up = m->parent[index];
    mjsBody *above = up < 0 ? mjs_findBody(m->spec, "world") : add_body(m, (unsigned)up, pairs);
    mjsBody *body = m->made[index] = mjs_addBody(above, NULL);
    char name[24];
    snprintf(name, sizeof name, "b%u", index);
    mjs_setName(body->element, name);
    memcpy(body->pos, b->position, sizeof body->pos);
    to_quat(b->rotation, body->quat);
    if (up >= 0) {
        const peer_body *p = &m->scene->bodies[up];
        double between[3], q[4], n[4], own[4];
        mju_sub3(between, b->position, p->position);
        turn_back(p->rotation, between, body->pos);
        to_quat(p->rotation, q);
        mju_negQuat(n, q);
        to_quat(b->rotation, own);
        mju_mulQuat(body->quat, n, own);
    }
    if (b->kind == PEER_DYNAMIC) {
        body->explicitinertial = 1;
        body->mass = b->mass;
        /* Unsaid, MuJoCo takes the frame of the parent. */
        mju_zero3(body->ipos);
        mju_unit4(body->iquat);
        memcpy(body->inertia, b->inertia, sizeof body->inertia);
        if (up < 0) {
            mjs_addFreeJoint(body);
        } else {
            add_joint(m, index, body);
        }
    }
    add_geoms(m, index, body, pairs);
    return body;
}

static void name_of(const char *format, unsigned index, mjString *to) {
    char name[24];
    snprintf(name, sizeof name, format, index);
    mjs_setString(to, name);
}

static void connect(maker *m, const peer_joint *j, const double at[3]) {
    mjsEquality *e = mjs_addEquality(m->spec, NULL);
    e->type = mjEQ_CONNECT;
    e->objtype = mjOBJ_BODY;
    name_of("b%u", j->bodies[0], e->name1);
    name_of("b%u", j->bodies[1], e->name2);
    memcpy(e->data, at, 3 * sizeof(double));
}

/* A rod is a tendon of fixed length, a spring one with a stiffness. */
static void add_tendon(maker *m, unsigned index, const peer_joint *j) {
    mjsTendon *t = mjs_addTendon(m->spec, NULL);
    char name[24];
    double p[2][3], v[3];
    for (int side = 0; side < 2; side++) {
        snprintf(name, sizeof name, "s%u_%d", index, side);
        mjsSite *site = mjs_addSite(m->made[j->bodies[side]], NULL);
        mjs_setName(site->element, name);
        memcpy(site->pos, j->position[side], sizeof site->pos);
        mjs_wrapSite(t, name);
        end_of(m->scene, j, side, p[side], v);
    }
    snprintf(name, sizeof name, "t%u", index);
    mjs_setName(t->element, name);
    if (j->kind == PEER_SPRING) {
        t->stiffness[0] = j->stiffness;
        t->damping[0] = j->damping;
        t->springlength[0] = t->springlength[1] = j->length;
        return;
    }
    if (fabs(distance(p[0], p[1]) - j->length) > 1e-9) {
        m->problem = "MuJoCo holds a rod at the length that it starts with";
    }
    mjsEquality *e = mjs_addEquality(m->spec, NULL);
    e->type = mjEQ_TENDON;
    e->objtype = mjOBJ_TENDON;
    mjs_setString(e->name1, name);
}

/* A joint that is not in the tree. */
static void close_loop(maker *m, unsigned index) {
    const peer_joint *j = &m->scene->joints[index];
    const peer_body *bodies = m->scene->bodies;
    if (bodies[j->bodies[0]].kind == PEER_STATIC && bodies[j->bodies[1]].kind == PEER_STATIC) {
        return;
    }
    if (j->kind == PEER_BALL) {
        connect(m, j, j->position[0]);
    } else if (j->kind == PEER_HINGE) {
        /* Two points of its axis, 0.1 m to either side. */
        for (int k = -1; k <= 1; k += 2) {
            double own[3] = {0.0, 0.0, 0.1 * k}, arm[3], at[3];
            turn(j->rotation[0], own, arm);
            mju_add3(at, j->position[0], arm);
            connect(m, j, at);
        }
    } else if (j->kind == PEER_ROD || j->kind == PEER_SPRING) {
        add_tendon(m, index, j);
    } else {
        m->problem = "a slider or a weld that closes a loop";
    }
}

/* Whether all surfaces are alike, so that MuJoCo's greater one of two is what the scene means. */
static int alike(const peer_scene *scene) {
    double friction = -1.0;
    for (unsigned k = 0; k < scene->body_count; k++) {
        const peer_body *b = &scene->bodies[k];
        if (b->collides && friction >= 0.0 && b->friction != friction) {
            return 0;
        }
        friction = b->collides ? b->friction : friction;
    }
    return 1;
}

static int are_joined(const peer_scene *scene, unsigned a, unsigned b) {
    for (unsigned j = 0; j < scene->joint_count; j++) {
        const unsigned *p = scene->joints[j].bodies;
        if ((p[0] == a && p[1] == b) || (p[0] == b && p[1] == a)) {
            return 1;
        }
    }
    return 0;
}

static void add_pair(maker *m, unsigned a, unsigned b, double friction) {
    mjsPair *pair = mjs_addPair(m->spec, NULL);
    name_of("g%u", a, pair->geomname1);
    name_of("g%u", b, pair->geomname2);
    pair->condim = friction > 0.0 ? 3 : 1;
    pair->friction[0] = pair->friction[1] = friction;
}

/* Every pair of shapes with its own friction. */
static void add_pairs(maker *m) {
    const peer_scene *scene = m->scene;
    unsigned count = 0;
    for (unsigned a = 0; a < scene->body_count; a++) {
        for (unsigned b = a + 1; b < scene->body_count; b++) {
            const peer_body *p = &scene->bodies[a], *q = &scene->bodies[b];
            int both = p->collides && q->collides && (p->kind == PEER_DYNAMIC || q->kind == PEER_DYNAMIC);
            if (!both || are_joined(scene, a, b)) {
                continue;
            }
            for (unsigned i = 0; i < p->shape_count * q->shape_count; i++) {
                if (++count > MOST_PAIRS) {
                    m->problem = "MuJoCo takes the greater friction of two, and there are too many pairs to name each";
                    return;
                }
                add_pair(m, p->first_shape + i % p->shape_count, q->first_shape + i / p->shape_count,
                         sqrt(p->friction * q->friction));
            }
        }
    }
}

static void add_hulls(maker *m) {
    for (unsigned h = 0; h < m->scene->hull_count; h++) {
        const peer_hull *hull = &m->scene->hulls[h];
        mjsMesh *mesh = mjs_addMesh(m->spec, NULL);
        char name[24];
        snprintf(name, sizeof name, "h%u", h);
        mjs_setName(mesh->element, name);
        float *points = calloc(3 * hull->point_count, sizeof *points);
        for (unsigned k = 0; k < 3 * hull->point_count; k++) {
            points[k] = (float)hull->points[k];
        }
        mjs_setFloat(mesh->uservert, points, (int)(3 * hull->point_count));
        free(points);
    }
}

static void set_options(mjSpec *spec, const peer_scene *scene, const peer_setting *setting) {
    static const int integrators[] = {mjINT_IMPLICITFAST, mjINT_RK4, mjINT_EULER};
    static const int solvers[] = {mjSOL_NEWTON, mjSOL_PGS, mjSOL_CG};
    mjOption *o = &spec->option;
    o->timestep = setting->dt;
    memcpy(o->gravity, scene->gravity, sizeof o->gravity);
    o->cone = mjCONE_ELLIPTIC;
    o->integrator = integrators[setting->integrator];
    o->solver = solvers[setting->solver];
    if (setting->iterations > 0) {
        o->iterations = (int)setting->iterations;
    }
    /* A number that is not finite is to be seen, not to begin anew. */
    o->disableflags |= mjDSBL_AUTORESET;
    if (scene->sleeps) {
        o->enableflags |= mjENBL_SLEEP;
    }
    spec->memory = ((mjtSize)64 << 20) + (mjtSize)scene->body_count * (100 << 10);
}

static const char *refuses(const peer_scene *scene) {
    for (unsigned k = 0; k < scene->body_count; k++) {
        if (scene->bodies[k].kind == PEER_KINEMATIC) {
            return "MuJoCo has no bodies that move with a given velocity (those that are placed have none)";
        }
        if (scene->bodies[k].collides && scene->bodies[k].restitution > 0.0) {
            return "MuJoCo has no coefficient of restitution";
        }
    }
    return NULL;
}

/* Velocities in the coordinates of the tree. */
static void set_velocities(const maker *m, mujoco_world *w) {
    const peer_scene *scene = m->scene;
    for (unsigned k = 0; k < scene->body_count; k++) {
        const peer_body *b = &scene->bodies[k];
        int joint = w->model->body_jntadr[w->ids[k]];
        if (b->kind != PEER_DYNAMIC || joint < 0) {
            continue;
        }
        mjtNum *v = w->data->qvel + w->model->jnt_dofadr[joint];
        if (m->by[k] < 0) {
            mju_copy3(v, b->velocity);
            turn_back(b->rotation, b->spin, v + 3);
            continue;
        }
        const peer_joint *j = &scene->joints[m->by[k]];
        int side = j->bodies[1] == k;
        double relative[3], axis[3], p[3], speeds[2][3];
        mju_sub3(relative, b->spin, scene->bodies[m->parent[k]].spin);
        axis_of(scene, j, side, axis);
        if (j->kind == PEER_BALL) {
            turn_back(b->rotation, relative, v);
        } else if (j->kind == PEER_HINGE) {
            v[0] = mju_dot3(axis, relative);
        } else {
            /* What turning with the parent adds is across the axis. */
            end_of(scene, j, side, p, speeds[0]);
            end_of(scene, j, !side, p, speeds[1]);
            mju_sub3(relative, speeds[0], speeds[1]);
            v[0] = mju_dot3(axis, relative);
        }
    }
}

static void build(maker *m, mujoco_world *w, const peer_setting *setting) {
    const peer_scene *scene = m->scene;
    int pairs = !alike(scene);
    set_options(m->spec, scene, setting);
    add_hulls(m);
    plan_tree(m);
    for (unsigned k = 0; k < scene->body_count; k++) {
        add_body(m, k, pairs);
    }
    w->is_free = 1;
    for (unsigned j = 0; j < scene->joint_count; j++) {
        if (m->used[j]) {
            w->is_free = 0;
        } else {
            close_loop(m, j);
        }
        if (!pairs) {
            mjsExclude *e = mjs_addExclude(m->spec);
            name_of("b%u", scene->joints[j].bodies[0], e->bodyname1);
            name_of("b%u", scene->joints[j].bodies[1], e->bodyname2);
        }
    }
    if (pairs) {
        add_pairs(m);
    }
    if (m->problem) {
        return;
    }
    w->model = mj_compile(m->spec, NULL);
    w->data = w->model ? mj_makeData(w->model) : NULL;
    if (!w->data) {
        m->problem = mjs_getError(m->spec);
        return;
    }
    for (unsigned k = 0; k < scene->body_count; k++) {
        char name[24];
        snprintf(name, sizeof name, "b%u", k);
        w->ids[k] = mj_name2id(w->model, mjOBJ_BODY, name);
    }
    set_velocities(m, w);
}

/* Builds, unless MuJoCo calls for the end. */
static void attempt(maker *m, mujoco_world *w, const peer_setting *setting) {
    jmp_buf here;
    escape = &here;
    if (setjmp(here) == 0) {
        m->spec = mj_makeSpec();
        build(m, w, setting);
    } else {
        m->problem = last_error;
    }
    escape = NULL;
}

void *mujoco_create(const peer_scene *scene, const peer_setting *setting, char *why, unsigned why_size) {
    mju_user_error = on_error;
    mju_user_warning = on_warning;
    unsigned n = scene->body_count;
    mujoco_world *w = calloc(1, sizeof *w);
    w->count = n;
    w->sub_steps = setting->sub_steps;
    w->ids = calloc(n, sizeof *w->ids);
    w->bodies = calloc(n, sizeof *w->bodies);
    memcpy(w->bodies, scene->bodies, n * sizeof *w->bodies);
    maker m = {.scene = scene, .problem = refuses(scene)};
    m.made = calloc(n, sizeof *m.made);
    m.by = calloc(n, sizeof *m.by);
    m.parent = calloc(n, sizeof *m.parent);
    m.used = calloc(scene->joint_count + 1, sizeof *m.used);
    if (!m.problem) {
        attempt(&m, w, setting);
    }
    int failed = m.problem != NULL;
    if (failed) {
        snprintf(why, why_size, "%s", m.problem);
    }
    if (m.spec) {
        mj_deleteSpec(m.spec);
    }
    free(m.made), free(m.by), free(m.parent), free(m.used);
    if (failed) {
        mujoco_destroy(w);
        return NULL;
    }
    return w;
}

void mujoco_step(void *world) {
    mujoco_world *w = world;
    jmp_buf here;
    if (w->failed) {
        return;
    }
    escape = &here;
    if (setjmp(here) == 0) {
        for (unsigned s = 0; s < w->sub_steps; s++) {
            mj_step(w->model, w->data);
        }
    } else {
        w->failed = 1;
    }
    escape = NULL;
    mju_zero(w->data->xfrc_applied, 6 * w->model->nbody);
}

void mujoco_push(void *world, unsigned body, const double force[3], const double torque[3]) {
    mujoco_world *w = world;
    mjtNum *f = w->data->xfrc_applied + 6 * w->ids[body];
    mju_addTo3(f, force);
    mju_addTo3(f + 3, torque);
}

/* From the state itself: what mj_step leaves behind is of the start of the step. */
void mujoco_motions(const void *world, peer_motion *out) {
    const mujoco_world *w = world;
    const mjModel *m = w->model;
    mjData *d = w->data;
    if (!w->is_free) {
        mj_kinematics(m, d);
        mj_comPos(m, d);
        mj_comVel(m, d);
    }
    for (unsigned k = 0; k < w->count; k++) {
        peer_motion *o = &out[k];
        const peer_body *b = &w->bodies[k];
        int id = w->ids[k], joint = m->body_jntadr[id];
        if (b->kind != PEER_DYNAMIC) {
            mju_copy3(o->position, b->position);
            mju_copy4(o->rotation, b->rotation);
            mju_zero3(o->velocity);
            mju_zero3(o->spin);
        } else if (joint >= 0 && m->jnt_type[joint] == mjJNT_FREE) {
            const mjtNum *q = d->qpos + m->jnt_qposadr[joint], *v = d->qvel + m->jnt_dofadr[joint];
            mju_copy3(o->position, q);
            from_quat(q + 3, o->rotation);
            mju_copy3(o->velocity, v);
            /* The spin of a free joint is about the body's axes. */
            turn(o->rotation, v + 3, o->spin);
        } else {
            mjtNum v[6];
            mju_copy3(o->position, d->xpos + 3 * id);
            from_quat(d->xquat + 4 * id, o->rotation);
            mj_objectVelocity(m, d, mjOBJ_BODY, id, v, 0);
            mju_copy3(o->spin, v);
            mju_copy3(o->velocity, v + 3);
        }
    }
}

/* Contacts or constraints that had no room were dropped. */
int mujoco_is_broken(const void *world) {
    const mujoco_world *w = world;
    return w->failed || w->data->warning[mjWARN_CONTACTFULL].number > 0 ||
           w->data->warning[mjWARN_CNSTRFULL].number > 0;
}

void mujoco_destroy(void *world) {
    mujoco_world *w = world;
    if (w->data) {
        mj_deleteData(w->data);
    }
    if (w->model) {
        mj_deleteModel(w->model);
    }
    free(w->ids);
    free(w->bodies);
    free(w);
}

const char *mujoco_version(void) {
    return mj_versionString();
}
