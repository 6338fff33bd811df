// A world with a player, stepped as a session does it.
#pragma once

#include "moving.h"

#include "world/crowd.h"
#include "world/object_motion.h"
#include "world/quest.h"
#include "world/world_step.h"

#include <utility>
#include <vector>

namespace slicecast {

struct Stage {
    World world;
    Player player;
    std::vector<QuestNews> news;  // of all steps

    // The world's map must be complete.
    explicit Stage(World made, double x = 1.5, double y = 1.5) : world(std::move(made)) {
        startObjects(world);
        startQuest(world);
        putPlayer(x, y);
    }

    void putPlayer(double x, double y, int map = 0) {
        player = {};
        player.map = map;
        player.x = toCoordinate(x);
        player.y = toCoordinate(y);
        player.onGround = true;
    }

    void step(const PlayerInput& input = {}, GateAsk::Wish wish = GateAsk::Wish::nothing) {
        const GateAsk ask = asks(player, wish);
        std::vector<Body> bodies = {bodyOf(travellerOf(player), player.onGround)};
        addBodies(world, bodies);
        stepWorld(world, bodies, ask);
        shift(player, bodies[0]);
        liftObjects(world, std::span(bodies).subspan(1));
        const Body body = bodyOf(travellerOf(player), player.onGround);
        stepObjects(world, &body);
        pushApart(world, player);
        stepPlayer(world, player, input);
        stepQuest(world, player, ask, input.forward != 0.0);
        news.insert(news.end(), world.quest.news.begin(), world.quest.news.end());
    }
    void stepFor(double seconds, const PlayerInput& input = {}) {
        for (int i = 0; i < static_cast<int>(seconds * kStepsPerSecond + 0.5); ++i) step(input);
    }

    const Object& object(std::size_t motion = 0) const {
        const ObjectMotion& moving = world.movingObjects.motions[motion];
        return world.maps[static_cast<std::size_t>(moving.map)]
            .objects[static_cast<std::size_t>(moving.object)];
    }
    double x(std::size_t motion = 0) const { return object(motion).x.value(); }
    double y(std::size_t motion = 0) const { return object(motion).y.value(); }
};

// Adds an object, 0.3 wide and 0.6 high, to the motion's map.
inline void addActor(World& world, double x, double y, ObjectMotion motion) {
    std::vector<Object>& objects = world.maps[static_cast<std::size_t>(motion.map)].objects;
    motion.object = static_cast<int>(objects.size());
    Object object;
    object.x = toCoordinate(x);
    object.y = toCoordinate(y);
    object.width = 0.3_u;
    object.height = 0.6_u;
    objects.push_back(object);
    world.movingObjects.motions.push_back(motion);
}

inline ObjectMotion standing(ObjectMotion::Reaction reaction = ObjectMotion::Reaction::none,
                             double near = 4.0) {
    ObjectMotion motion;
    motion.kind = ObjectMotion::Kind::stand;
    motion.speed = 1.0;
    motion.reaction = reaction;
    motion.near = toCoordinate(near);
    motion.keep = 0.9_u;
    motion.alertSpeed = 2.0;
    motion.calmSteps = 2 * kStepsPerSecond;
    motion.solid = true;
    return motion;
}

// Adds its path to the world.
inline ObjectMotion patrolling(World& world, std::vector<PathPoint> path, double speed = 1.0) {
    ObjectMotion motion;
    motion.kind = ObjectMotion::Kind::patrol;
    motion.speed = speed;
    motion.solid = true;
    motion.path = static_cast<int>(world.movingObjects.paths.size());
    world.movingObjects.paths.push_back(std::move(path));
    return motion;
}

inline PathPoint point(double x, double y, int map = 0) {
    return {.map = map,
            .place = {toCoordinate(x), toCoordinate(y)},
            .feet = std::nullopt,
            .waitSteps = 0};
}

}  // namespace slicecast
