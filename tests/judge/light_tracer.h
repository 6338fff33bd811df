// Baked light as the definition says it, slowly: every block near a light ray is asked whether the
// ray meets it, in exact fractions. It knows nothing of the renderer.
#pragma once

#include "world/world.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace slicecast::judge {

using Rgb = std::array<int, 3>;

// The face of a tile or cell. `kind` is a Face's number, or one of the three after them.
struct LitFace {
    static constexpr int kFloor = 6;
    static constexpr int kCeilingBelow = 7;
    static constexpr int kCeilingAbove = 8;
    int x = 0;
    int y = 0;
    int level = 0;
    int kind = 0;

    friend auto operator<=>(const LitFace&, const LitFace&) = default;
};

class LightTracer {
public:
    // Both must outlive the tracer.
    LightTracer(const World& world, const Map& map);

    // The nodes [square sideways][square upwards][node sideways][node upwards] of a face, 0 to 255.
    using Nodes = std::array<Rgb, 16>;
    const Nodes& nodesOf(const LitFace& face);
    static std::size_t nodeIndex(int squareA, int squareB, int nodeA, int nodeB) {
        return static_cast<std::size_t>(squareA * 8 + squareB * 4 + nodeA * 2 + nodeB);
    }

    bool hasFace(const LitFace& face) const { return areaOf(face).has_value(); }
    // Whether it is a slope, or the cut of a half.
    bool isRising(const LitFace& face) const { return isRising(areaOf(face)->plane); }

    // L of a place of the face, 1/65536 of its tile along both of its axes.
    Rgb lightAt(const LitFace& face, int placeA, int placeB);
    Rgb lightOutside();
    Rgb lightOf(const Object& object);

    // For asserting coverage.
    bool sawTint = false;
    bool sawPartlyLinked = false;
    bool sawOddSquare = false;
    bool sawSlope = false;       // a texel on one was lit
    bool sawCut = false;         // on the cut of a half
    bool sawGoOn = false;        // one of them goes on in the next tile
    bool sawClimb = false;       // a slope in another level
    bool sawBelowFloor = false;  // a part of a slope is below the floor
    bool sawMoverApart = false;  // between parts of a mover, side by side, that do not join
    bool sawHiddenFace = false;  // a face without a texture, or between parts of a mover, counts

private:
    using Vector = std::array<std::int64_t, 3>;  // x, y, z, 1/65536 units
    // Points p with n * p + c > 0 are on its outer side, where n * p + c is 65536 times their
    // distance along the axis on which n is +-65536.
    struct Plane {
        Vector n{};
        std::int64_t c = 0;
        int face = 0;

        std::int64_t at(const Vector& p) const {
            return n[0] * p[0] + n[1] * p[1] + n[2] * p[2] + c;
        }
        friend bool operator==(const Plane&, const Plane&) = default;
    };
    // A block: what is behind all of its planes. Between `low` and `high` there is a box around it.
    struct Solid {
        Vector low;
        Vector high;
        std::vector<Plane> planes;
        BlueprintId id = kEmptyCell;
    };
    struct Area {
        Plane plane;
        int axis = 0;  // on which its n is +-65536
        int a = 0;     // its axes
        int b = 1;
        std::array<std::int64_t, 2> low{};  // along a and b
        std::array<std::int64_t, 2> high{};
        std::array<std::int64_t, 2> tile{};  // where the tile or cell begins

        int sign() const { return plane.n[static_cast<std::size_t>(axis)] > 0 ? 1 : -1; }
        Vector inFront(std::int64_t atA, std::int64_t atB, std::int64_t distance) const;
    };
    struct Sample {
        bool counts = false;
        Vector at{};
        Rgb light{};
    };

    std::optional<Solid> solidAt(int x, int y, int level) const;
    std::optional<Area> areaOf(const LitFace& face) const;
    static bool isRising(const Plane& plane);
    static bool isBehind(const Plane& plane, const Vector& point);
    bool isHidden(const LitFace& face) const;
    bool isInOpaque(const Vector& point) const;
    Rgb through(const Vector& from, const Vector& way, bool endless);
    Rgb tintOf(TextureId texture);
    // Without an area (an object's sample) cos is 1.
    Rgb lightOfSample(const Vector& at, const Area* area, int turns);
    Sample sampleOf(const LitFace& face, int column, int row);
    // The lamps that light what lies in the cube of a point.
    struct HungLamp;
    const std::vector<const HungLamp*>& lampsNear(const Vector& at);

    const World& world_;
    const Map& map_;
    Vector sun_{};
    struct HungLamp {
        Lamp lamp;
        std::optional<Plane> plane;  // of the face that it hangs before
    };
    std::vector<HungLamp> lamps_;
    std::map<Vector, std::vector<const HungLamp*>> nearLamps_;  // by cube
    std::map<TextureId, Rgb> tints_;
    std::map<std::tuple<LitFace, int, int>, Sample> samples_;
    std::map<LitFace, Nodes> nodes_;
    std::map<const Object*, Rgb> objects_;
};

}  // namespace slicecast::judge
