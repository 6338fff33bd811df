#include "render/view/frame_objects.h"

#include "base/sort.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicecast {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

constexpr int kGroup = 16;            // columns
constexpr std::size_t kTogether = 4;  // groups

using Seen = FrameObjectRoom::Seen;

void begin(ColumnObjects& list) {
    list.objects.clear();
    list.from = list.to = kEndless;
}

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
    asked_ = 0;
    together_ = false;
}

const ColumnObjects& FrameObjects::inColumn(int column, double from, double to) {
    // A search for a group costs as much as many for a column, the more so the more objects
    const int few = std::min(64, static_cast<int>(map_->objects.size() / 64));
    ColumnObjects* list = listOf(column);
    if (from >= list->from && to <= list->to) return *list;
    if (!together_ && asked_++ == few) {
        askTogether();
        list = listOf(column);
    }
    // Farther than asked, so that a slice asks a few times only
    constexpr double kLeast = 16.0;  // units
    const double nearest = std::min(from, list->from);
    const double farthest = nearest + std::max(kLeast, 2.0 * (to - nearest));
    std::span<ColumnObjects> lists = {list, 1};
    int first = column;
    if (together_) {
        const std::size_t group = static_cast<std::size_t>(column / kGroup) / kTogether * kTogether;
        lists = std::span(groups_).subspan(group, std::min(kTogether, groups_.size() - group));
        first = static_cast<int>(group) * kGroup;
    }
    find(lists, first, together_ ? kGroup : 1, nearest, farthest);
    return *list;
}

void FrameObjects::askTogether() {
    together_ = true;
    groups_.resize(static_cast<std::size_t>((projection_->width + kGroup - 1) / kGroup));
    for (ColumnObjects& group : groups_) begin(group);
}

ColumnObjects* FrameObjects::listOf(int column) {
    if (together_) return &groups_[static_cast<std::size_t>(column / kGroup)];
    const std::uint64_t hash = (reinterpret_cast<std::uintptr_t>(this) >> 4) * 0x9e3779b97f4a7c15u +
                               static_cast<std::uint64_t>(column) * 0xbf58476d1ce4e5b9u;
    return &room_->lists.find({this, column}, static_cast<std::uint32_t>(hash >> 32), begin);
}

// Adds what is missing to lists, each of some columns, from a first one on.
void FrameObjects::find(std::span<ColumnObjects> lists, int first, int columns, double from,
                        double to) {
    double missing = to;
    for (ColumnObjects& list : lists) {
        if (from < list.from) {
            list.objects.clear();
            list.from = list.to = from;
        }
        missing = std::min(missing, list.to);
    }
    const int end = first + columns * static_cast<int>(lists.size());
    findSeen(first, end, missing, to);
    mergeSort(room_->seen, room_->sorting, [](const Seen& a, const Seen& b) {
        return a.depth < b.depth || (a.depth == b.depth && a.index < b.index);
    });
    const auto listOf = [&](double column) {
        return static_cast<std::size_t>(std::clamp<double>(column, first, end - 1) - first) /
               columns;
    };
    for (const Seen& seen : room_->seen) {
        FrameObject shown;
        if (!look(seen, shown)) continue;
        const std::size_t last =
            listOf(columnOf(*projection_, seen.left + shown.width, seen.depth) + 1.0);
        for (std::size_t i = listOf(columnOf(*projection_, seen.left, seen.depth) - 1.0); i <= last;
             ++i) {
            if (seen.depth >= lists[i].to)
                lists[i].objects.push_back(static_cast<int>(room_->objects.size()));
        }
        room_->objects.push_back(shown);
    }
    for (ColumnObjects& list : lists) list.to = std::max(list.to, to);
}

// Finds objects in the columns [first, end), with up to a column more on both sides, at depths of
// [from, to).
void FrameObjects::findSeen(int first, int end, double from, double to) {
    // A few more columns, for roundings and edges just outside
    constexpr int kMore = 2;
    const auto aside = [&](int column) {
        return (column - projection_->width / 2.0) / projection_->distance;
    };
    std::vector<int>& near = room_->near;
    near.clear();
    cells_->find(
        {from_.x, from_.y, forward_, right_, aside(first - kMore), aside(end + kMore), from, to},
        near);
    room_->seen.clear();
    for (const int i : near) {
        const Object& object = map_->objects[static_cast<std::size_t>(i)];
        const double dx = static_cast<double>(object.x.raw - from_.x) / 65536.0;
        const double dy = static_cast<double>(object.y.raw - from_.y) / 65536.0;
        const double depth =
            std::floor(65536.0 * (forward_.x * dx + forward_.y * dy) + 0.5) / 65536.0;
        if (depth <= 0.0 || depth < from || depth >= to) continue;
        const double width = object.width.value();
        const double left = right_.x * dx + right_.y * dy - width / 2.0;
        if (end - first == 1) {  // as ObjectCursor::across finds it
            const double share = (projection_->sidewaysSlope(first) * depth - left) / width;
            if (!(share >= 0.0 && share < 1.0)) continue;
        } else if (columnOf(*projection_, left, depth) > end + 1.0 ||
                   columnOf(*projection_, left + width, depth) < first - 1.0)
            continue;
        room_->seen.push_back({depth, left, i});
    }
}

// What an object shows; false if it covers no row.
bool FrameObjects::look(const Seen& seen, FrameObject& shown) const {
    const Object& object = map_->objects[static_cast<std::size_t>(seen.index)];
    shown.bottom = object.z.raw - from_.z;
    shown.top = shown.bottom + object.height.raw;
    shown.firstRow = firstRowBelow(*projection_, shown.top, seen.depth);
    shown.lastRow = firstRowBelow(*projection_, shown.bottom, seen.depth);
    if (shown.firstRow >= shown.lastRow) return false;
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
    return true;
}

}  // namespace slicecast
