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

Pieces::Pieces(const std::function<int(double, double)>& pieceOf, double unevenness,
               std::uint32_t seed, int fineness)
    : side_(fineness * kSide),
      pieces_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)),
      edges_(pieces_.size()) {
    const double fine = fineness;
    const int octaveCount = fineness == 1 ? 2 : 3;
    const auto bent = [&](int x, int y, std::uint32_t with) {
        const double bend =
            fractalNoise(x / (8.0 * fine), y / (8.0 * fine), 16, 16, octaveCount, with) - 0.5;
        return static_cast<int>(std::floor(2.0 * bend * unevenness * fine + 0.5));
    };
    for (int y = 0; y < side_; ++y) {
        for (int x = 0; x < side_; ++x) {
            const int fromX = x + bent(x, y, seed);
            const int fromY = y + bent(x, y, seed + 1U);
            pieces_[indexOf(x, y)] = pieceOf(wrap(fromX, side_) / fine, wrap(fromY, side_) / fine);
        }
    }
    const int reach = kEdgeReach * fineness;
    for (int y = 0; y < side_; ++y) {
        for (int x = 0; x < side_; ++x) {
            int best = reach * reach;
            for (int dy = -reach; dy <= reach; ++dy) {
                for (int dx = -reach; dx <= reach; ++dx) {
                    const int square = dx * dx + dy * dy;
                    if (square < best && pieceAt(x + dx, y + dy) != pieceAt(x, y)) {
                        best = square;
                    }
                }
            }
            edges_[indexOf(x, y)] = (std::sqrt(static_cast<double>(best)) - 0.5) / fine;
        }
    }
}

std::function<int(double, double)> coursed(std::vector<Course> courses) {
    return [courses = std::move(courses)](double atX, double atY) {
        const int x = static_cast<int>(atX);
        const int y = static_cast<int>(atY);
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

std::function<int(double, double)> lettered(std::vector<std::string> rows) {
    return [rows = std::move(rows)](double atX, double atY) {
        const int x = static_cast<int>(atX);
        const int y = static_cast<int>(atY);
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

std::function<int(double, double)> nearest(std::vector<Point> points, double flatness) {
    return [points = std::move(points), flatness](double x, double y) {
        return nearestPoint(points, flatness, x, y);
    };
}

}  // namespace slicecast::textures
