#include "render/frame_objects.h"

#include "base/sort.h"

#include <algorithm>
#include <cmath>

namespace slicecast {

namespace {

// Where a point appears that is `aside` units to the right of the eye, at a depth.
double columnOf(const Projection& projection, double aside, double depth) {
    return aside * projection.distance / depth + projection.width / 2.0;
}

}  // namespace

void FrameObjects::beginFrame(const World& world, const Viewpoint& from,
                              const Projection& projection, const Detail& detail,
                              const Lighting& lighting) {
    const Map& map = world.maps[static_cast<std::size_t>(from.map)];
    findSeen(map, from, projection);
    objects_.clear();
    highest_ = 0.0;
    for (const Seen& seen : seen_) {
        const Object& object = map.objects[static_cast<std::size_t>(seen.index)];
        FrameObject shown;
        shown.bottom = object.z.raw - from.z;
        shown.top = shown.bottom + object.height.raw;
        shown.firstRow = firstRowBelow(projection, shown.top, seen.depth);
        shown.lastRow = firstRowBelow(projection, shown.bottom, seen.depth);
        if (shown.firstRow >= shown.lastRow) continue;
        shown.depth = seen.depth;
        shown.along = seen.depth / projection.distance;
        shown.left = seen.left;
        shown.width = object.width.value();
        const std::vector<SpriteLevel>& levels =
            world.sprites[object.sprite].levelsAt(world.seconds);
        shown.detail =
            detail.levelAt(seen.depth, levels[0].height, static_cast<int>(levels.size()) - 1);
        shown.level = &levels[static_cast<std::size_t>(shown.detail)];
        const Shade shade = lighting.at(seen.depth, object.light, object.glow);
        shown.factor = shade.factor;
        shown.fog = shade.fog;
        shown.index = seen.index;
        objects_.push_back(shown);
        highest_ = std::max(highest_, (object.z + object.height).value());
    }
    putIntoGroups(projection);
}

// Nearest first; those of one depth in the map's order.
void FrameObjects::findSeen(const Map& map, const Viewpoint& from, const Projection& projection) {
    const GroundDirection forward = turned(projection.forward, from.turn);
    const GroundDirection right = turned(projection.right, from.turn);
    seen_.clear();
    for (std::size_t i = 0; i < map.objects.size(); ++i) {
        const Object& object = map.objects[i];
        const double dx = static_cast<double>(object.x.raw - from.x) / 65536.0;
        const double dy = static_cast<double>(object.y.raw - from.y) / 65536.0;
        const double depth =
            std::floor(65536.0 * (forward.x * dx + forward.y * dy) + 0.5) / 65536.0;
        if (depth <= 0.0) continue;
        const double left = right.x * dx + right.y * dy - object.width.value() / 2.0;
        if (columnOf(projection, left, depth) > projection.width + 1.0 ||
            columnOf(projection, left + object.width.value(), depth) < -1.0)
            continue;
        seen_.push_back({depth, left, static_cast<int>(i)});
    }
    mergeSort(seen_, room_, [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
}

void FrameObjects::putIntoGroups(const Projection& projection) {
    const auto groups = static_cast<std::size_t>((projection.width + kGroup - 1) / kGroup);
    if (groups_.size() != groups) groups_.resize(groups);
    for (std::vector<int>& group : groups_) group.clear();
    const double lastColumn = projection.width - 1.0;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        const FrameObject& object = objects_[i];
        const double left = columnOf(projection, object.left, object.depth);
        const double right = columnOf(projection, object.left + object.width, object.depth);
        const int first = static_cast<int>(std::clamp(left - 1.0, 0.0, lastColumn));
        const int last = static_cast<int>(std::clamp(right + 1.0, 0.0, lastColumn));
        for (int group = first / kGroup; group <= last / kGroup; ++group)
            groups_[static_cast<std::size_t>(group)].push_back(static_cast<int>(i));
    }
}

}  // namespace slicecast
