// The judge's tracer: a slow, plain statement of what a correct picture is. It follows the ray of one pixel through the blocks in three dimensions, from
// border to border and from height to height, in double precision, and knows nothing of the renderer: it includes `base` and `world` only, and does its own
// sampling, light and fog.
#pragma once

#include "base/colour.h"
#include "base/coordinate.h"
#include "world/world.h"

#include <cstdint>
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
    bool light = true;
    bool fog = true;
};

// Something that a ray meets.
struct Sight {
    enum class Kind : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze, object };
    Kind kind = Kind::sky;
    Face face = Face::top;       // side, roof, underside
    bool fromInside = false;     // the ray left the block through this face
    bool outsideGrid = false;    // floor
    TextureId texture = kNoTexture;  // of an object its sprite
    double faceLight = 1.0;
    bool glow = false;
    double depth = 0.0;          // t
    double u = 0.0;              // fractions of the texture, 0 to 1
    double v = 0.0;
    Colour colour;               // sky: what it shows
    bool seeThrough = false;     // what lies behind may show, depending on the texel's alpha
};

class Tracer {
public:
    Tracer(const World& world, const View& view);

    // The sights through a point of the picture plane, in pixels from its upper left; a pixel's centre is at + 0.5. Front to back: see-through ones and then
    // one that is not.
    void look(double x, double y, std::vector<Sight>& sights) const;

    // A sight's colour, with the texel's own alpha. `depthFactor` is 1, or a little off to ask for the other side of a threshold on t.
    Colour colour(const Sight& sight, double depthFactor = 1.0) const;

    // The level of detail that a sight is shown at, for asserting coverage.
    int level(const Sight& sight, double depthFactor = 1.0) const;

private:
    struct Border;
    struct Meeting;
    struct Ray;

    void lookAtMap(double x, double y, std::vector<Sight>& sights) const;
    void addObjects(double x, double y, std::vector<Sight>& sights) const;
    const Image& imageOf(const Sight& sight, int level) const;
    bool joined(BlueprintId block, int tileX, int tileY, int level) const;
    Sight face(const Ray& ray, const CellBlueprint& block, int level, Face face, int tileX, int tileY, const Meeting& meeting, bool fromInside) const;
    Sight plane(const Ray& ray, Sight::Kind kind, TextureId texture, double light, int tileX, int tileY, const Meeting& meeting) const;
    Sight background(const Ray& ray) const;

    const World& world_;
    const Map& map_;
    View view_;
    double distance_;
    double forwardX_;
    double forwardY_;
    std::vector<std::vector<Image>> levels_;        // of each texture
    std::vector<std::vector<Image>> spriteLevels_;  // of each sprite
};

}  // namespace slicecast::judge
