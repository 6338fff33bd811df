#include "turned_copy.h"

#include "base/angle.h"

#include <utility>

namespace slicecast::judge {
namespace {

constexpr int kTileSide = 65536;  // as a coordinate

// The point of a map of that size where one of its points, (x, y), lies after clockwise quarter
// turns. Of tiles, `side` is 1 and the result is the tile.
Tile turnedWithin(Tile at, int width, int depth, int turn, int side) {
    for (int i = 0; i < turn; ++i) {
        at = {depth - side - at.y, at.x};
        std::swap(width, depth);
    }
    return at;
}

// Every frame of a sheet turned clockwise within itself.
TextureId turnedTexture(World& world, TextureId id, int turn) {
    if (id == kNoTexture || turn == 0) return id;
    const Texture& texture = world.textures[id];
    const int size = texture.size();
    Image image(texture.frames() * size, size);
    for (int y = 0; y < size; ++y) {
        for (int column = 0; column < image.width; ++column) {
            const Tile to = turnedWithin({column % size, y}, size, size, turn, 1);
            const TextureLevel& frame = texture.levelsOf(column / size)[0];
            image.at(column - column % size + to.x, to.y) =
                frame.texels[static_cast<std::size_t>(column % size * size + y)];
        }
    }
    const double rate = texture.rate;
    const int frames = texture.frames();
    world.textures.push_back(makeTexture("turned", image, frames, rate));
    return static_cast<TextureId>(world.textures.size() - 1);
}

// The panorama begins in the east; its columns move on by a quarter of its width for each turn.
Image turnedPanorama(const Image& panorama, int turn) {
    Image turned(panorama.width, panorama.height);
    for (int y = 0; y < panorama.height; ++y) {
        for (int x = 0; x < panorama.width; ++x)
            turned.at((x + turn * panorama.width / 4) % panorama.width, y) = panorama.at(x, y);
    }
    return turned;
}

}  // namespace

Tile turnedTile(const Map& original, Tile tile, int turn) {
    return turnedWithin(tile, original.width, original.depth, turn, 1);
}

int addTurnedCopy(World& world, int index, int turn) {
    const Map original = world.maps[static_cast<std::size_t>(index)];
    Map copy = original;
    copy.tilePortals.clear();
    if (turn % 2 != 0) std::swap(copy.width, copy.depth);

    // Each texture is turned once for what is seen from above and once for what is seen from below,
    // where it runs the other way.
    const int fromBelow = (4 - turn) % 4;
    std::vector<TextureId> above(world.textures.size());
    std::vector<TextureId> below(world.textures.size());
    for (std::size_t i = 0; i < above.size(); ++i) {
        above[i] = turnedTexture(world, static_cast<TextureId>(i), turn);
        below[i] = turnedTexture(world, static_cast<TextureId>(i), fromBelow);
    }
    std::vector<BlueprintId> blocks(world.blueprints.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        blocks[i] = static_cast<BlueprintId>(i);
        if (i == kEmptyCell || turn == 0) continue;
        CellBlueprint block = world.blueprints[i];
        for (std::size_t side = 0; side < 4; ++side)
            block.faces[(side + static_cast<std::size_t>(turn)) % 4] =
                world.blueprints[i].faces[side];
        for (FaceBlueprint& face : block.faces) face.portal = kNoPortal;
        block.plan = turned(block.plan, turn);
        block.slopes = turned(block.slopes, turn);
        for (int quarter = 0; quarter < turn; ++quarter) {
            const Coordinate east = block.textureEast;
            block.textureEast = {-block.textureSouth.raw & 0xffff};
            block.textureSouth = east;
        }
        FaceBlueprint& top = block.faces[static_cast<std::size_t>(Face::top)];
        FaceBlueprint& bottom = block.faces[static_cast<std::size_t>(Face::bottom)];
        // Water may lack faces.
        if (top.texture != kNoTexture) top.texture = above[top.texture];
        if (bottom.texture != kNoTexture) bottom.texture = below[bottom.texture];
        world.blueprints.push_back(block);
        blocks[i] = static_cast<BlueprintId>(world.blueprints.size() - 1);
    }

    copy.floor.texture = above[original.floor.texture];
    for (int y = 0; y < original.depth; ++y) {
        for (int x = 0; x < original.width; ++x) {
            const Tile at = turnedTile(original, {x, y}, turn);
            const std::size_t from = original.tileIndex(x, y);
            const std::size_t to = copy.tileIndex(at.x, at.y);
            for (int level = 0; level < original.levels; ++level) {
                copy.cells[copy.cellIndex(at.x, at.y, level)] =
                    blocks[original.cells[original.cellIndex(x, y, level)]];
            }
            copy.occupied[to] = original.occupied[from];
            copy.floor.tiles[to] = above[original.floor.tiles[from]];
            if (original.ceiling.tiles.empty()) continue;
            const TextureId ceiling = original.ceiling.tiles[from];
            copy.ceiling.tiles[to] = ceiling == kNoTexture ? ceiling : below[ceiling];
        }
    }
    for (Object& object : copy.objects) {
        const Tile at = turnedWithin({object.x.raw, object.y.raw}, original.width * kTileSide,
                                     original.depth * kTileSide, turn, 0);
        object.x = {at.x};
        object.y = {at.y};
        for (int quarter = 0; quarter < turn; ++quarter)
            object.facingX = {-std::exchange(object.facingY, object.facingX).raw};
    }
    if (original.sky.kind == Sky::Kind::panorama)
        copy.sky.panorama = turnedPanorama(original.sky.panorama, turn);
    for (SkyDisc* const disc : {&copy.sky.sun, &copy.sky.moon})
        disc->azimuth = wrapDegrees(disc->azimuth + 90.0 * turn);
    world.maps.push_back(std::move(copy));
    return static_cast<int>(world.maps.size()) - 1;
}

}  // namespace slicecast::judge
