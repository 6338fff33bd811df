// The spans of a slice as text, one a line in the order in which they stand, so that what differs
// can be read:
//
//     side 86-114 west of 6,2,0: wall detail 2, u 8, v 0-15, depth 3.5, light 256, fog 0
//     layer roof 80-86 of 5,2,0: glass at 0.5, light 1
//     floor 114-200 over 2,2 to 12,2 and on: floor at -0.5, light 1
//     sky 0-86
//
// Tiles are x,y, cells x,y,level; heights are above the viewpoint, in units. After the spans come
// the portals and mirrors, then what shows in mirrors.
#pragma once

#include "render/spans/slice_spans.h"
#include "world/world.h"

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace slicecast::known {

class SpanText {
public:
    explicit SpanText(const World& world) : world_(world) {}

    std::string of(const SliceSpans& slice) {
        tell(slice.upright, "");
        tell(slice.reflected, "reflected ");
        return text_.str();
    }

private:
    using What = FilledRows::What;

    void tell(const ColumnSpans& column, const char* before) {
        for (const Span& span : column.spans) {
            text_ << before;
            tell(span);
            text_ << '\n';
        }
        for (const PortalSpan& span : column.portals) {
            text_ << before << "portal " << span.portal << ' ' << span.first << '-' << span.last
                  << " at depth " << span.depth;
            tellPassed(span.portals);
            text_ << '\n';
        }
        for (const MirrorSpan& span : column.mirrors)
            text_ << before << "mirror " << span.first << '-' << span.last << " at "
                  << Coordinate{span.rise}.value() << ", strength " << span.strength << '\n';
    }

    void tell(const Span& span) {
        constexpr std::array kNames = {"side",    "roof", "underside", "floor",
                                       "ceiling", "sky",  "haze",      "object"};
        if (span.layer) text_ << "layer ";
        text_ << kNames[static_cast<std::size_t>(span.what)] << ' ' << span.first << '-'
              << span.last;
        switch (span.what) {
            case What::side:
                text_ << ' ' << kFaceNames[static_cast<std::size_t>(span.face)];
                tellCell(span);
                tellSide(span);
                break;
            case What::object:
                text_ << " of " << span.object;
                tellObject(span);
                break;
            case What::roof:
            case What::underside:
                tellCell(span);
                tellPlane(span.look->plane);
                break;
            case What::floor:
            case What::ceiling:
                tellTiles(span.tiles);
                tellPlane(span.look->plane);
                break;
            case What::sky:
            case What::haze:
                break;
        }
        if (span.vista->viewpoint.map != 0) text_ << ", map " << span.vista->viewpoint.map;
        tellPassed(span.portals);
    }

    void tellPassed(int portals) {
        if (portals > 0) text_ << ", behind " << portals;
    }

    void tellCell(const Span& span) {
        text_ << " of " << span.tiles.fromX << ',' << span.tiles.fromY << ',' << span.level;
    }

    void tellTiles(const TileRange& tiles) {
        text_ << " over " << tiles.fromX << ',' << tiles.fromY << " to " << tiles.toX << ','
              << tiles.toY << (tiles.endless ? " and on" : "");
    }

    void tellPlane(const Plane& plane) {
        text_ << ": " << world_.textures[plane.texture].name << " at "
              << Coordinate{plane.rise}.value() << ", light " << plane.light
              << (plane.glow ? ", glows" : "") << (plane.mirror ? ", mirror" : "")
              << (plane.southReversed ? ", from below" : "");
    }

    void tellSide(const Span& span) {
        const Texture& texture = world_.textures[span.image];
        const TextureLevel& level = texture.levelsOf(
            texture.frameAt(world_.steps))[static_cast<std::size_t>(span.column.detail)];
        tellTexels(span, texture.name, level.texels, level.size);
    }

    void tellObject(const Span& span) {
        const Sprite& sprite = world_.sprites[span.image];
        const SpriteLevel& level =
            sprite.levelsAt(world_.steps)[static_cast<std::size_t>(span.column.detail)];
        tellTexels(span, sprite.name, level.texels, level.height);
    }

    // Which column of texels, and the first and the last of it that are seen.
    void tellTexels(const Span& span, const std::string& name, const std::vector<Pixel>& texels,
                    int height) {
        const TexelColumn& column = span.column;
        const auto steps = static_cast<std::uint64_t>(span.last - span.first - 1);
        text_ << ": " << name << " detail " << column.detail << ", u "
              << (column.texels - texels.data()) / height << ", v "
              << (column.start >> column.shift) << '-'
              << ((column.start + steps * column.step) >> column.shift) << ", depth "
              << column.depth << ", light " << column.factor << ", fog " << column.fog;
    }

    const World& world_;
    std::ostringstream text_;
};

}  // namespace slicecast::known
