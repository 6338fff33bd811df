// The painter on spans that are made by hand: the second stage of a slice, alone. Nothing walks.
//
// Pictures are 200 x 200 pixels at 90 degrees, so d is 100 and the horizon is row 100; the eye is
// at (2.5, 2.5), half a unit above the floor. Column 100 looks 1/200 to the right of east.
#include "defined_shade.h"
#include "scenes.h"
#include "slice_stage.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slicecast::known {
namespace {

using What = FilledRows::What;

constexpr int kSliceHeight = 200;
constexpr Pixel kBefore = 0x12345678;
constexpr Colour kHaze = {10, 200, 90, 255};

// Half a unit below the eye, and above it.
constexpr Plane kFloor = {.rise = -32768, .texture = 0};
constexpr Plane kCeiling = {.rise = 32768, .texture = 0};

Texture noise(const char* name, bool seeThrough = false) {
    Random random(7);
    Image image(8, 8);
    for (Pixel& pixel : image.pixels)
        pixel = static_cast<Pixel>(random.next()) | (seeThrough ? 0 : 0xff000000);
    return makeTexture(name, image);
}

World paintedWorld(bool seeThroughFloor = false) {
    World world = emptyWorld(12, 5, 1, noise("noise", seeThroughFloor));
    Map& map = world.maps[0];
    map.haze = kHaze;
    map.light = {.on = true, .intensity = 1.0, .multiplier = 3.0};
    map.fog = {.on = true, .start = 2.0, .end = 30.0};
    return world;
}

class SlicePaint : public testing::Test {
protected:
    explicit SlicePaint(World world = paintedWorld())
        : world_(std::move(world)), stage_(world_, eyeAt(2.5, 2.5, 0.5, 0.0), 200, kSliceHeight) {
        slice_.column = 100;
    }

    // All that a span must say; `column` is the slice's own or what mirrors show.
    Span& add(ColumnSpans& column, What what, int first, int last) {
        Span& span = column.spans.add();
        span = {};
        span.what = what;
        span.first = first;
        span.last = last;
        span.vista = &stage_.ofEye();
        return span;
    }
    Span& add(What what, int first, int last) { return add(slice_.upright, what, first, last); }

    // One texel each row.
    Span& addTexels(What what, int first, const std::vector<Pixel>& texels,
                    std::uint32_t factor = 256, std::uint32_t fog = 0) {
        Span& span = add(what, first, first + static_cast<int>(texels.size()));
        span.column = {.texels = texels.data(), .step = 1, .factor = factor, .fog = fog};
        return span;
    }
    Span& addLayer(What what, int first, const std::vector<Pixel>& texels,
                   std::uint32_t factor = 256, std::uint32_t fog = 0) {
        Span& span = addTexels(what, first, texels, factor, fog);
        span.layer = true;
        ++slice_.upright.layers;
        return span;
    }
    Span& addPlane(What what, int first, int last, const Plane& plane, const TileRange& tiles) {
        Span& span = add(what, first, last);
        const Frame& frame = stage_.frame();
        span.look =
            &span.vista->planeLooks.find(plane, frame.textures[plane.texture], frame.detail);
        span.tiles = tiles;
        return span;
    }

    std::vector<Pixel> painted() { return stage_.paint(slice_, kBefore); }

    // What a row of a plane of texture 0 shows, by the definition.
    Pixel planePixel(int row, const Plane& plane, Lay lay = Lay::opaque, Pixel there = 0) const {
        const double slope = (100.0 - (row + 0.5)) / 100.0;
        const double depth = Coordinate{plane.rise}.value() / slope;
        const double x = 2.5 + depth;
        const double y = 2.5 + depth * 0.005;
        const Texture& texture = world_.textures[0];
        int detail = 0;
        for (double t = 1.0; detail < 3 && depth * 8 > t * 100.0; t *= 2.0) ++detail;
        const TextureLevel& level = texture.levels[static_cast<std::size_t>(detail)];
        const auto texelOf = [&](double v) {
            return static_cast<int>((v - std::floor(v)) * level.size);
        };
        const int u = texelOf(x);
        const int v = plane.southReversed ? level.size - 1 - texelOf(y) : texelOf(y);
        const double bright = std::clamp(3.0 / depth, 0.1, 1.0) * plane.light;
        const double fog = std::clamp((depth - 2.0) / 28.0, 0.0, 1.0);
        const std::size_t texel =
            (static_cast<std::size_t>(u) << level.bits) + static_cast<std::size_t>(v);
        const auto rounded = [](double value) {
            return static_cast<std::uint32_t>(std::floor(value + 0.5));
        };
        return defined(level.texels[texel],
                       {rounded(256 * bright), rounded(255 * fog), toPixel(kHaze)}, lay, there);
    }

    World world_;
    SliceStage stage_;
    SliceSpans slice_;
};

std::vector<Pixel> anyTexels(std::uint64_t seed, int count, bool opaque) {
    Random random(seed);
    std::vector<Pixel> texels(static_cast<std::size_t>(count));
    for (Pixel& texel : texels)
        texel = static_cast<Pixel>(random.next()) | (opaque ? 0xff000000 : 0);
    return texels;
}

Pixel at(const std::vector<Pixel>& pixels, int row) {
    return pixels[static_cast<std::size_t>(row)];
}

TEST_F(SlicePaint, NoSpansFillNothing) {
    EXPECT_EQ(painted(), std::vector<Pixel>(kSliceHeight, kBefore));
    EXPECT_EQ(stage_.report().spansDrawn, 0);
}

TEST_F(SlicePaint, SkyHazeAndASideFillTheirRowsAlone) {
    const std::vector<Pixel> texels = anyTexels(1, 40, true);
    addTexels(What::side, 80, texels, 100, 60);
    add(What::sky, 3, 70);
    add(What::haze, 130, 198);
    const std::vector<Pixel> pixels = painted();
    for (int row = 0; row < kSliceHeight; ++row) {
        const Pixel expected =
            row >= 3 && row < 70 ? toPixel(kMagenta)
            : row >= 80 && row < 120
                ? defined(at(texels, row - 80), {100, 60, toPixel(kHaze)}, Lay::opaque, 0)
            : row >= 130 && row < 198 ? toPixel(kHaze)
                                      : kBefore;
        ASSERT_EQ(at(pixels, row), expected) << row;
    }
    EXPECT_EQ(stage_.report().spansDrawn, 3);
    EXPECT_EQ(stage_.report().rowsFilled, 40 + 67 + 68);
}

// A column of four texels, from the middle of the first on, a quarter of a texel each row.
TEST_F(SlicePaint, ASideStretchesItsTexels) {
    const std::vector<Pixel> texels = anyTexels(2, 4, true);
    constexpr int kShift = kTexturePositionBits - 2;
    Span& side = add(What::side, 50, 64);
    side.column = {.texels = texels.data(),
                   .start = std::uint64_t{1} << (kShift - 1),
                   .step = std::uint64_t{1} << (kShift - 2),
                   .shift = kShift};
    const std::vector<Pixel> pixels = painted();
    for (int row = 50; row < 64; ++row) ASSERT_EQ(at(pixels, row), at(texels, (row - 48) / 4));
}

// Spans stand nearest first: the later one is farther, and laid over what is there first.
TEST_F(SlicePaint, LayersAreBlendedFromTheBack) {
    const std::vector<Pixel> near = anyTexels(3, 20, false);
    const std::vector<Pixel> far = anyTexels(4, 20, false);
    const std::vector<Pixel> behind = anyTexels(5, 40, true);
    addLayer(What::object, 100, near, 256, 10);
    addTexels(What::side, 90, behind);
    addLayer(What::side, 110, far, 77, 200);
    const std::vector<Pixel> pixels = painted();
    for (int row = 90; row < 130; ++row) {
        Pixel expected = at(behind, row - 90);
        if (row >= 110)
            expected = defined(at(far, row - 110), {77, 200, toPixel(kHaze)}, Lay::over, expected);
        if (row >= 100 && row < 120)
            expected = defined(at(near, row - 100), {256, 10, toPixel(kHaze)}, Lay::over, expected);
        ASSERT_EQ(at(pixels, row), expected) << row;
    }
    EXPECT_EQ(stage_.report().layers, 2);
}

// Depths from 0.5 to 100: light, fog and all levels of detail.
TEST_F(SlicePaint, AFloorIsDrawnRowByRow) {
    Plane floor = kFloor;
    floor.light = 0.75;
    addPlane(What::floor, 100, 200, floor, {2, 2, 12, 2, true});
    const std::vector<Pixel> pixels = painted();
    for (int row = 0; row < kSliceHeight; ++row)
        ASSERT_EQ(at(pixels, row), row < 100 ? kBefore : planePixel(row, floor)) << row;
}

TEST_F(SlicePaint, ACeilingIsReversed) {
    Plane ceiling = kCeiling;
    ceiling.southReversed = true;
    addPlane(What::ceiling, 0, 95, ceiling, {2, 2, 12, 2, false});
    const std::vector<Pixel> pixels = painted();
    for (int row = 0; row < 95; ++row) ASSERT_EQ(at(pixels, row), planePixel(row, ceiling)) << row;
}

// The floor at depths 1.5 and 3.5 is at 133.33 and 114.29, the ceiling at 66.67 and 85.71. Rows of
// one plane that follow each other towards the horizon are filled at once, whatever stands between.
TEST_F(SlicePaint, RunsOfAPlaneAreFilledAtOnce) {
    addPlane(What::floor, 133, 200, kFloor, {2, 2, 3, 2, false});
    addPlane(What::ceiling, 0, 67, kCeiling, {2, 2, 3, 2, false});
    add(What::haze, 95, 100);
    addPlane(What::floor, 114, 133, kFloor, {4, 2, 5, 2, false});
    addPlane(What::ceiling, 67, 86, kCeiling, {4, 2, 5, 2, false});
    addPlane(What::floor, 100, 114, kFloor, {6, 2, 12, 2, true});
    const std::vector<Pixel> pixels = painted();
    for (int row = 0; row < 86; ++row) ASSERT_EQ(at(pixels, row), planePixel(row, kCeiling)) << row;
    for (int row = 100; row < 200; ++row)
        ASSERT_EQ(at(pixels, row), planePixel(row, kFloor)) << row;
    EXPECT_EQ(stage_.report().spansDrawn, 3);
}

TEST_F(SlicePaint, RunsEndWhereThePlaneChanges) {
    addPlane(What::floor, 133, 200, kFloor, {2, 2, 3, 2, false});
    Plane dark = kFloor;
    dark.light = 0.25;
    addPlane(What::floor, 114, 133, dark, {4, 2, 5, 2, false});
    addPlane(What::floor, 100, 114, dark, {6, 2, 12, 2, true}).part = 1;
    const std::vector<Pixel> pixels = painted();
    for (int row = 100; row < 133; ++row) ASSERT_EQ(at(pixels, row), planePixel(row, dark)) << row;
    EXPECT_EQ(stage_.report().spansDrawn, 3) << "of another light, then of another walk";
    // A gap between rows ends a run too.
    slice_.upright.clear();
    addPlane(What::floor, 150, 200, kFloor, {2, 2, 3, 2, false});
    addPlane(What::floor, 114, 133, kFloor, {4, 2, 5, 2, false});
    EXPECT_EQ(at(painted(), 140), kBefore);
    EXPECT_EQ(stage_.report().spansDrawn, 5);
}

// Row 133 sees (3.99, 2.51), a trifle before tile 4, and row 119 (5.06, 2.51), behind it. If the
// walk says that they are in tile 4, their texels are the first and the last of that.
TEST_F(SlicePaint, TexelsAreClampedToTheirTiles) {
    addPlane(What::floor, 119, 134, kFloor, {4, 2, 4, 2, false});
    const std::vector<Pixel> pixels = painted();
    const auto texelAt = [&](std::size_t u) {
        return world_.textures[0].levels[0].texels[(u << 3) + 4];
    };
    EXPECT_EQ(at(pixels, 133), defined(texelAt(0), {256, 0, 0}, Lay::opaque, 0));
    EXPECT_EQ(at(pixels, 119), defined(texelAt(7), {256, 5, toPixel(kHaze)}, Lay::opaque, 0));
    EXPECT_NE(at(pixels, 133), planePixel(133, kFloor));
    EXPECT_NE(at(pixels, 119), planePixel(119, kFloor));
    for (int row = 120; row < 133; ++row)
        ASSERT_EQ(at(pixels, row), planePixel(row, kFloor)) << row;
}

// Row r of what mirrors show stands in row 199 - r of the picture.
TEST_F(SlicePaint, ReflectionsAreBlendedUpsideDown) {
    const std::vector<Pixel> floor = anyTexels(6, 60, true);
    const std::vector<Pixel> shown = anyTexels(7, 50, true);
    addTexels(What::side, 140, floor);
    slice_.upright.mirrors.push_back({.first = 150, .last = 170, .strength = 77});
    slice_.upright.mirrors.push_back({.first = 180, .last = 190, .strength = 255});
    Span& span = add(slice_.reflected, What::side, 5, 55);
    span.column = {.texels = shown.data(), .step = 1};
    const std::vector<Pixel> pixels = painted();
    for (int row = 140; row < 200; ++row) {
        const int strength = row >= 150 && row < 170 ? 77 : row >= 180 && row < 190 ? 255 : 0;
        const Pixel expected = strength == 0 ? at(floor, row - 140)
                                             : over(at(shown, 199 - row - 5), at(floor, row - 140),
                                                    static_cast<std::uint32_t>(strength));
        ASSERT_EQ(at(pixels, row), expected) << row;
    }
    EXPECT_EQ(at(pixels, 139), kBefore);
}

// Layers of the reflection belong to it; those of the slice lie over all.
TEST_F(SlicePaint, LayersLieOverReflections) {
    const std::vector<Pixel> floor = anyTexels(8, 10, true);
    const std::vector<Pixel> glass = anyTexels(9, 10, false);
    addTexels(What::side, 150, floor);
    addLayer(What::side, 150, glass);
    slice_.upright.mirrors.push_back({.first = 150, .last = 160, .strength = 100});
    add(slice_.reflected, What::sky, 40, 50);
    const std::vector<Pixel> pixels = painted();
    for (int row = 150; row < 160; ++row) {
        const Pixel mirrored = over(toPixel(kMagenta), at(floor, row - 150), 100);
        ASSERT_EQ(at(pixels, row), defined(at(glass, row - 150), {256, 0, 0}, Lay::over, mirrored))
            << row;
    }
}

class SlicePaintSeeThrough : public SlicePaint {
protected:
    SlicePaintSeeThrough() : SlicePaint(paintedWorld(true)) {}
};

// Below a floor there is haze; a mirror's texels count as opaque.
TEST_F(SlicePaintSeeThrough, FloorsShowHaze) {
    addPlane(What::floor, 120, 200, kFloor, {2, 2, 12, 2, true});
    Plane mirror = kFloor;
    mirror.mirror = true;
    addPlane(What::floor, 105, 120, mirror, {2, 2, 12, 2, true});
    const std::vector<Pixel> pixels = painted();
    for (int row = 120; row < 200; ++row)
        ASSERT_EQ(at(pixels, row), planePixel(row, kFloor, Lay::over, toPixel(kHaze))) << row;
    for (int row = 105; row < 120; ++row)
        ASSERT_EQ(at(pixels, row), planePixel(row, mirror)) << row;
}

TEST_F(SlicePaintSeeThrough, PlanesAsLayers) {
    Span& roof = addPlane(What::roof, 120, 200, kFloor, {2, 2, 12, 2, true});
    roof.layer = true;
    slice_.upright.layers = 1;
    add(What::sky, 0, 160);
    const std::vector<Pixel> pixels = painted();
    for (int row = 0; row < kSliceHeight; ++row) {
        const Pixel there = row < 160 ? toPixel(kMagenta) : kBefore;
        ASSERT_EQ(at(pixels, row), row < 120 ? there : planePixel(row, kFloor, Lay::over, there))
            << row;
    }
}

// The eye stands in water, 0.25 below its surface.
World floodedWorld() {
    World world = paintedWorld();
    const BlueprintId water = addBlock(world, kNoTexture, {}, toCoordinate(0.75));
    world.blueprints[water].isWater = true;
    world.blueprints[water].waterColour = kHaze;
    world.blueprints[water].waterSight = 8.0;
    world.maps[0].setCell(2, 2, 0, water);
    markSeeThrough(world);
    return world;
}

class SlicePaintInWater : public SlicePaint {
protected:
    SlicePaintInWater() : SlicePaint(floodedWorld()) {}

    // Of a ray that goes on for `depth` units at least: it leaves the water after 0.25 / slope.
    static std::uint32_t fogOf(int row, double depth) {
        const double slope = (100.0 - (row + 0.5)) / 100.0;
        const double t = slope > 0.0 ? std::min(depth, 0.25 / slope) : depth;
        return static_cast<std::uint32_t>(255 * std::min(1.0, t / 8.0) + 0.5);
    }
};

TEST_F(SlicePaintInWater, FogEndsAtTheSurface) {
    const std::vector<Pixel> texels = anyTexels(10, 100, true);
    addTexels(What::side, 60, texels, 256, fogOf(150, 3.0));
    add(What::sky, 0, 60);
    const std::vector<Pixel> pixels = painted();
    for (int row = 0; row < 160; ++row) {
        const Pixel texel = row < 60 ? toPixel(kMagenta) : at(texels, row - 60);
        const std::uint32_t fog = fogOf(row, row < 60 ? 1e9 : 3.0);
        ASSERT_EQ(at(pixels, row), defined(texel, {256, fog, toPixel(kHaze)}, Lay::opaque, 0))
            << row;
    }
}

// What is seen in a mirror under water knows no surface.
TEST_F(SlicePaintInWater, ReflectionsIgnoreTheSurface) {
    const std::vector<Pixel> texels = anyTexels(11, 20, true);
    addTexels(What::side, 150, texels);
    slice_.upright.mirrors.push_back({.first = 150, .last = 170, .strength = 255});
    add(slice_.reflected, What::side, 30, 50).column = {
        .texels = texels.data(), .step = 1, .factor = 256, .fog = 128};
    const std::vector<Pixel> pixels = painted();
    for (int row = 150; row < 170; ++row) {
        ASSERT_EQ(at(pixels, row),
                  defined(at(texels, 169 - row), {256, 128, toPixel(kHaze)}, Lay::opaque, 0));
    }
}

}  // namespace
}  // namespace slicecast::known
