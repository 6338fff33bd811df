#include "tracer_walk.h"

#include <algorithm>
#include <cmath>

namespace slicecast::judge {
namespace {

// Which face of a block is met by what moves that way.
Face enteredFace(Tile step) {
    return step.x > 0   ? Face::west
           : step.x < 0 ? Face::east
           : step.y > 0 ? Face::north
                        : Face::south;
}

Face leftFace(Tile step) {
    return enteredFace({-step.x, -step.y});
}

double inverse(double number) {
    return number == 0.0 ? 0.0 : 1.0 / number;
}

// A cut counts as the side that looks north or south as it does.
Face faceOfCut(Half half) {
    return half == Half::southEast || half == Half::southWest ? Face::north : Face::south;
}

}  // namespace

void Tracer::look(double x, double y, std::vector<Sight>& sights, Notes* notes) const {
    Notes unread;
    Notes& noted = notes != nullptr ? *notes : unread;
    follow(x, y, sights, noted);
    ripple(x, y, sights, noted);
}

void Tracer::follow(double x, double y, std::vector<Sight>& sights, Notes& notes) const {
    sights.clear();
    Walk walk(*this, x, y, sights, notes);
    walk.run();
    walk.addObjects();
}

Tracer::Walk::Walk(const Tracer& tracer, double px, double py, std::vector<Sight>& sights,
                   Notes& notes)
    : tracer_(tracer), world_(tracer.world_), sights_(sights), notes_(notes) {
    const View& view = tracer.view_;
    const double q = px - view.width / 2.0;
    const double d = tracer.distance_;
    direction_ = {d * tracer.forwardX_ - q * tracer.forwardY_,
                  d * tracer.forwardY_ + q * tracer.forwardX_};
    up_ = view.height / 2.0 + view.look * view.height - py;
    sideways_ = q / d;
    leaves_ = up_ > 0.0 ? (tracer.surface_ - view.z.value()) * d / up_ : kNever;
    if (tracer.water_ != nullptr) note(Note::fromWater);
    eye_ = {view.x.value(), view.y.value()};
    eyeZ_ = view.z.value();
    place_.map = view.map;
    tile_ = {view.x.tile(), view.y.tile()};
    stretches_.push_back({place_, 0.0, false, eyeZ_, up_ / d, 0});
}

void Tracer::Walk::run() {
    for (;;) {
        const Border leave = nextBorder();
        const Then then = passTile(leave);
        if (then == Then::again) continue;
        if (then == Then::ended || !(leave.inner ? leaveEdge(leave) : leaveTile(leave))) return;
    }
}

// ---- Before and after, above and below ----

// Where the ray is at a height. The eye counts as a trifle above its own height: a ray that rises
// or runs level is above it from the start, one that falls crosses it at once.
double Tracer::Walk::alongOf(double height) const {
    if (height == eyeZ_) return falls() ? 0.0 : -kNever;
    if (up_ == 0.0) return height < eyeZ_ ? -kNever : kNever;
    const double along = meetingOf(height).along();
    return along > 0.0 ? along : falls() ? kNever : -kNever;
}

bool Tracer::Walk::crossedBefore(double height, const Border& border) const {
    const double along = alongOf(height);
    return along < border.along || (along == border.along && !border.early);
}

// Is the ray above a height when it crosses a border? A falling ray is not above what lies higher
// than the eye, a rising one always above what lies lower.
bool Tracer::Walk::isAbove(double height, const Border& border) const {
    return falls() ? height <= eyeZ_ && !crossedBefore(height, border)
                   : crossedBefore(height, border);
}

// Is the ray above an edge where it begins in the tile? A ray that comes out of a top or bottom
// face has yet to meet the faces that it enters and the planes at that height, but not the faces
// that it leaves. A ray from a mirror has yet to meet only what lies above.
bool Tracer::Walk::isAboveAtStart(double height, Edge edge) const {
    switch (start_) {
        case Start::eye:
            return height <= eyeZ_;
        case Start::border:
            return isAbove(height, enter_);
        case Start::mirror:
            return height <= startHeight_;
        case Start::portal:
            break;
    }
    if (height != startHeight_) return height < startHeight_;
    return edge == Edge::top || (edge == Edge::plane && falls());
}

// ---- Slopes ----

Tracer::Walk::Surface Tracer::Walk::surfaceOf(const CellBlueprint& block, int level, Face which,
                                              const Place& place, Tile tile) const {
    const double base = level - place.levels;
    const Slopes slopes = slicecast::turned(block.slopes, 4 - place.turn);
    const Slant& slant = slopes.of(which);
    if (slant.isLevel())
        return {.height = base + (which == Face::top ? block.top : block.bottom).value()};
    const double rise = slant.to.value() - slant.from.value();
    const double way = (slopes.alongX ? eye_.x - tile.x : eye_.y - tile.y) - slant.shift.value();
    return {.height = base + slant.from.value() + rise * way,
            .isSloped = true,
            .riseX = slopes.alongX ? rise : 0.0,
            .riseY = slopes.alongX ? 0.0 : rise,
            .most = base + std::max(slant.from.value(), slant.to.value())};
}

// The ray's height above the plane is -over + t / d * up.
Meeting Tracer::Walk::meetingOf(const Surface& surface) const {
    const double over = surface.height - eyeZ_;
    const double up = up_ - surface.riseX * direction_.x - surface.riseY * direction_.y;
    return over == 0.0 ? Meeting{0.0, 1.0} : Meeting{over, up};
}

bool Tracer::Walk::isAbove(const Surface& surface, const Border& border) const {
    if (!surface.isSloped) return isAbove(surface.height, border);
    const double way = border.meeting.distance;
    // Over a border across its rise the plane is level.
    const double rise = surface.riseX * border.step.x + surface.riseY * border.step.y;
    if (rise != 0.0) return isAbove(surface.height + rise * way, border);
    const double over = surface.height - eyeZ_;
    const double up = up_ - surface.riseX * direction_.x - surface.riseY * direction_.y;
    const double above = up * way - over * border.meeting.speed;
    if (above != 0.0) return above > 0.0;
    // How it changes as the eye moves east, then south, then up: the way to the border becomes
    // shorter or longer, and the plane over the eye higher or lower.
    if (border.cut != Half::none) {
        const double byEast = -border.sooner[0] * up - surface.riseX;
        return byEast != 0.0 ? byEast > 0.0 : -border.sooner[1] * up - surface.riseY > 0.0;
    }
    const double east = -border.step.x * up - surface.riseX * border.meeting.speed;
    if (east != 0.0) return east > 0.0;
    const double south = -border.step.y * up - surface.riseY * border.meeting.speed;
    return south == 0.0 || south > 0.0;
}

// What a portal or a mirror is in lies wholly above the slopes of its tile or below them.
bool Tracer::Walk::isAboveAtStart(const Surface& surface, Edge edge) const {
    if (!surface.isSloped) return isAboveAtStart(surface.height, edge);
    switch (start_) {
        case Start::border:
            return isAbove(surface, enter_);
        case Start::mirror:
        case Start::portal:
            return surface.most <= startHeight_;
        case Start::eye:
            break;
    }
    const double over = surface.height - eyeZ_;
    return over != 0.0 ? over < 0.0 : surface.riseX + surface.riseY < 0.0;
}

// The level ends of a block's part in its cell. They cut it off if its slopes go beyond.
Tracer::Walk::Levels Tracer::Walk::endsOf(const CellBlueprint& block, int level,
                                          const Place& place) {
    const auto isBeyond = [&](const Slant& slant) {
        return !slant.isLevel() && (slant.least() < block.bottom || slant.most() > block.top);
    };
    const double base = level - place.levels;
    return {base + block.bottom.value(), base + block.top.value(),
            isBeyond(block.slopes.bottom) || isBeyond(block.slopes.top)};
}

// The border by which the ray leaves the tile.
Border Tracer::Walk::tileBorder() const {
    const auto meetingOn = [](int tile, double eye, double direction) {
        return direction > 0.0   ? Meeting{tile + 1 - eye, direction}
               : direction < 0.0 ? Meeting{eye - tile, -direction}
                                 : Meeting{kNever, 1.0};
    };
    Border x;
    x.meeting = meetingOn(tile_.x, eye_.x, direction_.x);
    x.along = x.meeting.along();
    x.step = {direction_.x > 0.0 ? 1 : -1, 0};
    x.early = direction_.x > 0.0;
    x.sooner[0] = inverse(direction_.x);
    Border y;
    y.meeting = meetingOn(tile_.y, eye_.y, direction_.y);
    y.along = y.meeting.along();
    y.step = {0, direction_.y > 0.0 ? 1 : -1};
    y.early = direction_.y > 0.0;
    y.sooner[1] = inverse(direction_.y);
    return isBefore(y, x) ? y : x;
}

Border Tracer::Walk::nextBorder() const {
    Border next = tileBorder();
    const auto consider = [&](const Border& edge) {
        if (isPassed(edge)) return;
        // A cut is crossed within the tile, so before its border
        const bool isCut = edge.cut != Half::none && !next.inner;
        if (isCut ? edge.along <= next.along : isBefore(edge, next)) next = edge;
    };
    const Tile at = place_.tileOf(tile_);
    for (int level = 0; map().contains(at.x, at.y) && level < map().levels; ++level) {
        const BlueprintId id = map().cell(at.x, at.y, level);
        if (id == kEmptyCell || isWhole(id)) continue;
        if (const Half half = halfOf(id, place_); half != Half::none) {
            const HalfPass pass = passHalf(half);
            if (pass.begins != pass.ends) consider(pass.cut);
            continue;
        }
        for (const bool axis : {true, false}) {
            const PlanEdges edges = planEdges(blueprint(id).plan, place_, tile_, axis);
            consider(edges.near);
            consider(edges.far);
        }
    }
    return next;
}

// ---- Blocks that fill only a part of their tile ----

Tracer::Walk::PlanEdges Tracer::Walk::planEdges(const Plan& plan, const Place& place, Tile tile,
                                                bool alongX) const {
    const Plan along = slicecast::turned(plan, 4 - place.turn);  // in the ray's own coordinates
    const double direction = alongX ? direction_.x : direction_.y;
    const double eye = alongX ? eye_.x : eye_.y;
    const auto edge = [&](Coordinate at) {
        const double way = (alongX ? tile.x : tile.y) + at.value() - eye;
        Border border;
        border.inner = true;
        if (direction == 0.0) {
            border.along = way <= 0.0 ? -kNever : kNever;
            return border;
        }
        border.meeting = {direction > 0.0 ? way : -way, std::abs(direction)};
        border.sooner[alongX ? 0 : 1] = 1.0 / direction;
        border.along = border.meeting.along();
        border.early = direction > 0.0;
        const int step = direction > 0.0 ? 1 : -1;
        border.step = alongX ? Tile{step, 0} : Tile{0, step};
        return border;
    };
    const Border low = edge(alongX ? along.west : along.north);
    const Border high = edge(alongX ? along.east : along.south);
    return direction < 0.0 ? PlanEdges{high, low} : PlanEdges{low, high};
}

Half Tracer::Walk::halfOf(BlueprintId id, const Place& place) const {
    return slicecast::turned(blueprint(id).plan, 4 - place.turn).half;
}

// The ray is in a half at the borders that are the half's sides. In the eye's tile the eye's own
// side of the cut counts; on the cut it counts as east of it.
Tracer::Walk::HalfPass Tracer::Walk::passHalf(Half half) const {
    const bool isEast = half == Half::northEast || half == Half::southEast;
    const bool isSouth = half == Half::southEast || half == Half::southWest;
    const auto isSide = [&](Face face) {
        return face == (isEast ? Face::east : Face::west) ||
               face == (isSouth ? Face::south : Face::north);
    };
    const double x = eye_.x - tile_.x;
    const double y = eye_.y - tile_.y;
    // How far the eye is on the side towards which the cut looks eastward
    const double eyeEast = isEast == isSouth ? x + y - 1.0 : x - y;
    const double fast =
        isEast == isSouth ? direction_.x + direction_.y : direction_.x - direction_.y;
    const Border leave = tileBorder();
    HalfPass pass;
    pass.begins = isEyeTile_ ? (eyeEast >= 0.0) == isEast : isSide(enteredFace(tileEnter_.step));
    pass.ends = isSide(leftFace(leave.step));
    if (pass.begins == pass.ends) return pass;
    Border& cut = pass.cut;
    cut.inner = true;
    cut.cut = half;
    const Meeting start = isEyeTile_ ? Meeting{} : tileEnter_.meeting;
    cut.meeting = fast == 0.0 ? start : Meeting{std::abs(eyeEast), std::abs(fast)};
    // Between the borders, whatever the quotient says
    if (cut.meeting.along() < start.along()) cut.meeting = start;
    if (cut.meeting.along() > leave.along) cut.meeting = leave.meeting;
    cut.along = cut.meeting.along();
    cut.sooner[0] = inverse(fast);
    cut.sooner[1] = isEast == isSouth ? inverse(fast) : -inverse(fast);
    cut.early = fast > 0.0;
    return pass;
}

// The eye counts as a little further east, and less further south: at one depth, what is met much
// sooner by this comes first.
bool Tracer::Walk::isBefore(const Border& a, const Border& b) const {
    if (a.along != b.along) return a.along < b.along;
    return std::lexicographical_compare(b.sooner, b.sooner + 2, a.sooner, a.sooner + 2);
}

// Whether the ray has crossed an edge before it is where it begins in the tile.
bool Tracer::Walk::isPassed(const Border& edge) const {
    switch (start_) {
        case Start::eye:
            if (edge.cut != Half::none) return false;
            return edge.along < 0.0 || (edge.along == 0.0 && edge.early);
        case Start::border:
            if (edge.cut != Half::none && !enter_.inner) return false;
            return !isBefore(enter_, edge);
        case Start::portal:
        case Start::mirror:
            break;
    }
    return !crossedBefore(startHeight_, edge);
}

// Whether the block is where the ray begins in the tile.
bool Tracer::Walk::isHere(BlueprintId id) const {
    if (isWhole(id)) return true;
    if (const Half half = halfOf(id, place_); half != Half::none) {
        const HalfPass pass = passHalf(half);
        return pass.begins == pass.ends || !isPassed(pass.cut) ? pass.begins : pass.ends;
    }
    for (const bool alongX : {true, false}) {
        const PlanEdges edges = planEdges(blueprint(id).plan, place_, tile_, alongX);
        if (!isPassed(edges.near) || isPassed(edges.far)) return false;
    }
    return true;
}

// Whether the block, where the ray is, begins at a border or an edge.
bool Tracer::Walk::beginsAt(const Border& border, BlueprintId id) const {
    if (!border.inner) return true;
    if (isWhole(id)) return false;
    const Half half = halfOf(id, place_);
    if (half == Half::none || border.cut == Half::none)
        return half == border.cut &&
               planEdges(blueprint(id).plan, place_, tile_, border.step.x != 0).near.along ==
                   border.along;
    const HalfPass pass = passHalf(half);
    return isCutFalling(half) == isCutFalling(border.cut) && !pass.begins && pass.ends;
}

// Whether the block is where the ray crosses a border into its tile.
bool Tracer::Walk::isBehind(BlueprintId id, const Place& place, Tile tile,
                            const Border& border) const {
    if (isWhole(id)) return true;
    if (const Half half = halfOf(id, place); half != Half::none) {
        const Tile step = border.step;
        return step.x != 0 ? (step.x < 0) == (half == Half::northEast || half == Half::southEast)
                           : (step.y < 0) == (half == Half::southEast || half == Half::southWest);
    }
    for (const bool alongX : {true, false}) {
        const PlanEdges edges = planEdges(blueprint(id).plan, place, tile, alongX);
        if (isBefore(border, edges.near) || !isBefore(border, edges.far)) return false;
    }
    return true;
}

// From one part of a tile to the next. Returns false if the ray has ended.
bool Tracer::Walk::leaveEdge(const Border& edge) {
    if (inside_ != kNoLevel) {
        const CellBlueprint& block = blueprint(map().cell(mapTile_.x, mapTile_.y, inside_));
        const bool isCut = edge.cut != Half::none;
        const bool isHalf = block.plan.half != Half::none;
        // Of two halves with one cut the ray is in one
        const bool ends =
            isCut == isHalf &&
            (isHalf
                 ? isCutFalling(halfOf(map().cell(mapTile_.x, mapTile_.y, inside_), place_)) ==
                       isCutFalling(edge.cut)
                 : planEdges(block.plan, place_, tile_, edge.step.x != 0).far.along == edge.along);
        if (ends && edge.along > 0.0 && !block.plan.isWhole()) {
            const Tile mapStep = Place::turned(edge.step, place_.turn);
            note(isHalf ? Note::cutLeft : Note::planLeft);
            pushFace(block, inside_, isHalf ? faceOfCut(block.plan.half) : leftFace(mapStep),
                     edge.meeting, true);
            if (!block.seeThrough) return false;
        }
    }
    start_ = Start::border;
    enter_ = edge;
    left_ = kEmptyCell;
    return true;
}

// ---- Blocks that touch ----

// Of two touching see-through blocks that join, the faces between them are not there.
bool Tracer::Walk::join(BlueprintId a, BlueprintId b) const {
    if (a == kEmptyCell || b == kEmptyCell) return false;
    const CellBlueprint& first = blueprint(a);
    const CellBlueprint& second = blueprint(b);
    return first.seeThrough && second.seeThrough && first.join && second.join &&
           originOf(a) == originOf(b);
}

// The same beside each other; a block that moves that way is one, though borders cut it.
bool Tracer::Walk::joinBeside(BlueprintId a, BlueprintId b, Tile mapStep) const {
    if (join(a, b)) return true;
    if (!isOneBlock(a, b) || !blueprint(a).seeThrough || !blueprint(b).seeThrough) return false;
    const int motion = blueprint(a).motion;
    if (motion < 0) return false;
    const Axis axis = world_.motions[static_cast<std::size_t>(motion)].axis;
    return axis == (mapStep.x != 0 ? Axis::x : Axis::y);
}

// What moves is one block, though a border between levels cuts it.
bool Tracer::Walk::isOneBlock(BlueprintId a, BlueprintId b) const {
    return a != kEmptyCell && b != kEmptyCell && blueprint(a).mover >= 0 &&
           blueprint(a).mover == blueprint(b).mover;
}

// The block that the ray is in as soon as it has crossed a border into a tile.
BlueprintId Tracer::Walk::blockBehind(const Place& place, Tile tile, const Border& border) const {
    const Map& map = mapOf(place);
    const Tile at = place.tileOf(tile);
    for (int level = 0; level < map.levels; ++level) {
        const BlueprintId id = map.cell(at.x, at.y, level);
        if (id == kEmptyCell || !isBehind(id, place, tile, border)) continue;
        const auto isAboveIts = [&](Face which) {
            return isAbove(surfaceOf(blueprint(id), level, which, place, tile), border);
        };
        const Levels ends = endsOf(blueprint(id), level, place);
        if (isAboveIts(Face::bottom) && !isAboveIts(Face::top) &&
            (!ends.cut || (isAbove(ends.bottom, border) && !isAbove(ends.top, border))))
            return id;
    }
    return kEmptyCell;
}

// The block of a level of the tile if it reaches down to the level's base (where it is above
// something) or up to its end.
BlueprintId Tracer::Walk::touching(const Place& place, int level, bool above) const {
    const Tile at = place.tileOf(tile_);
    const BlueprintId id = mapOf(place).cell(at.x, at.y, level);
    if (id == kEmptyCell || !isHere(id)) return kEmptyCell;
    return reachesEnd(blueprint(id), !above) ? id : kEmptyCell;
}

// What touches the end of an event's level.
BlueprintId Tracer::Walk::touchingNext(const Event& event) const {
    return touching(place_, event.top ? event.level + 1 : event.level - 1, event.top);
}

// What touches the end of the current tile's `level` from the next one: what the ray meets there,
// behind a portal if there is one.
BlueprintId Tracer::Walk::behindLevel(int level, bool above) const {
    const int next = above ? level + 1 : level - 1;
    const BlueprintId id = touching(place_, next, above);
    if (id == kEmptyCell) return id;
    const Face facing = above ? Face::bottom : Face::top;
    if (blueprint(id).face(facing).portal == kNoPortal || !mayPass()) return id;
    const Portal& portal = world_.portals[blueprint(id).face(facing).portal];
    return touching(place_.through(portal), next + portal.levels, above);
}

// ---- One tile ----

Tracer::Walk::Then Tracer::Walk::passTile(const Border& leave) {
    inside_ = kNoLevel;
    mapTile_ = place_.tileOf(tile_);
    return map().contains(mapTile_.x, mapTile_.y) ? passGrid(leave) : passOutside(leave);
}

Tracer::Walk::Then Tracer::Walk::passOutside(const Border& leave) {
    const Point direction = Place::turned(direction_, place_.turn);
    const bool goneX =
        mapTile_.x < 0 ? direction.x <= 0.0 : mapTile_.x >= map().width && direction.x >= 0.0;
    const bool goneY =
        mapTile_.y < 0 ? direction.y <= 0.0 : mapTile_.y >= map().depth && direction.y >= 0.0;
    const bool gone = goneX || goneY;
    if (falls() && (gone || crossedBefore(-place_.levels, leave)))
        return meetFloor(map().floor.texture, true);
    if (!gone) return Then::leaves;
    pushBackground();
    return Then::ended;
}

Tracer::Walk::Then Tracer::Walk::passGrid(const Border& leave) {
    Event events[2 * kMaxLevels + 2];
    int count = 0;
    // Crossed after the start and before the exit.
    const auto add = [&](double height, Edge edge, int order, int level) {
        const bool met =
            up_ != 0.0 && (falls() ? isAboveAtStart(height, edge) && !isAbove(height, leave)
                                   : !isAboveAtStart(height, edge) && isAbove(height, leave));
        if (met)
            events[count++] = {height,     alongOf(height),  order, level, edge == Edge::top,
                               order == 0, meetingOf(height)};
    };
    const auto addSurface = [&](const Surface& surface, Edge edge, int level) {
        const bool isTop = edge == Edge::top;
        if (!surface.isSloped) return add(surface.height, edge, falls() == isTop ? 1 : 0, level);
        const bool isAboveNow = isAboveAtStart(surface, edge);
        if (isAboveNow == isAbove(surface, leave)) return;
        const bool leaves = isAboveNow != isTop;
        const Meeting meeting = meetingOf(surface);
        events[count++] = {surface.height, meeting.along(), leaves ? 0 : 1, level,
                           isTop,          leaves,          meeting};
    };
    for (int level = 0; level < map().levels; ++level) {
        const BlueprintId id = map().cell(mapTile_.x, mapTile_.y, level);
        if (id == kEmptyCell) {
            if (map().cells[map().cellIndex(mapTile_.x, mapTile_.y, level)] != kEmptyCell)
                note(Note::emptyMover);
            continue;
        }
        const CellBlueprint& block = blueprint(id);
        if (!isHere(id)) {
            note(Note::planMissed);
            continue;
        }
        const Surface bottom = surfaceOf(block, level, Face::bottom, place_, tile_);
        const Surface top = surfaceOf(block, level, Face::top, place_, tile_);
        const Levels ends = endsOf(block, level, place_);
        if (isAboveAtStart(bottom, Edge::bottom) && !isAboveAtStart(top, Edge::top) &&
            (!ends.cut ||
             (isAboveAtStart(ends.bottom, Edge::bottom) && !isAboveAtStart(ends.top, Edge::top)))) {
            // At an edge within the tile, blocks that do not begin there go on.
            const bool begins = start_ == Start::border && beginsAt(enter_, id);
            if (begins && enter_.along > 0.0) {
                const bool isCut = enter_.cut != Half::none;
                const Face entered = isCut ? faceOfCut(block.plan.half)
                                           : enteredFace(Place::turned(enter_.step, place_.turn));
                if (enter_.inner) note(isCut ? Note::cutEntered : Note::planEntered);
                if (block.slopes.any()) note(Note::slopeSide);
                const Tile mapStep = Place::turned(enter_.step, place_.turn);
                if (!(arrived_ ? joinThrough(left_, id) : joinBeside(left_, id, mapStep))) {
                    if (block.face(entered).portal != kNoPortal)
                        note(arrived_ ? Note::faceAtExit : Note::faceAtLimit);
                    pushFace(block, level, entered, enter_.meeting, false);
                }
                if (!block.seeThrough) return Then::ended;
            }
            inside_ = level;
            if (start_ == Start::portal) note(Note::outInsideBlock);
        }
        if (ends.cut) {
            count +=
                cutEvents({bottom, {ends.bottom}, top, {ends.top}}, level, leave, events + count);
            continue;
        }
        addSurface(bottom, Edge::bottom, level);
        addSurface(top, Edge::top, level);
    }
    if (falls()) add(-place_.levels, Edge::plane, 2, kFloor);
    if (!map().ceiling.tiles.empty() &&
        map().ceiling.tiles[map().tileIndex(mapTile_.x, mapTile_.y)] != kNoTexture) {
        add(map().ceiling.height.value() - place_.levels, Edge::plane, 2, kCeiling);
    }
    std::sort(events, events + count, [](const Event& a, const Event& b) {
        return a.along != b.along ? a.along < b.along : a.order < b.order;
    });
    // A block is entered before it is left, at the edge where its top meets its underside too.
    for (int i = 1; i < count; ++i) {
        for (int j = 0; j < i; ++j) {
            if (events[j].level == events[i].level && events[j].leaves && !events[i].leaves)
                std::swap(events[i], events[j]);
        }
    }
    for (int i = 0; i < count; ++i) {
        const Then then = meet(events[i], i > 0 ? &events[i - 1] : nullptr);
        if (then != Then::leaves) return then;
    }
    return Then::leaves;
}

// A part of a moving block with slopes lies over two surfaces and under two: its own underside and
// top, and the ends of its cell. The ray is in it from the last one by which it comes in to the
// first one by which it goes out. Adds up to two events, and returns their number.
int Tracer::Walk::cutEvents(const std::array<Surface, 4>& surfaces, int level, const Border& leave,
                            Event* events) const {
    Event enter{};
    Event exit{};
    enter.along = -kNever;
    exit.along = kNever;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Surface& surface = surfaces[i];
        const bool isTop = i >= 2;
        const Edge edge = isTop ? Edge::top : Edge::bottom;
        const bool isAboveNow = isAboveAtStart(surface, edge);
        const bool isAboveThen = isAbove(surface, leave);
        if (isAboveNow == isAboveThen) {
            if (isAboveNow == isTop) return 0;  // never on its side
            continue;
        }
        const bool leaves = isAboveNow != isTop;
        const Meeting meeting = meetingOf(surface);
        // An end of the cell is no face if its side of the block is a slope
        const bool isEnd = i % 2 == 1;
        const Event event = {surface.height, meeting.along(), leaves ? 0 : 1, level,
                             isTop,          leaves,          meeting,        isEnd};
        if (leaves ? event.along < exit.along || (event.along == exit.along && exit.isEnd)
                   : event.along > enter.along || (event.along == enter.along && enter.isEnd))
            (leaves ? exit : enter) = event;
    }
    if (enter.along >= exit.along) return 0;
    int count = 0;
    if (enter.along != -kNever) events[count++] = enter;
    if (exit.along != kNever) events[count++] = exit;
    return count;
}

// `before` is what was met before in this tile; a block that was left at the same height is the
// event just before.
Tracer::Walk::Then Tracer::Walk::meet(const Event& event, const Event* before) {
    const Meeting meeting = event.meeting;
    if (event.level == kFloor)
        return meetFloor(map().floor.tiles[map().tileIndex(mapTile_.x, mapTile_.y)], false);
    if (event.level == kCeiling) {
        if (event.along <= 0.0) return Then::leaves;
        pushPlane(Sight::Kind::ceiling,
                  map().ceiling.tiles[map().tileIndex(mapTile_.x, mapTile_.y)], map().ceiling.light,
                  map().ceiling.glow, meeting, false);
        return sights_.back().seeThrough ? Then::leaves : Then::ended;
    }
    const BlueprintId id = map().cell(mapTile_.x, mapTile_.y, event.level);
    const CellBlueprint& block = blueprint(id);
    const Face which = event.top ? Face::top : Face::bottom;
    // Only a block that ends where its level does can touch the next one.
    const bool atLevelsEnd = block.slopes.of(which).isLevel() && reachesEnd(block, event.top);
    if (event.isEnd && !block.slopes.of(which).isLevel()) {
        note(Note::cutSlope);
        inside_ = event.leaves ? kNoLevel : event.level;
        return Then::leaves;
    }
    if (!block.slopes.of(which).isLevel()) {
        if (block.mover >= 0) note(Note::movedSlope);
        if (block.slopes.of(which).shift.raw != 0) note(Note::shiftedSlope);
        note(event.leaves ? Note::slopeFromInside : event.top ? Note::slopeRoof : Note::slopeUnder);
        if (event.top && !event.leaves && !falls()) note(Note::slopeAboveHorizon);
        if (!event.top && !event.leaves && falls()) note(Note::slopeBelowHorizon);
    }
    if (event.leaves) {  // upwards through the top, downwards through the bottom
        inside_ = kNoLevel;
        if (block.face(which).portal != kNoPortal) {
            note(Note::leftThroughPortal);
            return Then::leaves;
        }
        if (event.along <= 0.0) return Then::leaves;
        if (atLevelsEnd && isOneBlock(id, touchingNext(event))) {
            note(block.seeThrough && block.join ? Note::joinedMover
                 : block.seeThrough             ? Note::wholeMover
                                                : Note::insideMover);
            return Then::leaves;
        }
        const BlueprintId next = atLevelsEnd ? behindLevel(event.level, event.top) : kEmptyCell;
        const bool isThrough = next != touchingNext(event);
        if (!(isThrough ? joinThrough(id, next) : join(id, next)))
            pushFace(block, event.level, which, meeting, true);
        return block.seeThrough ? Then::leaves : Then::ended;
    }
    if (acts(block, which, event.height) && mayPass()) {
        if (arrived_) note(Note::faceBehindExit);
        const bool left = before != nullptr && before->height == event.height && before->order == 0;
        return throughHeight(block.face(which).portal, event,
                             left ? map().cell(mapTile_.x, mapTile_.y, before->level) : kEmptyCell);
    }
    inside_ = event.level;
    if (event.along <= 0.0) return Then::leaves;
    const bool atPortal = isWhereItCameOut(event.height);
    const BlueprintId left = atPortal ? left_ : atLevelsEnd ? touchingNext(event) : kEmptyCell;
    if ((atPortal ? joinThrough(left, id) : join(left, id)) ||
        (!atPortal && isOneBlock(left, id))) {
        if (atPortal) note(Note::joinedByPortal);
        if (event.top && block.face(which).mirror > 0) note(Note::mirrorJoined);
        return Then::leaves;
    }
    if (block.face(which).portal != kNoPortal)
        note(atPortal ? Note::faceAtExit : Note::faceAtLimit);
    pushFace(block, event.level, which, meeting, false);
    if (block.face(which).texture != kNoTexture && sights_.back().mirror > 0) {
        note(Note::roofMirror);
        return reflect(event.height, block.face(which).ripples);
    }
    return block.seeThrough ? Then::leaves : Then::ended;
}

Tracer::Walk::Then Tracer::Walk::meetFloor(TextureId texture, bool outside) {
    const double height = -place_.levels;
    const Meeting meeting = meetingOf(height);
    // A floor at t = 0 is not drawn: the ray came out of a portal there, and goes on below.
    if (alongOf(height) <= 0.0 || meeting.along() * tracer_.distance_ > map().far) {
        pushBackground();
        return Then::ended;
    }
    pushPlane(Sight::Kind::floor, texture, map().floor.light, map().floor.glow, meeting, outside);
    if (sights_.back().mirror > 0) {
        note(Note::floorMirror);
        if (outside) note(Note::mirrorOutside);
        return reflect(height, map().floor.ripples);
    }
    if (sights_.back().seeThrough) pushBackground();
    return Then::ended;
}

Tracer::Walk::Then Tracer::Walk::throughHeight(PortalId id, const Event& event, BlueprintId left) {
    const Portal& portal = world_.portals[id];
    const CellBlueprint& block = blueprint(map().cell(mapTile_.x, mapTile_.y, event.level));
    if (block.seeThrough) note(Note::portalInGlass);
    note(event.top ? Note::topPortal : Note::bottomPortal);
    passPortal(place_.through(portal), portal, event.along, Note::facePortal0);
    start_ = Start::portal;
    startHeight_ = event.height;
    left_ = left;
    if (event.height >= -place_.levels) return Then::again;
    note(Note::belowFloor);
    pushHaze(event.along);
    return Then::ended;
}

// The ray goes on from a mirror as if it came, rising, from the mirrored eye.
Tracer::Walk::Then Tracer::Walk::reflect(double height, int ripples) {
    const Meeting meeting = meetingOf(height);
    const Point at = Place::turned(
        Point{eye_.x + meeting.at(direction_.x), eye_.y + meeting.at(direction_.y)}, place_.turn);
    // What is this little before a step counts as on it.
    const auto stepOf = [](double place) {
        constexpr double kSnap = 1.0 / 8589934592.0;  // 2^-33
        return static_cast<int>(std::floor(256.0 * (place + kSnap)));
    };
    sights_.back().waves = {
        ripples,  eyeZ_ - height, -up_,         stepOf(at.x + place_.x), stepOf(at.y + place_.y),
        place_.x, place_.y,       place_.levels};
    if (portals_ > 0) note(Note::mirrorBehindPortal);
    const double along = alongOf(height);
    eyeZ_ = 2.0 * height - eyeZ_;
    up_ = -up_;
    reflected_ = true;
    start_ = Start::mirror;
    startHeight_ = height;
    stretches_.push_back({place_, along, true, eyeZ_, up_ / tracer_.distance_, sights_.size()});
    return Then::again;
}

void Tracer::Walk::passPortal(const Place& next, const Portal& portal, double along, Note kind) {
    note(kind, portal.turn);
    if (portal.levels != 0) note(Note::levelsShifted);
    if (next.map == place_.map) note(Note::portalWithinMap);
    if (along <= 0.0) note(Note::portalAtOnce);
    if (reflected_) note(Note::portalBehindMirror);
    if (++portals_ >= 3) note(Note::threePortals);
    place_ = next;
    arrived_ = true;
    stretches_.push_back({place_, along, false, eyeZ_, up_ / tracer_.distance_, sights_.size()});
}

// From one tile to the next, through a portal if there is one. Returns false if the ray has ended.
bool Tracer::Walk::leaveTile(const Border& leave) {
    const Tile next = {tile_.x + leave.step.x, tile_.y + leave.step.y};
    const Tile mapNext = place_.tileOf(next);
    const Tile mapStep = Place::turned(leave.step, place_.turn);
    const BlueprintId left =
        inside_ == kNoLevel ? kEmptyCell : map().cell(mapTile_.x, mapTile_.y, inside_);
    const Face entered = enteredFace(mapStep);

    // What lies behind the border: a tile portal, or a block with or without a portal on the face
    // that is met.
    BlueprintId ahead = kEmptyCell;
    PortalId portal = map().tilePortal(mapNext.x, mapNext.y);
    const bool wholeTile = portal != kNoPortal;
    if (!wholeTile) {
        ahead = blockBehind(place_, next, leave);
        if (ahead != kEmptyCell && mayPass()) portal = blueprint(ahead).face(entered).portal;
    }
    Place beyond = place_;
    bool below = false;
    const bool passes = portal != kNoPortal && mayPass();
    const bool inGlass = passes && !wholeTile && blueprint(ahead).seeThrough;
    if (passes) {
        beyond = place_.through(world_.portals[portal]);
        below = !isAbove(-beyond.levels, leave);
        ahead = below ? kEmptyCell : blockBehind(beyond, next, leave);
    }

    // The face left.
    if (left != kEmptyCell) {
        const CellBlueprint& block = blueprint(left);
        if (block.face(leftFace(mapStep)).portal != kNoPortal) {
            note(Note::leftThroughPortal);
        } else if (leave.along > 0.0) {
            if (!(passes ? joinThrough(left, ahead) : joinBeside(left, ahead, mapStep))) {
                pushFace(block, inside_, leftFace(mapStep), leave.meeting, true);
            } else if (passes) {
                note(Note::joinedByPortal);
            } else if (!join(left, ahead)) {
                note(Note::wholeSlider);
            } else if (left != ahead) {
                note(Note::joinedKin);
            }
            if (!block.seeThrough) return false;
        }
    }

    arrived_ = false;
    if (portal != kNoPortal && !passes) {
        note(Note::tileAtLimit);
        pushHaze(leave.along);
        return false;
    }
    if (passes) {
        if (inGlass) note(Note::portalInGlass);
        if (!wholeTile) note(Note::northPortal, static_cast<int>(entered));
        passPortal(beyond, world_.portals[portal], leave.along,
                   wholeTile ? Note::tilePortal0 : Note::facePortal0);
        if (below) {
            note(Note::belowFloor);
            pushHaze(leave.along);
            return false;
        }
        const Tile exit = place_.tileOf(next);
        if (map().tilePortal(exit.x, exit.y) != kNoPortal) note(Note::tileAtExit);
    }
    tile_ = next;
    start_ = Start::border;
    enter_ = tileEnter_ = leave;
    isEyeTile_ = false;
    left_ = left;
    return true;
}

}  // namespace slicecast::judge
