#include "slowest.h"

#include "canvas.h"
#include "views.h"

#include <algorithm>
#include <cstdio>

namespace slicecast {
namespace {

constexpr int kFramesOfMoment = 3;
constexpr std::size_t kMostRounds = 32;

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
    for (int i = 1; i < kFramesOfMoment; ++i) least = std::min(least, secondsOf(draw));
    return least;
}

// Other programs make some seem slower than they are: all are measured again and again, and the
// quicker half is dropped, until one is left.
Candidate slowestOf(std::vector<Candidate> all, Session& session, Canvas& canvas) {
    while (all.size() > 1) {
        for (std::size_t round = 0; round <= kMostRounds / all.size(); ++round) {
            for (Candidate& candidate : all) {
                session.restore(candidate.moment);
                candidate.seconds = std::min(candidate.seconds, secondsOfFrame(session, canvas));
            }
        }
        std::sort(all.begin(), all.end(),
                  [](const Candidate& a, const Candidate& b) { return a.seconds > b.seconds; });
        all.erase(all.end() - static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    }
    return std::move(all.front());
}

}  // namespace

bool printSlowest(const std::string& root, int every, const std::vector<std::string>& scenes) {
    Canvas canvas;
    std::printf("[");
    for (const std::string& scene : scenes) {
        const std::unique_ptr<Session> session = openScene(root, scene);
        std::optional<Replay> tour = openTour(root, scene);
        if (!session || !tour) return false;
        std::vector<Candidate> all;
        while (tour->step(*session)) {
            if (tour->stepsDone() % every == 0)
                all.push_back(
                    {tour->stepsDone(), session->moment(), secondsOfFrame(*session, canvas)});
        }
        if (all.empty()) return false;
        const Candidate slowest = slowestOf(std::move(all), *session, canvas);
        session->restore(slowest.moment);
        const SessionState state = session->state();
        std::printf(
            "%s\n  { \"scene\": \"%s\", \"step\": %lld, \"map\": \"%s\", \"x\": %.1f, "
            "\"y\": %.1f, \"z\": %.1f, \"heading\": %.0f, \"nsPerPixel\": %.2f }",
            &scene == &scenes.front() ? "" : ",", scene.c_str(),
            static_cast<long long>(slowest.step), state.map.c_str(), state.x, state.y, state.z,
            state.headingDegrees, nsPerPixel(slowest.seconds));
        std::fflush(stdout);
    }
    std::printf("\n]\n");
    return true;
}

}  // namespace slicecast
