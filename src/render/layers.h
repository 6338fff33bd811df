// What a slice sees through: faces and planes with see-through texels, gathered from front to back
// while the walk goes on, and laid over the opaque rows from back to front when it is done.
#pragma once

#include "render/column_fill.h"
#include "world/blueprint.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicecast {

// A level plane: the floor, a ceiling, or the roofs or undersides of blocks that end at one height.
struct Plane {
    std::int32_t rise = 0;  // 1/65536 units above the eye, never 0 where anything is drawn
    TextureId texture = kNoTexture;
    double light = 1.0;
    bool glow = false;
    bool southReversed = false;  // undersides and ceilings
    bool mirror = false;         // its texels count as opaque

    friend bool operator==(const Plane&, const Plane&) = default;
};

// Rows of a plane that lie over one tile or several in a row.
struct PlaneRun {
    Plane plane;
    int first = -1;  // no rows where `first` is `last`
    int last = -1;
    int fromX = 0;  // the first tile, nearest to the eye
    int fromY = 0;
    int toX = 0;  // the last one
    int toY = 0;
    bool endless = false;  // goes on in the ray's direction for ever
};

// Rows of a side or of an object: one column of texels.
struct SideRun {
    const Pixel* texels = nullptr;  // see fillSide
    int shift = 0;
    int first = 0;
    int last = 0;
    std::uint64_t start = 0;
    std::uint64_t step = 0;
    std::uint32_t factor = 256;
    std::uint32_t fog = 0;
    Pixel haze = 0;
};

class Vista;

// Rows of a plane, and where they were seen.
struct LayerPlane {
    PlaneRun run;
    Vista* vista = nullptr;
};

// At most this many runs of one slice are seen through; the farthest beyond are left out.
inline constexpr std::size_t kMaxLayers = 4096;

class Layers {
public:
    bool empty() const { return order_.empty(); }
    std::size_t count() const { return order_.size(); }
    void clear() {
        order_.clear();
        sides_.clear();
        planes_.clear();
    }
    void add(const SideRun& run) {
        if (order_.size() >= kMaxLayers) return;
        sides_.push_back(run);
        order_.push_back(true);
    }
    void add(const PlaneRun& run, Vista& vista) {
        if (order_.size() >= kMaxLayers) return;
        planes_.push_back({run, &vista});
        order_.push_back(false);
    }

    // Hands out all runs, the farthest first.
    template <typename OnSide, typename OnPlane>
    void fromBack(OnSide&& onSide, OnPlane&& onPlane) const {
        std::size_t side = sides_.size();
        std::size_t plane = planes_.size();
        for (std::size_t i = order_.size(); i-- > 0;) {
            if (order_[i]) {
                onSide(sides_[--side]);
            } else {
                onPlane(planes_[--plane]);
            }
        }
    }

private:
    std::vector<char> order_;  // front to back: whether a side comes next
    std::vector<SideRun> sides_;
    std::vector<LayerPlane> planes_;
};

}  // namespace slicecast
