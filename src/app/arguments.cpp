#include "app/arguments.h"

#ifndef __EMSCRIPTEN__

#include "app/keys.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

namespace slicecast {

namespace {

std::optional<Size> readSize(const std::string& text) {
    Size size;
    int end = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &size.width, &size.height, &end) != 2 ||
        end != static_cast<int>(text.size()))
        return std::nullopt;
    if (size.width < 1 || size.height < 1 || size.width > kLargestPictureSide ||
        size.height > kLargestPictureSide)
        return std::nullopt;
    return size;
}

bool isNumberOfThreads(const std::string& text) {
    int threads = 0;
    int end = 0;
    return std::sscanf(text.c_str(), "%3d%n", &threads, &end) == 1 &&
           end == static_cast<int>(text.size()) && threads >= 1 && threads <= kMostThreads;
}

std::string helpText() {
    std::string text = "Keys:\n";
    for (const KeyHelp& line : KeyBindings().help()) {
        if (isOfPagesOnly(line.first)) continue;
        std::string keys = keysText(line);
        keys.resize(std::max<std::size_t>(keys.size(), 18), ' ');
        text += "  " + keys + std::string(line.does) + "\n";
    }
    return text;
}

}  // namespace

ReadArguments readArguments(int argc, char** argv) {
    CLI::App cli("Walks through a world of stacked blocks.", "slicecast");
    cli.footer(helpText());
    Arguments arguments;
    std::string size;
    std::string fov;
    std::vector<std::string> options;
    std::string keys;
    cli.add_option("SCENE", arguments.scene,
                   "scene file to open (default: the opening scene that comes with the program)");
    CLI::Option* map =
        cli.add_option("--map", arguments.map,
                       "start flying over the middle of this map instead of at the scene's start")
            ->type_name("NAME");
    cli.add_option("--record", arguments.record,
                   "record the game to this file, written at F9 or when the window closes")
        ->type_name("FILE");
    cli.add_option("--replay", arguments.replay, "recording to replay; any movement takes over")
        ->type_name("FILE")
        ->excludes(map);
    cli.add_option("--size", size, "size of the picture in pixels (default: it fills the window)")
        ->type_name("WxH")
        ->check([](const std::string& text) {
            return readSize(text)
                       ? std::string()
                       : "\"" + text + "\" is not a size; expected WxH, 1x1 to 4096x4096";
        });
    cli.add_option("--fov", fov, "horizontal field of view in degrees")->type_name("DEGREES");
    cli.add_flag("--fullscreen", arguments.window.fullscreen, "fill the screen");
    cli.add_option("--threads", arguments.threads,
                   "number of threads that draw a picture (default: as many as the machine has, "
                   "here " +
                       std::to_string(arguments.threads) + ")")
        ->type_name("N")
        ->check([](const std::string& text) {
            return isNumberOfThreads(text)
                       ? std::string()
                       : "\"" + text + "\" is not a number of threads; expected 1 to " +
                             std::to_string(kMostThreads);
        });
    cli.add_option("--set", options, "set an option of the view")
        ->type_name("OPTION=VALUE")
        ->check([](const std::string& text) {
            return text.find('=') != std::string::npos ? std::string()
                                                       : "\"" + text + "\" is not OPTION=VALUE";
        });
    cli.add_option("--keys", keys,
                   "change keys, such as forward=ArrowUp,fly=KeyJ+F5; "
                   "keys are named as in KeyboardEvent.code")
        ->type_name("ACTION=KEY[+KEY],...")
        ->check([&](const std::string& text) { return arguments.keys.read(text); });
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        return {std::nullopt, cli.exit(fault)};
    }
    if (!size.empty()) arguments.window.picture = readSize(size);
    if (!fov.empty()) arguments.options.emplace_back("fov", fov);
    for (const std::string& option : options) {
        const std::size_t equals = option.find('=');
        arguments.options.emplace_back(option.substr(0, equals), option.substr(equals + 1));
    }
    return {std::move(arguments), 0};
}

}  // namespace slicecast

#endif
