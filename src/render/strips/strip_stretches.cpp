// Tiles whose edges of blocks and objects divide the way of each column into stretches; and the
// first tile of a part, where columns may stand. Columns in stretches of one kind meet them
// together.
#include "render/strips/strip_walk.h"

#include <bit>

namespace slicecast {

// `plans` are the levels with plans of the tile.
void StripWalk::meetStretches(unsigned bits, std::uint32_t plans, std::uint32_t reached,
                              TextureId floor, TextureId ceiling) {
    beginStretches(bits, plans);
    while (bits != 0) {
        unsigned left = 0;
        eachLane(bits, [&](int i) {
            if (!endStretch(i)) left |= 1u << i;
        });
        for (unsigned rest = bits; rest != 0;) {
            const Stretch& lead = stretchesOf(__builtin_ctz(rest)).stretch;
            unsigned alike = 0;
            eachLane(rest, [&](int i) {
                if (stretchesOf(i).stretch == lead) alike |= 1u << i;
            });
            rest &= ~alike;
            tile_.enterStretch(alike, lead);
            meetStretch(tile_, reached & ~lead.absent, floor, ceiling);
        }
        bits &= ~left;
        eachLane(bits, [&](int i) {
            if (!goOnBehind(i)) bits &= ~(1u << i);
        });
    }
}

// Stands at the border through which the columns enter the tile.
void StripWalk::beginStretches(unsigned bits, std::uint32_t plans) {
    const bool isFirst = isFirstTile(tile_.v);
    const bool hasObjects = !view_.vista->objects.none();
    unsigned enteredAlongU = 0;
    unsigned leftAlongU = 0;
    eachLane(bits, [&](int i) {
        SliceColumn& column = columns_[indexOf(i)];
        tile_.place(i);
        ColumnStretches& way = stretchesOf(i);
        const Crossing enter = column.walk.enter();
        tile_.enters[indexOf(i)] = enter;
        way.leave = column.walk.leave();
        if (enter.alongX == rays_.alongX) enteredAlongU |= 1u << i;
        if (way.leave.alongX == rays_.alongX) leftAlongU |= 1u << i;
        way.stretch = {};
        way.stretch.enters = column.walk.hasEntered() ? End::border : End::nothing;
        way.stretch.isAtEye = column.walk.entered == 0.0;
        if (hasObjects) {
            if (column.objects.knownTo() < way.leave.along)
                column.objects.find(column.walk.entered, way.leave.along);
            column.objects.skip(open_.firstOf(i), open_.lastOf(i));
        }
        findEdges(i, plans);
    });
    const Lanes mask = maskOf(bits);
    tile_.enteredAlongU = chosen(mask, maskOf(enteredAlongU), tile_.enteredAlongU);
    tile_.leftAlongU = chosen(mask, maskOf(leftAlongU), tile_.leftAlongU);
    tile_.isFirst = isFirst && startsInTile_;
    tile_.cover.changed = true;
}

// Finds where blocks of the tile begin and end within it, and which of them a column does not meet
// at its entry.
void StripWalk::findEdges(int i, std::uint32_t plans) {
    SliceColumn& column = columns_[indexOf(i)];
    ColumnStretches& way = stretchesOf(i);
    way.edges.clear();
    const PlanWalk walk(column.walk, view_.vista->viewpoint, column.ray);
    for (; plans != 0; plans &= plans - 1) {
        const int level = std::countr_zero(plans);
        const std::uint32_t bit = std::uint32_t{1} << level;
        const PlanPassage passage =
            walk.passage(view_.blockAt(tile_.tileX(), tile_.tileY(), level).blueprint->plan);
        if (!passage.isMet || passage.enter.inner) way.stretch.absent |= bit;
        if (!passage.isMet) continue;
        if (passage.enter.inner) way.edges.add(walk, passage.enter, bit, 0);
        if (passage.leave.inner) way.edges.add(walk, passage.leave, 0, bit);
    }
    way.edge = way.edges.begin();
}

// Finds the end of a column's stretch; false if it is that of the tile. What an edge and an object
// at one depth show comes in this order.
bool StripWalk::endStretch(int i) {
    const SliceColumn& column = columns_[indexOf(i)];
    ColumnStretches& way = stretchesOf(i);
    Stretch& stretch = way.stretch;
    const double objectAlong = column.objects.nextAlong();
    const PlanEdge* const edge = way.edge;
    Crossing& leave = tile_.leaves[indexOf(i)];
    stretch.leaves = End::border;
    stretch.staying = 0;
    leave = way.leave;
    if (edge != way.edges.end() && edge->at.along <= objectAlong) {
        stretch.leaves = End::edge;
        stretch.staying = ~edge->leaves;
        leave = edge->at;
    } else if (objectAlong < leave.along) {
        stretch.leaves = End::object;
        leave = column.objects.crossing();
    }
    stretch.entersAhead = tile_.enters[indexOf(i)].along > 0.0;
    stretch.leavesAhead = leave.along > 0.0;
    return stretch.leaves != End::border;
}

// Begins the next stretch of a column behind an edge or an object; false if no row is open.
bool StripWalk::goOnBehind(int i) {
    SliceColumn& column = columns_[indexOf(i)];
    ColumnStretches& way = stretchesOf(i);
    Stretch& stretch = way.stretch;
    stretch.enters = stretch.leaves;
    stretch.within = ~stretch.absent;
    tile_.enters[indexOf(i)] = tile_.leaves[indexOf(i)];
    if (stretch.leaves == End::edge) {
        const PlanEdge& edge = *way.edge++;
        stretch.absent = (stretch.absent | edge.leaves) & ~edge.enters;
        stretch.within &= ~stretch.absent;
        if (edge.at.along > 0.0) stretch.late |= edge.enters;
    } else {
        open_.write(i);
        column.meetObject();
        column.objects.skip(column.open.first(), column.open.last());
        open_.read(i);
    }
    return open_.firstOf(i) < open_.lastOf(i);
}

}  // namespace slicecast
