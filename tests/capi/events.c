/* Events and contacts: a ball falls onto a floor, bounces, rests, and is taken away. */
#include "check.h"

int main(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvSphere ball = { { 0, 0, 0 }, (mvFloat)0.5 };
    mvPlane floor = { { 0, 1, 0 }, 0 };
    mvWorldId world = mvCreateWorld(&def);
    mvBodyId ground = mvCreateBody(world, &bodyDef), body;
    mvShapeId floorShape, ballShape;
    mvContactEvents contacts;
    mvBodyEvents moves;
    mvContactData data[2];
    mvContactId contact = mv_nullContactId;
    const mvContactBeginTouchEvent* kept;
    int step, begins = 0, hits = 0, fell = 0, moved = 0, tag = 7;

    shapeDef.baseMaterial.userMaterialId = 11;
    floorShape = mvCreatePlaneShape(ground, &shapeDef, &floor);
    bodyDef.type = mv_dynamicBody;
    bodyDef.position.y = 3;
    bodyDef.userData = &tag;
    body = mvCreateBody(world, &bodyDef);
    shapeDef.enableHitEvents = true;
    shapeDef.baseMaterial.userMaterialId = 22;
    ballShape = mvCreateSphereShape(body, &shapeDef, &ball);

    CHECK(mvWorld_GetBodyEvents(world).moveCount == 0 && mvWorld_GetContactEvents(world).beginCount == 0);
    for (step = 0; step < 300 && fell == 0; ++step)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
        contacts = mvWorld_GetContactEvents(world);
        begins += contacts.beginCount;
        hits += contacts.hitCount;
        if (contacts.beginCount == 1)
        {
            kept = contacts.beginEvents;
            contact = kept->contactId;
            CHECK(MV_ID_EQUALS(kept->shapeIdA, floorShape) && MV_ID_EQUALS(kept->shapeIdB, ballShape));
            CHECK(mvContact_IsValid(contact));
            CHECK(mvBody_GetContactCapacity(body) >= 1 && mvBody_GetContactData(body, data, 2) == 1);
            CHECK(MV_ID_EQUALS(data[0].contactId, contact) && data[0].manifoldCount == 1);
            CHECK(data[0].manifolds[0].pointCount == 1 && near(data[0].manifolds[0].normal.y, 1, (mvFloat)1e-4));
            CHECK(mvShape_GetContactCapacity(floorShape) == 1 && mvShape_GetContactData(floorShape, data + 1, 1) == 1);
            CHECK(data[0].manifolds == data[1].manifolds);
            CHECK(mvBody_GetContactData(body, data, 0) == 0);
        }
        if (contacts.hitCount == 1)
        {
            const mvContactHitEvent* hit = contacts.hitEvents;
            CHECK(hit->approachSpeed > 6 && hit->approachSpeed < 8 && near(hit->point.y, 0, (mvFloat)0.2));
            CHECK(hit->userMaterialIdA == 11 && hit->userMaterialIdB == 22);
        }
        moves = mvWorld_GetBodyEvents(world);
        CHECK(moves.moveCount == 1);
        if (moves.moveCount == 1)
        {
            mvBodyMoveEvent event = moves.moveEvents[0];
            moved += 1;
            fell += event.fellAsleep ? 1 : 0;
            CHECK(MV_ID_EQUALS(event.bodyId, body) && event.userData == &tag);
            CHECK(event.transform.p.y == mvBody_GetPosition(body).y);
        }
    }
    CHECK(begins == 1 && hits == 1 && fell == 1 && moved > 60 && !mvBody_IsAwake(body));
    CHECK(mvWorld_GetAwakeBodyCount(world) == 0);

    /* Destroying makes an end event in the next step; arrays of this step stay until then. */
    moves = mvWorld_GetBodyEvents(world);
    mvDestroyBody(body);
    CHECK(moves.moveEvents[0].userData == &tag && !mvBody_IsValid(moves.moveEvents[0].bodyId));
    CHECK(!mvContact_IsValid(contact));
    mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
    contacts = mvWorld_GetContactEvents(world);
    CHECK(contacts.endCount == 1 && MV_ID_EQUALS(contacts.endEvents[0].contactId, contact));
    CHECK(MV_ID_EQUALS(contacts.endEvents[0].shapeIdB, ballShape) && !mvShape_IsValid(ballShape));
    mvDestroyWorld(world);
    FAILS(mv_errorStale, mvWorld_GetBodyEvents, CHECK(mvWorld_GetBodyEvents(world).moveEvents == NULL));
    FAILS(mv_errorStale, mvWorld_GetContactEvents, CHECK(mvWorld_GetContactEvents(world).hitCount == 0));
    CHECK(!mvContact_IsValid(contact) && !mvContact_IsValid(mv_nullContactId));
    return done("events");
}
