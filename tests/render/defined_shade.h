// Light, fog and see-through texels as they are defined, channel by channel.
#pragma once

#include "render/pixels/column_fill.h"

namespace slicecast::known {

inline int lit(int c, std::uint32_t factor) {
    return (c * static_cast<int>(factor) + 128) >> 8;
}

inline int mixed(int colour, int there, std::uint32_t share) {
    const int w = static_cast<int>(share);
    return (colour * w + there * (255 - w) + 127) / 255;
}

template <typename Channel>
Pixel byChannel(Pixel a, Pixel b, Channel&& channel) {
    const Colour x = toColour(a);
    const Colour y = toColour(b);
    const auto byte = [&](int p, int q) { return static_cast<std::uint8_t>(channel(p, q)); };
    return toPixel({byte(x.r, y.r), byte(x.g, y.g), byte(x.b, y.b), 255});
}

inline Pixel over(Pixel colour, Pixel there, std::uint32_t alpha) {
    return byChannel(colour, there, [&](int c, int t) { return mixed(c, t, alpha); });
}

struct DefinedLight {
    std::uint32_t factor;
    std::uint32_t fog;
    Pixel haze;
};

inline Pixel defined(Pixel texel, const DefinedLight& light, Lay lay, Pixel there) {
    const Pixel colour = byChannel(
        texel, light.haze, [&](int c, int h) { return mixed(h, lit(c, light.factor), light.fog); });
    return lay == Lay::opaque ? colour : over(colour, there, texel >> 24);
}

}  // namespace slicecast::known
