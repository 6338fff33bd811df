#include "render/slice.h"

#include "render/column_fill.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace slicecast {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double units(std::int32_t raw) { return raw / 65536.0; }

// A point that lies on the border of two texels exactly may come out a rounding before it: positions are moved by this much of a tile, far less than a pixel
// and far more than a rounding.
constexpr double kSnap = 1.0 / 17179869184.0;

// A walk that stops at a border must be past it for certain: by more than roundings.
constexpr double kBeyond = 1.0 + 1.0 / 1099511627776.0;

// The column of texels at a fraction of a tile, eastward or southward.
int texelColumn(double fraction, int size, bool reversed) {
    const int index = std::min(size - 1, static_cast<int>(std::max(0.0, fraction + kSnap) * size));
    return reversed ? size - 1 - index : index;
}

}  // namespace

Slice::Slice(const Frame& frame, OpenRows& open, FrameReport& report)
    : frame_(frame), map_(*frame.map), projection_(frame.projection), open_(open), report_(report), walk_({}, {}, {}) {}

void Slice::draw(int column, Pixel* pixels, SliceTrace* trace) {
    column_ = column;
    pixels_ = pixels;
    trace_ = trace;
    ray_ = projection_.ray(column);
    walk_ = GridWalk(frame_.eye.x, frame_.eye.y, ray_);
    open_.openAll(projection_.height);
    if (trace_) {
        trace_->column = column;
        trace_->rayX = ray_.x / projection_.distance;
        trace_->rayY = ray_.y / projection_.distance;
        trace_->horizonRow = projection_.horizon;
        trace_->projectionDistance = projection_.distance;
    }
    walk();
    drawBackground();
}

void Slice::walk() {
    floor_ = {map_.floor.texture, walk_.enter, walk_.tileX, walk_.tileY};
    ceiling_ = {};
    const TextureId* ceilingTiles = map_.ceiling.tiles.empty() ? nullptr : map_.ceiling.tiles.data();
    double stop = whereToStop();
    bool stopped = false;

    while (!open_.none()) {
        if (walk_.enter.along > stop) {
            stopped = true;
            break;
        }
        if (!map_.contains(walk_.tileX, walk_.tileY)) {
            // Outside the grid there is only the floor. The walk goes on while it may still come to the grid.
            const bool leavesX = walk_.tileX < 0 ? walk_.stepX <= 0 : walk_.tileX >= map_.width && walk_.stepX >= 0;
            const bool leavesY = walk_.tileY < 0 ? walk_.stepY <= 0 : walk_.tileY >= map_.depth && walk_.stepY >= 0;
            if (leavesX || leavesY) break;
            ++report_.tilesWalked;
            walk_.advance();
            continue;
        }
        ++report_.tilesWalked;
        if (trace_) traceTile();
        const std::size_t tile = map_.tileIndex(walk_.tileX, walk_.tileY);
        const bool floorChanges = map_.floor.tiles[tile] != floor_.texture;
        const std::uint32_t occupied = map_.occupied[tile];
        if (ceilingTiles) {
            // Where blocks stand, the ceiling of that tile takes its turn among them. A floor must not be drawn before the ceiling above it.
            const TextureId texture = occupied ? kNoTexture : ceilingTiles[tile];
            if (texture != ceiling_.texture || floorChanges) {
                endCeiling(walk_.enter, boxToPrevious(ceiling_));
                ceiling_ = {texture, walk_.enter, walk_.tileX, walk_.tileY};
                stop = whereToStop();
            }
        }
        if (floorChanges) {
            endFloor(walk_.enter, boxToPrevious(floor_));
            floor_ = {map_.floor.tiles[tile], walk_.enter, walk_.tileX, walk_.tileY};
        }
        if (occupied) {
            drawBlocks(occupied, ceilingTiles ? ceilingTiles[tile] : kNoTexture);
            stop = whereToStop();
        }
        walk_.advance();
    }

    // What is left beyond the walk: the ceiling ends with the grid, the floor goes on outside it.
    endCeiling(walk_.enter, boxToPrevious(ceiling_));
    if (!stopped && floor_.texture != map_.floor.texture) {
        endFloor(walk_.enter, boxToPrevious(floor_));
        floor_ = {map_.floor.texture, walk_.enter, walk_.tileX, walk_.tileY};
    }
    endFloor(Crossing::never(), boxWithoutEnd(floor_));
}

// How far along the ray to walk; beyond, nothing but the floor that is under way and the sky can be met. When all open rows look down, that at which the flattest of them
// meets the floor; when all look up, that at which the flattest of them is above everything.
double Slice::whereToStop() const {
    if (open_.none()) return 0.0;
    const int firstFalling = projection_.firstFallingRow;
    if (open_.first() >= firstFalling) return kBeyond * frame_.eye.z.value() * frame_.inverseOffsets[static_cast<std::size_t>(open_.first())];
    if (open_.last() > firstFalling) return kNever;
    const double rise = frame_.highest - frame_.eye.z.value();
    return rise <= 0.0 ? 0.0 : kBeyond * rise * frame_.inverseOffsets[static_cast<std::size_t>(open_.last() - 1)];
}

int Slice::collectBlocks(std::uint32_t occupied, std::array<Block, kMaxLevels>& blocks) const {
    const BlueprintId* cells = map_.cells.data() + map_.cellIndex(walk_.tileX, walk_.tileY, 0);
    const std::int32_t eyeHeight = frame_.eye.z.raw;
    int count = 0;
    for (std::uint32_t rest = occupied; rest != 0; rest &= rest - 1) {
        const int level = std::countr_zero(rest);
        const CellBlueprint& blueprint = frame_.world->blueprints[cells[level]];
        const std::int32_t base = tileEdge(level).raw - eyeHeight;
        Block& block = blocks[static_cast<std::size_t>(count++)];
        block.blueprint = &blueprint;
        block.level = level;
        block.bottomRaw = base + blueprint.bottom.raw;
        block.topRaw = base + blueprint.top.raw;
        block.bottom = units(block.bottomRaw);
        block.top = units(block.topRaw);
        block.hit = -1;
    }
    return count;
}

// Everything in one tile that holds blocks, nearest first: sides where the walk enters, then roofs from the eye's height downwards and undersides from it
// upwards. The floor comes last, with the run that it belongs to.
void Slice::drawBlocks(std::uint32_t occupied, TextureId ceilingTexture) {
    std::array<Block, kMaxLevels> blocks;
    const int count = collectBlocks(occupied, blocks);
    report_.blocksMet += count;
    if (trace_) {
        for (int i = 0; i < count; ++i) traceBlock(blocks[static_cast<std::size_t>(i)]);
    }
    if (walk_.enter.along > 0.0) drawSides(blocks.data(), count);
    if (!open_.none() && open_.last() > projection_.firstFallingRow) drawFalling(blocks.data(), count, ceilingTexture);
    if (!open_.none() && open_.first() < projection_.firstFallingRow) drawRising(blocks.data(), count, ceilingTexture);
}

void Slice::drawSides(const Block* blocks, int count) {
    const Crossing& border = walk_.enter;
    const Face face = enteredFace(border);
    for (int i = 0; i < count; ++i) {
        const Block& block = blocks[i];
        const int first = firstRowBelow(projection_, block.top, border);
        const int last = firstRowBelow(projection_, block.bottom, border);
        drawSide(block, face, border, {first, last});
    }
}

// Rows that look down. At depth 0 the eye may be inside a block, or on its roof: a face met at depth 0 is not drawn, so the ray is inside the block then and
// leaves it downwards or through the far side.
void Slice::drawFalling(const Block* blocks, int count, TextureId ceilingTexture) {
    const double ceilingRise = units(map_.ceiling.height.raw - frame_.eye.z.raw);
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise < 0.0;
    const auto ceilingAbove = [&](double height) {
        if (ceilingToCome && ceilingRise > height) {
            drawCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    for (int i = count - 1; i >= 0; --i) {
        const Block& block = blocks[i];
        if (walk_.enter.along == 0.0 && block.bottom < 0.0 && block.top >= 0.0) {
            ceilingAbove(block.bottom);
            const int below = firstRowBelow(projection_, block.bottom, walk_.leave);
            drawLevelFace(block, Face::bottom, {std::max(below, projection_.firstFallingRow), projection_.height});
            if (walk_.leave.along > 0.0) drawSide(block, leftFace(walk_.leave), walk_.leave, {projection_.firstFallingRow, below});
        } else if (block.top < 0.0) {
            ceilingAbove(block.top);
            drawLevelFace(block, Face::top, planeRows(block.top, walk_.enter, walk_.leave));
        }
    }
    ceilingAbove(-kNever);
}

// Rows that look up or run level; the same upside down.
void Slice::drawRising(const Block* blocks, int count, TextureId ceilingTexture) {
    const double ceilingRise = units(map_.ceiling.height.raw - frame_.eye.z.raw);
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise > 0.0;
    const auto ceilingBelow = [&](double height) {
        if (ceilingToCome && ceilingRise < height) {
            drawCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    for (int i = 0; i < count; ++i) {
        const Block& block = blocks[i];
        if (walk_.enter.along == 0.0 && block.bottom <= 0.0 && block.top > 0.0) {
            ceilingBelow(block.top);
            const int below = firstRowBelow(projection_, block.top, walk_.leave);
            drawLevelFace(block, Face::top, {0, std::min(below, projection_.firstFallingRow)});
            if (walk_.leave.along > 0.0) drawSide(block, leftFace(walk_.leave), walk_.leave, {below, projection_.firstFallingRow});
        } else if (block.bottom > 0.0) {
            ceilingBelow(block.bottom);
            drawLevelFace(block, Face::bottom, planeRows(block.bottom, walk_.enter, walk_.leave));
        }
    }
    ceilingBelow(kNever);
}

void Slice::drawSide(const Block& block, Face face, const Crossing& border, RowRange rows) {
    open_.take(rows.first, rows.last, [&](int first, int last) {
        const FaceBlueprint& look = block.blueprint->face(face);
        const Texture& texture = frame_.world->textures[look.texture];
        const double depth = border.along * projection_.distance;
        const TextureLevel& level = texture.levels[static_cast<std::size_t>(frame_.detail.levelAt(depth, texture))];

        // Which column of texels: along x on the northern and southern faces, along y on the others; reversed where the other end is on the left.
        const double fraction = border.alongX ? frame_.eye.y.fraction() + (frame_.eye.y.tile() - walk_.tileY) + ray_.y * border.distance / border.speed
                                              : frame_.eye.x.fraction() + (frame_.eye.x.tile() - walk_.tileX) + ray_.x * border.distance / border.speed;
        const int u = texelColumn(fraction, level.size, face == Face::north || face == Face::east);

        // v runs from 0 at the level's upper edge to 1 at its lower edge; it stays within what the block covers of the level.
        constexpr double kPositions = 281474976710656.0;  // 1 << kTexturePositionBits
        constexpr std::int64_t kPositionsPerRaw = std::int64_t{1} << (kTexturePositionBits - 16);
        const std::int64_t lowest = (65536 - block.blueprint->top.raw) * kPositionsPerRaw;
        const std::int64_t end = (65536 - block.blueprint->bottom.raw) * kPositionsPerRaw;
        const double perRow = border.along;
        const double upperEdge = units(tileEdge(block.level + 1).raw - frame_.eye.z.raw);
        const double v = upperEdge + (first + 0.5 - projection_.horizon) * perRow + kSnap;
        const std::int64_t start = std::clamp(v <= 0.0 ? 0 : v >= 1.0 ? end : static_cast<std::int64_t>(v * kPositions), lowest, end - 1);
        const int steps = last - first - 1;
        std::int64_t step = steps > 0 ? static_cast<std::int64_t>(perRow * kPositions) : 0;
        if (start + steps * step >= end) step = (end - 1 - start) / steps;

        fillSide(pixels_ + first, last - first, level, u, static_cast<std::uint64_t>(start), static_cast<std::uint64_t>(step),
                 frame_.lighting.at(depth, look.light), frame_.lighting.haze);
        note(&block, FilledRows::What::side, face, first, last);
    });
}

void Slice::drawLevelFace(const Block& block, Face face, RowRange rows) {
    open_.take(rows.first, rows.last, [&](int first, int last) {
        const bool isTop = face == Face::top;
        fillPlaneRows(first, last, isTop ? block.topRaw : block.bottomRaw, block.blueprint->face(face), !isTop,
                      boxTo(walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY));
        note(&block, isTop ? FilledRows::What::roof : FilledRows::What::underside, face, first, last);
    });
}

void Slice::drawCeilingHere(TextureId texture) {
    ceiling_ = {texture, walk_.enter, walk_.tileX, walk_.tileY};
    endCeiling(walk_.leave, boxTo(walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY));
}

// Draws the floor's run up to a border. Rows beyond the map's `far` are left for the haze.
void Slice::endFloor(const Crossing& border, const TileBox& box) {
    const RowRange rows = planeRows(-frame_.eye.z.value(), floor_.from, border);
    open_.take(std::max(rows.first, frame_.firstFloorRow), rows.last, [&](int first, int last) {
        fillPlaneRows(first, last, -frame_.eye.z.raw, {floor_.texture, map_.floor.light}, false, box);
        note(nullptr, FilledRows::What::floor, Face::top, first, last);
    });
}

// Draws the ceiling's run, if there is one, up to a border. At the eye's own height it cannot be seen.
void Slice::endCeiling(const Crossing& border, const TileBox& box) {
    const std::int32_t rise = map_.ceiling.height.raw - frame_.eye.z.raw;
    if (ceiling_.texture != kNoTexture && rise != 0) {
        const RowRange rows = planeRows(units(rise), ceiling_.from, border);
        open_.take(rows.first, rows.last, [&](int first, int last) {
            fillPlaneRows(first, last, rise, {ceiling_.texture, map_.ceiling.light}, true, box);
            note(nullptr, FilledRows::What::ceiling, Face::bottom, first, last);
        });
    }
    ceiling_.texture = kNoTexture;
}

void Slice::drawBackground() {
    open_.take(0, projection_.firstFallingRow, [&](int first, int last) {
        frame_.skyRows.fill(pixels_, column_, first, last);
        note(nullptr, FilledRows::What::sky, Face::top, first, last);
    });
    open_.take(projection_.firstFallingRow, projection_.height, [&](int first, int last) {
        std::fill(pixels_ + first, pixels_ + last, frame_.lighting.haze);
        note(nullptr, FilledRows::What::haze, Face::top, first, last);
    });
}

// The rows in which the plane `rise` above the eye (below it where negative; not 0) is met between two borders.
Slice::RowRange Slice::planeRows(double rise, const Crossing& from, const Crossing& to) const {
    const int near = firstRowBelow(projection_, rise, from);
    const int far = firstRowBelow(projection_, rise, to);
    return rise < 0.0 ? RowRange{far, near} : RowRange{near, far};
}

Slice::TileBox Slice::boxTo(int fromX, int fromY, int toX, int toY) const {
    const int eyeX = frame_.eye.x.tile();
    const int eyeY = frame_.eye.y.tile();
    return {static_cast<double>(std::min(fromX, toX) - eyeX), static_cast<double>(std::max(fromX, toX) + 1 - eyeX),
            static_cast<double>(std::min(fromY, toY) - eyeY), static_cast<double>(std::max(fromY, toY) + 1 - eyeY)};
}

// A run whose last tile is the one that the walk has just left.
Slice::TileBox Slice::boxToPrevious(const PlaneRun& run) const {
    const bool alongX = walk_.enter.alongX;
    return boxTo(run.fromX, run.fromY, walk_.tileX - (alongX ? walk_.stepX : 0), walk_.tileY - (alongX ? 0 : walk_.stepY));
}

// A run that goes on in the ray's direction for ever.
Slice::TileBox Slice::boxWithoutEnd(const PlaneRun& run) const {
    TileBox box = boxTo(run.fromX, run.fromY, run.fromX, run.fromY);
    if (walk_.stepX > 0) box.eastEnd = kNever;
    if (walk_.stepX < 0) box.east = -kNever;
    if (walk_.stepY > 0) box.southEnd = kNever;
    if (walk_.stepY < 0) box.south = -kNever;
    return box;
}

// Rows of a level plane, split where the level of detail changes. The first and the last row may lie within a rounding of their tiles' border: their texel is
// held inside it, so that never a texel of the far side of the texture shows.
void Slice::fillPlaneRows(int first, int last, std::int32_t riseRaw, const FaceBlueprint& face, bool southReversed, const TileBox& box) {
    const Texture& texture = frame_.world->textures[face.texture];
    const double distance = units(riseRaw < 0 ? -riseRaw : riseRaw);
    const PlaneLine line = {frame_.eye.x.fraction(), frame_.eye.y.fraction(), distance * ray_.x, distance * ray_.y, southReversed};
    const PlaneRows rows = frame_.planeShades.rows(riseRaw, face.light, first, last);
    const auto levelAt = [&](int row) { return frame_.detail.levelAt(distance * projection_.distance * rows.inverseOffsets[row], texture); };

    for (int row = first; row < last;) {
        const int level = levelAt(row);
        int end = last;
        if (levelAt(last - 1) != level) {
            int same = row;  // the last row known to have this level; the first known not to is `end`
            end = last - 1;
            while (end - same > 1) {
                const int middle = same + (end - same) / 2;
                (levelAt(middle) == level ? same : end) = middle;
            }
        }
        fillPlane(pixels_, row, end, texture.levels[static_cast<std::size_t>(level)], line, rows, frame_.lighting.haze);
        row = end;
    }
    fillClampedRow(first, texture.levels[static_cast<std::size_t>(levelAt(first))], line, rows, box);
    if (last - first > 1) fillClampedRow(last - 1, texture.levels[static_cast<std::size_t>(levelAt(last - 1))], line, rows, box);
}

void Slice::fillClampedRow(int row, const TextureLevel& level, const PlaneLine& line, const PlaneRows& rows, const TileBox& box) {
    const double inverse = rows.inverseOffsets[row];
    const double east = line.eastStart + line.eastPerInverse * inverse;
    const double south = line.southStart + line.southPerInverse * inverse;
    // Half a step of the fraction that is kept; nearer to the end than that, it would round up to the next tile.
    constexpr double kHalfStep = 1.0 / 8589934592.0;
    const bool eastInside = east >= box.east && east < box.eastEnd - kHalfStep;
    const bool southInside = south >= box.south && south < box.southEnd - kHalfStep;
    if (eastInside && southInside) return;
    const auto held = [](double position, double first, double end, double start, double perInverse, double inverseOffset) {
        if (position < first) return std::uint32_t{0};
        if (position >= end - kHalfStep) return ~std::uint32_t{0};
        return PlaneLine::fractionBits(start, perInverse, inverseOffset);
    };
    const auto texelOf = [&](std::uint32_t bits) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(bits) >> (32 - level.bits)); };
    const std::uint32_t u = texelOf(held(east, box.east, box.eastEnd, line.eastStart, line.eastPerInverse, inverse));
    std::uint32_t v = texelOf(held(south, box.south, box.southEnd, line.southStart, line.southPerInverse, inverse));
    if (line.southReversed) v = static_cast<std::uint32_t>(level.size - 1) - v;
    pixels_[row] = shadedTexel(level.texels[(u << level.bits) | v], rows.factors[row] & 0xffff, rows.fogs ? rows.fogs[row] & 0xffff : 0, frame_.lighting.haze);
}

void Slice::note(const Block* block, FilledRows::What what, Face face, int first, int last) {
    ++report_.spansDrawn;
    if (!trace_) return;
    if (block) {
        trace_->hits[static_cast<std::size_t>(block->hit)].filled.push_back({what, face, first, last});
    } else {
        trace_->planes.push_back({what, face, first, last});
    }
}

void Slice::traceTile() { trace_->tiles.push_back({walk_.tileX, walk_.tileY, walk_.enter.along * projection_.distance}); }

void Slice::traceBlock(Block& block) {
    block.hit = static_cast<int>(trace_->hits.size());
    Hit hit;
    hit.map = frame_.eye.map;
    hit.tileX = walk_.tileX;
    hit.tileY = walk_.tileY;
    hit.level = block.level;
    hit.blueprint = map_.cell(walk_.tileX, walk_.tileY, block.level);
    hit.entered = walk_.enter.along > 0.0;
    hit.face = enteredFace(walk_.enter);
    hit.depth = walk_.enter.along * projection_.distance;
    hit.backDepth = walk_.leave.along * projection_.distance;
    hit.x = frame_.eye.x.value() + ray_.x * walk_.enter.along;
    hit.y = frame_.eye.y.value() + ray_.y * walk_.enter.along;
    hit.rawDepth = walk_.enter.along * std::sqrt(ray_.x * ray_.x + ray_.y * ray_.y);
    hit.bottom = tileEdge(block.level) + block.blueprint->bottom;
    hit.top = tileEdge(block.level) + block.blueprint->top;
    const auto rowOf = [&](double rise, double depth) { return rise == 0.0 ? projection_.horizon : projection_.rowOf(rise, depth); };
    hit.topFrontRow = rowOf(block.top, hit.depth);
    hit.bottomFrontRow = rowOf(block.bottom, hit.depth);
    hit.topBackRow = rowOf(block.top, hit.backDepth);
    hit.bottomBackRow = rowOf(block.bottom, hit.backDepth);
    trace_->hits.push_back(std::move(hit));
}

}  // namespace slicecast
