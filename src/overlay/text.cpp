#include "overlay/text.h"

#include "overlay/blend.h"
#include "overlay/layout.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace slicecast {
namespace {

constexpr int kGlyphsPerLine = 16;
constexpr char kFirstGlyph = ' ';
constexpr char kLastGlyph = '~';

// The glyphs from the space on, sixteen to a line, each up to five columns wide. The last two rows
// are below the line. The very last glyph stands for all other characters.
constexpr std::array<std::array<const char*, kGlyphHeight>, 6> kArt = {{
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

// A glyph ready for drawing: trimmed to its columns with ink, except for digits, which keep their
// width.
struct Glyph {
    std::array<std::uint8_t, kGlyphHeight> rows{};  // bit n is column n
    std::uint8_t width = 0;                         // dots
};

constexpr int kGlyphs = 6 * kGlyphsPerLine;
constexpr int kSpaceWidth = 2;  // dots, before the one that follows every glyph

constexpr bool isDigit(int glyph) {
    return glyph >= '0' - kFirstGlyph && glyph <= '9' - kFirstGlyph;
}

constexpr std::array<Glyph, kGlyphs> kFont = [] {
    std::array<Glyph, kGlyphs> font{};
    for (int i = 0; i < kGlyphs; ++i) {
        Glyph& glyph = font[static_cast<std::size_t>(i)];
        unsigned ink = 0;
        for (int row = 0; row < kGlyphHeight; ++row) {
            unsigned bits = 0;
            const char* art =
                kArt[static_cast<std::size_t>(i / kGlyphsPerLine)][static_cast<std::size_t>(row)];
            for (int column = 0; column < kGlyphWidth; ++column) {
                if (art[i % kGlyphsPerLine * (kGlyphWidth + 1) + column] == '#')
                    bits |= 1u << column;
            }
            glyph.rows[static_cast<std::size_t>(row)] = static_cast<std::uint8_t>(bits);
            ink |= bits;
        }
        if (isDigit(i)) ink = (1u << kGlyphWidth) - 1u;
        while (ink != 0 && (ink & 1u) == 0) {
            for (std::uint8_t& bits : glyph.rows) bits = static_cast<std::uint8_t>(bits >> 1);
            ink >>= 1;
        }
        for (; ink != 0; ink >>= 1) ++glyph.width;
        if (i == 0) glyph.width = kSpaceWidth;
    }
    return font;
}();

// True for the second and later bytes of a UTF-8 character.
constexpr bool continuesCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u;
}

const Glyph& glyphOf(char c) {
    return kFont[static_cast<std::size_t>((c < kFirstGlyph || c > kLastGlyph ? kLastGlyph + 1 : c) -
                                          kFirstGlyph)];
}

// Draws neighbouring dots of a row as one rectangle.
void drawGlyph(const Picture& picture, int x, int y, const Glyph& glyph, const TextStyle& style) {
    const int scale = style.scale;
    for (int row = 0; row < kGlyphHeight; ++row) {
        unsigned bits = glyph.rows[static_cast<std::size_t>(row)];
        for (int column = 0; bits != 0; ++column, bits >>= 1) {
            if ((bits & 1u) == 0) continue;
            const int first = column;
            for (; (bits & 2u) != 0; bits >>= 1) ++column;
            blendRect(picture,
                      {x + first * scale, y + row * scale, (column + 1 - first) * scale, scale},
                      style.colour);
        }
    }
}

// Calls visit(glyph, x, line) for each character, x in dots from the start of the line. Returns the
// dots of the longest line and the number of lines.
struct TextSize {
    int width = 0;
    int lines = 1;
};
template <typename Visit>
TextSize layOut(std::string_view text, Visit visit) {
    TextSize size;
    int x = 0;
    for (const char c : text) {
        if (c == '\n') {
            ++size.lines;
            x = 0;
        } else if (c == '\t') {
            x += kTabWidth - x % kTabWidth;
        } else if (!continuesCharacter(c)) {
            const Glyph& glyph = glyphOf(c);
            visit(glyph, x, size.lines - 1);
            size.width = std::max(size.width, x + glyph.width);
            x += glyph.width + 1;
        }
    }
    return size;
}

TextSize sizeOf(std::string_view text) {
    return layOut(text, [](const Glyph&, int, int) {});
}

}  // namespace

int textWidth(std::string_view text, int scale) {
    return sizeOf(text).width * scale;
}

int textHeight(std::string_view text, int scale) {
    return (sizeOf(text).lines * kLineAdvance - (kLineAdvance - kGlyphHeight)) * scale;
}

void drawText(const Picture& picture, int x, int y, std::string_view text, const TextStyle& style) {
    layOut(text, [&](const Glyph& glyph, int right, int line) {
        drawGlyph(picture, x + right * style.scale, y + line * kLineAdvance * style.scale, glyph,
                  style);
    });
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

    // The panel's place
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

    drawPanel(picture, panel, scale);
    drawText(picture, panel.x + kPanelPadding * scale, panel.y + kPanelPadding * scale, text,
             {.scale = scale});
}

}  // namespace slicecast
