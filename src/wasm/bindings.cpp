#include "wasm/bindings.h"

#include "answers/cast_json.h"
#include "answers/cells_json.h"
#include "answers/hits_json.h"
#include "answers/json_text.h"
#include "answers/pick.h"
#include "answers/quest_json.h"
#include "answers/spot.h"
#include "answers/trace_json.h"
#include "app/keys.h"
#include "app/page_shell.h"
#include "base/image.h"
#include "base/named.h"
#include "base/number_text.h"
#include "scene/scene.h"
#include "scene/spares.h"
#include "scene/unreached.h"
#include "session/old_ways.h"
#include "session/recording_text.h"
#include "session/session.h"
#include "world/hearing.h"

#include <emscripten/emscripten.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

using namespace slicecast;

// One session of JavaScript: what has been read of a scene so far, and the game. The program owns
// the game of its session.
struct SlicecastSession {
    bool ofProgram = false;
    bool keepsLight = false;  // once the scene that loads is there
    std::string sceneText;    // that is being parsed
    std::string pictures;     // the table of shipped pictures, once it has been supplied
    std::optional<SceneParser> parser;
    ParsedScene parsed;
    SceneFiles files;
    EarlyImages early;  // decoded from `files`
    std::optional<SceneLoader> loader;
    std::optional<Recorder> recorder;  // of `own`, which writes to it
    std::optional<Replay> replay;
    std::unique_ptr<Session> own;
    std::optional<Recording> recording;  // read, but not yet replayed
    SessionOptions waiting;              // options set before there is a game; see currentValue()

    // Results that JavaScript reads, each until the next of its kind
    Image picture;
    std::string answer;
    PackedValues packed;
    double view[6] = {};                        // of slicecast_view
    double heard[1 + 4 * Hearing::kMost] = {};  // of slicecast_hear
    double tried[8] = {};                       // of slicecast_tryOldWay
    double spot[4] = {};                        // of slicecast_project and slicecast_spot
    uint32_t supplied[2] = {};  // address and bytes of the pixels of slicecast_supply

    Session* game() const { return ofProgram ? pageProgram().game() : own.get(); }
    // The picture must be drawn again.
    void changed() const {
        if (ofProgram) pageProgram().redraw();
    }
    // Where a new packed answer goes; forgets the last one.
    PackedValues& pack() {
        packed.clear();
        return packed;
    }
    // These return the address of an answer.
    const double* tell(const PicturePoint& point, bool isSeen) {
        spot[0] = point.x;
        spot[1] = point.y;
        spot[2] = point.depth;
        spot[3] = isSeen ? 1.0 : 0.0;
        return spot;
    }
    const char* give(std::string text) {
        answer = std::move(text);
        return answer.c_str();
    }
    void endParsing();
    void endLoading();
};

namespace {

// `key` is "faults" or "warnings".
void writeFaults(JsonText& json, const char* key, const std::vector<Fault>& faults) {
    json.key(key).beginArray();
    for (const Fault& fault : faults) {
        json.beginObject();
        json.key("file").text(fault.file).key("pointer").text(fault.pointer);
        json.key("line")
            .number(fault.line)
            .key("column")
            .number(fault.column)
            .key("row")
            .number(fault.row)
            .key("character")
            .number(fault.character);
        json.key("found").text(fault.found).key("expected").text(fault.expected);
        json.key("message").text(describe(fault));
        json.endObject();
    }
    json.endArray();
}

constexpr Named<OptionKind> kKinds[] = {{OptionKind::onOff, "onOff"},
                                        {OptionKind::number, "number"},
                                        {OptionKind::wholeNumber, "wholeNumber"},
                                        {OptionKind::ownOrNumber, "ownOrNumber"},
                                        {OptionKind::choice, "choice"},
                                        {OptionKind::ownOrColour, "ownOrColour"}};

std::string currentValue(const SlicecastSession& session, std::string_view name) {
    const Session* game = session.game();
    return game != nullptr ? game->option(name) : optionValue(session.waiting, name);
}

bool hasMap(const Session& game, int32_t map) {
    return map >= 0 && static_cast<std::size_t>(map) < game.world().maps.size();
}

using PackColumns = void (*)(Session&, const std::string&, int, int, std::span<const int>,
                             PackedValues&);

const double* packColumns(SlicecastSession* session, int32_t width, int32_t height,
                          const int32_t* columns, int32_t count, PackColumns pack) {
    Session* game = session->game();
    if (game == nullptr || !isPictureSize(width, height) || count < 0 || count > kMostAskedColumns)
        return nullptr;
    const std::span<const int> columnList(reinterpret_cast<const int*>(columns),
                                          static_cast<std::size_t>(count));
    for (const int column : columnList) {
        if (column < 0 || column >= width) return nullptr;
    }
    pack(*game, game->world().title, width, height, columnList, session->pack());
    return session->packed.numbers.data();
}

void takeButtons(Input& input, int32_t buttons) {
    input.jump = (buttons & 1) != 0;
    input.fast = (buttons & 2) != 0;
    input.slow = (buttons & 4) != 0;
    input.use = (buttons & 8) != 0;
    input.open = (buttons & 16) != 0;
    input.close = (buttons & 32) != 0;
}

// The search for mistakes in a scene. It lies outside of its session, because no first picture
// needs it.
struct MistakesOf {
    SlicecastSession* session;
    NameUses uses;
    std::unique_ptr<LoadedScene> scene;
    std::optional<MistakeSearch> search;
};
MistakesOf* mistakes = nullptr;

}  // namespace

void SlicecastSession::endParsing() {
    parsed = parser->take();
    parser.reset();
    sceneText = {};
    if (parsed.needsPictures) {
        give("{}");
        return;
    }
    JsonText json;
    json.beginObject().key("files").beginArray();
    for (const std::string& file : parsed.files) json.text(file);
    json.endArray();
    writeFaults(json, "faults", parsed.faults);
    give(json.endObject().str());
}

void SlicecastSession::endLoading() {
    LoadedScene loaded = loader->take();
    loader.reset();
    files.clear();
    early = {};
    JsonText json;
    json.beginObject();
    writeFaults(json, "faults", loaded.faults);
    writeFaults(json, "warnings", loaded.warnings);
    give(json.endObject().str());
    if (!loaded.world) return;
    auto loadedGame = std::make_unique<Session>(std::move(*loaded.world));
    if (keepsLight && game() != nullptr) loadedGame->keepLightOf(*game());
    for (const OptionInfo& option : knownOptions())
        loadedGame->setOption(option.name, currentValue(*this, option.name));
    if (ofProgram) {
        pageProgram().play(std::move(loadedGame));
    } else {
        own = std::move(loadedGame);
        recorder.reset();
        replay.reset();
    }
    parsed = {};
}

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* slicecast_version(void) {
    return SLICECAST_VERSION;
}

// ---- sessions

EMSCRIPTEN_KEEPALIVE SlicecastSession* slicecast_create(void) {
    return new SlicecastSession;
}

EMSCRIPTEN_KEEPALIVE void slicecast_free(SlicecastSession* session) {
    if (!session->ofProgram) delete session;
}

EMSCRIPTEN_KEEPALIVE SlicecastSession* slicecast_programSession(void) {
    static SlicecastSession session;
    session.ofProgram = true;
    return &session;
}

// ---- loading

EMSCRIPTEN_KEEPALIVE void slicecast_parse(SlicecastSession* session, const char* text,
                                          int32_t textBytes, const char* fileName) {
    session->loader.reset();
    session->files.clear();
    session->early = {};
    session->parser.reset();
    session->sceneText.assign(text, static_cast<std::size_t>(textBytes));
    session->parser.emplace(session->sceneText, fileName);
    if (!session->pictures.empty()) session->parser->takePictures(session->pictures);
}

EMSCRIPTEN_KEEPALIVE void slicecast_takePictures(SlicecastSession* session, const char* table,
                                                 int32_t tableBytes) {
    session->pictures.assign(table, static_cast<std::size_t>(tableBytes));
}

EMSCRIPTEN_KEEPALIVE double slicecast_next(SlicecastSession* session) {
    constexpr double kMostOfTheWay = 0.99;
    if (session->parser) {
        if (session->parser->next()) return std::min(session->parser->share(), kMostOfTheWay);
        session->endParsing();
    } else if (session->loader) {
        if (session->loader->next()) return std::min(session->loader->share(), kMostOfTheWay);
        session->endLoading();
    }
    return 1.0;
}

EMSCRIPTEN_KEEPALIVE double slicecast_nextMistakes(SlicecastSession* session) {
    constexpr double kMostOfTheWay = 0.99;
    if (mistakes == nullptr || mistakes->session != session) {
        delete mistakes;
        mistakes = session != nullptr ? new MistakesOf{session, {}, {}, {}} : nullptr;
        if (session == nullptr) return 1.0;
    }
    if (session->parser) {
        session->parser->lookForMistakes(mistakes->uses);
        const double share = slicecast_next(session);
        if (!session->parser) mistakes->uses = {};
        return share;
    }
    if (session->loader) {
        mistakes->scene = session->loader->nextOrTake();
        if (mistakes->scene == nullptr) return kMostOfTheWay;
        session->loader.reset();
        mistakes->search.emplace(*mistakes->scene, kMostPlacesOfPage);
    }
    if (!mistakes->search) return 1.0;
    if (mistakes->search->next()) return kMostOfTheWay;
    const Mistakes found = mistakes->search->take();
    JsonText json;
    json.beginObject();
    writeFaults(json, "warnings", found.warnings);
    writeFaults(json, "spares", found.spares);
    session->give(json.endObject().str());
    return 1.0;
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_answer(SlicecastSession* session) {
    return session->answer.c_str();
}

EMSCRIPTEN_KEEPALIVE const uint32_t* slicecast_supply(SlicecastSession* session,
                                                      const char* fileName, const uint8_t* bytes,
                                                      int32_t byteCount, int32_t blank) {
    std::vector<std::uint8_t>& file = session->files[fileName];
    file.assign(bytes, bytes + byteCount);
    const std::span<Pixel> pixels = session->early.decode(fileName, file, blank != 0);
    session->supplied[0] = static_cast<uint32_t>(reinterpret_cast<std::uintptr_t>(pixels.data()));
    session->supplied[1] = static_cast<uint32_t>(pixels.size_bytes());
    return session->supplied;
}

EMSCRIPTEN_KEEPALIVE void slicecast_start(SlicecastSession* session, int32_t keepsLight) {
    session->keepsLight = keepsLight != 0;
    // If the text had faults, this reports them again and makes no world.
    session->loader.emplace(std::move(session->parsed), session->files, std::move(session->early));
}

EMSCRIPTEN_KEEPALIVE uint32_t slicecast_memoryEnd(void) {
    return static_cast<uint32_t>(reinterpret_cast<std::uintptr_t>(sbrk(0)));
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_adopt(void) {
    if (pageProgram().game() == nullptr) return 0;
    auto restarted = std::make_unique<Session>(pageProgram().game()->takeWorld());
    renewPageProgram();
    *slicecast_programSession() = {};
    slicecast_programSession()->ofProgram = true;
    pageProgram().play(std::move(restarted));
    return 1;
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_world(SlicecastSession* session) {
    const Session* game = session->game();
    if (game == nullptr) return session->give("null");
    JsonText json;
    json.beginObject().key("title").text(game->world().title).key("maps").beginArray();
    for (const Map& map : game->world().maps) {
        json.beginObject().key("name").text(map.name);
        json.key("width")
            .number(map.width)
            .key("depth")
            .number(map.depth)
            .key("levels")
            .number(map.levels)
            .endObject();
    }
    json.endArray().key("gates").number(static_cast<int>(game->world().gates.size()));
    return session->give(json.endObject().str());
}

// ---- playing

EMSCRIPTEN_KEEPALIVE void slicecast_step(SlicecastSession* session, double forward, double strafe,
                                         double turn, double look, double fly, double turnDegrees,
                                         double lookHeights, int32_t buttons) {
    Session* game = session->game();
    if (game == nullptr) return;
    Input input;
    input.forward = forward;
    input.strafe = strafe;
    input.turn = turn;
    input.look = look;
    input.fly = fly;
    input.turnDegrees = turnDegrees;
    input.lookHeights = lookHeights;
    takeButtons(input, buttons);
    if (session->ofProgram) {
        pageProgram().step(input);
    } else {
        game->step(input);
    }
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_draw(SlicecastSession* session, int32_t width,
                                            int32_t height, double fraction) {
    Session* game = session->game();
    if (game == nullptr || !isPictureSize(width, height)) return 0;
    if (session->picture.width != width || session->picture.height != height)
        session->picture = Image(width, height);
    return game->draw({session->picture.pixels.data(), width, height, width}, fraction) ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE const uint8_t* slicecast_picture(SlicecastSession* session) {
    return reinterpret_cast<const uint8_t*>(session->picture.pixels.data());
}

// ---- options and state

EMSCRIPTEN_KEEPALIVE const char* slicecast_setOption(SlicecastSession* session, const char* name,
                                                     const char* value) {
    Session* game = session->game();
    session->changed();
    return session->give(game != nullptr ? game->setOption(name, value)
                                         : setOption(session->waiting, name, value));
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_option(SlicecastSession* session, const char* name) {
    return session->give(currentValue(*session, name));
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_options(SlicecastSession* session) {
    JsonText json;
    json.beginArray();
    for (const OptionInfo& option : knownOptions()) {
        json.beginObject()
            .key("name")
            .text(option.name)
            .key("kind")
            .text(nameOf(kKinds, option.kind));
        json.key("label").text(option.label).key("group").text(option.group);
        json.key("least")
            .number(option.least)
            .key("greatest")
            .number(option.greatest)
            .key("choices")
            .text(option.choices);
        json.key("standard").text(option.standard).key("description").text(option.description);
        json.key("value").text(currentValue(*session, option.name)).endObject();
    }
    return session->give(json.endArray().str());
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_oldWays(SlicecastSession* session) {
    JsonText json;
    json.beginArray();
    for (const OldWay& way : knownOldWays()) {
        json.beginObject().key("name").text(way.name).key("description").text(way.description);
        json.key("options").beginObject();
        std::string_view words = way.options;
        while (!words.empty()) {
            const std::size_t end = std::min(words.find(' '), words.size());
            const std::size_t sign = words.find('=');
            json.key(words.substr(0, sign)).text(words.substr(sign + 1, end - sign - 1));
            words.remove_prefix(std::min(end + 1, words.size()));
        }
        json.endObject().endObject();
    }
    return session->give(json.endArray().str());
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_leftOut(SlicecastSession* session) {
    JsonText json;
    json.beginArray();
    if (const Session* game = session->game()) {
        for (const std::string& sentence : leftOut(game->world(), game->options()))
            json.text(sentence);
    }
    return session->give(json.endArray().str());
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_tryOldWay(SlicecastSession* session, int32_t number) {
    const Session* game = session->game();
    const std::optional<OldWayView> view = game != nullptr ? game->tryOldWay(number) : std::nullopt;
    if (!view) return nullptr;
    const Eye& eye = view->eye;
    const double numbers[] = {
        view->share,   static_cast<double>(eye.map), eye.x.value(), eye.y.value(),
        eye.z.value(), eye.headingDegrees,           eye.look,      view->flying ? 1.0 : 0.0};
    std::copy(std::begin(numbers), std::end(numbers), session->tried);
    return session->tried;
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_state(SlicecastSession* session) {
    constexpr Named<GateOffer> kOffers[] = {
        {GateOffer::none, ""}, {GateOffer::open, "open"}, {GateOffer::close, "close"}};
    const Session* game = session->game();
    if (game == nullptr) return session->give("null");
    const SessionState state = game->state();
    JsonText json;
    json.beginObject();
    json.key("map").number(game->player().map).key("mapName").text(state.map);
    json.key("x")
        .number(state.x)
        .key("y")
        .number(state.y)
        .key("z")
        .number(state.z)
        .key("feet")
        .number(state.feet);
    json.key("heading")
        .number(state.headingDegrees)
        .key("look")
        .number(state.look)
        .key("speed")
        .number(state.speed);
    json.key("flying")
        .yesNo(state.flying)
        .key("swimming")
        .yesNo(state.swimming)
        .key("crouched")
        .yesNo(state.crouched)
        .key("onGround")
        .yesNo(state.onGround)
        .key("gate")
        .text(nameOf(kOffers, state.gate));
    json.key("intensity").number(state.intensity).key("multiplier").number(state.multiplier);
    json.key("steps")
        .number(static_cast<double>(state.steps))
        .key("fingerprint")
        .text(hexText(game->fingerprint(), 16));
    return session->give(json.endObject().str());
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_game(SlicecastSession* session) {
    const Session* game = session->game();
    return session->give(game == nullptr ? "null" : gameJson(*game));
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_news(SlicecastSession* session) {
    Session* game = session->game();
    return session->give(game == nullptr ? "[]" : newsJson(*game));
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_hear(SlicecastSession* session) {
    double* out = session->heard + 1;
    if (Session* game = session->game()) {
        for (const Sound& sound : game->hear()) {
            *out++ = static_cast<double>(sound.kind);
            *out++ = static_cast<double>(sound.material);
            *out++ = sound.gain;
            *out++ = sound.pan;
        }
    }
    session->heard[0] = static_cast<double>(out - session->heard - 1);
    return session->heard;
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_view(SlicecastSession* session) {
    const Session* game = session->game();
    if (game == nullptr) return nullptr;
    const Eye eye = game->eye();
    double* out = session->view;
    for (const double number : {static_cast<double>(eye.map), eye.x.value(), eye.y.value(),
                                eye.z.value(), eye.headingDegrees, eye.look})
        *out++ = number;
    return session->view;
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_setEye(SlicecastSession* session, int32_t map, double x,
                                              double y, double z, double headingDegrees,
                                              double look) {
    Session* game = session->game();
    if (game == nullptr) return 0;
    session->changed();
    return game->setEye(
               {map, toCoordinate(x), toCoordinate(y), toCoordinate(z), headingDegrees, look})
               ? 1
               : 0;
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_land(SlicecastSession* session) {
    Session* game = session->game();
    if (game == nullptr) return 0;
    session->changed();
    return static_cast<int32_t>(game->land());
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_goToMap(SlicecastSession* session, int32_t map) {
    Session* game = session->game();
    if (game == nullptr) return 0;
    session->changed();
    return game->goToMap(map) ? 1 : 0;
}

// ---- questions

EMSCRIPTEN_KEEPALIVE const double* slicecast_hits(SlicecastSession* session, int32_t width,
                                                  int32_t height, const int32_t* columns,
                                                  int32_t count) {
    return packColumns(session, width, height, columns, count, packHits);
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_trace(SlicecastSession* session, int32_t width,
                                                   int32_t height, const int32_t* columns,
                                                   int32_t count) {
    return packColumns(session, width, height, columns, count, packTraces);
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_traceFrame(SlicecastSession* session, int32_t width,
                                                      int32_t height) {
    Session* game = session->game();
    if (game == nullptr || !isPictureSize(width, height)) return session->give("null");
    return session->give(frameTraceJson(*game, game->world().title, width, height));
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_cast(SlicecastSession* session, int32_t map, double x,
                                                  double y, double z, double headingDegrees) {
    const Session* game = session->game();
    if (game == nullptr || !hasMap(*game, map)) return nullptr;
    PackedJson json(session->pack());
    writeCast(json, game->world(),
              {.map = map,
               .x = toCoordinate(x),
               .y = toCoordinate(y),
               .z = std::isnan(z) ? std::nullopt : std::optional(toCoordinate(z)),
               .headingDegrees = headingDegrees});
    return session->packed.numbers.data();
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_pick(SlicecastSession* session, int32_t width,
                                                  int32_t height, int32_t column, int32_t row) {
    Session* game = session->game();
    if (game == nullptr || !isPictureSize(width, height)) return nullptr;
    if (column < 0 || column >= width || row < 0 || row >= height) return nullptr;
    PackedJson json(session->pack());
    writePick(json, *game, width, height, column, row);
    return session->packed.numbers.data();
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_texts(SlicecastSession* session) {
    JsonText json;
    json.beginArray();
    for (const std::string& text : session->packed.texts) json.text(text);
    return session->give(json.endArray().str());
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_project(SlicecastSession* session, int32_t map,
                                                     double x, double y, double z, int32_t width,
                                                     int32_t height) {
    const Session* game = session->game();
    if (game == nullptr || !isPictureSize(width, height)) return nullptr;
    const auto point = project(*game, game->eye(), {x, y, z}, map, width, height);
    return point ? session->tell(*point, false) : nullptr;
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_cells(SlicecastSession* session, int32_t map) {
    const Session* game = session->game();
    return session->give(game == nullptr || !hasMap(*game, map) ? "null"
                                                                : cellsJson(game->world(), map));
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_blueprints(SlicecastSession* session, int32_t map) {
    const Session* game = session->game();
    return session->give(
        game == nullptr || !hasMap(*game, map) ? "null" : blueprintsJson(game->world(), map));
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_setCells(SlicecastSession* session, int32_t map,
                                                    const int32_t* cells, int32_t count,
                                                    const char* signs) {
    Session* game = session->game();
    if (game == nullptr) return session->give("no scene is loaded");
    session->changed();
    std::vector<std::string_view> known;
    std::vector<CellChange> changes;
    for (int32_t i = 0; i < count; ++i, cells += 4) {
        for (; known.size() <= static_cast<std::size_t>(cells[3]); signs += known.back().size() + 1)
            known.emplace_back(signs);
        changes.push_back(
            {cells[0], cells[1], cells[2], known[static_cast<std::size_t>(cells[3])]});
    }
    return session->give(game->setCells(map, changes));
}

EMSCRIPTEN_KEEPALIVE void slicecast_mark(SlicecastSession* session, const double* lines,
                                         int32_t count) {
    Session* game = session->game();
    if (game == nullptr) return;
    session->changed();
    std::vector<Mark> marks;
    for (int32_t i = 0; i < count; ++i, lines += 8) {
        const auto colour = static_cast<uint32_t>(lines[7]);
        marks.push_back({static_cast<int>(lines[0]),
                         {lines[1], lines[2], lines[3]},
                         {lines[4], lines[5], lines[6]},
                         {static_cast<uint8_t>(colour >> 16), static_cast<uint8_t>(colour >> 8),
                          static_cast<uint8_t>(colour), 255}});
    }
    game->setMarks(std::move(marks));
}

EMSCRIPTEN_KEEPALIVE const double* slicecast_spot(SlicecastSession* session, int32_t map, double x,
                                                  double y, double z, int32_t width,
                                                  int32_t height) {
    const Session* game = session->game();
    if (game == nullptr || !isPictureSize(width, height)) return nullptr;
    const std::optional<Spot> spot = spotOf(*game, {x, y, z}, map, width, height);
    return spot ? session->tell(*spot, spot->isSeen) : nullptr;
}

EMSCRIPTEN_KEEPALIVE void slicecast_setFlying(SlicecastSession* session, int32_t flying) {
    Session* game = session->game();
    if (game == nullptr) return;
    game->setFlying(flying != 0);
    session->changed();
}

EMSCRIPTEN_KEEPALIVE void slicecast_reset(SlicecastSession* session) {
    Session* game = session->game();
    if (game == nullptr) return;
    game->reset();
    session->changed();
}

// ---- recordings

EMSCRIPTEN_KEEPALIVE void slicecast_record(SlicecastSession* session, const char* sceneName) {
    if (session->game() == nullptr) return;
    if (session->ofProgram) {
        pageProgram().record(sceneName);
    } else {
        session->own->record(nullptr);
        session->recorder.emplace(sceneName);
        session->own->record(&*session->recorder);
    }
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_takeRecording(SlicecastSession* session) {
    std::optional<Recording> recording;
    if (session->ofProgram) {
        recording = pageProgram().takeRecording();
    } else if (session->recorder) {
        recording = session->recorder->finish(*session->own);
        session->own->record(nullptr);
        session->recorder.reset();
    }
    return session->give(recording ? writeRecording(*recording) : std::string());
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_readRecording(SlicecastSession* session,
                                                         const char* text, int32_t textBytes,
                                                         const char* fileName) {
    ReadRecording read =
        readRecording(std::string_view(text, static_cast<std::size_t>(textBytes)), fileName);
    JsonText json;
    json.beginObject();
    writeFaults(json, "faults", read.faults);
    session->recording = std::move(read.recording);
    if (session->recording) {
        json.key("scene")
            .text(session->recording->scene)
            .key("steps")
            .number(static_cast<double>(session->recording->steps));
        json.key("marks").beginArray();
        std::int64_t steps = 0;
        for (const RecordedEntry& entry : session->recording->entries) {
            if (const auto* played = std::get_if<RecordedSteps>(&entry)) steps += played->count;
            const auto* mark = std::get_if<RecordedMark>(&entry);
            if (mark != nullptr)
                json.beginObject()
                    .key("name")
                    .text(mark->name)
                    .key("step")
                    .number(static_cast<double>(steps))
                    .endObject();
        }
        json.endArray();
    }
    return session->give(json.endObject().str());
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_replay(SlicecastSession* session) {
    if (session->game() == nullptr || !session->recording) return 0;
    if (session->ofProgram) {
        pageProgram().replay(std::move(*session->recording));
    } else {
        session->replay.emplace(std::move(*session->recording));
    }
    session->recording.reset();
    session->changed();
    return 1;
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_replayStep(SlicecastSession* session, int32_t count) {
    int32_t done = 0;
    while (session->own && session->replay && done < count && session->replay->step(*session->own))
        ++done;
    return done;
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_replayState(SlicecastSession* session) {
    const Replay* replay = session->ofProgram ? pageProgram().replayed()
                           : session->replay  ? &*session->replay
                                              : nullptr;
    if (replay == nullptr) return session->give("null");
    JsonText json;
    json.beginObject().key("steps").number(static_cast<double>(replay->recording().steps));
    json.key("stepsDone")
        .number(static_cast<double>(replay->stepsDone()))
        .key("isSame")
        .yesNo(replay->isSame());
    json.key("isSeeking").yesNo(session->ofProgram && pageProgram().isSeeking());
    return session->give(json.endObject().str());
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_seekReplay(SlicecastSession* session, int32_t step) {
    if (session->ofProgram) return pageProgram().seek(step) ? 1 : 0;
    if (!session->own || !session->replay || session->recorder) return 0;
    while (!session->replay->seek(*session->own, step, step)) {
    }
    return 1;
}

// ---- program in a page

EMSCRIPTEN_KEEPALIVE void slicecast_resize(int32_t width, int32_t height) {
    pageProgram().resize(width, height);
}

EMSCRIPTEN_KEEPALIVE void slicecast_pause(int32_t paused) {
    pageProgram().setPaused(paused != 0);
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_paused(void) {
    return pageProgram().paused() ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void slicecast_setMouse(double degreesPerPixel, int32_t invert) {
    pageProgram().setMouse(degreesPerPixel, invert != 0);
}

EMSCRIPTEN_KEEPALIVE void slicecast_gamepad(double leftX, double leftY, double rightX,
                                            double rightY, double leftTrigger, double rightTrigger,
                                            int32_t buttons) {
    pageProgram().setGamepad({.left = {leftX, leftY},
                              .right = {rightX, rightY},
                              .leftTrigger = leftTrigger,
                              .rightTrigger = rightTrigger,
                              .buttons = static_cast<unsigned>(buttons)});
}

EMSCRIPTEN_KEEPALIVE void slicecast_thumbs(double forward, double strafe, double fly,
                                           int32_t buttons) {
    Input input;
    input.forward = forward;
    input.strafe = strafe;
    input.fly = fly;
    takeButtons(input, buttons);
    pageProgram().setThumbs(input);
}

EMSCRIPTEN_KEEPALIVE void slicecast_drag(double right, double down) {
    pageProgram().dragged(right, down);
}

EMSCRIPTEN_KEEPALIVE void slicecast_steerByCursor(int32_t on) {
    pageProgram().setCursorSteering(on != 0);
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_keys(void) {
    const KeyBindings& keys = pageProgram().keys();
    JsonText json;
    json.beginArray();
    for (const KeyHelp& line : keys.help()) {
        const ActionInfo& first = infoOf(line.first);
        json.beginObject().key("keys").beginArray();
        for (const std::string_view key : line.keys) json.text(key);
        json.endArray().key("does").text(line.does).key("group").text(groupName(first.group));
        json.key("scope").text(scopeName(first.scope)).key("actions").beginArray();
        for (int i = static_cast<int>(line.first); i <= static_cast<int>(line.last); ++i) {
            const ActionInfo& action = allActions()[static_cast<std::size_t>(i)];
            if (*action.name == '\0') continue;
            json.beginObject().key("name").text(action.name).key("does").text(action.does);
            json.key("press").text(pressName(action.press)).key("keys").beginArray();
            const Action which = static_cast<Action>(i);
            for (int n = 0; const KeyPosition* key = keys.keyOf(which, n); ++n) {
                json.beginObject().key("code").text(key->code);
                json.key("label").text(key->label).endObject();
            }
            json.endArray().endObject();
        }
        json.endArray().endObject();
    }
    return slicecast_programSession()->give(json.endArray().str());
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_bindKey(const char* code, const char* action) {
    KeyBindings keys = pageProgram().keys();
    std::string fault = *action == '\0' ? keys.unbind(code) : keys.bind(code, action);
    if (fault.empty()) pageProgram().setKeys(keys);
    return slicecast_programSession()->give(std::move(fault));
}

EMSCRIPTEN_KEEPALIVE void slicecast_standardKeys(void) {
    pageProgram().setKeys({});
}

EMSCRIPTEN_KEEPALIVE const char* slicecast_keyScope(const char* code) {
    const KeyPosition* position = findPosition(code);
    const std::optional<Action> action =
        position != nullptr ? pageProgram().keys().actionOf(position->scancode) : std::nullopt;
    return action ? scopeName(infoOf(*action).scope) : "";
}

EMSCRIPTEN_KEEPALIVE int32_t slicecast_begin(void) {
    return beginPageProgram() ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void slicecast_stop(void) {
    endPageProgram();
}

}  // extern "C"
