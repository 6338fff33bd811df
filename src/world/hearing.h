// The ears of a player: finds what one hears from the world and the player's steps alone, so that
// the same walk sounds the same everywhere. It changes nothing.
//
//     Hearing ears;
//     ears.step(world, before, now);                 after each step
//     for (const Sound& sound : ears.take(world, now)) ...
//
// Distances are in units. What is further away than kEarshot, or in another map, is not heard.
#pragma once

#include "slicecast/sound.h"
#include "world/player.h"

#include <array>
#include <span>

namespace slicecast {

inline constexpr double kEarshot = 12.0;
// Water is heard only from close by: a lake behind three houses would never be silent.
inline constexpr double kWaterEarshot = 6.0;
// The height above the floor from which on the wind has its full strength.
inline constexpr double kWindyHeight = 8.0;

// A walker sets down a foot after so many units: kStride, and more at speed.
inline constexpr double kStride = 0.6;
inline constexpr double kStrideBySpeed = 0.15;  // times the speed in units per second
inline constexpr double kStroke = 1.2;          // of swimming

class Hearing {
public:
    // Hears the step of the world and the player that has just been made; takes no memory.
    void step(const World& world, const Player& before, const Player& now);

    // The sounds since the last call, and then those that last, one of each kind: as loud as the
    // nearest, whose material it has, and from the middle of all. Valid until the next step.
    std::span<const Sound> take(const World& world, const Player& now);

    // A listener who never takes sounds does not collect more of those that are heard once.
    static constexpr int kMostAtOnce = 32;
    static constexpr int kMost = kMostAtOnce + 5;  // with those that last

private:
    void add(const Sound& sound);
    void hearQuest(const World& world);
    void hearFeet(const World& world, const Player& before, const Player& now);

    std::array<Sound, kMost> heard_;
    int count_ = 0;
    bool isTaken_ = false;
    double stride_ = 0.0;  // part of the present one, 0 to 1
};

}  // namespace slicecast
