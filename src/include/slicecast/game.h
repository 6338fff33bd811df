// A running game: a scene with a player in it, who walks, looks and acts in steps of 1/120 second.
//
//     Game game(std::move(*loaded.scene));
//     game.step({.forward = 1.0});              // 1/120 s ahead
//     Image picture = game.picture(640, 400);   // what the player sees
//
// Reads no clock and prints nothing. For play in real time, call step() 120 times a second.
#pragma once

#include "slicecast/face.h"
#include "slicecast/image.h"
#include "slicecast/input.h"
#include "slicecast/picture.h"
#include "slicecast/scene.h"
#include "slicecast/sound.h"

#include <cstdint>
#include <memory>
#include <optional>
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

// Rows first <= row < last of a picture, 0 at the top.
struct RowRange {
    int first = 0;
    int last = 0;
};

// A block that one column of a picture passes, seen or not. "Front" is where the column's ray
// enters the block's tile, "back" where it leaves it. Rows are real numbers: the middle of row r is
// r + 0.5. In the tile of the eye the front depth is 0 and front rows are infinite.
struct ColumnHit {
    int map = 0;      // of the block
    int portals = 0;  // passed by the ray before it
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    std::string block;         // name of its blueprint
    std::optional<Face> face;  // where the ray enters; none in the tile of the eye
    double x = 0.0;            // the point where it enters, in the map's units
    double y = 0.0;
    double distance = 0.0;  // from the eye to that point along the ground, units
    double depth = 0.0;     // the same measured straight ahead; sizes in the picture depend on it
    double backDepth = 0.0;
    double bottom = 0.0;  // heights above the map's floor, units
    double top = 0.0;
    double topFrontRow = 0.0;
    double bottomFrontRow = 0.0;
    double topBackRow = 0.0;
    double bottomBackRow = 0.0;
    std::vector<RowRange> rows;  // where the block is seen, from the top; empty if it is hidden
};

enum class Seen : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze, object };

// What a pixel shows.
struct Pick {
    Seen what = Seen::sky;
    int map = 0;               // of the visible point
    int portals = 0;           // passed between the eye and the point
    std::optional<Face> face;  // this and the next four are set for blocks only
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    std::string block;    // name of its blueprint
    std::string texture;  // name of the texture or sprite; empty for sky and haze
    double x = 0.0;       // the visible point, in the map's units; 0 for sky and haze
    double y = 0.0;
    double z = 0.0;
    double depth = 0.0;  // straight ahead, units; infinite for sky and haze
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

    // The player's eye. setCamera() puts the player there, flying. It returns false and changes
    // nothing if a value is outside its range or there is no such map.
    Camera camera() const;
    bool setCamera(const Camera& camera);

    // Moves the player to that map: to the scene's start, or near the middle of another map.
    // Returns false and changes nothing if there is no such map.
    bool goToMap(int map);

    // Options by name: "fov" in degrees, "minimap", "inspector", "mirrors" and all others that
    // `slicecast --help` lists. Values are texts as there ("on", "75"). setOption() returns an
    // empty text on success; else it changes nothing and returns what it found and expected.
    // option() returns an empty text for an unknown name.
    std::string setOption(std::string_view name, std::string_view value);
    std::string option(std::string_view name) const;

    // Puts the block of a sign, a character of the legend in UTF-8, into a cell; "." empties it.
    // Returns an empty text on success, else what is wrong: no such cell or sign, or a block that
    // moves, opens or leads elsewhere.
    std::string setCell(int map, int level, int x, int y, std::string_view sign);

    // The blocks that one column of a picture of this size meets, front to back. Empty if there is
    // no such column or picture.
    std::vector<ColumnHit> hits(int width, int height, int column);

    // The nearest thing at a pixel of a picture of this size; nothing if there is no such pixel.
    std::optional<Pick> pick(int width, int height, int column, int row);

    // What the player hears: first what sounded once since the last call, at most 32 sounds, then
    // what lasts now, one of each kind. Call it once for each picture, and make the
    // sounds by whatever means; the library makes none. The first call begins to listen.
    std::vector<Sound> hear();

    // The scene's game, and how far the player is.
    GameProgress progress() const;

    // What has happened in it since the last call, oldest first; the first 64 if it is long ago.
    std::vector<GameNews> takeNews();

    // Where a point of the player's map (units) appears in a picture of this size, hidden or not.
    // Nothing for a point that is not in front of the eye, and if there is no such picture.
    std::optional<ScreenPoint> project(double x, double y, double z, int width, int height) const;

    const std::string& title() const;
    std::vector<MapInfo> maps() const;
    std::int64_t steps() const;  // since the game began

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace slicecast
