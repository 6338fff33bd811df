// Light and fog of level planes, row by row. A row of a plane is at one depth, so its light is
// worked out once a frame for all slices: one table for each height (relative to the eye) and face
// factor in sight, filled only in the rows that are asked for.
#pragma once

#include "render/column_fill.h"
#include "render/shading.h"

#include <cstdint>
#include <vector>

namespace slicecast {

class PlaneShades {
public:
    // Forgets all tables. `inverseOffsets` stays the caller's and holds 1 / |horizon - (row + 0.5)|
    // for each of `height` rows.
    void beginFrame(const Lighting& lighting, double projectionDistance,
                    const double* inverseOffsets, int height);

    // The tables of the plane that lies `rise` (in 1/65536 units, not 0) above the eye, good for
    // the rows [first, last).
    PlaneRows rows(std::int32_t rise, double faceLight, bool glow, int first, int last);

private:
    struct Table {
        std::uint64_t frame = 0;
        std::int32_t rise = 0;
        double faceLight = 0.0;
        bool glow = false;
        int first = 0;  // rows that are filled
        int last = 0;
        std::vector<std::uint32_t> factors;
        std::vector<std::uint32_t> fogs;

        bool isFor(std::int32_t r, double light, bool glows) const {
            return rise == r && faceLight == light && glow == glows;
        }
    };

    Table& find(std::int32_t rise, double faceLight, bool glow);
    void grow();
    void fill(Table& table, int first, int last) const;

    Lighting lighting_;
    double projectionDistance_ = 1.0;
    const double* inverseOffsets_ = nullptr;
    int height_ = 0;
    std::uint64_t frame_ = 0;
    int used_ = 0;               // tables in use this frame
    std::vector<Table> tables_;  // open addressing; the size is a power of two
    Table* recent_ = nullptr;
};

}  // namespace slicecast
