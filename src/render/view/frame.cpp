#include "render/view/frame.h"

#include <algorithm>

namespace slicecast {
namespace {

bool isInvisible(const TextureLevel& level) {
    for (int u = 0; u < level.size; ++u) {
        const TexelRun& run = *level.runs.of(u);
        if (run.coverage != Coverage::hole || run.end != level.size) return false;
    }
    return true;
}

bool hasRipples(const World& world) {
    return std::any_of(world.maps.begin(), world.maps.end(),
                       [](const Map& map) { return map.floor.ripples > 0; }) ||
           std::any_of(world.blueprints.begin(), world.blueprints.end(),
                       [](const CellBlueprint& blueprint) {
                           return blueprint.face(Face::top).ripples > 0;
                       });
}

}  // namespace

Frame::Frame(const World& w, const Eye& e, const RenderOptions& options, int width, int height,
             FrameMemory& memory)
    : world(&w),
      mirrors(options.mirrors),
      textures(memory.textures),
      lit(memory.lit),
      vistas(memory.vistas),
      ripples(memory.ripples) {
    memory.lit.beginFrame(w, options);
    vistas.beginFrame(w, e, options, memory.lit, width, height);
    detail = Detail(options, vistas.projection().distance);
    rippleRows = hasRipples(w) ? mostRippleRows(height) : 0;
    textures.resize(w.textures.size());
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const Texture& texture = w.textures[i];
        const SharedVector<TextureLevel>& levels = texture.levelsOf(texture.frameAt(w.steps));
        textures[i] = {levels.data(), texture.size(), static_cast<int>(levels.size()) - 1,
                       texture.seeThrough, texture.seeThrough && isInvisible(levels[0])};
    }
}

}  // namespace slicecast
