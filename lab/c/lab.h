/* What the lab's C programs hand to the lab. Mirrored in src/programs.rs. */
#ifndef LAB_H
#define LAB_H

#include "merev.h"

/* The world after a step. */
typedef struct LabFrame
{
    /* Since the start [s]. */
    double time;
    /* What the step took [s]. */
    double elapsed;
    /* The greatest approach speed of a hit in this step, 0 for none [m/s]. */
    double hitSpeed;
    /* Whether the report of the world was asked for; else the fields below up to penetration are 0. */
    int measured;
    /* Kinetic and potential energy [J]. */
    double energy;
    /* [kg m/s] */
    double momentum[3];
    /* The deepest overlap [m]. */
    double penetration;
    /* Position x, y, z [m] and rotation x, y, z, w of each moving body, in order of creation. */
    const float* poses;
    int bodyCount;
} LabFrame;

/* The lab, as the programs see it. */
typedef struct LabHost
{
    void* context;
    /* A clock [s]. */
    double (*now)(void* context);
    /* Takes what a step made. */
    void (*frame)(void* context, const LabFrame* frame);
} LabHost;

/* A step of the world, timed, with its transforms and, if wanted, its report given to the lab. */
void labStep(const LabHost* host, mvWorldId world, double timeStep, int step, bool measure, const mvBodyId* bodies,
             float* poses, int bodyCount);

/* The programs. Each returns mvGetLastError(): 0 when no call failed. */
int labBouncingBall(const LabHost* host, int steps);
int labPyramid(const LabHost* host, int rows, int steps, int measureEvery, int strikeAfter);

#endif
