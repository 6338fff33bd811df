#include "session/session.h"

#include "base/angle.h"
#include "base/hash.h"
#include "classic/draw_classic.h"
#include "overlay/divider.h"
#include "overlay/panels.h"
#include "overlay/pixel_grid.h"
#include "overlay/slice_inspector.h"
#include "world/crowd.h"
#include "world/map_entry.h"
#include "world/water.h"
#include "world/world_step.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace slicecast {
namespace {

static_assert(kLookLimit <= kMaxLook, "the renderer must be able to draw every look of the player");

PlayerInput playerInput(const Input& input, const SessionOptions& options) {
    return {.forward = input.forward,
            .strafe = input.strafe,
            .turn = input.turn,
            .look = input.look,
            .fly = input.fly,
            .turnDegrees = input.turnDegrees,
            .lookHeights = input.lookHeights,
            .jump = input.jump,
            .fast = input.fast,
            .slow = input.slow,
            .speed = options.speed,
            .bob = options.bob};
}

// Turns the shorter way.
double headingBetween(double a, double b, double fraction) {
    const double turn = wrapDegrees(b - a + 180.0) - 180.0;
    return wrapDegrees(a + turn * fraction);
}

Eye eyeOf(const Player& player) {
    return {.map = player.map,
            .x = player.x,
            .y = player.y,
            .z = eyeHeight(player),
            .headingDegrees = player.headingDegrees,
            .look = player.look};
}

// Rounded to the units of a recording.
double recordedHeading(double degrees) {
    return std::isfinite(degrees)
               ? std::floor(wrapDegrees(degrees) * kRecordedDegree + 0.5) / kRecordedDegree
               : 0.0;
}

double recordedLook(double look) {
    return std::floor(look * kRecordedHeight + 0.5) / kRecordedHeight;
}

double groundSpeed(const Player& player) {
    return std::sqrt(player.velocityX * player.velocityX + player.velocityY * player.velocityY);
}

// The part of a picture without these shares of its height; at least one row.
Picture rowsBetween(const Picture& picture, double top, double bottom) {
    const int first = std::min(static_cast<int>(top * picture.height + 0.5), picture.height - 1);
    const int end = picture.height - static_cast<int>(bottom * picture.height + 0.5);
    return {picture.row(first), picture.width, std::max(end - first, 1), picture.pitch};
}

GateAsk askOf(const Player& player) {
    return {.wish = GateAsk::Wish::nothing,
            .map = player.map,
            .x = player.x,
            .y = player.y,
            .z = eyeHeight(player)};
}

}  // namespace

Session::Session(World world) : world_(std::move(world)), lights_(world_.maps) {
    for (Map& map : world_.maps) map.findOpenLand();
    reset();
}

void Session::step(const Input& input) {
    clock_.begin();
    previous_ = player_;
    noteObjects(world_);
    const Input kept = recorder_ != nullptr ? recorder_->step(input) : input;
    const GateAsk ask = gateAsk(kept);
    stepAround(ask);
    const Body body = bodyOf(travellerOf(player_), player_.onGround);
    stepObjects(world_, &body);
    pushApart(world_, player_);
    stepPlayer(world_, player_, playerInput(kept, options_));
    stepQuest(world_, player_, ask, kept != Input{});
    keepNews();
    if (hearing_) hearing_->step(world_, previous_, player_);
    ++steps_;
    world_.steps = steps_ - beganAt_;
}

// A press is one wish, however long the key is held.
GateAsk Session::gateAsk(const Input& input) {
    const auto isPressed = [&](bool Input::*button) {
        return input.*button && !(heldBefore_.*button);
    };
    GateAsk ask = askOf(player_);
    if (isPressed(&Input::use)) ask.wish = GateAsk::Wish::change;
    if (isPressed(&Input::close)) ask.wish = GateAsk::Wish::close;
    if (isPressed(&Input::open)) ask.wish = GateAsk::Wish::open;
    heldBefore_ = input;
    return ask;
}

// A listener who never takes news does not collect more.
void Session::keepNews() {
    for (const QuestNews& news : world_.quest.news) {
        if (news_.size() < kMostNews) news_.push_back(news);
    }
}

std::vector<QuestNews> Session::takeNews() {
    return std::exchange(news_, {});
}

// Steps movers and gates; bodies may stand in their way.
void Session::stepAround(const GateAsk& ask) {
    if (isStill(world_)) return;
    bodies_.clear();
    bodies_.push_back(bodyOf(travellerOf(player_), player_.onGround));
    addBodies(world_, bodies_);
    stepWorld(world_, bodies_, ask);
    const Offset& shift = bodies_[0].shift;
    player_.x = player_.x + shift.x;
    player_.y = player_.y + shift.y;
    player_.z = player_.z + shift.z;
    liftObjects(world_, std::span(bodies_).subspan(1));
}

void Session::keepLightOf(Session& other) {
    renderer_.lit() = std::move(other.renderer_.lit());
}

bool Session::draw(const Picture& picture, double fraction, LightWork lightWork) {
    clock_.begin();
    // Movers and objects are shown between the steps like the eye; otherwise they would tremble for
    // a player who rides on one.
    const ShownBetween shown(world_, fraction);
    drawnFraction_ = fraction;
    return drawView(eye(fraction), picture, lightWork);
}

int Session::drawSome(const Picture& picture, double fraction, int firstColumn,
                      LightWork lightWork) {
    // The classic method draws all of it at once; light that is late comes with later pictures
    if (classicColumns(picture.width) > 0)
        return draw(picture, fraction, lightWork) ? picture.width : -1;
    clock_.begin();
    const ShownBetween shown(world_, fraction);
    drawnFraction_ = fraction;
    const Eye seen = eye(fraction);
    RenderOptions options = renderOptions(options_, picture.width, picture.height);
    options.lightWork = lightWork;
    const int next = renderer_.drawSome(world_, seen, options, picture, firstColumn);
    report_ = renderer_.report();
    if (next == picture.width) {
        clock_.endView();
        drawOverlays(seen, picture);
        clock_.endOverlays();
    }
    return next;
}

bool Session::drawView(const Eye& seen, const Picture& picture, LightWork lightWork) {
    const int classic = classicColumns(picture.width);
    const bool isAllClassic = classic > 0 && classic >= picture.width;
    // Skips the columns that the classic method draws afterwards.
    RenderOptions options = renderOptions(options_, picture.width, picture.height);
    options.lightWork = lightWork;
    FrameReport exact;
    if (!isAllClassic) {
        if (!renderer_.draw(world_, seen, options, picture, classic)) return false;
        exact = renderer_.report();
        report_ = exact;
    }
    if (classic > 0) {
        options.lightWork -= exact.lightWork;
        const std::optional<FrameReport> old =
            drawClassic(world_, seen, options, options_.classic, renderer_.lit(), picture, classic);
        if (!old) return false;
        report_ = isAllClassic ? *old : exact;
        report_.lightWork = exact.lightWork + old->lightWork;
        report_.lateLight = exact.lateLight + old->lateLight;
        report_.unlit = exact.unlit + old->unlit;
    }
    clock_.endView();
    drawOverlays(seen, picture);
    clock_.endOverlays();
    return true;
}

// First the overlays that cover the whole picture, then the panels on top.
void Session::drawOverlays(const Eye& seen, const Picture& picture) {
    const SessionOptions& o = options_;
    const RenderOptions render = renderOptions(o, picture.width, picture.height);
    const Picture free = rowsBetween(picture, o.overlayTop, o.overlayBottom);
    if (o.drawnColumns >= 0) {
        drawColumns(picture, o.drawnColumns);
    } else if (o.slow) {
        slowDrawing_.show(picture, o.slowSlices);
    }
    drawDivider(picture, classicColumns(picture.width));
    if (!marks_.empty()) drawMarks(world_, seen, render, marks_, picture);
    if (o.grid) drawPixelGrid(picture);
    if (o.inspector) {
        const SliceTrace slice =
            traceFrom(seen, {picture.width, picture.height, inspectedColumn(picture.width)});
        drawSliceLine(slice, picture);
        drawSideView(slice, world_, seen, free);
    }
    if (o.minimap) {
        const MinimapOptions minimap = {.level = o.minimapLevel,
                                        .fovDegrees = render.fovDegrees,
                                        .rays = o.minimapRays,
                                        .turns = o.minimapTurns,
                                        .reach = o.minimapReach,
                                        .classicShare = classicShare(),
                                        .classic = o.classic};
        minimap_.draw(world_, seen, minimap, free);
    }
    const Map& map = world_.maps[static_cast<std::size_t>(seen.map)];
    if (o.playerPanel) {
        drawPlayerPanel({.map = map.name,
                         .x = seen.x.value(),
                         .y = seen.y.value(),
                         .z = seen.z.value(),
                         .headingDegrees = seen.headingDegrees,
                         .look = seen.look,
                         .speed = groundSpeed(player_),
                         .flying = player_.flying,
                         .swimming = player_.swimming,
                         .crouched = player_.crouched},
                        free);
    }
    if (o.processPanel) {
        drawProcessPanel({.width = picture.width,
                          .height = picture.height,
                          .times = clock_.times(),
                          .report = &report(),
                          .intensity = map.light.intensity,
                          .multiplier = map.light.multiplier,
                          .mirrors = o.render.mirrors,
                          .slicesPerPicture = o.slowSlices,
                          .slow = o.slow},
                         free);
    }
}

void Session::reset() {
    if (recorder_ != nullptr) recorder_->add(RecordedReset{});
    edits_.undo(world_);
    resetWorld(world_);
    resetObjects(world_);
    resetQuest(world_);
    news_.clear();
    beganAt_ = steps_;
    world_.steps = 0;
    player_ = playerAtStart(world_);
    previous_ = player_;
}

SessionMoment Session::moment() const {
    return {.world = momentOf(world_),
            .edits = edits_.list(world_),
            .player = player_,
            .previous = previous_,
            .heldBefore = heldBefore_,
            .speed = options_.speed,
            .bob = options_.bob,
            .steps = steps_,
            .beganAt = beganAt_};
}

void Session::restore(const SessionMoment& moment) {
    edits_.restore(world_, moment.edits);
    slicecast::restore(world_, moment.world);
    news_.clear();
    if (hearing_) hearing_.emplace();
    player_ = moment.player;
    previous_ = moment.previous;
    heldBefore_ = moment.heldBefore;
    options_.speed = moment.speed;
    options_.bob = moment.bob;
    steps_ = moment.steps;
    beganAt_ = moment.beganAt;
}

World Session::takeWorld() {
    lights_.apply({}, world_.maps);
    edits_.undo(world_);
    world_.steps = 0;
    return std::move(world_);
}

void Session::levelLook() {
    if (recorder_ != nullptr) recorder_->add(RecordedLevelLook{});
    slicecast::levelLook(world_, player_);
    previous_ = player_;
}

void Session::setHeading(double degrees) {
    const double kept = recorder_ != nullptr ? recordedHeading(degrees) : degrees;
    if (recorder_ != nullptr)
        recorder_->add(RecordedHeading{static_cast<int>(kept * kRecordedDegree)});
    slicecast::setHeading(player_, kept);
    previous_.headingDegrees = player_.headingDegrees;
}

std::span<const Sound> Session::hear() {
    if (!hearing_) hearing_.emplace();
    return hearing_->take(world_, player_);
}

void Session::setFlying(bool flying) {
    if (recorder_ != nullptr) recorder_->add(RecordedFlying{flying});
    slicecast::setFlying(world_, player_, flying);
}

bool Session::setEye(const Eye& eye) {
    const bool exists = eye.map >= 0 && static_cast<std::size_t>(eye.map) < world_.maps.size();
    if (!exists || !isAboveFloor(eye) || !std::isfinite(eye.headingDegrees) ||
        !(std::abs(eye.look) <= kMaxLook))
        return false;
    double heading = eye.headingDegrees;
    double look = eye.look;
    if (recorder_ != nullptr) {
        heading = recordedHeading(heading);
        look = recordedLook(look);
        recorder_->add(RecordedEye{.map = eye.map,
                                   .x = eye.x.raw,
                                   .y = eye.y.raw,
                                   .z = eye.z.raw,
                                   .heading = static_cast<int>(heading * kRecordedDegree),
                                   .look = static_cast<int>(look * kRecordedHeight)});
    }
    const Eye now = this->eye();
    if (eye.map == now.map && eye.x == now.x && eye.y == now.y && eye.z == now.z) {
        slicecast::setHeading(player_, heading);
        player_.look = look;
        player_.lookRate = 0.0;
    } else {
        player_ = playerWithEye(eye.map, eye.x, eye.y, eye.z, heading, look);
    }
    previous_ = player_;
    return true;
}

Landing Session::land() {
    setFlying(false);
    if (player_.flying) {
        const MapEntry ground =
            findGround(world_, player_.map, {player_.x, player_.y, eyeHeight(player_)});
        return enter(player_.map, ground) && ground.stands ? Landing::moved : Landing::none;
    }
    const Traveller body = travellerOf(player_);
    const bool isNear = waterDepth(world_, body).raw > 0 ||
                        sweepZ(world_, body, {-kStepHeight.raw}) > Coordinate{-kStepHeight.raw};
    return isNear ? Landing::stands : Landing::falls;
}

// Faces the same way and looks level.
bool Session::enter(int map, const MapEntry& entry) {
    const Coordinate eyeZ = entry.stands ? entry.feet + kStandingEye : entry.feet;
    if (!setEye({.map = map,
                 .x = entry.x,
                 .y = entry.y,
                 .z = eyeZ,
                 .headingDegrees = player_.headingDegrees}))
        return false;
    if (entry.stands) setFlying(false);
    return true;
}

bool Session::goToMap(int map) {
    if (map < 0 || static_cast<std::size_t>(map) >= world_.maps.size()) return false;
    if (map == world_.start.map) {
        reset();
        return true;
    }
    return enter(map, findMapEntry(world_, map));
}

std::string Session::setCells(int map, std::span<const CellChange> changes) {
    std::string fault = edits_.set(world_, map, changes);
    if (!fault.empty()) return fault;
    if (recorder_ != nullptr) {
        for (const auto& [level, x, y, sign] : changes)
            recorder_->add(RecordedCell{map, level, x, y, std::string(sign)});
    }
    if (!player_.flying && !isFree(world_, travellerOf(player_)))
        slicecast::setFlying(world_, player_, true);
    return {};
}

void Session::record(Recorder* recorder) {
    recorder_ = recorder;
    if (recorder_ == nullptr) return;
    for (const OptionInfo& info : knownOptions()) {
        if (isRecordedOption(info.name))
            recorder_->add(RecordedOption{info.name, option(info.name)});
    }
}

std::string Session::setOption(std::string_view name, std::string_view value) {
    std::string fault = slicecast::setOption(options_, name, value);
    if (fault.empty()) optionChanged(name);
    return fault;
}

void Session::setOption(std::string_view name, double number) {
    slicecast::setOption(options_, name, number);
    optionChanged(name);
}

void Session::optionChanged(std::string_view name) {
    if (recorder_ != nullptr && isRecordedOption(name))
        recorder_->add(RecordedOption{std::string(name), option(name)});
    if (!options_.slow) slowDrawing_.restart();
    applyLight();
}

std::string Session::option(std::string_view name) const {
    return optionValue(options_, name);
}

std::string Session::lockedText() const {
    GateAsk ask = askOf(player_);
    ask.wish = GateAsk::Wish::change;
    const int gate = refusedGate(world_, ask, player_.map, bodyBox(player_));
    return gate < 0 ? std::string() : refusal(world_, world_.gates[static_cast<std::size_t>(gate)]);
}

SessionState Session::state() const {
    const Map& map = world_.maps[static_cast<std::size_t>(player_.map)];
    return {.title = world_.title,
            .map = map.name,
            .x = player_.x.value(),
            .y = player_.y.value(),
            .z = eyeHeight(player_).value(),
            .feet = player_.z.value(),
            .headingDegrees = player_.headingDegrees,
            .look = player_.look,
            .speed = groundSpeed(player_),
            .flying = player_.flying,
            .swimming = player_.swimming,
            .crouched = player_.crouched,
            .onGround = player_.onGround,
            .gate = gateOffer(world_, askOf(player_)),
            .intensity = map.light.intensity,
            .multiplier = map.light.multiplier,
            .steps = steps_};
}

Eye Session::eye(double fraction) const {
    const Eye now = eyeOf(player_);
    if (!(fraction < 1.0) || previous_.map != player_.map || previous_.leaps != player_.leaps)
        return now;
    const Eye before = eyeOf(previous_);
    const double part = fraction > 0.0 ? fraction : 0.0;
    return {.map = now.map,
            .x = between(before.x, now.x, part),
            .y = between(before.y, now.y, part),
            .z = between(before.z, now.z, part),
            .headingDegrees = headingBetween(before.headingDegrees, now.headingDegrees, part),
            .look = before.look + (now.look - before.look) * part};
}

SliceTrace Session::trace(int width, int height, int column, int watchedRow) {
    return traceFrom(eye(), {width, height, column, watchedRow});
}

void Session::trace(const TraceRequest& request, const std::function<void(SliceTrace&)>& take) {
    // Runs of neighbouring columns of the exact method are traced together.
    const RenderOptions options = renderOptions(options_, request.width, request.height);
    TraceRequest together = request;
    std::span<const int> columns = request.columns;
    const int classic = classicColumns(request.width);
    const auto isClassic = [classic](int column) { return column < classic; };
    while (!columns.empty()) {
        const auto exactEnd = std::find_if(columns.begin(), columns.end(), isClassic);
        const auto count = static_cast<std::size_t>(exactEnd - columns.begin());
        if (count > 0) {
            together.columns = columns.first(count);
            renderer_.trace(world_, eye(), options, together, take);
        } else {
            SliceTrace slice = traceFrom(
                eye(), {request.width, request.height, columns.front(), request.watchedRow});
            take(slice);
        }
        columns = columns.subspan(std::max<std::size_t>(count, 1));
    }
}

// Uses the method that draws the column.
SliceTrace Session::traceFrom(const Eye& seen, const ColumnRequest& request) {
    const RenderOptions options = renderOptions(options_, request.width, request.height);
    return request.column < classicColumns(request.width)
               ? traceClassic(world_, seen, options, options_.classic, renderer_.lit(), request)
               : renderer_.trace(world_, seen, options, request);
}

FrameReport Session::measure(int width, int height) {
    Image image(width, height);
    const Picture picture = {image.pixels.data(), width, height, width};
    const RenderOptions options = renderOptions(options_, width, height);
    if (classicShare() == 1.0) {
        return drawClassic(world_, eye(), options, options_.classic, renderer_.lit(), picture)
            .value_or(FrameReport{});
    }
    if (!renderer_.draw(world_, eye(), options, picture)) return {};
    return renderer_.report();
}

std::optional<OldWayView> Session::tryOldWay(int number) const {
    return slicecast::tryOldWay(world_, eye(), player_.flying, options_.render, options_.classic,
                                number);
}

double Session::classicShare() const {
    if (options_.compare > 0.0) return options_.compare;
    return options_.method == DrawMethod::classic ? 1.0 : 0.0;
}

int Session::classicColumns(int width) const {
    return static_cast<int>(classicShare() * width + 0.5);
}

std::uint64_t Session::fingerprint() const {
    Hash hash;
    const Player& p = player_;
    for (const std::int64_t number :
         {std::int64_t{p.map}, std::int64_t{p.x.raw}, std::int64_t{p.y.raw}, std::int64_t{p.z.raw},
          std::int64_t{p.eyeLag.raw}, std::int64_t{p.flying}, std::int64_t{p.crouched},
          std::int64_t{p.onGround}, std::int64_t{p.jumpHeld}, std::int64_t{p.lateJumpSteps},
          std::int64_t{p.earlyJumpSteps}, steps_}) {
        hash.add(number);
    }
    for (const double number : {p.velocityX, p.velocityY, p.velocityZ, p.headingDegrees, p.look,
                                p.turnRate, p.lookRate, p.eyeLagRate, options_.speed}) {
        hash.add(number);
    }
    if (p.swimming) {
        for (const int number : {p.bobStep, int{options_.bob}}) hash.add(std::int64_t{number});
    }
    if (p.behind.isOn) {
        const Portal& back = p.behind.back;
        for (const int number :
             {back.toMap, back.fromX, back.fromY, back.toX, back.toY, back.turn, back.levels,
              static_cast<int>(p.behind.side), p.behind.height.raw}) {
            hash.add(std::int64_t{number});
        }
    }
    if (!isStill(world_)) {
        for (const bool held : {heldBefore_.use, heldBefore_.open, heldBefore_.close})
            hash.add(std::int64_t{held});
        addTo(hash, world_);
    }
    addMovingObjects(hash, world_);
    addTo(hash, world_.quest);
    edits_.addTo(hash, world_);
    return hash.value();
}

int Session::inspectedColumn(int width) const {
    return options_.inspectorColumn < 0 ? width / 2 : std::min(options_.inspectorColumn, width - 1);
}

// The renderer reads the light from the map.
void Session::applyLight() {
    lights_.apply({.preset = options_.lightPreset,
                   .intensity = options_.intensity,
                   .multiplier = options_.multiplier,
                   .haze = options_.hazeColour},
                  world_.maps);
}

}  // namespace slicecast
