#include "session/options.h"

#include "base/angle.h"

#include <gtest/gtest.h>

#include <cmath>

#include <set>
#include <string>
#include <utility>

namespace slicecast {
namespace {

TEST(Options, TheTableHasTheDefaults) {
    std::set<std::string> names;
    for (const OptionInfo& info : knownOptions()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name << " twice";
        EXPECT_EQ(optionValue(SessionOptions{}, info.name), info.standard) << info.name;
        EXPECT_FALSE(std::string(info.description).empty());
        SessionOptions options;
        EXPECT_EQ(setOption(options, info.name, info.standard), "") << info.name;
        EXPECT_EQ(optionValue(options, info.name), info.standard);
    }
    for (const char* name : {"fov", "detail", "textures", "light", "fog", "minimap", "intensity",
                             "multiplier", "mirrors", "lightPreset", "speed"})
        EXPECT_EQ(names.count(name), 1u) << name;
}

TEST(Options, NumbersAreSetAndReadAsNumbers) {
    SessionOptions options;
    setOption(options, "slowSlices", -3.0);
    setOption(options, "mirrors", 99.0);
    setOption(options, "mirrors", std::nan(""));
    setOption(options, "intensity", 1.25);
    EXPECT_EQ(options.slowSlices, -3);
    EXPECT_EQ(options.render.mirrors, kGreatestMirrors) << "brought into its range";
    EXPECT_EQ(options.intensity, 1.25);
    EXPECT_EQ(optionNumber(options, "slowSlices"), -3.0);
    EXPECT_EQ(optionNumber(options, "mirrors"), kGreatestMirrors);
    EXPECT_EQ(optionNumber(options, "minimap"), 0.0);
    EXPECT_EQ(optionNumber(options, "no such option"), 0.0);
}

TEST(Options, AcceptTheirRangeAndNothingBeyond) {
    for (const OptionInfo& info : knownOptions()) {
        SessionOptions options;
        if (info.kind == OptionKind::onOff) {
            const std::string other = std::string(info.standard) == "on" ? "off" : "on";
            EXPECT_EQ(setOption(options, info.name, other), "");
            EXPECT_EQ(optionValue(options, info.name), other);
            continue;
        }
        if (info.kind == OptionKind::choice || info.kind == OptionKind::ownOrColour)
            continue;  // see ChoicesAcceptTheirWords, ColoursAreSixDigits
        for (const double end : {info.least, info.greatest}) {
            EXPECT_EQ(setOption(options, info.name, std::to_string(end)), "") << info.name;
            EXPECT_EQ(std::stod(optionValue(options, info.name)), end) << info.name;
        }
        const std::string before = optionValue(options, info.name);
        for (const double beyond : {info.least - 1.0, info.greatest + 1.0}) {
            EXPECT_NE(setOption(options, info.name, std::to_string(beyond)), "") << info.name;
            EXPECT_EQ(optionValue(options, info.name), before) << "a refused value changes nothing";
        }
    }
}

TEST(Options, AWideFovKeepsTheAngleFromAboveToBelow) {
    const auto seen = [](const char* wide, int width, int height) {
        SessionOptions options;
        options.render.fovDegrees = 60.0;
        EXPECT_EQ(setOption(options, "wideFov", wide), "");
        return renderOptions(options, width, height).fovDegrees;
    };
    // tan of half the angle from above to below
    const auto steep = [](double fovDegrees, int width, int height) {
        return tanDegrees(fovDegrees / 2.0) * height / width;
    };
    for (const auto& [width, height] : {std::pair{1920, 1080}, {2560, 1080}, {3840, 1080}}) {
        EXPECT_EQ(seen("off", width, height), 60.0);
        EXPECT_NEAR(steep(seen("on", width, height), width, height), steep(60.0, 640, 400), 1e-12);
    }
    EXPECT_NEAR(seen("on", 3840, 1080), 104.1, 0.1);
    for (const auto& [width, height] : {std::pair{640, 400}, {390, 844}, {800, 600}})
        EXPECT_EQ(seen("on", width, height), 60.0) << "never less than the width";
    EXPECT_EQ(seen("on", 4000, 1), kMaxFovDegrees);
}

TEST(Options, ReadBackExactly) {
    SessionOptions options;
    for (const char* value : {"75", "60.5", "33.3", "12.000000000000002", "149.99999999999997"}) {
        EXPECT_EQ(setOption(options, "fov", value), "");
        EXPECT_EQ(optionValue(options, "fov"), value);
    }
    EXPECT_EQ(setOption(options, "fov", "7.5e1"), "");
    EXPECT_EQ(options.render.fovDegrees, 75.0);
    EXPECT_EQ(setOption(options, "intensity", "2.5"), "");
    EXPECT_EQ(options.intensity, 2.5);
    EXPECT_EQ(setOption(options, "intensity", "map"), "");
    EXPECT_EQ(options.intensity, std::nullopt);
    EXPECT_EQ(setOption(options, "minimapLevel", "3"), "");
    EXPECT_EQ(options.minimapLevel, 3);
    EXPECT_EQ(setOption(options, "textures", "off"), "");
    EXPECT_FALSE(options.render.textures);
}

TEST(Options, ChoicesAcceptTheirWords) {
    SessionOptions options;
    EXPECT_EQ(setOption(options, "method", "classic"), "");
    EXPECT_EQ(options.method, DrawMethod::classic);
    EXPECT_EQ(setOption(options, "method", "exact"), "");
    EXPECT_EQ(options.method, DrawMethod::exact);
    const std::pair<const char*, ClassicProjection> projections[] = {
        {"equalAngles", ClassicProjection::equalAngles},
        {"equalAnglesCorrected", ClassicProjection::equalAnglesCorrected},
        {"plane", ClassicProjection::plane}};
    for (const auto& [word, projection] : projections) {
        EXPECT_EQ(setOption(options, "classic.projection", word), "");
        EXPECT_EQ(options.classic.projection, projection) << word;
        EXPECT_EQ(optionValue(options, "classic.projection"), word);
    }
    for (const char* value :
         {"", " ", "equal", "equalAngles ", "plane equalAngles", "Plane", "0"}) {
        EXPECT_EQ(setOption(options, "classic.projection", value),
                  "Option 'classic.projection' takes 'plane', 'equalAngles' or "
                  "'equalAnglesCorrected', not '" +
                      std::string(value) + "'." +
                      (value == std::string("equalAngles ") ? " Did you mean 'equalAngles'?"
                       : value == std::string("Plane")      ? " Did you mean 'plane'?"
                                                            : ""));
        EXPECT_EQ(options.classic.projection, ClassicProjection::plane);
    }
    EXPECT_EQ(setOption(options, "method", "fast"),
              "Option 'method' takes 'exact' or 'classic', not 'fast'.");
    EXPECT_EQ(setOption(options, "method", "clasic"),
              "Option 'method' takes 'exact' or 'classic', not 'clasic'. Did you mean 'classic'?");
}

TEST(Options, ChoicesCycle) {
    EXPECT_EQ(nextChoice("lightPreset", "map"), "day");
    EXPECT_EQ(nextChoice("lightPreset", "night"), "fog");
    EXPECT_EQ(nextChoice("lightPreset", "fog"), "map");
    EXPECT_EQ(nextChoice("lightPreset", "noon"), "");
    EXPECT_EQ(nextChoice("fov", "60"), "");
    EXPECT_EQ(nextChoice("noSuchOption", ""), "");
}

TEST(Options, ColoursAreSixDigits) {
    SessionOptions options;
    EXPECT_EQ(setOption(options, "hazeColour", "#0a80FF"), "");
    EXPECT_EQ(options.hazeColour, (Colour{10, 128, 255, 255}));
    EXPECT_EQ(optionValue(options, "hazeColour"), "#0a80ff");
    for (const char* value :
         {"", "#", "#0a80f", "#0a80ff0", "0a80ff", "#0a80fg", "# a80ff", "white"}) {
        EXPECT_EQ(setOption(options, "hazeColour", value),
                  "Option 'hazeColour' takes 'map' (each map's own) or a colour as '#a0b4c8', "
                  "not '" +
                      std::string(value) + "'.");
    }
    EXPECT_EQ(options.hazeColour, (Colour{10, 128, 255, 255}));
    EXPECT_EQ(setOption(options, "hazeColour", "map"), "");
    EXPECT_EQ(options.hazeColour, std::nullopt);
}

TEST(Options, MessagesSayWhatWasFoundAndExpected) {
    SessionOptions options;
    EXPECT_EQ(setOption(options, "fov", "wide"),
              "Option 'fov' takes a number from 10 to 150, not 'wide'.");
    EXPECT_EQ(setOption(options, "fog", "yes"), "Option 'fog' takes 'on' or 'off', not 'yes'.");
    EXPECT_EQ(setOption(options, "minimapLevel", "1.5"),
              "Option 'minimapLevel' takes a whole number from -1 to 31, not '1.5'.");
    EXPECT_EQ(setOption(options, "intensity", "own"),
              "Option 'intensity' takes 'map' (each map's own) or a number from 0 to 100, "
              "not 'own'.");
    EXPECT_EQ(setOption(options, "fvo", "60"), "Unknown option 'fvo'. Did you mean 'fov'?");
    EXPECT_EQ(setOption(options, "classic.marsh", "on"),
              "Unknown option 'classic.marsh'. Did you mean 'classic.march'?");
    EXPECT_EQ(setOption(options, "hat", "1"), "Unknown option 'hat'.");
    EXPECT_EQ(optionValue(options, "fvo"), "");
}

TEST(Options, RefuseAnythingButPlainNumbers) {
    SessionOptions options;
    for (const char* value : {"", " ", " 60", "60 ", "0x3c", "nan", "inf", "infinity", "1e400",
                              "60,5", "60deg", "+-60", "--60", ".", "e5", "1e"}) {
        EXPECT_NE(setOption(options, "fov", value), "") << value;
    }
    for (const char* value : {"", "On", "OFF", "true", "1", "on "})
        EXPECT_NE(setOption(options, "light", value), "") << value;
    EXPECT_EQ(options.render.fovDegrees, 60.0);
    EXPECT_TRUE(options.render.light);
}

}  // namespace
}  // namespace slicecast
