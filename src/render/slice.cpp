#include "render/slice.h"

#include "base/bits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace slicecast {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// A walk that stops at a border must be past it for certain: by more than roundings.
constexpr double kBeyond = 1.0 + 1.0 / 1099511627776.0;

constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

}  // namespace

Slice::Slice(const Frame& frame, SliceMemory& memory, FrameReport& report)
    : frame_(frame),
      ownVista_(frame.vistas.ofEye()),
      memory_(memory),
      open_(memory.open),
      report_(report),
      walk_({}, {}, {}),
      tracedWalk_({}, {}, {}) {}

void Slice::draw(int column, Pixel* pixels, SliceTrace* trace) {
    column_ = column;
    pixels_ = pixels;
    trace_ = trace;
    layers_ = &memory_.layers;
    parts_ = &memory_.parts;
    waterFogs_ = frame_.vistas.waterFogs();
    parts_->clear();
    memory_.mirrors.clear();
    const Viewpoint& eye = ownVista_.viewpoint;
    const GroundDirection ray = ownVista_.ray(column);
    Part& whole = parts_->find(
        ownVista_,
        GridWalk({static_cast<std::int32_t>(eye.x)}, {static_cast<std::int32_t>(eye.y)}, ray), {},
        {}, 0, 0);
    whole.rows.assign(1, {0, ownVista_.projection->height});
    if (trace_) {
        trace_->column = column;
        trace_->rayX = ray.x / ownVista_.projection->distance;
        trace_->rayY = ray.y / ownVista_.projection->distance;
        trace_->horizonRow = ownVista_.projection->horizon;
        trace_->projectionDistance = ownVista_.projection->distance;
    }
    drawParts();
    if (!memory_.mirrors.empty()) reflect();
    if (!layers_->empty()) layOver();
}

// Each part may add further ones.
void Slice::drawParts() {
    for (part_ = 0; part_ < parts_->count(); ++part_) {
        begin((*parts_)[part_]);
        walk();
        fill(falling_);
        fill(rising_);
        drawBackground();
    }
}

void Slice::begin(const Part& part) {
    lookInto(*part.vista);
    open_.openOnly(part.rows, projection_->height);
    walk_ = part.walk;
    if (trace_) tracedWalk_ = walk_;
    clip_ = part.clip;
    clipped_ = clip_.any();
    portals_ = part.portals;
    startX_ = walk_.tileX;
    startY_ = walk_.tileY;
    before_ = part.before;
    const bool ceilingMet =
        !clipped_ || (clip_.isMirror ? ceilingRise_ > clip_.low
                                     : ceilingRise_ >= clip_.low && ceilingRise_ <= clip_.high);
    ceilingTiles_ =
        map_->ceiling.tiles.empty() || !ceilingMet ? nullptr : map_->ceiling.tiles.data();
    report_.deepestPortal = std::max(report_.deepestPortal, portals_);
    if (portals_ > 0) ++report_.partsBehindPortals;
}

void Slice::lookInto(Vista& vista) {
    ray_ = vista.ray(column_);
    if (vista_ == &vista) return;
    vista_ = &vista;
    map_ = vista.map;
    projection_ = vista.projection;
    hasTilePortals_ = !map_->tilePortals.empty();
    floorMirror_ = mirrorStrength(map_->floor.mirror);
    eyeTileX_ = vista.viewpoint.tileX();
    eyeTileY_ = vista.viewpoint.tileY();
    eyeFractionX_ = vista.viewpoint.fractionX();
    eyeFractionY_ = vista.viewpoint.fractionY();
    eyeZ_ = vista.viewpoint.z;
    eyeHeight_ = Coordinate{eyeZ_}.value();
    const int eyeLevel = std::min(eyeZ_ >> 16, kMaxLevels - 1);
    levelsToEye_ =
        eyeLevel < 0 ? 0 : static_cast<std::uint32_t>((std::uint64_t{2} << eyeLevel) - 1);
    floorRise_ = -eyeZ_;
    ceilingRise_ = map_->ceiling.height.raw - eyeZ_;
}

void Slice::walk() {
    floor_ = {map_->floor.texture, projection_->height, walk_.tileX, walk_.tileY};
    ceiling_ = {};
    object_ = objectsEnd_ = nullptr;
    if (!vista_->objects.none()) {
        const std::vector<int>& objects = vista_->objects.inColumn(column_);
        object_ = objects.data();
        objectsEnd_ = object_ + objects.size();
        while (object_ != objectsEnd_ && vista_->objects[*object_].along < walk_.entered) ++object_;
    }
    Pass pass = passTiles(false);
    while (pass == Pass::tile) {
        enter_ = walk_.enter();
        leave_ = walk_.leave();
        enteredSideKnown_ = false;
        drawTile();
        if (open_.none()) break;
        pass = passTiles(true);
    }
    const bool stopped = pass == Pass::stopped;
    enter_ = walk_.enter();

    // What is left beyond the walk: the ceiling ends with the grid, the floor goes on outside it.
    endCeiling(Border::enter);
    if (pass == Pass::portal) return enterPortalTile();
    if (!stopped && floor_.texture != map_->floor.texture) {
        takeFloor(Border::enter);
        floor_.texture = map_->floor.texture;
    }
    if (pass == Pass::left) drawObjectsBeyond();
    takeFloorBeyond(0);
}

// How far along the ray to walk: beyond, nothing but the floor that is under way and the sky can be
// met. When all open rows look down, that is where the flattest of them meets the floor; when all
// look up, where the flattest of them is above everything but portal tiles, which act at all
// heights.
double Slice::whereToStop() const {
    if (open_.none()) return 0.0;
    const int firstFalling = projection_->firstFallingRow;
    if (open_.first() >= firstFalling)
        return kBeyond * eyeHeight_ *
               vista_->inverseOffsets[static_cast<std::size_t>(open_.first())];
    if (open_.last() > firstFalling || hasTilePortals_) return kNever;
    const double rise = vista_->highest - eyeHeight_;
    return rise <= 0.0 ? 0.0
                       : kBeyond * rise *
                             vista_->inverseOffsets[static_cast<std::size_t>(open_.last() - 1)];
}

// Walks on over tiles where nothing changes: no other floor or ceiling, and no block that an open
// row may meet.
template <bool portals>
Slice::Pass Slice::passTilesWith(bool leaveFirst) {
    if (object_ != objectsEnd_) skipHiddenObjects();
    constexpr double kSlack = 1.0 / 65536.0;  // units; far more than roundings
    const double stop = whereToStop();
    const double highestEye = eyeHeight_ + kSlack;
    const double lowestEye = eyeHeight_ - kSlack;
    const double upper = projection_->horizon - open_.first();
    const double lower = projection_->horizon - open_.last();
    const TextureId* const floorTiles = map_->floor.tiles.data();
    const TextureId* const ceilingTiles = ceilingTiles_;
    const std::uint32_t* const occupiedTiles = map_->occupied.data();
    const TextureId floorTexture = floor_.texture;
    const TextureId ceilingTexture = ceiling_.texture;
    const auto width = static_cast<unsigned>(map_->width);
    const auto depth = static_cast<unsigned>(map_->depth);
    const double objectAlong = object_ == objectsEnd_ ? kNever : vista_->objects[*object_].along;
    const bool trace = trace_ != nullptr;
    GridWalk walk = walk_;
    std::uint32_t reached = 0;
    int tiles = 0;
    Pass pass = Pass::tile;
    for (bool leave = leaveFirst;; leave = true) {
        if (leave) walk.advance();
        if (walk.entered > stop) {
            pass = Pass::stopped;
            break;
        }
        if (static_cast<unsigned>(walk.tileX) >= width ||
            static_cast<unsigned>(walk.tileY) >= depth) {
            // Outside the grid there is only the floor. The walk goes on while it may still come to
            // the grid.
            const bool leavesX =
                walk.tileX < 0 ? walk.stepX <= 0 : walk.tileX >= map_->width && walk.stepX >= 0;
            const bool leavesY =
                walk.tileY < 0 ? walk.stepY <= 0 : walk.tileY >= map_->depth && walk.stepY >= 0;
            if (leavesX || leavesY) {
                pass = Pass::left;
                break;
            }
            ++tiles;
            if (walk.left() > objectAlong) break;
            continue;
        }
        ++tiles;
        if (trace) traceTile(walk.tileX, walk.tileY, walk.entered);
        const std::size_t tile =
            static_cast<std::size_t>(walk.tileY) * width + static_cast<std::size_t>(walk.tileX);
        if constexpr (portals) {
            if (leave && map_->tilePortals[tile] != kNoPortal) {
                pass = Pass::portal;
                break;
            }
        }
        reached = occupiedTiles[tile];
        if (reached != 0 && !trace) {
            const double left = walk.left();
            const double highest = highestEye + upper * (upper > 0.0 ? left : walk.entered);
            const double lowest = lowestEye + lower * (lower < 0.0 ? left : walk.entered);
            if (highest < 0.0 || lowest >= kMaxLevels) {
                reached = 0;
            } else {
                // Rounded down: what lies exactly on a level's edge is meant a little to the other
                // side of it, by the slack.
                const int top = highest >= kMaxLevels
                                    ? kMaxLevels - 1
                                    : std::max(0, static_cast<int>(nearestInteger(highest - 0.5)));
                const int bottom =
                    lowest <= 0.5 ? 0 : static_cast<int>(nearestInteger(lowest - 0.5));
                reached &= static_cast<std::uint32_t>((std::uint64_t{2} << top) -
                                                      (std::uint64_t{1} << bottom));
            }
        }
        if (reached != 0 || floorTiles[tile] != floorTexture ||
            (ceilingTiles && ceilingTiles[tile] != ceilingTexture) || walk.left() > objectAlong) {
            break;
        }
    }
    walk_.comeTo(walk);
    reached_ = reached;
    report_.tilesWalked += tiles;
    return pass;
}

// A tile in which something changes.
void Slice::drawTile() {
    if (object_ != objectsEnd_ && vista_->objects[*object_].along < leave_.along) {
        drawTileWithObjects();
    } else {
        drawStretch();
    }
}

// What lies in the current tile between `enter_` and `leave_`.
void Slice::drawStretch() {
    const bool inGrid = map_->contains(walk_.tileX, walk_.tileY);
    const std::size_t tile = inGrid ? map_->tileIndex(walk_.tileX, walk_.tileY) : 0;
    const TextureId floorTexture = inGrid ? map_->floor.tiles[tile] : map_->floor.texture;
    const TextureId ceilingTexture = !inGrid || !ceilingTiles_ ? kNoTexture : ceilingTiles_[tile];
    const bool floorChanges = floorTexture != floor_.texture;
    // Where blocks stand, the ceiling of that tile takes its turn among them. A floor must not be
    // drawn before the ceiling above it.
    const TextureId ceilingAlone = reached_ ? kNoTexture : ceilingTexture;
    if (ceilingAlone != ceiling_.texture || floorChanges) {
        endCeiling(Border::enter);
        startCeiling(ceilingAlone);
    }
    if (floorChanges) {
        takeFloor(Border::enter);
        floor_.texture = floorTexture;
    }
    if (reached_) drawBlocks(reached_, ceilingTexture);
    // An object may stand behind: what lies before it is closed first, the ceiling before the
    // floor.
    if (!leave_.border) endCeiling(Border::leave);
    if (reached_ || !leave_.border) takeFloor(Border::leave);
}

Slice::Block Slice::blockAt(int level) const {
    const BlueprintId id = map_->cells[map_->cellIndex(walk_.tileX, walk_.tileY, level)];
    const CellBlueprint& blueprint = frame_.world->blueprints[id];
    const std::int32_t base = tileEdge(level).raw - eyeZ_;
    return {&blueprint, level, base + blueprint.bottom.raw, base + blueprint.top.raw, false};
}

// Everything in one tile that holds blocks, nearest first: for each block its side where the walk
// enters, then its roof or underside, from the eye's height downwards and then from it upwards. The
// floor comes last, with the run that it belongs to.
void Slice::drawBlocks(std::uint32_t reached, TextureId ceilingTexture) {
    report_.blocksMet += std::popcount(reached);
    if (trace_) traceBlocks(reached);
    const std::uint32_t falling = reached & levelsToEye_;
    const std::uint32_t rising = reached & ~(levelsToEye_ >> 1);
    if (falling != 0 || ceilingTexture != kNoTexture) drawFalling(falling, ceilingTexture);
    if (rising != 0 || ceilingTexture != kNoTexture) drawRising(rising, ceilingTexture);
}

// A block that rays are in: they leave it downwards or through the far side. Whether the first ones
// go on within the one below, unhindered.
bool Slice::leaveDownwards(const Block& block, int edgeRow) {
    const int falling = projection_->firstFallingRow;
    const int below = rowBelow(block.bottom, leave_);
    leaveBottom(block, std::max(below, falling), edgeRow);
    leaveSide(block, std::max(rowBelow(block.top, leave_), falling), below);
    return !block.blueprint->seeThrough && goesOn(block, -1);
}

// Blocks that are not wholly above the eye, downwards. At depth 0 the eye may be inside a block, or
// on its roof: a face met at depth 0 is not drawn, so the ray is inside the block then and leaves
// it downwards or through the far side.
void Slice::drawFalling(std::uint32_t levels, TextureId ceilingTexture) {
    const bool atEye = walk_.entered == 0.0;
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise_ < 0;
    const auto ceilingAbove = [&](std::int32_t height) {
        if (ceilingToCome && ceilingRise_ > height) {
            drawCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    // The lower edge of the block above, which may be this one's upper edge: nothing reaches a roof
    // on which an opaque block stands.
    std::int32_t edge = kHighest;
    int edgeRow = 0;
    bool opaqueAbove = false;
    bool inside = false;  // see leaveDownwards
    for (std::uint32_t rest = levels; rest != 0;) {
        const int level = static_cast<int>(std::bit_width(rest)) - 1;
        rest ^= std::uint32_t{1} << level;
        Block block = blockAt(level);
        if ((clipped_ && !cutToClip(block)) || block.bottom > 0) continue;
        block.cut |= std::exchange(inside, false);
        const int topRow = block.top == edge ? edgeRow : rowBelow(block.top, enter_);
        const bool covered = block.top == edge && opaqueAbove;
        edge = block.bottom;
        edgeRow = rowBelow(block.bottom, enter_);
        const bool isPlain =
            !(block.blueprint->seeThrough | block.blueprint->hasPortals | block.cut);
        opaqueAbove = isPlain;
        if (!isPlain) {
            enterSide(block, topRow, edgeRow);
            ceilingAbove(block.top);
            if (!block.cut && !covered && block.top < 0)
                enterTop(block, rowBelow(block.top, leave_), topRow);
            // Whoever stands exactly on a portal falls in at once.
            if (block.top == 0 && !walk_.hasEntered() && actsAtTop(block))
                enterTop(block, projection_->firstFallingRow, projection_->height);
            if (block.bottom < 0 &&
                (block.blueprint->seeThrough || block.cut || (atEye && block.top >= 0))) {
                ceilingAbove(block.bottom);
                inside = leaveDownwards(block, edgeRow);
            }
            continue;
        }
        if (!atEye && enter_.border && open_.mayHold(topRow, edgeRow))
            drawEnteredSide(block, topRow, edgeRow);
        if (block.top < 0) {
            ceilingAbove(block.top);
            if (!covered && topRow > open_.first())
                drawRoof(block, rowBelow(block.top, leave_), topRow);
        } else if (atEye && block.bottom < 0) {
            ceilingAbove(block.bottom);
            inside = leaveDownwards(block, edgeRow);
        }
    }
    ceilingAbove(-kHighest);
}

// Blocks that are not wholly below the eye, upwards. The side of one at the eye's height is drawn
// with those below.
void Slice::drawRising(std::uint32_t levels, TextureId ceilingTexture) {
    const bool atEye = walk_.entered == 0.0;
    bool ceilingToCome = ceilingTexture != kNoTexture && ceilingRise_ > 0;
    const auto ceilingBelow = [&](std::int32_t height) {
        if (ceilingToCome && ceilingRise_ < height) {
            drawCeilingHere(ceilingTexture);
            ceilingToCome = false;
        }
    };
    std::int32_t edge = -kHighest;
    int edgeRow = 0;
    bool opaqueBelow = false;
    bool inside = false;  // as in drawFalling
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1) {
        Block block = blockAt(std::countr_zero(rest));
        if (clipped_ && !cutToClip(block)) continue;
        block.cut |= std::exchange(inside, false);
        const bool isPlain =
            !(block.blueprint->seeThrough | block.blueprint->hasPortals | block.cut);
        if (block.bottom > 0) {
            const int bottomRow = block.bottom == edge ? edgeRow : rowBelow(block.bottom, enter_);
            const bool covered = block.bottom == edge && opaqueBelow;
            edge = block.top;
            edgeRow = rowBelow(block.top, enter_);
            opaqueBelow = isPlain;
            if (!isPlain) {
                enterSide(block, edgeRow, bottomRow);
                ceilingBelow(block.bottom);
                if (!block.cut && !covered)
                    enterBottom(block, bottomRow, rowBelow(block.bottom, leave_));
                if (block.blueprint->seeThrough || block.cut) {
                    ceilingBelow(block.top);
                    const int below = rowBelow(block.top, leave_);
                    leaveTop(block, edgeRow, below);
                    leaveSide(block, below, rowBelow(block.bottom, leave_));
                    inside = !block.blueprint->seeThrough && goesOn(block, 1);
                }
                continue;
            }
            if (!atEye && enter_.border && open_.mayHold(edgeRow, bottomRow))
                drawEnteredSide(block, edgeRow, bottomRow);
            ceilingBelow(block.bottom);
            if (!covered && bottomRow < open_.last())
                drawUnderside(block, bottomRow, rowBelow(block.bottom, leave_));
        } else if (block.top > 0 && (block.blueprint->seeThrough || atEye)) {
            edge = block.top;
            edgeRow = rowBelow(block.top, enter_);
            opaqueBelow = false;
            ceilingBelow(block.top);
            const int below = rowBelow(block.top, leave_);
            leaveTop(block, edgeRow, std::min(below, projection_->firstFallingRow));
            leaveSide(block, below,
                      std::min(rowBelow(block.bottom, leave_), projection_->firstFallingRow));
            inside = !block.blueprint->seeThrough && goesOn(block, 1);
        }
    }
    ceilingBelow(kHighest);
}

void Slice::drawEnteredSide(const Block& block, int firstRow, int lastRow) {
    if (!enteredSideKnown_) {
        enteredSide_ = sideView(enter_);
        enteredSideKnown_ = true;
    }
    drawSide(block, enteredFace(enter_), enter_, enteredSide_, firstRow, lastRow);
}

void Slice::drawRoof(const Block& block, int firstRow, int lastRow, bool fromInside) {
    open_.take(firstRow, lastRow, [&](int first, int last) {
        const FaceBlueprint& look = block.blueprint->face(Face::top);
        const int strength = fromInside ? 0 : mirrorStrength(look.mirror);
        gather({block.top, look.texture, look.light, look.glow, false, strength > 0}, first, last,
               walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY);
        if (strength > 0) mirror(block.top, first, last, strength);
        note(block.level, FilledRows::What::roof, Face::top, first, last);
    });
}

void Slice::drawUnderside(const Block& block, int firstRow, int lastRow) {
    open_.take(firstRow, lastRow, [&](int first, int last) {
        const FaceBlueprint& look = block.blueprint->face(Face::bottom);
        gather({block.bottom, look.texture, look.light, look.glow, true, false}, first, last,
               walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY);
        note(block.level, FilledRows::What::underside, Face::bottom, first, last);
    });
}

void Slice::drawCeilingHere(TextureId texture) {
    startCeiling(texture);
    endCeiling(Border::leave);
}

// Closes the rows that have met the floor by a border; behind it the floor goes on. Rows beyond the
// map's `far` are left for the haze.
void Slice::takeFloor(Border upTo) {
    open_.take(std::max(rowBelow(floorRise_, upTo), vista_->firstFloorRow), projection_->height,
               [&](int first, int last) {
                   if (floorMirror_ > 0) mirror(floorRise_, first, last, floorMirror_);
                   gather({floorRise_, floor_.texture, map_->floor.light, map_->floor.glow, false,
                           floorMirror_ > 0},
                          first, last, floor_.fromX, floor_.fromY, beforeX(upTo), beforeY(upTo));
                   note(kNoLevel, FilledRows::What::floor, Face::top, first, last);
               });
    floor_.fromX = behindX(upTo);
    floor_.fromY = behindY(upTo);
}

// From the current tile on without end, down to where `row` is the first one below the floor.
void Slice::takeFloorBeyond(int row) {
    open_.take(std::max(row, vista_->firstFloorRow), projection_->height, [&](int first, int last) {
        if (floorMirror_ > 0) mirror(floorRise_, first, last, floorMirror_);
        gather({floorRise_, floor_.texture, map_->floor.light, map_->floor.glow, false,
                floorMirror_ > 0},
               first, last, floor_.fromX, floor_.fromY, walk_.tileX, walk_.tileY, true);
        note(kNoLevel, FilledRows::What::floor, Face::top, first, last);
    });
}

// From the current tile on.
void Slice::startCeiling(TextureId texture) {
    ceiling_.texture = texture;
    ceiling_.row = rowBelow(ceilingRise_, enter_);
    ceiling_.fromX = walk_.tileX;
    ceiling_.fromY = walk_.tileY;
}

// Closes the rows that have met the ceiling, if there is one, up to a border. At the eye's own
// height it cannot be seen.
void Slice::endCeiling(Border at) {
    if (ceiling_.texture != kNoTexture && ceilingRise_ != 0) {
        const int row = rowBelow(ceilingRise_, at);
        const int firstRow = std::min(ceiling_.row, row);
        const int lastRow = std::max(ceiling_.row, row);
        const Plane plane = {
            ceilingRise_, ceiling_.texture, map_->ceiling.light, map_->ceiling.glow, true, false};
        if (frame_.textures[ceiling_.texture].seeThrough) {
            seeThroughPlane(kNoLevel, FilledRows::What::ceiling,
                            {plane, firstRow, lastRow, ceiling_.fromX, ceiling_.fromY, beforeX(at),
                             beforeY(at), false});
        } else {
            open_.take(firstRow, lastRow, [&](int first, int last) {
                gather(plane, first, last, ceiling_.fromX, ceiling_.fromY, beforeX(at),
                       beforeY(at));
                note(kNoLevel, FilledRows::What::ceiling, Face::bottom, first, last);
            });
        }
    }
    ceiling_.texture = kNoTexture;
}

void Slice::drawBackground() {
    open_.take(0, projection_->firstFallingRow, [&](int first, int last) {
        vista_->skyRows.fill(pixels_, column_, first, last);
        const Lighting& lighting = vista_->lighting;
        for (int row = first; lighting.inWater && row < last; ++row) {
            const std::uint32_t fog = waterFogs_ != nullptr ? waterFogs_[row] : 255;
            pixels_[row] =
                shadedTexel(pixels_[row], 256, fog, lighting.haze, Lay::opaque, pixels_[row]);
        }
        count(first, last);
        note(kNoLevel, FilledRows::What::sky, Face::top, first, last);
    });
    drawHaze(projection_->firstFallingRow);
}

void Slice::drawHaze(int firstRow) {
    open_.take(firstRow, projection_->height, [&](int first, int last) {
        std::fill(pixels_ + first, pixels_ + last, vista_->lighting.haze);
        count(first, last);
        note(kNoLevel, FilledRows::What::haze, Face::top, first, last);
    });
}

}  // namespace slicecast
