#include "render/view/vista.h"

#include "render/light/lit_maps.h"
#include "render/pixels/column_fill.h"
#include "world/water.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace slicecast {
namespace {

constexpr std::int64_t kUnit = 65536;

// Fills 1 / |horizon - (row + 0.5)| by row.
void fillInverseOffsets(const Projection& projection, std::vector<double>& inverseOffsets) {
    inverseOffsets.resize(static_cast<std::size_t>(projection.height + kRowsBeyond));
    for (int row = 0; row < projection.height; ++row) {
        const double offset = std::fabs(projection.horizon - (row + 0.5));
        inverseOffsets[static_cast<std::size_t>(row)] =
            offset > 0.0 ? 1.0 / offset : std::numeric_limits<double>::infinity();
    }
}

}  // namespace

// #region eye-beyond
Viewpoint throughPortal(const Viewpoint& from, const Portal& portal) {
    // Relative to the middle of the portal's tile, then from the middle of the exit tile
    std::int64_t x = from.x - portal.fromX * kUnit - kUnit / 2;
    std::int64_t y = from.y - portal.fromY * kUnit - kUnit / 2;
    for (int i = 0; i < portal.turn; ++i) x = -std::exchange(y, x);
    Viewpoint to = from;
    to.map = portal.toMap;
    to.turn = (from.turn + portal.turn) % 4;
    to.x = x + portal.toX * kUnit + kUnit / 2;
    to.y = y + portal.toY * kUnit + kUnit / 2;
    to.z = from.z + portal.levels * static_cast<std::int32_t>(kUnit);
    return to;
}
// #endregion

void Vista::begin(const FrameView& frame, const Viewpoint& from, FrameRays rays,
                  const Vista* sameMap, FrameObjectRoom& room) {
    viewpoint = from;
    map = &frame.world->maps[static_cast<std::size_t>(from.map)];
    lit = frame.lit->of(from.map);
    projection = &rays.projection;
    inverseOffsets = rays.inverseOffsets;
    lighting = Lighting(*map, *frame.options);
    lighting.putInWater(frame.water, from.upsideDown);
    const double height = Coordinate{from.z}.value();
    const double farRow = projection->rowOf(-height, map->far);
    firstFloorRow =
        std::max(projection->firstFallingRow, projection->firstRowBelowRow(farRow, true));
    if (sameMap == nullptr) ownCells.fill(*map);
    cells = sameMap == nullptr ? &ownCells : sameMap->cells;
    objects.beginFrame(*frame.world, *cells, from, *projection, frame.detail, lighting, room);
    highest = std::max({static_cast<double>(map->levels),
                        map->ceiling.tiles.empty() ? 0.0 : map->ceiling.height.value(),
                        cells->highest()});
    planeLooks.beginFrame({lighting, projection->distance, inverseOffsets,
                           projection->firstFallingRow, projection->height});
    skyRows.beginFrame(map->sky, *projection, frame.eye->headingDegrees + 90.0 * from.turn,
                       frame.world->steps);
}

void Vistas::beginFrame(const World& world, const Eye& eye, const RenderOptions& options,
                        LitMaps& lit, int width, int height) {
    eyeView_ = {.map = eye.map,
                .turn = 0,
                .x = eye.x.raw,
                .y = eye.y.raw,
                .z = eye.z.raw,
                .upsideDown = false};
    const Projection upright(eye, options, width, height);
    if (!projection_) {
        projection_ = std::make_unique<Projection>(upright);
        mirroredProjection_ = std::make_unique<Projection>(upright);
    }
    *projection_ = upright;
    *mirroredProjection_ = upright.mirrored();
    frame_ = {&world, &eye, &options, &lit, Detail(options, upright.distance), {}};
    fillInverseOffsets(*projection_, inverseOffsets_);
    mirroredInverseOffsets_.assign(inverseOffsets_.rbegin() + kRowsBeyond, inverseOffsets_.rend());
    mirroredInverseOffsets_.resize(inverseOffsets_.size());
    vistas_.forgetAll();
    firstOfMaps_.assign(world.maps.size(), nullptr);
    objectRoom_.forgetAll();
    findWater();
}

void Vistas::findWater() {
    const World& world = *frame_.world;
    const Eye& eye = *frame_.eye;
    const WaterAt here = waterAt(world, world.maps[static_cast<std::size_t>(eye.map)], eye.x.tile(),
                                 eye.y.tile(), eye.z);
    frame_.water = {here.water, (here.surface - eye.z).raw};
    if (here.water == nullptr) return;
    Lighting lighting;
    lighting.putInWater(frame_.water, false);
    waterFogs_.assign(static_cast<std::size_t>(projection_->height), 255);
    const double perInverse = Coordinate{frame_.water.surface}.value() * projection_->distance;
    for (int row = 0; row < projection_->firstFallingRow; ++row) {
        const auto i = static_cast<std::size_t>(row);
        waterFogs_[i] = static_cast<std::uint8_t>(lighting.fogAt(perInverse * inverseOffsets_[i]));
    }
}

// #region eye-below
Vista& Vistas::mirrored(const Vista& from, std::int32_t height) {
    Viewpoint below = from.viewpoint;
    below.z = 2 * height - below.z;
    below.upsideDown = true;
    return find(below);
}
// #endregion

Vista& Vistas::find(const Viewpoint& from) {
    const std::uint64_t hash =
        static_cast<std::uint64_t>(from.x) * 0x9e3779b97f4a7c15u +
        static_cast<std::uint64_t>(from.y) * 0xbf58476d1ce4e5b9u +
        static_cast<std::uint32_t>(from.z) * 0x94d049bb133111ebu +
        static_cast<std::uint64_t>(8 * from.map + 2 * from.turn + (from.upsideDown ? 1 : 0));
    return vistas_.find(from, static_cast<std::uint32_t>(hash ^ hash >> 40), [&](Vista& vista) {
        const Vista*& first = firstOfMaps_[static_cast<std::size_t>(from.map)];
        vista.begin(frame_, from,
                    from.upsideDown
                        ? FrameRays{*mirroredProjection_, mirroredInverseOffsets_.data()}
                        : FrameRays{*projection_, inverseOffsets_.data()},
                    first, objectRoom_);
        if (first == nullptr) first = &vista;
        // All columns ask for the objects that the eye sees in its own map
        if (from == eyeView_) vista.objects.askTogether();
    });
}

}  // namespace slicecast
