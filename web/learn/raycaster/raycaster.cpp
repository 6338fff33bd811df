// The reader's raycaster in C++20, at the end of the tutorial: all its functions but walking. Use:
//     raycaster WORLD >PICTURES
// world.h reads the world and the views; the pictures are bytes R, G, B, A, one after the other.
#include "world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

// Rounds off the last bits, which are wrong: the cosine of 90 degrees becomes 0.
double exact(double number) {
    return std::round(number * 0x1p45) / 0x1p45 + 0.0;
}

View makeView(const Picture& picture, const Eye& eye) {
    constexpr double kRadians = 3.14159265358979323846 / 180.0;
    const double x = exact(std::cos(eye.heading * kRadians));
    const double y = exact(std::sin(eye.heading * kRadians));
    const double width = picture.width;
    const double distance = width / 2.0 / exact(std::tan(eye.fov * kRadians / 2.0));
    return {width, distance, (0.5 + eye.look) * picture.height, 1.0, {x, y}, {-y, x}};
}

// The direction of a column's ray on the map, for each unit of depth.
Point rayOf(const View& view, int column) {
    const double sideways = (column + 0.5 - view.width / 2.0) / view.distance;
    return {view.forward.x + sideways * view.right.x, view.forward.y + sideways * view.right.y};
}

bool isInside(const Map& map, int x, int y) {
    return x >= 0 && y >= 0 && x < map.width && y < map.depth;
}

const Block* blockAt(const Map& map, int x, int y, int level) {
    if (!isInside(map, x, y)) return nullptr;
    const int cell = map.cells[(level * map.depth + y) * map.width + x];
    return cell < 0 ? nullptr : &map.blocks[cell];
}

// The tiles that a ray passes. The last one stands for all the rest, outside the map.
std::vector<Tile> walkGrid(const Map& map, const Eye& eye, Point ray, Tile tile) {
    std::vector<Tile> tiles;
    const int stepX = ray.x < 0.0 ? -1 : 1;
    const int stepY = ray.y < 0.0 ? -1 : 1;
    // Where two depths are equal, the eye counts as moved: a little east, and far less south.
    const double shareX = 1.0 - stepX * 0x1p-40;
    const double shareY = 1.0 - stepY * 0x1p-46;
    while (isInside(map, tile.x, tile.y)) {
        const double distanceX = stepX > 0 ? tile.x + 1 - eye.x : eye.x - tile.x;
        const double distanceY = stepY > 0 ? tile.y + 1 - eye.y : eye.y - tile.y;
        const double farX = distanceX / std::abs(ray.x) * shareX;
        const double farY = distanceY / std::abs(ray.y) * shareY;
        tile.far = std::min(farX, farY);
        tiles.push_back(tile);
        if (farX < farY) {
            tile = {tile.x + stepX, tile.y, farX, kInfinity, stepX > 0 ? west : east};
        } else {
            tile = {tile.x, tile.y + stepY, farY, kInfinity, stepY > 0 ? north : south};
        }
    }
    tiles.push_back(tile);
    return tiles;
}

// The blocks of a tile from below. Nothing at or below the height `lowest` is there.
std::vector<Placed> blocksOf(const Map& map, int x, int y, double lowest) {
    std::vector<Placed> blocks;
    for (int level = 0; level < map.levels; ++level) {
        const Block* block = blockAt(map, x, y, level);
        if (!block || block->bottom >= block->top || level + block->top <= lowest) continue;
        const double bottom = std::max(lowest, level + block->bottom);
        blocks.push_back({block, level, bottom, level + block->top});
    }
    return blocks;
}

Colour dim(const Colour& colour, double light) {
    const int factor = static_cast<int>(256.0 * light + 0.5);
    const auto lit = [&](int channel) { return (channel * factor + 128) >> 8; };
    return {lit(colour[0]), lit(colour[1]), lit(colour[2]), colour[3]};
}

Colour blend(const Colour& over, const Colour& under, int weight) {
    const auto mix = [&](int i) {
        return (over[i] * weight + under[i] * (255 - weight) + 127) / 255;
    };
    return {mix(0), mix(1), mix(2), under[3]};
}

// A colour in the light and the fog of its depth.
Colour shade(const Map& map, const Colour& colour, double depth, double faceLight) {
    const double falloff = map.intensity * map.multiplier / depth;
    const double limited = std::min(std::max(falloff, map.darkest), map.brightest);
    const Colour lit = dim(colour, (map.isLit ? limited : 1.0) * faceLight);
    if (!map.isFoggy || depth <= map.fogStart) return lit;
    const double share = std::min(1.0, (depth - map.fogStart) / (map.fogEnd - map.fogStart));
    return blend(map.haze, lit, static_cast<int>(255.0 * share + 0.5));
}

Colour skyColour(const Map& map, double slope) {
    if (slope < 0.0) return map.haze;
    const double share = std::min(1.0, slope / map.skySlope);
    const auto between = [&](int i) {
        const int low = map.skyLow[i];
        return static_cast<int>(low + (map.skyHigh[i] - low) * share + 0.5);
    };
    return {between(0), between(1), between(2), 255};
}

// `pixelSize` is the size of a pixel at its depth, in units: it chooses the level of detail.
Colour texelOf(const Texture& texture, double u, double v, double pixelSize) {
    const int last = static_cast<int>(texture.size()) - 1;
    int level = 0;
    while (level < last && pixelSize * texture[0].height > 1 << level) ++level;
    const auto& [width, height, texels] = texture[level];
    const int column =
        std::clamp(static_cast<int>(std::floor((u + 0x1p-33) * width)), 0, width - 1);
    const int row = std::clamp(static_cast<int>(std::floor((v + 0x1p-33) * height)), 0, height - 1);
    return texels[row * width + column];
}

double rowOf(const Slice& slice, double height, double depth) {
    const auto& [width, distance, horizon, up, forward, right] = slice.view;
    return horizon - up * (height - slice.eye.z) * distance / depth;
}

double slopeOf(const Slice& slice, int row) {
    return slice.view.up * (slice.view.horizon - (row + 0.5)) / slice.view.distance;
}

// The part of a slice between two heights on the screen.
Slice partOf(const Slice& slice, double from, double to) {
    const auto within = [&](double row) {
        return static_cast<int>(std::clamp<double>(std::floor(row + 0.5), slice.first, slice.last));
    };
    Slice part = slice;
    part.first = within(std::min(from, to));
    part.last = within(std::max(from, to));
    return part;
}

void put(Column& column, int row, const Colour& colour) {
    if (colour[3] == 0) return;
    if (colour[3] < 255) return column.layers.push_back({row, colour});
    column.open[row] = 0;
    const int at = row * column.picture.width + column.number;
    column.picture.pixels[at] = colour[0] | colour[1] << 8 | colour[2] << 16 | 255u << 24;
}

template <typename ColourOf>
void fillRows(const Slice& slice, double from, double to, const ColourOf& colourOf) {
    const Slice part = partOf(slice, from, to);
    for (int row = part.first; row < part.last; ++row)
        if (slice.column.open[row] != 0) put(slice.column, row, colourOf(row));
}

// Lays what is seen through over what is behind it, the furthest first.
void layOver(Column& column) {
    const std::vector<Layer> layers = column.layers;
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        const int at = layer->row * column.picture.width + column.number;
        const auto pixel = static_cast<int>(column.picture.pixels[at] & 0xffffff);
        const Colour behind = {pixel & 255, pixel >> 8 & 255, pixel >> 16, 255};
        put(column, layer->row, blend(layer->colour, behind, layer->colour[3]));
    }
}

// Whether a block touches its like among these, on some level: then there is no face between them.
bool isJoined(const Placed& each, const std::vector<Placed>& others, int level) {
    if (!each.block->seeThrough || !each.block->join) return false;
    return std::ranges::any_of(others, [&](const Placed& other) {
        return other.block == each.block && other.level == level && other.bottom <= each.top &&
               other.top >= each.bottom;
    });
}

void drawSide(const Slice& slice, const Tile& tile, Face face, const Placed& each) {
    const Look& look = each.block->faces[face];
    const double depth = tile.near;
    if (depth == 0.0) return;  // the eye is in its plane
    const double x = slice.eye.x + slice.ray.x * depth - tile.x;
    const double y = slice.eye.y + slice.ray.y * depth - tile.y;
    const double along = face == east || face == west ? y : x;
    const double u = face == north || face == east ? 1.0 - 0x1p-32 - along : along;
    const double upper = rowOf(slice, each.top, depth);
    fillRows(slice, upper, rowOf(slice, each.bottom, depth), [&](int row) {
        double v = each.level + 1 - (slice.eye.z + slopeOf(slice, row) * depth);
        if (each.block->motion.moves != 0)
            v += each.block->moved - std::floor(v + each.block->moved);
        const Texture& shown = slice.world.textures[look.texture];
        return shade(*slice.map, texelOf(shown, u, v, depth / slice.view.distance), depth,
                     look.light);
    });
}

// The planes of a tile in the order in which rays meet them: outwards from the eye's height.
std::vector<Plane> planesOf(const Slice& slice, const Tile& tile) {
    const Map& map = *slice.map;
    const double z = slice.eye.z;
    std::vector<Plane> planes;
    for (const Placed& each : tile.blocks) {
        const Plane roof = {each.top, &each.block->faces[top], false, each.top > z ? 1 : 2};
        const Plane under = {each.bottom, &each.block->faces[bottom], true,
                             each.bottom < z ? 1 : 2};
        if (!isJoined(each, tile.blocks, each.level + 1)) planes.push_back(roof);
        if (!isJoined(each, tile.blocks, each.level - 1)) planes.push_back(under);
    }
    const bool inside = isInside(map, tile.x, tile.y);
    const int at = inside ? tile.y * map.width + tile.x : 0;
    if (inside && map.ceiling[at].texture >= 0)
        planes.push_back({map.ceilingHeight, &map.ceiling[at], true, 3});
    planes.push_back({0.0, inside ? &map.floor[at] : &map.outside, false, 3});
    std::erase_if(planes, [&](const Plane& plane) { return plane.height <= slice.lowest; });
    const auto order = [z](const Plane& plane) {
        return std::pair(std::abs(plane.height - z), plane.order);
    };
    std::ranges::stable_sort(planes, {}, order);
    return planes;
}

void drawPart(const Slice& slice);

// Draws what a mirror shows: from an eye as far below it as ours is above, upside down.
void reflect(const Slice& slice, double height, double from, double to) {
    Slice part = partOf(slice, from, to);
    part.lowest = height;
    part.eye.z = 2.0 * height - slice.eye.z;
    part.view.up = -slice.view.up;
    drawPart(part);
}

void drawPlane(const Slice& slice, const Plane& plane, double near, double far) {
    const Look& look = *plane.look;
    const double rise = plane.height - slice.eye.z;
    if (rise == 0.0) return;
    const bool isMirror = look.mirror > 0 && rise < 0.0 && slice.lowest == -kInfinity;
    const double from = rowOf(slice, plane.height, near);
    const double to = rowOf(slice, plane.height, far);
    fillRows(slice, from, to, [&](int row) {
        const double depth = rise / slopeOf(slice, row);
        if (plane.height == 0.0 && depth > slice.map->far) return slice.map->haze;
        const double x = slice.eye.x + slice.ray.x * depth;
        const double y = slice.eye.y + slice.ray.y * depth;
        const double v = plane.under ? 1.0 - 0x1p-32 - (y - std::floor(y)) : y - std::floor(y);
        const Texture& shown = slice.world.textures[look.texture];
        Colour texel = texelOf(shown, x - std::floor(x), v, depth / slice.view.distance);
        if (isMirror) texel[3] = 255 - look.mirror;
        return shade(*slice.map, texel, depth, look.light);
    });
    if (isMirror) reflect(slice, plane.height, from, to);
}

std::vector<Seen> objectsOf(const Slice& slice) {
    const auto& [width, distance, horizon, up, forward, right] = slice.view;
    std::vector<Seen> seen;
    for (const Object& object : slice.map->objects) {
        const double x = object.x - slice.eye.x;
        const double y = object.y - slice.eye.y;
        const double depth = std::floor((x * forward.x + y * forward.y) * 65536.0 + 0.5) / 65536.0;
        const Point miss = {slice.ray.x * depth - x, slice.ray.y * depth - y};
        const double u = (miss.x * right.x + miss.y * right.y) / object.width + 0.5;
        const bool isAbove = object.z + object.height > slice.lowest;
        const bool isBeyond = depth > 0.0 && depth >= slice.from.near;
        if (isBeyond && u >= 0.0 && u < 1.0 && isAbove) seen.push_back({&object, depth, u});
    }
    std::ranges::stable_sort(seen, {}, &Seen::depth);
    return seen;
}

void drawObject(const Slice& slice, const Seen& seen) {
    const Object& object = *seen.object;
    const double head = object.z + object.height;
    const double feet = rowOf(slice, std::max(object.z, slice.lowest), seen.depth);
    fillRows(slice, rowOf(slice, head, seen.depth), feet, [&](int row) {
        const double v = (head - slice.eye.z - slopeOf(slice, row) * seen.depth) / object.height;
        const double pixelSize = seen.depth / slice.view.distance;
        const Colour texel = texelOf(slice.world.textures[object.texture], seen.u, v, pixelSize);
        return shade(*slice.map, texel, seen.depth, object.light);
    });
}

Point turned(Point arrow, int quarters) {
    return quarters == 0 ? arrow : turned({-arrow.y, arrow.x}, quarters - 1);
}

// The eye in the coordinates of the map behind a portal: its tile, turned, is laid on the exit's.
Eye eyeBeyond(Eye eye, const Portal& portal) {
    const Point fromMiddle = turned({eye.x - portal.x - 0.5, eye.y - portal.y - 0.5}, portal.turn);
    eye.x = portal.toX + 0.5 + fromMiddle.x;
    eye.y = portal.toY + 0.5 + fromMiddle.y;
    eye.z += portal.toLevel - portal.level;
    return eye;
}

const Portal* findPortal(const Map& map, const Tile& tile, int level) {
    for (const Portal& each : map.portals)
        if (each.x == tile.x && each.y == tile.y && each.level == level && each.face == tile.face)
            return &each;
    return nullptr;
}

// Draws what is behind a portal: the eye moves, the ray goes on at the same depth.
void lookThrough(const Slice& slice, const Tile& tile, const Placed& each, const Portal& portal) {
    const double upper = rowOf(slice, each.top, tile.near);
    Slice part = partOf(slice, upper, rowOf(slice, each.bottom, tile.near));
    part.map = &slice.world.maps[portal.toMap];
    part.portals = slice.portals + 1;
    part.eye = eyeBeyond(slice.eye, portal);
    part.view.forward = turned(slice.view.forward, portal.turn);
    part.view.right = turned(slice.view.right, portal.turn);
    part.ray = turned(slice.ray, portal.turn);
    part.from = {portal.toX, portal.toY, tile.near};
    part.lowest = slice.lowest + portal.toLevel - portal.level;
    if (part.first < part.last) drawPart(part);
}

// Draws the sides between two tiles: those that the ray leaves, then those that it enters.
void drawBorder(const Slice& slice, const Tile& before, const Tile& tile) {
    const Face left = std::array{south, west, north, east}[tile.face];
    for (const Placed& each : before.blocks)
        if (!isJoined(each, tile.blocks, each.level)) drawSide(slice, tile, left, each);
    for (const Placed& each : tile.blocks) {
        const Portal* portal = findPortal(*slice.map, tile, each.level);
        if (portal && slice.portals < slice.world.portalLimit)
            lookThrough(slice, tile, each, *portal);
        if (!isJoined(each, before.blocks, each.level)) drawSide(slice, tile, tile.face, each);
    }
}

// Draws what a slice shows of one map: the nearest tile first, and in the end the sky.
void drawPart(const Slice& slice) {
    const std::vector<Seen> objects = objectsOf(slice);
    auto object = objects.begin();
    const char* const open = slice.column.open.data();
    Tile before = {-1, -1};
    for (Tile& tile : walkGrid(*slice.map, slice.eye, slice.ray, slice.from)) {
        tile.blocks = blocksOf(*slice.map, tile.x, tile.y, slice.lowest);
        if (tile.face != none) drawBorder(slice, before, tile);
        const std::vector<Plane> planes = planesOf(slice, tile);
        double near = tile.near;
        // Each object parts its tile: what lies before it comes first.
        for (; object != objects.end() && object->depth < tile.far; ++object) {
            for (const Plane& plane : planes) drawPlane(slice, plane, near, object->depth);
            drawObject(slice, *object);
            near = object->depth;
        }
        for (const Plane& plane : planes) drawPlane(slice, plane, near, tile.far);
        if (std::count(open + slice.first, open + slice.last, 1) == 0) return;
        before = tile;
    }
    const auto sky = [&](int row) { return skyColour(*slice.map, slopeOf(slice, row)); };
    fillRows(slice, slice.first, slice.last, sky);
}

// How far a motion has moved its block up: there in half a period, and back in the other half.
double wayOf(const Motion& motion, double seconds) {
    const double at = std::fmod(seconds / motion.period + motion.phase, 1.0);
    double way = 2.0 * std::min(at, 1.0 - at);
    if (motion.shape == 2) way = std::clamp(2.0 * way - 0.5, 0.0, 1.0);
    if (motion.shape != 1) way = 3.0 * way * way - 2.0 * way * way * way;
    return std::floor((motion.from + (motion.to - motion.from) * way) * 65536.0 + 0.5) / 65536.0;
}

void moveBlocks(World& world) {
    for (Map& map : world.maps)
        for (auto& [bottom, top, seeThrough, join, faces, motion, moved] : map.blocks) {
            if (motion.moves == 0) continue;
            moved = wayOf(motion, world.seconds);
            if (motion.moves != 1) bottom = motion.bottom + moved;
            if (motion.moves != 2) top = motion.top + moved;
        }
}

void draw(Picture& picture, World& world, const Eye& eye) {
    moveBlocks(world);
    const View view = makeView(picture, eye);
    const Tile from = {static_cast<int>(std::floor(eye.x)), static_cast<int>(std::floor(eye.y))};
    for (int number = 0; number < picture.width; ++number) {
        Column column = {picture, number, std::vector<char>(picture.height, 1)};
        const Map* map = &world.maps[eye.map];
        drawPart({world, column, map, eye, view, rayOf(view, number), from, 0, picture.height});
        layOver(column);
    }
}

}  // namespace

int main(int count, char** arguments) {
    Numbers numbers(count == 2 ? arguments[1] : "");
    if (numbers.isAtEnd()) return std::fputs("usage: raycaster WORLD >PICTURES\n", stderr), 1;
    World world = numbers.world();
    while (!numbers.isAtEnd()) {
        Picture picture = {numbers.whole(), numbers.whole(), {}};
        picture.pixels.resize(picture.width * picture.height);
        draw(picture, world, numbers.eye());
        std::fwrite(picture.pixels.data(), 4, picture.pixels.size(), stdout);
    }
}
