// What a player hears: plain data for whoever makes the sound.
#pragma once

#include <cstdint>

namespace slicecast {

// What a block or a floor is made of, as far as one hears it.
enum class Material : std::uint8_t {
    stone,
    wood,
    earth,
    grass,
    sand,
    metal,
    glass,
    cloth,
    water,
};
inline constexpr int kMaterials = 9;

enum class SoundKind : std::uint8_t {
    // Heard once
    step,      // a foot is set down; in water it wades
    land,      // after a fall or a jump
    jump,      // the player leaves the ground
    splash,    // the player falls into deep water
    stroke,    // a stroke of swimming
    knock,     // a gate is all open, or shut
    crossing,  // the player goes through a portal
    find,      // the player takes a find
    goal,      // the game's goal is reached

    // Heard while they last, each as loud as the nearest of its kind
    gate,      // gates that open or close
    mover,     // blocks that move
    water,     // the nearest water
    wind,      // the open sky
    submerged  // the ears are under water: everything else is muffled
};
// Kinds from this one on last.
inline constexpr SoundKind kFirstLasting = SoundKind::gate;

struct Sound {
    SoundKind kind = SoundKind::step;
    Material material = Material::stone;
    double gain = 0.0;  // loudness where the player is, 0 to 1
    double pan = 0.0;   // -1 is left, 1 right, as the player looks

    friend bool operator==(const Sound&, const Sound&) = default;
};

}  // namespace slicecast
