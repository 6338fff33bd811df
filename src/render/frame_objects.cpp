#include "render/frame_objects.h"

#include "base/sort.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

namespace {

using Seen = FrameObjectRoom::Seen;

// The column, as a real number, of a point `aside` units right of the eye at a depth.
double columnOf(const Projection& projection, double aside, double depth) {
    return aside * projection.distance / depth + projection.width / 2.0;
}

}  // namespace

void FrameObjects::beginFrame(const World& world, const ObjectCells& cells, const Viewpoint& from,
                              const Projection& projection, const Detail& detail,
                              const Lighting& lighting, FrameObjectRoom& room) {
    world_ = &world;
    map_ = &cells.map();
    cells_ = &cells;
    projection_ = &projection;
    lighting_ = &lighting;
    from_ = from;
    detail_ = detail;
    forward_ = turned(projection.forward, from.turn);
    right_ = turned(projection.right, from.turn);
    room_ = &room;
    groups_.resize(static_cast<std::size_t>((projection.width + kGroup - 1) / kGroup));
    known_.assign(groups_.size(), 0);
    asked_ = 0;
}

void FrameObjects::ask(int group) {
    const int few = static_cast<int>(groups_.size()) / 4;
    if (asked_++ < few) return find(group, group);
    findAll();
}

void FrameObjects::findAll() {
    find(0, static_cast<int>(groups_.size()) - 1);
}

// Fills the unknown lists of the groups from `first` to `last`, nearest first; at equal depth in
// the map's order.
void FrameObjects::find(int first, int last) {
    findSeen(first * kGroup, (last + 1) * kGroup);
    mergeSort(room_->seen, room_->sorting, [](const Seen& a, const Seen& b) {
        return a.depth < b.depth || (a.depth == b.depth && a.index < b.index);
    });
    for (int group = first; group <= last; ++group)
        if (!isKnown(group)) groups_[static_cast<std::size_t>(group)].clear();
    for (const Seen& seen : room_->seen) add(seen, first, last);
    for (int group = first; group <= last; ++group) known_[static_cast<std::size_t>(group)] = 1;
}

// Finds objects in the columns [first, end), with up to a column more on both sides.
void FrameObjects::findSeen(int first, int end) {
    // A few more columns, for roundings and edges just outside
    constexpr int kMore = 4;
    const auto aside = [&](int column) {
        return (column - projection_->width / 2.0) / projection_->distance;
    };
    std::vector<int>& near = room_->near;
    near.clear();
    cells_->find({from_.x, from_.y, forward_, right_, aside(first - kMore), aside(end + kMore)},
                 near);
    room_->seen.clear();
    for (const int i : near) {
        const Object& object = map_->objects[static_cast<std::size_t>(i)];
        const double dx = static_cast<double>(object.x.raw - from_.x) / 65536.0;
        const double dy = static_cast<double>(object.y.raw - from_.y) / 65536.0;
        const double depth =
            std::floor(65536.0 * (forward_.x * dx + forward_.y * dy) + 0.5) / 65536.0;
        if (depth <= 0.0) continue;
        const double width = object.width.value();
        const double left = right_.x * dx + right_.y * dy - width / 2.0;
        if (columnOf(*projection_, left, depth) > end + 1.0 ||
            columnOf(*projection_, left + width, depth) < first - 1.0)
            continue;
        room_->seen.push_back({depth, left, i});
    }
}

void FrameObjects::add(const Seen& seen, int firstGroup, int lastGroup) {
    const Object& object = map_->objects[static_cast<std::size_t>(seen.index)];
    FrameObject shown;
    shown.bottom = object.z.raw - from_.z;
    shown.top = shown.bottom + object.height.raw;
    shown.firstRow = firstRowBelow(*projection_, shown.top, seen.depth);
    shown.lastRow = firstRowBelow(*projection_, shown.bottom, seen.depth);
    if (shown.firstRow >= shown.lastRow) return;
    shown.depth = seen.depth;
    shown.along = seen.depth / projection_->distance;
    shown.left = seen.left;
    shown.width = object.width.value();
    const SharedVector<SpriteLevel>& levels = world_->sprites[object.sprite].levelsAt(
        world_->steps, sideTowards(object, from_.x - object.x.raw, from_.y - object.y.raw));
    shown.detail =
        detail_.levelAt(seen.depth, levels[0].height, static_cast<int>(levels.size()) - 1);
    shown.level = &levels[static_cast<std::size_t>(shown.detail)];
    const Shade shade = lighting_->at(seen.depth, object.light, object.glow);
    shown.factor = shade.factor;
    shown.fog = shade.fog;
    shown.index = seen.index;
    const auto groupOf = [&](double column) {
        return static_cast<int>(std::clamp(column, 0.0, projection_->width - 1.0)) / kGroup;
    };
    const int first = groupOf(columnOf(*projection_, seen.left, seen.depth) - 1.0);
    const int last = groupOf(columnOf(*projection_, seen.left + shown.width, seen.depth) + 1.0);
    for (int group = std::max(first, firstGroup); group <= std::min(last, lastGroup); ++group) {
        if (!isKnown(group))
            groups_[static_cast<std::size_t>(group)].push_back(
                static_cast<int>(room_->objects.size()));
    }
    room_->objects.push_back(shown);
}

}  // namespace slicecast
