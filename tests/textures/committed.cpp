#include "textures/committed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

namespace slicecast::textures {

namespace fs = std::filesystem;

namespace {

// Of four channels, so that a hole and a black texel are told apart.
double step(Pixel first, Pixel second) {
    const Colour a = toColour(first);
    const Colour b = toColour(second);
    const auto apart = [&](int ca, int cb) { return std::abs(ca * a.a - cb * b.a) / 255.0; };
    return (apart(a.r, b.r) + apart(a.g, b.g) + apart(a.b, b.b) + std::abs(a.a - b.a)) / 4.0;
}

}  // namespace

fs::path assetsFolder() {
    return fs::path(SLICECAST_SOURCE_FOLDER) / "assets";
}

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& file : fs::directory_iterator(folder)) {
        names.insert(file.path().filename().string());
    }
    return names;
}

Image decodedFile(const fs::path& path) {
    constexpr int kLargest = 2048;
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file),
                                  std::istreambuf_iterator<char>()};
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    DecodedImage decoded = decodePng({first, bytes.size()}, kLargest, kLargest);
    EXPECT_EQ(decoded.fault, "") << path;
    return std::move(decoded.image);
}

const Entry& entryNamed(const std::string& name) {
    const auto& all = catalogue();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Entry& entry) { return entry.name == name; });
    EXPECT_NE(found, all.end()) << name;
    return found != all.end() ? *found : all.front();
}

const Image& committed(const Entry& entry) {
    static std::map<std::string, Image> images;
    const fs::path file = fs::path(folderOf(entry.use)) / (entry.name + ".png");
    const auto found = images.find(file.string());
    return found != images.end()
               ? found->second
               : images.emplace(file.string(), decodedFile(assetsFolder() / file)).first->second;
}

Image frameOf(const Entry& entry, int frame) {
    const Image& row = committed(entry);
    Image image(row.width / entry.frames, row.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            image.at(x, y) = row.at(frame * image.width + x, y);
        }
    }
    return image;
}

double columnStep(const Image& image, int x1, int x2) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y) {
        sum += step(image.at(x1, y), image.at(x2, y));
    }
    return sum / image.height;
}

double rowStep(const Image& image, int y1, int y2) {
    double sum = 0.0;
    for (int x = 0; x < image.width; ++x) {
        sum += step(image.at(x, y1), image.at(x, y2));
    }
    return sum / image.width;
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

double difference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t index = 0; index < a.pixels.size(); ++index) {
        sum += step(a.pixels[index], b.pixels[index]);
    }
    return sum / static_cast<double>(a.pixels.size());
}

double coverage(const Image& image) {
    const auto covered = std::count_if(image.pixels.begin(), image.pixels.end(),
                                       [](Pixel pixel) { return toColour(pixel).a > 0; });
    return static_cast<double>(covered) / static_cast<double>(image.pixels.size());
}

}  // namespace slicecast::textures
