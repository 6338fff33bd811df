#include "render/view/plane_looks.h"

#include "base/bits.h"
#include "render/view/frame.h"

#include <algorithm>

namespace slicecast {

std::uint32_t PlaneLook::factorAt(int row) const {
    return rays_->lighting.factorAt(depthPerInverse * rays_->inverseOffsets[row], plane.light,
                                    plane.glow);
}

std::uint32_t PlaneLook::fogAt(int row) const {
    return rays_->lighting.fogAt(fogPerInverse_ * rays_->inverseOffsets[row]);
}

// Depth is monotonic along the rows, so equal rows are adjacent.
void PlaneLook::begin(const Plane& looked, const FrameTexture& texture, const Detail& detail,
                      const PlaneRays& rays) {
    plane = looked;
    rays_ = &rays;
    seeThrough = texture.seeThrough;
    height = Coordinate{plane.rise < 0 ? -plane.rise : plane.rise}.value();
    depthPerInverse = height * rays.projectionDistance;
    const std::int32_t surface = rays.lighting.surface;
    fogPerInverse_ = plane.rise > surface ? Coordinate{surface}.value() * rays.projectionDistance
                                          : depthPerInverse;
    first_ = last_ = 0;
    stretches_.clear();
    const auto at = [&](int row) {
        const double depth = depthPerInverse * rays.inverseOffsets[row];
        const int level = detail.levelAt(depth, texture.size, texture.last);
        const PlaneShade shade = fogAt(row) != 0        ? PlaneShade::foggy
                                 : factorAt(row) != 256 ? PlaneShade::dimmed
                                                        : PlaneShade::full;
        return Stretch{row + 1, static_cast<std::uint8_t>(level), shade,
                       detail.isSmooth(level, depth, texture.size)};
    };
    const auto alike = [](const Stretch& a, const Stretch& b) {
        return a.detail == b.detail && a.shade == b.shade && a.smooth == b.smooth;
    };
    const int end = plane.rise < 0 ? rays.height : rays.firstFallingRow;
    int row = plane.rise < 0 ? rays.firstFallingRow : 0;
    // The last stretch covers all remaining rows, so that rows without the plane find one too. No
    // row sees a plane at the eye's own height.
    if (row == end || plane.rise == 0) {
        stretches_.push_back({rays.height, 0, PlaneShade::full, false});
        return;
    }
    Stretch last = at(end - 1);
    for (Stretch here = at(row);; here = at(row)) {
        if (alike(here, last)) break;
        int change = end - 1;  // the first row known to differ
        while (change - row > 1) {
            const int middle = row + (change - row) / 2;
            if (alike(at(middle), here)) {
                row = middle;
            } else {
                change = middle;
            }
        }
        here.last = row = change;
        stretches_.push_back(here);
    }
    last.last = rays.height;
    stretches_.push_back(last);
}

void PlaneLook::extend(int first, int last) {
    factors_.resize(static_cast<std::size_t>(rays_->height));
    if (rays_->lighting.foggy) fogs_.resize(factors_.size());
    if (first_ == last_) first_ = last_ = first;
    if (first < first_) {
        fill(first, first_);
        first_ = first;
    }
    if (last > last_) {
        fill(last_, last);
        last_ = last;
    }
}

void PlaneLook::fill(int first, int last) {
    for (int row = first; row < last; ++row)
        factors_[static_cast<std::size_t>(row)] = inBothHalves(factorAt(row));
    if (!rays_->lighting.foggy) return;
    for (int row = first; row < last; ++row)
        fogs_[static_cast<std::size_t>(row)] = inBothHalves(fogAt(row));
}

void PlaneLooks::beginFrame(const PlaneRays& rays) {
    rays_ = rays;
    looks_.forgetAll();
}

PlaneLook& PlaneLooks::find(const Plane& plane, const FrameTexture& texture, const Detail& detail) {
    const std::uint64_t hash = static_cast<std::uint32_t>(plane.rise) * 0x9e3779b97f4a7c15u +
                               (bitCast<std::uint64_t>(plane.light) ^
                                (std::uint64_t{plane.texture} << 8 | (plane.glow ? 4u : 0u) |
                                 (plane.mirror ? 2u : 0u) | (plane.southReversed ? 1u : 0u))) *
                                   0xbf58476d1ce4e5b9u;
    return looks_.find(plane, static_cast<std::uint32_t>(hash >> 40),
                       [&](PlaneLook& look) { look.begin(plane, texture, detail, rays_); });
}

}  // namespace slicecast
