// A running game: a scene with a player in it, who walks, looks and acts in steps of 1/120 second.
//
//     Game game(std::move(*loaded.scene));
//     game.step({.forward = 1.0});              // 1/120 s ahead
//     Image picture = game.picture(640, 400);   // what the player sees
//
// Reads no clock and prints nothing. For play in real time, call step() 120 times a second.
#pragma once

#include "slicecast/blueprint.h"
#include "slicecast/cell_change.h"
#include "slicecast/face.h"
#include "slicecast/image.h"
#include "slicecast/input.h"
#include "slicecast/mark.h"
#include "slicecast/option.h"
#include "slicecast/picture.h"
#include "slicecast/ray.h"
#include "slicecast/scene.h"
#include "slicecast/sound.h"
#include "slicecast/trace.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

inline constexpr int kStepsEachSecond = 120;

// The viewpoint of a picture.
struct Camera {
    int map = 0;     // index in Scene::maps
    double x = 0.0;  // units, -32767 to 32767; may lie outside the map or inside a block
    double y = 0.0;
    double z = 0.0;               // height of the eye, > 0 and at most 32767
    double headingDegrees = 0.0;  // 0 = east, 90 = south; any finite number, returned as [0, 360)
    double look = 0.0;            // how far the horizon lies below the middle, in screen heights;
                                  // -4 to 4, positive looks up
};

// What a pixel shows: the nearest thing that has no hole there.
struct Pick {
    Seen what = Seen::sky;
    int map = 0;      // of the visible point
    int portals = 0;  // passed between the eye and the point
    int tileX = 0;    // of a block, the floor or the ceiling; 0 for others
    int tileY = 0;
    std::optional<Face> face;  // this and the next two are set for blocks only
    int level = 0;
    std::string block;    // name of its blueprint
    int object = -1;      // its number in the map; -1 for others
    std::string texture;  // name of the texture or sprite; empty for sky and haze
    double x = 0.0;       // the visible point, in the map's units; 0 for sky and haze
    double y = 0.0;
    double z = 0.0;
    double depth = 0.0;            // straight ahead, units; infinite for sky and haze
    std::optional<Texel> texel;    // none for sky and haze
    int alpha = 255;               // of that texel, 1 to 255: below 255 something shows through
    std::vector<Pick> reflection;  // what a mirror shows there: one element, or none
};

// The position of a world point in a picture.
struct ScreenPoint {
    double x = 0.0;      // pixels from the left; may lie outside the picture
    double y = 0.0;      // from the top
    double depth = 0.0;  // straight ahead, units
};

// The finds of one name.
struct FindCount {
    std::string name;
    int taken = 0;
    int of = 0;  // in the scene
};

// The game of a scene, see "game" in its file: what is to be found and reached.
struct GameProgress {
    std::string aim;  // for the player; may be empty, as all may be
    int taken = 0;    // finds
    int of = 0;
    std::vector<FindCount> finds;
    bool hasGoal = false;
    bool isReached = false;
    std::int64_t steps = 0;  // of 1/120 s, from the first input to the goal
};

// What has happened: a message, a find taken, the goal reached.
struct GameNews {
    enum class Kind : std::uint8_t { message, find, goal };
    Kind kind = Kind::message;
    std::string text;  // for the player; may be empty for finds and the goal
    std::string name;  // of a find
    int taken = 0;     // finds until then
};

class Game {
public:
    // The player stands at the start of the scene. `scene` must not have been moved from.
    explicit Game(Scene scene);
    ~Game();
    Game(Game&& other) noexcept;
    Game& operator=(Game&& other) noexcept;
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    // One step of 1/120 second.
    void step(const Input& input = {});

    // Restarts: everything as the scene has it; options stay.
    void reset();

    // Draws what the player sees into the caller's pixels; keeps no pointer to them. `fraction` is
    // the moment of the picture: 0 is the last step but one, 1 the last step. Use it for screens
    // that do not show 120 pictures a second. Returns false and changes no pixel if the picture is
    // empty, has no pixels, has a pitch below its width or is larger than 8192 a side.
    bool draw(const Picture& picture, double fraction = 1.0);

    // The same into a new image; an empty one where draw() returns false.
    Image picture(int width, int height);

    // The player's eye. setCamera() puts the player there, flying; where the eye already is, the
    // player only turns. It returns false and changes nothing if a value is outside its range or
    // there is no such map.
    Camera camera() const;
    bool setCamera(const Camera& camera);

    // Moves the player to that map: to the scene's start, or near the middle of another map.
    // Returns false and changes nothing if there is no such map.
    bool goToMap(int map);

    // Options by name: "fov" in degrees, "minimap", "inspector", "mirrors" and all others of
    // options(). Values are texts as `slicecast --set` takes them ("on", "75"). setOption() returns
    // an empty text on success; else it changes nothing and returns what it found and expected.
    // option() returns an empty text for an unknown name.
    std::string setOption(std::string_view name, std::string_view value);
    std::string option(std::string_view name) const;

    // All options with what they take, in the order of a list.
    static std::span<const OptionInfo> options();

    // The cells of a map as rows of signs: [level][y], each row from west to east. A sign is a
    // character of the legend, in UTF-8; '.' is an empty cell. Blocks that move appear where they
    // stand at rest. Empty if there is no such map.
    std::vector<std::vector<std::string>> cells(int map) const;

    // The sign of one cell; empty if there is no such cell.
    std::string cell(int map, int level, int x, int y) const;

    // Puts the block of a sign into a cell; "." empties it. Returns an empty text on success, else
    // what is wrong: no such cell or sign, or a block that moves, opens or leads elsewhere.
    std::string setCell(int map, int level, int x, int y, std::string_view sign);

    // The same for many cells, one after another: all of them or, with a message, none. Takes the
    // time of sorting them.
    std::string setCells(int map, std::span<const CellChange> changes);

    // The blocks of a map's legend, in its order. Empty if there is no such map.
    std::vector<Blueprint> blueprints(int map) const;

    // The blocks that one column of a picture of this size meets, front to back. Empty if there is
    // no such column or picture.
    std::vector<ColumnHit> hits(int width, int height, int column);

    // Everything that columns of a picture of this size did, in the order asked for; many at once
    // take far less time than one by one. Empty if there is no such picture, or not one of the
    // columns, or if more than kMaxPictureSide are asked for.
    std::vector<ColumnTrace> trace(int width, int height, std::span<const int> columns);

    // What drawing a picture of this size takes. Nothing if there is no such picture.
    std::optional<FrameTrace> traceFrame(int width, int height);

    // What a free ray meets. Nothing if there is no such map or a number is outside its range.
    std::optional<Ray> cast(const RayStart& from) const;

    // The nearest thing at a pixel of a picture of this size; nothing if there is no such pixel.
    std::optional<Pick> pick(int width, int height, int column, int row);

    // Where a point of the player's map (units) appears in a picture of this size, hidden or not.
    // Nothing for a point that is not in front of the eye, and if there is no such picture.
    std::optional<ScreenPoint> project(double x, double y, double z, int width, int height) const;

    // Lays lines over the picture from now on, instead of those before; only those of the player's
    // map are seen. Returns false and changes nothing for more than kMostMarks, a map that does not
    // exist, or a coordinate that is NaN or beyond 32767.
    bool mark(std::span<const Mark> lines);

    // What the player hears: first what sounded once since the last call, at most 32 sounds, then
    // what lasts now, one of each kind. Call it once for each picture, and make the
    // sounds by whatever means; the library makes none. The first call begins to listen.
    std::vector<Sound> hear();

    // The scene's game, and how far the player is.
    GameProgress progress() const;

    // What has happened in it since the last call, oldest first; the first 64 if it is long ago.
    std::vector<GameNews> takeNews();

    const std::string& title() const;
    std::vector<MapInfo> maps() const;
    std::int64_t steps() const;  // since the game began

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace slicecast
