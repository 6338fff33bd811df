#include "render/light_samples.h"

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr std::int32_t kHalfUnit = 32768;
constexpr std::int32_t kLift = 16;  // of samples off their face, 1/65536 units
constexpr int kTurns[2][2] = {{0, 3}, {1, 2}};

// Which way a sample looks: as its face does, or for objects as a roof.
struct Outlook {
    LitArea area;
    bool even = false;  // of an object: light counts the same from all sides
};

double squareOf(const LightVector& v) {
    const auto part = [&](std::size_t i) { return static_cast<double>(v[i]); };
    return part(0) * part(0) + part(1) * part(1) + part(2) * part(2);
}

// The cosine between the outward direction and a way.
double cosine(const Outlook& outlook, const LightVector& way) {
    if (outlook.even) return 1.0;
    const std::array<std::int64_t, 3> out = outlook.area.outward();
    const auto product = static_cast<double>(out[0] * way[0] + out[1] * way[1] + out[2] * way[2]);
    const auto square = static_cast<double>(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    return product / (std::sqrt(square) * std::sqrt(squareOf(way)));
}

// #region sun
void addSun(LightScene& scene, const LightVector& at, const Outlook& outlook, LightColour& light) {
    const Colour sun = scene.light().sun;
    if ((sun.r | sun.g | sun.b) == 0) return;
    const auto n =
        static_cast<std::int32_t>(256.0 * std::max(0.0, cosine(outlook, scene.sun())) + 0.5);
    if (n == 0) return;
    const LightTint t = scene.through(at, scene.sun(), true);
    const std::array channels = {sun.r, sun.g, sun.b};
    for (std::size_t i = 0; i < 3; ++i) light[i] += (channels[i] * n * t[i] + 32640) / 65280;
}
// #endregion

void addSky(LightScene& scene, const LightVector& at, const Outlook& outlook, int turns,
            LightColour& light) {
    const Colour ambient = scene.light().ambient;
    if ((ambient.r | ambient.g | ambient.b) == 0) return;
    LightColour sky = {1020, 1020, 1020};
    for (const auto& way : kSkyWays) {
        std::int32_t a = way[0];
        std::int32_t b = way[1];
        for (int i = 0; i < turns; ++i) {
            const std::int32_t before = a;
            a = -b;
            b = before;
        }
        const LitArea& area = outlook.area;
        LightVector step{};
        step[static_cast<std::size_t>(area.a)] = a;
        step[static_cast<std::size_t>(area.b)] = b;
        step[static_cast<std::size_t>(area.normal)] = area.sign * way[2] + area.liftOf(a, b);
        const LightTint t = scene.through(at, step);
        for (std::size_t i = 0; i < 3; ++i) sky[i] += t[i];
    }
    const std::array channels = {ambient.r, ambient.g, ambient.b};
    for (std::size_t i = 0; i < 3; ++i) light[i] += (channels[i] * sky[i] + 1530) / 3060;
}

void addLamps(LightScene& scene, const LightVector& at, const Outlook& outlook,
              LightColour& light) {
    for (const HungLamp& lamp : scene.lampsNear(at)) {
        const LightVector way = {lamp.at[0] - at[0], lamp.at[1] - at[1], lamp.at[2] - at[2]};
        const double square = squareOf(way);
        if (square >= lamp.square) continue;
        if (lamp.ofFace && lamp.face.inFront(at) <= 0) continue;
        const double c = square > 0.0 || outlook.even ? cosine(outlook, way) : 0.0;
        if (!(c > 0.0)) continue;
        const LightTint t = scene.through(at, way);
        const double w = 1.0 - square / lamp.square;
        const Colour colour = lamp.kind.colour;
        const std::array channels = {colour.r, colour.g, colour.b};
        for (std::size_t i = 0; i < 3; ++i) {
            const double s = lamp.kind.strength * channels[i] * w * w * (1.0 + 3.0 * c) / 4.0 + 0.5;
            light[i] += (static_cast<std::int32_t>(s) * t[i] + 127) / 255;
        }
    }
}

LightColour lightAt(LightScene& scene, const LightVector& at, const Outlook& outlook, int turns) {
    LightColour light{};
    addSun(scene, at, outlook, light);
    addSky(scene, at, outlook, turns, light);
    addLamps(scene, at, outlook, light);
    return light;
}

// The mean of some samples' light.
struct Mean {
    LightColour sum{};
    int count = 0;

    void add(const LightColour& light) {
        for (std::size_t i = 0; i < 3; ++i) sum[i] += light[i];
        ++count;
    }
    std::int32_t of(std::size_t channel) const {
        return std::min(255, (sum[channel] + count / 2) / count);
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
    const auto n = static_cast<std::int32_t>(256.0 * std::max(0.0, cosine({}, scene.sun())) + 0.5);
    const std::array suns = {baked.sun.r, baked.sun.g, baked.sun.b};
    const std::array ambients = {baked.ambient.r, baked.ambient.g, baked.ambient.b};
    LightColour light{};
    for (std::size_t i = 0; i < 3; ++i)
        light[i] = std::min(255, (suns[i] * n * 255 + 32640) / 65280 + ambients[i]);
    FaceNodes nodes;
    nodes.nodes.fill(opaque(light));
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
    Mean mean;
    for (std::size_t i = 0; i < 4; ++i) {
        if (all || !scene.isInOpaque(places[i]))
            mean.add(lightAt(scene, places[i], {{}, true}, static_cast<int>(i)));
    }
    return {inSteps(mean.of(0)), inSteps(mean.of(1)), inSteps(mean.of(2))};
}

LightSamples::Entry& LightSamples::entryOf(LightScene& scene, const LitFaceAt& face) {
    if (entries_.empty()) entries_.resize(kEntries);
    const std::uint64_t key = face.key();
    Entry& entry =
        entries_[static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> 40) & (kEntries - 1)];
    if (entry.key == key && entry.generation == generation_) return entry;
    entry.key = key;
    entry.generation = generation_;
    entry.touched = 0;
    entry.exists = scene.findArea(face, entry.area);
    for (Quarter& quarter : entry.quarters) quarter.known = false;
    return entry;
}

// The quarter in a column and row from 0 to 3.
const LightSamples::Quarter& LightSamples::quarterOf(LightScene& scene, Entry& entry, int column,
                                                     int row) {
    Quarter& quarter = entry.quarters[static_cast<std::size_t>(row * 4 + column)];
    if (quarter.known) return quarter;
    quarter.known = true;
    quarter.counts = false;
    const LitArea& area = entry.area;
    const std::array place = {column, row};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int32_t begin = area.tile[i] + place[i] / 2 * kHalfUnit;
        const std::int32_t low = std::max(area.low[i], begin);
        const std::int32_t high = std::min(area.high[i], begin + kHalfUnit);
        if (low >= high) return quarter;
        quarter.at[static_cast<std::size_t>(i == 0 ? area.a : area.b)] =
            low + (high - low) * (place[i] % 2 == 0 ? 1 : 3) / 4;
    }
    quarter.at[static_cast<std::size_t>(area.normal)] =
        area.planeAt(quarter.at[static_cast<std::size_t>(area.a)],
                     quarter.at[static_cast<std::size_t>(area.b)]) +
        area.sign * kLift;
    const std::uint64_t before = scene.touched();
    scene.clearTouched();
    quarter.counts = !scene.isInOpaque(quarter.at);
    if (quarter.counts) {
        quarter.light = lightAt(scene, quarter.at, {area}, kTurns[column % 2][row % 2]);
    }
    entry.touched |= scene.touched();
    scene.addTouched(before);
    return quarter;
}

FaceNodes LightSamples::nodesOf(LightScene& scene, const LitFaceAt& face, const LitArea& area) {
    constexpr Quarter kNothing = {};
    // The quarter in a column and row that may be those of a face beside.
    std::uint64_t touched = 0;
    const auto quarter = [&](int column, int row) -> Quarter {
        const int stepA = column < 0 ? -1 : column > 3 ? 1 : 0;
        const int stepB = row < 0 ? -1 : row > 3 ? 1 : 0;
        LitFaceAt at = LightScene::beside(face, area, stepA, stepB);
        if (!scene.map().contains(at.x, at.y)) return kNothing;
        touched |= scene.changeableBit(at.x, at.y);
        const bool climbs = area.normal == 2 && area.rise[0] * stepA + area.rise[1] * stepB != 0;
        for (const int climb : {0, 1, -2}) {
            if (climb != 0 && !climbs) break;
            at.level += climb;
            if (at.level < 0) continue;
            Entry& entry = entryOf(scene, at);
            if (!entry.exists || !entry.area.isInPlaneOf(area)) continue;
            const Quarter& found = quarterOf(scene, entry, column - 4 * stepA, row - 4 * stepB);
            touched |= entry.touched;
            return found;
        }
        return kNothing;
    };
    FaceNodes nodes;
    scene.clearTouched();
    for (int nodeA = 0; nodeA < 3; ++nodeA) {
        for (int nodeB = 0; nodeB < 3; ++nodeB) {
            const int column = 2 * nodeA - 1;
            const int row = 2 * nodeB - 1;
            // Round the node: low low, high low, high high, low high
            const std::array<Quarter, 4> round = {quarter(column, row), quarter(column + 1, row),
                                                  quarter(column + 1, row + 1),
                                                  quarter(column, row + 1)};
            // #region links
            std::array<int, 4> group = {0, 1, 2, 3};  // quarters of one number are linked
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t next = (i + 1) % 4;
                if (!round[i].counts || !round[next].counts || group[i] == group[next]) continue;
                const LightVector& from = round[i < 2 ? i : next].at;
                const LightVector& to = round[i < 2 ? next : i].at;
                const LightTint t =
                    scene.through(from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]});
                if ((t[0] | t[1] | t[2]) == 0) continue;
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
                for (std::size_t k = 0; k < 4 && round[own].counts; ++k) {
                    if (round[k].counts && group[k] == group[own]) mean.add(round[k].light);
                }
                const auto addAll = [&](int firstColumn, int lastColumn, int firstRow,
                                        int lastRow) {
                    for (int r = firstRow; r <= lastRow; ++r) {
                        for (int c = firstColumn; c <= lastColumn; ++c) {
                            const Quarter one = quarter(c, r);
                            if (one.counts) mean.add(one.light);
                        }
                    }
                };
                if (mean.count == 0)
                    addAll(2 * squareA, 2 * squareA + 1, 2 * squareB, 2 * squareB + 1);
                if (mean.count == 0) addAll(0, 3, 0, 3);
                nodes.nodes[FaceNodes::index(squareA, squareB, 1 - highA, 1 - highB)] =
                    mean.count > 0 ? opaque({mean.of(0), mean.of(1), mean.of(2)})
                                   : everywhere(scene);
            }
        }
    }
    scene.addTouched(touched);
    return nodes;
}

}  // namespace slicecast
