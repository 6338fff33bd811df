// Roofs and undersides, for all columns of a strip that pass a tile.
#include "render/strip_walk.h"

namespace slicecast {

void StripWalk::enterTop(const Block& block, Lanes first, Lanes last) {
    const bool isMirror = any().mirrorStrength(block.blueprint->face(Face::top).mirror) > 0;
    if (block.blueprint->seeThrough && !(isMirror && !joinsNext(block, 1)))
        return seePlane(block, Face::top, first, last);
    takePlane(block, Face::top, first, last);
}

void StripWalk::enterBottom(const Block& block, Lanes first, Lanes last) {
    if (block.blueprint->seeThrough) return seePlane(block, Face::bottom, first, last);
    takePlane(block, Face::bottom, first, last);
}

// See SliceWalk::joinsNext; here without movers and portals.
bool StripWalk::joinsNext(const Block& block, int up) const {
    const HeightClip& clip = any().clip_;
    if (up > 0 ? block.top == clip.high : block.bottom == clip.low) return false;
    const CellBlueprint& own = *block.blueprint;
    if (!own.join || !(up > 0 ? own.fillsUp() : own.fillsDown())) return false;
    const CellBlueprint& next =
        frame_.world->blueprints[map_->cell(tileX(v_), tileY(v_), block.level + up)];
    return areJoined(*frame_.world, own, next) && (up > 0 ? next.fillsDown() : next.fillsUp());
}

// Closes the rows of a roof or an underside.
void StripWalk::takePlane(const Block& block, Face face, Lanes first, Lanes last) {
    const bool isTop = face == Face::top;
    const FaceBlueprint& shown = block.blueprint->face(face);
    const int strength = isTop ? any().mirrorStrength(shown.mirror) : 0;
    PlaneLook* look = nullptr;
    for (const auto& [i, from, to] : open_.take(mask_, first, last)) {
        SliceWalk& walk = lane(i);
        if (look == nullptr) {
            Plane plane = walk.planeOf(block, face);
            plane.mirror = strength > 0;
            look = &walk.lookOf(plane);
        }
        if (strength > 0) walk.mirror(block.top, from, to, strength, shown.ripples);
        walk.addFace(isTop ? What::roof : What::underside, *look, from, to, here(), block.level);
    }
}

// Adds the layer of a roof or an underside.
void StripWalk::seePlane(const Block& block, Face face, Lanes first, Lanes last) {
    if (!any().isThere(block, face) || joinsNext(block, face == Face::top ? 1 : -1)) return;
    const unsigned bits =
        bitsOf(mask_ & (first < last) & open_.reachBelow(first) & open_.reachAbove(last));
    if (bits == 0) return;
    const Plane plane = any().planeOf(block, face);
    const LaneValues from(first);
    const LaneValues to(last);
    eachLane(bits, [&](int i) {
        open_.write(i);
        lane(i).seeThroughPlane(face == Face::top ? What::roof : What::underside, plane, from.at[i],
                                to.at[i], here(), block.level);
    });
}

}  // namespace slicecast
