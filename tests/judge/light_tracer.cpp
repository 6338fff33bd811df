#include "light_tracer.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>

namespace slicecast::judge {
namespace {

Rgb held(const Rgb& light) {
    const std::int64_t most = std::max({light[0], light[1], light[2]});
    Rgb out = light;
    if (most > 255) {
        for (int& c : out) c = static_cast<int>((c * std::int64_t{255} + most / 2) / most);
    }
    return out;
}

// A moment of a ray: num / den of its vector, and after it an infinitely small time: the small
// steps by which samples are moved, each times late / den of its axis.
struct Moment {
    std::int64_t num = 0;
    std::int64_t den = 1;  // 0: never
    std::array<std::int64_t, 3> late{};
};

__extension__ using Wide = __int128;

// Less than 0 if a is before b, more than 0 if b is before a.
int compared(const Moment& a, const Moment& b) {
    const auto sign = [](Wide left, Wide right) {
        return left < right ? -1 : left > right ? 1 : 0;
    };
    int found = sign(Wide{a.num} * b.den, Wide{b.num} * a.den);
    for (std::size_t i = 0; i < 3 && found == 0; ++i)
        found = sign(Wide{a.late[i]} * b.den, Wide{b.late[i]} * a.den);
    return found;
}
bool isBefore(const Moment& a, const Moment& b) {
    return compared(a, b) < 0;
}

constexpr Moment kStart = {};
constexpr Moment kNotMet = {1, 0, {}};

// When a ray crosses a coordinate on an axis on which it moves.
Moment crossing(std::int64_t from, std::int64_t way, std::int64_t at, int axis) {
    Moment moment = way > 0 ? Moment{at - from, way, {}} : Moment{from - at, -way, {}};
    moment.late[static_cast<std::size_t>(axis)] = way > 0 ? -1 : 1;
    return moment;
}

std::int64_t floorDivided(std::int64_t a, std::int64_t b) {
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

// Eight ways towards the sky from a sample: along the face's axes and outward, 3 units long, even
// over the sky as the face sees it.
constexpr std::int64_t kSky[8][3] = {{49152, 0, 190365},        {-62775, 57507, 177220},
                                     {9609, -109486, 163019},   {79124, 103203, 147456},
                                     {-145202, -25684, 130044}, {137548, -87497, 109907},
                                     {-46007, 171144, 85134},   {-87741, -168939, 49152}};

constexpr std::int64_t kHalf = 32768;
constexpr std::int64_t kQuarterUnit = 16384;
constexpr std::int64_t kLift = 16;

}  // namespace

LightTracer::LightTracer(const World& world, const Map& map) : world_(world), map_(map) {
    const BakedLight& baked = map.baked;
    const double level = cosDegrees(baked.altitude);
    sun_ = {toCoordinate(level * cosDegrees(baked.azimuth)).raw,
            toCoordinate(level * sinDegrees(baked.azimuth)).raw,
            toCoordinate(sinDegrees(baked.altitude)).raw};
    for (const Lamp& lamp : baked.lamps) lamps_.push_back({lamp, std::nullopt});
    for (const Object& object : map.objects) {
        if (object.lamp != kNoLamp)
            lamps_.push_back({{object.x,
                               object.y,
                               {object.z.raw + object.height.raw / 5 * 4},
                               world.lampKinds[object.lamp]},
                              std::nullopt});
    }
    for (int y = 0; y < map.depth; ++y) {
        for (int x = 0; x < map.width; ++x) {
            for (int level_ = 0; level_ < map.levels; ++level_) {
                const CellBlueprint& block = world.blueprints[map.cell(x, y, level_)];
                for (int kind = 0; kind < kFaces; ++kind) {
                    const LampId lamp = block.faces[static_cast<std::size_t>(kind)].lamp;
                    if (lamp == kNoLamp || map.cell(x, y, level_) == kEmptyCell) continue;
                    const auto area = areaOf({x, y, level_, kind});
                    if (!area) continue;
                    const Vector at = area->inFront((area->low[0] + area->high[0]) / 2,
                                                    (area->low[1] + area->high[1]) / 2, 4096);
                    const auto coordinate = [](std::int64_t raw) {
                        return Coordinate{static_cast<std::int32_t>(raw)};
                    };
                    lamps_.push_back({{coordinate(at[0]), coordinate(at[1]), coordinate(at[2]),
                                       world.lampKinds[lamp]},
                                      area->plane});
                }
            }
        }
    }
}

// The point of the plane at a place along a and b, rounded down, and so far before it.
LightTracer::Vector LightTracer::Area::inFront(std::int64_t atA, std::int64_t atB,
                                               std::int64_t distance) const {
    Vector point{};
    point[static_cast<std::size_t>(a)] = atA;
    point[static_cast<std::size_t>(b)] = atB;
    point[static_cast<std::size_t>(axis)] =
        floorDivided(-sign() * plane.at(point), 65536) + sign() * distance;
    return point;
}

// A block as light sees it.
std::optional<LightTracer::Solid> LightTracer::solidAt(int x, int y, int level) const {
    const BlueprintId id = map_.cell(x, y, level);
    if (id == kEmptyCell) return std::nullopt;
    const CellBlueprint& block = world_.blueprints[id];
    Vector low = {block.plan.west.raw, block.plan.north.raw, block.bottom.raw};
    Vector high = {block.plan.east.raw, block.plan.south.raw, block.top.raw};
    if (block.mover >= 0) {
        Axis axis = Axis::z;
        if (block.motion >= 0) axis = world_.motions[static_cast<std::size_t>(block.motion)].axis;
        auto& from = low[static_cast<std::size_t>(axis)];
        auto& to = high[static_cast<std::size_t>(axis)];
        from = from / kQuarterUnit * kQuarterUnit;
        to = (to + kQuarterUnit - 1) / kQuarterUnit * kQuarterUnit;
    }
    const std::int64_t west = tileEdge(x).raw;
    const std::int64_t north = tileEdge(y).raw;
    const std::int64_t base = tileEdge(level).raw;
    // How far the motion's offset is beyond a quarter of a unit; slopes lie that much further back
    const std::int64_t beyondX = block.textureEast.raw % kQuarterUnit;
    const std::int64_t beyondY = block.textureSouth.raw % kQuarterUnit;
    const std::int64_t beyondZ = block.textureRise.raw % kQuarterUnit;
    Solid solid;
    solid.low = {west + low[0], north + low[1], base + low[2]};
    solid.high = {west + high[0], north + high[1], base + high[2]};
    solid.id = id;
    for (int face = 0; face < kFaces; ++face) {
        const auto which = static_cast<Face>(face);
        const Half half = block.plan.half;
        Plane plane;
        plane.face = face;
        if (which == Face::top || which == Face::bottom) {
            // Heights over the edges of the tile where the slope's axis begins and ends
            const Slant& slant = which == Face::top ? block.slopes.top : block.slopes.bottom;
            const std::int64_t rise = slant.isLevel() ? 0 : slant.to.raw - slant.from.raw;
            const std::int64_t height = base + (!slant.isLevel()     ? slant.from.raw - beyondZ
                                                : which == Face::top ? high[2]
                                                                     : low[2]);
            const std::size_t along = block.slopes.alongX ? 0 : 1;
            plane.n[2] = 65536;
            plane.n[along] = -rise;
            plane.c = rise * ((along == 0 ? west - beyondX : north - beyondY) + slant.shift.raw) -
                      65536 * height;
        } else if (half != Half::none && cutFace(half) == which) {
            // From the north-western corner, or from the south-western one
            const std::int64_t way = isCutFalling(half) ? 1 : -1;
            plane.n = {-65536 * way, 65536, 0};
            plane.c = 65536 * (way * west - north - (way > 0 ? 0 : 65536));
        } else if (half != Half::none && !hasSide(half, which)) {
            continue;
        } else {
            const std::size_t axis = which == Face::east || which == Face::west ? 0 : 1;
            const bool isHigh = which == Face::east || which == Face::south;
            plane.n[axis] = 65536;
            plane.c = -65536 * (isHigh ? solid.high : solid.low)[axis];
        }
        if (which == Face::bottom || which == Face::west || which == Face::north) {
            for (std::int64_t& part : plane.n) part = -part;
            plane.c = -plane.c;
        }
        solid.planes.push_back(plane);
    }
    // A moving slope goes on beyond its part, which ends with its box
    for (const auto& [which, end] :
         {std::pair{Face::top, solid.high[2]}, {Face::bottom, -solid.low[2]}}) {
        if (block.mover < 0 || block.slopes.of(which).isLevel()) continue;
        Plane plane;
        plane.face = static_cast<int>(which);
        plane.n[2] = which == Face::top ? 65536 : -65536;
        plane.c = -65536 * end;
        solid.planes.push_back(plane);
    }
    return solid;
}

std::optional<LightTracer::Area> LightTracer::areaOf(const LitFace& face) const {
    const std::int64_t west = tileEdge(face.x).raw;
    const std::int64_t north = tileEdge(face.y).raw;
    if (!map_.contains(face.x, face.y)) return std::nullopt;
    if (face.kind >= LitFace::kFloor) {
        const bool floor = face.kind == LitFace::kFloor;
        if (!floor && (map_.ceiling.tiles.empty() ||
                       map_.ceiling.tiles[map_.tileIndex(face.x, face.y)] == kNoTexture))
            return std::nullopt;
        const std::int64_t sign = face.kind == LitFace::kCeilingBelow ? -1 : 1;
        const std::int64_t height = floor ? 0 : map_.ceiling.height.raw;
        return Area{{{0, 0, sign * 65536}, -sign * 65536 * height, face.kind},
                    2,
                    0,
                    1,
                    {west, north},
                    {west + 65536, north + 65536},
                    {west, north}};
    }
    if (face.level < 0 || face.level >= map_.levels) return std::nullopt;
    const auto solid = solidAt(face.x, face.y, face.level);
    if (!solid) return std::nullopt;
    const auto plane = std::find_if(solid->planes.begin(), solid->planes.end(),
                                    [&](const Plane& p) { return p.face == face.kind; });
    if (plane == solid->planes.end()) return std::nullopt;
    const auto which = static_cast<Face>(face.kind);
    Area area;
    area.plane = *plane;
    area.axis = which == Face::top || which == Face::bottom  ? 2
                : which == Face::east || which == Face::west ? 0
                                                             : 1;
    area.a = area.axis == 0 ? 1 : 0;
    area.b = area.axis == 2 ? 1 : 2;
    const Vector begin = {west, north, tileEdge(face.level).raw};
    const auto along = [&](const Vector& v) {
        return std::array{v[static_cast<std::size_t>(area.a)], v[static_cast<std::size_t>(area.b)]};
    };
    area.low = along(solid->low);
    area.high = along(solid->high);
    area.tile = along(begin);
    return area;
}

// Whether it is a slope's or a cut's.
bool LightTracer::isRising(const Plane& plane) {
    return std::count(plane.n.begin(), plane.n.end(), 0) < 2;
}

// Whether the point, moved by its small steps, is on the inner side.
bool LightTracer::isBehind(const Plane& plane, const Vector& point) {
    const std::int64_t at = plane.at(point);
    if (at != 0) return at < 0;
    const auto first =
        std::find_if(plane.n.begin(), plane.n.end(), [](std::int64_t part) { return part != 0; });
    return *first < 0;
}

// Whether no picture shows it, because it has no texture or is between parts of a mover.
bool LightTracer::isHidden(const LitFace& face) const {
    if (face.kind >= LitFace::kFloor) return false;
    const auto blockAt = [&](int level) -> const CellBlueprint& {
        return world_.blueprints[map_.cell(face.x, face.y, level)];
    };
    const CellBlueprint& block = blockAt(face.level);
    const auto which = static_cast<Face>(face.kind);
    const int next = face.level + (which == Face::top      ? 1
                                   : which == Face::bottom ? -1
                                                           : map_.levels);
    return block.face(which).texture == kNoTexture ||
           (next >= 0 && next < map_.levels && areOneMover(block, blockAt(next)));
}

bool LightTracer::isInOpaque(const Vector& point) const {
    if (point[2] < 0) return true;  // below the floor
    const auto tile = [](std::int64_t raw) { return static_cast<int>(raw >> 16); };
    const auto solid = solidAt(tile(point[0]), tile(point[1]), tile(point[2]));
    return solid && !world_.blueprints[solid->id].seeThrough &&
           std::all_of(solid->planes.begin(), solid->planes.end(),
                       [&](const Plane& plane) { return isBehind(plane, point); });
}

Rgb LightTracer::tintOf(TextureId texture) {
    const auto [found, isNew] = tints_.try_emplace(texture);
    if (!isNew) return found->second;
    const std::vector<Pixel>& texels = world_.textures[texture].levels[0].texels;
    std::array<std::int64_t, 3> sums{};
    for (const Pixel texel : texels) {
        const Colour c = toColour(texel);
        const std::int64_t clear = 255 - c.a;
        sums[0] += clear * (255 * clear + c.r * c.a);
        sums[1] += clear * (255 * clear + c.g * c.a);
        sums[2] += clear * (255 * clear + c.b * c.a);
    }
    const auto n = static_cast<std::int64_t>(texels.size());
    for (std::size_t i = 0; i < 3; ++i)
        found->second[i] = static_cast<int>((sums[i] + 32512 * n) / (65025 * n));
    return found->second;
}

Rgb LightTracer::through(const Vector& from, const Vector& way, bool endless) {
    Moment end = endless ? kNotMet : Moment{1, 1, {}};
    if (way[2] < 0 && isBefore(crossing(from[2], way[2], 0, 2), end)) return {0, 0, 0};
    const std::int64_t highest =
        std::max<std::int64_t>(tileEdge(map_.levels).raw, map_.ceiling.height.raw) + 1;
    // Where it could meet anything: tiles between its ends, or to where it leaves the map.
    std::array<std::int64_t, 2> low{};
    std::array<std::int64_t, 2> high{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int64_t last = tileEdge(i == 0 ? map_.width : map_.depth).raw;
        std::int64_t to = endless ? (way[i] > 0   ? last
                                     : way[i] < 0 ? 0
                                                  : from[i])
                                  : from[i] + way[i];
        if (endless && way[2] > 0 && way[i] != 0) {
            // No farther than where it is above everything, and a unit more
            const auto above = static_cast<double>(std::max<std::int64_t>(0, highest - from[2]));
            const double reach = static_cast<double>(way[i]) * above / static_cast<double>(way[2]);
            const std::int64_t there = from[i] + static_cast<std::int64_t>(reach);
            to = way[i] > 0 ? std::min(to, there + 65536) : std::max(to, there - 65536);
        }
        low[i] = std::max<std::int64_t>(0, std::min(from[i], to) >> 16) - 1;
        high[i] = std::min(last, std::max(from[i], to)) >> 16;
    }
    struct Met {
        Solid solid;
        Moment in;
        Moment out;
        int left = 0;  // the face
    };
    std::vector<Met> met;
    for (auto y = static_cast<int>(low[1]); y <= high[1]; ++y) {
        for (auto x = static_cast<int>(low[0]); x <= high[0]; ++x) {
            for (int level = 0; level < map_.levels; ++level) {
                const auto solid = solidAt(x, y, level);
                if (!solid) continue;
                Met here{*solid, {-1, 0, {}}, kNotMet};
                bool beside = false;
                for (const Plane& plane : solid->planes) {
                    const auto& n = plane.n;
                    const std::int64_t speed = plane.at(way) - plane.c;
                    const std::int64_t at = plane.at(from);
                    if (speed == 0) {
                        beside = beside || !isBehind(plane, from);
                    } else if (speed < 0) {
                        const Moment in = {at, -speed, n};
                        if (!isBefore(here.in, in)) continue;
                        here.in = in;
                    } else {
                        const Moment out = {-at, speed, {-n[0], -n[1], -n[2]}};
                        if (!isBefore(out, here.out)) continue;
                        here.out = out;
                        here.left = plane.face;
                    }
                }
                if (beside || !isBefore(here.in, here.out) || !isBefore(kStart, here.out) ||
                    !isBefore(here.in, end))
                    continue;
                if (!world_.blueprints[solid->id].seeThrough) return {0, 0, 0};
                met.push_back(std::move(here));
            }
        }
    }
    std::sort(met.begin(), met.end(),
              [](const Met& a, const Met& b) { return isBefore(a.out, b.out); });
    Rgb t = {255, 255, 255};
    const auto tint = [&](TextureId texture) {
        if (texture == kNoTexture) return;
        const Rgb by = tintOf(texture);
        for (std::size_t i = 0; i < 3; ++i) t[i] = (t[i] * by[i] + 127) / 255;
        sawTint = true;
    };
    for (const Met& left : met) {
        if (!isBefore(left.out, end)) continue;
        const CellBlueprint& block = world_.blueprints[left.solid.id];
        // Parts of a mover are one block where one stands on the other, and along its motion
        const Axis border =
            left.left == static_cast<int>(Face::top) || left.left == static_cast<int>(Face::bottom)
                ? Axis::z
            : left.left == static_cast<int>(Face::east) || left.left == static_cast<int>(Face::west)
                ? Axis::x
                : Axis::y;
        const bool isOneThere =
            border == Axis::z ||
            (block.motion >= 0 &&
             world_.motions[static_cast<std::size_t>(block.motion)].axis == border);
        const bool joins = std::any_of(met.begin(), met.end(), [&](const Met& next) {
            const CellBlueprint& other = world_.blueprints[next.solid.id];
            if (compared(next.in, left.out) != 0) return false;
            const bool isOne = areOneMover(block, other);
            sawMoverApart = sawMoverApart || (isOne && !isOneThere && !block.join);
            return areJoined(world_, block, other) || (isOneThere && isOne);
        });
        if (!joins) tint(block.faces[static_cast<std::size_t>(left.left)].texture);
    }
    if (map_.ceiling.tiles.empty() || way[2] == 0) return t;
    const Moment at = crossing(from[2], way[2], map_.ceiling.height.raw, 2);
    if (!isBefore(kStart, at) || !isBefore(at, end)) return t;
    for (auto y = static_cast<int>(low[1]); y <= high[1]; ++y) {
        for (auto x = static_cast<int>(low[0]); x <= high[0]; ++x) {
            if (!map_.contains(x, y)) continue;
            const TextureId texture = map_.ceiling.tiles[map_.tileIndex(x, y)];
            if (texture == kNoTexture) continue;
            bool crosses = true;
            for (std::size_t i = 0; i < 2; ++i) {
                const std::int64_t begin = tileEdge(i == 0 ? x : y).raw;
                if (way[i] == 0) {
                    crosses = crosses && from[i] >= begin && from[i] < begin + 65536;
                    continue;
                }
                const bool up = way[i] > 0;
                const int axis = static_cast<int>(i);
                crosses =
                    crosses &&
                    isBefore(crossing(from[i], way[i], up ? begin : begin + 65536, axis), at) &&
                    isBefore(at, crossing(from[i], way[i], up ? begin + 65536 : begin, axis));
            }
            if (!crosses) continue;
            if (!world_.textures[texture].seeThrough) return {0, 0, 0};
            tint(texture);
        }
    }
    return t;
}

Rgb LightTracer::lightOfSample(const Vector& at, const Area* area, int turns) {
    const BakedLight& baked = map_.baked;
    const auto channels = [](Colour c) { return Rgb{c.r, c.g, c.b}; };
    const auto cosine = [&](const Vector& way) {
        if (area == nullptr) return 1.0;
        const auto times = [](const Vector& a, const Vector& b) {
            return static_cast<double>(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
        };
        const Vector& n = area->plane.n;
        return times(n, way) / (std::sqrt(times(n, n)) * std::sqrt(times(way, way)));
    };
    Rgb light{};
    const int n = static_cast<int>(std::floor(256.0 * std::max(0.0, cosine(sun_)) + 0.5));
    if (n > 0) {
        const Rgb t = through(at, sun_, true);
        const Rgb sun = channels(baked.sun);
        for (std::size_t i = 0; i < 3; ++i) light[i] += (sun[i] * n * t[i] + 32640) / 65280;
    }
    Rgb sky = {1020, 1020, 1020};
    for (const auto& way : kSky) {
        std::int64_t a = way[0];
        std::int64_t b = way[1];
        for (int i = 0; i < turns; ++i) {
            const std::int64_t before = a;
            a = -b;
            b = before;
        }
        Vector v = {a, b, way[2]};
        if (area != nullptr) {
            // Along the face, and then outward
            const Plane through0 = {area->plane.n, 0, 0};
            v = Area{through0, area->axis, area->a, area->b}.inFront(a, b, way[2]);
        }
        const Rgb t = through(at, v, false);
        for (std::size_t i = 0; i < 3; ++i) sky[i] += t[i];
    }
    const Rgb ambient = channels(baked.ambient);
    for (std::size_t i = 0; i < 3; ++i) light[i] += (ambient[i] * sky[i] + 1530) / 3060;
    for (const HungLamp* const hung : lampsNear(at)) {
        const Lamp& lamp = hung->lamp;
        const Vector v = {lamp.x.raw - at[0], lamp.y.raw - at[1], lamp.z.raw - at[2]};
        const std::int64_t square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const std::int64_t r = lamp.kind.radius.raw;
        if (square >= r * r) continue;
        if (hung->plane && hung->plane->at(at) <= 0) continue;
        const double c = square == 0 ? (area == nullptr ? 1.0 : 0.0) : cosine(v);
        if (!(c > 0.0)) continue;
        const double w = 1.0 - static_cast<double>(square) / static_cast<double>(r * r);
        const Rgb t = through(at, v, false);
        const Rgb colour = channels(lamp.kind.colour);
        for (std::size_t i = 0; i < 3; ++i) {
            const double s =
                lamp.kind.strength * baked.lampStrength * colour[i] * w * w * (1.0 + 3.0 * c) / 4.0;
            light[i] += (static_cast<int>(std::floor(s + 0.5)) * t[i] + 127) / 255;
        }
    }
    return light;
}

const std::vector<const LightTracer::HungLamp*>& LightTracer::lampsNear(const Vector& at) {
    constexpr std::int64_t kSide = std::int64_t{4} * 65536;
    Vector low{};
    for (std::size_t i = 0; i < 3; ++i) low[i] = floorDivided(at[i], kSide) * kSide;
    const auto [found, isNew] = nearLamps_.try_emplace(low);
    if (!isNew) return found->second;
    std::multimap<std::int64_t, const HungLamp*> byDistance;
    for (const HungLamp& hung : lamps_) {
        const Vector lamp = {hung.lamp.x.raw, hung.lamp.y.raw, hung.lamp.z.raw};
        std::int64_t toNearest = 0;
        std::int64_t toMiddle = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t nearest = std::clamp(lamp[i], low[i], low[i] + kSide);
            const std::int64_t middle = low[i] + kSide / 2;
            toNearest += (lamp[i] - nearest) * (lamp[i] - nearest);
            toMiddle += (lamp[i] - middle) * (lamp[i] - middle);
        }
        const std::int64_t r = hung.lamp.kind.radius.raw;
        if (toNearest < r * r) byDistance.emplace(toMiddle, &hung);
    }
    for (const auto& [distance, hung] : byDistance) {
        if (found->second.size() < 64) found->second.push_back(hung);
    }
    return found->second;
}

// The quarter in a column and row from 0 to 3 of its face.
LightTracer::Sample LightTracer::sampleOf(const LitFace& face, int column, int row) {
    const auto [found, isNew] = samples_.try_emplace({face, column, row});
    if (!isNew) return found->second;
    Sample& sample = found->second;
    const auto area = areaOf(face);
    if (!area) return sample;
    const std::array place = {column, row};
    std::array<std::int64_t, 2> along{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int64_t begin = area->tile[i] + place[i] / 2 * kHalf;
        const std::int64_t low = std::max(area->low[i], begin);
        const std::int64_t high = std::min(area->high[i], begin + kHalf);
        if (low >= high) return sample;
        along[i] = low + (high - low) * (place[i] % 2 == 0 ? 1 : 3) / 4;
    }
    sample.at = area->inFront(along[0], along[1], kLift);
    sample.counts = !isInOpaque(sample.at);
    sawBelowFloor = sawBelowFloor || (sample.at[2] < 0 && isRising(area->plane));
    constexpr int kTurns[2][2] = {{0, 3}, {1, 2}};
    if (sample.counts) sample.light = lightOfSample(sample.at, &*area, kTurns[column % 2][row % 2]);
    return sample;
}

const LightTracer::Nodes& LightTracer::nodesOf(const LitFace& face) {
    const auto [found, isNew] = nodes_.try_emplace(face);
    if (!isNew) return found->second;
    const auto area = areaOf(face);
    // The quarter in a column and row that may be those of a face beside.
    const auto quarter = [&](int column, int row) -> Sample {
        const int stepA = column < 0 ? -1 : column > 3 ? 1 : 0;
        const int stepB = row < 0 ? -1 : row > 3 ? 1 : 0;
        std::optional<LitFace> at;
        // Where a plane rises it may go on in a tile beside the next one, or in another level
        const Vector& n = area->plane.n;
        const bool rises = n[static_cast<std::size_t>(area->a)] * stepA +
                               n[static_cast<std::size_t>(area->b)] * stepB !=
                           0;
        for (const int off : {0, 1, -1}) {
            LitFace next = face;
            (area->a == 0 ? next.x : next.y) += stepA;
            (area->b == 2 ? next.level : next.y) += stepB;
            (area->axis == 2 ? next.level : area->axis == 1 ? next.y : next.x) += off;
            if (at || (off != 0 && !rises)) continue;
            const auto beside = areaOf(next);
            if (beside && beside->plane == area->plane) at = next;
        }
        if (!at) return {};
        if (isRising(area->plane) && (stepA != 0 || stepB != 0)) {
            sawGoOn = true;
            sawClimb = sawClimb || (area->axis == 2 && at->level != face.level);
        }
        const Sample sample = sampleOf(*at, column - 4 * stepA, row - 4 * stepB);
        sawHiddenFace = sawHiddenFace || (sample.counts && isHidden(*at) && !isHidden(face));
        return sample;
    };
    const Rgb everywhere = {map_.baked.ambient.r, map_.baked.ambient.g, map_.baked.ambient.b};
    const auto mean = [&](const std::vector<Sample>& samples) {
        Rgb light{};
        const auto n = static_cast<int>(samples.size());
        for (std::size_t i = 0; i < 3; ++i) {
            int sum = 0;
            if (n == 0) {
                light[i] = (everywhere[i] * 1020 + 1530) / 3060;
                continue;
            }
            for (const Sample& sample : samples) sum += sample.light[i];
            light[i] = (sum + n / 2) / n;
        }
        return held(light);
    };
    for (int squareA = 0; squareA < 2; ++squareA) {
        for (int squareB = 0; squareB < 2; ++squareB) {
            for (int nodeA = 0; nodeA < 2; ++nodeA) {
                for (int nodeB = 0; nodeB < 2; ++nodeB) {
                    const int column = 2 * (squareA + nodeA) - 1;
                    const int row = 2 * (squareB + nodeB) - 1;
                    // Round the node: 0 low low, 1 high low, 2 high high, 3 low high
                    const std::array<Sample, 4> round = {
                        quarter(column, row), quarter(column + 1, row),
                        quarter(column + 1, row + 1), quarter(column, row + 1)};
                    const auto linked = [&](std::size_t i) {  // to the next one
                        const Sample* a = &round[i];
                        const Sample* b = &round[(i + 1) % 4];
                        if (!a->counts || !b->counts) return false;
                        if (i >= 2) std::swap(a, b);
                        Vector way{};
                        for (std::size_t k = 0; k < 3; ++k) way[k] = b->at[k] - a->at[k];
                        const bool tint = sawTint;
                        const Rgb t = through(a->at, way, false);
                        sawTint = tint;
                        return t != Rgb{0, 0, 0};
                    };
                    const std::size_t own =
                        nodeA == 0 ? (nodeB == 0 ? 2 : 1) : (nodeB == 0 ? 3 : 0);
                    std::array<bool, 4> in{};
                    in[own] = round[own].counts;
                    for (int again = 0; again < 3; ++again) {
                        for (std::size_t i = 0; i < 4; ++i) {
                            const std::size_t next = (i + 1) % 4;
                            if (in[i] != in[next] && linked(i)) in[i] = in[next] = true;
                        }
                    }
                    std::vector<Sample> lit;
                    std::size_t counting = 0;
                    for (std::size_t i = 0; i < 4; ++i) {
                        counting += round[i].counts ? 1 : 0;
                        if (in[i]) lit.push_back(round[i]);
                    }
                    if (!lit.empty() && lit.size() < counting) sawPartlyLinked = true;
                    const auto collect = [&](bool ofFace) {
                        for (int i = 0; i < 16 && (ofFace || i < 4); ++i) {
                            const Sample sample =
                                ofFace ? quarter(i % 4, i / 4)
                                       : quarter(2 * squareA + i % 2, 2 * squareB + i / 2);
                            if (sample.counts) lit.push_back(sample);
                        }
                    };
                    if (lit.empty()) {
                        sawOddSquare = true;
                        collect(false);
                    }
                    if (lit.empty()) collect(true);
                    found->second[nodeIndex(squareA, squareB, nodeA, nodeB)] = mean(lit);
                }
            }
        }
    }
    return found->second;
}

Rgb LightTracer::lightAt(const LitFace& face, int placeA, int placeB) {
    const Nodes& nodes = nodesOf(face);
    const auto area = areaOf(face);
    if (isRising(area->plane)) (area->axis == 2 ? sawSlope : sawCut) = true;
    const int squareA = placeA / 32768;
    const int squareB = placeB / 32768;
    const int a = placeA % 32768 / 256;
    const int b = placeB % 32768 / 256;
    Rgb light{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = [&](int nodeA, int nodeB) {
            return nodes[nodeIndex(squareA, squareB, nodeA, nodeB)][i];
        };
        light[i] = (at(0, 0) * (128 - a) * (128 - b) + at(1, 0) * a * (128 - b) +
                    at(0, 1) * (128 - a) * b + at(1, 1) * a * b + 8192) /
                   16384;
        light[i] += light[i] / 128;
    }
    return light;
}

Rgb LightTracer::lightOutside() {
    const BakedLight& baked = map_.baked;
    const auto z = static_cast<double>(sun_[2]);
    const double length =
        std::sqrt(static_cast<double>(sun_[0]) * static_cast<double>(sun_[0]) +
                  static_cast<double>(sun_[1]) * static_cast<double>(sun_[1]) + z * z);
    const int n = static_cast<int>(std::floor(256.0 * std::max(0.0, z / length) + 0.5));
    const Rgb sun = {baked.sun.r, baked.sun.g, baked.sun.b};
    const Rgb ambient = {baked.ambient.r, baked.ambient.g, baked.ambient.b};
    Rgb light{};
    for (std::size_t i = 0; i < 3; ++i) {
        light[i] = (sun[i] * n * 255 + 32640) / 65280 + ambient[i];
    }
    light = held(light);
    for (int& c : light) c += c / 128;
    return light;
}

Rgb LightTracer::lightOf(const Object& object) {
    const auto [found, isNew] = objects_.try_emplace(&object);
    if (!isNew) return found->second;
    std::vector<Vector> places;
    for (int i = 0; i < 4; ++i) {
        const std::int64_t quarter = object.width.raw / 4;
        places.push_back({object.x.raw + (i == 1 || i == 2 ? quarter : -quarter),
                          object.y.raw + (i >= 2 ? quarter : -quarter),
                          object.z.raw + object.height.raw / 2});
    }
    const bool any = std::any_of(places.begin(), places.end(),
                                 [&](const Vector& at) { return !isInOpaque(at); });
    Rgb sum{};
    int n = 0;
    for (int i = 0; i < 4; ++i) {
        const Vector& at = places[static_cast<std::size_t>(i)];
        if (any && isInOpaque(at)) continue;
        const Rgb light = lightOfSample(at, nullptr, i);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += light[k];
        ++n;
    }
    for (int& c : sum) c = (c + n / 2) / n;
    sum = held(sum);
    for (int& c : sum) c += c / 128;
    found->second = sum;
    return sum;
}

}  // namespace slicecast::judge
