// What a slice tells of itself, for those who ask.
#include "render/slice.h"

#include <bit>
#include <cmath>

namespace slicecast {

void Slice::traceRows(int level, const FilledRows& rows) {
    if (level == kNoLevel) {
        trace_->planes.push_back(rows);
        return;
    }
    const int above = std::popcount(tracedLevels_ >> level);
    trace_->hits[trace_->hits.size() - static_cast<std::size_t>(above)].filled.push_back(rows);
}

void Slice::traceTile(int x, int y, double along) { trace_->tiles.push_back({vista_->viewpoint.map, x, y, along * projection_->distance}); }

void Slice::traceBlocks(std::uint32_t levels) {
    tracedLevels_ = levels;
    for (std::uint32_t rest = levels; rest != 0; rest &= rest - 1) traceBlock(blockAt(std::countr_zero(rest)));
}

void Slice::traceBlock(const Block& block) {
    Hit hit;
    hit.map = vista_->viewpoint.map;
    hit.portals = portals_;
    hit.tileX = walk_.tileX;
    hit.tileY = walk_.tileY;
    hit.level = block.level;
    hit.blueprint = map_->cell(walk_.tileX, walk_.tileY, block.level);
    hit.entered = enter_.along > 0.0;
    hit.face = enteredFace(enter_);
    hit.depth = enter_.along * projection_->distance;
    hit.backDepth = leave_.along * projection_->distance;
    hit.x = eyeTileX_ + eyeFractionX_ + ray_.x * enter_.along;
    hit.y = eyeTileY_ + eyeFractionY_ + ray_.y * enter_.along;
    hit.rawDepth = enter_.along * std::sqrt(ray_.x * ray_.x + ray_.y * ray_.y);
    hit.bottom = tileEdge(block.level) + block.blueprint->bottom;
    hit.top = tileEdge(block.level) + block.blueprint->top;
    const auto rowOf = [&](std::int32_t rise, double depth) { return rise == 0 ? projection_->horizon : projection_->rowOf(Coordinate{rise}.value(), depth); };
    hit.topFrontRow = rowOf(block.top, hit.depth);
    hit.bottomFrontRow = rowOf(block.bottom, hit.depth);
    hit.topBackRow = rowOf(block.top, hit.backDepth);
    hit.bottomBackRow = rowOf(block.bottom, hit.backDepth);
    trace_->hits.push_back(std::move(hit));
}

}  // namespace slicecast
