// The pictures as files: drawn anew they are the same, they repeat without a seam, and floors,
// walls and roofs differ in value.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "textures/committed.h"
#include "textures/skies.h"

namespace slicecast::textures {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kFolders = {"textures", "see-through", "sheets", "sprites"};

// A joint that lies on the border may be a little stronger than its like inside.
constexpr double kSeamTolerance = 1.1;

double meanGrey(const Image& image) {
    double sum = 0.0;
    for (const Pixel pixel : image.pixels) {
        sum += greyOf(toColour(pixel));
    }
    return sum / static_cast<double>(image.pixels.size());
}

TEST(Textures, TheProgramDrawsTheCommittedFiles) {
    const fs::path drawn = fs::temp_directory_path() /
                           ("slicecast-textures-" +
                            std::to_string(std::hash<std::string>{}(SLICECAST_TEXTURES_PROGRAM)));
    fs::remove_all(drawn);
    const std::string program = SLICECAST_TEXTURES_PROGRAM;
    std::string command = "\"";
    command.append(program).append("\" \"").append(drawn.string()).append("\"");
    ASSERT_EQ(std::system(command.c_str()), 0);
    for (const std::string& folder : kFolders) {
        EXPECT_EQ(namesIn(drawn / folder), namesIn(assetsFolder() / folder));
    }
    for (const Entry& entry : catalogue()) {
        const Image image = decodedFile(drawn / folderOf(entry.use) / (entry.name + ".png"));
        EXPECT_EQ(image.width, committed(entry).width) << entry.name;
        EXPECT_TRUE(image.pixels == committed(entry).pixels)
            << entry.name << ": draw the assets anew";
    }
    fs::remove_all(drawn);
}

TEST(Textures, EveryFileIsListedAndEveryListedOneIsAFile) {
    std::map<std::string, std::set<std::string>> listed;
    std::set<std::string> names;
    for (const Entry& entry : catalogue()) {
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " is listed twice";
        listed[folderOf(entry.use)].insert(entry.name + ".png");
        for (const char letter : entry.name) {
            EXPECT_TRUE((letter >= 'a' && letter <= 'z') || letter == '-') << entry.name;
        }
    }
    for (const std::string& folder : kFolders) {
        EXPECT_EQ(listed[folder], namesIn(assetsFolder() / folder));
    }
}

TEST(Textures, Sizes) {
    for (const Entry& entry : catalogue()) {
        const Image& image = committed(entry);
        if (entry.use == Use::Sprite) {
            EXPECT_EQ(image.width % entry.frames, 0) << entry.name;
            EXPECT_LE(image.width, 1024) << entry.name;
            EXPECT_EQ(image.height % entry.views, 0) << entry.name;
            EXPECT_LE(image.height, 256 * entry.views) << entry.name;
            continue;
        }
        const bool sky = entry.use == Use::Sky;
        EXPECT_EQ(image.width, sky ? kSkyWidth : entry.side * entry.frames) << entry.name;
        EXPECT_EQ(image.height, sky ? kSkyHeight : entry.side) << entry.name;
    }
}

TEST(Textures, TheyRepeatSidewaysWithoutASeam) {
    for (const Entry& entry : catalogue()) {
        for (int frame = 0; entry.repeatsSideways && frame < entry.frames; ++frame) {
            const Image image = frameOf(entry, frame);
            EXPECT_LE(columnStep(image, image.width - 1, 0),
                      kSeamTolerance * strongestColumnStep(image))
                << entry.name << " frame " << frame;
        }
    }
}

// Above a panorama one sees its first row, as far up as one looks: anything in it would be a bar.
TEST(Textures, SkiesEndInOneColour) {
    for (const Entry& entry : catalogue()) {
        if (entry.use != Use::Sky) continue;
        const Image image = frameOf(entry, 0);
        for (int x = 1; x < image.width; ++x)
            ASSERT_EQ(image.pixels[static_cast<std::size_t>(x)], image.pixels[0]) << entry.name;
    }
}

TEST(Textures, TheyRepeatUpwardsWithoutASeam) {
    for (const Entry& entry : catalogue()) {
        if (entry.use == Use::Sky || !entry.repeatsUpwards) {
            continue;
        }
        for (int frame = 0; frame < entry.frames; ++frame) {
            const Image image = frameOf(entry, frame);
            EXPECT_LE(rowStep(image, image.height - 1, 0), kSeamTolerance * strongestRowStep(image))
                << entry.name << " frame " << frame;
        }
    }
}

// Where most of a picture is holes, its strongest step is no measure of a seam: the steps close by
// are.
TEST(Textures, ThoseWithHolesCrossTheirBordersAsTheyRunBesideThem) {
    constexpr int kNear = 5;
    constexpr double kTolerance = 1.5;
    for (const Entry& entry : catalogue()) {
        for (int frame = 0; entry.alpha == Alpha::Holes && frame < entry.frames; ++frame) {
            const Image image = frameOf(entry, frame);
            double beside = 0.0;
            double above = 0.0;
            for (int near = 0; near < kNear; ++near) {
                beside =
                    std::max({beside, columnStep(image, near, near + 1),
                              columnStep(image, image.width - 2 - near, image.width - 1 - near)});
                above =
                    std::max({above, rowStep(image, near, near + 1),
                              rowStep(image, image.height - 2 - near, image.height - 1 - near)});
            }
            if (entry.repeatsSideways) {
                EXPECT_LE(columnStep(image, image.width - 1, 0), kTolerance * beside + 0.5)
                    << entry.name << " frame " << frame;
            }
            if (entry.repeatsUpwards) {
                EXPECT_LE(rowStep(image, image.height - 1, 0), kTolerance * above + 0.5)
                    << entry.name << " frame " << frame;
            }
        }
    }
}

TEST(Textures, WhatIsPaintedOnAWallContinuesIt) {
    constexpr int kBorder = 6;
    int painted = 0;
    for (const Entry& entry : catalogue()) {
        if (entry.wall.empty()) {
            continue;
        }
        ++painted;
        const Image& image = committed(entry);
        const Image& wall = committed(entryNamed(entry.wall));
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kBorder; ++x) {
                ASSERT_EQ(image.at(x, y), wall.at(x, y)) << entry.name << " at " << x << ", " << y;
                ASSERT_EQ(image.at(kSide - 1 - x, y), wall.at(kSide - 1 - x, y))
                    << entry.name << " at " << kSide - 1 - x << ", " << y;
            }
        }
    }
    EXPECT_GE(painted, 4);
}

TEST(Textures, HazeColoursMatchTheFootOfTheSkies) {
    const std::map<std::string, Colour> hazes = {
        {"sky-day", kHazeDay}, {"sky-dusk", kHazeDusk}, {"sky-night", kHazeNight}};
    for (const auto& [name, haze] : hazes) {
        const Image& image = committed(entryNamed(name));
        for (int x = 0; x < image.width; ++x) {
            ASSERT_EQ(image.at(x, image.height - 1), toPixel(haze)) << name << " column " << x;
        }
    }
}

// Space must read without light: roofs and ceilings are dark, and walls of houses lighter than what
// covers them.
TEST(Textures, RoofsAndCeilingsAreDarkerThanTheWallsUnderThem) {
    double darkestHouse = 255.0;
    for (const char* wall : {"brick", "stone-blocks", "sandstone", "plaster-white", "plaster-warm",
                             "timber-frame", "planks-wall"}) {
        darkestHouse = std::min(darkestHouse, meanGrey(committed(entryNamed(wall))));
    }
    for (const Entry& entry : catalogue()) {
        if (entry.use == Use::Roof || entry.use == Use::Ceiling) {
            EXPECT_LT(meanGrey(committed(entry)) + 10.0, darkestHouse) << entry.name;
        }
    }
}

TEST(Textures, ThePaletteHasNoColourTwice) {
    for (std::size_t i = 0; i < kPalette.size(); ++i) {
        for (std::size_t j = i + 1; j < kPalette.size(); ++j) {
            EXPECT_FALSE(kPalette[i] == kPalette[j]) << i << " and " << j;
        }
    }
}

TEST(Textures, AllOfThemAreSmall) {
    for (const std::string& folder : kFolders) {
        std::uintmax_t bytes = 0;
        for (const auto& file : fs::directory_iterator(assetsFolder() / folder)) {
            bytes += file.file_size();
        }
        EXPECT_LT(bytes, 1'500'000U) << folder;
    }
}

}  // namespace
}  // namespace slicecast::textures
