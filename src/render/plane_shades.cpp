#include "render/plane_shades.h"

#include "base/bits.h"

#include <cstddef>
#include <utility>

namespace slicecast {
namespace {

constexpr std::size_t kFirstTables = 64;

std::size_t slotOf(std::int32_t rise, double faceLight, bool glow, std::size_t tables) {
    const std::uint64_t key = (glow ? 0x94d049bb133111ebu : 0u) ^
                              static_cast<std::uint32_t>(rise) * 0x9e3779b97f4a7c15u ^
                              bitCast<std::uint64_t>(faceLight) * 0xbf58476d1ce4e5b9u;
    return static_cast<std::size_t>(key >> 40) & (tables - 1);
}

}  // namespace

void PlaneShades::beginFrame(const Lighting& lighting, double projectionDistance,
                             const double* inverseOffsets, int height) {
    lighting_ = lighting;
    projectionDistance_ = projectionDistance;
    inverseOffsets_ = inverseOffsets;
    height_ = height;
    ++frame_;
    used_ = 0;
    recent_ = nullptr;
    if (tables_.empty()) tables_.resize(kFirstTables);
}

PlaneRows PlaneShades::rows(std::int32_t rise, double faceLight, bool glow, int first, int last) {
    if (!recent_ || !recent_->isFor(rise, faceLight, glow)) recent_ = &find(rise, faceLight, glow);
    Table& table = *recent_;
    if (table.first == table.last) {
        table.first = table.last = first;
    }
    if (first < table.first) {
        fill(table, first, table.first);
        table.first = first;
    }
    if (last > table.last) {
        fill(table, table.last, last);
        table.last = last;
    }
    return {inverseOffsets_, table.factors.data(), lighting_.foggy ? table.fogs.data() : nullptr};
}

PlaneShades::Table& PlaneShades::find(std::int32_t rise, double faceLight, bool glow) {
    if (2 * static_cast<std::size_t>(used_) >= tables_.size()) grow();
    std::size_t slot = slotOf(rise, faceLight, glow, tables_.size());
    while (tables_[slot].frame == frame_ && !tables_[slot].isFor(rise, faceLight, glow))
        slot = (slot + 1) & (tables_.size() - 1);
    Table& table = tables_[slot];
    if (table.frame != frame_) {
        ++used_;
        table.frame = frame_;
        table.rise = rise;
        table.faceLight = faceLight;
        table.glow = glow;
        table.first = table.last = 0;
        table.factors.resize(static_cast<std::size_t>(height_));
        if (lighting_.foggy) table.fogs.resize(static_cast<std::size_t>(height_));
    }
    return table;
}

void PlaneShades::grow() {
    std::vector<Table> old = std::exchange(tables_, std::vector<Table>(tables_.size() * 2));
    for (Table& table : old) {
        if (table.frame != frame_) continue;
        std::size_t slot = slotOf(table.rise, table.faceLight, table.glow, tables_.size());
        while (tables_[slot].frame == frame_) slot = (slot + 1) & (tables_.size() - 1);
        tables_[slot] = std::move(table);
    }
}

void PlaneShades::fill(Table& table, int first, int last) const {
    const double distance =
        (table.rise < 0 ? -table.rise : table.rise) / 65536.0 * projectionDistance_;
    for (int row = first; row < last; ++row) {
        const double depth = distance * inverseOffsets_[row];
        table.factors[static_cast<std::size_t>(row)] =
            inBothHalves(lighting_.factorAt(depth, table.faceLight, table.glow));
    }
    if (!lighting_.foggy) return;
    const double inFog = table.rise > lighting_.surface
                             ? lighting_.surface / 65536.0 * projectionDistance_
                             : distance;
    for (int row = first; row < last; ++row) {
        const double depth = inFog * inverseOffsets_[row];
        table.fogs[static_cast<std::size_t>(row)] = inBothHalves(lighting_.fogAt(depth));
    }
}

}  // namespace slicecast
