// slicecast-render: draws one view of a scene into a PNG file, without a screen; or prints what a
// column meets, or how it was drawn.

#include "answers/hits_json.h"
#include "answers/trace_json.h"
#include "base/image.h"
#include "files/print_line.h"
#include "files/recording_file.h"
#include "files/scene_file.h"
#include "files/write_file.h"
#include "headless/replay_file.h"
#include "headless/view_arguments.h"
#include "session/session.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace slicecast;

namespace {

// Exit status for a wrong command line; it is 1 for a faulty scene or file.
constexpr int kWrongUse = 2;

struct Arguments {
    std::string scene;
    std::string map;
    std::string eye;
    std::string size;
    std::string fov;
    std::string time;
    std::vector<std::string> options;  // OPTION=VALUE
    std::string replay;
    std::string at;
    std::string hits;
    std::string trace;
    std::string out;
};

std::string footer() {
    constexpr std::size_t kDescriptions = 22;  // column at which they begin
    std::string text = "Options for --set:\n";
    for (const OptionInfo& option : knownOptions()) {
        std::string name = "  " + std::string(option.name);
        name.resize(std::max(name.size() + 1, kDescriptions), ' ');
        std::string words = option.choices[0] != '\0' ? std::string(": ") : std::string();
        for (const char* letter = option.choices; *letter != '\0'; ++letter)
            words += *letter == ' ' ? std::string(", ") : std::string(1, *letter);
        text += name + option.description + words + " (" + option.standard + ")\n";
    }
    text +=
        "\nExamples:\n"
        "  slicecast-render castle.json --out castle.png\n"
        "  slicecast-render castle.json --eye 8.5,3.25,0.5,90,0.1 --size 640x400 --fov 75 --out "
        "gate.png\n"
        "  slicecast-render castle.json --map cellar --eye 4,4,0.5,0,0 --set light=off --set "
        "detail=off --out cellar.png\n"
        "  slicecast-render castle.json --time 2.5 --out later.png\n"
        "  slicecast-render castle.json --hits 640 > hits.json\n"
        "  slicecast-render castle.json --size 320x200 --trace all > trace.json\n"
        "  slicecast-render castle.json --replay castle.txt --at on-the-bridge --out bridge.png\n"
        "\nAn eye is X,Y,Z in units (x to the east, y to the south, z up from the floor), a "
        "heading in degrees (0 east, 90 south) and a look\n"
        "in screen heights (0 level, positive up). The exit status is 1 for a faulty scene and 2 "
        "for a wrong command line.\n";
    return text;
}

void describeArguments(CLI::App& cli, Arguments& arguments) {
    cli.add_option("SCENE", arguments.scene, "scene file")->required();
    cli.add_option("--map", arguments.map, "map to draw (default: the one where the scene starts)")
        ->type_name("NAME");
    cli.add_option("--eye", arguments.eye, "viewpoint (default: the player's at the scene's start)")
        ->type_name("X,Y,Z,HEADING,LOOK");
    cli.add_option("--size", arguments.size, "size of the picture in pixels (default: 1280x720)")
        ->type_name("WxH");
    cli.add_option("--fov", arguments.fov, "horizontal field of view in degrees")->type_name("DEG");
    CLI::Option* time =
        cli.add_option("--time", arguments.time,
                       "simulate the world for this long before drawing (default: 0)")
            ->type_name("SECONDS");
    cli.add_option("--set", arguments.options, "set an option of the view; see below")
        ->type_name("OPTION=VALUE")
        ->allow_extra_args(false);
    CLI::Option* replay =
        cli.add_option("--replay", arguments.replay, "recording to replay before drawing")
            ->type_name("FILE")
            ->excludes(time);
    cli.add_option(
           "--at", arguments.at,
           "replay up to this step (1/120 s) or the mark of this name (default: to the end)")
        ->type_name("STEP")
        ->needs(replay);
    CLI::Option* hits =
        cli.add_option("--hits", arguments.hits,
                       "print the hits of this column of the picture as JSON; 0 is the leftmost")
            ->type_name("COLUMN");
    cli.add_option("--trace", arguments.trace,
                   "print each step of drawing this column, or \"all\" columns, as JSON")
        ->type_name("COLUMN")
        ->excludes(hits);
    cli.add_option("--out", arguments.out, "PNG file to write; optional with --hits or --trace")
        ->type_name("PICTURE.png");
    cli.footer(footer());
}

constexpr const char* kProgram = "slicecast-render";

int fail(const std::string& fault, int status) {
    printLine(stderr, {kProgram, ": ", fault});
    return status;
}

// The map of that name; the map of the start if the name is empty.
Read<int> findMap(const World& world, const std::string& name) {
    if (name.empty()) return {world.start.map, {}};
    std::string names;
    for (std::size_t i = 0; i < world.maps.size(); ++i) {
        if (world.maps[i].name == name) return {static_cast<int>(i), {}};
        names += (i > 0 ? ", \"" : "\"") + world.maps[i].name + "\"";
    }
    return {std::nullopt, "--map: found \"" + name + "\", expected a map of this scene: " + names};
}

// Sets the options and the eye of the command line. Empty on success, else an error message.
std::string arrange(Session& session, const Arguments& arguments) {
    if (!arguments.fov.empty()) {
        std::string fault = session.setOption("fov", arguments.fov);
        if (!fault.empty()) return fault;
    }
    for (const std::string& option : arguments.options) {
        const std::size_t equals = option.find('=');
        if (equals == std::string::npos)
            return "--set: found \"" + option + "\", expected OPTION=VALUE";
        std::string fault = session.setOption(option.substr(0, equals), option.substr(equals + 1));
        if (!fault.empty()) return fault;
    }
    if (!arguments.time.empty()) {
        const Read<int> steps = readTime(arguments.time);
        if (!steps.value) return "--time: " + steps.fault;
        for (int i = 0; i < *steps.value; ++i) session.step(Input{});
    }
    const Read<int> map = findMap(session.world(), arguments.map);
    if (!map.value) return map.fault;
    if (arguments.eye.empty()) {
        if (*map.value == session.world().start.map) return {};
        return "--map: the scene does not start in \"" + arguments.map +
               "\"; add --eye to set the viewpoint";
    }
    const Read<Eye> eye = readEye(arguments.eye, *map.value);
    if (!eye.value) return "--eye: " + eye.fault;
    return session.setEye(*eye.value)
               ? std::string()
               : "--eye: found \"" + arguments.eye +
                     "\", which sees nothing; expected a viewpoint above the floor";
}

// Replays the recording. 0 on success, else the exit status after printing the error.
int play(Session& session, const Arguments& arguments) {
    if (!arguments.eye.empty() || !arguments.map.empty())
        return fail(
            "--replay: cannot be used with --eye or --map, because the recording moves the player",
            kWrongUse);
    ReadRecording read = readRecordingFile(arguments.replay);
    for (const Fault& fault : read.faults) printLine(stderr, describe(fault));
    if (!read.recording) return 1;
    const std::string scene = std::filesystem::path(arguments.scene).stem().string();
    if (read.recording->scene != scene) {
        return fail("--replay: found a recording of the scene \"" + read.recording->scene +
                        "\", expected one of \"" + scene + "\"",
                    kWrongUse);
    }
    Replay replay(std::move(*read.recording));
    const std::string fault = replayUpTo(session, replay, arguments.at);
    if (!fault.empty()) return fail("--at: " + fault, kWrongUse);
    if (!replay.isSame())
        return fail(
            "--replay: the replay ends elsewhere than the recording; the scene or the engine has "
            "changed since",
            1);
    return 0;
}

std::string drawTo(const std::string& path, Session& session, const PictureSize& size) {
    Image image(size.width, size.height);
    if (!session.draw({image.pixels.data(), size.width, size.height, size.width}))
        return "the picture could not be drawn";
    return writeWholeFile(path,
                          encodePng(image.pixels.data(), size.width, size.height, size.width));
}

}  // namespace

int main(int argc, char** argv) {
    // The command line
    outliveClosedPipes();
    CLI::App cli("Draws one view of a scene into a PNG file.", kProgram);
    Arguments arguments;
    describeArguments(cli, arguments);
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        return finishOutput(kProgram, cli.exit(fault) == 0 ? 0 : kWrongUse);
    }
    const std::string& columnText =
        arguments.hits.empty() ? arguments.trace : arguments.hits;  // at most one of them
    if (arguments.out.empty() && columnText.empty())
        return fail("nothing to do; expected --out PICTURE.png, --hits COLUMN or --trace COLUMN",
                    kWrongUse);
    PictureSize size;
    if (!arguments.size.empty()) {
        const Read<PictureSize> read = readSize(arguments.size);
        if (!read.value) return fail("--size: " + read.fault, kWrongUse);
        size = *read.value;
    }
    int column = 0;
    const bool isWhole = arguments.trace == "all";
    if (!columnText.empty() && !isWhole) {
        const Read<int> read = readColumn(columnText, size.width);
        if (!read.value)
            return fail((arguments.hits.empty() ? "--trace: " : "--hits: ") + read.fault,
                        kWrongUse);
        column = *read.value;
    }

    // The scene
    LoadedScene scene = readSceneFile(arguments.scene);
    for (const Fault& fault : scene.faults) printLine(stderr, describe(fault));
    for (const Fault& warning : scene.warnings) printLine(stderr, {"warning: ", describe(warning)});
    if (!scene.world) return 1;
    Session session(std::move(*scene.world));
    const std::string wrong = arrange(session, arguments);
    if (!wrong.empty()) return fail(wrong, kWrongUse);
    if (!arguments.replay.empty()) {
        const int status = play(session, arguments);
        if (status != 0) return status;
    }

    // Picture and texts
    if (!arguments.out.empty()) {
        const std::string fault = drawTo(arguments.out, session, size);
        if (!fault.empty()) return fail(fault, 1);
    }
    if (!columnText.empty()) {
        const auto [width, height] = size;
        const std::string text = isWhole ? frameTraceJson(session, arguments.scene, width, height)
                                 : arguments.hits.empty()
                                     ? traceJson(session, arguments.scene, width, height, column)
                                     : hitsJson(session, arguments.scene, width, height, column);
        std::fputs(text.c_str(), stdout);
    }
    return finishOutput(kProgram, 0);
}
