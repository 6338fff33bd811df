// The judge's tracer: a slow, plain statement of what a correct picture is. It follows the ray of
// one pixel through the blocks in three dimensions, in double precision: from border to border and
// from height to height, through portals and up again from mirrors. It knows nothing of the
// renderer: it includes `base` and `world` only, and does its own sampling, light and fog.
#pragma once

#include "base/coordinate.h"
#include "light_tracer.h"
#include "slicecast/colour.h"
#include "world/world.h"

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace slicecast::judge {

struct View {
    int map = 0;
    Coordinate x;
    Coordinate y;
    Coordinate z;
    double headingDegrees = 0.0;
    double look = 0.0;  // screen heights
    double fovDegrees = 60.0;
    int width = 1;
    int height = 1;
    bool detail = true;
    double detailThreshold = 1.0;  // of level 1, and then doubled; in texels a pixel
    bool smooth = false;
    bool textures = true;  // off: only the last level
    bool light = true;
    bool fog = true;
    bool baked = true;
    double mirrors = 1.0;  // a mirror's strength r becomes min(255, floor(r * this + 0.5))
};

// Something that a ray meets.
struct Sight {
    enum class Kind : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze, object };
    Kind kind = Kind::sky;
    std::size_t side = 0;            // object: the row of its sprite
    Face face = Face::top;           // side, roof, underside
    bool fromInside = false;         // the ray left the block through this face
    bool outsideGrid = false;        // floor
    bool isSloped = false;           // roof, underside
    int map = 0;                     // whose light and fog lie on it
    int turn = 0;                    // quarter turns by which that map lies along the ray
    int portals = 0;                 // that the ray has passed before
    bool reflected = false;          // behind a mirror
    TextureId texture = kNoTexture;  // of an object its sprite
    double faceLight = 1.0;
    bool glow = false;
    double depth = 0.0;   // t
    double leaves = 0.0;  // t at which the ray leaves the eye's water, if that is in some
    double along = 0.0;   // t / d as it was found, so that equal depths come out equal
    double u = 0.0;  // fractions of the texture, 0 to 1; negative ones count from the other end
    double v = 0.0;
    LitFace litFace;    // of a block, the floor in the grid or the ceiling
    Coordinate rise;    // of the texture on a side of what moves
    Coordinate slideU;  // how far textures have gone along a face's axes
    Coordinate slideV;
    int object = -1;          // index into Map::objects
    Colour colour;            // sky, haze: what they show
    bool seeThrough = false;  // what lies behind may show, depending on the texel's alpha
    int mirror =
        0;  // how much of what comes next shows in it, of 255; then it counts as opaque otherwise
    struct Waves {
        int ripples = 0;      // of the mirror, of 255
        double over = 0.0;    // the eye's height over it
        double offset = 0.0;  // rows from the horizon
        int x = 0;            // its point on the map, in 1/256 units
        int y = 0;
        // Where its map lies along the ray
        int placeX = 0;
        int placeY = 0;
        int placeLevels = 0;
    } waves;
};

// What happened to a ray on its way, besides what it met; for asserting coverage.
enum class Note : std::uint8_t {
    facePortal0,  // passed a portal face that turns by so many quarters
    facePortal1,
    facePortal2,
    facePortal3,
    tilePortal0,
    tilePortal1,
    tilePortal2,
    tilePortal3,
    northPortal,  // came in through such a face, by the entry map's names
    eastPortal,
    southPortal,
    westPortal,
    topPortal,
    bottomPortal,
    levelsShifted,
    threePortals,  // passed three or more
    portalWithinMap,
    portalAtOnce,   // at t = 0
    portalInGlass,  // on a block that is see-through
    faceAtLimit,  // the face's own texture is drawn, since the ray has passed as many portals as it
                  // may
    tileAtLimit,
    belowFloor,         // came out below the floor
    outInsideBlock,     // came out within a block, upwards or downwards
    faceAtExit,         // a portal face where the ray comes out, drawn like any other
    faceBehindExit,     // passed a portal face that stands farther on in the exit tile
    tileAtExit,         // a tile portal that does not act on what arrives
    leftThroughPortal,  // out of a block through a portal face
    joinedByPortal,     // two faces left out between which lies a portal
    joinedMover,        // two faces left out between parts of one thing that moves
    joinedKin,     // two faces left out between blocks of one blueprint, one of which has portals
    wholeMover,    // two faces that do not join, between parts of one thing that moves
    wholeSlider,   // two that would not join, between parts of what moves that way
    insideMover,   // went on from one part to the other inside an opaque one
    risenTexture,  // on a side of what moves
    emptyMover,    // went through a tile in which a block is empty at the moment
    floorMirror,
    roofMirror,
    mirrorJoined,  // a mirrored roof that is left out
    mirrorBehindPortal,
    portalBehindMirror,
    mirrorOutside,  // the floor outside the grid
    fromWater,      // the eye is in water
    outOfWater,     // and met something beyond its surface
    waterSky,       // or the sky through it
    waterMirror,    // or a mirror
    noFace,         // a face that water leaves out
    planEntered,    // a block entered through an edge within its tile
    planLeft,       // and left through one
    planMissed,     // a block in a tile that the ray passed beside it
    cutEntered,     // a half entered through its cut
    cutLeft,        // and left through it
    slopeSide,      // a side of a block with slopes
    slopeRoof,      // a sloped face, from outside
    slopeUnder,
    slopeFromInside,
    slopeAboveHorizon,  // a sloped roof met by a rising ray
    slopeBelowHorizon,  // a sloped underside met by a falling one
    movedSlope,         // a slope of what moves
    shiftedSlope,       // along its rise
    cutSlope,           // went on from one part of a slope's block to the next
    slidSide,           // on a side of what moves along it
    slidPlane,          // on a roof or an underside of what moves along x or y
    skyStar,
    skySun,
    skyMoon,
    skyCloud,
    rippledMirror,  // shows the reflection of another row
    rippledStop,    // or of a nearer one than the ripples say, where the mirror ends
    count
};
using Notes = std::bitset<static_cast<std::size_t>(Note::count)>;
const char* nameOf(Note note);

class Tracer {
public:
    Tracer(const World& world, const View& view);

    // The sights through a point of the picture plane, in pixels from its upper left; a pixel's
    // centre is at + 0.5. Front to back: see-through ones and mirrors, and then one that is
    // neither.
    void look(double x, double y, std::vector<Sight>& sights, Notes* notes = nullptr) const;

    // A sight's colour, with the texel's own alpha (255 of a mirror). `depthFactor` is 1, or a
    // little off to ask for the other side of a threshold on t.
    Colour colour(const Sight& sight, double depthFactor = 1.0) const;

    // The level of detail that a sight is shown at, for asserting coverage.
    int level(const Sight& sight, double depthFactor = 1.0) const;

    // Whether its colour is blended between four texels; and whether between texels at opposite
    // borders of the texture, or between holes and others.
    bool isSmooth(const Sight& sight, double depthFactor = 1.0) const;
    bool isBlendedAcrossBorder(const Sight& sight) const;
    bool isBlendedBesideHole(const Sight& sight) const;

    // What has been seen of the maps' baked light, for asserting coverage.
    bool isLit(const Sight& sight) const;
    bool sawLight(bool LightTracer::*what) const;

private:
    class Walk;

    void follow(double x, double y, std::vector<Sight>& sights, Notes& notes) const;
    void ripple(double x, double y, std::vector<Sight>& sights, Notes& notes) const;
    int shiftOf(const Sight::Waves& waves) const;

    LightTracer& lightOf(int map) const;
    // A place along both axes of a face, in 1/65536 of the texture as the map's axes run.
    struct Spot {
        int u;
        int v;
    };
    Colour lit(const Sight& sight, Colour texel, Spot spot) const;
    // The four texels round a point, the nearest first, and their shares of 128 * 128.
    struct Four {
        Colour texels[4];
        int shares[4];
        bool wraps = false;
    };
    Four fourRound(const Sight& sight) const;
    static Colour blended(const Four& four);

    const std::vector<Image>& levelsOf(const Sight& sight) const;

    const World& world_;
    View view_;
    const CellBlueprint* water_ = nullptr;  // that the eye is in
    double surface_ = 0.0;                  // its height
    double distance_;
    double forwardX_;
    double forwardY_;
    std::vector<std::vector<Image>> levels_;                     // of each texture
    std::vector<std::vector<std::vector<Image>>> spriteLevels_;  // of each row of each sprite
    mutable std::vector<std::unique_ptr<LightTracer>> lights_;   // of each map, when asked for
};

}  // namespace slicecast::judge
