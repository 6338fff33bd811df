#include "session/options.h"

#include "base/angle.h"
#include "base/named.h"
#include "base/nearest_name.h"
#include "base/number_text.h"
#include "base/words.h"
#include "overlay/slow_drawing.h"
#include "slicecast/picture.h"
#include "world/limits.h"
#include "world/player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

namespace slicecast {
namespace {

constexpr double kFovShape = 1.6;  // width / height of the pictures that wideFov goes by

static_assert(kGreatestMirrors <= kMaxMirrors, "the renderer must be able to draw every value");

// The member that stores an option.
using OptionMember =
    std::variant<bool RenderOptions::*, double RenderOptions::*, bool SessionOptions::*,
                 int SessionOptions::*, double SessionOptions::*,
                 std::optional<double> SessionOptions::*, DrawMethod SessionOptions::*,
                 LightPreset SessionOptions::*, std::optional<Colour> SessionOptions::*,
                 bool ClassicOptions::*, int ClassicOptions::*, double ClassicOptions::*,
                 ClassicProjection ClassicOptions::*, ClassicRoofs ClassicOptions::*>;

// The words of the choices.
constexpr Named<LightPreset> kPresets[] = {{LightPreset::map, "map"},
                                           {LightPreset::day, "day"},
                                           {LightPreset::dusk, "dusk"},
                                           {LightPreset::night, "night"},
                                           {LightPreset::fog, "fog"}};
constexpr Named<DrawMethod> kMethods[] = {{DrawMethod::exact, "exact"},
                                          {DrawMethod::classic, "classic"}};
constexpr Named<ClassicProjection> kProjections[] = {
    {ClassicProjection::plane, "plane"},
    {ClassicProjection::equalAngles, "equalAngles"},
    {ClassicProjection::equalAnglesCorrected, "equalAnglesCorrected"}};
constexpr Named<ClassicRoofs> kRoofs[] = {{ClassicRoofs::textured, "textured"},
                                          {ClassicRoofs::flat, "flat"},
                                          {ClassicRoofs::missing, "missing"}};
constexpr auto& choicesOf(LightPreset) {
    return kPresets;
}
constexpr auto& choicesOf(DrawMethod) {
    return kMethods;
}
constexpr auto& choicesOf(ClassicProjection) {
    return kProjections;
}
constexpr auto& choicesOf(ClassicRoofs) {
    return kRoofs;
}

struct Entry {
    OptionInfo info;
    OptionMember place;
};

constexpr const char* kView = "view";
constexpr const char* kLight = "light";
constexpr const char* kOverlays = "overlays";
constexpr const char* kMoving = "moving";
constexpr const char* kClassic = "classic";

constexpr std::array kEntries = {
    Entry{{"fov", "Field of view", kView, OptionKind::number, kMinFovDegrees, kMaxFovDegrees, "60",
           "horizontal field of view in degrees"},
          &RenderOptions::fovDegrees},
    Entry{{"wideFov", "More at the sides", kView, OptionKind::onOff, 0, 0, "off",
           "pictures wider than 16:10 show more at their sides, and as much above and below as one "
           "of 16:10 with this field of view; off: it is that of the picture's width"},
          &SessionOptions::wideFov},
    Entry{{"detail", "Smooth far textures", kView, OptionKind::onOff, 0, 0, "on",
           "smaller images for distant textures, so that they do not flicker"},
          &RenderOptions::detail},
    Entry{{"detailThreshold", "Texels per pixel", kView, OptionKind::number, 0.125, 64, "1",
           "texels per pixel from which the next smaller image is used"},
          &RenderOptions::detailThreshold},
    Entry{{"smooth", "Smooth near textures", kView, OptionKind::onOff, 0, 0, "off",
           "textures close to the eye blend from texel to texel, instead of showing squares"},
          &RenderOptions::smooth},
    Entry{{"textures", "Textures", kView, OptionKind::onOff, 0, 0, "on",
           "textures; off: their average colours"},
          &RenderOptions::textures},
    Entry{
        {"light", "Light", kLight, OptionKind::onOff, 0, 0, "on", "light that fades with distance"},
        &RenderOptions::light},
    Entry{{"intensity", "Intensity", kLight, OptionKind::ownOrNumber, 0, 100, "map",
           "intensity of the light"},
          &SessionOptions::intensity},
    Entry{{"multiplier", "Reach of the light", kLight, OptionKind::ownOrNumber, 0, 1000, "map",
           "reach of the light, units"},
          &SessionOptions::multiplier},
    Entry{{"baked", "Sun and lamps", kLight, OptionKind::onOff, 0, 0, "on",
           "baked light of sun, sky and lamps, in maps that have it"},
          &RenderOptions::baked},
    Entry{{"fog", "Fog", kLight, OptionKind::onOff, 0, 0, "on", "fog, in maps that have it"},
          &RenderOptions::fog},
    Entry{{"mirrors", "Mirrors", kLight, OptionKind::number, 0, kGreatestMirrors, "1",
           "multiplies the strength of all mirrors; 0 for none"},
          &RenderOptions::mirrors},
    Entry{{"lightPreset", "Time of day", kLight, OptionKind::choice, 0, 0, "map",
           "time of day in all maps; map keeps the light, fog and sky of each",
           kJoinedNames<kPresets>.data()},
          &SessionOptions::lightPreset},
    Entry{{"hazeColour", "Haze", kLight, OptionKind::ownOrColour, 0, 0, "map",
           "colour of the fog and of the far floor, #rrggbb"},
          &SessionOptions::hazeColour},
    Entry{{"minimap", "Minimap", kOverlays, OptionKind::onOff, 0, 0, "off", "the map from above"},
          &SessionOptions::minimap},
    Entry{{"minimapLevel", "Level of the minimap", kOverlays, OptionKind::wholeNumber, -1,
           kMaxLevels - 1, "-1", "level that the minimap shows; -1 for the player's"},
          &SessionOptions::minimapLevel},
    Entry{{"minimapRays", "Rays on the minimap", kOverlays, OptionKind::onOff, 0, 0, "off",
           "rays on the minimap, each up to the first block that it meets"},
          &SessionOptions::minimapRays},
    Entry{{"minimapTurns", "Minimap turns", kOverlays, OptionKind::onOff, 0, 0, "off",
           "the minimap turns with the view; off: north is up"},
          &SessionOptions::minimapTurns},
    Entry{{"minimapReach", "Circle on the minimap", kOverlays, OptionKind::number, 0, 100, "2",
           "radius of the circle around the player, units; 0 for none"},
          &SessionOptions::minimapReach},
    Entry{{"playerPanel", "Player", kOverlays, OptionKind::onOff, 0, 0, "off",
           "the player's position and heading"},
          &SessionOptions::playerPanel},
    Entry{{"processPanel", "Drawing", kOverlays, OptionKind::onOff, 0, 0, "off",
           "figures about drawing the picture"},
          &SessionOptions::processPanel},
    Entry{{"inspector", "Slice inspector", kOverlays, OptionKind::onOff, 0, 0, "off",
           "one slice: its line, and its hits from the side"},
          &SessionOptions::inspector},
    Entry{{"inspectorColumn", "Inspected slice", kOverlays, OptionKind::wholeNumber, -1,
           kMaxPictureSide - 1, "-1", "the inspected slice; -1 for the middle one"},
          &SessionOptions::inspectorColumn},
    Entry{{"overlayTop", "Free above", kOverlays, OptionKind::number, 0, 1, "0",
           "share of the picture's height that panels keep free at its top"},
          &SessionOptions::overlayTop},
    Entry{{"overlayBottom", "Free below", kOverlays, OptionKind::number, 0, 1, "0",
           "the same at its bottom"},
          &SessionOptions::overlayBottom},
    Entry{{"grid", "Pixel grid", kOverlays, OptionKind::onOff, 0, 0, "off",
           "a grid of 10 and 100 pixels over the picture"},
          &SessionOptions::grid},
    Entry{{"slow", "Slow drawing", kOverlays, OptionKind::onOff, 0, 0, "off",
           "the picture builds up slice by slice"},
          &SessionOptions::slow},
    Entry{{"slowSlices", "Slices per picture", kOverlays, OptionKind::wholeNumber,
           -kMostSlicesPerPicture, kMostSlicesPerPicture, "1",
           "slices that each picture adds; -n adds one every n pictures"},
          &SessionOptions::slowSlices},
    Entry{{"drawnColumns", "Drawn slices", kOverlays, OptionKind::wholeNumber, -1, kMaxPictureSide,
           "-1", "number of slices drawn, from the left; -1 for all"},
          &SessionOptions::drawnColumns},
    Entry{{"speed", "Speed", kMoving, OptionKind::number, kLeastSpeed, kGreatestSpeed, "1",
           "multiplies the moving speed"},
          &SessionOptions::speed},
    Entry{{"bob", "Bobbing on water", kMoving, OptionKind::onOff, 0, 0, "on",
           "the view bobs up and down on the water"},
          &SessionOptions::bob},
    Entry{{"method", "Renderer", kClassic, OptionKind::choice, 0, 0, "exact",
           "the renderer; classic is slow and shows the old ways below, for lessons",
           kJoinedNames<kMethods>.data()},
          &SessionOptions::method},
    Entry{{"compare", "Old against exact", kClassic, OptionKind::number, 0, 1, "0",
           "share of the picture, from the left, that the classic renderer draws beside the exact "
           "one; 0 for no comparison"},
          &SessionOptions::compare},
    Entry{{"classic.projection", "Projection", kClassic, OptionKind::choice, 0, 0, "plane",
           "how columns are aimed; equal angles bend walls, like a fish eye unless corrected",
           kJoinedNames<kProjections>.data()},
          &ClassicOptions::projection},
    Entry{{"classic.march", "Marching with a step", kClassic, OptionKind::onOff, 0, 0, "off",
           "rays look for blocks step by step"},
          &ClassicOptions::march},
    Entry{{"classic.step", "Size of the step", kClassic, OptionKind::number, kLeastMarchStep,
           kGreatestMarchStep, "0.001", "size of a step, units"},
          &ClassicOptions::stepSize},
    Entry{{"classic.reach", "Reach of the rays", kClassic, OptionKind::number, kLeastMarchReach,
           kGreatestMarchReach, "25", "distance at which rays stop, units"},
          &ClassicOptions::reach},
    Entry{{"classic.stretched", "Stretched textures", kClassic, OptionKind::onOff, 0, 0, "off",
           "one texture over the whole height of a stack of blocks"},
          &ClassicOptions::stretched},
    Entry{{"classic.mirroredTextures", "Mirrored textures", kClassic, OptionKind::onOff, 0, 0,
           "off", "letters on northern and eastern faces are mirrored"},
          &ClassicOptions::mirroredTextures},
    Entry{{"classic.roofs", "Roofs", kClassic, OptionKind::choice, 0, 0, "textured",
           "tops and undersides of blocks: with their textures, in one colour, or not drawn",
           kJoinedNames<kRoofs>.data()},
          &ClassicOptions::roofs},
    Entry{{"classic.seams", "Seams", kClassic, OptionKind::onOff, 0, 0, "off",
           "lines one pixel high between stacked blocks, and at the picture's edges"},
          &ClassicOptions::seams},
    Entry{{"classic.painter", "Painter's order", kClassic, OptionKind::onOff, 0, 0, "off",
           "painter's order: all blocks, from far to near, over each other"},
          &ClassicOptions::paintersOrder},
    Entry{{"classic.oneLevel", "One level", kClassic, OptionKind::onOff, 0, 0, "off",
           "only the eye's level, placed on the floor, with all blocks one unit high"},
          &ClassicOptions::oneLevel},
    Entry{{"classic.firstHits", "One hit per level", kClassic, OptionKind::onOff, 0, 0, "off",
           "one hit per level: everything behind the first block of a level is missing"},
          &ClassicOptions::firstHits},
    Entry{{"classic.noOwnCell", "Own cell missing", kClassic, OptionKind::onOff, 0, 0, "off",
           "the blocks of the eye's own tile are missing"},
          &ClassicOptions::noOwnCell},
    Entry{{"classic.driftingHorizon", "Drifting horizon", kClassic, OptionKind::onOff, 0, 0, "off",
           "the horizon sinks when the eye rises"},
          &ClassicOptions::driftingHorizon},
    Entry{{"classic.columnDepth", "One depth per column", kClassic, OptionKind::onOff, 0, 0, "off",
           "one depth per column: the first block, however low, hides all objects behind it"},
          &ClassicOptions::columnDepth},
    Entry{{"classic.wrongScale", "Objects in a wrong scale", kClassic, OptionKind::onOff, 0, 0,
           "off", "objects are sized by the picture's height: too small, their feet off the floor"},
          &ClassicOptions::wrongScale},
    Entry{{"classic.flippedMirrors", "Flipped reflection", kClassic, OptionKind::onOff, 0, 0, "off",
           "floors reflect the picture flipped; other mirrors do not reflect"},
          &ClassicOptions::flippedMirrors},
    Entry{{"classic.portalsOverdrawn", "Portals drawn over", kClassic, OptionKind::onOff, 0, 0,
           "off", "the view through a portal is drawn over the things in front of it"},
          &ClassicOptions::portalsOverdrawn},
    Entry{{"classic.sineSteps", "Table of sines", kClassic, OptionKind::wholeNumber, 0,
           kMostSineSteps, "0", "entries of the sine table for a full turn; 0 for exact sines"},
          &ClassicOptions::sineSteps},
    Entry{{"classic.pixelSize", "Coarse pixels", kClassic, OptionKind::wholeNumber, 1,
           kMostPixelSize, "1", "side of the squares of one colour, pixels"},
          &ClassicOptions::pixelSize},
};

constexpr auto kInfos = [] {
    std::array<OptionInfo, kEntries.size()> infos{};
    for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = kEntries[i].info;
    return infos;
}();

const Entry* findEntry(std::string_view name) {
    for (const Entry& entry : kEntries) {
        if (name == entry.info.name) return &entry;
    }
    return nullptr;
}

// The whole text must be a finite decimal number.
std::optional<double> readFinite(std::string_view text) {
    const std::optional<double> number = readNumber(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

// Removes the first word of a choice and returns it; empty if there is none.
std::string_view nextWord(std::string_view& words) {
    const std::size_t end = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    return word;
}

// 'a', 'b' or 'c'
std::string listed(std::string_view words) {
    std::string text;
    while (!words.empty()) {
        const std::string_view word = nextWord(words);
        text += text.empty() ? "" : words.empty() ? " or " : ", ";
        add(text, {"'", word, "'"});
    }
    return text;
}

std::string expected(const OptionInfo& info) {
    const std::string range = words(Shortest{info.least}, " to ", Shortest{info.greatest});
    switch (info.kind) {
        case OptionKind::onOff:
            return "'on' or 'off'";
        case OptionKind::wholeNumber:
            return words("a whole number from ", range);
        case OptionKind::ownOrNumber:
            return words("'map' (each map's own) or a number from ", range);
        case OptionKind::choice:
            return listed(info.choices);
        case OptionKind::ownOrColour:
            return "'map' (each map's own) or a colour as '#a0b4c8'";
        case OptionKind::number:
            break;
    }
    return words("a number from ", range);
}

// The member that stores an entry's value.
auto& member(SessionOptions& options, bool RenderOptions::*place) {
    return options.render.*place;
}
auto& member(SessionOptions& options, double RenderOptions::*place) {
    return options.render.*place;
}
template <typename Value>
auto& member(SessionOptions& options, Value ClassicOptions::*place) {
    return options.classic.*place;
}
template <typename Value>
auto& member(SessionOptions& options, Value SessionOptions::*place) {
    return options.*place;
}

// Each returns false if the option does not allow the text.
bool read(const OptionInfo&, std::string_view text, bool& value) {
    if (text != "on" && text != "off") return false;
    value = text == "on";
    return true;
}

bool read(const OptionInfo& info, std::string_view text, double& value) {
    const std::optional<double> number = readFinite(text);
    if (!number || *number < info.least || *number > info.greatest) return false;
    value = *number;
    return true;
}

bool read(const OptionInfo& info, std::string_view text, int& value) {
    double number = 0.0;
    if (!read(info, text, number) || number != std::floor(number)) return false;
    value = static_cast<int>(number);
    return true;
}

bool read(const OptionInfo& info, std::string_view text, std::optional<double>& value) {
    double number = 0.0;
    if (text == "map") {
        value.reset();
        return true;
    }
    if (!read(info, text, number)) return false;
    value = number;
    return true;
}

bool read(const OptionInfo&, std::string_view text, std::optional<Colour>& value) {
    if (text == "map") {
        value.reset();
        return true;
    }
    if (text.size() != 7 || text[0] != '#' ||
        text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string_view::npos)
        return false;
    const unsigned long number = std::strtoul(std::string(text.substr(1)).c_str(), nullptr, 16);
    value = Colour{static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8),
                   static_cast<std::uint8_t>(number), 255};
    return true;
}

template <typename Value>
    requires std::is_enum_v<Value> bool
read(const OptionInfo&, std::string_view text, Value& value) {
    const std::optional<Value> found = valueOf(choicesOf(value), text);
    value = found.value_or(value);
    return found.has_value();
}

std::string written(const OptionInfo&, bool value) {
    return value ? "on" : "off";
}
std::string written(const OptionInfo&, int value) {
    return words(value);
}
std::string written(const OptionInfo&, double value) {
    return words(Shortest{value});
}
std::string written(const OptionInfo&, const std::optional<double>& value) {
    return value ? words(Shortest{*value}) : "map";
}
std::string written(const OptionInfo&, const std::optional<Colour>& value) {
    if (!value) return "map";
    return words("#",
                 hexText(static_cast<std::uint64_t>(value->r << 16 | value->g << 8 | value->b), 6));
}
template <typename Value>
    requires std::is_enum_v<Value>
std::string written(const OptionInfo&, Value value) {
    return nameOf(choicesOf(value), value);
}

}  // namespace

std::span<const OptionInfo> knownOptions() {
    return kInfos;
}

const OptionInfo* findOption(std::string_view name) {
    const Entry* entry = findEntry(name);
    return entry == nullptr ? nullptr : &entry->info;
}

std::string setOption(SessionOptions& options, std::string_view name, std::string_view value) {
    const Entry* entry = findEntry(name);
    if (entry == nullptr) {
        std::vector<std::string_view> names;
        names.reserve(std::size(kInfos));
        for (const OptionInfo& info : kInfos) names.push_back(info.name);
        return words("Unknown option '", name, "'.", didYouMean(name, names));
    }
    const auto readInto = [&](auto place) {
        return read(entry->info, value, member(options, place));
    };
    if (std::visit(readInto, entry->place)) return {};
    std::vector<std::string_view> choices;
    for (std::string_view rest = entry->info.choices; !rest.empty();)
        choices.push_back(nextWord(rest));
    return words("Option '", name, "' takes ", expected(entry->info), ", not '", value, "'.",
                 didYouMean(value, choices));
}

void setOption(SessionOptions& options, std::string_view name, double number) {
    const Entry* entry = findEntry(name);
    if (entry == nullptr || std::isnan(number)) return;
    const double taken = std::clamp(number, entry->info.least, entry->info.greatest);
    const auto write = [&](auto place) {
        auto& value = member(options, place);
        using Value = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, int>) {
            value = static_cast<int>(taken);
        } else if constexpr (std::is_same_v<Value, double> ||
                             std::is_same_v<Value, std::optional<double>>) {
            value = taken;
        }
    };
    std::visit(write, entry->place);
}

RenderOptions renderOptions(const SessionOptions& options, int width, int height) {
    RenderOptions render = options.render;
    const double spanned = kFovShape * std::max(height, 1);
    if (options.wideFov && width > spanned) {
        const double slope = width / spanned * tanDegrees(render.fovDegrees / 2.0);
        render.fovDegrees = std::min(kMaxFovDegrees, 2.0 * atanDegrees(slope));
    }
    return render;
}

std::string nextChoice(std::string_view name, std::string_view value) {
    const Entry* entry = findEntry(name);
    if (entry == nullptr) return {};
    std::string_view words = entry->info.choices;
    const std::string first(nextWord(words));
    for (std::string_view word = first; !word.empty(); word = nextWord(words)) {
        if (word == value) return words.empty() ? first : std::string(nextWord(words));
    }
    return {};
}

std::string optionValue(const SessionOptions& options, std::string_view name) {
    const Entry* entry = findEntry(name);
    if (entry == nullptr) return {};
    SessionOptions copy = options;
    return std::visit([&](auto place) { return written(entry->info, member(copy, place)); },
                      entry->place);
}

double optionNumber(const SessionOptions& options, std::string_view name) {
    const Entry* entry = findEntry(name);
    if (entry == nullptr) return 0.0;
    SessionOptions copy = options;
    const auto read = [&](auto place) -> double {
        auto& value = member(copy, place);
        using Value = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, double>) {
            return value;
        } else {
            return 0.0;
        }
    };
    return std::visit(read, entry->place);
}

bool showsOverlay(const SessionOptions& options) {
    return std::any_of(kEntries.begin(), kEntries.end(), [&](const Entry& entry) {
        const auto* place = std::get_if<bool SessionOptions::*>(&entry.place);
        return entry.info.group == kOverlays && place != nullptr && options.**place;
    });
}

}  // namespace slicecast
