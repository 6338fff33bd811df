// What runs a million times for the traces of all columns of a picture, and is built for speed.
#include "session/json_text.h"

#include <cstdint>

namespace slicecast {

void JsonText::pack(double value) {
    if (!open_.empty() && open_.back() != kObject) packed_->numbers[open_.back()] += 1.0;
    if (packed_->count == packed_->numbers.size()) growPacked();
    packed_->numbers[packed_->count++] = value;
}

void JsonText::packText(std::string_view value) {
    PackedText& lately =
        packedTexts_[reinterpret_cast<std::uintptr_t>(value.data()) / 4 % kPackedTexts];
    if (lately.data != value.data() || lately.size != value.size())
        lately = {value.data(), value.size(), indexOf(value)};
    pack(lately.index);
}

}  // namespace slicecast
