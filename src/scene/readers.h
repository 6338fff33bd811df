// The readers of a scene's parts: each takes a value of the tree, reports what is wrong with it,
// and puts what it says into the description.
#pragma once

#include "base/task_list.h"
#include "scene/checker.h"
#include "scene/description.h"
#include "scene/legend.h"
#include "scene/limits.h"
#include "scene/names.h"
#include "scene/rooms.h"
#include "world/mover.h"
#include "world/object_sowing.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slicecast {

// Ranges that several readers share.
inline constexpr NumberRange kOnMapRange = {0.0, 4096.0, false,
                                            "a number from 0 to 4096, on the map"};
inline constexpr NumberRange kTile = {0.0, 4095.0, false,
                                      "a whole number of a tile, from 0 to 4095"};
inline constexpr NumberRange kTiles = {1.0, 4096.0, false,
                                       "a whole number of tiles, from 1 to 4096"};
inline constexpr NumberRange kObjectSizeRange = {0.0, kMaxObjectSize, true,
                                                 "a number above 0 and at most 64, in units"};
inline constexpr NumberRange kHeadingRange = {
    -kMaxStartHeading, kMaxStartHeading, false,
    "a number from -360 to 360, in degrees; 0 is east, 90 south"};
static_assert(kMaxMapWidth == 4096 && kMaxMapDepth == 4096 && kMaxObjectSize == 64.0 &&
                  kMaxStartHeading == 360.0,
              "as the words say");

// Something to sow over a map, and where the file states it.
struct SowingOrder {
    JsonValue value;
    std::size_t map;
    Sowing sowing;
};

// Something that is of no use inside an opaque block: its place, and where the file states it.
struct PlacedThing {
    JsonValue value;
    const char* what;
    std::size_t map;
    Coordinate x;
    Coordinate y;
    Coordinate z;
};

// A moving object, and where the file states it.
struct PlacedMotion {
    JsonValue value;
    std::size_t motion;  // index into the world's
};

// The path of an object that patrols, and where the file states it.
struct PlacedPath {
    JsonValue value;
    std::size_t motion;
};

// What a gate or a message needs, and where the file states it.
struct PlacedNeeds {
    enum class Of : std::uint8_t { gate, notice, unless };
    JsonValue value;
    Of of;
    std::size_t number;  // index into World::gateKinds or Quest::notices
};

// A message of an area, and where the file states it.
struct PlacedNotice {
    JsonValue value;
    std::size_t notice;  // index into Quest::notices
};

// "portals" of a map, which are read once all maps are known.
struct PortalList {
    JsonValue value;
    std::size_t map;
};

// The name of a gate's blueprint, and the kind of gate that follows it.
struct FollowedGate {
    JsonValue name;
    int kind;
};

// The shape of clouds that some map has.
struct ReadClouds {
    std::uint32_t seed;
    double size;
    std::shared_ptr<const CloudCover> shape;
};

struct Placing;

// A place of a map that has a name, or one that is given by x and y.
struct NamedPlace {
    JsonValue value;
    double x = 0.0;
    double y = 0.0;
    std::optional<double> z = {};
    std::optional<double> heading = {};
    bool isUsed = false;
};
struct Places {
    NameTable names;  // index into `places`
    std::vector<NamedPlace> places;
};

struct Reading;

// The shipped pictures as textures, or as sprites.
class ShippedPictures final : public MoreNames {
public:
    // `table` is "textures" or "sprites" of the table of shipped pictures.
    ShippedPictures(Reading& reading, FoundValue table, bool areTextures)
        : reading_(reading), table_(table), areTextures_(areTextures) {}

    std::optional<std::uint16_t> bring(JsonValue value) override;
    void list(std::vector<std::string_view>& names) const override;

private:
    Reading& reading_;
    FoundValue table_;
    bool areTextures_;
};

// What the readers share.
struct Reading {
    Checker& checker;
    SceneDescription& description;
    TaskList& tasks;       // long readers leave their work to it, in parts
    NameTable textures;    // TextureId
    NameTable sprites;     // SpriteId
    NameTable blueprints;  // BlueprintId
    NameTable maps;        // index into World::maps
    bool areBlueprintsSound = false;
    std::vector<bool> isMapSound;
    std::int64_t cells = 0;                           // of all maps so far
    std::int64_t filledCells = 0;                     // those that rows and fills set
    std::vector<Places> places = {};                  // of each map
    std::vector<std::vector<JsonValue>> levels = {};  // of each map, those that repeat repeated
    std::vector<PlacedMotion> placedMotions = {};
    std::vector<SowingOrder> sowings = {};
    NameTable motions = {};  // index into World::motions
    std::vector<FollowedGate> followed = {};
    std::vector<PortalList> portals = {};
    std::vector<JsonValue> mapValues = {};
    std::vector<PlacedThing> things = {};
    std::vector<std::vector<TextureId>> pictures = {};  // of textures with variants, by TextureId
    FoundValue variants = {};                           // the last list of variants
    NameTable findKinds = {};                           // index into Quest::kinds
    std::vector<PlacedPath> paths = {};
    std::vector<PlacedNeeds> needs = {};
    std::vector<PlacedNotice> placedNotices = {};
    Rooms rooms = {};
    std::vector<ReadClouds> clouds = {};  // each shape once
    FoundValue lamp = {};                 // the first one of a face or an object
    std::vector<LampId> lampOrder = {};   // the world's kinds of lamp, sorted by what they are

    Legend legend{kEmptyCell, kEmptyCell};  // of all maps
    FoundValue mapList = {};                // "maps", once they are sound
    std::optional<MoverMaker> movers = {};
    std::shared_ptr<Placing> placing = {};  // see place_objects.cpp

    void addAim(Aim::What what, JsonValue value, std::size_t first, std::size_t count = 1) {
        description.aims.push_back({what, first, count, checker.faultAt(value)});
    }
};

// "textures": { NAME: FILE, "#rrggbb" or { file, frames, rate, material, variants } }; a sheet
// without a rate is held at its first frame
void readTextures(Reading& reading, JsonValue value);

// A file or a sheet of frames; a texture may also be a colour, and has a material.
TextureReference readPicture(Checker& checker, JsonValue value, bool isTexture);

// "sprites": { NAME: FILE or { file, frames, rate, views } }
void readSprites(Reading& reading, JsonValue value);

// "objects" of a map: [ { sprite, x, y, z, width, height, light, glow, heading, find, message,
// motion } ]; they are checked to be on the map where `hasSize`.
void readObjects(Reading& reading, JsonValue value, bool hasSize, Map& map);

// "objectRows" of a map: { legend, rows }; the legend has objects without x and y.
void readObjectRows(Reading& reading, JsonValue value, bool hasSize, Map& map);

// "motion" of an object: { kind, speed, heading, reach, path, loop, alert, solid, sprites }
struct ReadMotion {
    ObjectMotion motion;
    bool hasHeading = false;
    FoundValue path = {};  // read once all maps are known
};
ReadMotion readObjectMotion(Reading& reading, JsonValue value);

// The paths of objects that patrol. Call it when all maps have been read.
void placePaths(Reading& reading);

// "find" and "message" of an object: its kind and its message; when it is shown.
std::optional<Find> readFindKind(Reading& reading, JsonValue value);
Notice readObjectMessage(Reading& reading, JsonValue value);
// Of the next map's object with this index.
void placeFind(Reading& reading, JsonValue value, Find find, int object);
void placeObjectMessage(Reading& reading, JsonValue value, Notice notice, int object);

// "messages" of the next map: [ { text, place, x, y, width, depth, bottom, top, near, once, needs,
// unless } ]
void readMessages(Reading& reading, JsonValue value);

// "game": { aim, needs, at, message }, and the needs of gates. Call it when everything else has
// been read.
void placeQuest(Reading& reading, FoundValue game);

// "sow" of a map: [ { sprite, density, seed, height, width, above, on, textures, clear, light,
// glow, find, motion } ]
void readSowing(Reading& reading, JsonValue value);

// Sows objects and checks that moving ones have room. Call it when everything else has been read.
void placeObjects(Reading& reading);

// Finds lamps, objects and points of paths within blocks, once all maps are read.
void findHiddenThings(Reading& reading);

// A PNG file's name, relative to the scene.
std::optional<std::string> readFileName(Checker& checker, JsonValue value);

// Where an image is named.
ImageReference referTo(const Checker& checker, JsonValue value, std::string file);

// Whole steps of the world, rounded.
int stepsOf(double seconds);

// "motions": { NAME: { along, moves, from, to, period, phase, shape, once } }
void readMotions(Reading& reading, JsonValue value);

// "gate" of a blueprint: { seconds, reach, keyed, approach, hold, every, once, follows, open,
// needs, locked }. Gives its index into World::gateKinds.
int readGate(Reading& reading, JsonValue value);

// Finds the gates that others follow, once all blueprints are read.
void findFollowedGates(Reading& reading);

// Checks that a gate, and a motion, fit their blueprint; that one is read but for its slopes.
void checkGate(Reading& reading, JsonValue value, const CellBlueprint& blueprint);
void checkMotion(Reading& reading, JsonValue value, const CellBlueprint& blueprint);

// "blueprints": { NAME: { bottom, top, faces, join, motion, gate } }
void readBlueprints(Reading& reading, JsonValue value);

// "maps": [ { name, legend, levels, floor, ceiling, objects, sow, portals, sky, light, fog, haze,
// far } ]
void readMaps(Reading& reading, JsonValue value);

// "levels" of a map, and its "size", which levels without rows need: its size and cells.
void readLevels(Reading& reading, JsonValue value, FoundValue size, const Legend& legend, Map& map);

// "mirror" of a roof or floor: how much of what is above shows in it; and "ripples": how far waves
// move that. Both from 0 to 1, as shares of 255.
struct ReadMirror {
    std::uint8_t mirror = 0;
    std::uint8_t ripples = 0;
};
ReadMirror readMirror(Checker& checker, const Fields& fields);

// "places" of the last map: { NAME: { x, y, z, heading } }
void readPlaces(Reading& reading, JsonValue value, bool hasSize, const Map& map);

// The place with this name. A map that is not known has every place, somewhere.
NamedPlace findPlace(Reading& reading, JsonValue value, std::optional<std::uint16_t> map);

// "x" and "y" of a tile or a point, or the "place" of the map that has them.
NamedPlace readPosition(Reading& reading, JsonValue value, const Fields& fields, bool isTile,
                        std::optional<std::uint16_t> map);

// Rows with a character for each tile; `tiles` has a number for each already.
void readTileRows(Reading& reading, JsonValue rows, const Legend& legend, std::uint16_t otherwise,
                  const Map& map, bool hasSize, std::vector<std::uint16_t>& tiles);

// The surroundings of a map whose size is known; a grid of tiles is only looked at where `hasSize`.
void readFloor(Reading& reading, JsonValue value, bool hasSize, Map& map);
void readCeiling(Reading& reading, JsonValue value, bool hasSize, Map& map);
void readSky(Reading& reading, JsonValue value, std::size_t mapIndex, Map& map);
void readLight(Reading& reading, JsonValue value, Light& light);
void readFog(Reading& reading, JsonValue value, Fog& fog);

// "lamp" of a face or an object, and the same keys of a map's lamps.
LampKind readLampKind(const Fields& fields);
LampId readLamp(Reading& reading, JsonValue value);

// "baked" of a map: { sun, ambient, lamps }
void readBakedLight(Reading& reading, JsonValue value, bool hasSize, Map& map);

// Gives moving blocks and gates their own blueprints, and checks that they have room. `maps` is the
// value in the file; all maps have been read.
void placeMovers(Reading& reading, JsonValue maps);

// "portals" of all maps: [ { x, y, level, face, to: { map, x, y, level }, turn, twoWay } ]. Call it
// when all maps have been read, before placeMovers.
void placePortals(Reading& reading);

// Gives each place its variant of textures. Call it when everything else has been read.
void placeVariants(Reading& reading);

// "start": { map, x, y, z, heading, look }
void readStart(Reading& reading, JsonValue value);

}  // namespace slicecast
