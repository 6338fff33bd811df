#include "verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace slicecast::judge {
namespace {

constexpr std::size_t kComplaints = 5;
constexpr double kRadii[] = {1.0 / 64, 1.0 / 512, 1.0 / 4096, 1.0 / 32768};
constexpr int kDirections[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                   {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
constexpr double kDiagonal = 0.70710678;
constexpr double kDepthFactors[] = {1.0, 1.0 - 1e-6, 1.0 + 1e-6};

bool alike(Colour a, Colour b) {
    return std::abs(a.r - b.r) <= 1 && std::abs(a.g - b.g) <= 1 && std::abs(a.b - b.b) <= 1 &&
           a.a == b.a;
}

// out = (front * a + behind * (255 - a) + 127) / 255
Colour blended(Colour front, Colour behind) {
    const auto channel = [&](int f, int b) {
        return static_cast<std::uint8_t>((f * front.a + b * (255 - front.a) + 127) / 255);
    };
    return {channel(front.r, behind.r), channel(front.g, behind.g), channel(front.b, behind.b),
            255};
}

// out = (mirror * (255 - r) + reflected * r + 127) / 255
Colour mirrored(Colour mirror, int strength, Colour reflected) {
    const auto channel = [&](int m, int b) {
        return static_cast<std::uint8_t>((m * (255 - strength) + b * strength + 127) / 255);
    };
    return {channel(mirror.r, reflected.r), channel(mirror.g, reflected.g),
            channel(mirror.b, reflected.b), 255};
}

// The colours that a layer of a pixel may have.
struct Layer {
    std::vector<Colour> colours;
    int mirror = 0;
};
using Choices = std::vector<Layer>;  // front to back

void addChoice(std::vector<Colour>& choices, Colour colour) {
    if (std::find(choices.begin(), choices.end(), colour) == choices.end())
        choices.push_back(colour);
}

void addChoices(const Tracer& tracer, const std::vector<Sight>& sights, Choices& choices) {
    choices.resize(sights.size());
    for (std::size_t i = 0; i < sights.size(); ++i) {
        choices[i].mirror = sights[i].mirror;
        for (const double factor : kDepthFactors)
            addChoice(choices[i].colours, tracer.colour(sights[i], factor));
    }
}

// Whether some choice for each layer gives the colour.
bool canShow(const Choices& choices, Colour found) {
    constexpr std::size_t kMost = 4096;
    std::vector<Colour> behind = choices.back().colours;
    for (std::size_t i = choices.size() - 1; i-- > 0;) {
        std::vector<Colour> sums;
        for (const Colour front : choices[i].colours) {
            for (const Colour back : behind) {
                if (sums.size() < kMost)
                    addChoice(sums, choices[i].mirror > 0 ? mirrored(front, choices[i].mirror, back)
                                                          : blended(front, back));
            }
        }
        behind = std::move(sums);
    }
    return std::any_of(behind.begin(), behind.end(), [&](Colour colour) {
        return alike({colour.r, colour.g, colour.b, 255}, found);
    });
}

bool shows(const Tracer& tracer, const std::vector<Sight>& sights, Colour found) {
    Choices choices;
    addChoices(tracer, sights, choices);
    return canShow(choices, found);
}

bool sameKinds(const std::vector<Sight>& a, const std::vector<Sight>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Sight& x, const Sight& y) {
        return x.kind == y.kind && x.face == y.face && x.fromInside == y.fromInside &&
               x.mirror == y.mirror && x.portals == y.portals;
    });
}

// A fraction of a texture that lies just before a texel's border, moved onto it.
double onBorder(double fraction) {
    constexpr double kBefore = 1.0 / 4294967296.0;
    const double moved = std::fabs(fraction) + kBefore;
    return moved < 1.0 ? std::copysign(moved, fraction) : fraction;
}

// A point just before the border of a texel may count as on it.
void addChoicesOnBorders(const Tracer& tracer, std::vector<Sight> sights, Choices& choices) {
    for (Sight& sight : sights) sight.u = onBorder(sight.u);
    addChoices(tracer, sights, choices);
    for (Sight& sight : sights) sight.v = onBorder(sight.v);
    addChoices(tracer, sights, choices);
}

// Where layers blend, each may take its texel from another of the points, if that point's ray meets
// the same kinds of layer in the same order.
bool excusable(const Tracer& tracer, double x, double y, const std::vector<Sight>& sights,
               Colour found) {
    Choices all;
    addChoices(tracer, sights, all);
    addChoicesOnBorders(tracer, sights, all);
    if (canShow(all, found)) return true;
    std::vector<Sight> around;
    for (const double radius : kRadii) {
        for (const auto& direction : kDirections) {
            const double length =
                direction[0] != 0 && direction[1] != 0 ? radius * kDiagonal : radius;
            tracer.look(x + direction[0] * length, y + direction[1] * length, around);
            if (shows(tracer, around, found)) return true;
            if (sights.size() > 1 && sameKinds(sights, around)) addChoices(tracer, around, all);
        }
    }
    return sights.size() > 1 && canShow(all, found);
}

// What a ray meets, as far as it tells the things of one column from each other.
using Thing = std::tuple<int, bool, int, Sight::Kind, Face, bool, LitFace, int>;

Thing thingOf(const Sight& sight) {
    return {sight.map,  sight.reflected,  sight.portals, sight.kind,
            sight.face, sight.fromInside, sight.litFace, sight.object};
}

// What counts as a run, and may be left out; floors never are.
bool isLayer(const Sight& sight) {
    return sight.seeThrough && sight.kind != Sight::Kind::floor;
}

// Whether the rays of a column may meet so many see-through runs of rows, in mirrors or before
// them, that further ones are left out: three quarters of the most that there are, because two that
// touch look like one. Counts as many as there can be: what is behind opaque
// texels may count or not, so a run ends wherever another thing hides it; and what objects, or
// edges within the tile, may divide counts for each of them.
class Crowds {
public:
    Crowds(const Tracer& tracer, int height) : tracer_(tracer), height_(height) {}

    bool isFull(double x, bool reflected) {
        const auto [found, isNew] = known_.try_emplace({x, reflected}, false);
        if (isNew) found->second = runs(x, reflected) >= (reflected ? 48 : 96);
        return found->second;
    }

private:
    int runs(double x, bool reflected) const {
        std::map<Thing, int> runsOf;
        std::set<int> objects;
        std::map<std::array<int, 3>, std::set<LitFace>> sides;  // by map and tile
        using Run = std::tuple<Thing, Thing, LitFace>;  // what, hidden by what, in which mirror
        std::set<Run> before;
        std::vector<Sight> sights;
        const Thing none = {};
        for (int y = 0; y < height_; ++y) {
            tracer_.look(x, y + 0.5, sights);
            std::set<Run> here;
            Thing hidden = none;
            LitFace mirror;
            for (const Sight& sight : sights) {
                const Thing thing = thingOf(sight);
                if (sight.kind == Sight::Kind::object) objects.insert(sight.object);
                if (sight.kind == Sight::Kind::side)
                    sides[{sight.map, sight.litFace.x, sight.litFace.y}].insert(sight.litFace);
                if (sight.mirror > 0) mirror = sight.litFace;
                if (!isLayer(sight) || sight.reflected != reflected) continue;
                here.insert({thing, hidden, mirror});
                if (hidden == none && tracer_.colour(sight).a == 255) hidden = thing;
            }
            for (const Run& run : here) runsOf[std::get<0>(run)] += before.count(run) == 0 ? 1 : 0;
            before = std::move(here);
        }
        int sum = 0;
        for (const auto& [thing, count] : runsOf) {
            const auto kind = std::get<Sight::Kind>(thing);
            const LitFace& face = std::get<LitFace>(thing);
            const bool isPlane = kind != Sight::Kind::side && kind != Sight::Kind::object;
            const auto cuts = sides.find({std::get<0>(thing), face.x, face.y});
            const std::size_t more =
                !isPlane ? 0 : objects.size() + (cuts == sides.end() ? 0 : cuts->second.size());
            sum += count * (1 + static_cast<int>(more));
        }
        return sum;
    }

    const Tracer& tracer_;
    int height_;
    std::map<std::pair<double, bool>, bool> known_;
};

// Whether the colour is shown without the farthest see-through things, before a mirror and in it,
// where the column is full of them.
bool isWithoutTheFarthest(const Tracer& tracer, Crowds& crowds, double x,
                          const std::vector<Sight>& sights, Colour found) {
    Choices all;
    addChoices(tracer, sights, all);
    const auto numberOf = [&](bool reflected) {
        const auto number = std::count_if(sights.begin(), sights.end(), [&](const Sight& sight) {
            return isLayer(sight) && sight.reflected == reflected;
        });
        return number > 0 && crowds.isFull(x, reflected) ? number : 0;
    };
    const std::ptrdiff_t most = numberOf(false);
    const std::ptrdiff_t mostReflected = numberOf(true);
    for (std::ptrdiff_t out = 0; out <= most; ++out) {
        for (std::ptrdiff_t outReflected = 0; outReflected <= mostReflected; ++outReflected) {
            std::ptrdiff_t rest = out;
            std::ptrdiff_t restReflected = outReflected;
            Choices left;
            for (std::size_t i = sights.size(); i-- > 0;) {
                std::ptrdiff_t& toGo = sights[i].reflected ? restReflected : rest;
                if (isLayer(sights[i]) && toGo > 0) {
                    --toGo;
                } else {
                    left.push_back(all[i]);
                }
            }
            std::reverse(left.begin(), left.end());
            if (canShow(left, found)) return true;
        }
    }
    return false;
}

constexpr const char* kKinds[] = {"side",    "roof", "underside", "floor",
                                  "ceiling", "sky",  "haze",      "object"};

std::string nameOf(const World& world, const Tracer& tracer, const Sight& sight) {
    const Map& map = world.maps[static_cast<std::size_t>(sight.map)];
    static const char* const kSkies[] = {"colour", "gradient", "panorama"};
    std::string name = kKinds[static_cast<int>(sight.kind)];
    if (sight.kind == Sight::Kind::side) name = kFaceNames[static_cast<std::size_t>(sight.face)];
    if (sight.kind == Sight::Kind::sky) return name + " " + kSkies[static_cast<int>(map.sky.kind)];
    if (sight.kind == Sight::Kind::haze) return name;
    if (sight.fromInside) name += " from inside";
    if (sight.outsideGrid) name += " outside";
    if (sight.kind == Sight::Kind::object)
        return name + (tracer.level(sight) > 0 ? " smaller" : "");
    if (sight.mirror > 0) return name + " mirror";
    if (sight.seeThrough) return name + " see-through";
    if (tracer.level(sight) > 0)
        name +=
            tracer.level(sight) + 1 == static_cast<int>(world.textures[sight.texture].levels.size())
                ? " last level"
                : " smaller";
    return name;
}

std::string words(Colour c) {
    return "(" + std::to_string(c.r) + " " + std::to_string(c.g) + " " + std::to_string(c.b) + " " +
           std::to_string(c.a) + ")";
}

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

Verdict judge(const World& world, const View& view, const Pixel* pixels, int pitch,
              const std::string& name) {
    const Tracer tracer(world, view);
    Crowds crowds(tracer, view.height);
    Verdict verdict;
    std::vector<Sight> sights;
    Notes notes;
    std::array<std::int64_t, static_cast<std::size_t>(Note::count)> noted{};
    std::array<std::int64_t, std::size(kKinds)> mirroredKinds{};
    std::array<std::int64_t, std::size(kKinds)> kindsBehindPortals{};
    std::map<std::uint64_t, std::int64_t>
        counts;  // by kind, face and the like: names are made once at the end
    std::map<std::uint64_t, std::string> names;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const Colour found = toColour(pixels[static_cast<std::ptrdiff_t>(y) * pitch + x]);
            notes.reset();
            tracer.look(x + 0.5, y + 0.5, sights, &notes);
            ++verdict.pixels;
            for (std::size_t i = 0; i < noted.size(); ++i) noted[i] += notes[i] ? 1 : 0;
            for (const Sight& sight : sights) {
                const auto key = static_cast<std::uint64_t>(
                    static_cast<int>(sight.kind) | static_cast<int>(sight.face) << 4 |
                    sight.fromInside << 8 | sight.outsideGrid << 9 | sight.seeThrough << 10 |
                    (sight.mirror > 0) << 11 | tracer.level(sight) << 12 |
                    (sight.texture & 0xff) << 16 | sight.map << 24);
                if (sight.glow) ++verdict.coverage["glow"];
                if (sight.side > 0)
                    ++verdict.coverage["object's side " + std::to_string(sight.side)];
                if (tracer.isLit(sight))
                    ++verdict.coverage[std::string("lit ") + kKinds[static_cast<int>(sight.kind)]];
                if (sight.kind != Sight::Kind::object && sight.texture != kNoTexture &&
                    world.textures[sight.texture].size() == 512) {
                    ++verdict.coverage["large texture"];
                    if (tracer.isLit(sight)) ++verdict.coverage["large texture, lit"];
                    if (tracer.isSmooth(sight)) ++verdict.coverage["large texture, smooth"];
                }
                if (tracer.isSmooth(sight)) {
                    const std::string kind = kKinds[static_cast<int>(sight.kind)];
                    ++verdict.coverage[(tracer.isLit(sight) ? "smooth lit " : "smooth ") + kind];
                    if (tracer.isBlendedAcrossBorder(sight))
                        ++verdict.coverage["smooth across a border " + kind];
                    if (tracer.isBlendedBesideHole(sight))
                        ++verdict.coverage["smooth beside a hole"];
                    if (sight.slideU.raw != 0 || sight.slideV.raw != 0 || sight.rise.raw != 0)
                        ++verdict.coverage["smooth on what moves"];
                    if (sight.isSloped) ++verdict.coverage["smooth slope"];
                }
                if (sight.kind != Sight::Kind::object && sight.texture != kNoTexture &&
                    world.textures[sight.texture].frames() > 1)
                    ++verdict.coverage["animated"];
                if (++counts[key] == 1) names[key] = nameOf(world, tracer, sight);
                if (sight.reflected) ++mirroredKinds[static_cast<std::size_t>(sight.kind)];
                if (sight.portals > 0) ++kindsBehindPortals[static_cast<std::size_t>(sight.kind)];
                if (sight.portals > 0 && sight.turn > 0 && sight.kind == Sight::Kind::sky)
                    ++verdict.coverage["sky turned"];
            }
            if (sights.size() > 1) {
                ++verdict.coverage[std::to_string(std::min<std::size_t>(sights.size() - 1, 8)) +
                                   " layers"];
                if (tracer.colour(sights[0]).a == 0) ++verdict.coverage["hole"];
            }
            if (shows(tracer, sights, found)) continue;
            if (excusable(tracer, x + 0.5, y + 0.5, sights, found)) {
                ++verdict.excused;
                continue;
            }
            if (isWithoutTheFarthest(tracer, crowds, x + 0.5, sights, found)) {
                ++verdict.coverage["without the farthest layers"];
                continue;
            }
            ++verdict.unexcused;
            if (verdict.complaints.size() < kComplaints) {
                std::string met;
                for (const Sight& sight : sights) {
                    met += (met.empty() ? "" : ", then ") + nameOf(world, tracer, sight) +
                           " of map " + std::to_string(sight.map) + " at depth " +
                           std::to_string(sight.depth) + ", " + words(tracer.colour(sight)) +
                           (sight.mirror > 0 ? " mirror " + std::to_string(sight.mirror) : "");
                }
                for (std::size_t i = 0; i < notes.size(); ++i) {
                    if (notes[i]) met += std::string(", ") + nameOf(static_cast<Note>(i));
                }
                verdict.complaints.push_back(
                    name + ", pixel " + std::to_string(x) + "," + std::to_string(y) + " of " +
                    std::to_string(view.width) + "x" + std::to_string(view.height) + ": drawn " +
                    words(found) + ", but the ray meets " + met);
            }
        }
    }
    const auto seen = [&](const std::string& what, std::int64_t count) {
        if (count > 0) verdict.coverage[what] += count;
    };
    for (std::size_t i = 0; i < noted.size(); ++i) seen(nameOf(static_cast<Note>(i)), noted[i]);
    for (std::size_t i = 0; i < std::size(kKinds); ++i) {
        seen(std::string("mirrored ") + kKinds[i], mirroredKinds[i]);
        seen(std::string(kKinds[i]) + " behind a portal", kindsBehindPortals[i]);
    }
    for (const auto& [key, count] : counts) verdict.coverage[names[key]] += count;
    seen("pictures with tinted light", tracer.sawLight(&LightTracer::sawTint));
    seen("pictures with nodes partly linked", tracer.sawLight(&LightTracer::sawPartlyLinked));
    seen("pictures with a square of other nodes", tracer.sawLight(&LightTracer::sawOddSquare));
    seen("pictures with a lit slope", tracer.sawLight(&LightTracer::sawSlope));
    seen("pictures with a lit cut", tracer.sawLight(&LightTracer::sawCut));
    seen("pictures with light that goes on with a slope or cut",
         tracer.sawLight(&LightTracer::sawGoOn));
    seen("pictures with light that goes on in another level",
         tracer.sawLight(&LightTracer::sawClimb));
    seen("pictures with a slope that dips below the floor",
         tracer.sawLight(&LightTracer::sawBelowFloor));
    seen("pictures with light between parts of a mover that do not join",
         tracer.sawLight(&LightTracer::sawMoverApart));
    seen("pictures with light on a face that is not shown",
         tracer.sawLight(&LightTracer::sawHiddenFace));
    const auto allowed = std::max(
        kExcusedAtLeast,
        static_cast<std::int64_t>(kExcusedShareOfPicture * static_cast<double>(verdict.pixels)));
    verdict.crowded = verdict.excused > allowed ? 1 : 0;
    return verdict;
}

}  // namespace slicecast::judge
