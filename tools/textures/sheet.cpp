#include "sheet.h"

#include <algorithm>

namespace slicecast::textures {

namespace {

constexpr int kMargin = 8;         // pixels, like all sizes of sheets
constexpr int kTiled = 3 * kSide;  // side of a square that is filled with copies of a texture

// Fills a rectangle with copies of a texture whose texels are `zoom` pixels wide.
void copyTiled(Picture& sheet, const Picture& texture, int left, int top, int width, int height,
               int zoom) {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            sheet.at(left + x, top + y) = texture.at(x / zoom, y / zoom);
        }
    }
}

// A part of a sky as a screen shows it: columns and rows are drawn `columnSize` and `rowSize`
// hundredths of a pixel wide and tall.
struct SkyView {
    int fromColumn;
    int fromRow;
    int columnSize;
    int rowSize;
};

void copySky(Picture& sheet, const Picture& sky, const SkyView& view, int left, int top, int width,
             int height) {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            sheet.at(left + x, top + y) = sky.at(view.fromColumn + x * 100 / view.columnSize,
                                                 view.fromRow + y * 100 / view.rowSize);
        }
    }
}

// A smaller picture: each pixel is the mean of factor x factor texels.
Picture reduced(const Picture& texture, int factor) {
    Picture small(texture.width / factor, texture.height / factor);
    const int area = factor * factor;
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            int r = area / 2;
            int g = area / 2;
            int b = area / 2;
            for (int inner = 0; inner < area; ++inner) {
                const Colour& colour =
                    texture.at(x * factor + inner % factor, y * factor + inner / factor);
                r += colour.r;
                g += colour.g;
                b += colour.b;
            }
            small.at(x, y) = {static_cast<std::uint8_t>(r / area),
                              static_cast<std::uint8_t>(g / area),
                              static_cast<std::uint8_t>(b / area)};
        }
    }
    return small;
}

Picture grey(const Picture& texture) {
    Picture result = texture;
    for (Colour& colour : result.pixels) {
        const auto value = static_cast<std::uint8_t>(greyOf(colour));
        colour = {value, value, value};
    }
    return result;
}

constexpr int kSheetWidth = 1560;

// A see-through colour in front of an opaque one.
Colour over(const Colour& colour, const Colour& ground) {
    return blend(ground, colour, (colour.a * 256 + 127) / 255);
}

// What see-through pictures are shown on.
enum class Ground { Checker, Dark, Light };

Colour groundAt(Ground ground, int x, int y) {
    if (ground == Ground::Checker) {
        return (x / 8 + y / 8) % 2 == 0 ? kSlate3 : kSlate4;
    }
    return ground == Ground::Dark ? kNight : kSea4;
}

// Lays a part of a picture over a ground, enlarged `zoom` times. `fromColumn` and the size of the
// part count texels, `left` and `top` pixels of the sheet.
void copyOver(Picture& sheet, const Picture& picture, int fromColumn, Ground ground, int left,
              int top, int width, int height, int zoom) {
    for (int y = 0; y < zoom * height; ++y) {
        for (int x = 0; x < zoom * width; ++x) {
            sheet.at(left + x, top + y) =
                over(picture.at(fromColumn + x / zoom, y / zoom), groundAt(ground, x, y));
        }
    }
}

// Shows all frames of one entry, on three grounds if it is see-through.
Picture groundsSheet(const Entry& entry) {
    const Picture picture = entry.paint();
    const int frameWidth = picture.width / entry.frames;
    const bool tiled = entry.frames == 1 && entry.use != Use::Sprite;
    // Each ground shows one piece: a texture beside a copy of itself, or one frame. In texels
    const int width = tiled && entry.repeatsSideways ? 2 * frameWidth : frameWidth;
    const int height = tiled && entry.repeatsUpwards ? 2 * picture.height : picture.height;
    const int zoom =
        std::clamp(kSheetWidth / 3 / width, 1, entry.frames > 1 ? (height > 64 ? 2 : 3) : 4);
    const int perLine = kSheetWidth / (zoom * width + kMargin);
    const int grounds = entry.alpha == Alpha::Opaque ? 1 : 3;
    const int pieces = entry.frames * grounds;
    Picture sheet(kSheetWidth, (pieces + perLine - 1) / perLine * (zoom * height + kMargin));
    std::fill(sheet.pixels.begin(), sheet.pixels.end(), kInk);
    for (int piece = 0; piece < pieces; ++piece) {
        const auto ground = static_cast<Ground>(piece / entry.frames);
        const int left = piece % perLine * (zoom * width + kMargin);
        const int top = piece / perLine * (zoom * height + kMargin);
        copyOver(sheet, picture, piece % entry.frames * frameWidth, ground, left, top, width,
                 height, zoom);
    }
    return sheet;
}

// Puts another sheet below.
void append(Picture& sheet, const Picture& below) {
    Picture both(std::max(sheet.width, below.width), sheet.height + below.height);
    std::fill(both.pixels.begin(), both.pixels.end(), kNight);
    int top = 0;
    for (const Picture* part : {static_cast<const Picture*>(&sheet), &below}) {
        for (int y = 0; y < part->height; ++y) {
            for (int x = 0; x < part->width; ++x) {
                both.at(x, top + y) = part->at(x, y);
            }
        }
        top += part->height;
    }
    sheet = both;
}

// Shows opaque pictures without frames: textures repeated in two sizes, grey and reduced; skies as
// a whole and in two views.
Picture tilesSheet(const std::vector<Entry>& entries);

}  // namespace

Picture contactSheet(const std::vector<Entry>& entries) {
    std::vector<Entry> tiles;
    std::vector<Entry> others;
    for (const Entry& entry : entries) {
        (entry.alpha == Alpha::Opaque && entry.frames == 1 ? tiles : others).push_back(entry);
    }
    Picture sheet = tiles.empty() ? Picture(0, 0) : tilesSheet(tiles);
    for (const Entry& entry : others) {
        append(sheet, groundsSheet(entry));
    }
    return sheet;
}

namespace {

Picture tilesSheet(const std::vector<Entry>& entries) {
    const int perRow = std::min(2, static_cast<int>(entries.size()));
    const int cellWidth = kTiled + kMargin + kTiled + kMargin + kSide + 2 * kMargin;
    const int cellHeight = kTiled + kMargin;
    const int rows = (static_cast<int>(entries.size()) + perRow - 1) / perRow;
    Picture sheet(perRow * cellWidth, rows * cellHeight);
    std::fill(sheet.pixels.begin(), sheet.pixels.end(), kNight);
    int index = 0;
    for (const Entry& entry : entries) {
        const Picture texture = entry.paint();
        const int left = index % perRow * cellWidth + kMargin;
        const int top = index / perRow * cellHeight + kMargin / 2;
        if (texture.width == texture.height) {
            const int second = left + kTiled + kMargin;
            const int third = second + kTiled + kMargin;
            copyTiled(sheet, texture, left, top, kTiled, kTiled, 1);
            copyTiled(sheet, texture, second, top, kTiled, kTiled, 4);
            copyTiled(sheet, grey(texture), third, top, kSide, kSide, 1);
            copyTiled(sheet, reduced(texture, 4), third, top + kSide + kMargin, kSide, 96, 1);
            copyTiled(sheet, reduced(texture, 8), third, top + kSide + 96 + 2 * kMargin, kSide, 64,
                      1);
            copyTiled(sheet, reduced(texture, 8), third, top + kSide + 160 + 3 * kMargin, kSide, 64,
                      4);
        } else {
            // The whole sky in its true proportions, and what a view of 60 degrees sees of it
            copySky(sheet, texture,
                    {.fromColumn = 0, .fromRow = 0, .columnSize = 88, .rowSize = 56}, left, top,
                    cellWidth - 2 * kMargin, 143);
            copySky(sheet, texture,
                    {.fromColumn = 500, .fromRow = 256 - 88, .columnSize = 420, .rowSize = 267},
                    left, top + 150, 448, 234);
            copySky(sheet, texture,
                    {.fromColumn = 700, .fromRow = 50, .columnSize = 420, .rowSize = 267},
                    left + 456, top + 150, 448, 234);
        }
        ++index;
    }
    return sheet;
}

}  // namespace

}  // namespace slicecast::textures
