#include "render/light/light_samples.h"

#include <algorithm>
#include <bit>
#include <span>

namespace slicecast {
namespace {

constexpr LightTint kAll = {255, 255, 255};

// Which way a sample looks: as its face does, or for objects as a roof.
struct Outlook {
    LitArea area;
    bool even = false;  // of an object: light counts the same from all sides
};

double squareOf(const LightVector& v) {
    const auto part = [&](std::size_t i) { return static_cast<double>(v[i]); };
    return part(0) * part(0) + part(1) * part(1) + part(2) * part(2);
}

// #region sun
void addSun(LightScene& scene, const LightVector& at, std::size_t quarter,
            const LightFans::Face& ways, LightColour& light) {
    if (!scene.hasSun() || ways.sunShare == 0 || ways.sun.dark.has(quarter)) return;
    const LightTint t = ways.sun.dim.has(quarter) ? scene.through(at, scene.sun(), true) : kAll;
    const Colour sun = scene.light().sun;
    const std::array channels = {sun.r, sun.g, sun.b};
    for (std::size_t i = 0; i < 3; ++i)
        light[i] += (channels[i] * ways.sunShare * t[i] + 32640) / 65280;
}
// #endregion

void addSky(LightScene& scene, const LightVector& at, const Outlook& outlook, std::size_t quarter,
            const LightFans::Face& ways, LightColour& light) {
    if (!scene.hasSky()) return;
    const std::uint32_t dark = ways.sky.dark.skyOf(quarter);
    const std::uint32_t dim = ways.sky.dim.skyOf(quarter) & ~dark;
    LightColour sky;
    sky.fill(1020 + 255 * (8 - std::popcount(dark | dim)));
    for (std::size_t way = 0; way < 8; ++way) {
        if ((dim >> way & 1) == 0) continue;
        const LightTint t = scene.through(at, skyWay(outlook.area, way, turnsOf(quarter)));
        for (std::size_t i = 0; i < 3; ++i) sky[i] += t[i];
    }
    const Colour ambient = scene.light().ambient;
    const std::array channels = {ambient.r, ambient.g, ambient.b};
    for (std::size_t i = 0; i < 3; ++i) light[i] += (channels[i] * sky[i] + 1530) / 3060;
}

void addLamps(LightScene& scene, const LightVector& at, const Outlook& outlook,
              LightColour& light) {
    const std::span<const std::uint16_t> lamps = scene.lampsNear(at);
    scene.addWork(static_cast<LightWork>(lamps.size()));
    for (const std::uint16_t number : lamps) {
        const HungLamp& lamp = scene.lamp(number);
        const LightVector way = {lamp.at[0] - at[0], lamp.at[1] - at[1], lamp.at[2] - at[2]};
        const double square = squareOf(way);
        if (square >= lamp.square) continue;
        if (lamp.ofFace && lamp.face.inFront(at) <= 0) continue;
        const double c = outlook.even ? 1.0 : square > 0.0 ? outlook.area.cosine(way) : 0.0;
        if (!(c > 0.0)) continue;
        const double w = 1.0 - square / lamp.square;
        const Colour colour = lamp.kind.colour;
        const std::array channels = {colour.r, colour.g, colour.b};
        LightColour all{};
        for (std::size_t i = 0; i < 3; ++i)
            all[i] = static_cast<std::int32_t>(
                lamp.kind.strength * channels[i] * w * w * (1.0 + 3.0 * c) / 4.0 + 0.5);
        if ((all[0] | all[1] | all[2]) == 0) continue;
        const LightTint t = scene.through(at, way);
        for (std::size_t i = 0; i < 3; ++i) light[i] += (all[i] * t[i] + 127) / 255;
    }
}

LightColour lightAt(LightScene& scene, const LightVector& at, const Outlook& outlook,
                    std::size_t quarter, const LightFans::Face& ways) {
    LightColour light{};
    addSun(scene, at, quarter, ways, light);
    addSky(scene, at, outlook, quarter, ways, light);
    addLamps(scene, at, outlook, light);
    return light;
}

// Light above 255 keeps its colour: its largest channel becomes 255, and the others in proportion.
LightColour held(const LightColour& light) {
    const std::int64_t most = *std::max_element(light.begin(), light.end());
    if (most <= 255) return light;
    const auto part = [&](std::int32_t channel) {
        return static_cast<std::int32_t>((channel * std::int64_t{255} + most / 2) / most);
    };
    return {part(light[0]), part(light[1]), part(light[2])};
}

// The mean of some samples' light.
struct Mean {
    LightColour sum{};
    int count = 0;

    void add(const LightColour& light) {
        for (std::size_t i = 0; i < 3; ++i) sum[i] += light[i];
        ++count;
    }
    LightColour light() const {
        const auto mean = [&](std::int32_t channel) { return (channel + count / 2) / count; };
        return held({mean(sum[0]), mean(sum[1]), mean(sum[2])});
    }
};

Pixel opaque(const LightColour& light) {
    return toPixel({static_cast<std::uint8_t>(light[0]), static_cast<std::uint8_t>(light[1]),
                    static_cast<std::uint8_t>(light[2]), 255});
}

std::int32_t inSteps(std::int32_t light) {  // 0 to 255 becomes 0 to 256
    return light + (light >> 7);
}

// The part of the ambient light that reaches what no sample shows.
Pixel everywhere(const LightScene& scene) {
    const Colour ambient = scene.light().ambient;
    const auto third = [](int channel) { return (channel * 1020 + 1530) / 3060; };
    return opaque({third(ambient.r), third(ambient.g), third(ambient.b)});
}

}  // namespace

FaceNodes LightSamples::ofOutside(const LightScene& scene) {
    const BakedLight& baked = scene.light();
    const std::int32_t n = sunShareOf({}, scene.sun());
    const std::array suns = {baked.sun.r, baked.sun.g, baked.sun.b};
    const std::array ambients = {baked.ambient.r, baked.ambient.g, baked.ambient.b};
    LightColour light{};
    for (std::size_t i = 0; i < 3; ++i)
        light[i] = (suns[i] * n * 255 + 32640) / 65280 + ambients[i];
    FaceNodes nodes;
    nodes.nodes.fill(opaque(held(light)));
    return nodes;
}

FaceNodes LightSamples::ofAmbient(const LightScene& scene) {
    FaceNodes nodes;
    nodes.nodes.fill(everywhere(scene));
    return nodes;
}

LightColour LightSamples::ofObject(LightScene& scene, const Object& object) {
    const std::int32_t quarter = object.width.raw / 4;
    std::array<LightVector, 4> places;
    for (std::size_t i = 0; i < 4; ++i) {
        places[i] = {object.x.raw + (i == 1 || i == 2 ? quarter : -quarter),
                     object.y.raw + (i >= 2 ? quarter : -quarter),
                     object.z.raw + object.height.raw / 2};
    }
    const bool all = std::all_of(places.begin(), places.end(),
                                 [&](const LightVector& at) { return scene.isInOpaque(at); });
    // No cell tells of its ways: each is followed
    constexpr std::array<std::size_t, 4> kTurned = {0, 1, 5, 4};  // quarters turned by 0 to 3
    Mean mean;
    for (std::size_t i = 0; i < 4; ++i) {
        if (all || !scene.isInOpaque(places[i]))
            mean.add(lightAt(scene, places[i], {{}, true}, kTurned[i], {kNotSeen, kNotSeen, 256}));
    }
    const LightColour light = mean.light();
    return {inSteps(light[0]), inSteps(light[1]), inSteps(light[2])};
}

LightSamples::Entry& LightSamples::entryOf(LightScene& scene, const LitFaceAt& face) {
    const std::uint64_t key = face.key();
    Entry& entry = entries_[scattered(key) & (entries_.size() - 1)];
    if (entry.key == key && entry.generation == generation_) return entry;
    entry.key = key;
    entry.generation = generation_;
    entry.touched = 0;
    entry.isSeen = false;
    entry.exists = scene.findArea(face, entry.area);
    for (Quarter& quarter : entry.quarters) quarter.known = false;
    return entry;
}

const LightSamples::Quarter& LightSamples::quarterOf(LightScene& scene, const LitFaceAt& face,
                                                     Entry& entry, std::size_t number) {
    Quarter& quarter = entry.quarters[number];
    if (quarter.known) return quarter;
    quarter.known = true;
    quarter.counts = false;
    if (!findSample(entry.area, number, quarter.at)) return quarter;
    const std::uint64_t before = scene.touched();
    scene.clearTouched();
    quarter.counts = !scene.isInOpaque(quarter.at);
    if (quarter.counts) {
        if (!entry.isSeen) entry.ways = fans_.look(scene, face, entry.area);
        entry.isSeen = true;
        quarter.isInOpen = scene.isOpen(quarter.at, face);
        quarter.light = lightAt(scene, quarter.at, {entry.area}, number, entry.ways);
    }
    entry.touched |= scene.touched();
    scene.addTouched(before);
    return quarter;
}

bool LightSamples::areLinked(LightScene& scene, const LitArea& area, const Quarter& a,
                             const Quarter& b) {
    // Most are in one open cell, or in two side by side
    if (a.isInOpen && b.isInOpen && (area.isLevel() || LightScene::areInOneCell(a.at, b.at)) &&
        !scene.isCeilingBetween(a.at[2], b.at[2]))
        return true;
    const LightTint t =
        scene.through(a.at, {b.at[0] - a.at[0], b.at[1] - a.at[1], b.at[2] - a.at[2]});
    return (t[0] | t[1] | t[2]) != 0;
}

FaceNodes LightSamples::nodesOf(LightScene& scene, const LitFaceAt& face, const LitArea& area) {
    constexpr LightWork kWorkOfFace = 64;  // beside that of its samples
    scene.addWork(kWorkOfFace);
    // The face's quarters, and those round them, which are of the faces beside
    std::array<std::array<Quarter, 6>, 6> quarters{};
    std::uint64_t touched = 0;
    for (int stepA = -1; stepA <= 1; ++stepA) {
        for (int stepB = -1; stepB <= 1; ++stepB) {
            LitFaceAt at = LightScene::beside(face, area, stepA, stepB);
            if (!scene.map().contains(at.x, at.y)) continue;
            const bool climbs =
                area.normal == 2 && area.rise[0] * stepA + area.rise[1] * stepB != 0;
            for (const int climb : {0, 1, -2}) {
                if (climb != 0 && !climbs) break;
                at.level += climb;
                if (at.level < 0) continue;
                touched |= scene.changeableBit(at.x, at.y, at.level);
                Entry& entry = entryOf(scene, at);
                if (!entry.exists || !entry.area.isInPlaneOf(area)) continue;
                const auto first = [](int step) { return step < 0 ? 3 : 0; };
                const auto last = [](int step) { return step > 0 ? 0 : 3; };
                for (int row = first(stepB); row <= last(stepB); ++row) {
                    for (int column = first(stepA); column <= last(stepA); ++column)
                        quarters[static_cast<std::size_t>(row + 4 * stepB + 1)]
                                [static_cast<std::size_t>(column + 4 * stepA + 1)] = quarterOf(
                                    scene, at, entry, static_cast<std::size_t>(4 * row + column));
                }
                touched |= entry.touched;
                break;
            }
        }
    }
    const auto quarter = [&](int column, int row) -> const Quarter& {
        return quarters[static_cast<std::size_t>(row + 1)][static_cast<std::size_t>(column + 1)];
    };
    FaceNodes nodes;
    scene.clearTouched();
    for (int nodeA = 0; nodeA < 3; ++nodeA) {
        for (int nodeB = 0; nodeB < 3; ++nodeB) {
            const int column = 2 * nodeA - 1;
            const int row = 2 * nodeB - 1;
            // Round the node: low low, high low, high high, low high
            const std::array<const Quarter*, 4> round = {
                &quarter(column, row), &quarter(column + 1, row), &quarter(column + 1, row + 1),
                &quarter(column, row + 1)};
            // #region links
            std::array<int, 4> group = {0, 1, 2, 3};  // quarters of one number are linked
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t next = (i + 1) % 4;
                if (!round[i]->counts || !round[next]->counts || group[i] == group[next]) continue;
                if (!areLinked(scene, area, *round[i < 2 ? i : next], *round[i < 2 ? next : i]))
                    continue;
                const int old = group[next];
                for (int& number : group) number = number == old ? group[i] : number;
            }
            // #endregion
            // The face's own quarters of them, and which node this is of their squares
            for (int i = 0; i < 4; ++i) {
                const int highA = i == 1 || i == 2 ? 1 : 0;
                const int highB = i >= 2 ? 1 : 0;
                const int squareA = nodeA - 1 + highA;
                const int squareB = nodeB - 1 + highB;
                if (squareA < 0 || squareA > 1 || squareB < 0 || squareB > 1) continue;
                Mean mean;
                const auto own = static_cast<std::size_t>(i);
                for (std::size_t k = 0; k < 4 && round[own]->counts; ++k) {
                    if (round[k]->counts && group[k] == group[own]) mean.add(round[k]->light);
                }
                const auto addAll = [&](int firstColumn, int lastColumn, int firstRow,
                                        int lastRow) {
                    for (int r = firstRow; r <= lastRow; ++r) {
                        for (int c = firstColumn; c <= lastColumn; ++c) {
                            const Quarter& one = quarter(c, r);
                            if (one.counts) mean.add(one.light);
                        }
                    }
                };
                if (mean.count == 0)
                    addAll(2 * squareA, 2 * squareA + 1, 2 * squareB, 2 * squareB + 1);
                if (mean.count == 0) addAll(0, 3, 0, 3);
                nodes.nodes[FaceNodes::index(squareA, squareB, 1 - highA, 1 - highB)] =
                    mean.count > 0 ? opaque(mean.light()) : everywhere(scene);
            }
        }
    }
    scene.addTouched(touched);
    return nodes;
}

}  // namespace slicecast
