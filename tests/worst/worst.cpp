// Looks for legal scenes whose frames or steps cost too much: random ones, then changes of the
// worst so far. The limits are
//
//     a frame    kMostTimes the processor time of the castle's frame
//     a step     kMostStepTimes the same
//     memory     kMostMemory for drawing and stepping, beyond what the session holds after loading
//
// Prints the worst of each. If a scene is far over a limit, writes it to a file and fails.
//
//     slicecast-worst SCENES ASSETS     how many scenes; a folder with scenes/castle.json
#include "base/random.h"
#include "files/scene_file.h"
#include "session/session.h"

#include <malloc.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

using namespace slicecast;

namespace {

constexpr double kMostTimes = 50.0;
// Times vary on a busy machine: a scene fails only if it exceeds a limit by this factor, also when
// it is measured again and again, each time beside the castle.
constexpr double kSlack = 1.5;
constexpr int kMeasuredAgain = 5;
constexpr double kMostStepTimes = 5.0;
constexpr std::int64_t kMostMemory = 64 << 20;  // bytes
constexpr int kWidth = 640;
constexpr int kHeight = 400;
constexpr int kHeadings = 4;
constexpr int kSteps = 3;

std::int64_t liveBytes = 0;
std::int64_t mostBytes = 0;

}  // namespace

// Not inlined: g++ would take free() for the wrong partner of the library's operator new.
__attribute__((noinline)) void* operator new(std::size_t size) {
    void* const memory = std::malloc(size);
    if (memory == nullptr) std::abort();
    liveBytes += static_cast<std::int64_t>(malloc_usable_size(memory));
    mostBytes = std::max(mostBytes, liveBytes);
    return memory;
}
__attribute__((noinline)) void operator delete(void* memory) noexcept {
    if (memory != nullptr) liveBytes -= static_cast<std::int64_t>(malloc_usable_size(memory));
    std::free(memory);
}
__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept {
    operator delete(memory);
}

namespace {

// ---- Scenes

// What a scene is made of: each number from 0 to 255 is a share of its range, so that any bytes
// are a scene.
enum Gene : std::uint8_t {
    size,     // tiles a side, 8 to 263
    levels,   // 1 to 32
    walls,    // density of blocks
    glass,    // density of blocks that are seen through
    gates,    // density of gates
    movers,   // density of moving blocks
    portals,  // how many, 0 to 4,080
    far,      // a portal leads far away, or near
    limit,    // portals that a ray passes, 1 to 32
    well,     // all around the eye stand portals; how many levels high
    bushes,   // density of objects
    walkers,  // density of objects that move
    mirrors,  // bits: floor, roofs, ceiling; and how strong
    ceiling,  // height, none below 64
    water,    // density of water
    eye,      // height
    seed,
    count
};
using Genes = std::array<std::uint8_t, Gene::count>;

class SceneText {
public:
    explicit SceneText(const Genes& genes) : genes_(genes), random_(genes[Gene::seed] + 1u) {}

    std::string text() {
        side_ = 8 + genes_[Gene::size];
        levels_ = 1 + genes_[Gene::levels] / 8;
        fill();
        const int strength = (genes_[Gene::mirrors] >> 4) + 1;
        mirror_ = ", \"mirror\": " + number(strength / 16.0);
        const bool hasRoofs = (genes_[Gene::mirrors] & 2) != 0;
        std::string text = R"({"title": "worst",
"textures": {"stone": "../textures/rock.png", "glass": "../see-through/glass-pane.png",
  "door": {"file": "../sheets/double-door.png", "frames": 8}},
"sprites": {"bush": "../sprites/bush.png",
  "walker": {"file": "../sprites/walker.png", "frames": 8, "rate": 7}},
"motions": {"lift": {"moves": "both", "from": 0, "to": 0.5, "period": 3}},
"blueprints": {"wall": {"faces": {"all": "stone"})";
        if (hasRoofs)
            text.replace(text.rfind("\"all\""), std::string::npos,
                         "\"all\": \"stone\", \"top\": {\"texture\": \"stone\"" + mirror_ + "}}");
        text += R"(}, "pane": {"faces": "glass", "join": false},
  "gate": {"faces": "door", "gate": {"approach": 2}},
  "lift": {"top": 0.5, "faces": "stone", "motion": "lift"},
  "pond": {"top": 0.75, "water": true, "faces": {"top": "glass"}}},
"legend": {"#": "wall", "g": "pane", "G": "gate", "l": "lift", "w": "pond"},
"maps": [{"name": "map", "levels": [)";
        for (int level = 0; level < levels_; ++level) {
            text += level == 0 ? "[" : ",\n[";
            for (int y = 0; y < side_; ++y) {
                text += y == 0 ? "\"" : "\", \"";
                text += rows_[static_cast<std::size_t>(level * side_ + y)];
            }
            text += "\"]";
        }
        text += "],\n\"floor\": {\"texture\": \"stone\"";
        if ((genes_[Gene::mirrors] & 1) != 0) text += mirror_;
        text += "}";
        if (genes_[Gene::ceiling] >= 64) {
            text += ", \"ceiling\": {\"texture\": \"stone\", \"height\": " +
                    number(genes_[Gene::ceiling] / 8.0);
            if ((genes_[Gene::mirrors] & 4) != 0) text += mirror_;
            text += "}";
        }
        addSowing(text);
        addPortals(text);
        const double height = std::min<double>(genes_[Gene::eye] / 16.0, levels_);
        text += "}]";
        if (hasPortals_)
            text += ",\n\"portalLimit\": " + std::to_string(1 + genes_[Gene::limit] / 8);
        text += ",\n\"start\": {\"x\": " + number(side_ / 2 + 0.5) +
                ", \"y\": " + number(side_ / 2 + 0.5) + ", \"z\": " + number(height) +
                ", \"heading\": 20}}\n";
        return text;
    }

private:
    static std::string number(double value) {
        std::array<char, 32> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        return {digits.data(), end};
    }

    bool isChosen(Gene gene) {
        const auto share = static_cast<std::uint64_t>(genes_[gene]);
        return share > 0 && random_.next() % 256 < share;
    }
    int pick(int count) {
        return static_cast<int>(random_.next() % static_cast<std::uint64_t>(count));
    }

    // Around the eye it stays free, so that there is something to see.
    void fill() {
        rows_.assign(static_cast<std::size_t>(levels_ * side_),
                     std::string(static_cast<std::size_t>(side_), '.'));
        const int wellHeight = std::min(levels_, genes_[Gene::well] / 8);
        const int middle = side_ / 2;
        for (int level = 0; level < levels_; ++level) {
            for (int y = 0; y < side_; ++y) {
                for (int x = 0; x < side_; ++x) {
                    char& cell = at(x, y, level);
                    const int away = std::max(std::abs(x - middle), std::abs(y - middle));
                    if (level < wellHeight && away == 3) {
                        cell = '#';
                        sites_.push_back({x, y, level});
                        continue;
                    }
                    if (away <= 2) continue;
                    if (isChosen(Gene::walls)) {
                        cell = '#';
                        sites_.push_back({x, y, level});
                    } else if (isChosen(Gene::glass)) {
                        cell = 'g';
                    } else if (isChosen(Gene::gates)) {
                        cell = 'G';
                    } else if (isChosen(Gene::movers)) {
                        cell = 'l';
                    } else if (isChosen(Gene::water)) {
                        cell = 'w';
                    }
                }
            }
        }
        // Those beside the eye come first, whatever else there is.
        const auto distance = [&](const Site& site) {
            return std::abs(site.x - middle) + std::abs(site.y - middle);
        };
        std::stable_sort(sites_.begin(), sites_.end(),
                         [&](const Site& a, const Site& b) { return distance(a) < distance(b); });
    }
    char& at(int x, int y, int level) {
        return rows_[static_cast<std::size_t>(level * side_ + y)][static_cast<std::size_t>(x)];
    }

    // The limit on objects is of those that would stand there: the densities keep below it.
    void addSowing(std::string& text) {
        const double tiles = side_ * side_;
        const double bushes = std::min(genes_[Gene::bushes] / 256.0, 60'000 / tiles);
        const double walkers = std::min(genes_[Gene::walkers] / 256.0, 3'800 / tiles);
        std::string sown;
        if (bushes > 0)
            sown += R"({"sprite": "bush", "density": )" + number(bushes) +
                    R"(, "seed": 4, "height": [0.2, 0.6]})";
        if (walkers > 0)
            sown += std::string(sown.empty() ? "" : ", ") + R"({"sprite": "walker", "density": )" +
                    number(walkers) +
                    R"(, "height": 0.5, "motion": {"kind": "wander", "speed": 1}})";
        if (!sown.empty()) text += ",\n\"sow\": [" + sown + "]";
    }

    void addPortals(std::string& text) {
        const int wanted = genes_[Gene::portals] * 16;
        std::string made;
        int count = 0;
        for (const Site& site : sites_) {
            if (count >= wanted) break;
            const int middle = side_ / 2;
            // The side that looks at the eye.
            const int dx = site.x - middle;
            const int dy = site.y - middle;
            const bool isAlongX = std::abs(dx) >= std::abs(dy);
            const char* const face =
                isAlongX ? (dx > 0 ? "west" : "east") : (dy > 0 ? "north" : "south");
            const int reach = 4 + genes_[Gene::far] * (side_ - 8) / 512;
            const int x = std::clamp(middle + pick(2 * reach + 1) - reach, 0, side_ - 1);
            const int y = std::clamp(middle + pick(2 * reach + 1) - reach, 0, side_ - 1);
            if (at(x, y, site.level) != '.') continue;
            made += std::string(count == 0 ? "" : ",\n") + "{\"x\": " + std::to_string(site.x) +
                    ", \"y\": " + std::to_string(site.y) +
                    ", \"level\": " + std::to_string(site.level) + ", \"face\": \"" + face +
                    "\", \"to\": {\"x\": " + std::to_string(x) + ", \"y\": " + std::to_string(y) +
                    ", \"level\": " + std::to_string(site.level) +
                    "}, \"turn\": " + std::to_string(90 * pick(4)) + "}";
            ++count;
        }
        if (count > 0) text += ",\n\"portals\": [" + made + "]";
        hasPortals_ = count > 0;
    }

    struct Site {
        int x, y, level;
    };

    Genes genes_;
    Random random_;
    int side_ = 0;
    int levels_ = 0;
    bool hasPortals_ = false;
    std::string mirror_;
    std::vector<std::string> rows_;  // level after level, south after north
    std::vector<Site> sites_;        // walls, where portals can be
};

// ---- Costs

double secondsUsed() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Cost {
    double frameSeconds = 0.0;  // the slowest of some directions, each the better of two
    double stepSeconds = 0.0;
    std::int64_t bytes = 0;  // most that was held beside what the session has at the beginning
};

Cost costOf(World world) {
    static std::vector<Pixel> pixels(std::size_t{kWidth} * kHeight);
    const Picture picture{pixels.data(), kWidth, kHeight, kWidth};
    Session session(std::move(world));
    Cost cost;
    const std::int64_t before = liveBytes;
    mostBytes = liveBytes;
    for (int heading = 0; heading < kHeadings; ++heading) {
        Eye eye = session.eye();
        eye.headingDegrees = 20.0 + heading * 360.0 / kHeadings;
        session.setEye(eye);
        double best = 1e9;
        for (int i = 0; i < 2; ++i) {
            const double begin = secondsUsed();
            session.draw(picture);
            best = std::min(best, secondsUsed() - begin);
        }
        cost.frameSeconds = std::max(cost.frameSeconds, best);
    }
    cost.stepSeconds = 1e9;
    for (int i = 0; i < kSteps; ++i) {
        const double begin = secondsUsed();
        session.step({.forward = 1.0});
        cost.stepSeconds = std::min(cost.stepSeconds, secondsUsed() - begin);
    }
    cost.bytes = mostBytes - before;
    return cost;
}

// How bad a cost is, as a share of what is allowed: 1 is at a limit.
struct Shares {
    double frame, step, memory;
    double worst() const { return std::max({frame, step, memory}); }
    std::string text() const {
        char text[100];
        std::snprintf(text, sizeof text, "frame %.1f castles, step %.2f, %.0f KB",
                      frame * kMostTimes, step * kMostStepTimes, memory * (kMostMemory >> 10));
        return text;
    }
};

Shares sharesOf(World world, double castleSeconds) {
    const Cost cost = costOf(std::move(world));
    return {cost.frameSeconds / (castleSeconds * kMostTimes),
            cost.stepSeconds / (castleSeconds * kMostStepTimes),
            static_cast<double>(cost.bytes) / kMostMemory};
}

std::int64_t toNumber(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? value : 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::int64_t scenes = argc == 3 ? toNumber(argv[1]) : 0;
    if (scenes < 1) {
        std::fprintf(stderr, "usage: slicecast-worst SCENES ASSETS\n");
        return 2;
    }
    const std::filesystem::path folder = std::filesystem::path(argv[2]) / "scenes";
    LoadedScene castle = readSceneFile(folder / "castle.json");
    if (!castle.world) return 1;
    const double unit = costOf(castle.world->copy()).frameSeconds;

    Random random(20'261'123);
    struct Try {
        Genes genes{};
        Shares shares{};
    };
    std::array<Try, 3> worst;  // by frame, step and memory
    int loaded = 0;
    int over = 0;
    for (std::int64_t n = 0; n < scenes; ++n) {
        Try next;
        // Half are new, half change some bytes of one of the worst.
        if (n % 2 == 0) {
            for (std::uint8_t& gene : next.genes) {
                const auto bits = random.next();
                gene = bits % 4 == 0 ? static_cast<std::uint8_t>(bits >> 8) : 0;
            }
        } else {
            next.genes = worst[static_cast<std::size_t>(n / 2 % 3)].genes;
            for (int i = 0; i < 3; ++i)
                next.genes[random.next() % next.genes.size()] =
                    static_cast<std::uint8_t>(random.next());
        }
        // As large as loads in no time.
        if (next.genes[Gene::levels] > 64 && next.genes[Gene::size] > 128)
            next.genes[Gene::levels] /= 4;
        const std::string text = SceneText(next.genes).text();
        ParsedScene parsed = parseScene(text, "worst.json");
        const ReadImages images = readImages(parsed, folder);
        LoadedScene scene = loadScene(std::move(parsed), images.files);
        if (!scene.world) {
            if (loaded == 0 && n > 20) {
                for (const Fault& fault : scene.faults)
                    std::fprintf(stderr, "%s\n", describe(fault).c_str());
                return 1;
            }
            continue;
        }
        ++loaded;
        next.shares = sharesOf(scene.world->copy(), unit);
        for (int i = 0; i < kMeasuredAgain && next.shares.worst() > kSlack; ++i) {
            const double unitNow = costOf(castle.world->copy()).frameSeconds;
            const Shares again = sharesOf(scene.world->copy(), unitNow);
            next.shares.frame = std::min(next.shares.frame, again.frame);
            next.shares.step = std::min(next.shares.step, again.step);
        }
        if (next.shares.worst() > kSlack) {
            const std::string file = "worst-" + std::to_string(over++) + ".json";
            std::ofstream(file) << text;
            std::printf("%s: %s\n", file.c_str(), next.shares.text().c_str());
        }
        if (next.shares.frame > worst[0].shares.frame) worst[0] = next;
        if (next.shares.step > worst[1].shares.step) worst[1] = next;
        if (next.shares.memory > worst[2].shares.memory) worst[2] = next;
    }
    std::printf("%d of %lld scenes load; a castle's frame takes %.2f ms\n", loaded,
                static_cast<long long>(scenes), unit * 1e3);
    const std::array limits = {"frame", "step", "memory"};
    for (std::size_t i = 0; i < worst.size(); ++i)
        std::printf("most %s: %s\n", limits[i], worst[i].shares.text().c_str());
    std::printf("allowed: %s\n", Shares{1.0, 1.0, 1.0}.text().c_str());
    if (loaded < scenes / 4) {
        std::fprintf(stderr, "too few scenes load\n");
        return 1;
    }
    return over == 0 ? 0 : 1;
}
