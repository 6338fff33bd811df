// Draws text in a built-in font of printable ASCII. Letters are up to five columns wide, digits all
// five, so that numbers line up; capitals are seven rows high, with two rows below the line for g j
// p q y. Any other character shows as a box.
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
inline constexpr int kTabWidth = 84;  // dots; '\t' continues at the next multiple of it

struct TextStyle {
    Colour colour = {240, 240, 232, 255};
    int scale = 1;  // pixels per dot of the font, >= 1
};

// The width of the longest line, from the left edge of its first character to the right edge of its
// last; and the height from the top of the first line to the bottom of the last. Lines end in '\n'.
int textWidth(std::string_view text, int scale = 1);
int textHeight(std::string_view text, int scale = 1);

// Draws text with the upper left corner of its first character at (x, y).
void drawText(const Picture& picture, int x, int y, std::string_view text,
              const TextStyle& style = {});

// The place of a panel in the picture.
enum class Anchor { topLeft, top, topRight, middle, bottomLeft, bottom, bottomRight };

// Draws lines of text on a panel, at a readable scale, or a smaller one if they do not fit.
void drawTextPanel(const Picture& picture, Anchor anchor, std::string_view text);

}  // namespace slicecast
