// Draws the renderer's picture of a scene that the judge made.
#pragma once

#include "base/image.h"
#include "random_scene.h"
#include "render/renderer.h"

namespace slicecast::judge {

inline RenderOptions optionsOf(const View& view) {
    return {.fovDegrees = view.fovDegrees,
            .detail = view.detail,
            .detailThreshold = view.detailThreshold,
            .smooth = view.smooth,
            .textures = view.textures,
            .light = view.light,
            .fog = view.fog,
            .baked = view.baked,
            .mirrors = view.mirrors};
}

inline Eye eyeOf(const View& view) {
    return {.map = view.map,
            .x = view.x,
            .y = view.y,
            .z = view.z,
            .headingDegrees = view.headingDegrees,
            .look = view.look};
}

// Empty if the renderer refuses.
inline Image draw(Renderer& renderer, const World& world, const View& view) {
    Image image(view.width, view.height);
    const Picture picture{image.pixels.data(), view.width, view.height, view.width};
    return renderer.draw(world, eyeOf(view), optionsOf(view), picture) ? image : Image{};
}

}  // namespace slicecast::judge
