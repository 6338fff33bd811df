// What runs a hundred thousand times for the traces of all columns of a picture, and is built for
// speed.
#include "session/json_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace slicecast {

void PackedJson::grow() {
    packed_.numbers.resize(2 * packed_.count + 1024);
}

double PackedJson::indexOf(std::string_view text) {
    std::vector<std::string>& texts = packed_.texts;
    const auto known = std::find(texts.begin(), texts.end(), text);
    const auto index = static_cast<double>(known - texts.begin());
    if (known == texts.end()) texts.emplace_back(text);
    return index;
}

PackedJson& PackedJson::pack(double value) {
    if (packed_.count == packed_.numbers.size()) grow();
    packed_.numbers[packed_.count++] = value;
    return *this;
}

PackedJson& PackedJson::text(std::string_view value) {
    PackedText& lately =
        packedTexts_[reinterpret_cast<std::uintptr_t>(value.data()) / 4 % kPackedTexts];
    if (lately.data != value.data() || lately.size != value.size())
        lately = {value.data(), value.size(), indexOf(value)};
    return pack(lately.index);
}

PackedJson& PackedJson::number(double value) {
    return std::isfinite(value) ? pack(value) : null();
}

PackedJson& PackedJson::pair(double a, double b) {
    return number(a).number(b);
}

PackedJson& PackedJson::null() {
    return pack(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace slicecast
