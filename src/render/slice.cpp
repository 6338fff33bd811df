#include "render/slice.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace slicecast {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// A walk that stops at a border must be past it for certain: by more than roundings.
constexpr double kBeyond = 1.0 + 1.0 / 1099511627776.0;

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
    floor_ = startRun(map_.floor.texture, projection_.height);
    ceiling_ = {};
    const TextureId* ceilingTiles = map_.ceiling.tiles.empty() ? nullptr : map_.ceiling.tiles.data();
    double stop = whereToStop();
    bool stopped = false;

    while (!open_.none()) {
        if (walk_.enter().along > stop) {
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
        const std::uint32_t occupied = levelsInReach(map_.occupied[tile]);
        if (ceilingTiles) {
            // Where blocks stand, the ceiling of that tile takes its turn among them. A floor must not be drawn before the ceiling above it.
            const TextureId texture = occupied ? kNoTexture : ceilingTiles[tile];
            if (texture != ceiling_.texture || floorChanges) {
                const int row = ceilingRow(walk_.enter());
                endCeiling(row);
                ceiling_ = startRun(texture, row);
                stop = whereToStop();
            }
        }
        if (floorChanges) {
            const int row = floorRow(walk_.enter());
            endFloor(row);
            floor_ = startRun(map_.floor.tiles[tile], row);
        }
        if (occupied) {
            drawBlocks(occupied, ceilingTiles ? ceilingTiles[tile] : kNoTexture);
            stop = whereToStop();
        }
        walk_.advance();
    }

    // What is left beyond the walk: the ceiling ends with the grid, the floor goes on outside it.
    if (ceiling_.texture != kNoTexture) endCeiling(ceilingRow(walk_.enter()));
    if (!stopped && floor_.texture != map_.floor.texture) {
        const int row = floorRow(walk_.enter());
        endFloor(row);
        floor_ = startRun(map_.floor.texture, row);
    }
    endFloor(frame_.firstFloorRow, true);
}

// How far along the ray to walk; beyond, nothing but the floor that is under way and the sky can be met. Rows that have met the floor by the current tile's far
// border are only waiting for their run to end. When all others look down, the walk goes to where the flattest of them meets the floor; when all look up, to where
// the flattest of them is above everything.
double Slice::whereToStop() const {
    const int firstFalling = projection_.firstFallingRow;
    const int firstWaiting = floorRow(walk_.leave());
    int last = 0;
    for (const OpenRows::Run& run : open_.runs()) {
        if (run.first < firstWaiting) last = std::min(run.last, firstWaiting);
    }
    if (last == 0) return 0.0;
    if (open_.first() >= firstFalling) return kBeyond * frame_.eye.z.value() * frame_.inverseOffsets[static_cast<std::size_t>(open_.first())];
    if (last > firstFalling) return kNever;
    const double rise = frame_.highest - frame_.eye.z.value();
    return rise <= 0.0 ? 0.0 : kBeyond * rise * frame_.inverseOffsets[static_cast<std::size_t>(last - 1)];
}

// Of the occupied levels of the current tile, those that an open row may meet: a run of rows passes the tile between the heights that its first and its last row
// have at the two borders. Most blocks of a town are behind others and are left out here without a division. A trace keeps them all.
std::uint32_t Slice::levelsInReach(std::uint32_t occupied) const {
    if (occupied == 0 || trace_) return occupied;
    constexpr double kSlack = 1.0 / 65536.0;  // units; far more than roundings
    const double eye = frame_.eye.z.value();
    const int first = std::countr_zero(occupied);
    const int end = static_cast<int>(std::bit_width(occupied));
    std::uint32_t reached = 0;
    for (const OpenRows::Run& run : open_.runs()) {
        const double upper = projection_.horizon - (run.first + 0.5);
        const double lower = projection_.horizon - (run.last - 0.5);
        const double highest = eye + upper * (upper > 0.0 ? walk_.leave().along : walk_.enter().along) + kSlack;
        const double lowest = eye + lower * (lower < 0.0 ? walk_.leave().along : walk_.enter().along) - kSlack;
        if (highest < first || lowest >= end) continue;
        if (lowest < first + 1 && highest >= end - 1) return occupied;
        const std::uint64_t upToHighest = highest >= kMaxLevels ? ~std::uint64_t{0} : (std::uint64_t{2} << static_cast<int>(highest)) - 1;
        const std::uint64_t belowLowest = lowest <= 0.0 ? 0 : (std::uint64_t{1} << static_cast<int>(lowest)) - 1;
        reached |= static_cast<std::uint32_t>(upToHighest & ~belowLowest);
    }
    return occupied & reached;
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
        block.bottom = Coordinate{block.bottomRaw}.value();
        block.top = Coordinate{block.topRaw}.value();
        block.hit = -1;
        const bool touchesLower = count > 1 && blocks[static_cast<std::size_t>(count - 2)].topRaw == block.bottomRaw;
        block.bottomFront = touchesLower ? blocks[static_cast<std::size_t>(count - 2)].topFront : firstRowBelow(projection_, block.bottom, walk_.enter());
        block.topFront = firstRowBelow(projection_, block.top, walk_.enter());
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
    if (walk_.enter().along > 0.0) drawSides(blocks.data(), count);
    if (!open_.none() && open_.last() > projection_.firstFallingRow) drawFalling(blocks.data(), count, ceilingTexture);
    if (!open_.none() && open_.first() < projection_.firstFallingRow) drawRising(blocks.data(), count, ceilingTexture);
}

void Slice::drawSides(const Block* blocks, int count) {
    const Face face = enteredFace(walk_.enter());
    for (int i = 0; i < count; ++i) drawSide(blocks[i], face, walk_.enter(), {blocks[i].topFront, blocks[i].bottomFront});
}

// Rows that look down. At depth 0 the eye may be inside a block, or on its roof: a face met at depth 0 is not drawn, so the ray is inside the block then and
// leaves it downwards or through the far side.
void Slice::drawFalling(const Block* blocks, int count, TextureId ceilingTexture) {
    const double ceilingRise = (map_.ceiling.height - frame_.eye.z).value();
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise < 0.0;
    const auto ceilingAbove = [&](double height) {
        if (ceilingToCome && ceilingRise > height) {
            drawCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    const int openFirst = open_.first();
    for (int i = count - 1; i >= 0; --i) {
        const Block& block = blocks[i];
        if (walk_.enter().along == 0.0 && block.bottom < 0.0 && block.top >= 0.0) {
            ceilingAbove(block.bottom);
            const int below = firstRowBelow(projection_, block.bottom, walk_.leave());
            drawLevelFace(block, Face::bottom, {std::max(below, projection_.firstFallingRow), projection_.height});
            if (walk_.leave().along > 0.0) drawSide(block, leftFace(walk_.leave()), walk_.leave(), {projection_.firstFallingRow, below});
        } else if (block.top < 0.0) {
            ceilingAbove(block.top);
            // Nothing reaches a roof on which the next block stands.
            const bool covered = i + 1 < count && blocks[i + 1].bottomRaw == block.topRaw;
            if (!covered && block.topFront > openFirst) drawLevelFace(block, Face::top, {firstRowBelow(projection_, block.top, walk_.leave()), block.topFront});
        }
    }
    ceilingAbove(-kNever);
}

// Rows that look up or run level; the same upside down.
void Slice::drawRising(const Block* blocks, int count, TextureId ceilingTexture) {
    const double ceilingRise = (map_.ceiling.height - frame_.eye.z).value();
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise > 0.0;
    const auto ceilingBelow = [&](double height) {
        if (ceilingToCome && ceilingRise < height) {
            drawCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    const int openLast = open_.last();
    for (int i = 0; i < count; ++i) {
        const Block& block = blocks[i];
        if (walk_.enter().along == 0.0 && block.bottom <= 0.0 && block.top > 0.0) {
            ceilingBelow(block.top);
            const int below = firstRowBelow(projection_, block.top, walk_.leave());
            drawLevelFace(block, Face::top, {0, std::min(below, projection_.firstFallingRow)});
            if (walk_.leave().along > 0.0) drawSide(block, leftFace(walk_.leave()), walk_.leave(), {below, projection_.firstFallingRow});
        } else if (block.bottom > 0.0) {
            ceilingBelow(block.bottom);
            const bool covered = i > 0 && blocks[i - 1].topRaw == block.bottomRaw;
            if (!covered && block.bottomFront < openLast) drawLevelFace(block, Face::bottom, {block.bottomFront, firstRowBelow(projection_, block.bottom, walk_.leave())});
        }
    }
    ceilingBelow(kNever);
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
    ceiling_ = startRun(texture, ceilingRow(walk_.enter()));
    endCeiling(ceilingRow(walk_.leave()), true);
}

Slice::PlaneRun Slice::startRun(TextureId texture, int row) const { return {texture, row, walk_.tileX, walk_.tileY}; }

// Draws the floor's run up to a border, where `row` is the first one below it. Rows beyond the map's `far` are left for the haze.
void Slice::endFloor(int row, bool endless) {
    open_.take(std::max(row, frame_.firstFloorRow), floor_.row, [&](int first, int last) {
        fillPlaneRows(first, last, -frame_.eye.z.raw, {floor_.texture, map_.floor.light}, false, endless ? boxWithoutEnd(floor_) : boxToPrevious(floor_));
        note(nullptr, FilledRows::What::floor, Face::top, first, last);
    });
}

// Draws the ceiling's run, if there is one, up to a border. At the eye's own height it cannot be seen.
void Slice::endCeiling(int row, bool inThisTile) {
    const std::int32_t rise = map_.ceiling.height.raw - frame_.eye.z.raw;
    if (ceiling_.texture != kNoTexture && rise != 0) {
        open_.take(std::min(ceiling_.row, row), std::max(ceiling_.row, row), [&](int first, int last) {
            fillPlaneRows(first, last, rise, {ceiling_.texture, map_.ceiling.light}, true,
                          inThisTile ? boxTo(walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY) : boxToPrevious(ceiling_));
            note(nullptr, FilledRows::What::ceiling, Face::bottom, first, last);
        });
    }
    ceiling_.texture = kNoTexture;
}

// The first row below the floor, or the ceiling, where a border is crossed.
int Slice::floorRow(const Crossing& border) const { return firstRowBelow(projection_, -frame_.eye.z.value(), border); }

int Slice::ceilingRow(const Crossing& border) const { return firstRowBelow(projection_, (map_.ceiling.height - frame_.eye.z).value(), border); }

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

Slice::TileBox Slice::boxTo(int fromX, int fromY, int toX, int toY) const {
    const int eyeX = frame_.eye.x.tile();
    const int eyeY = frame_.eye.y.tile();
    return {static_cast<double>(std::min(fromX, toX) - eyeX), static_cast<double>(std::max(fromX, toX) + 1 - eyeX),
            static_cast<double>(std::min(fromY, toY) - eyeY), static_cast<double>(std::max(fromY, toY) + 1 - eyeY)};
}

// A run whose last tile is the one that the walk has just left.
Slice::TileBox Slice::boxToPrevious(const PlaneRun& run) const {
    const bool alongX = walk_.enter().alongX;
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

}  // namespace slicecast
