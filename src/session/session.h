// One running game: a world, a player and options. The program, the page's bindings and the tools
// all work through this class.
//
//     Session session(std::move(world));
//     session.step(input);                  exactly 1/120 s (kStepSeconds)
//     session.draw(picture, fraction);      `fraction` (0 to 1): between the last two steps
//
// Reads no clock, prints nothing and has no global state: the same inputs give the same states and
// pictures everywhere.
#pragma once

#include "overlay/marks.h"
#include "overlay/minimap.h"
#include "overlay/slow_drawing.h"
#include "render/crew_renderer.h"
#include "render/eye.h"
#include "render/options.h"
#include "session/edit_cells.h"
#include "session/light_presets.h"
#include "session/old_way_view.h"
#include "session/options.h"
#include "session/phase_clock.h"
#include "session/recording.h"
#include "session/session_moment.h"
#include "slicecast/input.h"
#include "slicecast/picture.h"
#include "world/body.h"
#include "world/hearing.h"
#include "world/player.h"
#include "world/world.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {

struct MapEntry;

// Facts about a game for panels, after the last step.
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
    GateOffer gate = GateOffer::none;  // what the use key would do
    double intensity = 0.0;            // of the light in this map
    double multiplier = 0.0;           // units
    std::int64_t steps = 0;            // since the session began
};

// How a player landed.
enum class Landing : std::uint8_t {
    none,    // not at all: the map has no ground to stand on
    stands,  // where the eye was; or swims there
    falls,   // where the eye was, but the ground is deeper than a step
    moved,   // on the nearest ground
};

class Session {
public:
    static constexpr std::size_t kMostNews = 64;

    // The player stands at the world's start. The world must have at least one map.
    explicit Session(World world);

    void step(const Input& input);

    // Draws the view at `fraction` of the way between the last two steps, and the overlays that are
    // on. False if the picture cannot be drawn (see Renderer::draw). Afterwards the world is what
    // it was before, even if an exception ends the drawing. Light beyond `lightWork` comes late:
    // see RenderOptions.
    bool draw(const Picture& picture, double fraction = 1.0, LightWork lightWork = kAllLight);

    // Draws a part of such a picture, from a column on, within milliseconds. Returns the column
    // where the next call has to go on, the picture's width when it is whole, or -1 if it cannot be
    // drawn. Nothing else may happen to the session in between.
    int drawSome(const Picture& picture, double fraction, int firstColumn, LightWork lightWork);

    // Back to the world's start, standing and walking. Motions, gates and animations restart, and
    // every cell is as the scene has it. Options stay.
    void reset();
    // Looks level; when flying, also comes down to standing height.
    void levelLook();
    void setHeading(double degrees);
    void setFlying(bool flying);
    // What the player hears: what sounded once since the last call, and what lasts now. The first
    // call begins to listen; before it, steps spend no time on this. Valid until the next step. See
    // world/hearing.h.
    std::span<const Sound> hear();

    // What has happened in the world's game since the last call: messages, finds, the goal. Of
    // those that nobody takes, the first kMostNews.
    std::vector<QuestNews> takeNews();

    // Puts the player's eye somewhere else, flying, for tools; also outside the grid and inside
    // blocks. Where the eye already is, the player only turns, and goes on walking. Returns false
    // and changes nothing if the eye would see nothing: no such map, at or below the floor, look
    // beyond kMaxLook, or a heading that is NaN or infinite.
    bool setEye(const Eye& eye);

    // Ends flying where the eye is, if the body has room there. Else, as inside a block or outside
    // the grid, moves the player to the nearest ground (see findGround).
    Landing land();

    // Moves the player into a map: to the scene's start if it lies in that map, else to the place
    // that map_entry.h describes, with the same heading. The player stands, and walks if there is
    // room. Returns false and changes nothing if there is no such map.
    bool goToMap(int map);

    // Changes cells of the running world (see CellEdits::set). Returns "" on success, else a
    // message. The eye stays where it is: a player inside a new block flies until out of it, as
    // after setEye.
    std::string setCells(int map, std::span<const CellChange> changes);
    std::string setCell(const CellAt& at, std::string_view sign) {
        const CellChange change = {at.level, at.x, at.y, sign};
        return setCells(at.map, {&change, 1});
    }

    // Lines over the picture from now on, instead of those before; see overlay/marks.h.
    void setMarks(std::vector<Mark> marks) { marks_ = std::move(marks); }

    // The game as it is between two steps, and the same again: later steps and pictures are those
    // that followed it. A moment is of this session, or of another one of the same scene. Restoring
    // forgets news and sounds that nobody has taken, and must not be done while recording.
    SessionMoment moment() const;
    void restore(const SessionMoment& moment);

    // Records everything that affects the player, until null is given. Start with the session, or
    // the recording is useless.
    void record(Recorder* recorder);

    // Sets the clock for the timings of the process panel; without one it shows none. Nothing else
    // uses it.
    void setClock(PhaseClock::Now now) { clock_.set(std::move(now)); }

    // Shows the light that another session of almost the same world has worked out, until it is
    // worked out for this one.
    void keepLightOf(Session& other);

    // Draws the view. Natively it may be given a crew.
    SessionRenderer& renderer() { return renderer_; }

    // Options by name ("fov", "light" ...); see options.h. Returns "" on success, else a message.
    std::string setOption(std::string_view name, std::string_view value);
    void setOption(std::string_view name, double number);
    std::string option(std::string_view name) const;

    // Gives back the world as it was loaded, for another session; this one must not be used
    // afterwards.
    World takeWorld();

    const World& world() const { return world_; }
    const Player& player() const { return player_; }
    // The player before the last step; after a leap, as now.
    const Player& beforeStep() const { return previous_; }
    const SessionOptions& options() const { return options_; }
    // Whether the old ways that are set show in one of many views.
    std::optional<OldWayView> tryOldWay(int number) const;
    // Of the last picture: of the exact method's part, if it has one, but of all its light.
    const FrameReport& report() const { return report_; }
    std::int64_t steps() const { return steps_; }
    SessionState state() const;
    // What a player is told who tries the locked gate within reach; empty without one.
    std::string lockedText() const;
    // The eye that draw(picture, fraction) uses.
    Eye eye(double fraction = 1.0) const;
    // The eye of the last picture; after a step, with the same fraction.
    Eye drawnEye() const { return eye(drawnFraction_); }
    // A trace of one column of a picture of this size, by the method that draws it.
    SliceTrace trace(int width, int height, int column, int watchedRow = -1);
    // The same for many columns; far faster than one by one.
    void trace(const TraceRequest& request, const std::function<void(SliceTrace&)>& take);
    // The work of drawing a picture of this size, without overlays; all 0 if it cannot be drawn. In
    // a comparison, of the exact method's part.
    FrameReport measure(int width, int height);
    // Recent times of the parts of a picture; null without a clock.
    const ProcessTimes* times() const { return clock_.times(); }
    // The inspected column of a picture of this width: the option's, or the middle one.
    int inspectedColumn(int width) const;
    // A hash of the state: the player, movers and gates, the options that affect a step, and the
    // number of steps.
    std::uint64_t fingerprint() const;

private:
    GateAsk gateAsk(const Input& input);
    void stepAround(const GateAsk& ask);
    bool enter(int map, const MapEntry& entry);
    void keepNews();
    bool drawView(const Eye& seen, const Picture& picture, LightWork lightWork);
    SliceTrace traceFrom(const Eye& seen, const ColumnRequest& request);
    double classicShare() const;          // share of the width, from the left
    int classicColumns(int width) const;  // columns that the classic method draws
    void optionChanged(std::string_view name);
    void applyLight();
    void drawOverlays(const Eye& seen, const Picture& picture);

    World world_;
    CellEdits edits_;
    MapLights lights_;
    SessionOptions options_;
    Player player_;
    Player previous_;   // before the last step; equals player_ after a leap
    Input heldBefore_;  // of the last step, to tell a new press from a held key
    std::vector<Body> bodies_;
    std::vector<QuestNews> news_;
    std::optional<Hearing> hearing_;
    SessionRenderer renderer_;
    FrameReport report_;
    SlowDrawing slowDrawing_;
    Minimap minimap_;
    std::vector<Mark> marks_;
    PhaseClock clock_;
    double drawnFraction_ = 1.0;
    std::int64_t steps_ = 0;
    std::int64_t beganAt_ = 0;  // the step after which the world was last at its start
    Recorder* recorder_ = nullptr;
};

}  // namespace slicecast
