// One running game: a world, a player in it, and options. The only thing that the program, the page's bindings and the tools talk to.
//
//     Session session(std::move(world));
//     session.step(input);                  exactly 1/120 s, as often as time has passed
//     session.draw(picture, fraction);      `fraction` (0 to 1) of the way from the last step but one to the last
//
// It reads no clock, prints nothing and holds no global state: the same inputs give the same states and pictures everywhere.
#pragma once

#include "render/eye.h"
#include "render/options.h"
#include "render/picture.h"
#include "render/renderer.h"
#include "session/input.h"
#include "session/options.h"
#include "world/player.h"
#include "world/world.h"

#include <string>
#include <string_view>

namespace slicecast {

inline constexpr int kStepsPerSecond = 120;

class Session {
public:
    // The player stands at the world's start.
    explicit Session(World world);

    void step(const Input& input);

    // Draws the view between the last two steps, and the overlays that are switched on. False if the picture cannot be drawn (see Renderer::draw).
    bool draw(const Picture& picture, double fraction = 1.0);

    // Back to the world's start, at rest.
    void reset();
    // Straight look at the middle of the screen, standing height (the notes' R key).
    void levelLook();
    void setHeading(double degrees);
    void setFlying(bool flying);
    // Puts the player's eye somewhere else, for tools; the player need not fit there in fly mode.
    bool setEye(const Eye& eye);

    // Options by name ("fov", "light" ...); see options.h. An empty string on success, else what was wrong.
    std::string setOption(std::string_view name, std::string_view value);
    std::string option(std::string_view name) const;

    const World& world() const;
    const Player& player() const;
    const SessionOptions& options() const;
    const FrameReport& report() const;
    // The eye as it would be drawn.
    Eye eye(double fraction = 1.0) const;
    std::int64_t steps() const;
    SliceTrace trace(int width, int height, int column);

private:
    World world_;
    SessionOptions options_;
    Player player_;
    Player previous_;
    Renderer renderer_;
    std::int64_t steps_ = 0;
};

}  // namespace slicecast
