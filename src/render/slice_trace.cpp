// What a slice tells of itself, for those who ask.
#include "render/slice.h"

#include <cmath>

namespace slicecast {

void Slice::traceRows(const Block* block, const FilledRows& rows) {
    if (block) {
        trace_->hits[static_cast<std::size_t>(block->hit)].filled.push_back(rows);
    } else {
        trace_->planes.push_back(rows);
    }
}

void Slice::traceTile() { trace_->tiles.push_back({walk_.tileX, walk_.tileY, walk_.enter().along * projection_.distance}); }

void Slice::traceBlock(Block& block) {
    block.hit = static_cast<int>(trace_->hits.size());
    Hit hit;
    hit.map = frame_.eye.map;
    hit.tileX = walk_.tileX;
    hit.tileY = walk_.tileY;
    hit.level = block.level;
    hit.blueprint = map_.cell(walk_.tileX, walk_.tileY, block.level);
    hit.entered = walk_.enter().along > 0.0;
    hit.face = enteredFace(walk_.enter());
    hit.depth = walk_.enter().along * projection_.distance;
    hit.backDepth = walk_.leave().along * projection_.distance;
    hit.x = frame_.eye.x.value() + ray_.x * walk_.enter().along;
    hit.y = frame_.eye.y.value() + ray_.y * walk_.enter().along;
    hit.rawDepth = walk_.enter().along * std::sqrt(ray_.x * ray_.x + ray_.y * ray_.y);
    hit.bottom = tileEdge(block.level) + block.blueprint->bottom;
    hit.top = tileEdge(block.level) + block.blueprint->top;
    const auto rowOf = [&](double rise, double depth) { return rise == 0.0 ? projection_.horizon : projection_.rowOf(rise, depth); };
    hit.topFrontRow = rowOf(block.top, hit.depth);
    hit.bottomFrontRow = rowOf(block.bottom, hit.depth);
    hit.topBackRow = rowOf(block.top, hit.backDepth);
    hit.bottomBackRow = rowOf(block.bottom, hit.backDepth);
    trace_->hits.push_back(std::move(hit));
}

}  // namespace slicecast
