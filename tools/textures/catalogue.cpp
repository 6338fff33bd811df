#include "catalogue.h"

#include "banners.h"
#include "brickwork.h"
#include "carving.h"
#include "foliage.h"
#include "furnishings.h"
#include "ground.h"
#include "lettering.h"
#include "metalwork.h"
#include "openings.h"
#include "plaster.h"
#include "roofs.h"
#include "skies.h"
#include "stonework.h"
#include "tiling.h"
#include "woodwork.h"

namespace slicecast::textures {

const std::vector<Entry>& catalogue() {
    static const std::vector<Entry> entries = {
        {"brick", Use::Wall, paintBrick},
        {"brick-weathered", Use::Wall, paintBrickWeathered},
        {"brick-mossy", Use::Wall, paintBrickMossy},
        {"stone-blocks", Use::Wall, paintStoneBlocks},
        {"stone-blocks-worn", Use::Wall, paintStoneBlocksWorn},
        {"stone-blocks-dark", Use::Wall, paintStoneBlocksDark},
        {"stone-rubble", Use::Wall, paintStoneRubble},
        {"sandstone", Use::Wall, paintSandstone},
        {"rock", Use::Wall, paintRock},
        {"plaster-white", Use::Wall, paintPlasterWhite},
        {"plaster-warm", Use::Wall, paintPlasterWarm},
        {"plaster-broken", Use::Wall, paintPlasterBroken, "plaster-warm"},
        {"timber-frame", Use::Wall, paintTimberFrame},
        {"timber-frame-brace", Use::Wall, paintTimberFrameBrace},
        {"planks-wall", Use::Wall, paintPlanksWall},
        {"crate", Use::Wall, paintCrate},
        {"metal-plates", Use::Wall, paintMetalPlates},
        {"metal-rusty", Use::Wall, paintMetalRusty},
        {"earth", Use::Wall, paintEarth},
        {"turf", Use::Wall, paintTurf, "", false},
        {"bark", Use::Wall, paintBark},
        {"hedge", Use::Wall, paintHedge},
        {"ivy", Use::Wall, paintIvy},
        {"door", Use::Wall, paintDoor, "stone-blocks", false},
        {"window-brick", Use::Wall, paintWindowBrick, "brick"},
        {"window-lit", Use::Wall, paintWindowLit, "brick"},
        {"window-timber", Use::Wall, paintWindowTimber, "timber-frame"},
        {"bookshelf", Use::Wall, paintBookshelf},
        {"barrel", Use::Wall, paintBarrel},
        {"banner", Use::Wall, paintBanner, "stone-blocks"},
        {"banner-sea", Use::Wall, paintBannerSea, "stone-blocks"},
        {"frieze", Use::Wall, paintFrieze},
        {"grass", Use::Floor, paintGrass},
        {"grass-meadow", Use::Floor, paintGrassMeadow},
        {"moss", Use::Floor, paintMoss},
        {"path", Use::Floor, paintPath},
        {"sand", Use::Floor, paintSand},
        {"cobbles", Use::Floor, paintCobbles},
        {"flagstones", Use::Floor, paintFlagstones},
        {"water", Use::Floor, paintWater},
        {"marble-checker", Use::Floor, paintMarbleChecker},
        {"terracotta", Use::Floor, paintTerracotta},
        {"mosaic", Use::Floor, paintMosaic},
        {"metal-tread", Use::Floor, paintMetalTread},
        {"planks-floor", Use::Floor, paintPlanksFloor},
        {"roof-clay", Use::Roof, paintRoofClay},
        {"roof-slate", Use::Roof, paintRoofSlate},
        {"roof-thatch", Use::Roof, paintRoofThatch},
        {"ceiling-coffers", Use::Ceiling, paintCeilingCoffers},
        {"ceiling-beams", Use::Ceiling, paintCeilingBeams},
        {"sky-day", Use::Sky, paintSkyDay},
        {"sky-dusk", Use::Sky, paintSkyDusk},
        {"sky-night", Use::Sky, paintSkyNight},
        {"lettering", Use::Test, paintLettering},
    };
    return entries;
}

const char* nameOf(Use use) {
    switch (use) {
        case Use::Wall:
            return "wall";
        case Use::Floor:
            return "floor";
        case Use::Roof:
            return "roof";
        case Use::Ceiling:
            return "ceiling";
        case Use::Sky:
            return "sky";
        case Use::Test:
            return "test";
    }
    return "";
}

}  // namespace slicecast::textures
