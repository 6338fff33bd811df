#include "tracer.h"

#include "base/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast::judge {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// The next level of detail: 2 x 2 texels become one, colours weighted by alpha.
Image nextLevel(const Image& image) {
    Image next(image.width / 2, image.height / 2);
    for (int y = 0; y < next.height; ++y) {
        for (int x = 0; x < next.width; ++x) {
            int sumOfAlpha = 0;
            int sum[3] = {0, 0, 0};
            for (int i = 0; i < 4; ++i) {
                const Colour c = toColour(image.at(2 * x + i % 2, 2 * y + i / 2));
                sumOfAlpha += c.a;
                sum[0] += c.r * c.a;
                sum[1] += c.g * c.a;
                sum[2] += c.b * c.a;
            }
            Colour mean{0, 0, 0, static_cast<std::uint8_t>((sumOfAlpha + 2) / 4)};
            if (sumOfAlpha > 0) {
                mean.r = static_cast<std::uint8_t>((sum[0] + sumOfAlpha / 2) / sumOfAlpha);
                mean.g = static_cast<std::uint8_t>((sum[1] + sumOfAlpha / 2) / sumOfAlpha);
                mean.b = static_cast<std::uint8_t>((sum[2] + sumOfAlpha / 2) / sumOfAlpha);
            }
            next.at(x, y) = toPixel(mean);
        }
    }
    return next;
}

double clampTo(double value, double low, double high) { return value < low ? low : value > high ? high : value; }

}  // namespace

// The ray's direction, d units of t ahead: d * (forward + k * right + s * up) = d * forward + (x - W / 2) * right + (horizon - y) * up. Without the division
// by d, rays through corners and along edges keep exact numbers, and equal quotients below come out equal.
struct Tracer::Ray {
    double x;
    double y;
    double up;
    double slope;
    double sideways;
};

// How far along the ray something is met: distance / speed on the axis that it was found on, so that points can be worked out before the division rounds.
struct Tracer::Meeting {
    double distance = 0.0;
    double speed = 1.0;

    double along() const { return distance / speed; }
    double at(double direction) const { return direction * distance / speed; }
};

// A border between tiles. It is met "early" when it is crossed eastward or southward, for the eye counts as a little further that way.
struct Tracer::Border {
    Meeting meeting;
    double along;
    bool alongX;
    bool early;
};

Tracer::Tracer(const World& world, const View& view) : world_(world), map_(world.maps[static_cast<std::size_t>(view.map)]), view_(view) {
    distance_ = (view.width / 2.0) / tanDegrees(view.fovDegrees / 2.0);
    forwardX_ = cosDegrees(view.headingDegrees);
    forwardY_ = sinDegrees(view.headingDegrees);
    // A sheet's frames follow one another for ever.
    const auto levelsOf = [&](const Image& sheet, int frames, double rate) {
        const int width = sheet.width / frames;
        const int frame = frames == 1 ? 0 : static_cast<int>(static_cast<std::int64_t>(std::floor(world.seconds * rate)) % frames);
        Image shown(width, sheet.height);
        for (int y = 0; y < shown.height; ++y) {
            for (int x = 0; x < width; ++x) shown.at(x, y) = sheet.at(frame * width + x, y);
        }
        std::vector<Image> levels = {shown};
        while (levels.back().width % 2 == 0 && levels.back().height % 2 == 0) levels.push_back(nextLevel(levels.back()));
        return levels;
    };
    for (const Texture& texture : world.textures) levels_.push_back(levelsOf(texture.image, texture.image.width / texture.image.height, texture.rate));
    for (const Sprite& sprite : world.sprites) spriteLevels_.push_back(levelsOf(sprite.image, static_cast<int>(sprite.frames.size()), sprite.rate));
}

void Tracer::look(double x, double y, std::vector<Sight>& sights) const {
    sights.clear();
    lookAtMap(x, y, sights);
    if (!map_.objects.empty()) addObjects(x, y, sights);
}

// Every object is a rectangle at one depth t, that of its middle to the nearest 1/65536; it comes after whatever else is at that depth.
void Tracer::addObjects(double px, double py, std::vector<Sight>& sights) const {
    const double k = (px - view_.width / 2.0) / distance_;
    const double slope = (view_.height / 2.0 + view_.look * view_.height - py) / distance_;
    std::vector<Sight> met;
    for (const Object& object : map_.objects) {
        const double dx = (object.x - view_.x).value();
        const double dy = (object.y - view_.y).value();
        const double t = std::floor(65536.0 * (forwardX_ * dx + forwardY_ * dy) + 0.5) / 65536.0;
        if (t <= 0.0) continue;
        const double left = -forwardY_ * dx + forwardX_ * dy - object.width.value() / 2.0;
        const double across = (k * t - left) / object.width.value();
        const double height = (view_.z - object.z).value() + slope * t;
        const double down = 1.0 - height / object.height.value();
        if (across < 0.0 || across >= 1.0 || height < 0.0 || height >= object.height.value()) continue;
        Sight sight;
        sight.kind = Sight::Kind::object;
        sight.seeThrough = true;
        sight.texture = object.sprite;
        sight.faceLight = object.light;
        sight.glow = object.glow;
        sight.depth = t;
        sight.u = across;
        sight.v = clampTo(down, 0.0, 1.0);
        met.push_back(sight);
    }
    std::stable_sort(met.begin(), met.end(), [](const Sight& a, const Sight& b) { return a.depth < b.depth; });
    const double end = sights.back().kind == Sight::Kind::sky ? kNever : sights.back().depth;
    for (const Sight& object : met) {
        if (object.depth >= end) break;
        const auto behind = std::find_if(sights.begin(), sights.end(), [&](const Sight& s) { return s.kind == Sight::Kind::sky || s.depth > object.depth; });
        sights.insert(behind, object);
    }
}

const Image& Tracer::imageOf(const Sight& sight, int level) const {
    return (sight.kind == Sight::Kind::object ? spriteLevels_ : levels_)[sight.texture][static_cast<std::size_t>(level)];
}

void Tracer::lookAtMap(double px, double py, std::vector<Sight>& sights) const {
    const double q = px - view_.width / 2.0;
    const double horizon = view_.height / 2.0 + view_.look * view_.height;
    const double up = horizon - py;
    const Ray ray = {distance_ * forwardX_ - q * forwardY_, distance_ * forwardY_ + q * forwardX_, up, up / distance_, q / distance_};

    const double eyeX = view_.x.value();
    const double eyeY = view_.y.value();
    const double eyeZ = view_.z.value();
    const bool falls = ray.up < 0.0;

    // Where the ray is at a height. The eye counts as a trifle above its own height: a ray that rises or runs level is above it from the start, one that falls
    // crosses it at once.
    const auto meetingOfHeight = [&](double height) { return Meeting{height - eyeZ, ray.up}; };
    const auto alongOfHeight = [&](double height) -> double {
        if (height == eyeZ) return falls ? 0.0 : -kNever;
        if (ray.up == 0.0) return height < eyeZ ? -kNever : kNever;
        const double along = meetingOfHeight(height).along();
        return along > 0.0 ? along : falls ? kNever : -kNever;
    };
    const auto crossedBefore = [&](double height, const Border& border) {
        const double along = alongOfHeight(height);
        return along < border.along || (along == border.along && !border.early);
    };
    // Is the ray above a height when it crosses a border? A falling ray is not above what lies higher than the eye, a rising one always above what lies lower.
    const auto isAbove = [&](double height, const Border& border) { return falls ? height <= eyeZ && !crossedBefore(height, border) : crossedBefore(height, border); };
    const auto isAboveAtStart = [&](double height) { return height <= eyeZ; };

    int tileX = view_.x.tile();
    int tileY = view_.y.tile();
    bool first = true;
    Border enter{{}, 0.0, false, false};

    for (;;) {
        // The border that is met next.
        const auto next = [](int tile, double eye, double direction) {
            return direction > 0.0 ? Meeting{tile + 1 - eye, direction} : direction < 0.0 ? Meeting{eye - tile, -direction} : Meeting{kNever, 1.0};
        };
        const Meeting meetingX = next(tileX, eyeX, ray.x);
        const Meeting meetingY = next(tileY, eyeY, ray.y);
        const bool alongX = meetingX.along() < meetingY.along() || (meetingX.along() == meetingY.along() && ray.x > 0.0);
        const Border leave = alongX ? Border{meetingX, meetingX.along(), true, ray.x > 0.0} : Border{meetingY, meetingY.along(), false, ray.y > 0.0};

        if (!map_.contains(tileX, tileY)) {
            const bool goneX = tileX < 0 ? ray.x <= 0.0 : tileX >= map_.width && ray.x >= 0.0;
            const bool goneY = tileY < 0 ? ray.y <= 0.0 : tileY >= map_.depth && ray.y >= 0.0;
            if (falls && (goneX || goneY || crossedBefore(0.0, leave))) {
                const Meeting floor = meetingOfHeight(0.0);
                if (floor.along() * distance_ > map_.far) return sights.push_back(background(ray));
                // Outside, the tile is the one that the point is in.
                Sight sight = plane(ray, Sight::Kind::floor, map_.floor.texture, map_.floor.light, static_cast<int>(std::floor(eyeX + floor.at(ray.x))),
                                    static_cast<int>(std::floor(eyeY + floor.at(ray.y))), floor);
                sight.outsideGrid = true;
                sights.push_back(sight);
                if (sight.seeThrough) sights.push_back(background(ray));
                return;
            }
            if (goneX || goneY) return sights.push_back(background(ray));
        } else {
            // The heights at which something lies in this tile, in the order in which the ray meets them.
            struct Event {
                double height;
                double along;
                int order;  // at equal depth: faces left, then faces entered, then planes
                int level;  // of the block; -1 for the floor, -2 for the ceiling
                bool top;
            };
            Event events[2 * kMaxLevels + 2];
            int count = 0;
            int inside = -1;
            const auto atEntry = [&](double height) { return first ? isAboveAtStart(height) : isAbove(height, enter); };
            const auto add = [&](double height, int order, int level, bool top) {
                // Crossed after the entry and before the exit.
                const bool met = ray.up != 0.0 && (falls ? atEntry(height) && !isAbove(height, leave) : !atEntry(height) && isAbove(height, leave));
                if (met) events[count++] = {height, alongOfHeight(height), order, level, top};
            };
            for (int level = 0; level < map_.levels; ++level) {
                const BlueprintId id = map_.cell(tileX, tileY, level);
                if (id == kEmptyCell) continue;
                const CellBlueprint& block = world_.blueprints[id];
                const double bottom = level + block.bottom.value();
                const double top = level + block.top.value();
                if (atEntry(bottom) && !atEntry(top)) {
                    if (!first && enter.along > 0.0) {
                        const Face entered = enter.alongX ? (ray.x > 0.0 ? Face::west : Face::east) : (ray.y > 0.0 ? Face::north : Face::south);
                        const int stepX = enter.alongX ? (ray.x > 0.0 ? 1 : -1) : 0;
                        const int stepY = enter.alongX ? 0 : (ray.y > 0.0 ? 1 : -1);
                        if (!joined(id, tileX - stepX, tileY - stepY, level)) sights.push_back(face(ray, block, level, entered, tileX, tileY, enter.meeting, false));
                        if (!block.seeThrough) return;
                    }
                    inside = level;
                }
                add(bottom, falls ? 0 : 1, level, false);
                add(top, falls ? 1 : 0, level, true);
            }
            add(0.0, 2, -1, false);
            const TextureId ceiling = map_.ceiling.tiles.empty() ? kNoTexture : map_.ceiling.tiles[map_.tileIndex(tileX, tileY)];
            if (ceiling != kNoTexture) add(map_.ceiling.height.value(), 2, -2, false);
            std::sort(events, events + count, [](const Event& a, const Event& b) { return a.along != b.along ? a.along < b.along : a.order < b.order; });

            for (int i = 0; i < count; ++i) {
                const Event& event = events[i];
                const Meeting meeting = meetingOfHeight(event.height);
                if (event.level == -1) {
                    if (meeting.along() * distance_ > map_.far) return sights.push_back(background(ray));
                    sights.push_back(plane(ray, Sight::Kind::floor, map_.floor.tiles[map_.tileIndex(tileX, tileY)], map_.floor.light, tileX, tileY, meeting));
                    if (sights.back().seeThrough) sights.push_back(background(ray));
                    return;
                }
                if (event.level == -2) {
                    if (event.along <= 0.0) continue;
                    sights.push_back(plane(ray, Sight::Kind::ceiling, ceiling, map_.ceiling.light, tileX, tileY, meeting));
                    if (!sights.back().seeThrough) return;
                    continue;
                }
                const bool leaves = event.top != falls;  // upwards through the top, downwards through the bottom
                if (event.along > 0.0) {
                    const BlueprintId id = map_.cell(tileX, tileY, event.level);
                    const CellBlueprint& block = world_.blueprints[id];
                    // Blocks above one another touch only if they fill their levels.
                    const bool full = block.bottom == Coordinate{0} && block.top == tileEdge(1);
                    if (!full || !joined(id, tileX, tileY, event.level + (event.top ? 1 : -1))) {
                        sights.push_back(face(ray, block, event.level, event.top ? Face::top : Face::bottom, tileX, tileY, meeting, leaves));
                    }
                    if (!block.seeThrough) return;
                }
                inside = leaves ? -1 : event.level;
            }
            if (inside >= 0 && leave.along > 0.0) {
                const BlueprintId id = map_.cell(tileX, tileY, inside);
                const CellBlueprint& block = world_.blueprints[id];
                const Face left = leave.alongX ? (ray.x > 0.0 ? Face::east : Face::west) : (ray.y > 0.0 ? Face::south : Face::north);
                const int stepX = leave.alongX ? (ray.x > 0.0 ? 1 : -1) : 0;
                const int stepY = leave.alongX ? 0 : (ray.y > 0.0 ? 1 : -1);
                if (!joined(id, tileX + stepX, tileY + stepY, inside)) sights.push_back(face(ray, block, inside, left, tileX, tileY, leave.meeting, true));
                if (!block.seeThrough) return;
            }
        }

        if (leave.alongX) {
            tileX += ray.x > 0.0 ? 1 : -1;
        } else {
            tileY += ray.y > 0.0 ? 1 : -1;
        }
        enter = leave;
        first = false;
    }
}

// Of two see-through blocks of one blueprint that touch, the faces between them are not there.
bool Tracer::joined(BlueprintId block, int tileX, int tileY, int level) const {
    const CellBlueprint& blueprint = world_.blueprints[block];
    return blueprint.seeThrough && blueprint.join && map_.cell(tileX, tileY, level) == block;
}

// A point on a block's face. Seen from outside no lettering is mirrored: u runs with x on the south side, against it on the north side, with y on the west side,
// against it on the east side; v runs downwards over the whole level. The top shows the map as from above, the bottom with its rows reversed.
Sight Tracer::face(const Ray& ray, const CellBlueprint& block, int level, Face which, int tileX, int tileY, const Meeting& meeting, bool fromInside) const {
    const FaceBlueprint& look = block.face(which);
    const double x = clampTo(view_.x.value() + meeting.at(ray.x) - tileX, 0.0, 1.0);
    const double y = clampTo(view_.y.value() + meeting.at(ray.y) - tileY, 0.0, 1.0);
    const double z = clampTo(view_.z.value() + meeting.at(ray.up) - level, block.bottom.value(), block.top.value());
    Sight sight;
    sight.face = which;
    sight.fromInside = fromInside;
    sight.seeThrough = block.seeThrough;
    sight.texture = look.texture;
    sight.faceLight = look.light;
    sight.glow = look.glow;
    sight.depth = meeting.along() * distance_;
    switch (which) {
        case Face::south: sight.u = x; break;
        case Face::north: sight.u = -x; break;
        case Face::west: sight.u = y; break;
        case Face::east: sight.u = -y; break;
        default: sight.u = x; break;
    }
    if (which == Face::top) {
        sight.kind = Sight::Kind::roof;
        sight.v = y;
    } else if (which == Face::bottom) {
        sight.kind = Sight::Kind::underside;
        sight.v = -y;
    } else {
        sight.kind = Sight::Kind::side;
        sight.v = 1.0 - z;
    }
    return sight;
}

Sight Tracer::plane(const Ray& ray, Sight::Kind kind, TextureId texture, double light, int tileX, int tileY, const Meeting& meeting) const {
    Sight sight;
    sight.kind = kind;
    sight.texture = texture;
    sight.seeThrough = world_.textures[texture].seeThrough;
    sight.faceLight = light;
    sight.glow = kind == Sight::Kind::floor ? map_.floor.glow : map_.ceiling.glow;
    sight.depth = meeting.along() * distance_;
    sight.u = clampTo(view_.x.value() + meeting.at(ray.x) - tileX, 0.0, 1.0);
    const double y = clampTo(view_.y.value() + meeting.at(ray.y) - tileY, 0.0, 1.0);
    sight.v = kind == Sight::Kind::ceiling ? -y : y;
    return sight;
}

Sight Tracer::background(const Ray& ray) const {
    Sight sight;
    if (ray.slope < 0.0) {
        sight.kind = Sight::Kind::haze;
        sight.colour = map_.haze;
        sight.depth = (0.0 - view_.z.value()) / ray.slope;
        return sight;
    }
    sight.kind = Sight::Kind::sky;
    const Sky& sky = map_.sky;
    const double height = std::min(1.0, ray.slope / sky.slope);
    switch (sky.kind) {
        case Sky::Kind::colour: sight.colour = sky.low; break;
        case Sky::Kind::gradient: {
            const auto mix = [&](int a, int b) { return static_cast<std::uint8_t>(std::floor(a + (b - a) * height + 0.5)); };
            sight.colour = {mix(sky.low.r, sky.high.r), mix(sky.low.g, sky.high.g), mix(sky.low.b, sky.high.b), 255};
            break;
        }
        case Sky::Kind::panorama: {
            const double azimuth = (view_.headingDegrees + atanDegrees(ray.sideways)) / 360.0;
            const int w = sky.panorama.width;
            const int h = sky.panorama.height;
            const int column = std::min(w - 1, static_cast<int>(std::floor((azimuth - std::floor(azimuth)) * w)));
            const int row = std::min(h - 1, static_cast<int>(std::floor((1.0 - height) * h)));
            sight.colour = toColour(sky.panorama.at(column, row));
            break;
        }
    }
    return sight;
}

int Tracer::level(const Sight& sight, double depthFactor) const {
    if (!view_.detail || sight.texture == kNoTexture) return 0;
    const int last = static_cast<int>((sight.kind == Sight::Kind::object ? spriteLevels_ : levels_)[sight.texture].size()) - 1;
    const int texels = imageOf(sight, 0).height;
    int level = 0;
    for (double threshold = 1.0; level < last && sight.depth * depthFactor * texels > threshold * distance_; threshold *= 2.0) ++level;
    return level;
}

Colour Tracer::colour(const Sight& sight, double depthFactor) const {
    if (sight.kind == Sight::Kind::sky || sight.kind == Sight::Kind::haze) return sight.colour;
    const double depth = sight.depth * depthFactor;
    if (sight.kind == Sight::Kind::floor && depth > map_.far) return map_.haze;
    const Image& image = imageOf(sight, level(sight, depthFactor));
    // A negative fraction stands for a reversed one: texel N - 1 - i.
    const auto texel = [](double fraction, int n) {
        const int i = std::min(n - 1, static_cast<int>(std::floor(std::fabs(fraction) * n)));
        return std::signbit(fraction) ? n - 1 - i : i;
    };
    const Colour raw = toColour(image.at(texel(sight.u, image.width), texel(sight.v, image.height)));

    const double falloff = map_.light.on && view_.light ? map_.light.intensity * map_.light.multiplier / depth : 1.0;
    const double bright = (sight.glow ? 1.0 : clampTo(falloff, map_.light.darkest, map_.light.brightest)) * sight.faceLight;
    const int q = std::min(256, static_cast<int>(std::floor(256.0 * bright + 0.5)));
    int fog = 0;
    if (map_.fog.on && view_.fog) {
        fog = static_cast<int>(std::floor(255.0 * clampTo((depth - map_.fog.start) / (map_.fog.end - map_.fog.start), 0.0, 1.0) + 0.5));
    }
    const auto channel = [&](int c, int haze) { return static_cast<std::uint8_t>((haze * fog + ((c * q + 128) >> 8) * (255 - fog) + 127) / 255); };
    return {channel(raw.r, map_.haze.r), channel(raw.g, map_.haze.g), channel(raw.b, map_.haze.b), raw.a};
}

}  // namespace slicecast::judge
