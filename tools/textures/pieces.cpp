#include "pieces.h"

#include <cmath>
#include <utility>

#include "noise.h"

namespace slicecast::textures {

namespace {

int nearestPoint(const std::vector<Point>& points, double flatness, double x, double y) {
    int best = 0;
    double bestDistance = 1.0e9;
    for (std::size_t index = 0; index < points.size(); ++index) {
        const double dx = wrappedDifference(points[index].x, x);
        const double dy = wrappedDifference(points[index].y, y) * flatness;
        const double distance = dx * dx + dy * dy;
        if (distance < bestDistance) {
            bestDistance = distance;
            best = static_cast<int>(index);
        }
    }
    return best;
}

// Moves every point to the middle of its region.
void relax(std::vector<Point>& points, double flatness) {
    std::vector<Point> sums(points.size(), Point{0.0, 0.0});
    std::vector<int> counts(points.size(), 0);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto owner = static_cast<std::size_t>(nearestPoint(points, flatness, x, y));
            sums[owner].x += wrappedDifference(points[owner].x, x);
            sums[owner].y += wrappedDifference(points[owner].y, y);
            ++counts[owner];
        }
    }
    for (std::size_t index = 0; index < points.size(); ++index) {
        if (counts[index] > 0) {
            points[index].x += sums[index].x / counts[index];
            points[index].y += sums[index].y / counts[index];
        }
    }
}

}  // namespace

double wrappedDifference(double from, double to) {
    const double difference = to - from;
    return difference - kSide * std::floor(difference / kSide + 0.5);
}

Pieces::Pieces(const std::function<int(int, int)>& pieceOf, double unevenness, std::uint32_t seed)
    : pieces_(static_cast<std::size_t>(kSide) * kSide),
      edges_(static_cast<std::size_t>(kSide) * kSide) {
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double bendX = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, seed) - 0.5;
            const double bendY = fractalNoise(x / 8.0, y / 8.0, 16, 16, 2, seed + 1U) - 0.5;
            const int fromX = x + static_cast<int>(std::floor(2.0 * bendX * unevenness + 0.5));
            const int fromY = y + static_cast<int>(std::floor(2.0 * bendY * unevenness + 0.5));
            pieces_[indexOf(x, y)] = pieceOf(wrap(fromX, kSide), wrap(fromY, kSide));
        }
    }
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            int best = kEdgeReach * kEdgeReach;
            for (int dy = -kEdgeReach; dy <= kEdgeReach; ++dy) {
                for (int dx = -kEdgeReach; dx <= kEdgeReach; ++dx) {
                    const int square = dx * dx + dy * dy;
                    if (square < best && pieceAt(x + dx, y + dy) != pieceAt(x, y)) {
                        best = square;
                    }
                }
            }
            edges_[indexOf(x, y)] = std::sqrt(static_cast<double>(best)) - 0.5;
        }
    }
}

std::function<int(int, int)> coursed(std::vector<Course> courses) {
    return [courses = std::move(courses)](int x, int y) {
        int number = 0;
        int top = 0;
        while (y >= top + courses[static_cast<std::size_t>(number)].height) {
            top += courses[static_cast<std::size_t>(number)].height;
            ++number;
        }
        const Course& course = courses[static_cast<std::size_t>(number)];
        int along = wrap(x - course.offset, kSide);
        int block = 0;
        while (along >= course.widths[static_cast<std::size_t>(block)]) {
            along -= course.widths[static_cast<std::size_t>(block)];
            ++block;
        }
        return 16 * number + block;
    };
}

std::function<int(int, int)> lettered(std::vector<std::string> rows) {
    return [rows = std::move(rows)](int x, int y) {
        const int size = kSide / static_cast<int>(rows.size());
        return static_cast<int>(
            rows[static_cast<std::size_t>(y / size)][static_cast<std::size_t>(x / size)]);
    };
}

std::vector<Point> spreadPoints(int count, double flatness, std::uint32_t seed) {
    Random random(seed);
    std::vector<Point> points;
    for (int index = 0; index < count; ++index) {
        const double x = random.between(0.0, kSide);
        const double y = random.between(0.0, kSide);
        points.push_back({x, y});
    }
    for (int round = 0; round < 3; ++round) {
        relax(points, flatness);
    }
    return points;
}

std::function<int(int, int)> nearest(std::vector<Point> points, double flatness) {
    return [points = std::move(points), flatness](int x, int y) {
        return nearestPoint(points, flatness, x, y);
    };
}

}  // namespace slicecast::textures
