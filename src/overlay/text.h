// Text over a picture, in a built-in font of printable ASCII: letters as wide as they need, at most
// five columns, digits all equally wide, so that numbers stand in columns; capitals seven rows
// high, two rows below the line for g j p q y. Any other character shows as a box.
#pragma once

#include "overlay/blend.h"
#include "slicecast/colour.h"
#include "slicecast/picture.h"

#include <string_view>

namespace slicecast {

inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 9;
inline constexpr int kGlyphAdvance = kGlyphWidth + 1;  // from one digit to the next
inline constexpr int kLineAdvance = kGlyphHeight + 2;  // from one line to the next
inline constexpr int kTabWidth = 84;                   // dots; '\t' goes on at a multiple of it

struct TextStyle {
    Colour colour = {240, 240, 232, 255};
    int scale = 1;  // pixels that a dot of the font is wide and high, >= 1
};

// Pixels from the left edge of the first character to the right edge of the last one of the longest
// line; and from the top of the first line to the bottom of the last. Lines end in '\n'.
int textWidth(std::string_view text, int scale = 1);
int textHeight(std::string_view text, int scale = 1);

// Draws text with the upper left corner of its first character at (x, y).
void drawText(const Picture& picture, int x, int y, std::string_view text,
              const TextStyle& style = {});

// The corner, edge or middle of the picture at which a panel stands.
enum class Anchor { topLeft, top, topRight, middle, bottomLeft, bottom, bottomRight };

// Draws lines of text on a panel, at a readable scale, a smaller one if they do not fit.
void drawTextPanel(const Picture& picture, Anchor anchor, std::string_view text);

}  // namespace slicecast
