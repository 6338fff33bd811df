#include "render/crew_renderer.h"

#include "render/pixels/strip.h"

#include <algorithm>
#include <atomic>

namespace slicecast {
namespace {

void add(FrameReport& sum, const FrameReport& part) {
    sum.tilesWalked += part.tilesWalked;
    sum.blocksMet += part.blocksMet;
    sum.spansDrawn += part.spansDrawn;
    sum.partsBehindPortals += part.partsBehindPortals;
    sum.deepestPortal = std::max(sum.deepestPortal, part.deepestPortal);
    sum.mirroredRows += part.mirroredRows;
    sum.layers += part.layers;
    sum.objectSlices += part.objectSlices;
    sum.rowsFilled += part.rowsFilled;
    sum.lightWork += part.lightWork;
    sum.lateLight += part.lateLight;
    sum.unlit += part.unlit;
}

}  // namespace

bool CrewRenderer::draw(const World& world, const Eye& eye, const RenderOptions& options,
                        const Picture& picture, int firstColumn) {
    const int hands = crew_ != nullptr ? crew_->hands() : 1;
    if (hands <= 1) {
        Renderer& alone = renderers_.front();
        const bool isDrawn = alone.draw(world, eye, options, picture, firstColumn);
        report_ = alone.report();
        return isDrawn;
    }
    if (renderers_.size() < static_cast<std::size_t>(hands))
        renderers_.resize(static_cast<std::size_t>(hands));
    const int first = std::max(0, firstColumn);
    std::atomic<int> nextStrip = first / kStripColumns;
    const auto next = [&nextStrip, first] {
        return std::max(first, nextStrip.fetch_add(1, std::memory_order_relaxed) * kStripColumns);
    };
    std::atomic<bool> isDrawn = true;
    crew_->work([&](int hand) {
        Renderer& own = renderers_[static_cast<std::size_t>(hand)];
        if (!own.drawStrips(world, eye, options, picture, next)) isDrawn = false;
    });
    report_ = {};
    for (int hand = 0; isDrawn && hand < hands; ++hand)
        add(report_, renderers_[static_cast<std::size_t>(hand)].report());
    return isDrawn;
}

int CrewRenderer::drawSome(const World& world, const Eye& eye, const RenderOptions& options,
                           const Picture& picture, int firstColumn) {
    Renderer& alone = renderers_.front();
    const int next = alone.drawSome(world, eye, options, picture, firstColumn);
    report_ = alone.report();
    return next;
}

}  // namespace slicecast
