// Part of the plain walk: objects, and which texels of objects and sides are visible.
#include "plain_walk.h"

#include "base/bits.h"

#include <algorithm>

namespace slicecast {
namespace {

// Rounding may put a point on the border of two texels just before it: positions are moved on by
// this part of a tile.
constexpr double kSnap = 1.0 / 17179869184.0;

constexpr double kOne = static_cast<double>(kWholeTexture);

// The first position in a column of texels and its step per row; positions stay in [lowest, end).
struct Positions {
    double start;
    double step;
    std::int64_t lowest;
    std::int64_t end;
};
void place(TexelColumn& column, const Positions& at, int rows) {
    const auto within = [&](double position) {
        return nearestInteger(std::clamp(position, 0.0, static_cast<double>(at.end)));
    };
    const std::int64_t start = std::clamp(within(at.start), at.lowest, at.end - 1);
    column.start = static_cast<std::uint64_t>(start);
    column.step = 0;
    if (rows > 1)
        column.step = static_cast<std::uint64_t>(
            std::min(within(at.step), (at.end - 1 - start) / (rows - 1)));
}

// Where a column's ray passes an object, as a part of its width from the left.
double across(const FrameObject& object, const Projection& projection, int column) {
    return (projection.sidewaysSlope(column) * object.depth - object.left) / object.width;
}

}  // namespace

// Finds the objects that the column's rays pass, from the start of the part on.
void PlainWalk::findObjects() {
    objects_.clear();
    for (const int i : part_.vista->objects.inColumn(column_, 0.0, kNever).objects) {
        const FrameObject& object = part_.vista->objects[i];
        const double share = across(object, projection(), column_);
        if (object.along >= walk_.entered && share >= 0.0 && share < 1.0)
            objects_.push_back(&object);
    }
}

// The ray at an object's depth, which is not a tile border.
Crossing PlainWalk::crossingAt(const FrameObject& object) const {
    Crossing at;
    at.along = object.along;
    at.distance = object.depth;
    at.speed = projection().distance;
    at.border = false;
    return at;
}

// A row exactly through the lower edge is on the object, one through its upper edge is not.
void PlainWalk::meetObject(const FrameObject& object) {
    const auto rowAt = [&](std::int32_t rise, bool tieIsBelow) {
        return FrameObjects::firstRowBelow(projection(), rise, object.depth, tieIsBelow);
    };
    const HeightClip& clip = part_.clip;
    const Rows rows = {object.top <= clip.high ? object.firstRow : rowAt(clip.high, true),
                       object.bottom >= clip.low ? object.lastRow : rowAt(clip.low, false)};
    const SpriteLevel& level = *object.level;
    const double share = across(object, projection(), column_);
    const int u = std::min(level.width - 1, static_cast<int>(share * level.width));
    Span span = spanOf(What::object);
    span.layer = true;
    span.object = object.index;
    span.image = map().objects[static_cast<std::size_t>(object.index)].sprite;
    span.column = {.texels = level.texels.data() + static_cast<std::ptrdiff_t>(u) * level.height,
                   .start = 0,
                   .step = 0,
                   .depth = object.depth,
                   .factor = object.factor,
                   .fog = object.fog,
                   .shift = 32,
                   .detail = object.detail};
    const std::int64_t end = static_cast<std::int64_t>(level.height) << 32;
    const double perUnit = static_cast<double>(end) / ((object.top - object.bottom) / 65536.0);
    show(span, rows, [&](Span& seen) {
        const double down =
            object.top / 65536.0 - (projection().horizon - (seen.first + 0.5)) * object.along;
        place(seen.column, {down * perUnit, object.along * perUnit, 0, end},
              seen.last - seen.first);
    });
}

void PlainWalk::showSide(const Block& block, Face face, const Crossing& border, Rows rows) {
    if (block.blueprint->face(face).texture == kNoTexture) return;
    Span span = spanOf(What::side);
    span.face = face;
    span.level = block.level;
    span.layer = block.blueprint->seeThrough;
    span.glow = block.blueprint->face(face).glow;
    span.rise = block.blueprint->textureRise;
    span.slide = border.alongX ? block.blueprint->textureSouth : block.blueprint->textureEast;
    span.image = block.blueprint->face(face).texture;
    span.along = alongSide(block, border);
    show(span, rows, [&](Span& seen) {
        seen.column = sideColumn(block, face, border, {seen.first, seen.last});
        splitWhereTextureEnds(seen);
    });
}

// The texture of a moving side may end within it and start again: the rows from there on become a
// span of their own.
void PlainWalk::splitWhereTextureEnds(Span& seen) {
    if (seen.column.start >= kWholeTexture) seen.column.start -= kWholeTexture;
    Span rest = seen;
    while (rest.first < rest.last && rest.column.start < kWholeTexture) {
        ++rest.first;
        rest.column.start += rest.column.step;
    }
    if (rest.first == rest.last) return;
    rest.column.start -= kWholeTexture;
    seen.last = rest.first;
    found_->spans.add() = rest;
}

// Where the ray meets a side, from the tile's northern or western end, in 1/2^32 of the tile. Only
// what the block covers.
std::uint32_t PlainWalk::alongSide(const Block& block, const Crossing& border) const {
    const Viewpoint& eye = part_.vista->viewpoint;
    const GroundDirection ray = part_.vista->ray(column_);
    const double fraction = border.alongX ? eye.fractionY() + (eye.tileY() - walk_.tileY) +
                                                ray.y * border.distance / border.speed
                                          : eye.fractionX() + (eye.tileX() - walk_.tileX) +
                                                ray.x * border.distance / border.speed;
    const Plan& plan = block.blueprint->plan;
    const Coordinate from = border.alongX ? plan.north : plan.west;
    const Coordinate to = border.alongX ? plan.south : plan.east;
    const auto bits = [](Coordinate edge) { return std::int64_t{edge.raw} << 16; };
    return static_cast<std::uint32_t>(
        std::clamp(static_cast<std::int64_t>(std::clamp(fraction + kSnap, 0.0, 1.0) * 4294967296.0),
                   bits(from), bits(to) - 1));
}

// The texels of a side that the rows show, and their light.
TexelColumn PlainWalk::sideColumn(const Block& block, Face face, const Crossing& border,
                                  Rows rows) const {
    const Vista& vista = *part_.vista;
    const FaceBlueprint& look = block.blueprint->face(face);
    const FrameTexture& texture = frame_.textures[look.texture];
    TexelColumn column;
    column.depth = border.along * projection().distance;
    column.detail = frame_.detail.levelAt(column.depth, texture.size, texture.last);
    column.factor = vista.lighting.factorAt(column.depth, look.light, look.glow);
    column.fog = vista.lighting.fogAt(column.depth);

    const TextureLevel& level = texture.levels[column.detail];
    // The texture may have slid along
    const Coordinate slide =
        border.alongX ? block.blueprint->textureSouth : block.blueprint->textureEast;
    const std::int64_t along = alongSide(block, border) - (std::int64_t{slide.raw} << 16);
    int u = static_cast<int>((along & 0xffffffff) * level.size >> 32);
    if (face == Face::north || face == Face::east) u = level.size - 1 - u;
    column.texels = level.texels.data() + static_cast<std::ptrdiff_t>(u) * level.size;
    column.shift = kTexturePositionBits - level.bits;

    // How far below the level's upper edge, limited to the block
    const double upperEdge = riseOf(tileEdge(block.level + 1).raw) / 65536.0;
    const double down =
        upperEdge + (rows.first + 0.5 - projection().horizon) * border.along + kSnap;
    const auto positionOf = [](Coordinate height) {
        return (std::int64_t{65536} - height.raw) << (kTexturePositionBits - 16);
    };
    place(column,
          {down * kOne, border.along * kOne, positionOf(block.blueprint->top),
           positionOf(block.blueprint->bottom)},
          rows.last - rows.first);
    // A risen block shows its texture moved up
    column.start += static_cast<std::uint64_t>(block.blueprint->textureRise.raw)
                    << (kTexturePositionBits - 16);
    return column;
}

}  // namespace slicecast
