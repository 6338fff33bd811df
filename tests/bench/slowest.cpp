#include "slowest.h"

#include "canvas.h"
#include "limit_kernel.h"
#include "views.h"

#include <algorithm>
#include <cstdio>

namespace slicecast {
namespace {

constexpr std::size_t kCandidates = 16;  // measured again, because other programs disturb
constexpr int kRounds = 12;
constexpr int kFrames = 3;

struct Candidate {
    std::int64_t step;
    SessionMoment moment;
    double timesTheLimit;
    double seconds;
};

template <typename Draw>
double leastSeconds(Draw&& draw) {
    double least = secondsOf(draw);
    for (int i = 1; i < kFrames; ++i) least = std::min(least, secondsOf(draw));
    return least;
}

// Of some frames, after one that makes the light.
double secondsOfFrame(Session& session, Canvas& canvas) {
    session.draw(canvas.picture());
    return leastSeconds([&] { session.draw(canvas.picture()); });
}

// The slowest come first.
void keep(std::vector<Candidate>& found, Candidate candidate) {
    const auto place = std::find_if(found.begin(), found.end(), [&](const Candidate& other) {
        return other.timesTheLimit < candidate.timesTheLimit;
    });
    found.insert(place, std::move(candidate));
    if (found.size() > kCandidates) found.pop_back();
}

}  // namespace

bool printSlowest(const std::string& root, int every, const std::vector<std::string>& scenes) {
    Canvas canvas;
    LimitKernel kernel(kWidth, kHeight);
    std::printf("[");
    for (const std::string& scene : scenes) {
        const std::unique_ptr<Session> session = openScene(root, scene);
        std::optional<Replay> tour = openTour(root, scene);
        if (!session || !tour) return false;
        std::vector<Candidate> found;
        while (tour->step(*session)) {
            if (tour->stepsDone() % every != 0) continue;
            const double seconds = secondsOfFrame(*session, canvas);
            const double limit = leastSeconds([&] { kernel.draw(canvas.pixels.data()); });
            if (found.size() < kCandidates || seconds / limit > found.back().timesTheLimit)
                keep(found, {tour->stepsDone(), session->moment(), seconds / limit, seconds});
        }
        for (int round = 0; round < kRounds; ++round) {
            for (Candidate& candidate : found) {
                session->restore(candidate.moment);
                candidate.seconds = std::min(candidate.seconds, secondsOfFrame(*session, canvas));
            }
        }
        const auto slowest = std::max_element(
            found.begin(), found.end(),
            [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });
        if (slowest == found.end()) return false;
        session->restore(slowest->moment);
        const SessionState state = session->state();
        std::printf(
            "%s\n  { \"scene\": \"%s\", \"step\": %lld, \"map\": \"%s\", \"x\": %.1f, "
            "\"y\": %.1f, \"z\": %.1f, \"heading\": %.0f, \"nsPerPixel\": %.2f }",
            &scene == &scenes.front() ? "" : ",", scene.c_str(),
            static_cast<long long>(slowest->step), state.map.c_str(), state.x, state.y, state.z,
            state.headingDegrees, nsPerPixel(slowest->seconds));
        std::fflush(stdout);
    }
    std::printf("\n]\n");
    return true;
}

}  // namespace slicecast
