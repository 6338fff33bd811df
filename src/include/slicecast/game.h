// A running game: a scene with a player in it, who walks, looks and acts in steps of 1/120 second.
//
//     Game game(std::move(*loaded.scene));
//     game.step({.forward = 1.0});              // 1/120 s ahead
//     Image picture = game.picture(640, 400);   // what the player sees
//
// It reads no clock and prints nothing: who calls step() as often as time has passed plays in real
// time.
#pragma once

#include "slicecast/face.h"
#include "slicecast/image.h"
#include "slicecast/input.h"
#include "slicecast/picture.h"
#include "slicecast/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

inline constexpr int kStepsEachSecond = 120;

// From where a picture is seen.
struct Camera {
    int map = 0;     // its number, see Scene::maps
    double x = 0.0;  // units; outside the map and inside of blocks, too
    double y = 0.0;
    double z = 0.0;               // height of the eye, > 0
    double headingDegrees = 0.0;  // 0 = east, 90 = south; any finite number, told as [0, 360)
    double look = 0.0;            // how far the horizon lies below the middle, in screen heights;
                                  // -4 to 4, positive looks up
};

// Rows of a picture from `first` to before `last`, 0 at the top.
struct RowRange {
    int first = 0;
    int last = 0;
};

// A block that one column of a picture passes, whether or not any of it is seen. "Front" is where
// the column's ray enters the block's tile, "back" where it leaves it. Rows are real numbers: the
// middle of row r is r + 0.5. In the tile of the eye the front depth is 0 and front rows are
// infinite.
struct ColumnHit {
    int map = 0;      // where the block stands
    int portals = 0;  // that the ray has passed before
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    std::string block;         // name of its blueprint
    std::optional<Face> face;  // through which the ray enters; none in the tile of the eye
    double x = 0.0;            // where it enters, in the map's units
    double y = 0.0;
    double distance = 0.0;  // from the eye to there along the ground, units
    double depth = 0.0;     // the same, straight ahead: what sizes in the picture go by
    double backDepth = 0.0;
    double bottom = 0.0;  // heights above the map's floor, units
    double top = 0.0;
    double topFrontRow = 0.0;
    double bottomFrontRow = 0.0;
    double topBackRow = 0.0;
    double bottomBackRow = 0.0;
    std::vector<RowRange> rows;  // where it is seen, from the top; empty where it is hidden
};

// What a pixel shows.
enum class Seen : std::uint8_t { side, roof, underside, floor, ceiling, sky, haze, object };

struct Pick {
    Seen what = Seen::sky;
    int map = 0;
    int portals = 0;           // between the eye and it
    std::optional<Face> face;  // of a block, with the four that follow
    int tileX = 0;
    int tileY = 0;
    int level = 0;
    std::string block;    // name of its blueprint
    std::string texture;  // name of the texture or sprite; empty for sky and haze
    double x = 0.0;       // the point of the map that is seen, units; 0 for sky and haze
    double y = 0.0;
    double z = 0.0;
    double depth = 0.0;  // straight ahead, units; infinite for sky and haze
};

// Where a point of the world lies in a picture.
struct ScreenPoint {
    double x = 0.0;      // pixels from the left; may lie outside the picture
    double y = 0.0;      // from the top
    double depth = 0.0;  // straight ahead, units
};

class Game {
public:
    // The player stands at the start of the scene. The scene has not been moved from.
    explicit Game(Scene scene);
    ~Game();
    Game(Game&& other) noexcept;
    Game& operator=(Game&& other) noexcept;
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    // One step of 1/120 second.
    void step(const Input& input = {});

    // Back to the start, everything as the scene has it; options stay.
    void reset();

    // Draws what the player sees into somebody's pixels, which it does not keep. `fraction` (0 to
    // 1) of the way from the last step but one to the last: for screens that show other than 120
    // pictures a second. False, and no pixel changed, for a picture that is empty, has no pixels or
    // is larger than 8192 a side.
    bool draw(const Picture& picture, double fraction = 1.0);

    // The same into an image of its own; an empty one where draw() refuses.
    Image picture(int width, int height);

    // The player's eye. To set it puts the player there, flying; false, and nothing changed, where
    // a value is outside its range.
    Camera camera() const;
    bool setCamera(const Camera& camera);

    // Where the player stands in that map: at the scene's start, or near the middle. False, and
    // nothing changed, if there is no such map.
    bool goToMap(int map);

    // Options by name: "fov" in degrees, "minimap", "inspector", "mirrors" and what else `slicecast
    // --help` lists. Values are texts as there ("on", "75"). Empty on success, else what was found
    // and expected; nothing is changed then. To ask for an unknown one gives an empty text.
    std::string setOption(std::string_view name, std::string_view value);
    std::string option(std::string_view name) const;

    // Puts the block that a character of the map's legend stands for into a cell, nothing for '.'.
    // Empty on success, else what was wrong: no such place or character, or a block that moves,
    // opens or leads elsewhere.
    std::string setCell(int map, int level, int x, int y, char32_t character);

    // What one column of a picture of that size meets, front to back; empty where there is no such
    // column or picture.
    std::vector<ColumnHit> hits(int width, int height, int column);

    // The nearest thing at a pixel of such a picture; nothing where there is no such pixel.
    std::optional<Pick> pick(int width, int height, int column, int row);

    // The other way round, for a point of the map in which the player is. Nothing for one that is
    // not before the eye.
    std::optional<ScreenPoint> project(double x, double y, double z, int width, int height) const;

    const std::string& title() const;
    std::vector<MapInfo> maps() const;
    std::int64_t steps() const;  // since the game began

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace slicecast
