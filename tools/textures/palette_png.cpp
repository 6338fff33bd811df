#include "palette_png.h"

#include "slicecast/colour.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace slicecast::textures {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kMostColours = 256;

void addNumber(Bytes& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

// Length, name, data, and the checksum of name and data.
void addChunk(Bytes& bytes, std::string_view name, const Bytes& data) {
    addNumber(bytes, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = bytes.size();
    bytes.insert(bytes.end(), name.begin(), name.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    std::uint32_t sum = ~std::uint32_t{0};
    for (std::size_t i = begin; i < bytes.size(); ++i) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xedb88320u : 0u);
    }
    addNumber(bytes, ~sum);
}

}  // namespace

std::vector<std::uint8_t> encodePalettePng(const std::vector<Pixel>& pixels, int width,
                                           int height) {
    // As numbers the see-through colours come first, and only they are given an alpha.
    std::vector<Pixel> colours = pixels;
    std::sort(colours.begin(), colours.end());
    colours.erase(std::unique(colours.begin(), colours.end()), colours.end());
    if (colours.size() > kMostColours) return {};

    Bytes header;
    addNumber(header, static_cast<std::uint32_t>(width));
    addNumber(header, static_cast<std::uint32_t>(height));
    header.insert(header.end(), {8, 3, 0, 0, 0});  // bits, palette, and no choice of methods
    Bytes palette;
    Bytes alphas;
    for (const Pixel pixel : colours) {
        const Colour colour = toColour(pixel);
        palette.insert(palette.end(), {colour.r, colour.g, colour.b});
        if (colour.a < 255) alphas.push_back(colour.a);
    }
    Bytes rows;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i % static_cast<std::size_t>(width) == 0) rows.push_back(0);  // no filter
        rows.push_back(static_cast<std::uint8_t>(
            std::lower_bound(colours.begin(), colours.end(), pixels[i]) - colours.begin()));
    }

    Bytes bytes = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    addChunk(bytes, "IHDR", header);
    addChunk(bytes, "PLTE", palette);
    if (!alphas.empty()) addChunk(bytes, "tRNS", alphas);
    addChunk(bytes, "IDAT", slicecast::compressed(rows));
    addChunk(bytes, "IEND", {});
    return bytes;
}

}  // namespace slicecast::textures
