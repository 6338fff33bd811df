#include "slowest.h"

#include "canvas.h"
#include "views.h"

#include <algorithm>
#include <cstdio>

namespace slicecast {
namespace {

constexpr std::size_t kCandidates = 8;  // measured again, because other programs disturb
constexpr int kRounds = 12;
constexpr int kFrames = 3;

struct Candidate {
    std::int64_t step;
    SessionMoment moment;
    double seconds;
};

// The least of some frames, after one that makes the light.
double secondsOfFrame(Session& session, Canvas& canvas) {
    const auto draw = [&] { session.draw(canvas.picture()); };
    draw();
    double least = secondsOf(draw);
    for (int i = 1; i < kFrames; ++i) least = std::min(least, secondsOf(draw));
    return least;
}

// The slowest come first.
void keep(std::vector<Candidate>& found, Candidate candidate) {
    const auto place = std::find_if(found.begin(), found.end(), [&](const Candidate& other) {
        return other.seconds < candidate.seconds;
    });
    found.insert(place, std::move(candidate));
    if (found.size() > kCandidates) found.pop_back();
}

}  // namespace

bool printSlowest(const std::string& root, int every, const std::vector<std::string>& scenes) {
    Canvas canvas;
    std::printf("[");
    for (const std::string& scene : scenes) {
        const std::unique_ptr<Session> session = openScene(root, scene);
        std::optional<Replay> tour = openTour(root, scene);
        if (!session || !tour) return false;
        std::vector<Candidate> found;
        while (tour->step(*session)) {
            if (tour->stepsDone() % every != 0) continue;
            const double seconds = secondsOfFrame(*session, canvas);
            if (found.size() < kCandidates || seconds > found.back().seconds)
                keep(found, {tour->stepsDone(), session->moment(), seconds});
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
