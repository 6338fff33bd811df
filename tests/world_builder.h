// Small worlds for tests, written as they look:
//
//     WorldBuilder make;
//     make.texture("grey", {128, 128, 128, 255});
//     make.block('#');                                    blueprint 1: whole, of texture 0
//     make.block('-', {.name = "step", .top = 0.5});      blueprint 2
//     make.map("yard", 2, R"(                             of 2 levels, the upper one empty
//     #####
//     #..-#
//     #####
//     )");
//     make.start(1.5, 1.5);
//     make.world                                          for whatever else a test wants
#pragma once

#include "base/image.h"
#include "world/world.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace slicecast {

inline Image imageOf(Colour colour, int side = 8) {
    Image image(side, side);
    for (Pixel& pixel : image.pixels) pixel = toPixel(colour);
    return image;
}

// Each texel has another colour.
inline Image squaresImage() {
    Image image(8, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x)
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(90 + 16 * x),
                                      static_cast<std::uint8_t>(60 + 20 * y), 110, 255});
    }
    return image;
}

struct BlockSpec {
    const char* name = "";
    double bottom = 0.0;  // units above its level's base
    double top = 1.0;
    TextureId texture = 0;  // of all faces
};

struct WorldBuilder {
    World world;

    void texture(const char* name, Image image) {
        world.textures.push_back(makeTexture(name, std::move(image)));
    }
    void texture(const char* name, Colour colour) { texture(name, imageOf(colour)); }

    // `sign` stands for it in rows.
    CellBlueprint& block(char sign, const BlockSpec& spec = {}) {
        signs_[sign] = static_cast<BlueprintId>(world.blueprints.size());
        CellBlueprint& added = world.blueprints.emplace_back();
        added.name = spec.name;
        added.bottom = toCoordinate(spec.bottom);
        added.top = toCoordinate(spec.top);
        for (FaceBlueprint& face : added.faces) face.texture = spec.texture;
        return added;
    }

    // Level 0 as rows, a line each; '.' is an empty cell. What is above is empty.
    Map& map(const char* name, int levels, std::string_view rows, TextureId floor = 0) {
        rows = rows.substr(1, rows.size() - 2);  // the line breaks before and behind
        const int width = static_cast<int>(std::min(rows.find('\n'), rows.size()));
        const int depth = static_cast<int>(std::count(rows.begin(), rows.end(), '\n')) + 1;
        map(name, width, depth, levels, floor);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const int at = static_cast<int>(i);
            if (rows[i] != '.' && rows[i] != '\n') put(rows[i], at % (width + 1), at / (width + 1));
        }
        return world.maps.back();
    }
    // An empty one.
    Map& map(const char* name, int width, int depth, int levels, TextureId floor = 0) {
        return world.maps.emplace_back(makeMap(name, width, depth, levels, floor));
    }

    // These three go into the last map.
    void put(char sign, int x, int y, int level = 0) {
        world.maps.back().setCell(x, y, level, signs_.at(sign));
    }
    Object& object(double x, double y, double z, double width, double height) {
        return world.maps.back().objects.emplace_back(Object{.x = toCoordinate(x),
                                                             .y = toCoordinate(y),
                                                             .z = toCoordinate(z),
                                                             .width = toCoordinate(width),
                                                             .height = toCoordinate(height)});
    }
    void ceiling(double height, TextureId texture, int firstRow, int endRow) {
        Map& map = world.maps.back();
        map.ceiling.height = toCoordinate(height);
        map.ceiling.tiles.assign(map.occupied.size(), kNoTexture);
        for (int y = firstRow; y < endRow; ++y) {
            for (int x = 0; x < map.width; ++x) map.ceiling.tiles[map.tileIndex(x, y)] = texture;
        }
    }

    // Of a whole tile. All maps that it joins are there.
    void tilePortal(const Portal& portal) {
        Map& map = world.maps[static_cast<std::size_t>(portal.fromMap)];
        map.tilePortals.resize(map.occupied.size(), kNoPortal);
        map.tilePortals[map.tileIndex(portal.fromX, portal.fromY)] =
            static_cast<PortalId>(world.portals.size());
        world.portals.push_back(portal);
    }

    // In the first map.
    void start(double x, double y, double z = 0.0, double headingDegrees = 0.0, double look = 0.0) {
        world.start = {.map = 0,
                       .x = toCoordinate(x),
                       .y = toCoordinate(y),
                       .z = toCoordinate(z),
                       .headingDegrees = headingDegrees,
                       .look = look};
    }

private:
    std::unordered_map<char, BlueprintId> signs_;
};

}  // namespace slicecast
