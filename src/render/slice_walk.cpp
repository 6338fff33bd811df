#include "render/slice_walk.h"

#include "render/open_slopes.h"

#include <algorithm>
#include <bit>

namespace slicecast {
namespace {

// A walk that stops at a border must be past it by more than the rounding error.
constexpr double kBeyond = 1.0 + 1.0 / 1099511627776.0;

// From a tile outside the grid, on one axis.
bool leadsAway(int tile, int step, int size) {
    return tile < 0 ? step <= 0 : tile >= size && step >= 0;
}

}  // namespace

SliceWalk::SliceWalk(const Frame& frame, OpenRows& open, FrameReport& report, SeeThrough seeThrough)
    : frame_(frame),
      ownVista_(frame.vistas.ofEye()),
      cuts_(seeThrough == SeeThrough::cut),
      open_(open),
      report_(report),
      walk_({}, {}, {}) {}

void SliceWalk::find(int column, SliceSpans& found, bool withReflection) {
    beginColumn(column, found);
    walkParts();
    if (withReflection && beginReflection(found)) walkParts();
}

// Makes the first part.
void SliceWalk::beginColumn(int column, SliceSpans& found) {
    column_ = column;
    found.column = column;
    found.upright.clear();
    found.reflected.clear();
    found_ = &found.upright;
    const Viewpoint& eye = ownVista_.viewpoint;
    const GridWalk start({static_cast<std::int32_t>(eye.x)}, {static_cast<std::int32_t>(eye.y)},
                         ownVista_.ray(column));
    Part& whole = found_->parts.find(ownVista_, start, {}, {}, 0, 0);
    whole.rows.assign(1, {0, ownVista_.projection->height});
    part_ = 0;
}

// Walks the present part and those after it. Walking a part may add more parts.
void SliceWalk::walkParts() {
    do {
        begin();
        goOn(false);
    } while (nextPart());
}

// Ends the present part; false if it was the last one.
bool SliceWalk::nextPart() {
    takeBackground();
    part().tiles = tiles_;
    part().endsInPortal = endsInPortal_;
    return ++part_ < static_cast<int>(found_->parts.count());
}

// Stands before the first tile of the present part.
void SliceWalk::begin() {
    const Part& part = this->part();
    lookInto(*part.vista);
    open_.openOnly(part.rows, projection_->height);
    walk_ = part.walk;
    clip_ = part.clip;
    clipped_ = clip_.any();
    lowest_ = clip_.low / 65536.0 + eyeHeight_;
    portals_ = part.portals;
    startX_ = walk_.tileX;
    startY_ = walk_.tileY;
    before_ = part.before;
    tiles_ = 0;
    floorSpan_ = kNone;
    const bool ceilingMet =
        !clipped_ || (clip_.isMirror ? ceilingRise_ > clip_.low
                                     : ceilingRise_ >= clip_.low && ceilingRise_ <= clip_.high);
    ceilingTiles_ =
        map_->ceiling.tiles.empty() || !ceilingMet ? nullptr : map_->ceiling.tiles.data();
    report_.deepestPortal = std::max(report_.deepestPortal, portals_);
    if (portals_ > 0) ++report_.partsBehindPortals;
    floor_ = {map_->floor.texture, projection_->height, walk_.tileX, walk_.tileY};
    ceiling_ = {};
    objects_ = nullptr;
    object_ = 0;
    objectsTo_ = kNever;
    if (vista_->objects.none()) return;
    findObjects(walk_.entered);
}

void SliceWalk::lookInto(Vista& vista) {
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

// Walks from the current tile, or from the next one, to the end of the part.
void SliceWalk::goOn(bool leaveFirst) {
    Pass pass = passTiles(leaveFirst);
    while (pass == Pass::tile) {
        meetHere(reached_ == 0 ? 0 : levelsWithPlans(walk_.tileX, walk_.tileY));
        if (open_.none()) break;
        pass = passTiles(true);
    }
    endWay(pass);
}

// `plans` are the levels with plans of the current tile.
void SliceWalk::meetHere(std::uint32_t plans) {
    enter_ = walk_.enter();
    leave_ = walk_.leave();
    here_ = {walk_.tileX, walk_.tileY, walk_.tileX, walk_.tileY, false};
    enteredSideKnown_ = false;
    meetTile(plans);
}

void SliceWalk::endWay(Pass pass) {
    endsInPortal_ = pass == Pass::portal;
    enter_ = walk_.enter();

    // The ceiling ends with the grid; the floor continues outside it.
    endCeiling(Border::enter);
    if (pass == Pass::portal) return enterPortalTile();
    if (pass != Pass::stopped && floor_.texture != map_->floor.texture) {
        takeFloor(Border::enter);
        floor_.texture = map_->floor.texture;
    }
    if (pass == Pass::left) meetObjectsBeyond();
    takeFloorBeyond(0);
}

// How far along the ray to walk while the rows [first, last) are open: beyond that they can meet
// only the present floor and the sky. If all open rows look down, it is where the flattest of them
// meets the floor; if all look up, where the flattest of them is above everything but portal tiles,
// which act at all heights.
double SliceWalk::whereToStop(int first, int last) const {
    if (first >= last) return 0.0;
    const int firstFalling = projection_->firstFallingRow;
    if (first >= firstFalling)
        return kBeyond * eyeHeight_ * vista_->inverseOffsets[static_cast<std::size_t>(first)];
    if (last > firstFalling || hasTilePortals_) return kNever;
    const double rise = vista_->highest - eyeHeight_;
    return rise <= 0.0
               ? 0.0
               : kBeyond * rise * vista_->inverseOffsets[static_cast<std::size_t>(last - 1)];
}

// Walks over tiles where nothing changes: the same floor and ceiling, and no block that an open row
// may meet.
SliceWalk::Pass SliceWalk::passTiles(bool leaveFirst) {
    skipHiddenObjects();
    const double stop = whereToStop(open_.first(), open_.last());
    const OpenSlopes slopes(*projection_, open_.first(), open_.last(), eyeHeight_, lowest_);
    const TextureId* const floorTiles = map_->floor.tiles.data();
    const TextureId* const ceilingTiles = ceilingTiles_;
    const std::uint32_t* const occupiedTiles = map_->occupied.data();
    const TextureId floorTexture = floor_.texture;
    const TextureId ceilingTexture = ceiling_.texture;
    const auto width = static_cast<unsigned>(map_->width);
    const auto depth = static_cast<unsigned>(map_->depth);
    const double objectAlong = nextObjectAlong();
    const bool isFull = this->isFull();
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
            // Outside the grid there is only the floor. The walk continues while it may still reach
            // the grid
            if (leadsAway(walk.tileX, walk.stepX, map_->width) ||
                leadsAway(walk.tileY, walk.stepY, map_->depth)) {
                pass = Pass::left;
                break;
            }
            ++tiles;
            if (walk.left() > objectAlong) break;
            continue;
        }
        ++tiles;
        const std::size_t tile =
            static_cast<std::size_t>(walk.tileY) * width + static_cast<std::size_t>(walk.tileX);
        if (hasTilePortals_ && leave && map_->tilePortals[tile] != kNoPortal) {
            pass = Pass::portal;
            break;
        }
        reached = occupiedTiles[tile];
        if (reached != 0) reached &= slopes.levelsReached(walk.entered, walk.left());
        if (isFull && reached != 0) reached = withoutLayers(walk.tileX, walk.tileY, reached);
        if (reached != 0 || floorTiles[tile] != floorTexture ||
            (ceilingTiles && ceilingTiles[tile] != ceilingTexture) || walk.left() > objectAlong) {
            break;
        }
    }
    walk_.comeTo(walk);
    reached_ = reached;
    report_.tilesWalked += tiles;
    tiles_ += tiles;
    return pass;
}

// Of some levels of a tile in the grid, those whose blocks still add to a column with kMaxLayers.
// A mirror is opaque; but what mirrors show is seen from below.
std::uint32_t SliceWalk::withoutLayers(int x, int y, std::uint32_t levels) const {
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1) {
        const CellBlueprint& block = *blockAt(x, y, std::countr_zero(rest)).blueprint;
        if (block.seeThrough && !block.hasPortals &&
            (clip_.isMirror || block.face(Face::top).mirror == 0))
            levels ^= rest & -rest;
    }
    return levels;
}

// Meets the present tile, even if nothing changes there.
void SliceWalk::meetCurrent(std::uint32_t plans) {
    skipHiddenObjects();
    const OpenSlopes slopes(*projection_, open_.first(), open_.last(), eyeHeight_, lowest_);
    reached_ = map_->occupied[map_->tileIndex(walk_.tileX, walk_.tileY)];
    if (reached_ != 0) reached_ &= slopes.levelsReached(walk_.entered, walk_.left());
    if (isFull()) reached_ = withoutLayers(walk_.tileX, walk_.tileY, reached_);
    meetHere(plans);
}

// Meets a tile in which something changes.
void SliceWalk::meetTile(std::uint32_t plans) {
    if (objectsTo_ < leave_.along) {
        findObjects(leave_.along);
        skipHiddenObjects();
    }
    plans &= reached_ | reached_ << 1 | reached_ >> 1;
    if (plans != 0) {
        meetTileWithPlans(plans);
    } else if (nextObjectAlong() < leave_.along) {
        meetTileWithObjects();
    } else {
        meetStretch();
    }
}

// Meets everything in the current tile between `enter_` and `leave_`.
void SliceWalk::meetStretch() {
    const bool inGrid = map_->contains(walk_.tileX, walk_.tileY);
    const std::size_t tile = inGrid ? map_->tileIndex(walk_.tileX, walk_.tileY) : 0;
    const TextureId floorTexture = inGrid ? map_->floor.tiles[tile] : map_->floor.texture;
    const TextureId ceilingTexture = !inGrid || !ceilingTiles_ ? kNoTexture : ceilingTiles_[tile];
    const bool floorChanges = floorTexture != floor_.texture;
    // In a tile with blocks, meetBlocks() draws the ceiling in its turn. A floor must not be drawn
    // before the ceiling above it
    const TextureId ceilingAlone = reached_ ? kNoTexture : ceilingTexture;
    if (ceilingAlone != ceiling_.texture || floorChanges) {
        endCeiling(Border::enter);
        startCeiling(ceilingAlone);
    }
    if (floorChanges) {
        takeFloor(Border::enter);
        floor_.texture = floorTexture;
    }
    if (reached_) meetBlocks(reached_, ceilingTexture);
    // An object follows: close everything before it, the ceiling before the floor
    if (!leave_.border) endCeiling(Border::leave);
    if (reached_ || !leave_.border) takeFloor(Border::leave);
}

void SliceWalk::takeBackground() {
    for (const auto& [first, last] : open_.take(0, projection_->firstFallingRow))
        add(What::sky, first, last);
    takeHaze(projection_->firstFallingRow);
}

void SliceWalk::takeHaze(int firstRow) {
    for (const auto& [first, last] : open_.take(firstRow, projection_->height))
        add(What::haze, first, last);
}

}  // namespace slicecast
