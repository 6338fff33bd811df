// Capital letters of five by seven texels, for what is written in pictures.
#pragma once

#include <array>
#include <string_view>

namespace slicecast::textures {

inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 7;

using GlyphRows = std::array<std::string_view, kGlyphHeight>;  // '#' where the letter is

// Blank for characters that are not used.
const GlyphRows& glyphOf(char letter);

}  // namespace slicecast::textures
