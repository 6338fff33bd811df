// How the judge's tracer follows one ray: through tiles, heights, portals and mirrors.
#pragma once

#include "place.h"
#include "tracer.h"

#include <array>
#include <cstddef>
#include <limits>

namespace slicecast::judge {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

// How far along the ray something is met: distance / speed on the axis that it was found on, so
// that points can be worked out before the division rounds.
struct Meeting {
    double distance = 0.0;
    double speed = 1.0;

    double along() const { return distance / speed; }
    double at(double direction) const { return direction * distance / speed; }
};

// A border between tiles, or an edge of a block within a tile. It is met "early" when it is crossed
// eastward or southward, for the eye counts as a little further that way.
struct Border {
    Meeting meeting;
    double along = 0.0;
    Tile step;  // the way across it
    bool early = false;
    bool inner = false;  // within a tile
    Half cut =
        Half::none;  // the half beyond, of the tile as the ray sees it; then there is no step
    // How much sooner it is met if the eye moves on by a unit, eastward and southward.
    double sooner[2] = {0.0, 0.0};
};

// One ray on its way. Tiles, points and heights are in the ray's own coordinates (those of the
// eye's map) unless they say map.
class Tracer::Walk {
public:
    Walk(const Tracer& tracer, double px, double py, std::vector<Sight>& sights, Notes& notes);

    void run();
    void addObjects();

private:
    enum class Then { ended, again, leaves };
    // Where the ray begins in a tile: at the eye, on a border, at the height of a top or bottom
    // face through which it came out of a portal, or of a mirror.
    enum class Start { eye, border, portal, mirror };
    enum class Edge { bottom, top, plane };
    // The heights at which something lies in a tile, in the order in which the ray meets them.
    struct Event {
        double height;
        double along;
        int order;  // at equal depth: faces left, then faces entered, then planes
        int level;  // of the block, or kFloor or kCeiling
        bool top;
        bool leaves;         // the block
        Meeting meeting;     // where
        bool isEnd = false;  // an end of the cell, which cuts off a block with slopes
    };
    // Over the eye's map's floor.
    struct Levels {
        double bottom;
        double top;
        bool cut;
    };
    // A top or an underside. A sloped one is a plane; `height` is the plane's over the eye.
    struct Surface {
        double height;
        bool isSloped = false;
        double riseX = 0.0;  // per unit, in the ray's coordinates
        double riseY = 0.0;
        double most = 0.0;  // the block's greatest height on that face
    };
    static constexpr int kFloor = -1;
    static constexpr int kCeiling = -2;
    static constexpr int kNoLevel = -1;
    // A part of the ray within one place; objects of that map are met there. `first` is where its
    // sights begin.
    struct Stretch {
        Place place;
        double from = 0.0;  // t / d
        bool afterMirror = false;
        double eyeZ = 0.0;
        double slope = 0.0;
        std::size_t first = 0;
    };

    bool falls() const { return up_ < 0.0; }
    Meeting meetingOf(double height) const { return {height - eyeZ_, up_}; }
    double alongOf(double height) const;
    bool crossedBefore(double height, const Border& border) const;
    bool isAbove(double height, const Border& border) const;
    bool isAboveAtStart(double height, Edge edge) const;
    Surface surfaceOf(const CellBlueprint& block, int level, Face which, const Place& place,
                      Tile tile) const;
    Meeting meetingOf(const Surface& surface) const;
    bool isAbove(const Surface& surface, const Border& border) const;
    bool isAboveAtStart(const Surface& surface, Edge edge) const;
    static Levels endsOf(const CellBlueprint& block, int level, const Place& place);
    int cutEvents(const std::array<Surface, 4>& surfaces, int level, const Border& leave,
                  Event* events) const;
    Border nextBorder() const;

    // Blocks that fill only a part of their tile. The edges of a plan along an axis, in the order
    // in which the ray crosses them.
    struct PlanEdges {
        Border near;
        Border far;
    };
    PlanEdges planEdges(const Plan& plan, const Place& place, Tile tile, bool alongX) const;
    // How the ray passes a half of its tile: whether it is in it where it enters the tile and where
    // it leaves it; if the two differ, it crosses the cut between.
    struct HalfPass {
        bool begins = false;
        bool ends = false;
        Border cut;
    };
    Half halfOf(BlueprintId id, const Place& place) const;  // as the ray sees it
    HalfPass passHalf(Half half) const;
    Border tileBorder() const;
    bool isBefore(const Border& a, const Border& b) const;
    bool isPassed(const Border& edge) const;
    bool isHere(BlueprintId id) const;
    bool isBehind(BlueprintId id, const Place& place, Tile tile, const Border& border) const;
    bool isWhole(BlueprintId id) const { return blueprint(id).plan.isWhole(); }
    bool beginsAt(const Border& border, BlueprintId id) const;
    bool leaveEdge(const Border& edge);

    const Map& map() const { return mapOf(place_); }
    const Map& mapOf(const Place& place) const {
        return world_.maps[static_cast<std::size_t>(place.map)];
    }
    const CellBlueprint& blueprint(BlueprintId id) const { return world_.blueprints[id]; }
    bool mayPass() const { return portals_ < world_.portalLimit; }
    // Where the ray has just come out of one, no face portal acts at that very height.
    bool acts(const CellBlueprint& block, Face face, double height) const {
        return block.face(face).portal != kNoPortal && !isWhereItCameOut(height);
    }
    bool isWhereItCameOut(double height) const {
        return start_ == Start::portal && height == startHeight_;
    }
    BlueprintId originOf(BlueprintId id) const {
        return blueprint(id).origin == kEmptyCell ? id : blueprint(id).origin;
    }
    bool join(BlueprintId a, BlueprintId b) const;
    bool joinBeside(BlueprintId a, BlueprintId b, Tile mapStep) const;
    // Through a portal, a block that fills only a part of its tile joins none, nor one with slopes.
    bool joinThrough(BlueprintId a, BlueprintId b) const {
        const auto isPlain = [&](BlueprintId id) {
            return isWhole(id) && !blueprint(id).slopes.any();
        };
        return join(a, b) && isPlain(a) && isPlain(b);
    }
    static bool reachesEnd(const CellBlueprint& block, bool above) {
        const Slant& top = block.slopes.top;
        const Slant& bottom = block.slopes.bottom;
        return above ? block.top == tileEdge(1) && (top.isLevel() || top.most() > block.top)
                     : block.bottom == Coordinate{0} &&
                           (bottom.isLevel() || bottom.least() < block.bottom);
    }
    bool isOneBlock(BlueprintId a, BlueprintId b) const;
    BlueprintId touchingNext(const Event& event) const;
    BlueprintId blockBehind(const Place& place, Tile tile, const Border& border) const;
    BlueprintId touching(const Place& place, int level, bool above) const;
    BlueprintId behindLevel(int level, bool above) const;

    Then passTile(const Border& leave);
    Then passOutside(const Border& leave);
    Then passGrid(const Border& leave);
    Then meet(const Event& event, const Event* before);
    Then meetFloor(TextureId texture, bool outside);
    Then throughHeight(PortalId portal, const Event& event, BlueprintId left);
    Then reflect(double height, int ripples);
    bool leaveTile(const Border& leave);
    void passPortal(const Place& next, const Portal& portal, double along, Note kind);

    void push(Sight sight);
    void pushFace(const CellBlueprint& block, int level, Face face, const Meeting& meeting,
                  bool fromInside);
    void pushPlane(Sight::Kind kind, TextureId texture, double light, bool glow,
                   const Meeting& meeting, bool outside);
    void pushHaze(double along);
    void pushBackground();
    void note(Note note) { notes_.set(static_cast<std::size_t>(note)); }
    void note(Note first, int further) {
        notes_.set(static_cast<std::size_t>(first) + static_cast<std::size_t>(further));
    }

    const Tracer& tracer_;
    const World& world_;
    std::vector<Sight>& sights_;
    Notes& notes_;

    // The ray's direction, d units of t ahead: d * (forward + k * right + s * up) = d * forward +
    // (x - W / 2) * right + (horizon - y) * up. Without the division by d, rays through corners and
    // along edges keep exact numbers, and equal quotients come out equal.
    Point direction_;
    double up_;
    double sideways_;
    double leaves_;  // t at which it leaves the eye's water
    Point eye_;
    double eyeZ_;  // behind a mirror the mirrored eye's

    Place place_;
    Tile tile_;
    Tile mapTile_;
    int portals_ = 0;
    bool arrived_ = false;  // the tile is a portal's exit, and the ray came out there
    bool reflected_ = false;
    Start start_ = Start::eye;
    Border enter_;
    Border tileEnter_;       // the border by which the ray came into the tile
    bool isEyeTile_ = true;  // there is none
    double startHeight_ = 0.0;
    BlueprintId left_ = kEmptyCell;  // the block that the ray left where it entered the tile
    int inside_ = kNoLevel;          // the level of the block that it is in
    std::vector<Stretch> stretches_;
};

}  // namespace slicecast::judge
