#include "catalogue.h"

#include "animals.h"
#include "arch.h"
#include "banners.h"
#include "brickwork.h"
#include "carving.h"
#include "cutout.h"
#include "figures.h"
#include "foliage.h"
#include "fountain.h"
#include "furnishings.h"
#include "gates.h"
#include "glazing.h"
#include "glow.h"
#include "ground.h"
#include "keepsakes.h"
#include "lake.h"
#include "lettering.h"
#include "liquids.h"
#include "loops.h"
#include "metalwork.h"
#include "openings.h"
#include "palace.h"
#include "palace_windows.h"
#include "plaster.h"
#include "railings.h"
#include "roofs.h"
#include "signs.h"
#include "skies.h"
#include "statue.h"
#include "stonework.h"
#include "street.h"
#include "tiling.h"
#include "trees.h"
#include "walker.h"
#include "woodwork.h"

namespace slicecast::textures {

namespace {

// One that people stand close to.
Entry fine(const char* name, Use use, Picture (*paint)()) {
    return {.name = name, .use = use, .paint = paint, .side = kFineSide};
}

std::vector<Entry> opaqueTextures() {
    return {
        {"brick", Use::Wall, paintBrick},
        {"brick-weathered", Use::Wall, paintBrickWeathered},
        {"brick-mossy", Use::Wall, paintBrickMossy},
        {"stone-blocks", Use::Wall, paintStoneBlocks},
        {"stone-blocks-worn", Use::Wall, paintStoneBlocksWorn},
        fine("stone-blocks-dark", Use::Wall, paintStoneBlocksDark),
        fine("stone-rubble", Use::Wall, paintStoneRubble),
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
        {"window-timber-lit", Use::Wall, paintWindowTimberLit, "timber-frame"},
        {"painted-window-foot", Use::Wall, paintPaintedWindowFoot, "plaster-white", false},
        {"painted-window-head", Use::Wall, paintPaintedWindowHead, "plaster-white", false},
        {"bookshelf", Use::Wall, paintBookshelf},
        {"barrel", Use::Wall, paintBarrel},
        {"banner", Use::Wall, paintBanner, "stone-blocks"},
        {"banner-sea", Use::Wall, paintBannerSea, "stone-blocks"},
        {"frieze", Use::Wall, paintFrieze},
        {"carved-jamb", Use::Wall, paintCarvedJamb},
        {"sign-climb", Use::Wall, paintSignClimb, "stone-blocks"},
        {"sign-court", Use::Wall, paintSignCourt, "stone-blocks"},
        {"sign-deep", Use::Wall, paintSignDeep, "stone-blocks"},
        {"sign-inn", Use::Wall, paintSignInn, "stone-blocks"},
        {"sign-lane", Use::Wall, paintSignLane, "stone-blocks"},
        {"sign-moor", Use::Wall, paintSignMoor, "stone-blocks"},
        {"sign-night", Use::Wall, paintSignNight, "stone-blocks"},
        {"sign-round", Use::Wall, paintSignRound, "stone-blocks"},
        {"sign-shore", Use::Wall, paintSignShore, "stone-blocks"},
        {"grass", Use::Floor, paintGrass},
        {"grass-meadow", Use::Floor, paintGrassMeadow},
        {"moss", Use::Floor, paintMoss},
        {"path", Use::Floor, paintPath},
        {"sand", Use::Floor, paintSand},
        fine("cobbles", Use::Floor, paintCobbles),
        {"flagstones", Use::Floor, paintFlagstones},
        {"water", Use::Floor, paintWater},
        {"marble-checker", Use::Floor, paintMarbleChecker},
        {"marble-dark", Use::Floor, paintMarbleDark},
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
}

std::vector<Entry> seeThroughTextures() {
    return {
        {.name = "glass-pane",
         .use = Use::SeeThrough,
         .paint = paintGlassPane,
         .alpha = Alpha::Blended},
        {.name = "stained-glass",
         .use = Use::SeeThrough,
         .paint = paintStainedGlass,
         .wall = "stone-blocks",
         .alpha = Alpha::Blended},
        {.name = "shop-window",
         .use = Use::SeeThrough,
         .paint = paintShopWindow,
         .repeatsUpwards = false,
         .alpha = Alpha::Blended},
        {.name = "palace-window-foot",
         .use = Use::SeeThrough,
         .paint = paintPalaceWindowFoot,
         .wall = "plaster-white",
         .repeatsUpwards = false,
         .alpha = Alpha::Blended},
        {.name = "palace-window-head",
         .use = Use::SeeThrough,
         .paint = paintPalaceWindowHead,
         .wall = "plaster-white",
         .repeatsUpwards = false,
         .alpha = Alpha::Blended},
        {.name = "palace-opening-foot",
         .use = Use::SeeThrough,
         .paint = paintPalaceOpeningFoot,
         .wall = "plaster-white",
         .repeatsUpwards = false,
         .alpha = Alpha::Holes},
        {.name = "palace-opening-head",
         .use = Use::SeeThrough,
         .paint = paintPalaceOpeningHead,
         .wall = "plaster-white",
         .repeatsUpwards = false,
         .alpha = Alpha::Holes},
        {.name = "iron-bars",
         .use = Use::SeeThrough,
         .paint = paintIronBars,
         .alpha = Alpha::Holes},
        {.name = "grate", .use = Use::SeeThrough, .paint = paintGrate, .alpha = Alpha::Holes},
        {.name = "fence",
         .use = Use::SeeThrough,
         .paint = paintFence,
         .repeatsUpwards = false,
         .alpha = Alpha::Holes},
        {.name = "net", .use = Use::SeeThrough, .paint = paintNet, .alpha = Alpha::Holes},
        {.name = "rope-railing",
         .use = Use::SeeThrough,
         .paint = paintRopeRailing,
         .repeatsUpwards = false,
         .alpha = Alpha::Holes},
        {.name = "leaves", .use = Use::SeeThrough, .paint = paintLeaves, .alpha = Alpha::Holes},
        {.name = "nothing", .use = Use::SeeThrough, .paint = paintNothing, .alpha = Alpha::Nothing},
        {.name = "archway",
         .use = Use::SeeThrough,
         .paint = paintArchway,
         .wall = "stone-blocks",
         .repeatsUpwards = false,
         .alpha = Alpha::Holes},
    };
}

std::vector<Entry> sheets() {
    return {
        {.name = "portcullis",
         .use = Use::Sheet,
         .paint = paintPortcullis,
         .repeatsUpwards = false,
         .alpha = Alpha::Holes,
         .frames = kGateFrames},
        {.name = "double-door",
         .use = Use::Sheet,
         .paint = paintDoubleDoor,
         .repeatsUpwards = false,
         .alpha = Alpha::Holes,
         .frames = kGateFrames},
        {.name = "lava",
         .use = Use::Sheet,
         .paint = paintLava,
         .frames = kLoopFrames,
         .loops = true},
        {.name = "water-surface",
         .use = Use::Sheet,
         .paint = paintWaterSurface,
         .frames = kLoopFrames,
         .loops = true},
        {.name = "water-clear",
         .use = Use::Sheet,
         .paint = paintWaterClear,
         .alpha = Alpha::Blended,
         .frames = kLoopFrames,
         .loops = true},
        {.name = "waterfall",
         .use = Use::Sheet,
         .paint = paintWaterfall,
         .alpha = Alpha::Blended,
         .frames = kLoopFrames,
         .loops = true},
        {.name = "rune-panel",
         .use = Use::Sheet,
         .paint = paintRunePanel,
         .frames = kLoopFrames,
         .loops = true},
        {.name = "brazier",
         .use = Use::Sheet,
         .paint = paintBrazier,
         .repeatsUpwards = false,
         .repeatsSideways = false,
         .alpha = Alpha::Blended,
         .frames = kLoopFrames,
         .loops = true},
    };
}

Entry sprite(const char* name, Picture (*paint)(), int frames = 1, bool stands = true) {
    return {.name = name,
            .use = Use::Sprite,
            .paint = paint,
            .repeatsUpwards = false,
            .repeatsSideways = false,
            .alpha = Alpha::Blended,
            .frames = frames,
            .loops = frames > 1,
            .stands = stands};
}

// The same with a row for each of its four sides.
Entry figure(const char* name, Picture (*paint)(), int frames = 1) {
    Entry entry = sprite(name, paint, frames);
    entry.views = 4;
    return entry;
}

std::vector<Entry> sprites() {
    return {
        sprite("oak", paintOak),
        sprite("pine", paintPine),
        sprite("birch", paintBirch),
        sprite("bush", paintBush),
        sprite("flower-bush", paintFlowerBush),
        sprite("street-lamp", paintStreetLamp),
        sprite("standing-barrel", paintStandingBarrel),
        sprite("crate-stack", paintCrateStack),
        sprite("market-stall", paintMarketStall),
        sprite("statue", paintStatue),
        sprite("walker", paintWalker, kWalkFrames),
        sprite("cat", paintCat, kCatFrames),
        sprite("gull", paintBird, kBirdFrames, false),
        sprite("column", paintColumn),
        sprite("chandelier", paintChandelier, 1, false),
        sprite("sailing-boat", paintSailingBoat),
        sprite("swan", paintSwan),
        sprite("cypress", paintCypress),
        sprite("fountain", paintFountain, kFountainFrames),
        figure("keeper", paintKeeper),
        figure("keeper-walking", paintKeeperWalking, kFigureFrames),
        figure("guard", paintGuard),
        figure("guard-walking", paintGuardWalking, kFigureFrames),
        figure("guard-alert", paintGuardAlert),
        figure("lamb", paintLamb),
        figure("lamb-walking", paintLambWalking, kFigureFrames),
        figure("fox", paintFox),
        figure("fox-running", paintFoxRunning, kFigureFrames),
        sprite("shell", paintShell, kKeepsakeFrames),
        sprite("moonflower", paintMoonflower, kKeepsakeFrames),
        sprite("crystal", paintCrystal, kKeepsakeFrames, false),
        sprite("lantern", paintLantern, kKeepsakeFrames),
        sprite("spray", paintSpray, kLoopFrames, false),
    };
}

}  // namespace

const std::vector<Entry>& catalogue() {
    static const std::vector<Entry> entries = [] {
        std::vector<Entry> all = opaqueTextures();
        for (const std::vector<Entry>& more : {seeThroughTextures(), sheets(), sprites()}) {
            all.insert(all.end(), more.begin(), more.end());
        }
        return all;
    }();
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
        case Use::SeeThrough:
            return "window";
        case Use::Sheet:
            return "sheet";
        case Use::Sprite:
            return "sprite";
    }
    return "";
}

const char* folderOf(Use use) {
    switch (use) {
        case Use::SeeThrough:
            return "see-through";
        case Use::Sheet:
            return "sheets";
        case Use::Sprite:
            return "sprites";
        default:
            return "textures";
    }
}

}  // namespace slicecast::textures
