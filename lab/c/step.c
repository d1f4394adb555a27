/* A step of the world, and what the lab wants to know of it. */
#include "lab.h"

void labStep(const LabHost* host, mvWorldId world, double timeStep, int step, bool measure, const mvBodyId* bodies,
             float* poses, int bodyCount)
{
    LabFrame frame = { 0 };
    mvContactEvents contacts;
    double start;
    int i;

    start = host->now(host->context);
    mvWorld_Step(world, (mvFloat)timeStep, 4);
    frame.elapsed = host->now(host->context) - start;
    frame.time = timeStep * step;

    contacts = mvWorld_GetContactEvents(world);
    for (i = 0; i < contacts.hitCount; ++i)
    {
        frame.hitSpeed = fmax(frame.hitSpeed, (double)contacts.hitEvents[i].approachSpeed);
    }
    if (measure)
    {
        mvStepReport report = mvWorld_GetStepReport(world);
        frame.measured = 1;
        frame.energy = report.kineticEnergy + report.potentialEnergy;
        frame.penetration = (double)report.worstPenetration;
        for (i = 0; i < 3; ++i)
        {
            frame.momentum[i] = report.linearMomentum[i];
        }
    }
    for (i = 0; i < bodyCount; ++i)
    {
        mvWorldTransform there = mvBody_GetTransform(bodies[i]);
        float* pose = poses + 7 * i;
        pose[0] = (float)there.p.x;
        pose[1] = (float)there.p.y;
        pose[2] = (float)there.p.z;
        pose[3] = (float)there.q.v.x;
        pose[4] = (float)there.q.v.y;
        pose[5] = (float)there.q.v.z;
        pose[6] = (float)there.q.s;
    }
    frame.poses = poses;
    frame.bodyCount = bodyCount;
    host->frame(host->context, &frame);
}
