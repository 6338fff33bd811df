// One running game: a world, a player in it, and options. The only thing that the program, the
// page's bindings and the tools talk to.
//
//     Session session(std::move(world));
//     session.step(input);                  exactly 1/120 s (kStepSeconds), as often as time has passed
//     session.draw(picture, fraction);      `fraction` (0 to 1) of the way from the last step but one to the last
//
// It reads no clock, prints nothing and holds no global state: the same inputs give the same states
// and pictures everywhere.
#pragma once

#include "overlay/minimap.h"
#include "overlay/slow_drawing.h"
#include "render/crew_renderer.h"
#include "render/eye.h"
#include "render/options.h"
#include "session/edit_cells.h"
#include "session/light_presets.h"
#include "session/options.h"
#include "session/phase_clock.h"
#include "session/recording.h"
#include "slicecast/input.h"
#include "slicecast/picture.h"
#include "world/body.h"
#include "world/player.h"
#include "world/world.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {

// What a panel may show about a game, after the last step.
struct SessionState {
    std::string title;  // of the world
    std::string map;    // name of the map
    double x = 0.0;     // the eye, units
    double y = 0.0;
    double z = 0.0;
    double feet = 0.0;            // height of the feet, units
    double headingDegrees = 0.0;  // [0, 360)
    double look = 0.0;            // screen heights
    double speed = 0.0;           // along the ground, units per second
    bool flying = false;
    bool swimming = false;
    bool crouched = false;
    bool onGround = false;
    GateOffer gate = GateOffer::none;  // what the key for gates would do
    double intensity = 0.0;            // of the light in this map
    double multiplier = 0.0;           // units
    std::int64_t steps = 0;            // since the session began
};

class Session {
public:
    // The player stands at the world's start. The world has at least one map.
    explicit Session(World world);

    void step(const Input& input);

    // Draws the view between the last two steps, and the overlays that are switched on. False if
    // the picture cannot be drawn (see Renderer::draw).
    bool draw(const Picture& picture, double fraction = 1.0);

    // Back to the world's start, at rest, walking; what moves, opens and is animated begins anew
    // too, and every cell is as the scene has it. Options stay as they are.
    void reset();
    // Looks level; when flying, also comes down to standing height (the notes' R key).
    void levelLook();
    void setHeading(double degrees);
    void setFlying(bool flying);
    // Puts the player's eye somewhere else, flying, for tools; outside the grid and inside blocks
    // too. False, and nothing changed, if such an eye cannot see: no such map, at or below the
    // floor, look beyond kMaxLook, or a heading that is no number.
    bool setEye(const Eye& eye);

    // Into a map: to the scene's start if it lies in that map, else to the place that map_entry.h
    // describes, with the same heading. At rest, walking where there is room. False, and nothing
    // changed, if there is no such map.
    bool goToMap(int map);

    // Changes a cell of the running world (see CellEdits::set). "" on success, else what was wrong.
    // The eye stays where it is: a player who is inside the new block flies until they are out of
    // it, as after setEye.
    std::string setCell(const CellAt& at, char32_t character);

    // From now on notes down there whatever bears on the player, until null is given. A recording
    // is of use only if it begins with the session.
    void record(Recorder* recorder);

    // A clock to measure with what the process panel shows; without one it shows none of that.
    // Nothing else depends on it.
    void setClock(PhaseClock::Now now) { clock_.set(std::move(now)); }

    // What draws its view: natively it may be lent a crew.
    SessionRenderer& renderer() { return renderer_; }

    // Options by name ("fov", "light" ...); see options.h. An empty string on success, else what
    // was wrong.
    std::string setOption(std::string_view name, std::string_view value);
    void setOption(std::string_view name, double number);
    std::string option(std::string_view name) const;

    // The world as it came, for another session; what this one does then means nothing.
    World takeWorld();

    const World& world() const { return world_; }
    const Player& player() const { return player_; }
    const Player& beforeStep() const {
        return previous_;
    }  // the player as it was before the last step; as it is now after a leap
    const SessionOptions& options() const { return options_; }
    const FrameReport& report() const { return renderer_.report(); }
    std::int64_t steps() const { return steps_; }
    SessionState state() const;
    // The eye as it would be drawn.
    Eye eye(double fraction = 1.0) const;
    // The eye as it was drawn last; after a step, as it would be drawn the same part of the way on.
    Eye drawnEye() const { return eye(drawnFraction_); }
    // Everything that one column of a picture of that size does, by the method that draws it.
    SliceTrace trace(int width, int height, int column, int watchedRow = -1);
    // The same for many of them, which takes far less time than one after another.
    void trace(const TraceRequest& request, const std::function<void(SliceTrace&)>& take);
    // What it takes to draw a picture of that size, overlays apart; all 0 where it cannot be drawn.
    // Of a comparison, the exact method's part.
    FrameReport measure(int width, int height);
    // How long the parts of a picture have taken lately; null without a clock.
    const ProcessTimes* times() const { return clock_.times(); }
    // The column that is inspected in a picture of that width: the option's, or the middle one.
    int inspectedColumn(int width) const;
    // A number that two sessions share if they are in the same state: the player, what moves and
    // opens, the options that bear on a step, and the steps done.
    std::uint64_t fingerprint() const;

private:
    GateAsk gateAsk(const Input& input);
    void stepAround(const GateAsk& ask);
    bool drawView(const Eye& seen, const Picture& picture);
    SliceTrace traceFrom(const Eye& seen, const ColumnRequest& request);
    double classicShare() const;          // of the width, from the left
    int classicColumns(int width) const;  // that the classic method draws
    void optionChanged(std::string_view name);
    void applyLight();
    void drawOverlays(const Eye& seen, const Picture& picture);

    World world_;
    CellEdits edits_;
    MapLights lights_;
    SessionOptions options_;
    Player player_;
    Player previous_;   // before the last step; the same as player_ after a leap
    Input heldBefore_;  // of the last step, to tell a press from a key that is held
    std::vector<Body> bodies_;
    SessionRenderer renderer_;
    FrameReport
        classicReport_;  // of the last picture, or part of one, that the classic method drew
    SlowDrawing slowDrawing_;
    Minimap minimap_;
    PhaseClock clock_;
    double drawnFraction_ = 1.0;
    std::int64_t steps_ = 0;
    std::int64_t beganAt_ = 0;  // the step after which the world stood at its start
    Recorder* recorder_ = nullptr;
};

}  // namespace slicecast
