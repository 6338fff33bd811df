// Helpers to make small worlds whose pictures can be worked out by hand.
#pragma once

#include "base/image.h"
#include "render/renderer.h"
#include "world/world.h"

#include <string>

namespace slicecast::known {

inline constexpr Colour kWhite = {255, 255, 255, 255};
inline constexpr Colour kMagenta = {255, 0, 255, 255};

// A texture of one colour.
inline Texture plain(const std::string& name, Colour colour, int size = 8) {
    Image image(size, size);
    for (Pixel& pixel : image.pixels) pixel = toPixel(colour);
    return makeTexture(name, std::move(image));
}

// A world with one empty map and no light; `floor` is its first texture, the sky magenta.
inline World emptyWorld(int width, int depth, int levels, Texture floor) {
    World world;
    world.textures.push_back(std::move(floor));
    Map map = makeMap("known", width, depth, levels, 0);
    map.light.on = false;
    map.sky.low = kMagenta;
    map.haze = kMagenta;
    world.maps.push_back(std::move(map));
    return world;
}

// A blueprint with one texture on all faces; by default it fills its cell.
inline BlueprintId addBlock(World& world, TextureId texture, Coordinate bottom = {},
                            Coordinate top = tileEdge(1)) {
    CellBlueprint blueprint;
    blueprint.bottom = bottom;
    blueprint.top = top;
    for (FaceBlueprint& face : blueprint.faces) face.texture = texture;
    world.blueprints.push_back(blueprint);
    return static_cast<BlueprintId>(world.blueprints.size() - 1);
}

inline TextureId addTexture(World& world, Texture texture) {
    world.textures.push_back(std::move(texture));
    return static_cast<TextureId>(world.textures.size() - 1);
}

inline Eye eyeAt(double x, double y, double z, double heading, double look = 0.0) {
    return {.map = 0,
            .x = toCoordinate(x),
            .y = toCoordinate(y),
            .z = toCoordinate(z),
            .headingDegrees = heading,
            .look = look};
}

// Draws a picture; an empty image if the renderer refuses.
inline Image draw(const World& world, const Eye& eye, int width, int height,
                  const RenderOptions& options = {}) {
    Renderer renderer;
    Image image(width, height);
    return renderer.draw(world, eye, options, {image.pixels.data(), width, height, width})
               ? image
               : Image{};
}

inline SpriteId addSprite(World& world, int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint8_t alpha = (x + y) % 4 == 0 ? 0 : (x + y) % 4 == 1 ? 120 : 255;
            image.at(x, y) = toPixel({static_cast<std::uint8_t>(100 + 5 * x),
                                      static_cast<std::uint8_t>(100 + 5 * y), 30, alpha});
        }
    }
    world.sprites.push_back(makeSprite("figure", image));
    return static_cast<SpriteId>(world.sprites.size() - 1);
}

inline void addObject(World& world, SpriteId sprite, double x, double y, double z, double width,
                      double height) {
    Object object;
    object.sprite = sprite;
    object.x = toCoordinate(x);
    object.y = toCoordinate(y);
    object.z = toCoordinate(z);
    object.width = toCoordinate(width);
    object.height = toCoordinate(height);
    world.maps[0].objects.push_back(object);
}

}  // namespace slicecast::known
