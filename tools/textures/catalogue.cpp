#include "catalogue.h"

#include "brickwork.h"
#include "stonework.h"

namespace slicecast::textures {

const std::vector<Entry>& catalogue() {
    static const std::vector<Entry> entries = {
        {"brick", Use::wall, paintBrick},
        {"brick-weathered", Use::wall, paintBrickWeathered},
        {"brick-mossy", Use::wall, paintBrickMossy},
        {"stone-blocks", Use::wall, paintStoneBlocks},
        {"stone-blocks-worn", Use::wall, paintStoneBlocksWorn},
        {"stone-blocks-dark", Use::wall, paintStoneBlocksDark},
        {"stone-rubble", Use::wall, paintStoneRubble},
        {"sandstone", Use::wall, paintSandstone},
        {"rock", Use::wall, paintRock},
    };
    return entries;
}

const char* nameOf(Use use) {
    switch (use) {
        case Use::wall: return "wall";
        case Use::floor: return "floor";
        case Use::roof: return "roof";
        case Use::ceiling: return "ceiling";
        case Use::sky: return "sky";
        case Use::test: return "test";
    }
    return "";
}

}  // namespace slicecast::textures
