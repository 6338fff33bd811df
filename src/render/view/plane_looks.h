// How the horizontal planes of a vista look, row by row: level of detail, light and fog. Each row
// of a plane has one depth, so this is computed once per frame for all slices, with one look for
// each visible plane. Tables are filled only in the rows that are needed.
#pragma once

#include "base/keyed_pool.h"
#include "render/pixels/column_fill.h"
#include "render/view/detail.h"
#include "render/view/shading.h"
#include "world/blueprint.h"
#include "world/texture.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

struct FrameTexture;

// A horizontal plane: the floor, a ceiling, or the roofs or undersides of blocks at one height.
struct Plane {
    std::int32_t rise = 0;  // 1/65536 units above the eye; never 0 where a level one is drawn
    TextureId texture = kNoTexture;
    double light = 1.0;
    bool glow = false;
    bool southReversed = false;  // undersides and ceilings
    bool mirror = false;         // its texels count as opaque
    bool sloped = false;         // each span has a slope of its own; `rise` is 0 then
    Coordinate east = {};        // CellBlueprint::textureEast and textureSouth
    Coordinate south = {};

    bool isShifted() const { return (east.raw | south.raw) != 0; }

    friend bool operator==(const Plane&, const Plane&) = default;
};

// Values shared by all planes of a vista.
struct PlaneRays {
    Lighting lighting;
    double projectionDistance = 1.0;         // d, pixels
    const double* inverseOffsets = nullptr;  // 1 / |horizon - (row + 0.5)| by row
    int firstFallingRow = 0;                 // the first row that looks down
    int height = 0;                          // rows
};

class PlaneLook {
public:
    // The rows up to `last` since the stretch before; they share level of detail, kind of shade,
    // and whether texels are blended.
    struct Stretch {
        int last;
        std::uint8_t detail;
        PlaneShade shade;
        bool smooth;
    };

    Plane plane;
    double height = 0.0;           // the plane's distance from the eye, units
    double depthPerInverse = 0.0;  // a row's depth per inverse offset
    bool seeThrough = false;       // of its texture

    // Covers all rows on the plane's side of the horizon, from the top, and any others.
    const std::vector<Stretch>& stretches() const { return stretches_; }

    // The tables, valid for the rows [first, last).
    PlaneRows rows(int first, int last) {
        if (first < first_ || last > last_) extend(first, last);
        return {rays_->inverseOffsets, factors_.data(),
                rays_->lighting.foggy ? fogs_.data() : nullptr};
    }

private:
    friend class PlaneLooks;

    void begin(const Plane& looked, const FrameTexture& texture, const Detail& detail,
               const PlaneRays& rays);
    void extend(int first, int last);
    void fill(int first, int last);
    std::uint32_t fogAt(int row) const;
    std::uint32_t factorAt(int row) const;

    const PlaneRays* rays_ = nullptr;
    double fogPerInverse_ = 0.0;  // the same for the way through fog
    int first_ = 0;               // filled rows
    int last_ = 0;
    std::vector<Stretch> stretches_;
    std::vector<std::uint32_t> factors_;
    std::vector<std::uint32_t> fogs_;
};

class PlaneLooks {
public:
    // Forgets all looks; keeps their memory.
    void beginFrame(const PlaneRays& rays);

    // Valid until the next frame begins. Texture and levels of detail must not change during a
    // frame.
    PlaneLook& find(const Plane& plane, const FrameTexture& texture, const Detail& detail);

private:
    PlaneRays rays_;
    KeyedPool<Plane, PlaneLook> looks_;
};

}  // namespace slicecast
