// What a ray meets, as sights; and the objects, which are met last.
#include "tracer_sky.h"
#include "tracer_walk.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>

namespace slicecast::judge {
void Tracer::Walk::push(Sight sight) {
    sight.map = place_.map;
    sight.turn = place_.turn;
    sight.portals = portals_;
    sight.reflected = reflected_;
    sight.leaves = leaves_;
    if (tracer_.water_ != nullptr) {
        if (sight.depth > leaves_) note(Note::outOfWater);
        if (sight.kind == Sight::Kind::sky) note(Note::waterSky);
        if (sight.mirror > 0) note(Note::waterMirror);
    }
    sights_.push_back(sight);
}

// Where the ray meets a face, as fractions of its texture. Seen from outside u runs to the right:
// north and east run against the map, which is marked by a negative fraction. The top shows the map
// as from above, the bottom with its rows reversed.
void Tracer::Walk::pushFace(const CellBlueprint& block, int level, Face which,
                            const Meeting& meeting, bool fromInside) {
    const FaceBlueprint& look = block.face(which);
    if (look.texture == kNoTexture) return note(Note::noFace);  // water may lack faces
    const Point point = Place::turned(
        Point{eye_.x + meeting.at(direction_.x), eye_.y + meeting.at(direction_.y)}, place_.turn);
    // A face shows only texels that its block covers.
    const auto within = [](double at, Coordinate from, Coordinate to) {
        const double last = to == tileEdge(1) ? 1.0 : std::nextafter(to.value(), 0.0);
        return std::clamp(at, from.value(), last);
    };
    // On a slope the point is found by a longer sum; what is this little before a texel's border
    // counts as on it.
    const bool isSloped =
        (which == Face::top || which == Face::bottom) && !block.slopes.of(which).isLevel();
    const Plan& plan = isSloped ? kWholeTile : block.plan;     // its texels keep to the tile
    const double snap = isSloped ? 1.0 / 17179869184.0 : 0.0;  // 2^-34
    const double x = within(point.x + (place_.x - mapTile_.x) + snap, plan.west, plan.east);
    const double y = within(point.y + (place_.y - mapTile_.y) + snap, plan.north, plan.south);
    // What moves along x or y carries its textures along; where they end they begin anew.
    const auto slid = [](double at, Coordinate by) {
        return at - by.value() + (at < by.value() ? 1.0 : 0.0);
    };
    const double textureX = slid(x, block.textureEast);
    const double textureY = slid(y, block.textureSouth);
    const double z = std::clamp(eyeZ_ + meeting.at(up_) + (place_.levels - level),
                                block.bottom.value(), block.top.value());
    Sight sight;
    sight.face = which;
    sight.litFace = {mapTile_.x, mapTile_.y, level, static_cast<int>(which)};
    sight.rise = block.textureRise;
    sight.fromInside = fromInside;
    sight.isSloped = isSloped;
    sight.seeThrough = block.seeThrough;
    sight.texture = look.texture;
    sight.faceLight = look.light;
    sight.glow = look.glow;
    sight.along = meeting.along();
    sight.depth = sight.along * tracer_.distance_;
    switch (which) {
        case Face::south:
            sight.u = textureX;
            break;
        case Face::north:
            sight.u = -textureX;
            break;
        case Face::west:
            sight.u = textureY;
            break;
        case Face::east:
            sight.u = -textureY;
            break;
        default:
            sight.u = textureX;
            break;
    }
    if (which == Face::top) {
        sight.kind = Sight::Kind::roof;
        sight.v = textureY;
        if (!fromInside)
            sight.mirror = std::min(
                255, static_cast<int>(std::floor(look.mirror * tracer_.view_.mirrors + 0.5)));
        if (sight.mirror > 0) sight.seeThrough = false;
    } else if (which == Face::bottom) {
        sight.kind = Sight::Kind::underside;
        sight.v = -textureY;
    } else {
        sight.kind = Sight::Kind::side;
        // What moves carries its textures along; where they end they begin anew.
        const double rise = block.textureRise.value();
        sight.v = 1.0 - z + rise;
        sight.slideU =
            which == Face::north || which == Face::south ? block.textureEast : block.textureSouth;
        if (rise > 0.0) note(Note::risenTexture);
        if (sight.slideU.raw != 0) note(Note::slidSide);
        if (rise > 0.0 && sight.v >= 1.0) sight.v -= 1.0;
    }
    if (sight.kind != Sight::Kind::side) {
        sight.slideU = block.textureEast;
        sight.slideV = block.textureSouth;
        if ((sight.slideU.raw | sight.slideV.raw) != 0) note(Note::slidPlane);
    }
    push(sight);
}

void Tracer::Walk::pushPlane(Sight::Kind kind, TextureId texture, double light, bool glow,
                             const Meeting& meeting, bool outside) {
    const Point rayPoint = {eye_.x + meeting.at(direction_.x), eye_.y + meeting.at(direction_.y)};
    const Point point = Place::turned(rayPoint, place_.turn);
    // Outside the grid, the tile is the one that the point is in; beside a border, the way from the
    // eye counts, which is smaller than what a sum would keep.
    const auto tileAt = [](double eye, double way) {
        const double border = std::floor(eye);
        return static_cast<int>(border + std::floor(eye - border + way));
    };
    const Tile tile = outside ? place_.tileOf({tileAt(eye_.x, meeting.at(direction_.x)),
                                               tileAt(eye_.y, meeting.at(direction_.y))})
                              : mapTile_;
    Sight sight;
    sight.kind = kind;
    sight.litFace = {tile.x, tile.y, 0,
                     kind == Sight::Kind::floor ? LitFace::kFloor
                     : falls()                  ? LitFace::kCeilingAbove
                                                : LitFace::kCeilingBelow};
    sight.outsideGrid = outside;
    sight.texture = texture;
    sight.seeThrough = world_.textures[texture].seeThrough;
    sight.faceLight = light;
    sight.glow = glow;
    sight.along = meeting.along();
    sight.depth = sight.along * tracer_.distance_;
    sight.u = std::clamp(point.x + (place_.x - tile.x), 0.0, 1.0);
    const double y = std::clamp(point.y + (place_.y - tile.y), 0.0, 1.0);
    sight.v = kind == Sight::Kind::ceiling ? -y : y;
    if (kind == Sight::Kind::floor)
        sight.mirror = std::min(
            255, static_cast<int>(std::floor(map().floor.mirror * tracer_.view_.mirrors + 0.5)));
    if (sight.mirror > 0) sight.seeThrough = false;
    push(sight);
}

void Tracer::Walk::pushHaze(double along) {
    Sight sight;
    sight.kind = Sight::Kind::haze;
    sight.colour = map().haze;
    sight.along = along;
    sight.depth = along * tracer_.distance_;
    push(sight);
}

void Tracer::Walk::pushBackground() {
    if (falls()) return pushHaze(meetingOf(-place_.levels).along());
    Sight sight;
    sight.kind = Sight::Kind::sky;
    sight.along = kNever;
    sight.depth = kNever;
    SkyNotes seen;
    sight.colour = skyColour(
        map().sky, tracer_.view_.headingDegrees + 90.0 * place_.turn + atanDegrees(sideways_),
        up_ / tracer_.distance_, world_.steps, seen);
    if (seen.star) note(Note::skyStar);
    if (seen.sun) note(Note::skySun);
    if (seen.moon) note(Note::skyMoon);
    if (seen.cloud) note(Note::skyCloud);
    push(sight);
}

// Every object is a rectangle at one depth t, that of its middle to the nearest 1/65536; it is met
// where the ray is in its map at that depth, after whatever else is at that depth.
void Tracer::Walk::addObjects() {
    double end = sights_.back().along;
    std::size_t last = sights_.size();
    for (std::size_t i = stretches_.size(); i-- > 0;) {
        const Stretch& stretch = stretches_[i];
        const int portals = static_cast<int>(std::count_if(
            stretches_.begin() + 1, stretches_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
            [](const Stretch& s) { return !s.afterMirror; }));
        const bool reflected =
            std::any_of(stretches_.begin(), stretches_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                        [](const Stretch& s) { return s.afterMirror; });
        std::vector<Sight> met;
        for (const Object& object : mapOf(stretch.place).objects) {
            const Point at = stretch.place.rayPointOf({object.x.value(), object.y.value()});
            const double dx = at.x - eye_.x;
            const double dy = at.y - eye_.y;
            const double t =
                std::floor(65536.0 * (tracer_.forwardX_ * dx + tracer_.forwardY_ * dy) + 0.5) /
                65536.0;
            const double along = t / tracer_.distance_;
            if (t <= 0.0 || along < stretch.from || along >= end) continue;
            const double left =
                -tracer_.forwardY_ * dx + tracer_.forwardX_ * dy - object.width.value() / 2.0;
            const double across = (sideways_ * t - left) / object.width.value();
            const double height =
                stretch.eyeZ + stretch.place.levels - object.z.value() + stretch.slope * t;
            if (across < 0.0 || across >= 1.0 || height < 0.0 || height >= object.height.value())
                continue;
            Sight sight;
            sight.kind = Sight::Kind::object;
            sight.object = static_cast<int>(&object - mapOf(stretch.place).objects.data());
            sight.map = stretch.place.map;
            sight.turn = stretch.place.turn;
            sight.portals = portals;
            sight.reflected = reflected;
            sight.leaves = leaves_;
            sight.seeThrough = true;
            sight.texture = object.sprite;
            if (tracer_.world_.sprites[object.sprite].views > 1) {
                // Exact: products of whole numbers of 1/65536
                const Point facing = Place::turned(
                    Point{object.facingX.value(), object.facingY.value()}, 4 - stretch.place.turn);
                const double ahead = -(facing.x * dx + facing.y * dy);
                const double right = facing.y * dx - facing.x * dy;
                sight.side = ahead >= std::abs(right)    ? 0
                             : -ahead >= std::abs(right) ? 2
                             : right > 0.0               ? 1
                                                         : 3;
            }
            sight.faceLight = object.light;
            sight.glow = object.glow;
            sight.along = along;
            sight.depth = t;
            sight.u = across;
            sight.v = std::clamp(1.0 - height / object.height.value(), 0.0, 1.0);
            met.push_back(sight);
        }
        std::stable_sort(met.begin(), met.end(),
                         [](const Sight& a, const Sight& b) { return a.depth < b.depth; });
        std::size_t from = stretch.first;
        std::size_t to = last;
        for (const Sight& object : met) {
            while (from < to && sights_[from].along <= object.along) ++from;
            sights_.insert(sights_.begin() + static_cast<std::ptrdiff_t>(from), object);
            ++to;
        }
        end = stretch.from;
        last = stretch.first;
    }
}

}  // namespace slicecast::judge
