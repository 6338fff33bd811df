#include "verdict.h"

#include <algorithm>
#include <cstdlib>

namespace slicecast::judge {
namespace {

constexpr std::size_t kComplaints = 5;
constexpr double kRadii[] = {1.0 / 64, 1.0 / 512, 1.0 / 4096, 1.0 / 32768};
constexpr int kDirections[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
constexpr double kDiagonal = 0.70710678;
constexpr double kDepthFactors[] = {1.0, 1.0 - 1e-6, 1.0 + 1e-6};

bool alike(Colour a, Colour b) { return std::abs(a.r - b.r) <= 1 && std::abs(a.g - b.g) <= 1 && std::abs(a.b - b.b) <= 1 && a.a == b.a; }

bool shows(const Tracer& tracer, const Sight& sight, Colour found) {
    return std::any_of(std::begin(kDepthFactors), std::end(kDepthFactors), [&](double f) { return alike(tracer.colour(sight, f), found); });
}

bool excusable(const Tracer& tracer, double x, double y, Colour found) {
    for (const double radius : kRadii) {
        for (const auto& direction : kDirections) {
            const double length = direction[0] != 0 && direction[1] != 0 ? radius * kDiagonal : radius;
            if (shows(tracer, tracer.look(x + direction[0] * length, y + direction[1] * length), found)) return true;
        }
    }
    return false;
}

std::string nameOf(const World& world, const Map& map, const Tracer& tracer, const Sight& sight) {
    static const char* const kKinds[] = {"side", "roof", "underside", "floor", "ceiling", "sky", "haze"};
    static const char* const kSkies[] = {"colour", "gradient", "panorama"};
    std::string name = kKinds[static_cast<int>(sight.kind)];
    if (sight.kind == Sight::Kind::side) name = kFaceNames[static_cast<std::size_t>(sight.face)];
    if (sight.kind == Sight::Kind::sky) return name + " " + kSkies[static_cast<int>(map.sky.kind)];
    if (sight.kind == Sight::Kind::haze) return name;
    if (sight.fromInside) name += " from inside";
    if (sight.outsideGrid) name += " outside";
    if (tracer.level(sight) > 0) name += tracer.level(sight) + 1 == static_cast<int>(world.textures[sight.texture].levels.size()) ? " last level" : " smaller";
    return name;
}

std::string words(Colour c) { return "(" + std::to_string(c.r) + " " + std::to_string(c.g) + " " + std::to_string(c.b) + " " + std::to_string(c.a) + ")"; }

}  // namespace

void Verdict::add(const Verdict& other) {
    pixels += other.pixels;
    excused += other.excused;
    unexcused += other.unexcused;
    crowded += other.crowded;
    for (const std::string& complaint : other.complaints) {
        if (complaints.size() < kComplaints) complaints.push_back(complaint);
    }
    for (const auto& [name, count] : other.coverage) coverage[name] += count;
}

Verdict judge(const World& world, const View& view, const Pixel* pixels, int pitch, const std::string& name) {
    const Tracer tracer(world, view);
    const Map& map = world.maps[static_cast<std::size_t>(view.map)];
    Verdict verdict;
    std::map<std::uint32_t, std::int64_t> counts;  // by kind, face and the like: names are made once at the end
    std::map<std::uint32_t, std::string> names;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const Colour found = toColour(pixels[static_cast<std::ptrdiff_t>(y) * pitch + x]);
            const Sight sight = tracer.look(x + 0.5, y + 0.5);
            ++verdict.pixels;
            const auto key = static_cast<std::uint32_t>(static_cast<int>(sight.kind) | static_cast<int>(sight.face) << 4 | sight.fromInside << 8 |
                                                        sight.outsideGrid << 9 | tracer.level(sight) << 12 | (sight.texture & 0xff) << 16);
            if (++counts[key] == 1) names[key] = nameOf(world, map, tracer, sight);
            if (shows(tracer, sight, found)) continue;
            if (excusable(tracer, x + 0.5, y + 0.5, found)) {
                ++verdict.excused;
                continue;
            }
            ++verdict.unexcused;
            if (verdict.complaints.size() < kComplaints) {
                verdict.complaints.push_back(name + ", pixel " + std::to_string(x) + "," + std::to_string(y) + " of " + std::to_string(view.width) + "x" +
                                             std::to_string(view.height) + ": drawn " + words(found) + ", but the ray meets " +
                                             nameOf(world, map, tracer, sight) + " at depth " + std::to_string(sight.depth) + ", " +
                                             words(tracer.colour(sight)));
            }
        }
    }
    for (const auto& [key, count] : counts) verdict.coverage[names[key]] += count;
    const auto allowed = std::max(kExcusedAtLeast, static_cast<std::int64_t>(kExcusedShareOfPicture * static_cast<double>(verdict.pixels)));
    verdict.crowded = verdict.excused > allowed ? 1 : 0;
    return verdict;
}

}  // namespace slicecast::judge
