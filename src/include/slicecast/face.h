// The six sides of a block.
#pragma once

#include <array>
#include <cstdint>

namespace slicecast {

// North is towards smaller y, west towards smaller x, top upwards.
enum class Face : std::uint8_t { north, east, south, west, top, bottom };
inline constexpr int kFaces = 6;
inline constexpr std::array<const char*, kFaces> kFaceNames = {"north", "east", "south",
                                                               "west",  "top",  "bottom"};

}  // namespace slicecast
