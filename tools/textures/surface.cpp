#include "surface.h"

#include <algorithm>

namespace slicecast::textures {

namespace {

double slopeToLight(const Surface& surface, int x, int y) {
    const double rise = surface.at(x + 1, y).height - surface.at(x - 1, y).height;
    const double fall = surface.at(x, y + 1).height - surface.at(x, y - 1).height;
    return 0.5 * (rise + fall);
}

bool inShadow(const Surface& surface, int x, int y, const Lighting& lighting) {
    const double own = surface.at(x, y).height;
    for (int reach = 1; reach <= lighting.shadowReach; ++reach) {
        if (surface.at(x - reach, y - reach).height - own > reach * lighting.shadowSlope) {
            return true;
        }
    }
    return false;
}

double hollow(const Surface& surface, int x, int y) {
    double sum = 0.0;
    for (int dy = -2; dy <= 2; dy += 2) {
        for (int dx = -2; dx <= 2; dx += 2) {
            sum += surface.at(x + dx, y + dy).height;
        }
    }
    return std::max(0.0, sum / 9.0 - surface.at(x, y).height);
}

}  // namespace

Surface Surface::empty(int w, int h) {
    Surface surface(w, h);
    for (Texel& texel : surface.texels_) {
        texel.alpha = 0;
    }
    return surface;
}

Picture lit(const Surface& surface, const Lighting& lighting) {
    Picture picture(surface.width, surface.height);
    everyTexelIn(0, 0, surface.width, surface.height, [&](int x, int y) {
        const Texel& texel = surface.at(x, y);
        double tone = texel.tone;
        tone += std::clamp(lighting.gain * slopeToLight(surface, x, y), -lighting.darkest,
                           lighting.lightest);
        tone -= inShadow(surface, x, y, lighting) ? lighting.shadowDepth : 0.0;
        tone -= lighting.hollowDepth * hollow(surface, x, y);
        picture.at(x, y) = colourAt(*texel.ramp, tone);
        picture.at(x, y).a = texel.alpha;
    });
    return picture;
}

Picture litOver(const Surface& wall, const Lighting& wallLighting, const Surface& surface,
                const Lighting& lighting) {
    const Picture bare = lit(wall, wallLighting);
    Picture picture = lit(surface, lighting);
    const auto changedNear = [&](int x, int y) {
        const int reach = std::max(2, lighting.shadowReach);
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                if (!(surface.at(x + dx, y + dy) == wall.at(x + dx, y + dy))) {
                    return true;
                }
            }
        }
        return false;
    };
    everyTexelIn(0, 0, surface.width, surface.height, [&](int x, int y) {
        if (!changedNear(x, y)) {
            picture.at(x, y) = bare.at(x, y);
        }
    });
    return picture;
}

}  // namespace slicecast::textures
