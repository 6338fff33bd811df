// Looks for legal scenes, of up to kMostSceneText, that cost too much: random ones with every key
// of the schema, then changes of the worst so far, for each of five costs. The limits are in units
// of the processor time of the castle's picture, drawn at the same size and with its light made:
//
//     load      100   reading the text and making the world, of pictures that are decoded
//     light     300   the first picture, until the program shows it
//     picture    50   any later picture of the program, while things move and gates open
//     step        5
//     memory    64 MB for drawing and stepping, beyond what the session holds after loading
//
// Prints the worst of each. A scene that is over a limit is written to a file, and fails the search
// if it is so by more than a busy machine explains. In a long search, so does a key of the schema
// that was in no scene that loads.
//
//     slicecast-worst SCENES ASSETS SCHEMA [SEED]
//
//     SCENES    how many
//     ASSETS    a folder with scenes/castle.json and the pictures
//     SCHEMA    the file of the schema
#include "app/app.h"
#include "base/random.h"
#include "files/scene_file.h"
#include "scene_maker.h"
#include "session/session.h"
#include "warm_heap.h"

#include <malloc.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace slicecast;

namespace {

enum Kind : std::uint8_t { load, light, picture, step, memory, kinds };
constexpr std::array<const char*, Kind::kinds> kNames = {"load", "light", "picture", "step",
                                                         "memory"};
constexpr std::array kMost = {100.0, 300.0, 50.0, 5.0, 64.0};  // castles; MB

// Times vary on a busy machine: a scene fails only if it exceeds a limit by this factor, also when
// it is measured again and again, each time beside the castle.
constexpr double kSlack = 1.5;
constexpr int kMeasuredAgain = 4;
constexpr double kEnough = 4.0;  // a scene so far over a limit is not measured further
constexpr int kWidth = 640;
constexpr int kHeight = 400;
constexpr int kPictures = 6;                // later ones
constexpr int kStepsOfPicture = 15;         // between two of them
constexpr std::size_t kPool = 4;            // worst scenes that are changed, for each cost
constexpr std::int64_t kLongSearch = 2000;  // scenes

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

// ---- Costs

double secondsUsed() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Work>
double secondsOf(Work work) {
    const double begin = secondsUsed();
    work();
    return secondsUsed() - begin;
}

// Each part's seconds, in the order in which they came; the same scene always has the same parts.
struct Cost {
    std::array<std::vector<double>, Kind::memory> seconds;
    std::int64_t bytes = 0;  // most that was held beside what the session has at the beginning

    // The less of each: what another program took away does not come again at the same place.
    void keepLess(const Cost& other) {
        for (std::size_t kind = 0; kind < seconds.size(); ++kind)
            for (std::size_t i = 0; i < seconds[kind].size() && i < other.seconds[kind].size(); ++i)
                seconds[kind][i] = std::min(seconds[kind][i], other.seconds[kind][i]);
    }
};

// How bad a cost is, as a share of what is allowed: 1 is at a limit.
struct Shares {
    std::array<double, Kind::kinds> of{};
    double worst() const { return *std::max_element(of.begin(), of.end()); }
    std::string text() const {
        std::string all;
        for (std::size_t i = 0; i < of.size(); ++i) {
            std::array<char, 60> text;
            std::snprintf(text.data(), text.size(), "%s%s %.*f%s", i == 0 ? "" : ", ", kNames[i],
                          of[i] * kMost[i] < 10.0 ? 2 : 0, of[i] * kMost[i],
                          i == Kind::memory ? " MB" : "");
            all += text.data();
        }
        return all;
    }
};

Shares sharesOf(const Cost& cost, double castleSeconds) {
    Shares shares;
    for (std::size_t kind = 0; kind < cost.seconds.size(); ++kind)
        for (const double seconds : cost.seconds[kind])
            shares.of[kind] = std::max(shares.of[kind], seconds / (castleSeconds * kMost[kind]));
    shares.of[Kind::memory] = static_cast<double>(cost.bytes) / (1 << 20) / kMost[Kind::memory];
    return shares;
}

// Where the program shows its pictures: nowhere.
class NoScreen : public Shell {
public:
    double nowSeconds() const override { return secondsUsed(); }
    void show(SDL_Surface&) override { hasShown = true; }
    void askForFrame() override {}
    void tell(News, bool) override {}
    void tellShown(bool) override {}
    void tellPortal(const std::string&, const std::string&) override {}
    void tellRates(const FrameRates&) override {}
    void tellSize(int, int) override {}
    void tellHits(Session&, int, int, int) override {}
    void leave() override {}

    bool hasShown = false;
};

// Plays a world that was loaded in so many seconds. Stops when something costs far too much.
Cost costOf(World world, double loadSeconds, double castleSeconds) {
    Cost cost;
    cost.seconds[Kind::load] = {loadSeconds};
    NoScreen screen;
    App app(screen);
    app.resize(kWidth, kHeight);
    app.play(std::make_unique<Session>(std::move(world)));
    const std::int64_t before = liveBytes;
    mostBytes = liveBytes;
    const auto isFarOver = [&] {
        cost.bytes = mostBytes - before;
        return sharesOf(cost, castleSeconds).worst() > kEnough;
    };

    // The first picture, slice by slice. The game's clock stands still: its steps come below.
    constexpr double kNow = 1.0;
    cost.seconds[Kind::light] = {0.0};
    for (bool isDrawn = false; !isDrawn && !isFarOver();) {
        cost.seconds[Kind::light][0] += secondsOf([&] { app.frame(kNow); });
        isDrawn = screen.hasShown || !app.wantsFrame();
    }

    // Later ones, all around and through what opens, each half a step later than its last step
    for (int i = 0; i < kPictures && !isFarOver(); ++i) {
        for (int n = 0; n < kStepsOfPicture; ++n) {
            const Input input = {.forward = i % 2 == 0 ? 1.0 : 0.0,
                                 .turnDegrees = n == 0 ? 360.0 / kPictures : 0.0,
                                 .jump = n == 8,
                                 .use = n % 4 == 0};
            cost.seconds[Kind::step].push_back(secondsOf([&] { app.game()->step(input); }));
            if (isFarOver()) return cost;
        }
        cost.seconds[Kind::picture].push_back(
            secondsOf([&] { app.frame(kNow + 0.5 * kStepSeconds); }));
    }
    return cost;
}

// The castle's picture, the best of some.
double castleSecondsOf(const World& castle) {
    static std::vector<Pixel> pixels(std::size_t{kWidth} * kHeight);
    const Picture canvas = {pixels.data(), kWidth, kHeight, kWidth};
    Session session(castle.copy());
    session.draw(canvas);
    double best = 1e9;
    for (int i = 0; i < 4; ++i) best = std::min(best, secondsOf([&] { session.draw(canvas); }));
    return best;
}

// ---- Scenes

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::int64_t toNumber(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? value : 0;
}

// Reads pictures from a folder, each once. A scene's text has no part in what decoding costs.
class Loader {
public:
    explicit Loader(std::filesystem::path folder) : folder_(std::move(folder)) {}

    struct Loaded {
        LoadedScene scene;
        double seconds = 0.0;
    };
    Loaded load(const std::string& text) {
        Loaded loaded;
        ParsedScene parsed;
        loaded.seconds = secondsOf([&] { parsed = parseScene(text, "worst.json"); });
        if (!parsed.faults.empty()) {
            loaded.scene.faults = std::move(parsed.faults);
            return loaded;
        }
        SceneFiles files;
        EarlyImages early;
        for (const std::string& name : parsed.files) {
            auto& bytes = files_[name];
            if (bytes.empty()) {
                const std::string all = textOf(folder_ / name);
                bytes.assign(all.begin(), all.end());
            }
            files[name] = bytes;
            early.decode(name, bytes);
        }
        loaded.seconds += secondsOf(
            [&] { loaded.scene = loadScene(std::move(parsed), files, std::move(early)); });
        return loaded;
    }
    std::vector<Fault> faultsOf(const std::string& text) { return load(text).scene.faults; }

private:
    std::filesystem::path folder_;
    SceneFiles files_;
};

// ---- The search

struct Try {
    std::string text;
    Shares shares;
};

class Search {
public:
    Search(const std::filesystem::path& assets, const std::string& schema, std::uint64_t seed)
        : loader_(assets / "scenes"),
          maker_(schema,
                 {.wall = "../textures/brick.png",
                  .seeThrough = "../see-through/glass-pane.png",
                  .sheet = "../sheets/double-door.png",
                  .sheetFrames = 8,
                  .sprite = "../sprites/bush.png",
                  .walker = "../sprites/walker.png",
                  .walkerFrames = 8,
                  .panorama = "../textures/sky-dusk.png"},
                 263),
          random_(seed) {
        LoadedScene castle = readSceneFile(assets / "scenes" / "castle.json");
        if (!castle.world) std::abort();
        castle_ = std::move(*castle.world);
        castleSeconds_ = castleSecondsOf(castle_);
    }

    void run(std::int64_t scenes) {
        for (std::int64_t n = 0; n < scenes; ++n) {
            Try next = {.text = nextText(n), .shares = {}};
            if (next.text.empty()) continue;
            ++loaded_;
            maker_.count(next.text);
            measure(next);
            for (std::size_t kind = 0; kind < worst_.size(); ++kind) keep(next, kind);
        }
        report(scenes);
    }

    bool isPassed(std::int64_t scenes) const {
        for (std::size_t kind = 0; kind < worst_.size(); ++kind)
            if (!worst_[kind].empty() && worst_[kind][0].shares.of[kind] > kSlack) return false;
        return isEnough(scenes) && (scenes < kLongSearch || maker_.neverMet().empty());
    }

private:
    bool isEnough(std::int64_t scenes) const { return loaded_ * 4 >= scenes; }

    // A third are new, the others change one of the worst. "" if it does not load.
    std::string nextText(std::int64_t n) {
        const auto faultsOf = [&](const std::string& text) { return loader_.faultsOf(text); };
        const auto& pool = worst_[static_cast<std::size_t>(n) % worst_.size()];
        if (n % 3 != 0 && !pool.empty()) {
            const std::string& before =
                pool[static_cast<std::size_t>(random_.below(static_cast<int>(pool.size())))].text;
            const std::string next = maker_.changed(before, random_);
            if (next != before) return maker_.mended(next, before, faultsOf);
        }
        return maker_.mended(maker_.fresh(random_), "", faultsOf);
    }

    void measure(Try& next) {
        const auto measureOnce = [&] {
            Loader::Loaded loaded = loader_.load(next.text);
            return costOf(std::move(*loaded.scene.world), loaded.seconds, castleSeconds_);
        };
        Cost cost = measureOnce();
        next.shares = sharesOf(cost, castleSeconds_);
        for (int i = 0; i < kMeasuredAgain && isWorseThanAll(next.shares); ++i) {
            castleSeconds_ = castleSecondsOf(castle_);
            cost.keepLess(measureOnce());
            next.shares = sharesOf(cost, castleSeconds_);
        }
    }

    bool isWorseThanAll(const Shares& shares) const {
        for (std::size_t kind = 0; kind < worst_.size(); ++kind)
            if (shares.of[kind] > 1.0 &&
                (worst_[kind].empty() || shares.of[kind] > worst_[kind][0].shares.of[kind]))
                return true;
        return false;
    }

    void keep(const Try& next, std::size_t kind) {
        std::vector<Try>& pool = worst_[kind];
        const auto place = std::find_if(pool.begin(), pool.end(), [&](const Try& other) {
            return next.shares.of[kind] > other.shares.of[kind];
        });
        if (place == pool.end() && pool.size() >= kPool) return;
        if (place == pool.begin() && next.shares.of[kind] > 1.0) {
            const std::string file = std::string("worst-") + kNames[kind] + ".json";
            std::ofstream(file, std::ios::binary) << next.text;
            std::printf("%s: %s\n", file.c_str(), next.shares.text().c_str());
            std::fflush(stdout);
        }
        pool.insert(place, next);
        if (pool.size() > kPool) pool.pop_back();
    }

    void report(std::int64_t scenes) const {
        std::printf("%lld of %lld scenes load; a castle's picture takes %.2f ms\n",
                    static_cast<long long>(loaded_), static_cast<long long>(scenes),
                    castleSeconds_ * 1e3);
        for (std::size_t kind = 0; kind < worst_.size(); ++kind)
            if (!worst_[kind].empty())
                std::printf("most %s: %s; %zu bytes\n", kNames[kind],
                            worst_[kind][0].shares.text().c_str(), worst_[kind][0].text.size());
        std::printf("allowed: %s\n", Shares{{1.0, 1.0, 1.0, 1.0, 1.0}}.text().c_str());
        const std::vector<std::string> never = maker_.neverMet();
        std::printf("%zu of %zu keys of the schema took part\n", maker_.keys() - never.size(),
                    maker_.keys());
        for (const std::string& name : never) std::printf("never: %s\n", name.c_str());
        if (!isEnough(scenes)) std::printf("too few scenes load\n");
    }

    Loader loader_;
    SceneMaker maker_;
    Random random_;
    World castle_;
    double castleSeconds_ = 0.0;
    std::array<std::vector<Try>, Kind::kinds> worst_;  // of each cost, the worst first
    std::int64_t loaded_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    const std::int64_t scenes = argc == 4 || argc == 5 ? toNumber(argv[1]) : 0;
    const std::int64_t seed = argc == 5 ? toNumber(argv[4]) : 20'261'123;
    if (scenes < 1) {
        std::fprintf(stderr, "usage: slicecast-worst SCENES ASSETS SCHEMA [SEED]\n");
        return 2;
    }
    warmHeap();
    Search search(argv[2], textOf(argv[3]), static_cast<std::uint64_t>(seed));
    search.run(scenes);
    return search.isPassed(scenes) ? 0 : 1;
}
