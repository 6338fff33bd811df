// slicecast-check: prints all faults of scenes, and warnings about probable mistakes.

#include "base/words.h"
#include "files/print_line.h"
#include "files/scene_file.h"
#include "files/write_file.h"
#include "scene/unreached.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

using namespace slicecast;

int main(int argc, char** argv) {
    constexpr const char* kProgram = "slicecast-check";
    outliveClosedPipes();
    CLI::App cli("Checks scene files and the images that they name.", kProgram);
    std::vector<std::string> scenes;
    cli.add_option("SCENE", scenes, "scene files")->required();
    cli.footer(
        "Prints a line \"FILE: ok\", with the number of warnings if there are any, or one line for "
        "each fault: FILE:LINE:COLUMN (JSON POINTER): "
        "found ..., expected ...\n"
        "Warnings go to the standard error in the same form; a scene that has only warnings is "
        "ok.\n"
        "The exit status is 0 if all scenes are ok, 1 if any is not, and 2 for a wrong command "
        "line.\n"
        "\nExamples:\n"
        "  slicecast-check castle.json\n"
        "  slicecast-check castle.json harbour.json\n");
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        return finishOutput(kProgram, cli.exit(fault) == 0 ? 0 : 2);
    }

    bool allOk = true;
    for (const std::string& name : scenes) {
        const LoadedScene scene = readSceneFile(name);
        for (const Fault& fault : scene.faults) printLine(stdout, describe(fault));
        std::int64_t count = 0;
        for (const std::vector<Fault>& warnings : {scene.warnings, findUnreached(scene)}) {
            for (const Fault& warning : warnings) {
                printLine(stderr, {"warning: ", describe(warning)});
                ++count;
            }
        }
        if (scene.world) {
            printLine(stdout,
                      {name, ": ok",
                       count == 0 ? std::string() : words(", ", Counted{count, "warning"})});
        } else {
            allOk = false;
        }
    }
    return finishOutput(kProgram, allOk ? 0 : 1);
}
