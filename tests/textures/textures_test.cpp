// The textures as files: drawn anew they are the same, they repeat without a seam, and floors, walls and roofs differ in value.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/image.h"
#include "textures/catalogue.h"
#include "textures/skies.h"

namespace slicecast::textures {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(SLICECAST_SOURCE_FOLDER) / "assets" / "textures";

Image decodedFile(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    DecodedImage decoded = decodePng({first, bytes.size()}, kSkyWidth, kSkyWidth);
    EXPECT_EQ(decoded.fault, "") << path;
    return std::move(decoded.image);
}

const Image& committed(const std::string& name) {
    static std::map<std::string, Image> images;
    const auto found = images.find(name);
    return found != images.end() ? found->second : images.emplace(name, decodedFile(kFolder / (name + ".png"))).first->second;
}

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& file : fs::directory_iterator(folder)) {
        names.insert(file.path().filename().string());
    }
    return names;
}

// Mean absolute difference of a channel between two columns, or two rows.
double columnStep(const Image& image, int x1, int x2) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        const Colour a = toColour(image.at(x1, y));
        const Colour b = toColour(image.at(x2, y));
        sum += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    }
    return sum / (3.0 * image.height);
}

double rowStep(const Image& image, int y1, int y2) {
    double sum = 0.0;
    for (int x = 0; x < image.width; ++x) {
        const Colour a = toColour(image.at(x, y1));
        const Colour b = toColour(image.at(x, y2));
        sum += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    }
    return sum / (3.0 * image.width);
}

double strongestColumnStep(const Image& image) {
    double strongest = 0.0;
    for (int x = 0; x + 1 < image.width; ++x) {
        strongest = std::max(strongest, columnStep(image, x, x + 1));
    }
    return strongest;
}

double strongestRowStep(const Image& image) {
    double strongest = 0.0;
    for (int y = 0; y + 1 < image.height; ++y) {
        strongest = std::max(strongest, rowStep(image, y, y + 1));
    }
    return strongest;
}

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
    const fs::path drawn = fs::temp_directory_path() / ("slicecast-textures-" + std::to_string(std::hash<std::string>{}(SLICECAST_TEXTURES_PROGRAM)));
    fs::remove_all(drawn);
    const std::string command = std::string("\"") + SLICECAST_TEXTURES_PROGRAM + "\" \"" + drawn.string() + "\"";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(namesIn(drawn), namesIn(kFolder));
    for (const Entry& entry : catalogue()) {
        const Image image = decodedFile(drawn / (entry.name + ".png"));
        EXPECT_EQ(image.width, committed(entry.name).width) << entry.name;
        EXPECT_TRUE(image.pixels == committed(entry.name).pixels) << entry.name << ": draw assets/textures anew";
    }
    fs::remove_all(drawn);
}

TEST(Textures, EveryFileIsListedAndEveryListedOneIsAFile) {
    std::set<std::string> listed;
    for (const Entry& entry : catalogue()) {
        EXPECT_TRUE(listed.insert(entry.name + ".png").second) << entry.name << " is listed twice";
        for (const char letter : entry.name) {
            EXPECT_TRUE((letter >= 'a' && letter <= 'z') || letter == '-') << entry.name;
        }
    }
    EXPECT_EQ(listed, namesIn(kFolder));
}

TEST(Textures, SizesAndOpacity) {
    for (const Entry& entry : catalogue()) {
        const Image& image = committed(entry.name);
        const bool sky = entry.use == Use::Sky;
        EXPECT_EQ(image.width, sky ? kSkyWidth : kSide) << entry.name;
        EXPECT_EQ(image.height, sky ? kSkyHeight : kSide) << entry.name;
        EXPECT_TRUE(std::all_of(image.pixels.begin(), image.pixels.end(), [](Pixel pixel) { return toColour(pixel).a == 255; })) << entry.name;
    }
}

TEST(Textures, TheyRepeatSidewaysWithoutASeam) {
    for (const Entry& entry : catalogue()) {
        const Image& image = committed(entry.name);
        EXPECT_LE(columnStep(image, image.width - 1, 0), kSeamTolerance * strongestColumnStep(image)) << entry.name;
    }
}

TEST(Textures, TheyRepeatUpwardsWithoutASeam) {
    for (const Entry& entry : catalogue()) {
        if (entry.use == Use::Sky || !entry.repeatsUpwards) {
            continue;
        }
        const Image& image = committed(entry.name);
        EXPECT_LE(rowStep(image, image.height - 1, 0), kSeamTolerance * strongestRowStep(image)) << entry.name;
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
        const Image& image = committed(entry.name);
        const Image& wall = committed(entry.wall);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kBorder; ++x) {
                ASSERT_EQ(image.at(x, y), wall.at(x, y)) << entry.name << " at " << x << ", " << y;
                ASSERT_EQ(image.at(kSide - 1 - x, y), wall.at(kSide - 1 - x, y)) << entry.name << " at " << kSide - 1 - x << ", " << y;
            }
        }
    }
    EXPECT_GE(painted, 4);
}

TEST(Textures, HazeColoursMatchTheFootOfTheSkies) {
    const std::map<std::string, Colour> hazes = {{"sky-day", kHazeDay}, {"sky-dusk", kHazeDusk}, {"sky-night", kHazeNight}};
    for (const auto& [name, haze] : hazes) {
        const Image& image = committed(name);
        for (int x = 0; x < image.width; ++x) {
            ASSERT_EQ(image.at(x, image.height - 1), toPixel(haze)) << name << " column " << x;
        }
    }
}

// Space must read without light: roofs and ceilings are dark, and walls of houses lighter than what covers them.
TEST(Textures, RoofsAndCeilingsAreDarkerThanTheWallsUnderThem) {
    double darkestHouse = 255.0;
    for (const char* wall : {"brick", "stone-blocks", "sandstone", "plaster-white", "plaster-warm", "timber-frame", "planks-wall"}) {
        darkestHouse = std::min(darkestHouse, meanGrey(committed(wall)));
    }
    for (const Entry& entry : catalogue()) {
        if (entry.use == Use::Roof || entry.use == Use::Ceiling) {
            EXPECT_LT(meanGrey(committed(entry.name)) + 10.0, darkestHouse) << entry.name;
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
    std::uintmax_t bytes = 0;
    for (const auto& file : fs::directory_iterator(kFolder)) {
        bytes += file.file_size();
    }
    EXPECT_LT(bytes, 1'500'000U);
}

}  // namespace
}  // namespace slicecast::textures
