#include "overlay/text.h"

#include "overlay/blend.h"
#include "overlay/layout.h"

#include <algorithm>
#include <array>

namespace slicecast {
namespace {

constexpr int kGlyphsPerLine = 16;
constexpr char kFirstGlyph = ' ';
constexpr char kLastGlyph = '~';

// The glyphs from the space on, sixteen to a line, each five columns wide. The last two rows hold
// what hangs below the line. The very last one stands for every other character.
constexpr std::array<std::array<const char*, kGlyphHeight>, 6> kGlyphs = {{
    {{
        "..... ..#.. .#.#. .#.#. ..#.. ##... .##.. ..#.. ...#. .#... ..... ..... ..... ..... ..... "
        "....#",
        "..... ..#.. .#.#. .#.#. .#### ##..# #..#. ..#.. ..#.. ..#.. ..#.. ..#.. ..... ..... ..... "
        "....#",
        "..... ..#.. .#.#. ##### #.#.. ...#. #.#.. ..... .#... ...#. #.#.# ..#.. ..... ..... ..... "
        "...#.",
        "..... ..#.. ..... .#.#. .###. ..#.. .#... ..... .#... ...#. .###. ##### ..... ##### ..... "
        "..#..",
        "..... ..#.. ..... ##### ..#.# .#... #.#.# ..... .#... ...#. #.#.# ..#.. ..... ..... ..... "
        ".#...",
        "..... ..... ..... .#.#. ####. #..## #..#. ..... ..#.. ..#.. ..#.. ..#.. ..##. ..... .##.. "
        "#....",
        "..... ..#.. ..... .#.#. ..#.. ...## .##.# ..... ...#. .#... ..... ..... ..##. ..... .##.. "
        "#....",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ...#. ..... ..... "
        ".....",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..#.. ..... ..... "
        ".....",
    }},
    {{
        ".###. ..#.. .###. .###. ...#. ##### ..##. ##### .###. .###. ..... ..... ....# ..... #.... "
        ".###.",
        "#...# .##.. #...# #...# ..##. #.... .#... ....# #...# #...# .##.. ..##. ...#. ..... .#... "
        "#...#",
        "#..## ..#.. ....# ....# .#.#. ####. #.... ...#. #...# #...# .##.. ..##. ..#.. ##### ..#.. "
        "....#",
        "#.#.# ..#.. ...#. ..##. #..#. ....# ####. ..#.. .###. .#### ..... ..... .#... ..... ...#. "
        "...#.",
        "##..# ..#.. ..#.. ....# ##### ....# #...# ..#.. #...# ....# ..... ..... ..#.. ##### ..#.. "
        "..#..",
        "#...# ..#.. .#... #...# ...#. #...# #...# ..#.. #...# ...#. .##.. ..##. ...#. ..... .#... "
        ".....",
        ".###. .###. ##### .###. ...#. .###. .###. ..#.. .###. .##.. .##.. ..##. ....# ..... #.... "
        "..#..",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ...#. ..... ..... ..... "
        ".....",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..#.. ..... ..... ..... "
        ".....",
    }},
    {{
        ".###. .###. ####. .###. ####. ##### ##### .###. #...# .###. ..### #...# #.... #...# #...# "
        ".###.",
        "#...# #...# #...# #...# #...# #.... #.... #...# #...# ..#.. ...#. #..#. #.... ##.## ##..# "
        "#...#",
        "#.### #...# #...# #.... #...# #.... #.... #.... #...# ..#.. ...#. #.#.. #.... #.#.# #.#.# "
        "#...#",
        "#.#.# ##### ####. #.... #...# ####. ####. #.### ##### ..#.. ...#. ##... #.... #.#.# #..## "
        "#...#",
        "#.### #...# #...# #.... #...# #.... #.... #...# #...# ..#.. ...#. #.#.. #.... #...# #...# "
        "#...#",
        "#.... #...# #...# #...# #...# #.... #.... #...# #...# ..#.. #..#. #..#. #.... #...# #...# "
        "#...#",
        ".#### #...# ####. .###. ####. ##### #.... .#### #...# .###. .##.. #...# ##### #...# #...# "
        ".###.",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... "
        ".....",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... "
        ".....",
    }},
    {{
        "####. .###. ####. .#### ##### #...# #...# #...# #...# #...# ##### .###. #.... .###. ..#.. "
        ".....",
        "#...# #...# #...# #.... ..#.. #...# #...# #...# #...# #...# ....# .#... #.... ...#. .#.#. "
        ".....",
        "#...# #...# #...# #.... ..#.. #...# #...# #...# .#.#. .#.#. ...#. .#... .#... ...#. #...# "
        ".....",
        "####. #...# ####. .###. ..#.. #...# #...# #.#.# ..#.. ..#.. ..#.. .#... ..#.. ...#. ..... "
        ".....",
        "#.... #.#.# #.#.. ....# ..#.. #...# .#.#. #.#.# .#.#. ..#.. .#... .#... ...#. ...#. ..... "
        ".....",
        "#.... #..#. #..#. ....# ..#.. #...# .#.#. ##.## #...# ..#.. #.... .#... ....# ...#. ..... "
        ".....",
        "#.... .##.# #...# ####. ..#.. .###. ..#.. #...# #...# ..#.. ##### .###. ....# .###. ..... "
        ".....",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... "
        "#####",
        "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... "
        ".....",
    }},
    {{
        ".#... ..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #.... .##.. ..... ..... "
        ".....",
        "..#.. ..... #.... ..... ....# ..... .#..# ..... #.... ..... ..... #.... ..#.. ..... ..... "
        ".....",
        "..... .###. ####. .###. .#### .###. .#... .#### ####. .##.. ..##. #..#. ..#.. ##.#. ####. "
        ".###.",
        "..... ....# #...# #.... #...# #...# ###.. #...# #...# ..#.. ...#. #.#.. ..#.. #.#.# #...# "
        "#...#",
        "..... .#### #...# #.... #...# ##### .#... #...# #...# ..#.. ...#. ##... ..#.. #.#.# #...# "
        "#...#",
        "..... #...# #...# #...# #...# #.... .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.# #...# "
        "#...#",
        "..... .#### ####. .###. .#### .###. .#... .#### #...# .###. ...#. #..#. .###. #...# #...# "
        ".###.",
        "..... ..... ..... ..... ..... ..... ..... ....# ..... ..... #..#. ..... ..... ..... ..... "
        ".....",
        "..... ..... ..... ..... ..... ..... ..... .###. ..... ..... .##.. ..... ..... ..... ..... "
        ".....",
    }},
    {{
        "..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ...#. ..#.. .#... ..... "
        "#####",
        "..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..#.. ..#.. ..#.. ..... "
        "#...#",
        "####. .#### #.##. .#### ###.. #...# #...# #...# #...# #...# ##### ..#.. ..#.. ..#.. .#..# "
        "#...#",
        "#...# #...# ##..# #.... .#... #...# #...# #...# .#.#. #...# ...#. .#... ..#.. ...#. #.#.# "
        "#...#",
        "#...# #...# #.... .###. .#... #...# #...# #.#.# ..#.. #...# ..#.. ..#.. ..#.. ..#.. #..#. "
        "#...#",
        "#...# #...# #.... ....# .#..# #...# .#.#. #.#.# .#.#. #...# .#... ..#.. ..#.. ..#.. ..... "
        "#...#",
        "####. .#### #.... ####. ..##. .#### ..#.. .#.#. #...# .#### ##### ...#. ..#.. .#... ..... "
        "#####",
        "#.... ....# ..... ..... ..... ..... ..... ..... ..... ....# ..... ..... ..#.. ..... ..... "
        ".....",
        "#.... ....# ..... ..... ..... ..... ..... ..... ..... .###. ..... ..... ..#.. ..... ..... "
        ".....",
    }},
}};

// The bytes after the first of a character in UTF-8 are part of it.
constexpr bool continuesCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u;
}

constexpr int glyphOf(char c) {
    return (c < kFirstGlyph || c > kLastGlyph ? kLastGlyph + 1 : c) - kFirstGlyph;
}

void drawGlyph(const Picture& picture, int x, int y, int glyph, const TextStyle& style) {
    const auto& lines = kGlyphs[static_cast<std::size_t>(glyph / kGlyphsPerLine)];
    const int firstColumn = glyph % kGlyphsPerLine * kGlyphAdvance;
    for (int row = 0; row < kGlyphHeight; ++row) {
        const char* dots = lines[static_cast<std::size_t>(row)] + firstColumn;
        for (int column = 0; column < kGlyphWidth; ++column) {
            if (dots[column] != '#') continue;
            blendRect(picture,
                      {x + column * style.scale, y + row * style.scale, style.scale, style.scale},
                      style.colour);
        }
    }
}

struct TextSize {
    int columns = 0;  // characters of the longest line
    int lines = 1;
};

TextSize sizeOf(std::string_view text) {
    TextSize size;
    int columns = 0;
    for (const char c : text) {
        if (c == '\n') {
            ++size.lines;
            columns = 0;
        } else if (!continuesCharacter(c)) {
            size.columns = std::max(size.columns, ++columns);
        }
    }
    return size;
}

}  // namespace

int textWidth(std::string_view text, int scale) {
    const int columns = sizeOf(text).columns;
    return columns == 0 ? 0 : (columns * kGlyphAdvance - 1) * scale;
}

int textHeight(std::string_view text, int scale) {
    return (sizeOf(text).lines * kLineAdvance - (kLineAdvance - kGlyphHeight)) * scale;
}

void drawText(const Picture& picture, int x, int y, std::string_view text, const TextStyle& style) {
    int left = x;
    int top = y;
    for (const char c : text) {
        if (c == '\n') {
            left = x;
            top += kLineAdvance * style.scale;
        } else if (!continuesCharacter(c)) {
            drawGlyph(picture, left, top, glyphOf(c), style);
            left += kGlyphAdvance * style.scale;
        }
    }
}

void drawTextPanel(const Picture& picture, Anchor anchor, std::string_view text) {
    const int margin = overlayMargin(picture.width, picture.height);
    int scale = readableScale(picture.width, picture.height);
    const auto fits = [&] {
        const int around = 2 * (kPanelPadding * scale + margin);
        return textWidth(text, scale) + around <= picture.width &&
               textHeight(text, scale) + around <= picture.height;
    };
    while (scale > 1 && !fits()) --scale;

    // Where the panel stands
    PixelRect panel;
    panel.width = textWidth(text, scale) + 2 * kPanelPadding * scale;
    panel.height = textHeight(text, scale) + 2 * kPanelPadding * scale;
    const bool left = anchor == Anchor::topLeft || anchor == Anchor::bottomLeft;
    const bool right = anchor == Anchor::topRight || anchor == Anchor::bottomRight;
    const bool top =
        anchor == Anchor::topLeft || anchor == Anchor::top || anchor == Anchor::topRight;
    const int freeX = picture.width - panel.width;
    const int freeY = picture.height - panel.height;
    panel.x = left ? margin : right ? freeX - margin : freeX / 2;
    panel.y = top ? margin : anchor == Anchor::middle ? freeY / 2 : freeY - margin;

    drawPanel(picture, panel);
    drawText(picture, panel.x + kPanelPadding * scale, panel.y + kPanelPadding * scale, text,
             {.scale = scale});
}

}  // namespace slicecast
