// Functions that run a hundred thousand times for the traces of all columns of a picture; built for
// speed.
#include "answers/json_text.h"

#include <algorithm>
#include <cstdint>

namespace slicecast {

void PackedJson::grow() {
    packed_.numbers.resize(2 * packed_.count + 1024);
}

// The index of a text in the answer's texts, which get it if it is new.
double PackedJson::indexOf(const char* text) {
    std::vector<std::string>& texts = packed_.texts;
    const auto known = std::find(texts.begin(), texts.end(), text);
    const auto index = static_cast<double>(known - texts.begin());
    if (known == texts.end()) texts.emplace_back(text);
    return index;
}

PackedJson& PackedJson::beginList(std::size_t count) {
    pack(static_cast<double>(count)).pack(0.0);
    lists_[openLists_++] = packed_.count;
    return *this;
}

PackedJson& PackedJson::endList() {
    const std::size_t begin = lists_[--openLists_];
    packed_.numbers[begin - 1] = static_cast<double>(packed_.count - begin);
    return *this;
}

// Finds texts that were packed before by their address, so nobody may change them meanwhile.
PackedJson& PackedJson::text(const char* value) {
    PackedText& cached = packedTexts_[reinterpret_cast<std::uintptr_t>(value) / 4 % kPackedTexts];
    if (cached.data != value) cached = {value, indexOf(value)};
    return pack(cached.index);
}

}  // namespace slicecast
