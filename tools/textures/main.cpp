// slicecast-textures: draws all textures, skies, sheets and sprites of the project into the folder
// of assets. Every run gives the same bytes.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/image.h"
#include "catalogue.h"
#include "files/write_file.h"
#include "palette_png.h"
#include "sheet.h"

namespace {

using slicecast::textures::catalogue;
using slicecast::textures::Entry;

constexpr const char* kProgram = "slicecast-textures";

std::vector<Entry> chosen(const std::vector<std::string>& names) {
    std::vector<Entry> entries;
    for (const Entry& entry : catalogue()) {
        if (names.empty() || std::find(names.begin(), names.end(), entry.name) != names.end()) {
            entries.push_back(entry);
        }
    }
    return entries;
}

std::string checkName(const std::string& name) {
    for (const Entry& entry : catalogue()) {
        if (entry.name == name) {
            return {};
        }
    }
    return "unknown texture " + name + "; --list shows all";
}

bool write(const std::string& path, const slicecast::textures::Picture& picture) {
    std::vector<slicecast::Pixel> pixels;
    pixels.reserve(picture.pixels.size());
    for (const slicecast::Colour& colour : picture.pixels) {
        pixels.push_back(slicecast::toPixel(colour));
    }
    std::vector<std::uint8_t> bytes =
        slicecast::textures::encodePalettePng(pixels, picture.width, picture.height);
    if (bytes.empty())
        bytes = slicecast::encodePng(pixels.data(), picture.width, picture.height, picture.width);
    const std::string fault = slicecast::writeWholeFile(path, bytes);
    if (!fault.empty()) std::fprintf(stderr, "%s: %s\n", kProgram, fault.c_str());
    return fault.empty();
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Draws the textures, skies, sheets and sprites of Slicecast as PNG files."};
    std::string folder;
    std::string sheet;
    std::vector<std::string> only;
    bool list = false;
    app.add_option("FOLDER", folder,
                   "the folder of assets: files go to textures, see-through, sheets and sprites in "
                   "it; made if missing");
    app.add_option("--only", only, "draw only these names, separated by commas")
        ->delimiter(',')
        ->check(checkName);
    app.add_option("--sheet", sheet, "also write a contact sheet of all pictures to this PNG file");
    app.add_flag("--list", list, "list every name with its use, and draw nothing");
    slicecast::outliveClosedPipes();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        return slicecast::finishOutput(kProgram, app.exit(fault));
    }

    if (list) {
        for (const Entry& entry : chosen(only)) {
            std::printf("%-8s %s\n", slicecast::textures::nameOf(entry.use), entry.name.c_str());
        }
        return slicecast::finishOutput(kProgram, 0);
    }
    if (folder.empty() && sheet.empty()) {
        std::fprintf(stderr, "%s: expected a FOLDER or --sheet FILE\n", kProgram);
        return 1;
    }

    bool written = true;
    if (!folder.empty()) {
        for (const Entry& entry : chosen(only)) {
            const std::string place = folder + "/" + slicecast::textures::folderOf(entry.use);
            std::error_code failure;
            std::filesystem::create_directories(place, failure);
            written = write(place + "/" + entry.name + ".png", entry.paint()) && written;
        }
    }
    if (!sheet.empty()) {
        written = write(sheet, slicecast::textures::contactSheet(chosen(only))) && written;
    }
    return written ? 0 : 1;
}
