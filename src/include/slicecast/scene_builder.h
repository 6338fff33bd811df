// Makes a scene in code, without a file.
//
//     SceneBuilder builder("A room");
//     const auto stone = builder.colour("stone", {150, 140, 130});
//     const auto wall = builder.block({.name = "wall", .texture = stone});
//     const auto room = builder.map({.name = "room", .width = 8, .depth = 6, .floor = stone});
//     builder.fill(room, {.width = 8}, wall);                   // the north side
//     builder.start(room, {.x = 4.0, .y = 4.0, .headingDegrees = 270.0});
//     LoadResult built = std::move(builder).build();
//
// The calls collect faults, and build() returns them all: no call has to be checked by itself.
// Portals, motions, gates and objects cannot be built; loadSceneText() reads them.
#pragma once

#include "slicecast/colour.h"
#include "slicecast/face.h"
#include "slicecast/half.h"
#include "slicecast/image.h"
#include "slicecast/scene.h"

#include <memory>
#include <optional>
#include <string>

namespace slicecast {

class SceneBuilder {
public:
    // Handles that the calls below return. A handle is valid only for the builder that returned it.
    struct Texture {
        int index = -1;  // below 0: none
    };
    struct Block {
        int index = 0;  // 0: the empty cell
    };
    struct Map {
        int index = -1;
    };

    // A top that rises evenly towards a side of the tile: from a height over the edge opposite to
    // it up to the block's own top, over the edge at it.
    struct Rise {
        Face side = Face::north;  // not the top or the bottom
        double from = 0.0;        // bottom <= from <= top
    };
    // A box that fills a cell from side to side.
    struct BlockSpec {
        std::string name = {};       // not empty
        Texture texture = {};        // of all faces
        Texture topTexture = {};     // of the top; none: like the other faces
        double bottom = 0.0;         // heights above the base of the cell's level, units;
        double top = 1.0;            // 0 <= bottom < top <= 1
        Half diagonal = Half::none;  // fills this half of its tile, which is cut corner to corner
        std::optional<Rise> rise = {};  // makes the top a slope; not with `diagonal` or `mirror`
        double light = 1.0;             // share of the map's light that its faces receive, 0 to 1
        double mirror = 0.0;            // how strongly its top mirrors what is above, 0 to 1
        std::string sign = {};  // for Game::setCell, a single visible character; may be empty
    };
    struct MapSpec {
        std::string name = {};                 // not empty, unique
        int width = 0;                         // tiles eastward, 1 to 4096
        int depth = 0;                         // tiles southward, 1 to 4096
        int levels = 1;                        // 1 to 32; at most 64,000,000 cells in all
        Texture floor = {};                    // under the whole map, and endless around it
        Colour skyLow = {150, 190, 230, 255};  // at the horizon
        Colour skyHigh = {90, 140, 200, 255};  // high above
        double fogStart = 0.0;  // units, 0 to 100,000; no fog unless the end lies beyond the start
        double fogEnd = 0.0;    // from here on only the colour of the horizon
    };
    // A box of cells from (x, y, level) on. It must lie inside the map.
    struct Box {
        int x = 0;
        int y = 0;
        int level = 0;
        int width = 1;  // tiles eastward
        int depth = 1;  // tiles southward
        int levels = 1;
    };
    // Light that falls on the faces of a map, with shadows; see web/docs/scenes.md, "Sun, sky and
    // lamps". The sun stands in the direction `azimuthDegrees`: 0 is east, 90 south.
    struct Sun {
        double azimuthDegrees = 225.0;
        double altitudeDegrees = 45.0;  // above the horizon, above 0 and at most 90
        Colour colour = {255, 244, 224, 255};
        Colour ambient = {96, 104, 128, 255};  // of the sky
    };
    struct Lamp {
        double x = 0.0;  // units, on the map
        double y = 0.0;
        double z = 0.0;  // 0 to 1000
        Colour colour = {255, 255, 255, 255};
        double strength = 1.0;  // 0 to 16
        double radius = 4.0;    // units, above 0 and at most 16: it lights nothing beyond
    };
    struct Start {
        double x = 0.0;  // units, on the map
        double y = 0.0;
        double z = 0.0;  // height of the feet, 0 to 1000
        double headingDegrees = 0.0;
    };

    explicit SceneBuilder(std::string title = {});
    ~SceneBuilder();
    SceneBuilder(SceneBuilder&& other) noexcept;
    SceneBuilder& operator=(SceneBuilder&& other) noexcept;
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;

    // A square image whose side is a power of two from 8 to 1024. Pixels with alpha below 255 are
    // see-through. Here and below, the first telling word of the name says the material ("planks"
    // is wood, see web/docs/scenes.md); without one it is stone.
    Texture texture(std::string name, const Image& image);
    // A texture of one opaque colour.
    Texture colour(std::string name, Colour colour);

    Block block(const BlockSpec& spec);

    // A map of empty cells.
    Map map(const MapSpec& spec);

    // Puts a block into each cell of a box; the empty block clears the cells.
    void fill(Map map, const Box& box, Block block);

    // Lights a map by a sun and the sky, and by lamps. A map without either is evenly bright.
    void light(Map map, const Sun& sun);
    void lamp(Map map, const Lamp& lamp);

    // Where the player starts; flies if that is inside a block. Without a call: the middle of the
    // first map, facing east.
    void start(Map map, const Start& start);

    // The scene, or all faults. The builder cannot be used afterwards.
    LoadResult build() &&;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace slicecast
