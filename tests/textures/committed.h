// The committed pictures, their frames, and how strongly two rows, columns or frames of them
// differ.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "base/image.h"
#include "textures/catalogue.h"

namespace slicecast::textures {

// The folder of assets in this checkout.
std::filesystem::path assetsFolder();

std::set<std::string> namesIn(const std::filesystem::path& folder);

Image decodedFile(const std::filesystem::path& path);

const Entry& entryNamed(const std::string& name);
const Image& committed(const Entry& entry);

// One of the pictures that stand side by side in it.
Image frameOf(const Entry& entry, int frame);

// Mean absolute differences of a channel, colours weighted by their alpha, and of alpha where there
// is any.
double columnStep(const Image& image, int x1, int x2);
double rowStep(const Image& image, int y1, int y2);
double strongestColumnStep(const Image& image);
double strongestRowStep(const Image& image);
double difference(const Image& a, const Image& b);

// The share of texels that are not wholly see-through.
double coverage(const Image& image);

}  // namespace slicecast::textures
