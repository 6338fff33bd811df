// How the level planes of a vista look, row by row: level of detail, light and fog. A row of a
// plane is at one depth, so all that is worked out once a frame for all slices: one look for each
// plane in sight. Its tables are filled only in the rows that are asked for.
#pragma once

#include "render/column_fill.h"
#include "render/detail.h"
#include "render/shading.h"
#include "world/blueprint.h"
#include "world/texture.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast {

struct FrameTexture;

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

// What all planes of a vista have in common.
struct PlaneRays {
    Lighting lighting;
    double projectionDistance = 1.0;         // d, pixels
    const double* inverseOffsets = nullptr;  // 1 / |horizon - (row + 0.5)| by row
    int firstFallingRow = 0;                 // the first that looks down
    int height = 0;                          // rows
};

class PlaneLook {
public:
    // Rows before `last`, behind those of the stretch before, that have one level of detail and one
    // kind of shade.
    struct Stretch {
        int last;
        std::uint8_t detail;
        PlaneShade shade;
    };

    Plane plane;
    double height = 0.0;           // the plane's distance from the eye, units
    double depthPerInverse = 0.0;  // the depth that a row sees, by its inverse offset
    bool seeThrough = false;       // its texture

    // All rows of the plane's side of the horizon, from the top, and any others.
    const std::vector<Stretch>& stretches() const { return stretches_; }

    // The tables, good for the rows [first, last).
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
    double fogPerInverse_ = 0.0;  // the way in fog, likewise
    int first_ = 0;               // rows that are filled
    int last_ = 0;
    std::vector<Stretch> stretches_;
    std::vector<std::uint32_t> factors_;
    std::vector<std::uint32_t> fogs_;
};

class PlaneLooks {
public:
    // Forgets all looks, and keeps their memory.
    void beginFrame(const PlaneRays& rays);

    // Valid until the next frame begins. A texture and what decides its levels of detail stay the
    // same throughout a frame.
    PlaneLook& find(const Plane& plane, const FrameTexture& texture, const Detail& detail);

private:
    void grow();
    std::size_t slotOf(const Plane& plane) const;

    PlaneRays rays_;
    std::size_t used_ = 0;
    std::vector<std::unique_ptr<PlaneLook>> looks_;
    std::vector<PlaneLook*> slots_;  // open addressing; the size is a power of two
};

}  // namespace slicecast
