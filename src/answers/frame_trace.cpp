#include "answers/frame_trace.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

using What = FilledRows::What;
static_assert(FilledRows::kWhats == kSeenKinds, "Seen has the renderer's order");

// Rows by level of detail, of each texture or each sprite.
using RowsOfDetails = std::vector<std::array<std::int64_t, kMostDetails>>;

void addColumn(const SliceTrace& trace, ColumnSums& column, RowsOfDetails& textures,
               RowsOfDetails& sprites) {
    column.nearest = std::numeric_limits<double>::infinity();
    column.tiles = static_cast<int>(trace.tiles.size());
    column.hits = static_cast<int>(trace.hits.size());
    for (const FilledRows& run : trace.filled) {
        (run.layer ? column.layers : column.rows[static_cast<std::size_t>(run.what)]) +=
            run.last - run.first;
        if (run.hit >= 0 || run.object >= 0)
            column.nearest = std::min({column.nearest, run.top.depth, run.bottom.depth});
        if (run.texture == kNoTexture) continue;
        RowsOfDetails& uses = run.what == What::object ? sprites : textures;
        if (uses.size() <= run.texture) uses.resize(run.texture + std::size_t{1});
        for (std::size_t m = 0; m < kMostDetails; ++m) uses[run.texture][m] += run.rowsOfDetail[m];
    }
}

template <typename Named>
void addUses(const RowsOfDetails& uses, const std::vector<Named>& named, bool areSprites,
             std::vector<TextureUse>& list) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
        std::size_t details = kMostDetails;
        while (details > 0 && uses[i][details - 1] == 0) --details;
        if (details > 0)
            list.push_back(
                {named[i].name, areSprites, {uses[i].begin(), uses[i].begin() + details}});
    }
}

}  // namespace

FrameTrace frameTrace(Session& session, int width, int height) {
    const FrameReport report = session.measure(width, height);
    FrameTrace frame;
    frame.tilesWalked = report.tilesWalked;
    frame.blocksMet = report.blocksMet;
    frame.spansDrawn = report.spansDrawn;
    frame.rowsFilled = report.rowsFilled;
    frame.layers = report.layers;
    frame.objectSlices = report.objectSlices;
    frame.walksBehindPortals = report.partsBehindPortals;
    frame.deepestPortal = report.deepestPortal;
    frame.mirroredRows = report.mirroredRows;

    frame.columns.resize(static_cast<std::size_t>(width));
    std::vector<int> columns(frame.columns.size());
    for (int column = 0; column < width; ++column)
        columns[static_cast<std::size_t>(column)] = column;
    RowsOfDetails textures;
    RowsOfDetails sprites;
    const TraceRequest request = {
        .width = width, .height = height, .columns = columns, .reflections = false};
    session.trace(request, [&](const SliceTrace& slice) {
        addColumn(slice, frame.columns[static_cast<std::size_t>(slice.column)], textures, sprites);
        frame.horizonRow = slice.horizonRow;
        frame.projectionDistance = slice.projectionDistance;
    });
    addUses(textures, session.world().textures, false, frame.textures);
    addUses(sprites, session.world().sprites, true, frame.textures);
    return frame;
}

}  // namespace slicecast
