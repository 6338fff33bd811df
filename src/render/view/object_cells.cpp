#include "render/view/object_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace slicecast {
namespace {

constexpr double kSlack = 1.0 / 256.0;  // units; far more than rounding errors

// A half-plane; cells entirely outside of it are skipped.
struct Side {
    double first;  // its greatest value in the first cell; below 0 if the cell is outside
    double perColumn;
    double perRow;

    double at(int column, int row) const { return first + column * perColumn + row * perRow; }
};

}  // namespace

void ObjectCells::fill(const Map& map) {
    map_ = &map;
    columns_ = rows_ = 0;
    halfWidest_ = highest_ = 0.0;
    if (map.objects.empty()) return;
    std::int64_t east = map.objects[0].x.raw;
    std::int64_t south = map.objects[0].y.raw;
    west_ = east;
    north_ = south;
    for (const Object& object : map.objects) {
        west_ = std::min<std::int64_t>(west_, object.x.raw);
        east = std::max<std::int64_t>(east, object.x.raw);
        north_ = std::min<std::int64_t>(north_, object.y.raw);
        south = std::max<std::int64_t>(south, object.y.raw);
        halfWidest_ = std::max(halfWidest_, object.width.value() / 2.0);
        highest_ = std::max(highest_, (object.z + object.height).value());
    }
    // A few objects go into a single cell
    constexpr std::size_t kFew = 64;
    shift_ = map.objects.size() <= kFew ? 40 : 16;
    while ((std::max(east - west_, south - north_) >> shift_) >= kMost) ++shift_;
    columns_ = static_cast<int>((east - west_) >> shift_) + 1;
    rows_ = static_cast<int>((south - north_) >> shift_) + 1;
    // Count, then place them, starting with the last
    starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    const auto startOf = [&](const Object& object) -> int& {
        return starts_[static_cast<std::size_t>(rowOf(object) * columns_ + columnOf(object))];
    };
    for (const Object& object : map.objects) ++startOf(object);
    for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
    order_.resize(map.objects.size());
    for (std::size_t i = map.objects.size(); i-- > 0;)
        order_[static_cast<std::size_t>(--startOf(map.objects[i]))] = static_cast<int>(i);
}

// A cell is outside of the wedge if it is entirely beyond one of the two depths or edges: if the
// greatest value of a . p + b over its points p is below 0.
void ObjectCells::find(const GroundWedge& wedge, std::vector<int>& found) const {
    const double size = static_cast<double>(std::int64_t{1} << shift_) / 65536.0;
    const double x = static_cast<double>(west_ - wedge.x) / 65536.0;  // of the first cell's corner
    const double y = static_cast<double>(north_ - wedge.y) / 65536.0;
    const auto side = [&](double ax, double ay, double b) {
        const double greatest =
            ax * x + ay * y + b + (std::max(ax, 0.0) + std::max(ay, 0.0)) * size;
        return Side{greatest, ax * size, ay * size};
    };
    const auto edge = [&](double aside, double sign) {
        return side(sign * (wedge.right.x - aside * wedge.forward.x),
                    sign * (wedge.right.y - aside * wedge.forward.y), halfWidest_ + kSlack);
    };
    const Side ahead = side(wedge.forward.x, wedge.forward.y, kSlack - wedge.nearest);
    const Side before = side(-wedge.forward.x, -wedge.forward.y, kSlack + wedge.farthest);
    const Side left = edge(wedge.left, 1.0);
    const Side right = edge(wedge.end, -1.0);
    // Only cells near the wedge's corners are looked at
    const double farthest = std::min(
        wedge.farthest, std::fabs(x) + std::fabs(y) + size * (columns_ + rows_) + halfWidest_);
    const auto cellsAlong = [&](double forward, double aside, double begin, int count) {
        const auto [least, most] = std::minmax({wedge.nearest * (forward + aside * wedge.left),
                                                wedge.nearest * (forward + aside * wedge.end),
                                                farthest * (forward + aside * wedge.left),
                                                farthest * (forward + aside * wedge.end)});
        const double more = halfWidest_ + 1.0;
        const auto cellOf = [&](double at) {
            return static_cast<int>(std::clamp((at - begin) / size, -1.0, count * 1.0) + 1.0) - 1;
        };
        return std::pair(std::max(cellOf(least - more), 0),
                         std::min(cellOf(most + more), count - 1));
    };
    const auto [firstRow, lastRow] = cellsAlong(wedge.forward.y, wedge.right.y, y, rows_);
    const auto [firstColumn, lastColumn] = cellsAlong(wedge.forward.x, wedge.right.x, x, columns_);
    for (int row = firstRow; row <= lastRow; ++row)
        for (int column = firstColumn; column <= lastColumn; ++column) {
            if (ahead.at(column, row) < 0.0 || before.at(column, row) < 0.0 ||
                left.at(column, row) < 0.0 || right.at(column, row) < 0.0)
                continue;
            const auto cell = static_cast<std::size_t>(row * columns_ + column);
            for (int i = starts_[cell]; i < starts_[cell + 1]; ++i)
                found.push_back(order_[static_cast<std::size_t>(i)]);
        }
}

}  // namespace slicecast
